//! What tests of cranes on their supports have in common.

use std::fmt::Write;

use lemnis_models::component::model::Model;
use lemnis_models::kernel::variable::Role;

/// Tables of a list, a line of numbers for each.
pub fn tables(text: &mut String, name: &str, keys: &[(&str, &str)], rows: &str) {
    for row in rows.split(';').filter(|row| !row.is_empty()) {
        let _ = writeln!(text, "[[supports.{name}]]");
        for ((key, unit), number) in keys.iter().zip(row.split(' ')) {
            let _ = writeln!(text, "{key} = \"{number} {unit}\"");
        }
    }
}

/// What slews on a support: bodies, wind areas and load cases, a line of numbers for each; slope (rad) and height of the load's
/// suspension.
#[allow(dead_code, reason = "not every support is slewed on")]
pub fn slewing(text: &mut String, upper: &str, areas: &str, cases: &str, slope: Option<[&str; 2]>) {
    tables(text, "upper", &[("G_u", "N"), ("r_u", "m"), ("h_u", "m")], upper);
    tables(text, "areas", &[("A_w", "m2"), ("h_w", "m")], areas);
    let of_case = [("k_Q", ""), ("p_w", "Pa"), ("chi_w", "rad")];
    tables(text, "load_cases", &of_case, cases);
    if let Some([gamma, high]) = slope {
        let _ = writeln!(text, "[supports.slope]\ngamma = \"{gamma} rad\"\nh_Q = \"{high} m\"");
    }
}

/// Every result by every input and parameter where the model stands, against differences: how many were compared. Without
/// those named: by `given` nothing changes there or only to one side, and `results` are no real numbers. What is zero has
/// no left side either, and what may be infinite has no difference there.
pub fn compared(model: &mut Model, given: &[&str], results: &[&str]) -> usize {
    let variables = model.variables().to_vec();
    let mut compared = 0;
    for by in 0..variables.len() {
        let quantity = variables[by].quantity();
        if !matches!(variables[by].role, Role::Input | Role::Parameter) || given.contains(&quantity.0.id) {
            continue;
        }
        let at = model.get(by).expect("known");
        let near = 1e-6 * at.abs().max(1e-2);
        let mut beside = [model.clone(), model.clone()];
        let mut both = beside.iter_mut().zip([-1.0, 1.0]);
        if !both.all(|(model, sign)| model.set(by, at + sign * near).is_ok()) {
            continue;
        }
        let mut tangent = model.tangent(&|other| f64::from(other == quantity));
        for of in 0..variables.len() {
            let variable = &variables[of];
            if variable.role != Role::Output || results.contains(&variable.symbol.id) {
                continue;
            }
            let exact = model.derivative(&mut tangent, of).expect("a derivative");
            let [low, high] = beside.each_mut().map(|model| model.get(of).expect("a result"));
            if variable.symbol.infinite.is_some() && (low.is_infinite() || high.is_infinite()) {
                continue;
            }
            let rough = (high - low) / (2.0 * near);
            let size = low.abs().max(high.abs());
            let allowed = 1e-6 * rough.abs() + 1e-13 * size / near + 1e-9;
            let apart = (exact - rough).abs();
            assert!(apart <= allowed, "{variable} by {}: {exact} {rough}", variables[by]);
            compared += 1;
        }
    }
    compared
}

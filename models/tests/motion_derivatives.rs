//! Derivatives of rates and reactions of every level in motion by every state, input and parameter, and
//! what depends on what, against 50-digit references: `tests/oracles/motion_derivatives.py` made them.

use std::collections::{BTreeMap, BTreeSet};

use lemnis_models::model::{Model, Role};

#[path = "common/levels.rs"]
mod levels;

const ORACLE: &str = include_str!("../../tests/oracles/motion_derivatives.csv");

type Numbers = &'static [(&'static str, f64)];

const MOMENT: Numbers = &[("M_A", 2.1e6), ("M_S", 3e4)];
const SWING: Numbers = &[("theta_1", 1.4), ("omega_1", -0.12), ("omega_R", 0.2), ("l_R", 9.5)];
const PORTS: Numbers = &[
    ("x_v", 0.3),
    ("v_v", 5.0),
    ("p_1", 120e5),
    ("p_2", 25e5),
    ("p_A", 90e5),
    ("p_B", 60e5),
];
const OPEN: Numbers = &[
    ("x_v", -0.6),
    ("v_v", -20.0),
    ("p_1", 320e5),
    ("p_2", 300e5),
    ("p_A", 250e5),
    ("p_B", 190e5),
];

/// States and inputs of the reference's cases, and the states of a load that the rope has let go.
const CASES: [(&str, &[Numbers], Numbers); 10] = [
    ("rigid/forward", &[&[("theta_1", 1.2), ("omega_1", 0.15)], MOMENT], &[]),
    ("rigid/backward", &[&[("theta_1", 1.9), ("omega_1", -0.2)], MOMENT], &[]),
    (
        "rigid/held",
        &[&[("theta_1", 1.3), ("omega_1", 0.0), ("M_A", 2.1e6), ("M_S", 5e6)]],
        &[],
    ),
    ("swing/taut", &[SWING, &[("phi_R", 0.3), ("v_h", 0.05)], MOMENT], &[]),
    (
        "swing/held",
        &[
            SWING,
            &[("omega_1", 0.0), ("phi_R", 0.3), ("M_A", 1e6), ("M_S", 9e6), ("v_h", -0.3)],
        ],
        &[],
    ),
    (
        "swing/slack",
        &[SWING, &[("phi_R", 2.2), ("v_h", 0.05)], MOMENT],
        &[("s_Q", 9.1), ("v_Q", 0.4)],
    ),
    (
        "hydraulic/raising",
        &[&[("theta_1", 1.2), ("omega_1", 0.05)], PORTS],
        &[],
    ),
    (
        "hydraulic/relief",
        &[&[("theta_1", 1.9), ("omega_1", -0.03)], OPEN],
        &[],
    ),
    (
        "hydraulic/stop",
        &[&[("theta_1", 2.0955), ("omega_1", 0.05)], PORTS],
        &[],
    ),
    (
        "hydraulic with swing/raising",
        &[SWING, &[("phi_R", 0.3)], PORTS],
        &[],
    ),
];

fn index(model: &Model, id: &str) -> Option<usize> {
    model.variables().iter().position(|variable| variable.symbol.id == id)
}

fn model(case: usize) -> Model {
    let (name, numbers, slack) = CASES[case];
    let level = name.split('/').next().unwrap_or_default();
    let mut model = levels::model(level);
    let mut set = |id: &str, value: f64| {
        // The rope of a luffing cylinder keeps its length, which is no variable.
        if let Some(at) = index(&model, id) {
            model.set(at, value).expect("allowed");
        }
    };
    numbers.iter().copied().flatten().for_each(|&(id, value)| set(id, value));
    model.update().expect("closes");
    for &(id, value) in slack {
        let at = index(&model, id).expect("exists");
        model.set(at, value).expect("allowed");
    }
    model
}

type Rows = BTreeMap<(&'static str, &'static str), (f64, f64)>;

/// Value and derivative of unknown by known.
fn rows(case: &str) -> Rows {
    let of = |line: &'static str| {
        let cells: Vec<&str> = line.split(',').collect();
        let number = |i: usize| -> f64 { cells[i].parse().expect("a number") };
        (cells[0] == case).then(|| ((cells[1], cells[2]), (number(3), number(4))))
    };
    ORACLE.lines().skip(1).filter_map(of).collect()
}

fn known(role: Role) -> bool {
    matches!(role, Role::Input | Role::Parameter | Role::Tunable | Role::State)
}

/// Within 1e-12 of the derivative, or of the value over the known quantity where the derivative is a small
/// difference of great summands. What the reference does not list is zero.
#[test]
fn derivatives_are_exact() {
    let (mut worst, mut compared) = ((0.0_f64, String::new()), 0);
    for (case, (name, ..)) in CASES.iter().enumerate() {
        let rows = rows(name);
        let mut model = model(case);
        let unknowns: BTreeSet<&str> = rows.keys().map(|(unknown, _)| *unknown).collect();
        assert!(unknowns.len() >= 2, "{name}");
        for variable in model.variables().to_vec() {
            if !known(variable.role) {
                continue;
            }
            let mut tangent = model.tangent(|other| f64::from(other == variable.quantity()));
            let at = model.get(index(&model, variable.symbol.id).expect("exists")).expect("a value");
            for &unknown in &unknowns {
                let i = index(&model, unknown).unwrap_or_else(|| panic!("{unknown}"));
                let value = model.get(i).expect("a value");
                let found = model.derivative(&mut tangent, i).expect("smooth here");
                let (reference, expected) = rows.get(&(unknown, variable.symbol.id)).copied().unwrap_or((value, 0.0));
                assert!(
                    (value - reference).abs() <= 1e-11 * reference.abs(),
                    "{name} {unknown} = {value:e}, reference {reference:e}"
                );
                let size = expected.abs().max((value / at.abs().max(0.1)).abs());
                let error = (found - expected).abs();
                let words = format!(
                    "{name}: d {unknown} / d {} = {found:e}, reference {expected:e}",
                    variable.symbol.id
                );
                if error / size > worst.0 {
                    worst = (error / size, words.clone());
                }
                assert!(error <= 1e-12 * size, "{words}");
                compared += 1;
            }
        }
    }
    println!("{compared} derivatives, largest error {:.1e}: {}", worst.0, worst.1);
}

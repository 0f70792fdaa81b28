//! Derivatives of rates and reactions of every level in motion by every state, input and parameter, and
//! what depends on what, against 50-digit references: `tests/oracles/motion_derivatives.py` made them.

use std::collections::{BTreeMap, BTreeSet};

use lemnis_models::component::model::Model;
use lemnis_models::kernel::variable::Role;
use lemnis_models::registry::dependencies;
use lemnis_models::scene::Scene;

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
const CASES: [(&str, &[Numbers], Numbers); 11] = [
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
            &[
                ("omega_1", 0.0),
                ("phi_R", 0.3),
                ("M_A", 1e6),
                ("M_S", 9e6),
                ("v_h", -0.3),
            ],
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
        &[SWING, &[("phi_R", 0.3), ("v_h", 0.05)], PORTS],
        &[],
    ),
    (
        "hydraulic with swing/slack",
        &[SWING, &[("phi_R", 2.2), ("v_h", 0.05)], PORTS],
        &[("s_Q", 9.1), ("v_Q", 0.4)],
    ),
];

fn index(model: &Model, id: &str) -> Option<usize> {
    model.variables().iter().position(|variable| variable.symbol.id == id)
}

fn model(case: usize) -> Model {
    let (name, numbers, slack) = CASES[case];
    let level = name.split('/').next().unwrap_or_default();
    let mut model = levels::model(level);
    for &(id, value) in numbers.iter().copied().flatten() {
        let at = index(&model, id).expect("exists");
        model.set(at, value).expect("allowed");
    }
    model.start().expect("closes");
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
            let mut tangent = model.tangent(&|other| f64::from(other == variable.quantity()));
            let at = model
                .get(index(&model, variable.symbol.id).expect("exists"))
                .expect("a value");
            for &unknown in &unknowns {
                let i = index(&model, unknown).unwrap_or_else(|| panic!("{unknown}"));
                let value = model.get(i).expect("a value");
                let found = model.derivative(&mut tangent, i).expect("smooth here");
                let (reference, expected) = rows
                    .get(&(unknown, variable.symbol.id))
                    .copied()
                    .unwrap_or((value, 0.0));
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

/// Rates and reactions depend on whatever changes them in any case of the reference, and on nothing else.
#[test]
fn dependencies_are_exact() {
    let mut levels: BTreeMap<&str, BTreeSet<(&str, &str)>> = BTreeMap::new();
    for (name, ..) in CASES {
        let level = name.split('/').next().unwrap_or_default();
        levels.entry(level).or_default().extend(rows(name).keys());
    }
    for (level, changes) in levels {
        let model = levels::model(level);
        let dependencies = dependencies(&model);
        for (variable, found) in model.variables().iter().zip(&dependencies) {
            let unknown = variable.symbol.id;
            if !changes.iter().any(|(changed, _)| *changed == unknown) {
                continue;
            }
            let expected: BTreeSet<&str> = changes
                .iter()
                .filter(|(changed, known)| *changed == unknown && index(&model, known).is_some())
                .map(|(_, known)| *known)
                .collect();
            let found: BTreeSet<&str> = found.iter().map(|(name, _)| *name).collect();
            assert!(
                found.is_superset(&expected),
                "{level} {unknown}: {expected:?}, {found:?}"
            );
            for more in found.difference(&expected) {
                // Contained where it cancels: the anchor's arm is a part of the boom; weights are masses times g;
                // the load's Coriolis force acts across the rope and its pull along it.
                let cancels = matches!(
                    (unknown, *more),
                    ("der(p_A)" | "der(p_B)", "X_1") | ("M_R", "g") | ("M_R" | "S_R" | "der(omega_1)", "v_h")
                );
                // The swinging load's case has its relief valves closed and its spool on one side.
                let elsewhere = level == "hydraulic with swing"
                    && unknown.starts_with("der(p_")
                    && matches!(*more, "p_P" | "k_R" | "p_R");
                assert!(cancels || elsewhere, "{level} {unknown} does not depend on {more}");
            }
        }
    }
}

/// What follows from the position alone has the derivatives of the static level, to the last bit; a state its
/// own; a result none by itself.
#[test]
fn results_of_the_position_are_those_of_the_static_level() {
    let (mut moving, mut at_rest) = (model(7), levels::model("static"));
    let index = |model: &Model, id: &str| index(model, id).unwrap_or_else(|| panic!("{id}"));
    for id in ["theta_1", "omega_1"] {
        let (from, to) = (index(&moving, id), index(&at_rest, id));
        let value = moving.get(from).expect("a state");
        at_rest.set(to, value).expect("allowed");
    }
    for known in ["theta_1", "omega_1", "Q", "X_2", "G_1", "E_x"] {
        let derivative = |model: &Model, output: &str| {
            let known = model.variables()[index(model, known)].quantity();
            let mut tangent = model.tangent(&|other| f64::from(other == known));
            model.derivative(&mut tangent, index(model, output))
        };
        for output in ["A.x", "V_AX", "M_Q", "M_G", "R_max"] {
            let found = derivative(&moving, output);
            assert!(
                found.is_ok() && found == derivative(&at_rest, output),
                "{output} by {known}"
            );
        }
        let own = f64::from(u8::from(known == "theta_1"));
        assert_eq!(derivative(&moving, "theta_1"), Ok(own));
        for result in ["u_v", "G_1"] {
            let fault = derivative(&moving, result).expect_err("no result");
            assert!(
                !fault.outside && fault.message.contains("no derivative"),
                "{}",
                fault.message
            );
        }
    }
}

/// No variable of a ready scene has a derivative that its FMU would hide, by whatever is given or a state: of what moves beside its
/// start, where all rates are nought and brakes hold.
#[test]
fn ready_scenes_tell_what_all_follows_from() {
    let scenes = std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/scenes")).expect("there");
    let mut compared = 0;
    for path in scenes.map(|entry| entry.expect("a file").path()) {
        let text = std::fs::read_to_string(&path).expect("a scene");
        let scene = Scene::parse(&text).unwrap_or_else(|found| panic!("{path:?}: {found:?}"));
        let mut model = scene.model().expect("starts");
        if !model.has_derivatives() {
            continue;
        }
        let dependencies = dependencies(&model);
        let mut states = vec![0.0; model.states()];
        model.get_states(&mut states);
        for (i, state) in states.iter_mut().enumerate() {
            *state += if *state == 0.0 {
                1e-3 / (i + 1) as f64
            } else {
                1e-3 * *state
            };
        }
        model.set_states(&states).expect("near its start");
        model.update().expect("moves");
        let variables = model.variables().to_vec();
        for (of, given) in variables.iter().enumerate() {
            if !known(given.role) {
                continue;
            }
            let size = model.get(of).expect("given").abs();
            let mut tangent = model.tangent(&|other| f64::from(other == given.quantity()));
            for (i, variable) in variables.iter().enumerate() {
                let derivative = model.derivative(&mut tangent, i).unwrap_or(0.0);
                let rounding = 1e-14 * model.get(i).map_or(0.0, f64::abs);
                if known(variable.role) || (derivative * size.max(1e-6)).abs() <= rounding {
                    continue;
                }
                let name = (given.symbol.id, given.number);
                assert!(
                    dependencies[i].contains(&name),
                    "{path:?}: {} follows from {}",
                    variable.name(),
                    given.name()
                );
                compared += 1;
            }
        }
    }
    assert!(compared > 20_000, "{compared}");
}

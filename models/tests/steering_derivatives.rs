//! Derivatives of the steered groups' rates, results and event indicators by every state, input and parameter, against
//! references with 200 digits: `tests/oracles/steering_derivatives.py` made them.

use std::collections::{BTreeMap, BTreeSet};

use lemnis_models::component::model::Model;
use lemnis_models::kernel::variable::{Role, Type};
use lemnis_models::registry::dependencies;
use lemnis_models::scene::Scene;

#[path = "common/counting.rs"]
mod counting;

const SCENE: &str = include_str!("../scenes/boat_hoist_003_hydraulic.toml");
const ORACLE: &str = include_str!("../../tests/oracles/steering_derivatives.csv");

type Numbers = [(&'static str, f64); 6];

const PORTS: Numbers = [
    ("x_v", 0.3),
    ("v_v", 5.0),
    ("p_1", 120e5),
    ("p_2", 25e5),
    ("p_A", 90e5),
    ("p_B", 60e5),
];
const OPEN: Numbers = [
    ("x_v", -0.6),
    ("v_v", -20.0),
    ("p_1", 340e5),
    ("p_2", 350e5),
    ("p_A", 290e5),
    ("p_B", 190e5),
];
const CLOSED: Numbers = [("x_v", 0.02), ("v_v", -3.0), PORTS[2], PORTS[3], PORTS[4], PORTS[5]];

/// Group, angle, rate, oil and travel speed of the reference's cases.
const CASES: [(&str, u16, [f64; 2], Numbers, f64); 6] = [
    ("lengthening", 1, [0.2, 0.03], PORTS, 0.5),
    ("shortening", 6, [-0.4, -0.02], OPEN, 0.5),
    ("standing", 3, [0.3, 0.0004], PORTS, 0.0),
    ("overlap", 8, [-0.1, -0.001], CLOSED, -0.3),
    ("low stop", 2, [-0.9953, -0.003], PORTS, 0.5),
    ("high stop", 5, [0.9951, 0.002], OPEN, 0.0),
];

fn built() -> Model {
    Scene::parse(SCENE)
        .unwrap_or_else(|found| panic!("{found:?}"))
        .model()
        .expect("built")
}

fn index(model: &Model, id: &str, number: Option<u16>) -> usize {
    let mut all = model.variables().iter();
    let found = all.position(|variable| variable.symbol.id == id && variable.number == number);
    found.unwrap_or_else(|| panic!("{id} {number:?}"))
}

fn known(role: Role) -> bool {
    matches!(role, Role::Input | Role::Parameter | Role::Tunable | Role::State)
}

fn model(case: usize) -> Model {
    let (_, group, [theta, omega], oil, speed) = CASES[case];
    let mut model = built();
    let at = index(&model, "v_t", None);
    model.set(at, speed).expect("allowed");
    for (id, value) in [("theta", theta), ("omega_g", omega)].into_iter().chain(oil) {
        let at = index(&model, id, Some(group));
        model.set(at, value).expect("allowed");
    }
    model.update().expect("a machine");
    model
}

/// Within 1e-12 of the derivative, or of the value over the known quantity where the derivative is a small difference
/// of great summands. What the reference does not list is zero: what belongs to other groups, the command, the PLC.
#[test]
fn derivatives_are_exact() {
    let (mut worst, mut compared) = ((0.0_f64, String::new()), 0);
    for (case, (name, group, ..)) in CASES.iter().enumerate() {
        let mut rows: BTreeMap<(&str, &str), (f64, f64)> = BTreeMap::new();
        for line in ORACLE.lines().skip(1) {
            let cells: Vec<&str> = line.split(',').collect();
            let number = |i: usize| -> f64 { cells[i].parse().expect("a number") };
            if cells[0] == *name {
                rows.insert((cells[1], cells[2]), (number(3), number(4)));
            }
        }
        let mut model = model(case);
        let unknowns: BTreeSet<&str> = rows.keys().map(|(unknown, _)| *unknown).collect();
        assert!(unknowns.len() >= 20, "{name}: {unknowns:?}");
        let of_group = Some(*group);
        for (at, variable) in model.variables().to_vec().into_iter().enumerate() {
            if !known(variable.role) || variable.kind != Type::Real {
                continue;
            }
            let mut tangent = model.tangent(&|other| f64::from(other == variable.quantity()));
            let at = model.get(at).expect("a value");
            for &unknown in &unknowns {
                let i = index(&model, unknown, of_group);
                let value = model.get(i).expect("a value");
                let found = model.derivative(&mut tangent, i).expect("smooth here");
                let own = variable.number.is_none() || variable.number == of_group;
                let listed = rows.get(&(unknown, variable.symbol.id)).filter(|_| own).copied();
                let (reference, expected) = listed.unwrap_or((value, 0.0));
                assert!(
                    (value - reference).abs() <= 1e-11 * reference.abs(),
                    "{name} {unknown} = {value:e}, reference {reference:e}"
                );
                let size = expected.abs().max((value / at.abs().max(0.1)).abs());
                let error = (found - expected).abs();
                let words = format!("{name}: d {unknown} / d {variable} = {found:e}, reference {expected:e}");
                assert!(error <= 1e-12 * size, "{words}");
                if error / size > worst.0 {
                    worst = (error / size, words);
                }
                compared += 1;
            }
        }
    }
    println!("{compared} derivatives, largest error {:.1e}: {}", worst.0, worst.1);
    assert!(compared > 10_000);
}

/// By states, loads and parameters, what a derivative says is what the dependencies allow.
#[test]
fn what_has_a_derivative_is_a_dependency() {
    let mut model = model(1);
    let dependencies = dependencies(&model);
    for variable in model.variables().to_vec() {
        if !known(variable.role) {
            continue;
        }
        let mut tangent = model.tangent(&|other| f64::from(other == variable.quantity()));
        for (i, found) in dependencies.iter().enumerate() {
            let of = model.variables()[i];
            if matches!(of.role, Role::Rate | Role::Output | Role::Indicator)
                && model
                    .derivative(&mut tangent, i)
                    .is_ok_and(|derivative| derivative != 0.0)
            {
                assert!(
                    found.contains(&(variable.symbol.id, variable.number)),
                    "{of} depends on {variable}"
                );
            }
        }
    }
    let _ = model.update();
}

/// What follows from the command alone has the derivatives of the groups that stand as commanded; the ground's speed
/// along the wheels is turned by the lag. The margin knows that its range is the cylinder's, where no other is given.
#[test]
fn results_of_the_command_are_those_of_the_kinematic_level() {
    let (before, range) = SCENE.split_once("[steering.range]\n").expect("a range");
    let (_, after) = range.split_once("\n\n").expect("another table");
    let text = format!("{before}{after}");
    let text = text.replacen("l_x   = \"1250 mm\"", "l_x   = \"900 mm\"", 1);
    let scene = Scene::parse(&text).unwrap_or_else(|found| panic!("{found:?}"));
    let mut moving = scene.model().expect("built");
    let mut still = scene.at("kinematic").model().expect("built");
    for model in [&mut moving, &mut still] {
        let command = index(model, "theta_b", None);
        model.set(command, 0.3).expect("allowed");
        model.update().expect("a machine");
    }
    let by = |model: &Model, id: &str, number, unknown: &str, of| {
        let known = model.variables()[index(model, id, number)].quantity();
        let mut tangent = model.tangent(&|other| f64::from(other == known));
        model.derivative(&mut tangent, index(model, unknown, of))
    };
    for (id, number) in [
        ("theta_b", None),
        ("v_t", None),
        ("x", Some(3)),
        ("R_c", None),
        ("l_x", None),
    ] {
        for (unknown, of) in [("omega", None), ("v_M.y", None), ("T_r", Some(2)), ("margin", None)] {
            let Some(at) = moving
                .variables()
                .iter()
                .position(|v| v.symbol.id == unknown && v.number == of)
            else {
                panic!("{unknown}");
            };
            let found = by(&moving, id, number, unknown, of);
            assert!(
                found.is_ok() && found == by(&still, id, number, unknown, of),
                "{unknown} by {id}: {found:?}"
            );
            // The same as a difference over a parameter, where it moves the range.
            if unknown == "margin" && number.is_none() && id != "v_t" {
                let mut margin = |change: f64| {
                    let known = index(&moving, id, None);
                    let value = moving.get(known).expect("a value");
                    moving.set(known, value + change).expect("allowed");
                    let margin = moving.get(at).expect("a machine");
                    moving.set(known, value).expect("allowed");
                    margin
                };
                let slope = (margin(1e-6) - margin(-1e-6)) / 2e-6;
                assert!(
                    (found.expect("smooth") - slope).abs() < 1e-8,
                    "{unknown} by {id}: {slope}"
                );
                assert!(slope.abs() > 1e-3, "{unknown} by {id}: {slope}");
            }
        }
    }
    for searched in ["theta_w", "e"] {
        let fault = by(&moving, "theta_b", None, searched, Some(1)).expect_err("searched for");
        assert!(fault.message.contains("searched for"), "{}", fault.message);
    }
}

/// What is searched for has no derivative, but it does not change with what it does not follow from: an importer may
/// ask for all results by all states. Where it does, the refusal names both.
#[test]
fn what_is_searched_for_does_not_change_with_the_rest() {
    let (mut model, mut zero, mut refused) = (model(1), 0, 0);
    let dependencies = dependencies(&model);
    let variables = model.variables().to_vec();
    for variable in variables.iter().filter(|variable| known(variable.role)) {
        if variable.kind != Type::Real {
            continue;
        }
        let mut tangent = model.tangent(&|other| f64::from(other == variable.quantity()));
        for (i, of) in variables.iter().enumerate() {
            if of.role != Role::Output || of.kind != Type::Real {
                continue;
            }
            let depends = dependencies[i].contains(&(variable.symbol.id, variable.number));
            match model.derivative(&mut tangent, i) {
                Ok(derivative) => {
                    assert!(depends || derivative == 0.0, "{of} by {variable}: {derivative}");
                    zero += u32::from(derivative == 0.0);
                }
                Err(fault) => {
                    assert!(depends, "{of} by {variable}: {}", fault.message);
                    let words = format!("{of} is searched for: it has no derivative by {variable}");
                    assert_eq!(fault.message, words);
                    refused += 1;
                }
            }
        }
    }
    assert!(zero > 10_000 && refused > 100, "{zero} {refused}");
    // Off from what is wanted by as much as the group turns itself.
    let turned = model.variables()[index(&model, "theta", Some(1))].quantity();
    let mut tangent = model.tangent(&|other| f64::from(other == turned));
    let off = index(&model, "e", Some(1));
    assert_eq!(
        model.derivative(&mut tangent, off).expect("follows from the state"),
        -1.0
    );
    let _ = model.update();
}

/// Rates by one state after the other, as an importer's Jacobian asks for them, with results of the groups: no allocation.
#[test]
fn a_jacobian_without_allocation() {
    let model = model(0);
    let states: Vec<usize> = (0..model.variables().len())
        .filter(|&i| model.variables()[i].role == Role::State)
        .collect();
    let unknowns: Vec<usize> = (0..model.variables().len())
        .filter(|&i| {
            let v = &model.variables()[i];
            v.role == Role::Rate || ["f_c", "q_v", "od", "f_g", "Q_P"].contains(&v.symbol.id)
        })
        .collect();
    let mut tangent = model.tangent(&|_| 0.0);
    let before = counting::count();
    let mut sum = 0.0;
    for &state in &states {
        let known = model.variables()[state].quantity();
        model.tangent_into(&|other| f64::from(other == known), &mut tangent);
        for &unknown in &unknowns {
            sum += model.derivative(&mut tangent, unknown).expect("smooth");
        }
    }
    assert_eq!(counting::count(), before, "allocations");
    assert!(sum.is_finite() && states.len() == 64 && unknowns.len() == 64 + 4 * 8 + 1);
}

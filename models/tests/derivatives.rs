//! Derivatives of the default crane's results by every input and parameter, and what depends on
//! what, against 50-digit references: `tests/oracles/lemniscate_derivatives.py` made them.

use std::collections::BTreeMap;

use lemnis_models::component::model::Model;
use lemnis_models::kernel::variable::{Role, TIME};
use lemnis_models::registry::dependencies;
use lemnis_models::scene::{DEFAULT, Scene};

const ORACLE: &str = include_str!("../../tests/oracles/lemniscate_derivatives.csv");

struct Row {
    theta_1: f64,
    output: &'static str,
    known: &'static str,
    value: f64,
    derivative: f64,
}

fn oracle() -> impl Iterator<Item = Row> {
    ORACLE.lines().skip(1).map(|line| {
        let cells: Vec<&str> = line.split(',').collect();
        let number = |i: usize| -> f64 { cells[i].parse().expect("a number") };
        Row {
            theta_1: number(0),
            output: cells[1],
            known: cells[2],
            value: number(3),
            derivative: number(4),
        }
    })
}

fn model() -> Model {
    Scene::parse(DEFAULT).expect("valid").model().expect("a mechanism")
}

fn index(model: &Model, id: &str) -> usize {
    let mut ids = model.variables().iter().map(|variable| variable.symbol.id);
    ids.position(|known| known == id).unwrap_or_else(|| panic!("{id}"))
}

/// Within 1e-13 of the derivative, or of the value over the known quantity where the derivative is
/// a small difference of great summands.
#[test]
fn derivatives_are_exact() {
    let mut model = model();
    let (mut worst, mut rows) = (0.0_f64, 0);
    for row in oracle() {
        let (known, output) = (index(&model, row.known), index(&model, row.output));
        let theta = index(&model, "theta_1");
        model.set(theta, row.theta_1).expect("reachable");
        let at = model.get(known).expect("a value");
        let value = model.get(output).expect("a value");
        let quantity = model.variables()[known].quantity();
        let mut tangent = model.tangent(&|other| f64::from(other == quantity));
        let derivative = model.derivative(&mut tangent, output).expect("smooth here");
        let size = row.derivative.abs().max((row.value / at.abs().max(0.1)).abs());
        assert!(
            (value - row.value).abs() <= 1e-13 * row.value.abs().max(1.0),
            "{} {value}",
            row.output
        );
        let error = (derivative - row.derivative).abs() / size;
        worst = worst.max(error);
        assert!(
            error <= 1e-13,
            "d {} / d {} at {}: {derivative:e}, reference {:e}",
            row.output,
            row.known,
            row.theta_1,
            row.derivative
        );
        rows += 1;
    }
    assert_eq!(rows, 4 * 23 * 26);
    println!("largest error {worst:.1e}");
}

/// A result depends on what changes it anywhere, and on nothing else.
#[test]
fn dependencies_are_exact() {
    let model = model();
    let dependencies = dependencies(&model);
    let mut changed: BTreeMap<(&str, &str), bool> = BTreeMap::new();
    for row in oracle() {
        *changed.entry((row.output, row.known)).or_default() |= row.derivative != 0.0;
    }
    for ((output, known), changes) in changed {
        // The oil flow's area is that of the bore while the cylinder lengthens; the oracle's does so.
        let expected = changes || (output, known) == ("q_d", "d_r");
        // The unset angle follows from time and angular velocity.
        let expected = expected || known == "omega_1";
        let found = dependencies[index(&model, output)].contains(&(known, None));
        // Contained in the expression, where it cancels: the anchor's arm is a part of the boom, and
        // a longer front arm with the same sag moves A along the line CA.
        let cancels = known == "X_1" && ["L_d", "h_d", "v_d", "q_d"].contains(&output);
        let cancels = cancels || (output, known) == ("alpha_1", "X_4");
        assert_eq!(found, expected || cancels, "{output} of {known}");
    }
    for (variable, dependencies) in model.variables().iter().zip(&dependencies) {
        match variable.role {
            Role::Output => assert!(dependencies.contains(&(TIME.id, None)), "{}", variable.symbol.id),
            Role::Calculated => assert!(
                !dependencies.is_empty()
                    && dependencies
                        .iter()
                        .all(|(name, _)| !["time", "theta_1", "omega_1"].contains(name)),
                "{}: {dependencies:?}",
                variable.symbol.id
            ),
            _ => assert!(dependencies.is_empty()),
        }
    }
}

/// Results of the range: against differences of the model itself, whose error is near the square
/// root of the working precision.
#[test]
fn derivatives_of_the_range() {
    let mut model = model();
    for output in ["R_max", "R_min", "Delta_Y", "epsilon_Y", "mu_min"] {
        for known in ["X_1", "X_2", "X_3", "X_4", "X_5", "X_6", "X_7", "X_8"] {
            let (output, known) = (index(&model, output), index(&model, known));
            let symbol = model.variables()[known].symbol;
            let mut tangent = model.tangent(&|other| f64::from(other == (symbol, None)));
            let derivative = model.derivative(&mut tangent, output).expect("smooth");
            let middle = model.get(known).expect("a value");
            let step = 1e-6;
            let at = |value: f64, model: &mut Model| {
                model.set(known, value).expect("allowed");
                model.get(output).expect("closes")
            };
            let difference = (at(middle + step, &mut model) - at(middle - step, &mut model)) / (2.0 * step);
            at(middle, &mut model);
            assert!(
                (derivative - difference).abs() <= 1e-7 * (1.0 + difference.abs()),
                "{} by {}: {derivative} {difference}",
                model.variables()[output].symbol.id,
                symbol.id
            );
        }
    }
}

/// While nobody has set the angle, it follows from time: the derivative by time is that of the angle
/// times the angular velocity.
#[test]
fn derivatives_by_time() {
    let mut model = model();
    model.set_time(20.0);
    let reach = index(&model, "R");
    let mut by_time = model.tangent(&|quantity| f64::from(quantity == (&TIME, None)));
    let swept = model.derivative(&mut by_time, reach).expect("smooth");
    let (theta, omega) = (model.get(0).expect("a value"), model.get(1).expect("a value"));
    model.set(0, theta).expect("reachable");
    let angle = model.variables()[0].quantity();
    let mut by_angle = model.tangent(&|other| f64::from(other == angle));
    let slope = model.derivative(&mut by_angle, reach).expect("smooth");
    assert!((swept - omega * slope).abs() <= 1e-15 * swept.abs().max(1.0));
    let mut by_time = model.tangent(&|quantity| f64::from(quantity == (&TIME, None)));
    assert_eq!(model.derivative(&mut by_time, reach).expect("smooth"), 0.0);
}

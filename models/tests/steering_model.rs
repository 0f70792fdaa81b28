//! The steering's running model: scenes, dependencies, derivatives, limits.

use lemnis_models::component::model::Model;
use lemnis_models::kernel::variable::{Role, TIME, Type};
use lemnis_models::registry::dependencies;
use lemnis_models::scene::Scene;

const HOIST: &str = include_str!("../scenes/boat_hoist_003.toml");
const CAR: &str = include_str!("../scenes/car_4x2.toml");

fn model(text: &str) -> Model {
    let scene = Scene::parse(text).unwrap_or_else(|found| panic!("{found:#?}"));
    scene.model().expect("a machine")
}

fn index(model: &Model, name: &str) -> usize {
    let mut names = model.variables().iter().map(ToString::to_string);
    names
        .position(|known| known == name)
        .unwrap_or_else(|| panic!("no {name}"))
}

/// The outputs at a set of inputs.
fn outputs(model: &mut Model) -> Vec<f64> {
    (0..model.variables().len())
        .map(|i| model.get(i).unwrap_or(f64::NAN))
        .collect()
}

/// Stances in every mode, with every kind of command.
fn stances() -> Vec<[(&'static str, f64); 4]> {
    let mut list = Vec::new();
    for mode in 1..=9 {
        for command in 1..=3 {
            let x = if mode == 9 {
                -4.0
            } else {
                [0.0, 0.0, 0.0, -9.0, 9.0, 0.0][(mode - 1) % 6]
            };
            list.push([
                ("mode", mode as f64),
                ("command", f64::from(command)),
                ("theta_b", 0.31),
                ("x_c", x),
            ]);
        }
    }
    list
}

/// What changes a result when it is moved is among its dependencies.
#[test]
fn dependencies_are_complete() {
    let mut seen = 0;
    for text in [HOIST, CAR] {
        let start = model(text);
        let dependencies = dependencies(&start);
        for stance in stances() {
            let mut at = start.clone();
            for (name, value) in stance {
                let index = index(&at, name);
                at.set(index, value).expect("allowed");
            }
            let before = outputs(&mut at);
            for known in 0..at.variables().len() {
                let variable = at.variables()[known];
                if !matches!(variable.role, Role::Input | Role::Parameter | Role::Tunable) {
                    continue;
                }
                let mut moved = at.clone();
                let value = match variable.kind {
                    Type::Enumeration(of) => 1.0 + before[known] % of.items.len() as f64,
                    _ => before[known] * 1.01 + 1e-3,
                };
                if moved.set(known, value).is_err() {
                    continue;
                }
                for (output, (a, b)) in before.iter().zip(outputs(&mut moved)).enumerate() {
                    // Of the angle and its part of the range each tells what the other has been set to.
                    let result = at.variables()[output].role != Role::Input;
                    if output != known && result && a.to_bits() != b.to_bits() && !(a.is_nan() && b.is_nan()) {
                        assert!(
                            dependencies[output].contains(&(variable.symbol.id, variable.number)),
                            "{} of {variable}",
                            at.variables()[output]
                        );
                        seen += 1;
                    }
                }
            }
        }
    }
    assert!(seen > 10_000, "{seen}");
}

/// The hoist with no two groups in line, so that one alone is foremost, rearmost and outermost:
/// where two are, there is no derivative by the place of one.
fn askew() -> String {
    let mut text = HOIST.to_owned();
    for (old, new) in [
        ("x = \"9 m\"                     # forward", "x = \"9.05 m\""),
        ("x = \"-4 m\"\ny = \"6 m\"", "x = \"-4 m\"\ny = \"6.04 m\""),
        ("x = \"-9 m\"\ny = \"6 m\"", "x = \"-9.03 m\"\ny = \"5.96 m\""),
        ("x = \"4 m\"\ny = \"-6 m\"", "x = \"4 m\"\ny = \"-6.05 m\""),
    ] {
        assert!(text.contains(old), "{old}");
        text = text.replacen(old, new, 1);
    }
    text
}

/// Derivatives against central differences of order six, by everything, in every mode.
#[test]
fn derivatives_agree_with_differences() {
    let mut compared = 0;
    for text in [askew()] {
        let start = model(&text);
        for stance in stances() {
            let mut at = start.clone();
            for (name, value) in stance {
                let index = index(&at, name);
                at.set(index, value).expect("allowed");
            }
            if at.update().is_err() {
                continue;
            }
            for known in 0..at.variables().len() {
                let variable = at.variables()[known];
                if variable.kind != Type::Real
                    || !matches!(variable.role, Role::Input | Role::Parameter | Role::Tunable)
                {
                    continue;
                }
                let middle = at.get(known).expect("a value");
                let step = 1e-4 * middle.abs().max(0.1);
                let mut tangent = at.tangent(&|other| f64::from(other == variable.quantity()));
                let values: Option<Vec<Vec<f64>>> = [-3.0, -2.0, -1.0, 1.0, 2.0, 3.0]
                    .into_iter()
                    .map(|n| {
                        let mut moved = at.clone();
                        moved.set(known, middle + n * step).ok()?;
                        moved.update().ok()?;
                        Some(outputs(&mut moved))
                    })
                    .collect();
                let Some(v) = values else { continue };
                for (output, of) in at.variables().iter().enumerate() {
                    // Which edge of the outline is nearest, and which group has the least left, changes at corners.
                    if of.kind != Type::Real || of.role != Role::Output {
                        continue;
                    }
                    let d = |i: usize, j: usize| v[j][output] - v[i][output];
                    let difference = (45.0 * d(2, 3) - 9.0 * d(1, 4) + d(0, 5)) / (60.0 * step);
                    let plain = d(2, 3) / (2.0 * step);
                    let size = difference
                        .abs()
                        .max(v[2][output].abs() / middle.abs().max(0.1))
                        .max(1e-3);
                    // Where the two differences disagree there is a corner between the points.
                    if !difference.is_finite() || (difference - plain).abs() > 1e-5 * size {
                        continue;
                    }
                    let Ok(derivative) = at.derivative(&mut tangent, output) else {
                        continue;
                    };
                    assert!(
                        (derivative - difference).abs() <= 1e-6 * size,
                        "{of} by {variable} in {stance:?}: {derivative} {difference}"
                    );
                    compared += 1;
                }
            }
        }
    }
    assert!(compared > 40_000, "{compared}");
}

/// Until a command is set, the angle follows from the time; then it stays.
#[test]
fn the_default_experiment() {
    let mut model = model(HOIST);
    let (theta, first) = (index(&model, "theta_b"), index(&model, "theta[1]"));
    assert_eq!(theta, 0);
    for time in [0.0, 10.0, model.stop_time(), 1e3] {
        model.set_time(time);
        let expected = (-26.5 + time.min(83.5)).to_radians();
        assert!((model.get(theta).expect("a value") - expected).abs() <= 1e-14);
        assert!((model.get(first).expect("a value") - expected).abs() <= 1e-14);
        let reachable = index(&model, "reachable");
        assert_eq!(model.get(reachable), Ok(1.0));
    }
    let by_time = model.tangent(&|quantity| f64::from(quantity == (&TIME, None)));
    drop(by_time);
    model.set(theta, 0.2).expect("allowed");
    model.set_time(20.0);
    assert_eq!(model.get(theta), Ok(0.2));
}

/// Saved as numbers and read back: the same state to the bit.
#[test]
fn states_as_numbers() {
    let mut model = model(HOIST);
    for (name, value) in [
        ("mode", 8.0),
        ("corner", 3.0),
        ("G[3]", 1.5e6),
        ("x[2]", 3.5),
        ("v_t", -0.25),
    ] {
        let index = index(&model, name);
        model.set(index, value).expect("allowed");
    }
    model.set_time(3.0);
    let numbers = model.numbers(&model.state());
    let mut other = self::model(HOIST);
    let state = other.state_of(&numbers).expect("its own");
    other.set_state(&state);
    let bits = |values: Vec<f64>| values.into_iter().map(f64::to_bits).collect::<Vec<_>>();
    assert_eq!(bits(outputs(&mut model)), bits(outputs(&mut other)));
    assert!(other.state_of(&numbers[1..]).is_err());
}

/// Values that cannot be are refused in words, and change nothing.
#[test]
fn refused_values() {
    let mut model = model(HOIST);
    let mut said = |name: &str, value: f64| {
        let index = index(&model, name);
        model.set(index, value).expect_err("refused").message
    };
    assert_eq!(
        said("mode", 10.0),
        "mode = 10 is unknown: it must be one of 1 straight, 2 crab, 3 crosswise, 4 front_axle, 5 rear_axle, \
         6 all_wheel, 7 pivot, 8 corner, 9 free"
    );
    assert!(said("mode", 1.5).contains("mode = 1.5 is unknown"));
    assert_eq!(
        said("G[2]", -5e3),
        "G[2] = -5 kN is not allowed: it must be a finite number, zero or greater"
    );
    assert_eq!(
        said("theta_b", 4.0),
        "theta_b = 229.183 deg is not allowed: it must be a finite number from -180 deg to 180 deg"
    );
    assert!(said("theta[1]", 0.0).contains("is a result"));
    let index_of = |name: &str, model: &Model| index(model, name);
    let (mode, by, x) = (
        index_of("mode", &model),
        index_of("command", &model),
        index_of("x_c", &model),
    );
    for (index, value) in [(mode, 6.0), (by, 3.0), (x, 1.0)] {
        model.set(index, value).expect("allowed by itself");
    }
    let fault = model.update().expect_err("not on the line");
    assert!(fault.outside && fault.message.contains("the line x = 0 m"), "{fault:?}");
    model.set(x, 0.0).expect("allowed");
    model.update().expect("on the line");
    // Groups that come to coincide are a machine that does not exist.
    let (x, y) = (index_of("x[2]", &model), index_of("y[2]", &model));
    model.set(x, 9.0).expect("allowed by itself");
    model.set(y, 6.0).expect("allowed by itself");
    assert!(
        model
            .update()
            .expect_err("coincide")
            .message
            .contains("groups 1 and 2 coincide")
    );
}

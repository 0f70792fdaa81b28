//! Oil below absolute vacuum, which the model has and a machine has not: it is told by a truth value with its event
//! indicator and once in words, alike for luffing and for steering.

use lemnis_models::component::model::Model;
use lemnis_models::kernel::variable::{Role, Type};
use lemnis_models::scene::Scene;

#[path = "common/levels.rs"]
mod levels;

const HOIST: &str = include_str!("../scenes/boat_hoist_003_hydraulic.toml");

fn index(model: &Model, id: &str) -> usize {
    let found = model.variables().iter().position(|variable| variable.symbol.id == id);
    found.unwrap_or_else(|| panic!("{id}"))
}

/// Least of all pressures, in Pa.
fn least(model: &mut Model) -> f64 {
    let pressures = ["p_1", "p_2", "p_A", "p_B"];
    let all: Vec<usize> = (0..model.variables().len())
        .filter(|&i| pressures.contains(&model.variables()[i].symbol.id))
        .collect();
    let values = all.into_iter().map(|i| model.get(i).expect("a state"));
    values.fold(f64::INFINITY, f64::min)
}

/// A jerk of all valves, then the other way.
fn jerk(model: &mut Model, time: f64) {
    let (id, value) = match model
        .variables()
        .iter()
        .any(|v| v.symbol.id == "u_v" && v.role == Role::Input)
    {
        true => ("u_v", if time < 1.0 { 1.0 } else { -1.0 }),
        false => ("theta_b", if time < 1.0 { 0.6 } else { -0.6 }),
    };
    let command = index(model, id);
    model.set(command, value).expect("an input");
}

fn cranes() -> Vec<(&'static str, Model)> {
    let cranes = levels::LEVELS
        .into_iter()
        .filter(|level| level.starts_with("hydraulic"));
    // Wheels that turn on by themselves when their valves close.
    let heavy = HOIST.replace("J     = \"12000 kg.m2\"", "J     = \"3000000 kg.m2\"");
    let hoist = Scene::parse(&heavy).expect("a scene").model().expect("built");
    cranes
        .map(|level| (level, levels::model(level)))
        .chain([("steering", hoist)])
        .collect()
}

/// The truth value is true exactly while a pressure is below -0.1 MPa, and its indicator has that margin.
#[test]
fn oil_below_vacuum_is_told() {
    for (name, mut model) in cranes() {
        let [flag, margin] = ["cavitates", "z.vacuum"].map(|id| index(&model, id));
        assert_eq!(
            (model.variables()[flag].role, model.variables()[flag].kind),
            (Role::Output, Type::Boolean)
        );
        let indicators = model.variables().iter().filter(|v| v.role == Role::Indicator);
        assert_eq!(indicators.count(), model.indicators(), "{name}");
        assert_eq!(model.warning(), None, "{name}");
        let (mut below, mut above, mut warned) = (0, 0, None);
        for step in 0..2000 {
            let time = 2e-3 * f64::from(step);
            jerk(&mut model, time);
            model.advance(time, time + 2e-3).expect("moves");
            let least = least(&mut model);
            // No step ends just there.
            assert!((least + 1e5).abs() > 1.0, "{least}");
            let torn = least < -1e5;
            assert_eq!(model.get(flag), Ok(f64::from(torn)), "{name} at {time} s: {least} Pa");
            assert_eq!(model.get(margin), Ok(least + 1e5), "{name} at {time} s");
            (below, above) = (below + u32::from(torn), above + u32::from(!torn));
            warned = warned.or(model.warning().map(|words| (time, words, below)));
        }
        assert!(below > 0 && above > 0, "{name}: {below} {above}");
        let (time, words, below) = warned.expect("warned");
        println!("{name} at {time} s: {words}");
        // A step of the solver may have met it between two of these.
        assert!(
            below <= 1 && words.contains("-0.1 MPa") && words.contains("cavitates"),
            "{words}"
        );
    }
}

/// At vacuum itself, where an importer finds the event, the truth value is what it will be: by the rate.
#[test]
fn at_vacuum_the_rate_decides() {
    for (name, mut model) in cranes() {
        let [flag, pressure, rate] = ["cavitates", "p_B", "der(p_B)"].map(|id| index(&model, id));
        // The piston draws at the chamber, or presses it.
        let moved = if name == "steering" { "omega_g" } else { "omega_1" };
        let moved = index(&model, moved);
        model.set(pressure, -1e5).expect("a state");
        let mut seen = [0, 0];
        for speed in [-0.5, 0.5] {
            model.set(moved, speed).expect("a state");
            let falls = model.get(rate).expect("closes") < 0.0;
            assert_eq!(model.get(flag), Ok(f64::from(falls)), "{name}");
            seen[usize::from(falls)] += 1;
        }
        assert_eq!(seen, [1, 1], "{name}");
    }
}

/// A dip within one long step does not show at its end, but is not missed.
#[test]
fn a_dip_within_a_step_is_not_missed() {
    for (name, mut model) in cranes() {
        let flag = index(&model, "cavitates");
        for (from, to) in [(0.0, 1.0), (1.0, 6.0)] {
            jerk(&mut model, from);
            model.advance(from, to).expect("moves");
        }
        assert_eq!(model.get(flag), Ok(0.0), "{name}: it is over");
        assert!(model.warning().is_some(), "{name}");
    }
}

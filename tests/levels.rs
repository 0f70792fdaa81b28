//! What the levels of modelling cost and how far off they are: `cargo bench --workspace --bench levels`.
//! With the argument `pendulum` only the rows that `tests/peers.py` reads:
//! what; error in rad; seconds for each simulated second. Nothing here fails.

use std::hint::black_box;
use std::time::Instant;

use lemnis_fmu::description::{Standard, model_description};
use lemnis_models::lemniscate::dynamics::{Dynamics, Phase};

#[path = "../models/tests/common/crane.rs"]
mod crane;
#[path = "../models/tests/common/levels.rs"]
mod levels;

/// Reference at t = 5 s under 1.8 MN·m, in rad.
const THETA: f64 = 1.959_365_828_718_83;
const SWING: f64 = 0.510_282_010_345_209_9;

fn run(crane: &Dynamics, h: f64) -> Phase {
    let mut m = Phase {
        theta: 65_f64.to_radians(),
        omega: 0.0,
        swing: 0.1,
        swing_rate: 0.0,
    };
    for _ in 0..(5.0 / h).round() as u32 {
        m = crane.step(&m, black_box(1.8e6), h).expect("closes on the way");
    }
    m
}

/// The best of many rounds, in s.
fn best(mut call: impl FnMut()) -> f64 {
    let mut best = f64::INFINITY;
    for _ in 0..300 {
        let clock = Instant::now();
        call();
        best = best.min(clock.elapsed().as_secs_f64());
    }
    best
}

/// What each level costs: parts of the same crane switched off one by one.
fn table() {
    println!(
        "{:24} {:>8} {:>10} {:>12} {:>14} {:>16}",
        "level", "states", "variables", "bytes saved", "XML of FMI 3", "us/s at 1 ms"
    );
    for level in levels::LEVELS.into_iter().rev() {
        let scene = levels::scene(level);
        let xml = model_description(&scene, Standard::Fmi3).expect("described").len();
        let mut model = levels::model(level);
        let saved = model.state();
        let reach = model
            .variables()
            .iter()
            .position(|v| v.symbol.id == "R")
            .expect("exists");
        let seconds = best(|| {
            model.set_state(&saved);
            for step in 0..1000 {
                let t = f64::from(step) * 1e-3;
                model.advance(t, t + 1e-3).expect("moves");
                black_box(model.get(reach).expect("exists"));
            }
        });
        let (states, variables, bytes) = (model.states(), model.variables().len(), 8 * model.numbers(&saved).len());
        println!(
            "{level:24} {states:>8} {variables:>10} {bytes:>12} {xml:>14} {:>16.0}",
            seconds * 1e6
        );
    }
}

fn main() {
    if std::env::args().all(|argument| argument != "pendulum") {
        table();
    }
    let crane = crane::dynamics(Some(crane::PENDULUM));
    for h in [0.1, 0.05, 0.02, 0.01] {
        let end = run(&crane, h);
        let error = (end.theta - THETA).abs().max((end.swing.abs() - SWING).abs());
        let seconds = best(|| {
            black_box(run(&crane, h));
        });
        println!("Lemnis swing, RK4, h = {h} s;{error:e};{:e}", seconds / 5.0);
    }
}

//! The mechanism in motion, against references that two independent codes agreed on, and by its energy.

use lemnis_models::luffing::moving::dynamics::{Coordinate, Dynamics};
use lemnis_models::luffing::moving::pendulum::Phase;

#[path = "common/crane.rs"]
mod common;

/// The crane with a load on a rope.
fn crane() -> Dynamics {
    common::dynamics(Some(common::PENDULUM))
}

const START: Phase = Phase {
    theta: 65.0 * std::f64::consts::PI / 180.0,
    omega: 0.0,
    swing: 0.1,
    swing_rate: 0.0,
};

fn run(crane: &Dynamics, moment: f64, h: f64, steps: u32) -> Phase {
    (0..steps).fold(START, |m, _| crane.step(&m, moment, h).expect("closes on the way"))
}

/// What was asked before, at another angle or of a crane that did not slew yet, leaves no trace.
#[test]
fn every_angle_is_answered_as_by_a_crane_that_was_never_asked() {
    let of = |crane: &Dynamics, theta: f64| {
        let r = f64::reduced(crane, theta).map(|r| [r.inertia, r.slope, r.moment, r.energy, r.turn[0], r.turn[1]]);
        r.map(|r| r.map(f64::to_bits))
    };
    let asked = common::turning(None, 1e6);
    for theta in [1.1, 1.2, 1.1, 1.1, 0.0, -0.0, f64::NAN, 1.2] {
        assert_eq!(of(&asked, theta), of(&common::turning(None, 1e6), theta), "{theta}");
    }
    let later = common::dynamics(None);
    assert_eq!(of(&later, 1.1).expect("closes")[4], 0);
    let turntable = asked.turntable().expect("it slews");
    assert_eq!(of(&later.with_slewing(turntable), 1.1), of(&asked, 1.1));
}

/// Luffing with a swinging load under 1.8 MN·m for 5 s: the reference of the measurements.
#[test]
fn luffing_with_a_pendulum_meets_the_reference() {
    let crane = crane();
    let (theta, swing) = (1.959_365_828_718_83, 0.510_282_010_345_209_9);
    let mut last = f64::INFINITY;
    for (h, steps, bound) in [(0.1, 50, 1e-4), (0.01, 500, 1e-8), (0.001, 5000, 1e-12)] {
        let end = run(&crane, 1.8e6, h, steps);
        let error = (end.theta - theta).abs().max((end.swing.abs() - swing).abs());
        println!("h = {h}: theta {} swing {} error {error:.1e}", end.theta, end.swing);
        assert!(error < bound && error < last, "h = {h}: {error:e}");
        last = error;
    }
}

/// Without drive and friction nothing is lost: a crane whose boom has a heavy tail rocks about the
/// upright for a million steps.
#[test]
fn a_million_steps_conserve_energy() {
    let (extremes, drift) = common::rock(1_000_000);
    println!("theta {extremes:?}, drift {drift:.1e}");
    assert!(extremes[1] - extremes[0] > 0.1, "it moves: {extremes:?}");
    assert!(drift.abs() < 1e-9);
}

/// The work of the drive is what the energy grows by, with a swinging load and large angles of the rope.
#[test]
fn work_is_energy() {
    let crane = common::with_boom(200e3, -16.0, 2.0, Some(common::PENDULUM));
    let mut m = Phase {
        theta: 1.2,
        swing: 3.0,
        ..START
    };
    let (first, moment, h) = (crane.energy(&m).expect("closes"), 2e5, 1e-3);
    let from = m.theta;
    for _ in 0..5000 {
        m = crane.step(&m, moment, h).expect("stays within the range");
    }
    let gained = crane.energy(&m).expect("closes") - first;
    let work = moment * (m.theta - from);
    let size = 16e3 * 9.81 * 10.0;
    println!("work {work} J, gained {gained} J");
    assert!((gained - work).abs() < 1e-9 * size, "{gained} {work}");
}

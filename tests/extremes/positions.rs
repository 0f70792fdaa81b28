//! Positions, lengths and masses: `tests/oracles/dynamics_extremes.py`, 50 digits.

use lemnis_models::luffing::double_link::linkage::{Bodies, HeavyLinkage};
use lemnis_models::luffing::moving::bodies::{Body, Pendulum};
use lemnis_models::luffing::moving::dynamics::{Coordinate, Dynamics};
use lemnis_models::luffing::moving::pendulum::Phase;
use lemnis_models::parts::hoist::Hoist;
use lemnis_models::parts::plane::Point;

use crate::crane;

const ORACLE: &str = include_str!("../oracles/dynamics_extremes.csv");

/// The crane with lengths and masses multiplied; the load is fixed to the head, or hangs on a rope.
pub fn scaled(length: f64, mass: f64, pendulum: Option<Pendulum>) -> Dynamics {
    let g = crane::scaled(length);
    HeavyLinkage::new(&g, crane::bodies(&g, mass, pendulum)).in_motion()
}

/// A double as C and Python write it in hexadecimal.
pub fn hex(text: &str) -> f64 {
    let (sign, text) = text.strip_prefix('-').map_or((1.0, text), |rest| (-1.0, rest));
    if text.starts_with("0x0.") {
        return 0.0;
    }
    let (digits, exponent) = text
        .strip_prefix("0x1.")
        .and_then(|rest| rest.split_once('p'))
        .expect("a normal hexadecimal number");
    let mantissa = u64::from_str_radix(digits, 16).expect("hexadecimal");
    let exponent: i64 = exponent.parse().expect("an exponent");
    sign * f64::from_bits(((exponent + 1023) as u64) << 52 | mantissa << (52 - 4 * digits.len()))
}

/// Dead points to 1e-15, theta_1 = theta_3, and lengths from 1e-3 to 1e6 of the crane's: inertia, its
/// slope and the moment to 1e-12 of the value; before a dead point they grow beyond all bounds.
#[test]
fn dead_points_and_lengths_agree_with_50_digits() {
    let (mut worst, mut cases) = ([0.0_f64; 3], 0);
    for line in ORACLE.lines().skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        let number = |i: usize| cells[i].parse::<f64>().expect("a number");
        let crane = scaled(number(2), number(3), None);
        let r = f64::reduced(&crane, hex(cells[1])).unwrap_or_else(|| panic!("{} closes", cells[0]));
        for (i, (ours, exact)) in [(r.inertia, number(4)), (r.slope, number(5)), (r.moment, number(6))]
            .into_iter()
            .enumerate()
        {
            let error = ((ours - exact) / exact).abs();
            assert!(error < 1e-12, "{} quantity {i}: {ours} {exact} {error:e}", cells[0]);
            worst[i] = worst[i].max(error);
        }
        cases += 1;
    }
    assert_eq!(cases, 34);
    println!(
        "{cases} positions: inertia {:.1e}, slope {:.1e}, moment {:.1e}",
        worst[0], worst[1], worst[2]
    );
}

/// Masses from 1e-6 to 1e9 kg and lengths from 1e-3 to 1e6 m: motion scales exactly as dimensions do,
/// so that masses cancel and time goes with the root of the length.
#[test]
fn masses_and_lengths_scale() {
    let start = Phase {
        theta: 1.2,
        omega: 0.0,
        swing: 0.0,
        swing_rate: 0.0,
    };
    let run = |length: f64, mass: f64| {
        let crane = scaled(length, mass, None);
        let h = 0.01 * length.sqrt();
        (0..200)
            .fold(start, |m, _| crane.step(&m, 0.0, h).expect("closes"))
            .theta
    };
    let reference = run(1.0, 1.0);
    // Bodies from 5e-7 of 2 t to 1e9 kg; lengths from 1e-3 to 1e6 m.
    for mass in [1e-10, 1e-6, 1e3, 5e4] {
        assert!((run(1.0, mass) - reference).abs() < 1e-12, "{mass}");
    }
    for length in [1e-4, 1e-2, 1e2, 1e5] {
        assert!((run(length, 1.0) - reference).abs() < 1e-11, "{length}");
    }
}

/// Without inertia of one body, and without load: the others carry on, and energy is kept.
#[test]
fn zero_inertia_and_zero_load() {
    let zero = Point::new(0.0, 0.0);
    let none = Body {
        mass: 0.0,
        inertia: 0.0,
        centre: zero,
        spread: [0.0; 3],
    };
    let g = crane::geometry();
    let full = crane::bodies(&g, 1.0, None);
    for bodies in [
        Bodies { boom: none, ..full },
        Bodies { jib: none, ..full },
        Bodies { rocker: none, ..full },
        Bodies {
            pendulum: Some(Pendulum {
                mass: 1e-300,
                length: 10.0,
                hoist: Hoist::AT_ONCE,
            }),
            ..full
        },
    ] {
        let crane = HeavyLinkage::new(&g, bodies).in_motion();
        let mut m = Phase {
            theta: 1.2,
            omega: 0.0,
            swing: 0.0,
            swing_rate: 0.0,
        };
        let first = crane.energy(&m).expect("closes");
        for _ in 0..500 {
            m = crane.step(&m, 0.0, 1e-3).expect("closes");
        }
        let size = 1e5 * 9.81;
        assert!((crane.energy(&m).expect("closes") - first).abs() < 1e-9 * size, "{m:?}");
        assert!(m.theta < 1.2, "it falls");
    }
}

/// No inertia at all: there is no acceleration, and the step is refused rather than answered.
#[test]
fn no_inertia_at_all_is_refused() {
    let none = Body {
        mass: 0.0,
        inertia: 0.0,
        centre: Point::new(0.0, 0.0),
        spread: [0.0; 3],
    };
    let crane = HeavyLinkage::new(
        &crane::geometry(),
        Bodies {
            boom: none,
            jib: none,
            rocker: none,
            pendulum: None,
            load: None,
            gravity: 9.81,
        },
    )
    .in_motion();
    let m = Phase {
        theta: 1.2,
        omega: 0.0,
        swing: 0.0,
        swing_rate: 0.0,
    };
    assert_eq!(crane.step(&m, 1.0, 1e-3), None);
}

/// Driven into a dead point without a stop before it, the motion ends there with a refusal, and
/// every state up to it is finite.
#[test]
fn the_end_of_assembly_is_refused() {
    let crane = scaled(1.0, 1.0, None);
    let mut m = Phase {
        theta: 0.9,
        omega: -0.05,
        swing: 0.0,
        swing_rate: 0.0,
    };
    let mut steps = 0;
    while let Some(next) = crane.step(&m, 0.0, 1e-3) {
        m = next;
        steps += 1;
        assert!(m.theta.is_finite() && m.omega.is_finite());
        // Inertia grows without bound before the dead point: the bar creeps in, or is thrown back.
        if steps == 100_000 {
            break;
        }
    }
    assert!(m.theta > 48.95968_f64.to_radians() - 1e-6, "{}", m.theta.to_degrees());
}

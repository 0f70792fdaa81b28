//! Ropes of 0.01 m and of 1 km, swing to 179 degrees.

use lemnis_models::kernel::calc::Calc;
use lemnis_models::luffing::moving::bodies::Pendulum;
use lemnis_models::luffing::moving::crane::Commands;
use lemnis_models::luffing::moving::motion::{MotionState, MovingLinkage};
use lemnis_models::parts::hoist::{Hoist, HoistCommand};
use lemnis_models::parts::joint::{Friction, Joint, JointDrive};

use super::crane;

const HELD: Commands<1> = Commands {
    shaft: 0.0,
    drives: [JointDrive {
        moment: 0.0,
        brake: f64::INFINITY,
    }],
    hoist: HoistCommand::speed(0.0),
};

fn motion(length: f64) -> MovingLinkage {
    MovingLinkage {
        dynamics: crane::dynamics(Some(Pendulum {
            mass: 16e3,
            length,
            hoist: Hoist::AT_ONCE,
        })),
        joints: [Joint {
            friction: Friction {
                viscous: 0.0,
                coulomb: 0.0,
            },
            stops: [60_f64.to_radians(), 120_f64.to_radians()],
        }],
    }
}

/// The period is that of theory, from 0.2 s for 0.01 m to 63 s for 1 km, at 1000 steps for each.
#[test]
fn ropes_of_a_centimetre_and_of_a_kilometre() {
    for length in [0.01, 0.1, 100.0, 1000.0] {
        let m = motion(length);
        let mut state = MotionState::resting(1.5, length);
        state.y[2] = 0.5;
        let (mut a, mut b) = (1.0_f64, Calc::sin_cos(0.25_f64).1);
        for _ in 0..6 {
            (a, b) = (f64::midpoint(a, b), (a * b).sqrt());
        }
        let period = std::f64::consts::TAU * (length / 9.81).sqrt() / a;
        m.advance(&mut state, &HELD, period, period / 1000.0).expect("swings");
        assert!((state.y[2] - 0.5).abs() < 1e-9, "{length} m: {}", state.y[2]);
    }
}

/// Held at 179 degrees and let go: the rope is slack, the load falls 2 l cos(1 deg) and is caught 1
/// degree from straight below, where the blow leaves only its motion across the rope.
#[test]
fn let_go_at_179_degrees() {
    let m = motion(10.0);
    let mut state = MotionState::resting(1.5, 10.0);
    state.y[2] = 179_f64.to_radians();
    let (sin, cos) = Calc::sin_cos(1_f64.to_radians());
    let fall = (4.0 * 10.0 * cos / 9.81).sqrt();
    m.advance(&mut state, &HELD, fall + 1e-6, 1e-4)
        .expect("falls and is caught");
    assert!(state.taut);
    let rate = 9.81 * fall * sin / 10.0;
    assert!((state.y[3].abs() - rate).abs() < 1e-5, "{} {rate}", state.y[3]);
    let turned = state.y[2].rem_euclid(std::f64::consts::TAU);
    assert!((turned - 1_f64.to_radians()).abs() < 1e-5, "{turned}");
}

/// With speed enough to stay taut, the load turns over the top: v² ≥ 5 g l at the bottom.
#[test]
fn over_the_top_only_with_speed_enough() {
    for (factor, over) in [(4.99_f64, false), (5.01, true)] {
        let m = motion(10.0);
        let mut state = MotionState::resting(1.5, 10.0);
        state.y[3] = (factor * 9.81 / 10.0).sqrt();
        let mut slack = false;
        for _ in 0..400 {
            m.advance(&mut state, &HELD, 0.01, 0.01).expect("turns");
            slack |= !state.taut;
        }
        assert_eq!(!slack, over, "{factor}");
    }
}

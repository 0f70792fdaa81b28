//! Denormal, huge and non-finite inputs; steps from 1e-9 to 1e3 s; friction without end and without any.

use lemnis_models::luffing::moving::crane::Commands;
use lemnis_models::luffing::moving::motion::{MotionState, MovingLinkage};
use lemnis_models::parts::hoist::HoistCommand;
use lemnis_models::parts::joint::{Bar, Friction, Joint};
use lemnis_models::parts::solver::{Halt, MOST_STEPS};

use super::crane;

const NONE: Commands<1> = crane::commands(0.0, 0.0);

fn motion(viscous: f64, coulomb: f64) -> MovingLinkage {
    MovingLinkage {
        dynamics: crane::dynamics(Some(crane::PENDULUM)),
        joints: [Joint {
            friction: Friction { viscous, coulomb },
            stops: [60_f64.to_radians(), 120_f64.to_radians()],
        }],
    }
}

/// Inputs that are no numbers are refused without a change; denormal ones are like zero, to the last bit.
#[test]
fn denormal_huge_and_broken_inputs() {
    let m = motion(1e5, 1e3);
    let start = MotionState::resting(1.5, 10.0);
    let run = |commands: Commands<1>, duration: f64| {
        let mut state = start;
        m.advance(&mut state, &commands, duration, 0.01).map(|_| state)
    };
    let zero = run(NONE, 0.5).expect("moves");
    for tiny in [5e-324, -5e-324, 1e-310] {
        assert_eq!(run(crane::driven(tiny), 0.5), Ok(zero), "{tiny:e}");
        // The rate of the load's distance is the hoist's own; nothing else differs.
        let hoisted = run(
            Commands {
                shaft: 0.0,
                hoist: HoistCommand::speed(tiny),
                ..NONE
            },
            0.5,
        )
        .expect("moves");
        assert_eq!(hoisted.y[..6], zero.y[..6], "{tiny:e}");
    }
    for broken in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(run(crane::driven(broken), 0.5), Err(Halt::Outside));
        assert_eq!(
            run(
                Commands {
                    shaft: 0.0,
                    hoist: HoistCommand::speed(broken),
                    ..NONE
                },
                0.5
            ),
            Err(Halt::Outside)
        );
    }
    assert_eq!(run(crane::braked(f64::NAN), 0.5), Err(Halt::Outside));
    assert_eq!(run(crane::braked(-1.0), 0.5), Err(Halt::Outside));
    // Huge but finite: refused, or at a stop with finite numbers.
    for huge in [1e15, -1e15, 1e300, f64::MAX] {
        match run(crane::driven(huge), 0.5) {
            Ok(state) => assert!(state.y.iter().all(|x| x.is_finite()), "{huge:e} {state:?}"),
            Err(halt) => assert!(
                matches!(halt, Halt::Outside | Halt::TooMany | Halt::TooFast),
                "{huge:e}"
            ),
        }
    }
}

/// Communication steps from 1e-9 to 1e3 s: at rest exactly at rest; beyond a million inner steps refused.
#[test]
fn steps_from_a_nanosecond_to_a_quarter_of_an_hour() {
    let m = motion(1e5, f64::INFINITY);
    let mut state = MotionState::resting(1.5, 10.0);
    for size in [1e-9, 1e-6, 1e-3, 1.0, 1e3] {
        m.advance(&mut state, &NONE, size, 0.01).expect("rests");
    }
    assert_eq!(
        (state.joints[0], state.y[0]),
        (Bar::Held, 1.5),
        "infinite friction holds for ever"
    );
    let before = state;
    let longest = 0.01;
    let beyond = longest * f64::from(MOST_STEPS) * 1.01;
    assert_eq!(m.advance(&mut state, &NONE, beyond, longest), Err(Halt::TooMany));
    assert_eq!(state, before);
}

/// Infinite viscosity is refused as soon as anything moves, zero is conservative: a million steps of a
/// swinging load on a held bar keep its energy to 1e-9.
#[test]
fn a_million_steps_of_the_swing() {
    let m = motion(0.0, 0.0);
    let held = crane::braked(f64::INFINITY);
    let mut state = MotionState::resting(1.5, 10.0);
    state.y[2] = 1.0;
    let first = m.energy(&state).expect("closes");
    // 1000 s in steps of 1 ms.
    for _ in 0..1000 {
        m.advance(&mut state, &held, 1.0, 1e-3).expect("swings");
    }
    let swinging = 16e3 * 9.81 * 10.0 * (1.0 - lemnis_models::kernel::calc::Calc::sin_cos(1.0_f64).1);
    let drift = (m.energy(&state).expect("closes") - first) / swinging;
    println!("drift {drift:.1e}");
    assert!(drift.abs() < 1e-9, "{drift:e}");
}

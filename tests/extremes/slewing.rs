//! A crane that slews: the load in every direction, no inertia and no end of it, no load, inputs that are none.

use lemnis_models::kernel::calc::Calc;
use lemnis_models::luffing::double_link::linkage::{Bodies, HeavyLinkage};
use lemnis_models::luffing::moving::bodies::{Body, Pendulum, Turntable};
use lemnis_models::luffing::moving::crane::Commands;
use lemnis_models::luffing::moving::dynamics::Coordinate;
use lemnis_models::luffing::moving::space::{Slewing, SlewingState, distance};
use lemnis_models::parts::hoist::{Hoist, HoistCommand};
use lemnis_models::parts::joint::JointDrive;
use lemnis_models::parts::plane::Point;
use lemnis_models::parts::solver::Halt;

use super::crane;

const G: f64 = 9.81;
const NONE: JointDrive = JointDrive {
    moment: 0.0,
    brake: 0.0,
};
const BRAKED: JointDrive = JointDrive {
    moment: 0.0,
    brake: f64::INFINITY,
};
const HELD: Commands<2> = Commands {
    shaft: 0.0,
    drives: [BRAKED, BRAKED],
    hoist: HoistCommand::speed(0.0),
};

fn slews(moment: f64) -> Commands<2> {
    Commands {
        shaft: 0.0,
        drives: [BRAKED, JointDrive { moment, brake: 0.0 }],
        hoist: HoistCommand::speed(0.0),
    }
}

fn frictionless(mass: f64, length: f64, inertia: f64) -> Slewing {
    crane::slewing(
        Some(Pendulum {
            mass,
            length,
            hoist: Hoist::AT_ONCE,
        }),
        inertia,
        [[0.0; 2]; 2],
    )
}

/// The load at rest on a rope at an angle (rad) from the vertical, towards a direction (rad) to the left of forward.
fn leaning(length: f64, angle: f64, towards: f64) -> SlewingState {
    let mut state = SlewingState::resting(1.5, length);
    let ((sin, cos), (left, forward)) = (Calc::sin_cos(angle), Calc::sin_cos(towards));
    state.y[4..7].copy_from_slice(&[sin * forward, -cos, sin * left].map(|x| x * length));
    state
}

const DIRECTIONS: [f64; 5] = [0.0, 0.3, std::f64::consts::FRAC_PI_2, 2.0, -3.0];

/// In every direction the period is that of theory, T = 4 sqrt(l/g) K(sin(a/2)), from a centimetre to a
/// kilometre and up to a level rope.
#[test]
fn the_period_is_the_same_in_every_direction() {
    for (length, angle) in [(10.0, 0.1), (10.0, 1.5), (0.01, 0.5), (1000.0, 0.5)] {
        let (mut a, mut b) = (1.0_f64, Calc::sin_cos(angle / 2.0_f64).1);
        for _ in 0..6 {
            (a, b) = (f64::midpoint(a, b), (a * b).sqrt());
        }
        let period = std::f64::consts::TAU * (length / G).sqrt() / a;
        let m = frictionless(16e3, length, 5e6);
        for towards in DIRECTIONS {
            let (mut state, start) = (leaning(length, angle, towards), leaning(length, angle, towards));
            m.advance(&mut state, &HELD, period, period / 4000.0).expect("swings");
            let error = (4..7).map(|i| (state.y[i] - start.y[i]).abs()).fold(0.0, f64::max);
            assert!(
                state.taut && error < 1e-9 * length,
                "{length} {angle} {towards}: {error:e}"
            );
        }
    }
}

/// Let go at 179 degrees in any direction: slack, a fall of 2 l cos(1 deg), and a blow 1 degree from
/// straight below that leaves only the motion across the rope.
#[test]
fn let_go_at_179_degrees_in_any_direction() {
    let (sin, cos) = Calc::sin_cos(1_f64.to_radians());
    let fall = (4.0 * 10.0 * cos / G).sqrt();
    for towards in DIRECTIONS {
        let m = frictionless(16e3, 10.0, 5e6);
        let mut state = leaning(10.0, 179_f64.to_radians(), towards);
        m.advance(&mut state, &HELD, 1e-3, 1e-4).expect("lets go");
        assert!(!state.taut);
        m.advance(&mut state, &HELD, fall - 1e-3 + 1e-6, 1e-4)
            .expect("is caught");
        assert!(state.taut);
        let speed = (7..10).map(|i| state.y[i] * state.y[i]).sum::<f64>().sqrt();
        assert!((speed - G * fall * sin).abs() < 1e-4, "{towards}: {speed}");
    }
}

/// With v² ≥ 5 g l at the bottom the load turns over the top on a taut rope, through level and upright
/// rope, in any direction; with less the rope goes slack.
#[test]
fn over_the_top_in_any_direction_only_with_speed_enough() {
    for (factor, over) in [(4.99_f64, false), (5.01, true)] {
        for towards in DIRECTIONS {
            let m = frictionless(16e3, 10.0, 5e6);
            let mut state = SlewingState::resting(1.5, 10.0);
            let (left, forward) = Calc::sin_cos(towards);
            let speed = (factor * G * 10.0).sqrt();
            (state.y[7], state.y[9]) = (speed * forward, speed * left);
            let (mut slack, mut highest) = (false, f64::NEG_INFINITY);
            for _ in 0..400 {
                m.advance(&mut state, &HELD, 0.01, 0.01).expect("turns");
                slack |= !state.taut;
                highest = highest.max(state.y[5]);
            }
            assert_eq!(!slack, over, "{factor} {towards}");
            assert!(!over || highest > 9.9);
        }
    }
}

/// The rest without inertia: the bars' own keeps the angular momentum. A rest without end of it: the load
/// swings as from a held crane.
#[test]
fn inertia_of_the_rest_from_nothing_to_without_end() {
    let m = frictionless(16e3, 10.0, 0.0);
    let mut state = leaning(10.0, 0.4, 1.0);
    state.y[3] = 0.1;
    let free = slews(0.0);
    m.event(&mut state, &free).expect("closes");
    let first = m.angular_momentum(&state).expect("closes");
    m.advance(&mut state, &free, 20.0, 1e-3).expect("slews");
    let drift = m.angular_momentum(&state).expect("closes") / first - 1.0;
    assert!(drift.abs() < 1e-10, "{drift:e}");

    let heavy = frictionless(16e3, 10.0, 1e18);
    let [mut free_state, mut held_state] = [leaning(10.0, 0.9, 1.0); 2];
    heavy.advance(&mut free_state, &free, 20.0, 1e-3).expect("swings");
    heavy.advance(&mut held_state, &HELD, 20.0, 1e-3).expect("swings");
    for i in 4..7 {
        assert!((free_state.y[i] - held_state.y[i]).abs() < 1e-9, "{free_state:?}");
    }
    // Angle of the rest: a moment of at most m g l times the reach over its inertia, for 20 s.
    assert!(free_state.y[2].abs() < 16e3 * G * 2.0 * 35.0 / 1e18 * 200.0);
}

/// A load that weighs nothing: the crane slews by ½ M/J t², to the last digits, and the rope's force is zero.
#[test]
fn a_load_without_weight() {
    for mass in [0.0, 1e-300] {
        let m = frictionless(mass, 10.0, 5e6);
        let mut state = leaning(10.0, 0.3, 1.0);
        let commands = slews(1e6);
        m.advance(&mut state, &commands, 10.0, 0.01).expect("slews");
        let r = f64::reduced(&m.dynamics, 1.5).expect("closes");
        let angle = 0.5 * 1e6 / r.turn[0] * 100.0;
        assert!((state.y[2] / angle - 1.0).abs() < 1e-13, "{} {angle}", state.y[2]);
        assert!(m.rope_force(&state, &commands, &state.y).expect("closes").abs() < 1e-290);
    }
}

/// The head in the slewing axis itself: the load has no arm about it and slews nothing.
#[test]
fn a_head_in_the_axis() {
    let inner = crane::dynamics(Some(crane::PENDULUM));
    let head = f64::reduced(&inner, 1.5).expect("closes").head[0];
    let m = Slewing {
        dynamics: inner.with_slewing(Turntable {
            axis: head.x,
            inertia: 5e6,
        }),
        ..frictionless(16e3, 10.0, 5e6)
    };
    let mut state = leaning(10.0, 1.0, 1.0);
    m.advance(&mut state, &slews(0.0), 20.0, 1e-3).expect("swings");
    assert_eq!((state.y[2], state.y[3]), (0.0, 0.0), "not by one bit");
}

/// Nothing has any inertia: there is no acceleration, and the step is refused rather than answered.
#[test]
fn no_inertia_at_all_is_refused() {
    let none = Body::uniform(0.0, Point::new(0.0, 0.0), Point::new(1.0, 0.0));
    let bodies = Bodies {
        boom: none,
        jib: none,
        rocker: none,
        pendulum: None,
        load: None,
        gravity: G,
    };
    let dynamics = HeavyLinkage::new(&crane::geometry(), bodies)
        .in_motion()
        .with_slewing(Turntable {
            axis: -5.2,
            inertia: 0.0,
        });
    let m = Slewing {
        dynamics,
        ..frictionless(16e3, 10.0, 0.0)
    };
    let mut state = SlewingState::resting(1.5, 0.0);
    assert_eq!(m.advance(&mut state, &slews(1.0), 0.1, 0.01), Err(Halt::Outside));
}

/// Inputs that are no numbers are refused without a change; denormal ones are like zero; huge ones are
/// refused or answered with finite numbers; steps from a nanosecond to a quarter of an hour at rest stay at rest.
#[test]
fn inputs_and_steps() {
    let m = crane::slewing(Some(crane::PENDULUM), 5e6, [[1e5, 1e3], [1e5, 1e3]]);
    let start = leaning(10.0, 0.2, 0.7);
    let run = |commands: Commands<2>, duration: f64| {
        let mut state = start;
        m.advance(&mut state, &commands, duration, 0.01).map(|_| state)
    };
    let driven = |drive: JointDrive| Commands {
        shaft: 0.0,
        drives: [NONE, drive],
        hoist: HoistCommand::speed(0.0),
    };
    let zero = run(driven(NONE), 0.5).expect("moves");
    for tiny in [5e-324, -5e-324, 1e-310] {
        assert_eq!(run(driven(JointDrive { moment: tiny, ..NONE }), 0.5), Ok(zero));
    }
    for broken in [f64::NAN, f64::INFINITY] {
        assert_eq!(
            run(driven(JointDrive { moment: broken, ..NONE }), 0.5),
            Err(Halt::Outside)
        );
    }
    for brake in [f64::NAN, -1.0] {
        assert_eq!(run(driven(JointDrive { brake, ..NONE }), 0.5), Err(Halt::Outside));
    }
    for huge in [1e15, -1e15, 1e300, f64::MAX] {
        match run(driven(JointDrive { moment: huge, ..NONE }), 0.5) {
            Ok(state) => assert!(state.y.iter().all(|x| x.is_finite()), "{huge:e} {state:?}"),
            Err(halt) => assert!(
                matches!(halt, Halt::Outside | Halt::TooMany | Halt::TooFast),
                "{huge:e}"
            ),
        }
    }
    let mut state = SlewingState::resting(1.5, 10.0);
    let resting = state;
    for size in [1e-9, 1e-6, 1e-3, 1.0, 1e3] {
        m.advance(&mut state, &HELD, size, 0.01).expect("rests");
    }
    assert_eq!(state, resting, "infinite friction holds for ever");
    assert_eq!(m.advance(&mut state, &HELD, 1.01e4, 0.01), Err(Halt::TooMany));
    assert_eq!(state, resting);
}

/// A million steps of a load that swings round while the crane slews freely: energy and angular momentum
/// stay to 1e-9, and the rope as long as it is.
#[test]
fn a_million_steps_of_a_slewing_crane() {
    let m = frictionless(16e3, 10.0, 5e6);
    let mut state = leaning(10.0, 0.8, 1.1);
    state.y[3] = 0.05;
    let free = slews(0.0);
    m.event(&mut state, &free).expect("closes");
    let of = |state: &SlewingState| {
        [
            m.energy(state).expect("closes"),
            m.angular_momentum(state).expect("closes"),
        ]
    };
    let first = of(&state);
    for _ in 0..1000 {
        m.advance(&mut state, &free, 1.0, 1e-3).expect("swings");
    }
    let last = of(&state);
    let drift = [(last[0] - first[0]) / (16e3 * G * 10.0), last[1] / first[1] - 1.0];
    let stretch = distance(&state.y) / 10.0 - 1.0;
    println!("drift {drift:?}, stretch {stretch:e}");
    assert!(drift.iter().all(|x| x.abs() < 1e-9), "{drift:?}");
    assert!(stretch.abs() < 1e-12, "{stretch:e}");
}

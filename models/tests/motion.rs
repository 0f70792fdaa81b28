//! Levels `rigid` and `swing`: friction that sticks, brake, end stops, a rope that is reeled and
//! goes slack. Expectations from theory: balances of energy and of moments, free fall, symmetry.

use lemnis_models::luffing::moving::bodies::Pendulum;
use lemnis_models::luffing::moving::crane::Commands;
use lemnis_models::luffing::moving::motion::{MotionState, MovingLinkage};
use lemnis_models::parts::hoist::HoistCommand;
use lemnis_models::parts::joint::{Bar, Friction, Joint};
use lemnis_models::parts::solver::{Halt, runge_kutta};

#[path = "common/crane.rs"]
mod crane;

const STILL: Commands<1> = crane::commands(0.0, 0.0);

fn motion(pendulum: Option<Pendulum>, viscous: f64, coulomb: f64) -> MovingLinkage {
    MovingLinkage {
        dynamics: crane::dynamics(pendulum),
        joints: [Joint {
            friction: Friction { viscous, coulomb },
            stops: [60_f64.to_radians(), 120_f64.to_radians()],
        }],
    }
}

fn at(degrees: f64, length: f64) -> MotionState {
    MotionState::resting(degrees.to_radians(), length)
}

/// Moment that holds the crane at rest.
fn holding(m: &MovingLinkage, state: &MotionState) -> f64 {
    let held = crane::braked(1e12);
    m.friction_moment(0, state, &held, &state.y).expect("closes")
}

/// Below the limit of friction the bar does not move by one bit, whatever the step; just above it breaks loose.
#[test]
fn friction_truly_sticks() {
    let m = motion(None, 0.0, 50e3);
    let start = at(75.0, 0.0);
    let hold = holding(&m, &start);
    for (over, moves) in [
        (-0.999_999, false),
        (0.0, false),
        (0.999_999, false),
        (1.000_001, true),
        (-1.000_001, true),
    ] {
        let commands = crane::driven(hold + over * 50e3);
        let mut state = start;
        for size in [1e-9, 1e-3, 0.1, 1.0, 10.0] {
            m.advance(&mut state, &commands, size, 0.01).expect("stays");
        }
        assert_eq!(state.y[0] != start.y[0], moves, "{over}: {state:?}");
        assert!(moves || (state.joints[0] == Bar::Held && state.y == start.y));
    }
}

/// Without friction, in equilibrium, nothing moves; beside it the bar follows the moment's sign.
#[test]
fn no_friction_holds_nothing() {
    let m = motion(None, 0.0, 0.0);
    let start = at(75.0, 0.0);
    let hold = holding(&m, &start);
    for (extra, sign) in [(1.0, 1.0), (-1.0, -1.0)] {
        let commands = crane::driven(hold + extra);
        let mut state = start;
        m.advance(&mut state, &commands, 0.1, 0.01).expect("stays");
        assert_eq!((state.y[0] - start.y[0]).signum(), sign);
    }
}

/// What a bar at rest does follows from the commands of the moment, not from those before.
#[test]
fn a_bar_at_rest_is_decided_again() {
    let m = motion(None, 0.0, 20e3);
    let mut state = at(60.0, 0.0);
    let up = crane::driven(1e7);
    m.event(&mut state, &up).expect("closes");
    assert_eq!(state.joints[0], Bar::Forward);
    // The lower stop holds it: without a moment it stays.
    m.event(&mut state, &STILL).expect("closes");
    assert_eq!(state.joints[0], Bar::Held);
    let rates = m.rates(&state, &STILL, &state.y).expect("closes");
    assert_eq!(rates[..2], [0.0, 0.0]);
}

/// A brake of any moment, up to infinity, holds; released, the crane falls, and braked again it stops
/// and stays: the energy lost is the work of friction and brake over the way.
#[test]
fn a_brake_stops_the_fall_and_takes_its_energy() {
    let m = motion(None, 3e5, 20e3);
    let mut state = at(80.0, 0.0);
    m.advance(&mut state, &crane::braked(f64::INFINITY), 100.0, 0.01)
        .expect("holds");
    assert_eq!(state, at(80.0, 0.0));

    m.advance(&mut state, &STILL, 1.0, 0.01).expect("falls");
    let falling = state;
    assert!(falling.y[1].abs() > 0.01 && falling.joints[0] != Bar::Held);
    let commands = crane::braked(6e6);
    let (first, mut work, mut steps) = (m.energy(&state).expect("closes"), 0.0, 0);
    while state.joints[0] != Bar::Held {
        let before = state;
        m.advance(&mut state, &commands, 1e-4, 1e-4).expect("brakes");
        // Viscous work by Simpson's rule with the middle of the step, dry work exact over the way.
        let mut half = before;
        m.advance(&mut half, &commands, 5e-5, 5e-5).expect("brakes");
        let power = [before, half, state].map(|s| 3e5 * s.y[1] * s.y[1]);
        let part = if state.joints[0] == Bar::Held { 0.0 } else { 1e-4 };
        work += (power[0] + 4.0 * power[1] + power[2]) / 6.0 * part + (20e3 + 6e6) * (state.y[0] - before.y[0]).abs();
        steps += 1;
        assert!(steps < 100_000);
    }
    let lost = first - m.energy(&state).expect("closes");
    println!(
        "fell at {} rad/s, stopped after {steps} steps, lost {lost} J, work {work} J",
        falling.y[1]
    );
    // What the last step leaves out: less than a step's viscous work.
    let last = 3e5 * (6.1e6 / 1e7 * 1e-4_f64).powi(2) * 1e-4;
    assert!((lost - work).abs() < 1e-7 * lost + last, "{lost} {work}");
    let stopped = state;
    m.advance(&mut state, &commands, 10.0, 0.01).expect("holds");
    assert_eq!(state, stopped, "it stays where it stopped, to the last bit");
}

/// Friction that dissipates: input work = stored + dissipated over a drive up and down, through reversals.
#[test]
fn work_is_stored_or_dissipated_with_a_swinging_load() {
    let m = motion(Some(crane::PENDULUM), 2e5, 40e3);
    let mut state = at(75.0, 10.0);
    state.y[2] = 0.3;
    let first = m.energy(&state).expect("closes");
    let hold = holding(&m, &at(75.0, 10.0));
    let (mut work, mut lost, mut reversals, h) = (0.0, 0.0, 0, 1e-4);
    for i in 0..60_000 {
        // Up, down, up for two seconds each.
        let push = if (i / 20_000) % 2 == 0 { 3e5 } else { -3e5 };
        let commands = crane::driven(hold + push);
        let before = state;
        let mut half = state;
        m.advance(&mut half, &commands, h / 2.0, h).expect("moves");
        m.advance(&mut state, &commands, h, h).expect("moves");
        let way = state.y[0] - before.y[0];
        work += commands.drives[0].moment * way;
        let power = [before, half, state].map(|s| 2e5 * s.y[1] * s.y[1]);
        lost += (power[0] + 4.0 * power[1] + power[2]) / 6.0 * h + 40e3 * way.abs();
        reversals += u32::from(before.joints[0] != state.joints[0]);
    }
    let gained = m.energy(&state).expect("closes") - first;
    println!("work {work:.3} J, stored {gained:.3} J, lost {lost:.3} J, {reversals} changes");
    assert!(reversals >= 2 && lost > 1e3);
    // Where the bar turns within a step, its way there and back counts once: at most a few steps.
    assert!(
        (work - gained - lost).abs() < 1e-6 * (work.abs() + lost),
        "{}",
        work - gained - lost
    );
}

/// Against an end stop the bar rests, gives no energy back, and leaves when it is pulled off.
#[test]
fn an_end_stop_catches_the_bar() {
    let m = motion(None, 0.0, 10e3);
    let mut state = at(100.0, 0.0);
    let hold = holding(&m, &state);
    let up = crane::driven(hold + 2e6);
    m.advance(&mut state, &up, 20.0, 0.01).expect("arrives");
    assert_eq!(
        (state.y[0], state.y[1], state.joints[0]),
        (m.joints[0].stops[1], 0.0, Bar::Held)
    );
    let still = state;
    m.advance(&mut state, &crane::driven(1e9), 1.0, 0.01).expect("holds");
    assert_eq!(state, still);
    m.advance(&mut state, &crane::driven(-1e7), 0.1, 0.01).expect("leaves");
    assert!(state.y[0] < m.joints[0].stops[1] && state.y[1] < 0.0);
    // All the way down to the other one.
    m.advance(&mut state, &crane::driven(-1e7), 20.0, 0.01)
        .expect("arrives");
    assert_eq!(
        (state.y[0], state.y[1], state.joints[0]),
        (m.joints[0].stops[0], 0.0, Bar::Held)
    );
}

/// A held crane with a swinging load is a simple pendulum: T = 4 sqrt(l/g) K(sin(a/2)), here by the
/// arithmetic-geometric mean, for small swing and for 179 degrees.
#[test]
fn the_period_of_the_swing_is_that_of_theory() {
    let m = motion(Some(crane::PENDULUM), 0.0, 0.0);
    let held = crane::braked(f64::INFINITY);
    for degrees in [0.01_f64, 10.0, 60.0, 89.0] {
        let mut state = at(90.0, 10.0);
        state.y[2] = degrees.to_radians();
        let (mut a, mut b) = (
            1.0_f64,
            lemnis_models::kernel::calc::Calc::sin_cos(degrees.to_radians() / 2.0).1,
        );
        for _ in 0..6 {
            (a, b) = (f64::midpoint(a, b), (a * b).sqrt());
        }
        let period = std::f64::consts::TAU * (10.0_f64 / 9.81).sqrt() / a;
        m.advance(&mut state, &held, period, 1e-3).expect("swings");
        let error = (state.y[2] - degrees.to_radians()).abs();
        assert!(error < 1e-9 && state.taut, "{degrees}: {error:e}");
    }
}

/// Let go from above the horizontal at rest, the rope is slack at once: the load falls freely and
/// vertically until the rope catches it, where only the motion across the rope survives.
#[test]
fn a_slack_rope_lets_the_load_fall_freely_and_catches_it() {
    let m = motion(Some(crane::PENDULUM), 0.0, 0.0);
    let held = crane::braked(f64::INFINITY);
    let mut state = at(90.0, 10.0);
    // 150 degrees from the hanging position: 8.66 m above the head, 5 m beside it.
    state.y[2] = 150_f64.to_radians();
    m.advance(&mut state, &held, 1e-9, 0.01).expect("lets go");
    assert!(!state.taut && m.rope_force(&state, &held, &state.y) == Some(0.0));
    // It falls 2 · 8.66 m until the rope is straight again below the horizontal.
    let (root_3, g) = (3_f64.sqrt(), 9.81);
    let fall = (2.0 * 10.0 * root_3 / g).sqrt();
    m.advance(&mut state, &held, fall - 1e-6, 1e-3).expect("falls");
    assert!(!state.taut);
    let (sin, cos) = lemnis_models::kernel::calc::Calc::sin_cos(state.y[2]);
    assert!(
        (state.y[5] * sin - 5.0).abs() < 1e-9,
        "beside the head: {}",
        state.y[5] * sin
    );
    let height = 5.0 * root_3 - 0.5 * g * (fall - 1e-6) * (fall - 1e-6);
    assert!(
        (-state.y[5] * cos - height).abs() < 1e-7,
        "{} {height}",
        -state.y[5] * cos
    );
    m.advance(&mut state, &held, 2e-6, 1e-3).expect("catches");
    assert!(state.taut && (state.y[5] - 10.0).abs() < 1e-12);
    // Speed g·t, at 30 degrees to the vertical: across the rope v sin 30°, towards the hanging position.
    let across = g * fall * 0.5 / 10.0;
    assert!((state.y[3] + across).abs() < 1e-4, "{} {across}", state.y[3]);
    let energy = m.energy(&state).expect("closes");
    m.advance(&mut state, &held, 2.0, 1e-3).expect("swings");
    assert!((m.energy(&state).expect("closes") - energy).abs() < 1e-8 * 16e3 * g * 10.0);
}

/// With the bar free, momentum passes through the rope: no energy is gained in the blow, and the whole
/// path is the same in parts as at once.
#[test]
fn a_blow_of_the_rope_gains_no_energy() {
    let m = motion(Some(crane::PENDULUM), 0.0, 0.0);
    let mut state = at(90.0, 10.0);
    state.y[2] = 120_f64.to_radians();
    let hold = holding(&m, &at(90.0, 10.0));
    let commands = crane::driven(hold);
    let mut energy = m.energy(&state).expect("closes");
    let mut blows = 0;
    for _ in 0..4000 {
        let (before, way) = (state, state.y[0]);
        m.advance(&mut state, &commands, 1e-3, 1e-3).expect("moves");
        let work = hold * (state.y[0] - way);
        let now = m.energy(&state).expect("closes");
        assert!(now - energy - work < 1e-3, "gained {}", now - energy - work);
        blows += u32::from(!before.taut && state.taut);
        energy = now;
    }
    assert!(blows >= 1, "the rope caught the load");
}

/// Hoisting in: the angular momentum law makes the swing grow as l^(-3/4) for slow small swing.
#[test]
fn a_shorter_rope_swings_wider() {
    let m = motion(Some(crane::PENDULUM), 0.0, 0.0);
    let held = crane::braked(f64::INFINITY);
    let mut state = at(90.0, 40.0);
    state.y[2] = 0.01;
    let hoisting = Commands {
        shaft: 0.0,
        hoist: HoistCommand::speed(-0.02),
        ..held
    };
    m.advance(&mut state, &hoisting, 1500.0, 0.01).expect("hoists");
    assert!((state.y[4] - 10.0).abs() < 1e-9, "{}", state.y[4]);
    // Amplitude from angle and rate; adiabatic invariant E/omega, so amplitude ~ l^(-3/4).
    let amplitude = (state.y[2] * state.y[2] + state.y[3] * state.y[3] * 10.0 / 9.81).sqrt();
    let expected = 0.01 * 4_f64.sqrt() * 4_f64.sqrt().sqrt();
    assert!((amplitude / expected - 1.0).abs() < 5e-3, "{amplitude} {expected}");
}

/// The same bits whether a state was copied on the way or not, and the same path within the method's
/// error however the steps are cut.
#[test]
fn restored_and_irregular_steps_agree() {
    let m = motion(Some(crane::PENDULUM), 1e5, 20e3);
    let hold = holding(&m, &at(75.0, 10.0));
    let commands = crane::driven(hold + 4e5);
    let run = |sizes: &[f64]| {
        let mut state = at(75.0, 10.0);
        for size in sizes {
            m.advance(&mut state, &commands, *size, 1e-3).expect("moves");
            let saved = state;
            m.advance(&mut state, &commands, 0.5, 1e-3).expect("moves");
            state = saved;
        }
        state
    };
    let whole = run(&[1.0]);
    assert_eq!(whole, run(&[1.0]));
    let mut cut = at(75.0, 10.0);
    for size in [0.1, 1e-9, 0.3, 0.007, 0.593 - 1e-9] {
        m.advance(&mut cut, &commands, size, 1e-3).expect("moves");
    }
    let error = (0..4).map(|i| (whole.y[i] - cut.y[i]).abs()).fold(0.0, f64::max);
    assert!(error < 1e-11, "{error:e}");
}

/// A million inner steps are allowed in one call, whatever their size, and not one more.
#[test]
fn a_million_steps_are_allowed() {
    let m = motion(None, 0.0, 0.0);
    let held = crane::braked(f64::INFINITY);
    for (duration, longest) in [(1e4, 0.01), (777.7, 7.777e-4)] {
        let mut state = at(90.0, 10.0);
        let count = m.advance(&mut state, &held, duration, longest);
        assert_eq!(count.map(|count| count.steps), Ok(1_000_000), "{duration} {longest}");
        let more = m.advance(&mut state, &held, duration * 1.000_001, longest);
        assert_eq!(more, Err(Halt::TooMany), "{duration} {longest}");
    }
    // Where an event cuts a step in two, that is still one.
    let mut state = at(90.0, 10.0);
    state.y[1] = 0.1;
    let count = m.advance(&mut state, &crane::braked(1e7), 1e4, 0.01);
    assert_eq!(count.map(|count| count.steps), Ok(1_000_001));
    assert_eq!(state.joints[0], Bar::Held);
}

/// Numbers that are none are refused, and nothing hangs: every loop is counted.
#[test]
fn hopeless_steps_are_refused() {
    let m = motion(Some(crane::PENDULUM), 0.0, 0.0);
    let mut state = at(75.0, 10.0);
    let before = state;
    for moment in [f64::NAN, f64::INFINITY, f64::MAX] {
        let commands = crane::driven(moment);
        assert!(m.advance(&mut state, &commands, 0.1, 0.01).is_err(), "{moment}");
        state = before;
    }
    assert_eq!(m.advance(&mut state, &STILL, 1e6, 1e-9), Err(Halt::TooMany));
    // The explicit method is fourth order: the reference of the pendulum, stepped by hand.
    let free = MovingLinkage {
        joints: [Joint {
            stops: [0.0, 3.0],
            ..m.joints[0]
        }],
        ..m
    };
    let y = runge_kutta::step(&before.y, 1e-3, |y| free.rates(&before, &crane::driven(f64::NAN), y));
    assert!(y.is_some(), "a held bar does not move, whatever pushes it");
}

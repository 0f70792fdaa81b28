//! A load in air that resists it, still and in wind: closed forms, the plane against space, and the account of energy.

use lemnis_models::kernel::calc::Calc;
use lemnis_models::luffing::moving::crane::Commands;
use lemnis_models::luffing::moving::motion::{self, MotionState, MovingLinkage};
use lemnis_models::luffing::moving::space::{Slewing, SlewingState};
use lemnis_models::parts::air::AirDrag;
use lemnis_models::parts::hoist::{Drum, HoistCommand};
use lemnis_models::parts::joint::{Friction, Joint, JointDrive};

#[path = "common/crane.rs"]
mod crane;

const G: f64 = 9.81;
const M: f64 = 16e3;
const HELD: JointDrive = JointDrive {
    moment: 0.0,
    brake: f64::INFINITY,
};
const BRAKED: Commands<2> = Commands {
    shaft: 0.0,
    drives: [HELD, HELD],
    hoist: HoistCommand::speed(0.0),
};

/// What the air does to a load, and its speed (m/s) and direction (rad).
type Wind = (AirDrag<f64>, [f64; 2]);

fn wind(linear: f64, square: f64, blows: [f64; 2]) -> Wind {
    (AirDrag { linear, square }, blows)
}

/// In the plane and in space, with friction of luffing.
fn both(air: Wind, friction: [f64; 2]) -> (MovingLinkage, Slewing) {
    let mut space = crane::slewing(Some(crane::PENDULUM), 5e6, [friction, [0.0, 0.0]]);
    space.dynamics = space.dynamics.in_air(air.0, air.1);
    let [viscous, coulomb] = friction;
    let plane = MovingLinkage {
        dynamics: crane::dynamics(Some(crane::PENDULUM)).in_air(air.0, air.1),
        joints: [Joint {
            friction: Friction { viscous, coulomb },
            stops: [60_f64.to_radians(), 120_f64.to_radians()],
        }],
    };
    (plane, space)
}

fn at(length: f64, load: [f64; 2]) -> SlewingState {
    let mut state = SlewingState::resting(75_f64.to_radians(), length);
    state.put_load(load);
    state
}

fn flat(length: f64, swing: f64) -> MotionState {
    let mut state = MotionState::resting(75_f64.to_radians(), length);
    state.y[2] = swing;
    state
}

/// φ″ + δ φ′ + (g/l) φ = 0: the logarithmic decrement is π δ/ω_d with ω_d² = g/l − δ²/4, in every direction.
#[test]
fn small_swings_decay_as_their_closed_form() {
    let (length, delta) = (10.0, 0.1);
    let (plane, space) = both(wind(delta, 0.0, [0.0; 2]), [0.0; 2]);
    let damped = (G / length - delta * delta / 4.0).sqrt();
    let period = 2.0 * std::f64::consts::PI / damped;
    let first = 1e-4;
    let (mut flat, mut along, mut aside) = (flat(length, first), at(length, [first, 0.0]), at(length, [0.0, first]));
    for count in 1..=5 {
        plane
            .advance(&mut flat, &crane::braked(f64::INFINITY), period, 1e-3)
            .expect("moves");
        for state in [&mut along, &mut aside] {
            space.advance(state, &BRAKED, period, 1e-3).expect("moves");
        }
        // A whole period after it was let go: the sine is zero.
        let wanted = first * libm::exp(-delta * period * f64::from(count) / 2.0);
        for found in [flat.y[2], along.y[4] / length, aside.y[6] / length] {
            assert!((found / wanted - 1.0).abs() < 1e-7, "{found} {wanted}");
        }
    }
}

/// tan φ = a/g with a = (δ + κ v) v: it hangs still in the wind, and pulls with m √(g² + a²).
#[test]
fn it_hangs_still_in_a_steady_wind() {
    let (length, speed, to) = (10.0, 18.0, 0.7);
    let (delta, kappa) = (0.01, 0.004);
    let pull = (delta + kappa * speed) * speed;
    let (lean, force) = (Calc::direction(G, pull), M * (G * G + pull * pull).sqrt());
    let (plane, _) = both(wind(delta, kappa, [speed, 0.0]), [0.0; 2]);
    let (_, space) = both(wind(delta, kappa, [speed, to]), [0.0; 2]);
    let (mut still, held) = (flat(length, lean), crane::braked(f64::INFINITY));
    plane.advance(&mut still, &held, 10.0, 1e-3).expect("moves");
    assert!((still.y[2] - lean).abs() < 1e-13, "{}", still.y[2] - lean);
    let found = plane.rope_force(&still, &held, &still.y).expect("closes");
    assert!((found / force - 1.0).abs() < 1e-12);
    let ((sin, cos), (aside, ahead)) = (Calc::sin_cos(lean), Calc::sin_cos(to));
    let mut state = at(length, [0.0; 2]);
    let place = [length * sin * ahead, -length * cos, length * sin * aside];
    state.y[4..7].copy_from_slice(&place);
    space.advance(&mut state, &BRAKED, 10.0, 1e-3).expect("moves");
    for (found, wanted) in state.y[4..7].iter().zip(place) {
        assert!((found - wanted).abs() < 1e-11, "{found} {wanted}");
    }
    let found = space.rope_force(&state, &BRAKED, &state.y).expect("closes");
    assert!((found / force - 1.0).abs() < 1e-12);
}

/// v = v_t tanh(g t/v_t) with v_t² = g/κ, of a load that falls freely.
#[test]
fn it_falls_at_most_as_fast_as_the_air_lets_it() {
    let kappa = 0.05;
    let (_, space) = both(wind(0.0, kappa, [0.0; 2]), [0.0; 2]);
    let mut state = at(100.0, [0.0; 2]);
    state.y[4..7].copy_from_slice(&[0.0, -1.0, 0.0]);
    state.taut = false;
    let last = (G / kappa).sqrt();
    for i in 1..=5 {
        space.advance(&mut state, &BRAKED, 1.0, 1e-3).expect("moves");
        let wanted = -last * (G * f64::from(i) / last).tanh();
        assert!(
            !state.taut && (state.y[8] - wanted).abs() < 1e-9,
            "{} {wanted}",
            state.y[8]
        );
    }
}

/// A crane that luffs while it reels in, its load swinging in wind, slack at times: the plane and space agree.
#[test]
fn in_its_plane_it_moves_as_in_space() {
    for (swing, moment) in [(0.3, 1.8e6), (125_f64.to_radians(), 1.5e6)] {
        let (plane, space) = both(wind(0.02, 0.01, [7.0, 0.0]), [1e5, 20e3]);
        let (mut flat, mut state) = (flat(10.0, swing), at(10.0, [swing, 0.0]));
        (flat.y[7], flat.drum) = (0.2, Drum::at(0.2));
        (state.y[11], state.drum) = (0.2, Drum::at(0.2));
        let push = JointDrive { moment, brake: 0.0 };
        let flat_commands = Commands {
            shaft: 0.0,
            drives: [push],
            hoist: HoistCommand::speed(0.2),
        };
        let commands = Commands {
            shaft: 0.0,
            drives: [push, HELD],
            hoist: HoistCommand::speed(0.2),
        };
        let mut slack = 0;
        for _ in 0..400 {
            plane.advance(&mut flat, &flat_commands, 0.01, 5e-4).expect("moves");
            space.advance(&mut state, &commands, 0.01, 5e-4).expect("moves");
            slack += u32::from(!state.taut);
            let (sin, cos) = Calc::sin_cos(flat.y[2]);
            let place = [flat.y[5] * sin, -flat.y[5] * cos];
            let apart = [state.y[0] - flat.y[0], state.y[4] - place[0], state.y[5] - place[1]];
            assert!(apart.iter().all(|e| e.abs() < 1e-8), "{apart:?}");
            assert_eq!(state.taut, flat.taut);
            let [a, b] = [
                plane.rope_force(&flat, &flat_commands, &flat.y).expect("closes"),
                space.rope_force(&state, &commands, &state.y).expect("closes"),
            ];
            assert!((a - b).abs() < 1e-6 * M * G, "{a} {b}");
        }
        assert_eq!(slack > 0, swing > 2.0);
    }
}

/// What bodies and load lose, friction and air take: luffing freely and slewing, no wind, no drive.
#[test]
fn what_is_lost_the_air_has_taken() {
    let (delta, kappa) = (0.05, 0.02);
    let (plane, _) = both(wind(delta, kappa, [0.0; 2]), [0.0; 2]);
    let held = crane::braked(f64::INFINITY);
    let (mut state, h) = (flat(10.0, 1.0), 1e-3);
    let energy = |state: &MotionState| plane.energy(state).expect("closes");
    let (first, mut taken) = (energy(&state), 0.0);
    let power = |y: &[f64; motion::STATES]| {
        let speed = 10.0 * y[3];
        M * (delta + kappa * speed.abs()) * speed * speed
    };
    for _ in 0..5000 {
        // Simpson over two steps.
        let before = power(&state.y);
        plane.advance(&mut state, &held, h, h).expect("moves");
        let middle = power(&state.y);
        plane.advance(&mut state, &held, h, h).expect("moves");
        taken += h / 3.0 * (before + 4.0 * middle + power(&state.y));
    }
    let lost = first - energy(&state);
    assert!(
        lost > 0.1 * M * G && (lost / taken - 1.0).abs() < 1e-8,
        "{lost} {taken}"
    );
}

/// An empty hook moves in the air as the lightest load.
#[test]
fn an_empty_hook_moves_as_the_lightest_load() {
    let air = wind(0.05, 0.02, [5.0, 0.3]);
    let with = |mass: f64| {
        let mut space = crane::slewing(Some(crane::pendulum(mass)), 5e6, [[1e5, 0.0], [1e5, 0.0]]);
        space.dynamics = space.dynamics.in_air(air.0, air.1);
        let mut state = at(10.0, [0.4, 0.2]);
        space.advance(&mut state, &BRAKED, 5.0, 1e-3).expect("moves");
        state.y
    };
    for (empty, light) in with(0.0).iter().zip(with(1e-7)) {
        assert!((empty - light).abs() < 1e-9, "{empty} {light}");
    }
}

//! The boom on a luffing rope in motion, against a Lagrangian written by hand, closed forms and its energy; its tackle, which
//! goes slack and is caught.

#[path = "common/roped.rs"]
mod roped;
#[path = "common/single_boom.rs"]
mod single_boom;

use std::f64::consts::TAU;

use lemnis_models::component::model::Model;
use lemnis_models::kernel::calc::Calc;
use lemnis_models::luffing::moving::crane::Commands;
use lemnis_models::luffing::moving::dynamics::{Coordinate, Dynamics};
use lemnis_models::luffing::moving::motion::{MotionState, MovingLinkage};
use lemnis_models::luffing::moving::pendulum::Phase;
use lemnis_models::parts::hoist::{Hoist, HoistCommand};
use lemnis_models::parts::joint::{Bar, Friction, Joint, JointDrive};
use roped::{LOAD, PARTS, RIG, ROPE, boom, crane, head, hoists};
use single_boom::{
    G, balanced, derivatives_are_those_of_the_values, holds_as_at_rest, moves_by, slopes_are_derivatives, swings_by,
};

const SINGLE: &str = include_str!("../scenes/rope_luffing.toml");
const COMPENSATED: &str = include_str!("../scenes/rope_compensation.toml");
#[test]
fn a_load_below_the_head_moves_as_by_hand() {
    for parts in PARTS {
        let crane = crane(parts, None);
        for i in 1..60 {
            let (phi, omega, drive) = (0.025 * f64::from(i), 0.3 - 0.01 * f64::from(i), 1e6 * f64::from(i % 7));
            let ([_, [dx, da], [ddx, dda]], [_, led, bent]) = head(phi, parts);
            let (dy, ddy) = (da + led, dda + bent);
            let [own, weight] = boom(phi);
            let inertia = own + LOAD * (dx * dx + dy * dy);
            let half_slope = LOAD * (dx * ddx + dy * ddy);
            let moment = weight + LOAD * G * dy;
            moves_by(&crane, [phi, omega, drive], [inertia, half_slope, moment]);
        }
    }
}

/// The load at (x_A + L sin σ, y_A − L cos σ) with L = const − n |A B|: its travel by both coordinates and what of its
/// acceleration is not theirs, worked out by hand.
#[test]
fn a_swinging_load_moves_as_by_hand() {
    for parts in PARTS {
        let crane = crane(parts, Some(Hoist::AT_ONCE));
        for i in 1..60 {
            let k = f64::from(i);
            let (phi, omega, swing, rate, drive) = (0.025 * k, 0.3 - 0.01 * k, 1.5 - 0.06 * k, 0.02 * k - 0.4, 2e5 * k);
            let ([_, [dx, dy], [ddx, ddy]], [_, led, bent]) = head(phi, parts);
            let (sin, cos) = Calc::sin_cos(swing);
            let [inertia, weight] = boom(phi);
            let (by_phi, by_swing) = ([dx - led * sin, dy + led * cos], [ROPE * cos, ROPE * sin]);
            let (turn, mixed, square) = (omega * omega, -2.0 * led * omega * rate, rate * rate);
            let rest = [
                (ddx - bent * sin) * turn + mixed * cos - ROPE * sin * square,
                (ddy + bent * cos) * turn + mixed * sin + ROPE * cos * square + G,
            ];
            let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
            let m = [
                [inertia + LOAD * dot(by_phi, by_phi), LOAD * dot(by_phi, by_swing)],
                [LOAD * dot(by_phi, by_swing), LOAD * ROPE * ROPE],
            ];
            let f = [drive - weight - LOAD * dot(by_phi, rest), -LOAD * dot(by_swing, rest)];
            let at = Phase {
                theta: phi,
                omega,
                swing,
                swing_rate: rate,
            };
            swings_by(&crane, &at, drive, m, f);
        }
    }
}

#[test]
fn slopes_are_those_of_the_plain_numbers() {
    for hoist in [None, Some(Hoist::AT_ONCE)] {
        let angles = (1..60).map(|i| 0.025 * f64::from(i));
        slopes_are_derivatives(&crane(PARTS[1], hoist), angles, [1e7, RIG.l], 8.0);
    }
}

fn moving(dynamics: Dynamics, coulomb: f64, stops: [f64; 2]) -> MovingLinkage {
    let joints = [Joint {
        friction: Friction { viscous: 0.0, coulomb },
        stops,
    }];
    MovingLinkage { dynamics, joints }
}

fn told(moment: f64, brake: f64, speed: f64) -> Commands<1> {
    Commands {
        shaft: 0.0,
        drives: [JointDrive { moment, brake }],
        hoist: HoistCommand::speed(speed),
    }
}

/// The moment of the drive over its way is what the energy gains, the hoist at rest, whichever rope goes slack.
#[test]
fn work_is_energy() {
    for (i, hoist) in hoists().into_iter().enumerate() {
        for parts in PARTS {
            let crane = moving(crane(parts, hoist), 0.0, [-1.5, 1.5]);
            let (mut state, moment) = (MotionState::resting(0.6, ROPE), 5e6);
            (state.y[1], state.y[2], state.y[3]) = (0.02, 0.4, 0.05);
            let commands = told(moment, 0.0, 0.0);
            crane.event(&mut state, &commands).expect("exists");
            let first = crane.energy(&state).expect("exists");
            let (mut way, before) = (0.0, state.blown);
            for _ in 0..200 {
                crane.advance(&mut state, &commands, 0.01, 2.5e-4).expect("exists");
                way += state.y[1].abs() * 0.01;
            }
            let gained = crane.energy(&state).expect("exists") - first + state.blown - before;
            let work = moment * (state.y[0] - 0.6);
            println!("{i}: {work} J over {way} rad, {gained} J, {:?}", state.taut);
            assert!(way > 0.05, "it moves");
            assert!((gained - work).abs() < 1e-9 * LOAD * G * RIG.l, "{i}: {gained} {work}");
        }
    }
}

/// The boom held by its brake, the load swings with T = 2π √(l / g), whatever the hoist rope's lead.
#[test]
fn a_small_swing_of_a_held_boom_has_its_period() {
    let crane = moving(crane(PARTS[1], Some(Hoist::AT_ONCE)), 0.0, [0.0, 1.5]);
    let (mut state, commands) = (MotionState::resting(0.9, ROPE), told(0.0, 1e9, 0.0));
    let small = 1e-5;
    state.y[2] = small;
    crane.event(&mut state, &commands).expect("exists");
    let period = TAU * (ROPE / G).sqrt();
    crane
        .advance(&mut state, &commands, 5.0 * period, 1e-3)
        .expect("exists");
    assert_eq!(state.joints[0], Bar::Held);
    assert!((state.y[2] / small - 1.0).abs() < 1e-8, "{}", state.y[2] / small - 1.0);
    assert!(state.y[3].abs() < 1e-8 * small * TAU / period * 1e4, "{}", state.y[3]);
}

/// Thrown up, with a brake that holds the drum: the boom flies alone and comes back as fast as it went, and the brake brings
/// it to rest over the way on which it takes what is left of the energy.
#[test]
fn a_boom_thrown_up_is_caught_by_its_brake() {
    let (dynamics, brake, start, fast) = (crane(None, None), 6e6, 0.6, 0.1);
    let crane = moving(dynamics, 0.0, [0.0, 1.5]);
    let commands = told(0.0, brake, 0.0);
    let mut state = MotionState::resting(start, ROPE);
    state.y[1] = fast;
    crane.event(&mut state, &commands).expect("exists");
    assert_eq!((state.joints[0], state.slack), (Bar::Forward, Some(start)));
    let thrown = crane.energy(&state).expect("exists");
    let mut highest = start;
    let mut back = None;
    for _ in 0..6000 {
        let before = state;
        crane.advance(&mut state, &commands, 1e-3, 1e-3).expect("exists");
        highest = highest.max(state.y[0]);
        if before.slack.is_some() && state.slack.is_none() {
            back = Some((before, state));
            break;
        }
        let energy = crane.energy(&state).expect("exists");
        assert!((energy - thrown).abs() < 1e-9 * thrown, "it flies alone");
    }
    let (before, caught) = back.expect("it comes back");
    assert!(highest > start + 1e-3);
    assert!(before.y[0] > start && caught.y[0] < start && caught.y[1] < 0.0);
    // As fast as it went, within what the brake took in the rest of a step.
    assert!(
        (before.y[1] + fast).abs() < 2e-3 * fast + 1e-3,
        "{} {}",
        before.y[1],
        caught.y[1]
    );
    assert_eq!(state.joints[0], Bar::Backward);
    crane.advance(&mut state, &commands, 5.0, 1e-3).expect("exists");
    assert_eq!((state.joints[0], state.y[1], state.blown), (Bar::Held, 0.0, 0.0));
    let rest = crane.energy(&state).expect("exists");
    let slipped = brake * (start - state.y[0]);
    assert!(
        (thrown - rest - slipped).abs() < 1e-9 * thrown,
        "{} {slipped}",
        thrown - rest
    );
}

/// Where load and weights pull the boom back, no brake holds it: the tackle is slack, and the stop takes what it fell by.
#[test]
fn a_boom_falls_back_to_its_stop() {
    let (start, stop) = (1.75, 1.9);
    let crane = moving(crane(None, None), 0.0, [0.3, stop]);
    let commands = told(0.0, 1e9, 0.0);
    let mut state = MotionState::resting(start, ROPE);
    crane.event(&mut state, &commands).expect("exists");
    assert_eq!((state.joints[0], state.slack), (Bar::Forward, Some(start)));
    let first = crane.energy(&state).expect("exists");
    crane.advance(&mut state, &commands, 5.0, 1e-3).expect("exists");
    assert_eq!((state.y[0], state.y[1], state.joints[0]), (stop, 0.0, Bar::Held));
    let fallen = first - crane.energy(&state).expect("exists");
    assert!(
        fallen > 1e5 && (state.blown / fallen - 1.0).abs() < 1e-9,
        "{} {fallen}",
        state.blown
    );
    // Its motor pulls it back to nowhere: the rope reels in, and holds no boom that leans on its stop.
    let pulled = told(1e5, 0.0, 0.0);
    crane.event(&mut state, &pulled).expect("exists");
    assert_eq!((state.joints[0], state.slack), (Bar::Held, None));
}

/// A load that flies is caught by a rope that the boom pays out as it rises: with the impulse p on load and boom, both are as
/// fast along the rope after it, so that p = excess / (1 / m + h² / I) and the loss is p · excess / 2.
#[test]
fn a_caught_load_takes_its_blow_from_the_boom() {
    for parts in PARTS {
        let (phi, omega, swing, fast) = (0.8, 0.05, 0.3, 0.9);
        let crane = moving(crane(parts, Some(Hoist::AT_ONCE)), 0.0, [0.0, 1.5]);
        let mut state = MotionState::resting(phi, ROPE);
        state.y = [phi, omega, swing, 0.1, ROPE, ROPE, fast, 0.0];
        (state.taut, state.joints[0]) = (false, Bar::Forward);
        let before = crane.energy(&state).expect("exists");
        crane.event(&mut state, &told(5e6, 0.0, 0.0)).expect("exists");
        let ([_, [dx, dy], _], [_, led, _]) = head(phi, parts);
        let (sin, cos) = Calc::sin_cos(swing);
        let ([inertia, _], arm, excess) = (boom(phi), dx * sin - dy * cos - led, fast + led * omega);
        let impulse = excess / (1.0 / LOAD + arm * arm / inertia);
        let (turned, lost) = (impulse * arm / inertia, 0.5 * impulse * excess);
        assert!(state.taut, "caught");
        assert!(
            (state.y[1] - omega - turned).abs() <= 1e-12 * turned.abs(),
            "{} {turned}",
            state.y[1]
        );
        assert!(
            (state.y[6] + led * state.y[1]).abs() <= 1e-12,
            "as fast as the rope is paid out"
        );
        assert!((state.blown - lost).abs() <= 1e-9 * before, "{} {lost}", state.blown);
    }
}

/// Of a motor against a stronger brake the rope pulls nothing while the boom rises, and what it needs while it is held.
#[test]
fn a_tackle_never_pushes() {
    let crane = moving(crane(None, None), 0.0, [0.0, 1.5]);
    for (moment, brake) in [(0.0, 0.0), (0.0, 1e7), (-1e6, 5e5), (2e6, 3e6), (3e6, 2e6), (-1e6, 1e7)] {
        let commands = told(moment, brake, 0.0);
        for omega in [-0.1, 0.0, 0.1] {
            let mut state = MotionState::resting(0.8, ROPE);
            state.y[1] = omega;
            crane.event(&mut state, &commands).expect("exists");
            let resistance = crane.friction_moment(0, &state, &commands, &state.y).expect("exists");
            let pull = moment + resistance;
            let expected = match state.joints[0] {
                Bar::Forward => (moment - brake).max(0.0),
                Bar::Backward => (moment + brake).max(0.0),
                _ => f64::reduced(&crane.dynamics, 0.8).expect("exists").moment,
            };
            assert!(
                (pull - expected).abs() <= 1e-9 * 1e7,
                "{moment} {brake} {omega}: {pull} {expected}"
            );
            assert!(pull >= -1e-9, "{moment} {brake} {omega}: {pull}");
        }
    }
}

/// With what moves it, at a level with its keys.
fn model(text: &str, (fidelity, rope): (&str, &str)) -> Model {
    let dynamics = format!("J_b = \"900000 kg.m2\"\nM_S = \"100 MN.m\"\n{rope}");
    single_boom::model(text, fidelity, &dynamics)
}

/// What a brake holds at rest is the moment of the drive at rest, and tackle, rope, foot and balance pull as at rest.
#[test]
fn what_holds_it_at_rest_is_the_tackle_at_rest() {
    let size = 19e3 * G * 33.0;
    let mut pairs = vec![(["M_R", "M_D"], size), (["T_dyn", "T"], size / 3.0)];
    let same = [
        "S_h", "F_k", "F_O1.x", "F_O1.y", "N_b", "N_1", "F_K.x", "F_K.y", "F_M.x", "F_M.y",
    ];
    pairs.extend(same.map(|name| ([name; 2], size / 3.0)));
    let balanced = balanced(SINGLE, false);
    for text in [SINGLE, COMPENSATED].into_iter().map(str::to_string).chain(balanced) {
        for level in [("rigid", ""), ("swing", "l_R = \"12 m\"\n")] {
            holds_as_at_rest(&mut model(&text, level), &text, 25..=78, &pairs);
        }
    }
}

/// While it rises under a motor, and while it falls against the brake under a motor that asks for nothing just then.
#[test]
fn derivatives_are_those_of_its_values() {
    let swing = ("swing", "l_R = \"12 m\"\na_h = \"0.5 m/s2\"\n");
    let levels = [(("rigid", ""), 40), (swing, 60)];
    let drives = [[0.05, 3e6], [-0.05, 0.0]];
    for ((level, least), [omega, moment]) in levels.into_iter().flat_map(|level| drives.map(|drive| (level, drive))) {
        let states = [
            ("phi", 0.7),
            ("omega", omega),
            ("M_A", moment),
            ("M_S", 4e5),
            ("phi_R", 0.2),
            ("omega_R", -0.1),
            // The hoist comes up to its speed, far from where it is reached.
            ("v_h", 0.2),
            ("v_R", 0.05),
        ];
        let asked = [
            "der(omega)",
            "T_dyn",
            "M_R",
            "S_R",
            "der(omega_R)",
            "der(l_R)",
            "der(v_Q)",
            "Y_Q",
            "T",
            "S_h",
            "F_k",
            "F_O1.x",
            "F_O1.y",
            "N_b",
            "P_l",
            "F_A.x",
        ];
        derivatives_are_those_of_the_values(model(COMPENSATED, level), &states, &asked, least);
    }
}

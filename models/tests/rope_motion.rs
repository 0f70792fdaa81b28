//! The boom on a luffing rope in motion, against a Lagrangian written by hand, closed forms and its energy; its tackle, which
//! goes slack and is caught.

use std::f64::consts::TAU;
use std::sync::Arc;

use lemnis_models::component::model::Model;
use lemnis_models::kernel::calc::Calc;
use lemnis_models::kernel::variable::Role;
use lemnis_models::luffing::moving::bodies::{Body, Pendulum};
use lemnis_models::luffing::moving::crane::Commands;
use lemnis_models::luffing::moving::dynamics::{Coordinate, Dynamics};
use lemnis_models::luffing::moving::motion::{MotionState, MovingLinkage};
use lemnis_models::luffing::moving::pendulum::Phase;
use lemnis_models::luffing::rope::moving::HeavyBoom;
use lemnis_models::luffing::rope::position::{Compensation, Rig};
use lemnis_models::parts::hoist::{Elastic, Hoist, HoistCommand, Winch};
use lemnis_models::parts::joint::{Bar, Friction, Joint, JointDrive};
use lemnis_models::parts::plane::{Point, length};
use lemnis_models::parts::solver::Gradient;
use lemnis_models::scene::Scene;

const G: f64 = 9.81;
const RIG: Rig<f64> = Rig {
    l: 33.0,
    f_a: 0.4,
    x_8: 2.0,
    e_x: -4.5,
    e_y: 13.0,
    s_k: 30.0,
    chi_k: 0.03,
    m_l: 8.0,
    eta_l: 1.0,
    b_x: -2.0,
    b_y: 12.0,
    m_h: 2.0,
    eta_h: 1.0,
    h_q: 12.0,
};
const BOOM: f64 = 9e3;
const CENTRE: Point<f64> = Point::new(15.0, 0.3);
const OWN: f64 = 9e5;
const LOAD: f64 = 10e3;
const ROPE: f64 = 12.0;

/// One rope to the sheave, or a compensation of three parts.
const PARTS: [Option<Compensation<f64>>; 2] = [None, Some(Compensation { m_k: 3.0, eta_k: 1.0 })];

/// The load on its rope, or straight below the head.
fn crane(parts: Option<Compensation<f64>>, hoist: Option<Hoist>) -> Dynamics {
    let along = Point::new(1.0, 0.0);
    let load = Body::slender(LOAD, 0.0, Point::zeros(), along);
    let boom = HeavyBoom {
        rig: RIG,
        parts,
        boom: Body::slender(BOOM, OWN, CENTRE, along),
        load: hoist.is_none().then_some(load),
        balance: None,
        gravity: G,
    };
    let pendulum = hoist.map(|hoist| Pendulum {
        mass: LOAD,
        length: ROPE,
        hoist,
    });
    Dynamics::new(Arc::new(boom), pendulum, G)
}

/// The boom alone: its inertia about the foot and the moment of its weight.
fn boom(phi: f64) -> [f64; 2] {
    let (sin, cos) = Calc::sin_cos(phi);
    let square = CENTRE.x * CENTRE.x + CENTRE.y * CENTRE.y;
    [OWN + BOOM * square, BOOM * G * (CENTRE.x * cos - CENTRE.y * sin)]
}

/// Head by polar coordinates, with two derivatives; and what the sheave takes: n |A B| by the law of cosines.
fn head(phi: f64, parts: Option<Compensation<f64>>) -> ([[f64; 2]; 3], [f64; 3]) {
    let (radius, ahead) = (length(Point::new(RIG.l, RIG.f_a)), f64::direction(RIG.l, RIG.f_a));
    let (sin, cos) = Calc::sin_cos(phi + ahead);
    let places = [
        [radius * cos, radius * sin],
        [-radius * sin, radius * cos],
        [-radius * cos, -radius * sin],
    ];
    let (far, sheave) = (length(Point::new(RIG.b_x, RIG.b_y)), f64::direction(RIG.b_x, RIG.b_y));
    let (sin, cos) = Calc::sin_cos(phi + ahead - sheave);
    let between = (radius * radius + far * far - 2.0 * radius * far * cos).sqrt();
    let first = radius * far * sin / between;
    let second = (radius * far * cos - first * first) / between;
    let part = parts.map_or(1.0, |parts| parts.m_k) / RIG.m_h;
    (places, [between, first, second].map(|x| part * x))
}

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
            let expected = (drive - moment - half_slope * omega * omega) / inertia;
            let m = Phase {
                theta: phi,
                omega,
                swing: 0.0,
                swing_rate: 0.0,
            };
            let [found, _] = crane.accelerations(&m, drive).expect("exists");
            let size = (drive.abs() + moment.abs() + half_slope.abs() * omega * omega) / inertia;
            assert!((found - expected).abs() <= 1e-12 * size, "{phi}: {found} {expected}");
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
            let determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
            let expected = [
                (f[0] * m[1][1] - m[0][1] * f[1]) / determinant,
                (m[0][0] * f[1] - m[1][0] * f[0]) / determinant,
            ];
            let at = Phase {
                theta: phi,
                omega,
                swing,
                swing_rate: rate,
            };
            let found = crane.accelerations(&at, drive).expect("exists");
            for (found, expected) in found.into_iter().zip(expected) {
                assert!(
                    (found - expected).abs() <= 1e-11 * (1.0 + expected.abs()),
                    "{phi}: {found} {expected}"
                );
            }
        }
    }
}

/// What is asked over dual numbers is the derivative of what is asked over plain ones.
#[test]
fn slopes_are_those_of_the_plain_numbers() {
    for hoist in [None, Some(Hoist::AT_ONCE)] {
        let crane = crane(PARTS[1], hoist);
        for i in 1..60 {
            let phi = 0.025 * f64::from(i);
            let [theta] = Gradient::<1>::states(&[phi]);
            let r = Gradient::reduced(&crane, theta).expect("exists");
            let plain = f64::reduced(&crane, phi).expect("exists");
            assert!(
                (r.inertia.re / plain.inertia - 1.0).abs() <= 8.0 * f64::EPSILON,
                "{phi}"
            );
            assert!((r.inertia.by[0] - plain.slope).abs() <= 1e-13 * plain.inertia, "{phi}");
            assert!((r.energy.by[0] - plain.moment).abs() <= 1e-13 * 1e7, "{phi}");
            if let (Some([lead, _]), Some([_, change])) = (r.lead, plain.lead) {
                assert!((lead.by[0] - change).abs() <= 1e-13 * RIG.l, "{phi}");
            }
        }
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
        drives: [JointDrive { moment, brake }],
        hoist: HoistCommand::speed(speed),
    }
}

/// Every hoist whose speed is commanded, and a load below the head.
fn hoists() -> [Option<Hoist>; 4] {
    let give = Elastic {
        stiffness: 4e6,
        damping: 0.0,
    };
    let ramp = Hoist {
        winch: Winch::Ramp(0.3),
        rope: None,
    };
    let elastic = Hoist {
        rope: Some(give),
        ..Hoist::AT_ONCE
    };
    [None, Some(Hoist::AT_ONCE), Some(ramp), Some(elastic)]
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

const MOTION: &str = "[luffing.dynamics]\nJ_b = \"900000 kg.m2\"\nM_S = \"100 MN.m\"\n";

fn model(text: &str, fidelity: &str, rope: &str) -> Model {
    let text = text
        .replacen(
            "[luffing.motion]",
            &format!("fidelity = \"{fidelity}\"\n\n[luffing.motion]"),
            1,
        )
        .replacen("[luffing.limits]", &format!("{MOTION}{rope}\n[luffing.limits]"), 1);
    Scene::parse(&text)
        .unwrap_or_else(|found| panic!("{found:?}"))
        .model()
        .expect("exists")
}

fn get(model: &mut Model, name: &str) -> f64 {
    let index = model.variables().iter().position(|variable| variable.name() == name);
    model.get(index.unwrap_or_else(|| panic!("no {name}"))).expect("exists")
}

/// What a brake holds at rest is the moment of the drive at rest, and the tackle pulls as at rest.
#[test]
fn what_holds_it_at_rest_is_the_tackle_at_rest() {
    let single = include_str!("../scenes/rope_luffing.toml");
    let tail =
        "[luffing.balance]\nkind = \"tail\"\nG_c = \"20 t\"\nr_c = \"5 m\"\nchi_c = \"3 deg\"\n\n[luffing.limits]";
    let balanced = single.replacen("[luffing.limits]", tail, 1);
    for text in [single, include_str!("../scenes/rope_compensation.toml"), &balanced] {
        for (fidelity, rope) in [("rigid", ""), ("swing", "l_R = \"12 m\"\n")] {
            let mut model = model(text, fidelity, rope);
            for i in 0..=53 {
                let phi = f64::from(25 + i).to_radians();
                let index = model
                    .variables()
                    .iter()
                    .position(|variable| variable.name() == "phi")
                    .expect("there");
                model.set(index, phi).expect("an angle");
                model.update().expect("exists");
                let [held, at_rest, dynamic, pull] = ["M_R", "M_D", "T_dyn", "T"].map(|name| get(&mut model, name));
                let size = 19e3 * G * 33.0;
                assert!(
                    (held - at_rest).abs() <= 1e-12 * size,
                    "{fidelity} {i}: {held} {at_rest}"
                );
                assert!(
                    (dynamic - pull).abs() <= 1e-12 * size / 3.0,
                    "{fidelity} {i}: {dynamic} {pull}"
                );
                assert_eq!(get(&mut model, "der(omega)"), 0.0);
            }
            if fidelity == "swing" {
                assert!((get(&mut model, "S_R") / (10e3 * 9.81) - 1.0).abs() < 1e-3);
            }
        }
    }
}

/// Every derivative that the FMU gives, against differences of fourth order of the values that it gives.
#[test]
fn derivatives_are_those_of_the_values() {
    let roles = [Role::Input, Role::Parameter, Role::Tunable, Role::State];
    for (fidelity, rope, least) in [("rigid", "", 40), ("swing", "l_R = \"12 m\"\na_h = \"0.5 m/s2\"\n", 60)] {
        let text = include_str!("../scenes/rope_compensation.toml");
        let mut model = model(text, fidelity, rope);
        let states = [
            ("phi", 0.7),
            ("omega", 0.05),
            ("M_A", 3e6),
            ("M_S", 4e5),
            ("phi_R", 0.2),
            ("omega_R", -0.1),
            // The hoist comes up to its speed, far from where it is reached.
            ("v_h", 0.2),
            ("v_R", 0.05),
        ];
        for (name, value) in states {
            if let Some(index) = model.variables().iter().position(|variable| variable.name() == name) {
                model.set(index, value).expect("allowed");
            }
        }
        model.start().expect("exists");
        let names: Vec<(String, Role)> = model
            .variables()
            .iter()
            .map(|v| (v.name().to_string(), v.role))
            .collect();
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
        ];
        let asked: Vec<usize> = (0..names.len())
            .filter(|&i| asked.contains(&names[i].0.as_str()))
            .collect();
        assert!(asked.len() >= 5);
        let mut compared = 0;
        for known in (0..names.len()).filter(|&i| roles.contains(&names[i].1)) {
            let variable = model.variables()[known];
            let x = model.get(known).expect("exists");
            let h = 1e-4 * x.abs().max(1e-2);
            let at = |value: f64| -> Option<Vec<f64>> {
                let mut moved = model.clone();
                moved.set(known, value).ok()?;
                moved.update().ok()?;
                asked.iter().map(|&i| moved.get(i).ok()).collect()
            };
            let Some([a, b, c, d]) = [-2.0, -1.0, 1.0, 2.0]
                .map(|part| at(x + part * h))
                .into_iter()
                .collect::<Option<Vec<_>>>()
                .and_then(|rows| <[Vec<f64>; 4]>::try_from(rows).ok())
            else {
                continue;
            };
            let seed = |(symbol, number)| f64::from((symbol, number) == variable.quantity());
            let mut tangent = model.tangent(&seed);
            for (place, &index) in asked.iter().enumerate() {
                let Ok(found) = model.derivative(&mut tangent, index) else {
                    continue;
                };
                let by_values = (a[place] - d[place] + 8.0 * (c[place] - b[place])) / (12.0 * h);
                let size = found.abs() + b[place].abs() / x.abs().max(1e-2);
                assert!(
                    (found - by_values).abs() <= 1e-8 * size,
                    "{fidelity}: {} by {}: {found} {by_values}",
                    names[index].0,
                    names[known].0
                );
                compared += usize::from(found != 0.0);
            }
        }
        assert!(compared > least, "{fidelity}: {compared}");
    }
}

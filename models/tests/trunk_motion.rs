//! The boom with a curved trunk in motion: against a pose with two derivatives written by hand, the closure's series, its
//! energy, the same crane at rest; a tie that goes slack.

#[path = "common/counting.rs"]
mod counting;
#[path = "common/single_boom.rs"]
mod single_boom;

use std::sync::Arc;

use lemnis_models::kernel::calc::Calc;
use lemnis_models::luffing::curved_trunk::contact::{Contact, direction};
use lemnis_models::luffing::curved_trunk::moving::{TrunkInertias, TrunkParts, Trunked};
use lemnis_models::luffing::curved_trunk::position::TrunkPosition;
use lemnis_models::luffing::curved_trunk::statics::TrunkWeights;
use lemnis_models::luffing::curved_trunk::tail::{TailArc, Trunk, TrunkChoice, TrunkTail};
use lemnis_models::luffing::curved_trunk::velocity::{TrunkBend, TrunkTravel};
use lemnis_models::luffing::moving::dynamics::Dynamics;
use lemnis_models::luffing::moving::pendulum::Phase;
use lemnis_models::parts::four_bar::Branch;
use lemnis_models::parts::hoist::Hoist;
use lemnis_models::parts::motion::Motion;
use lemnis_models::parts::plane::Point;
use lemnis_models::parts::smooth_curve::SmoothCurve;
use num_dual::Dual2;
use single_boom::{
    G, balanced, derivatives_are_those_of_the_values, get, holds_as_at_rest, index, model, moves_by,
    slopes_are_derivatives, swings_by,
};

const SCENE: &str = include_str!("../scenes/curved_trunk.toml");
const ORACLE: &str = include_str!("../../tests/oracles/trunk_motion.csv");
const TRUNK: Trunk<f64> = Trunk {
    b: 20.0,
    a: 12.0,
    l_t: 20.0,
    o3_x: -6.0,
    o3_y: 12.0,
    x_8: 2.0,
};
/// About the head of the boom.
const ARC: TailArc<f64> = TailArc {
    z_x: 0.0,
    z_y: 0.0,
    rho: 4.0,
    zeta_f: 2.1,
    zeta_r: 4.2,
};
const WEIGHTS: TrunkWeights<f64> = TrunkWeights {
    g_b: 60e3,
    r_b: 8.0,
    chi_b: 0.05,
    g_t: 40e3,
    r_t: 2.0,
    chi_t: 0.1,
};
const INERTIAS: TrunkInertias<f64> = TrunkInertias { j_b: 2.5e5, j_t: 9e4 };
const LOAD: f64 = 10e3;
const ROPE: f64 = 12.0;

fn choice(curve: Option<SmoothCurve>, from_rear: bool) -> TrunkChoice {
    TrunkChoice {
        range: Motion {
            from: 0.0,
            to: 2.0,
            step: 0.1,
            speed: 1.0,
            by_part: false,
            period: std::f64::consts::TAU,
        },
        from_rear,
        curve: curve.map(Arc::new),
        crank: Branch::Left,
    }
}

/// An ellipse's upper side as so many points, from the front to the rear.
fn ellipse(count: u32) -> SmoothCurve {
    let points = (0..=count).map(|i| {
        let (sin, cos) = Calc::sin_cos(2.2 + 1.8 * f64::from(i) / f64::from(count));
        Point::new(-1.0 + 5.0 * cos, 4.4 * sin)
    });
    SmoothCurve::new(&points.collect::<Vec<_>>()).expect("a tail")
}

/// Three tails, each with its choice: the arc about the head, one with its centre elsewhere, a curve through points.
fn tails() -> Vec<(TrunkTail<f64>, TrunkChoice)> {
    let aside = TailArc {
        z_x: -1.1,
        z_y: 0.3,
        ..ARC
    };
    let forms = [
        (Some(ARC), choice(None, false)),
        (Some(aside), choice(None, false)),
        (None, choice(Some(ellipse(9)), false)),
    ];
    let made = forms.map(|(arc, choice)| (TrunkTail::new(&TRUNK, &arc, &choice).expect("a tail"), choice));
    made.into()
}

/// Angles that all of them reach.
fn angles() -> impl Iterator<Item = f64> {
    (0..=40).map(|i| 0.88 + 0.008 * f64::from(i))
}

fn crane(tail: &TrunkTail<f64>, choice: &TrunkChoice, hangs: bool) -> Dynamics {
    let own = TrunkParts::new(tail, &WEIGHTS, &INERTIAS, choice, None, &None);
    single_boom::crane::<Trunked>(&own, [LOAD, ROPE], hangs.then_some(Hoist::AT_ONCE))
}

/// On the arc about B the tie leaves the tail at right angles to its radius: f = √(d² − ρ²), ζ = ζ_f + (L_t − f) / ρ, and the
/// trunk turns by the angle of d less ζ less atan(f / ρ). That, once and twice differentiated.
fn pose(phi: f64) -> [f64; 3] {
    let Trunk { b, l_t, o3_x, o3_y, .. } = TRUNK;
    let rho = ARC.rho;
    let (sin, cos) = Calc::sin_cos(phi);
    let (d, d_1) = ([o3_x - b * cos, o3_y - b * sin], [b * sin, -b * cos]);
    let d_2 = [b * cos, b * sin];
    let dot = |u: [f64; 2], v: [f64; 2]| u[0] * v[0] + u[1] * v[1];
    let cross = |u: [f64; 2], v: [f64; 2]| u[0] * v[1] - u[1] * v[0];
    let (s, s_1, s_2) = (dot(d, d), 2.0 * dot(d, d_1), 2.0 * (dot(d_1, d_1) + dot(d, d_2)));
    let f = (s - rho * rho).sqrt();
    let f_1 = s_1 / (2.0 * f);
    let f_2 = (0.5 * s_2 - f_1 * f_1) / f;
    let zeta = ARC.zeta_f + (l_t - f) / rho;
    let (of_d, of_d_1) = (f64::direction(d[0], d[1]), cross(d, d_1) / s);
    let of_d_2 = cross(d, d_2) / s - of_d_1 * s_1 / s;
    let (tilt_1, tilt_2) = (f_1 * rho / s, f_2 * rho / s - f_1 * rho * s_1 / (s * s));
    [
        of_d - zeta - f64::direction(rho, f),
        of_d_1 + f_1 / rho - tilt_1,
        of_d_2 + f_2 / rho - tilt_2,
    ]
}

/// A point of the trunk at a distance (m) and an angle (rad) from its line: travel, and how that changes.
fn travel(phi: f64, [long, angle]: [f64; 2]) -> [[f64; 2]; 2] {
    let [alpha, turn, change] = pose(phi);
    let ((sin, cos), (s, c)) = (Calc::sin_cos(phi), Calc::sin_cos(alpha + angle));
    let b = TRUNK.b;
    let once = [-b * sin - turn * long * s, b * cos + turn * long * c];
    let twice = [
        -b * cos - change * long * s - turn * turn * long * c,
        -b * sin + change * long * c - turn * turn * long * s,
    ];
    [once, twice]
}

/// Inertia, half of its change, and the moment of the weights, with a mass at the head.
fn by_hand(phi: f64, load: f64) -> [f64; 3] {
    let (w, [_, turn, change]) = (WEIGHTS, pose(phi));
    let boom = Calc::sin_cos(phi + w.chi_b).1;
    let mut sums = [
        w.g_b / G * w.r_b * w.r_b + INERTIAS.j_b + INERTIAS.j_t * turn * turn,
        INERTIAS.j_t * turn * change,
        w.g_b * w.r_b * boom,
    ];
    for (mass, at) in [(w.g_t / G, [w.r_t, w.chi_t]), (load, [TRUNK.a, 0.0])] {
        let [once, twice] = travel(phi, at);
        sums[0] += mass * (once[0] * once[0] + once[1] * once[1]);
        sums[1] += mass * (once[0] * twice[0] + once[1] * twice[1]);
        sums[2] += mass * G * once[1];
    }
    sums
}

#[test]
fn a_fixed_load_moves_as_by_hand() {
    let (tail, choice) = &tails()[0];
    let crane = crane(tail, choice, false);
    for (phi, i) in angles().zip(0..) {
        let (omega, drive) = (0.3 - 0.01 * f64::from(i), 1e5 * f64::from(i % 7));
        moves_by(&crane, [phi, omega, drive], by_hand(phi, LOAD));
    }
}

/// M q″ = f of boom and rope, with the coupling worked out by hand.
#[test]
fn a_swinging_load_moves_as_by_hand() {
    let (tail, choice) = &tails()[0];
    let crane = crane(tail, choice, true);
    for (theta, k) in angles().zip(0..) {
        let k = f64::from(k);
        let (omega, swing, swing_rate, drive) = (0.3 - 0.01 * k, 1.5 - 0.06 * k, 0.02 * k - 0.4, 2e4 * k);
        let [inertia, half_slope, moment] = by_hand(theta, 0.0);
        let [[dx, dy], [ddx, ddy]] = travel(theta, [TRUNK.a, 0.0]);
        let (s, c) = Calc::sin_cos(swing);
        // Along the circle of the load, and outwards.
        let (along, out) = ([c, s], [s, -c]);
        let coupled = LOAD * ROPE * (dx * along[0] + dy * along[1]);
        let m = [
            [inertia + LOAD * (dx * dx + dy * dy), coupled],
            [coupled, LOAD * ROPE * ROPE],
        ];
        let square = omega * omega;
        let pull = ROPE * swing_rate * swing_rate * (dx * out[0] + dy * out[1]);
        let f = [
            drive - moment - half_slope * square - LOAD * ((dx * ddx + dy * ddy) * square - pull + G * dy),
            -LOAD * ROPE * ((ddx * along[0] + ddy * along[1]) * square + G * s),
        ];
        let at = Phase {
            theta,
            omega,
            swing,
            swing_rate,
        };
        swings_by(&crane, &at, drive, m, f);
    }
}

/// The trunk's turn and its change over the point of contact are those of its direction as a series over the boom's angle.
#[test]
fn the_loop_twice_differentiated_is_the_closure_s_series() {
    for (tail, choice) in tails() {
        for phi in angles() {
            let contact = Contact::new(&tail, &choice, &phi).expect("closes");
            let position = TrunkPosition::new(&tail, &contact);
            let travel = TrunkTravel::new(&position);
            let bend = TrunkBend::new(&contact, &position, &travel);
            let lifted = tail.map(Dual2::from_re);
            let along = direction(&lifted, &choice, Dual2::new(phi, 1.0, 0.0)).expect("closes");
            let (x, y) = (along.x, along.y);
            let turn = x.re * y.v1 - y.re * x.v1;
            let change = x.re * y.v2 - y.re * x.v2;
            assert!((travel.i_2 - turn).abs() < 1e-13 * turn.abs(), "{phi}: {turn}");
            assert!(
                (bend.i_2 - change).abs() < 1e-12 * (change.abs() + turn * turn),
                "{phi}: {change}"
            );
        }
    }
}

/// At rest a fixed load and a brake-free boom swing about where the weights are even: ω² = U″ / I, the energy's curvature by
/// differences of heights written by hand.
#[test]
fn a_small_swing_has_its_period() {
    let (tail, choice) = &tails()[0];
    let crane = crane(tail, choice, false);
    // The moment of a drive that holds it there, steady.
    let phi = 1.02;
    let [inertia, _, held] = by_hand(phi, LOAD);
    let stiffness = (by_hand(phi + 1e-5, LOAD)[2] - by_hand(phi - 1e-5, LOAD)[2]) / 2e-5;
    assert!(stiffness > 0.0, "it comes back: {stiffness}");
    let period = std::f64::consts::TAU * (inertia / stiffness).sqrt();
    for small in [1e-4, 1e-5] {
        let mut m = Phase {
            theta: phi + small,
            omega: 0.0,
            swing: 0.0,
            swing_rate: 0.0,
        };
        for _ in 0..8000 {
            m = crane.step(&m, held, 3.0 * period / 8000.0).expect("exists");
        }
        let part = (m.theta - phi) / small;
        assert!((part - 1.0).abs() < 20.0 * small, "{small}: {part}");
    }
}

#[test]
fn work_is_energy() {
    for (tail, choice) in tails() {
        for hangs in [false, true] {
            let crane = crane(&tail, &choice, hangs);
            let mut m = Phase {
                theta: 0.95,
                omega: 0.02,
                swing: 0.3,
                swing_rate: 0.0,
            };
            let moment = by_hand(m.theta, LOAD)[2];
            let (first, from) = (crane.energy(&m).expect("exists"), m.theta);
            let mut way = 0.0;
            for _ in 0..4000 {
                m = crane.step(&m, moment, 2e-4).expect("exists");
                way += m.omega.abs() * 2e-4;
            }
            let gained = crane.energy(&m).expect("exists") - first;
            let work = moment * (m.theta - from);
            println!("{hangs}: {work} J over {way} rad, {gained} J");
            assert!(way > 0.01, "it moves: {way}");
            assert!((gained - work).abs() < 1e-9 * LOAD * G * ROPE, "{gained} {work}");
        }
    }
}

#[test]
fn slopes_are_those_of_the_plain_numbers() {
    for (tail, choice) in tails() {
        slopes_are_derivatives(&crane(&tail, &choice, false), angles(), [1e6, TRUNK.a], 16.0);
    }
}

const MOTION: &str = "J_b = \"500000 kg.m2\"\nJ_t = \"180000 kg.m2\"\n";
const LEVELS: [(&str, &str); 2] = [("rigid", ""), ("swing", "l_R = \"15 m\"\n")];

/// With the rest of its tail as points, and with a drive of each kind.
fn ready() -> Vec<String> {
    let drives = [
        "kind = \"rack\"\nE_x = \"-3 m\"\nE_y = \"4 m\"\ns_d = \"9 m\"\nchi_d = \"10 deg\"\n",
        "kind = \"cylinder\"\nE_x = \"3 m\"\nE_y = \"-1 m\"\ns_d = \"6 m\"\nchi_d = \"-5 deg\"\nD_c = \"200 mm\"\nd_r = \"140 mm\"\n",
    ];
    let driven = drives.map(|drive| {
        SCENE.replacen(
            "[luffing.balance]",
            &format!("[luffing.drive]\n{drive}\n[luffing.balance]"),
            1,
        )
    });
    let narrow = |text: String| text.replacen("to    = \"80 deg\"", "to    = \"72 deg\"", 1);
    [SCENE.to_owned()]
        .into_iter()
        .chain(driven)
        .chain(balanced(SCENE, false))
        .map(narrow)
        .collect()
}

/// What a brake holds at rest is the moment that the drive must give at rest, balance and all, and so are the forces of tie,
/// tail, boom, frame, drive and balance.
#[test]
fn what_holds_it_at_rest_is_the_moment_of_the_drive_at_rest() {
    let (moment, force) = (40e3 * G * 5.8, 5e5);
    let mut pairs = vec![
        (["M_R", "M_D"], moment),
        (["M_D", "M_D"], moment),
        (["p_t", "p_t"], 2e6),
    ];
    let forces = [
        "N_t", "q_t", "F_B.x", "F_B.y", "F_O1.x", "F_O1.y", "F_d", "N_1", "F_K.x", "F_K.y", "F_M.x", "F_M.y",
    ];
    pairs.extend(forces.map(|name| ([name; 2], force)));
    for text in ready() {
        for (fidelity, rope) in LEVELS {
            let mut model = model(&text, fidelity, &format!("{MOTION}M_S = \"100 MN.m\"\n{rope}"));
            holds_as_at_rest(&mut model, &text, 42..=72, &pairs);
        }
    }
}

#[test]
fn derivatives_are_those_of_its_values() {
    for (fidelity, rope) in [LEVELS[0], ("swing", "l_R = \"15 m\"\na_h = \"0.5 m/s2\"\n")] {
        let model = model(SCENE, fidelity, &format!("{MOTION}{rope}"));
        let states = [
            ("phi", 1.0),
            ("omega", 0.05),
            ("M_A", 3e5),
            ("M_S", 4e4),
            ("phi_R", 0.1),
            ("omega_R", -0.1),
            ("v_h", 0.2),
            ("v_R", 0.05),
        ];
        let asked = "der(omega) M_R S_R der(omega_R) A.x M_D N_t q_t F_B.x F_B.y F_O1.x F_O1.y F_A.x P_D z.tie";
        let asked: Vec<&str> = asked.split_whitespace().collect();
        derivatives_are_those_of_the_values(model, &states, &asked, 60);
    }
}

/// The force in the tie is a straight line over the drive's moment: where it is zero the motion ends, with a message that says
/// where and by how much; a moment that lets the tie pull is taken again.
#[test]
fn a_tie_that_would_have_to_push_ends_the_motion() {
    for (fidelity, rope) in LEVELS {
        let mut model = model(SCENE, fidelity, &format!("{MOTION}{rope}"));
        let drive = index(&model, "M_A").expect("there");
        let mut pull = |moment: f64| {
            model.set(drive, moment).expect("a moment");
            model.event().ok();
            get(&mut model, "N_t")
        };
        // Upward, as the lower stop is beneath it.
        let (one, two) = (pull(2e6), pull(4e6));
        assert!(one > two && two > 0.0, "{one} {two}");
        let zero = 2e6 * (1.0 + one / (one - two));
        for (part, taut) in [(1.001, false), (0.999, true), (1.001, false)] {
            model.set(drive, part * zero).expect("a moment");
            let ended = model.update();
            let (n_t, z) = (get(&mut model, "N_t"), get(&mut model, "z.tie"));
            assert_eq!(n_t, z);
            assert_eq!(n_t >= 0.0, taut, "{n_t}");
            match ended {
                Ok(()) => assert!(taut, "{fidelity}"),
                Err(fault) => {
                    assert!(!taut, "{}", fault.message);
                    for words in ["phi = 42", "the tie is slack", "would have to push with", "more gently"] {
                        assert!(fault.message.contains(words), "{}", fault.message);
                    }
                }
            }
        }
    }
}

/// A run allocates nothing, neither on an arc nor on a curve through points.
#[test]
fn nothing_is_allocated() {
    let mut model = model(SCENE, "swing", &format!("{MOTION}M_A = \"250 kN.m\"\nl_R = \"15 m\"\n"));
    model.start().expect("exists");
    let names = ["N_t", "q_t", "F_O1.x", "der(omega)"].map(|name| index(&model, name).expect("there"));
    let mut run = |from: f64| {
        for step in 0..10 {
            let time = from + 0.01 * f64::from(step);
            model.advance(time, time + 0.01).expect("moves");
            for name in names {
                model.get(name).expect("exists");
            }
        }
    };
    run(0.0);
    let before = counting::count();
    run(0.1);
    assert_eq!(counting::count(), before);
}

/// A case of the reference, its level, states and inputs.
type ReferenceCase = (&'static str, &'static str, &'static [(&'static str, f64)]);

const CASES: [ReferenceCase; 3] = [
    ("rigid/forward", "rigid", &[("phi", 1.0), ("omega", 0.15), ("M_A", 3e5)]),
    (
        "rigid/backward",
        "rigid",
        &[("phi", 1.35), ("omega", -0.2), ("M_A", -1e5)],
    ),
    (
        "swing/taut",
        "swing",
        &[
            ("phi", 0.8),
            ("omega", 0.12),
            ("M_A", 3e5),
            ("phi_R", 0.3),
            ("omega_R", 0.2),
        ],
    ),
];

/// Values and derivatives by every state, input and parameter, against those of 50 digits.
#[test]
fn rates_and_forces_have_the_derivatives_of_fifty_digits() {
    let motion = format!("{MOTION}c_v = \"200 kN.m.s\"\nM_F = \"5 kN.m\"\n");
    for (case, level, states) in CASES {
        let rope = if level == "swing" { "l_R = \"15 m\"\n" } else { "" };
        let mut model = model(SCENE, level, &format!("{motion}{rope}"));
        for (name, value) in states {
            let at = index(&model, name).expect("there");
            model.set(at, *value).expect("allowed");
        }
        model.event().expect("exists");
        let rows: Vec<Vec<&str>> = ORACLE.lines().map(|line| line.split(',').collect()).collect();
        let rows: Vec<_> = rows.iter().filter(|row| row[0] == case).collect();
        assert!(rows.len() > 180, "{}", rows.len());
        let number = |text: &str| text.parse::<f64>().expect("a number");
        for row in &rows {
            let (unknown, known) = (index(&model, row[1]).expect("there"), index(&model, row[2]));
            let known = known.unwrap_or_else(|| panic!("no {}", row[2]));
            let (value, slope) = (number(row[3]), number(row[4]));
            let found = model.get(unknown).expect("exists");
            assert!(
                (found - value).abs() <= 1e-12 * size(row[1]),
                "{case} {}: {found} {value}",
                row[1]
            );
            let of = model.variables()[known].quantity();
            let mut tangent = model.tangent(&|quantity| f64::from(quantity == of));
            let derivative = model.derivative(&mut tangent, unknown).expect("there is one");
            let per = size(row[1]) / model.get(known).expect("exists").abs().max(0.01);
            assert!(
                (derivative - slope).abs() <= 1e-12 * (slope.abs() + per),
                "{case} {} by {}: {derivative} {slope}",
                row[1],
                row[2]
            );
        }
    }
}

/// How great such a result is, in SI.
fn size(name: &str) -> f64 {
    match name {
        "der(omega)" | "der(omega_R)" => 1.0,
        "q_t" => 1e5,
        _ => 1e6,
    }
}

//! The boom on guide and link in motion, against a Lagrangian written by hand, closed forms and its energy.

#[path = "common/single_boom.rs"]
mod single_boom;

use lemnis_models::kernel::calc::Calc;
use lemnis_models::luffing::ellipsograph::moving::{Guided, GuidedInertias, GuidedParts};
use lemnis_models::luffing::ellipsograph::position::{Bars, GuidedChoice};
use lemnis_models::luffing::ellipsograph::statics::GuidedWeights;
use lemnis_models::luffing::moving::dynamics::Dynamics;
use lemnis_models::luffing::moving::pendulum::Phase;
use lemnis_models::parts::four_bar::Branch;
use lemnis_models::parts::hoist::Hoist;
use lemnis_models::parts::motion::Motion;
use lemnis_models::scene::Scene;
use single_boom::{
    G, balanced, derivatives_are_those_of_the_values, holds_as_at_rest, model, moves_by, slopes_are_derivatives,
    swings_by,
};

const SCENE: &str = include_str!("../scenes/ellipsograph.toml");
const BARS: Bars<f64> = Bars {
    c: 10.0,
    a: 13.0,
    x_8: 2.0,
};
const WEIGHTS: GuidedWeights<f64> = GuidedWeights {
    g_b: 60e3,
    r_b: 8.0,
    chi_b: 0.05,
    g_l: 20e3,
    r_l: 4.5,
};
const INERTIAS: GuidedInertias<f64> = GuidedInertias { j_b: 2.5e5, j_l: 3e4 };
const LOAD: f64 = 10e3;
const ROPE: f64 = 12.0;

fn choice() -> GuidedChoice {
    let scene = Scene::parse(SCENE).expect("sound");
    let range: Motion = *scene.mechanism.motion();
    GuidedChoice {
        range,
        crank: Branch::Left,
    }
}

/// The load on its rope, or fixed to the head.
fn crane(bars: &Bars<f64>, weights: &GuidedWeights<f64>, hangs: bool) -> Dynamics {
    let own = GuidedParts::new(bars, weights, &INERTIAS, &choice(), &None);
    single_boom::crane::<Guided>(&own, [LOAD, ROPE], hangs.then_some(Hoist::AT_ONCE))
}

/// Inertia, its change, and the moment of the weights: T = ½ I ω² with the trigonometry worked out by hand,
/// |v_S|² = r² + 4 c² cos² φ − 4 c r cos φ cos(φ + χ), |v_A|² = (c + a)² sin² φ + (a − c)² cos² φ.
fn by_hand(phi: f64, load: f64) -> [f64; 3] {
    let (Bars { c, a, .. }, w) = (BARS, WEIGHTS);
    let (m_b, m_l, r, chi) = (w.g_b / G, w.g_l / G, w.r_b, w.chi_b);
    let (sin, cos) = Calc::sin_cos(phi);
    let ((_, cos_s), (sin_2, _)) = (Calc::sin_cos(phi + chi), Calc::sin_cos(2.0 * phi));
    let (sin_2s, _) = Calc::sin_cos(2.0 * phi + chi);
    let (long, short) = (c + a, a - c);
    let inertia = m_b * (r * r + 4.0 * c * c * cos * cos - 4.0 * c * r * cos * cos_s)
        + INERTIAS.j_b
        + m_l * w.r_l * w.r_l
        + INERTIAS.j_l
        + load * (long * long * sin * sin + short * short * cos * cos);
    let slope = m_b * (-4.0 * c * c * sin_2 + 4.0 * c * r * sin_2s) + load * (long * long - short * short) * sin_2;
    let moment = G * (m_b * (r * cos_s - 2.0 * c * cos) - m_l * w.r_l * cos + load * short * cos);
    [inertia, slope, moment]
}

#[test]
fn a_fixed_load_moves_as_by_hand() {
    let crane = crane(&BARS, &WEIGHTS, false);
    for i in 1..60 {
        let (phi, omega, drive) = (0.05 * f64::from(i), 0.3 - 0.01 * f64::from(i), 1e5 * f64::from(i % 7));
        let [inertia, slope, moment] = by_hand(phi, LOAD);
        moves_by(&crane, [phi, omega, drive], [inertia, 0.5 * slope, moment]);
    }
}

/// M q″ = f of boom and rope, with the coupling m l (x′_A cos σ + y′_A sin σ) worked out by hand.
#[test]
fn a_swinging_load_moves_as_by_hand() {
    let crane = crane(&BARS, &WEIGHTS, true);
    let (long, short) = (BARS.c + BARS.a, BARS.a - BARS.c);
    for i in 1..60 {
        let k = f64::from(i);
        let (phi, omega, swing, rate, drive) = (0.05 * k, 0.3 - 0.01 * k, 1.5 - 0.06 * k, 0.02 * k - 0.4, 2e4 * k);
        let [inertia, slope, moment] = by_hand(phi, 0.0);
        let ((sin, cos), (s, c)) = (Calc::sin_cos(phi), Calc::sin_cos(swing));
        let (dx, dy, ddx, ddy) = (-long * sin, short * cos, -long * cos, -short * sin);
        // Along the circle of the load, and outwards.
        let (along, out) = ([c, s], [s, -c]);
        let coupled = LOAD * ROPE * (dx * along[0] + dy * along[1]);
        let m = [
            [inertia + LOAD * (dx * dx + dy * dy), coupled],
            [coupled, LOAD * ROPE * ROPE],
        ];
        let square = omega * omega;
        let f = [
            drive
                - moment
                - 0.5 * slope * square
                - LOAD * ((dx * ddx + dy * ddy) * square - ROPE * rate * rate * (dx * out[0] + dy * out[1]) + G * dy),
            -LOAD * ROPE * ((ddx * along[0] + ddy * along[1]) * square + G * s),
        ];
        let at = Phase {
            theta: phi,
            omega,
            swing,
            swing_rate: rate,
        };
        swings_by(&crane, &at, drive, m, f);
    }
}

/// A head that moves level, on a boom that weighs nothing: its inertia there is a mass J / (x′_A)², and boom and load swing
/// against each other with ω² = g / l · (1 + m_Q (x′_A)² / J).
#[test]
fn a_small_swing_has_its_period() {
    let bars = Bars { a: 10.0, ..BARS };
    let nothing = GuidedWeights {
        g_b: 0.0,
        g_l: 0.0,
        ..WEIGHTS
    };
    let crane = crane(&bars, &nothing, true);
    let travel = 20.0 * Calc::sin_cos(1.0_f64).0;
    let inertia = INERTIAS.j_b + INERTIAS.j_l;
    let square = G / ROPE * (1.0 + LOAD * travel * travel / inertia);
    let period = std::f64::consts::TAU / square.sqrt();
    for small in [1e-4, 1e-5] {
        let mut m = Phase {
            theta: 1.0,
            omega: 0.0,
            swing: small,
            swing_rate: 0.0,
        };
        for _ in 0..8000 {
            m = crane.step(&m, 0.0, 5.0 * period / 8000.0).expect("exists");
        }
        assert!((m.swing / small - 1.0).abs() < 20.0 * small, "{small}: {}", m.swing);
        // At its end it rests: the rate passes zero within a part of the period that goes with the amplitude.
        assert!(
            m.swing_rate.abs() < 20.0 * small * small * square.sqrt(),
            "{small}: {}",
            m.swing_rate
        );
    }
}

#[test]
fn work_is_energy() {
    for hangs in [false, true] {
        let crane = crane(&BARS, &WEIGHTS, hangs);
        let mut m = Phase {
            theta: 0.9,
            omega: 0.1,
            swing: 2.0,
            swing_rate: 0.0,
        };
        let (first, from, moment) = (crane.energy(&m).expect("exists"), m.theta, -5e5);
        let mut way = 0.0;
        for _ in 0..20_000 {
            m = crane.step(&m, moment, 2.5e-4).expect("exists");
            way += m.omega.abs() * 2.5e-4;
        }
        let gained = crane.energy(&m).expect("exists") - first;
        let work = moment * (m.theta - from);
        println!("{hangs}: {work} J over {way} rad, {gained} J");
        assert!(way > 0.1, "it moves");
        assert!((gained - work).abs() < 1e-9 * LOAD * G * ROPE, "{gained} {work}");
    }
}

const MOTION: &str = "J_b = \"900000 kg.m2\"\nJ_l = \"100000 kg.m2\"\n";
const LEVELS: [(&str, &str); 2] = [("rigid", ""), ("swing", "l_R = \"15 m\"\n")];

/// What a brake holds at rest is the moment that the drive must give at rest, balance and all, and so are the forces of guide,
/// link, frame, drive and balance.
#[test]
fn what_holds_it_at_rest_is_the_moment_of_the_drive_at_rest() {
    let size = 46e3 * G * 5.0;
    let mut pairs = vec![(["M_R", "M_D"], size), (["M_D", "M_D"], size)];
    let forces = [
        "F_B.x", "F_C.x", "F_C.y", "N_l", "F_O1.x", "F_O1.y", "F_d", "N_1", "F_K.x", "F_K.y", "F_M.x", "F_M.y",
    ];
    pairs.extend(forces.map(|name| ([name; 2], size)));
    let rack = "[luffing.drive]\nkind = \"rack\"\nE_x = \"-3 m\"\nE_y = \"2 m\"\ns_d = \"6 m\"\nchi_d = \"10 deg\"\n\n";
    let driven = SCENE.replacen("[luffing.balance]", &format!("{rack}[luffing.balance]"), 1);
    for text in [SCENE.to_string(), driven].into_iter().chain(balanced(SCENE, true)) {
        for (fidelity, rope) in LEVELS {
            let mut model = model(&text, fidelity, &format!("{MOTION}M_S = \"100 MN.m\"\n{rope}"));
            holds_as_at_rest(&mut model, &text, 25..=72, &pairs);
        }
    }
}

#[test]
fn slopes_are_those_of_the_plain_numbers() {
    let angles = (1..60).map(|i| 0.05 * f64::from(i));
    slopes_are_derivatives(&crane(&BARS, &WEIGHTS, false), angles, [1e6, BARS.a], 0.0);
}

#[test]
fn derivatives_are_those_of_its_values() {
    for (fidelity, rope) in [LEVELS[0], ("swing", "l_R = \"15 m\"\na_h = \"0.5 m/s2\"\n")] {
        let model = model(SCENE, fidelity, &format!("{MOTION}{rope}"));
        let states = [
            ("phi", 0.7),
            ("omega", 0.05),
            ("M_A", 3e5),
            ("M_S", 4e4),
            ("phi_R", 0.2),
            ("omega_R", -0.1),
            // The hoist comes up to its speed, far from where it is reached.
            ("v_h", 0.2),
            ("v_R", 0.05),
        ];
        let asked = [
            "der(omega)",
            "M_R",
            "S_R",
            "der(omega_R)",
            "A.x",
            "M_D",
            "F_B.x",
            "F_C.y",
            "N_l",
            "F_O1.x",
            "F_O1.y",
            "F_A.x",
            "P_D",
        ];
        derivatives_are_those_of_the_values(model, &states, &asked, 30);
    }
}

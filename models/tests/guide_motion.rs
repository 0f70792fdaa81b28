//! The boom on guide and link in motion, against a Lagrangian written by hand, closed forms and its energy.

use std::sync::Arc;

use lemnis_models::component::model::Model;
use lemnis_models::kernel::calc::Calc;
use lemnis_models::luffing::ellipsograph::moving::{GuidedInertias, HeavyGuide};
use lemnis_models::luffing::ellipsograph::position::{Bars, GuidedChoice};
use lemnis_models::luffing::ellipsograph::statics::GuidedWeights;
use lemnis_models::luffing::moving::bodies::Pendulum;
use lemnis_models::luffing::moving::dynamics::{Coordinate, Dynamics};
use lemnis_models::luffing::moving::pendulum::Phase;
use lemnis_models::parts::four_bar::Branch;
use lemnis_models::parts::hoist::Hoist;
use lemnis_models::parts::motion::Motion;
use lemnis_models::scene::Scene;

const G: f64 = 9.81;
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
    let scene = Scene::parse(include_str!("../scenes/ellipsograph.toml")).expect("sound");
    let range: Motion = *scene.mechanism.motion();
    GuidedChoice {
        range,
        crank: Branch::Left,
    }
}

/// The load on its rope, or fixed to the head.
fn crane(bars: &Bars<f64>, weights: &GuidedWeights<f64>, hangs: bool) -> Dynamics {
    let fixed = (!hangs).then_some(LOAD);
    let guide = HeavyGuide::new(bars, weights, &INERTIAS, &None, &choice(), fixed, G).expect("no balance");
    let pendulum = Pendulum {
        mass: LOAD,
        length: ROPE,
        hoist: Hoist::AT_ONCE,
    };
    Dynamics::new(Arc::new(guide), hangs.then_some(pendulum), G)
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
        let expected = (drive - moment - 0.5 * slope * omega * omega) / inertia;
        let m = Phase {
            theta: phi,
            omega,
            swing: 0.0,
            swing_rate: 0.0,
        };
        let [found, _] = crane.accelerations(&m, drive).expect("exists");
        let size = (drive.abs() + moment.abs() + slope.abs() * omega * omega) / inertia;
        assert!((found - expected).abs() <= 1e-12 * size, "{phi}: {found} {expected}");
        let kinetic = crane.energy(&m).expect("exists") - crane.energy(&Phase { omega: 0.0, ..m }).expect("exists");
        let by_hand = 0.5 * inertia * omega * omega;
        let potential = crane.energy(&m).expect("exists").abs();
        assert!(
            (kinetic - by_hand).abs() <= 1e-12 * by_hand + 4.0 * f64::EPSILON * potential,
            "{phi}"
        );
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

const MOTION: &str = "[luffing.dynamics]\nJ_b = \"900000 kg.m2\"\nJ_l = \"100000 kg.m2\"\nM_S = \"100 MN.m\"\n";

fn model(fidelity: &str, rope: &str) -> Model {
    let text = include_str!("../scenes/ellipsograph.toml")
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

/// What a brake holds at rest is the moment that the drive must give at rest, balance and all.
#[test]
fn what_holds_it_at_rest_is_the_moment_of_the_drive_at_rest() {
    for (fidelity, rope) in [("rigid", ""), ("swing", "l_R = \"15 m\"\n")] {
        let mut model = model(fidelity, rope);
        for i in 0..=47 {
            let phi = f64::from(25 + i).to_radians();
            let index = model
                .variables()
                .iter()
                .position(|variable| variable.name() == "phi")
                .expect("there");
            model.set(index, phi).expect("an angle");
            model.update().expect("exists");
            let [held, at_rest] = ["M_R", "M_D"].map(|name| get(&mut model, name));
            let size = 11e3 * G * 20.0;
            assert!(
                (held - at_rest).abs() <= 1e-12 * size,
                "{fidelity} {i}: {held} {at_rest}"
            );
            assert_eq!(get(&mut model, "der(omega)"), 0.0);
        }
        if fidelity == "swing" {
            assert!((get(&mut model, "S_R") / (10e3 * 9.81) - 1.0).abs() < 1e-3);
        }
    }
}

/// What is asked over dual numbers is the derivative of what is asked over plain ones.
#[test]
fn slopes_are_those_of_the_plain_numbers() {
    use lemnis_models::parts::solver::Gradient;
    let crane = crane(&BARS, &WEIGHTS, false);
    for i in 1..60 {
        let phi = 0.05 * f64::from(i);
        let [theta] = Gradient::<1>::states(&[phi]);
        let r = Gradient::reduced(&crane, theta).expect("exists");
        let plain = f64::reduced(&crane, phi).expect("exists");
        assert_eq!(r.inertia.re.to_bits(), plain.inertia.to_bits());
        assert!((r.inertia.by[0] - plain.slope).abs() <= 1e-13 * plain.inertia, "{phi}");
        assert!((r.energy.by[0] - plain.moment).abs() <= 1e-13 * 1e6, "{phi}");
    }
}

//! A balance in motion: the inertia and the moment of its counterweight against what statics and levers give.

use lemnis_models::balance::Balance;
use lemnis_models::balance::boom::Boom;
use lemnis_models::component::model::Model;
use lemnis_models::kernel::calc::Calc;
use lemnis_models::luffing::double_link::balancing::{self, residual};
use lemnis_models::luffing::double_link::geometry::Geometry;
use lemnis_models::luffing::double_link::linkage::{Bodies, HeavyLinkage};
use lemnis_models::luffing::double_link::parameters::Driven;
use lemnis_models::luffing::double_link::position::Position;
use lemnis_models::luffing::double_link::scene::Luffing;
use lemnis_models::luffing::double_link::velocity::Velocity;
use lemnis_models::luffing::moving::bodies::Body;
use lemnis_models::luffing::moving::dynamics::{Coordinate, Dynamics};
use lemnis_models::luffing::moving::pendulum::Phase;
use lemnis_models::parts::plane::Point;
use lemnis_models::scene::Scene;

#[path = "common/balances.rs"]
mod balances;

const G: f64 = 9.81;

const NOTHING: Body = Body {
    mass: 0.0,
    inertia: 0.0,
    centre: Point::new(0.0, 0.0),
    spread: [0.0; 3],
};

/// Every kind with either bar driven; levers with the arm of their counterweight.
fn scenes() -> Vec<String> {
    let armed = |text: String| {
        if text.contains("kind = \"lever\"") && !text.contains("s_5") {
            text.replace("M_5 = \"984.8 kN.m\"", "M_5 = \"984.8 kN.m\"\ns_5 = \"3 m\"")
        } else {
            text
        }
    };
    balances::every_kind().into_iter().map(armed).collect()
}

fn luffing(text: &str) -> Luffing {
    let scene = Scene::parse(text).unwrap_or_else(|mistakes| panic!("{mistakes:?}"));
    scene.mechanism.of::<Luffing>().expect("a luffing mechanism").clone()
}

/// The counterweight as the only body that weighs anything.
fn alone(luffing: &Luffing) -> Dynamics {
    let g = Geometry::new(&luffing.parameters).expect("exists");
    let bodies = Bodies {
        boom: NOTHING,
        jib: NOTHING,
        rocker: NOTHING,
        pendulum: None,
        load: None,
        gravity: G,
    };
    HeavyLinkage::new(&g, bodies)
        .with_balance(&luffing.parameters, &luffing.motion)
        .expect("a balance")
        .in_motion()
}

fn kind(luffing: &Luffing) -> &'static str {
    luffing.parameters.balance.as_ref().expect("a balance").kind()
}

/// The moment by the height of the counterweight is that of statics, by levers and ropes; the inertia is
/// mass times arm² times the square of the lever's ratio, or of the rope's arm about the boom foot.
#[test]
fn moment_and_inertia_are_those_of_statics() {
    for text in scenes() {
        let luffing = luffing(&text);
        let (p, name) = (luffing.parameters, kind(&luffing));
        let (g, w) = (Geometry::new(&p).expect("exists"), p.weights.expect("weights"));
        let balancing = balancing::new(&p, &luffing.motion).expect("sound").expect("a balance");
        let dynamics = alone(&luffing);
        for theta in luffing.motion.angles() {
            let r = f64::reduced(&dynamics, theta).expect("closes");
            let there = residual(&balancing, &g, &w, theta).expect("closes");
            // Rate of the boom's angle over that of the driven bar.
            let position = Position::new(&g, theta).expect("closes");
            let ratio = match p.driven {
                Driven::Boom => 1.0,
                Driven::Rocker => Velocity::new(&position).i_follower,
            };
            let moment = -there.action.m_b * ratio;
            let close = |found: f64, expected: f64, what: &str| {
                let error = (found - expected).abs() / expected.abs().max(1e3);
                assert!(error < 1e-10, "{name} {what} at {theta}: {found} {expected}");
            };
            close(r.moment, moment, "moment");
            let (mass, arm) = match &balancing.balance {
                Balance::Tail(it) => (it.g_c / G, it.r_c),
                Balance::Parallelogram(it) => (it.g_c / G, it.r_c),
                Balance::Lever(it) => {
                    let arm = it.s_5.expect("given");
                    let i_5 = there.action.lever.expect("turns").i_5;
                    (it.dimensions.m_5 / arm / G, arm * i_5)
                }
                Balance::StraightRail(it) => {
                    // The rope's arm: its moment over its force.
                    (it.g_c / G, there.action.m_b / there.action.n_1.expect("pulls"))
                }
                Balance::CurvedRail(it) => {
                    // Along its rail: the height by statics, the rest by differences of the rail's own equation.
                    let h = 1e-5;
                    let place = |phi: f64| {
                        let (boom, _) = balancing::boom(&luffing.parameters, &luffing.motion).expect("a boom system");
                        let load = boom.at(phi).expect("closes");
                        it.rail(phi, load.u_0).expect("reaches")
                    };
                    let d = (place(there.phi + h) - place(there.phi - h)) / (2.0 * h);
                    let exact = (d.norm() * ratio).powi(2) * it.dimensions.g_c / G;
                    assert!((r.inertia / exact - 1.0).abs() < 1e-7, "{name} at {theta}");
                    continue;
                }
            };
            close(r.inertia, mass * (arm * ratio).powi(2), "inertia");
        }
    }
}

/// Slope of the inertia and moment against differences of inertia and energy.
#[test]
fn slopes_are_those_of_differences() {
    for text in scenes() {
        let luffing = luffing(&text);
        let dynamics = alone(&luffing);
        let h = 1e-5;
        for theta in luffing.motion.angles().into_iter().skip(1) {
            let at = |theta: f64| f64::reduced(&dynamics, theta).expect("closes");
            let (a, b, r) = (at(theta - h), at(theta + h), at(theta));
            let slope = (b.inertia - a.inertia) / (2.0 * h);
            let moment = (b.energy - a.energy) / (2.0 * h);
            // Differences err by h² times the third derivative, which is large where the boom nearly stands still.
            let size = r.inertia.max(r.slope.abs()).max(1e3);
            assert!(
                (slope - r.slope).abs() < 1e-5 * size,
                "{}: {slope} {}",
                kind(&luffing),
                r.slope
            );
            assert!(
                (moment - r.moment).abs() < 1e-6 * (G * size),
                "{}: {moment} {}",
                kind(&luffing),
                r.moment
            );
        }
    }
}

/// Without drive and friction a balanced crane keeps its energy while it moves, whatever the balance.
#[test]
fn a_free_balanced_crane_conserves_energy() {
    for text in scenes() {
        let luffing = luffing(&text);
        let (p, name) = (luffing.parameters, kind(&luffing));
        let g = Geometry::new(&p).expect("exists");
        let w = p.weights.expect("weights");
        let body = |weight: f64, inertia: f64, distance: f64, angle: f64| {
            let (sin, cos) = Calc::sin_cos(angle);
            let centre = Point::new(distance * cos, distance * sin);
            Body::slender(weight / G, inertia, centre, Point::new(1.0, 0.0))
        };
        let bodies = Bodies {
            boom: body(w.g_1, 9e5, w.s_1, w.chi_1),
            jib: body(w.g_2, 2e5, w.s_2, w.chi_2),
            rocker: body(w.g_3, 1e5, w.s_3, w.chi_3),
            pendulum: None,
            load: None,
            gravity: G,
        };
        let crane = HeavyLinkage::new(&g, bodies)
            .with_balance(&p, &luffing.motion)
            .expect("a balance")
            .in_motion();
        let middle = f64::midpoint(luffing.motion.from, luffing.motion.to);
        let mut m = Phase {
            theta: middle,
            omega: 0.05,
            swing: 0.0,
            swing_rate: 0.0,
        };
        let first = crane.energy(&m).expect("closes");
        let still = Phase { omega: 0.0, ..m };
        let moving = first - crane.energy(&still).expect("closes");
        let mut moved = 0.0_f64;
        for _ in 0..2000 {
            m = crane.step(&m, 0.0, 1e-3).expect("stays");
            moved = moved.max((m.theta - middle).abs());
        }
        let drift = (crane.energy(&m).expect("closes") - first) / moving;
        assert!(drift.abs() < 1e-9 && moved > 0.02, "{name}: {drift:e}, moved {moved}");
    }
}

fn in_motion(text: &str) -> Model {
    let dynamics = "\n[luffing.dynamics]\nJ_1 = \"900000 kg.m2\"\nJ_2 = \"200000 kg.m2\"\nJ_3 = \"100000 kg.m2\"\n\
                    M_S = \"1e9 kN.m\"\n\n[luffing.drive]";
    let text = text
        .replace("driven = ", "fidelity = \"rigid\"\ndriven = ")
        .replace("\n[luffing.drive]", dynamics);
    let scene = Scene::parse(&text).unwrap_or_else(|mistakes| panic!("{mistakes:?}"));
    scene.model().expect("built")
}

/// What the brake holds at rest is what the book's drive would: the moment of load and weights less the balance's.
#[test]
fn at_rest_the_brake_holds_the_statics_moment() {
    for text in scenes() {
        let mut model = in_motion(&text);
        let index = |name: &str| {
            let mut variables = model.variables().iter();
            variables.position(|v| v.symbol.id == name).expect("exists")
        };
        let (held, drive) = (index("M_R"), index("M_D"));
        let (from, to) = (model.positions()[0], *model.positions().last().expect("positions"));
        for i in 1..10 {
            model
                .set(0, from + (to - from) * 0.1 * f64::from(i))
                .expect("in the range");
            model.update().expect("closes");
            let [held, drive] = [held, drive].map(|i| model.get(i).expect("closes"));
            assert!((held - drive).abs() < 1e-9 * drive.abs().max(1e5), "{held} {drive}");
        }
    }
}

/// Where the residual moment vanishes the unloaded crane rests without brake and friction.
#[test]
fn an_unloaded_crane_rests_where_it_is_balanced() {
    for text in scenes() {
        let luffing = luffing(&text.replace("Q = \"100 kN\"", "Q = \"0 kN\""));
        let p = luffing.parameters;
        let found = balancing::analysis(&p, &luffing.motion)
            .expect("sound")
            .expect("a balance");
        let mut model = in_motion(&text.replace("Q = \"100 kN\"", "Q = \"0 kN\""));
        let index = |name: &str| {
            let mut variables = model.variables().iter();
            variables.position(|v| v.symbol.id == name).expect("exists")
        };
        let (brake, rate) = (
            index("M_S"),
            index(if p.driven == Driven::Boom {
                "der(omega_1)"
            } else {
                "der(omega_3)"
            }),
        );
        for equilibrium in &*found.equilibria {
            model.set(0, equilibrium.at).expect("in the range");
            model.set(brake, 0.0).expect("allowed");
            model.update().expect("closes");
            let acceleration = model.get(rate).expect("closes");
            // 1 kN·m, a thousandth of the moments that cancel here, would give 1e-3 rad/s² or less.
            assert!(acceleration.abs() < 1e-9, "{acceleration:e}");
        }
    }
}

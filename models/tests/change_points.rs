//! IFToMM benchmark A02: N four-bars of 1 m in a row, bars of 1 kg, g = 9.81, started upright with
//! 1 m/s, for 20 s through all their change points, where the branches of every window meet.
//!
//! References: `tests/oracles/four_bars.py`, Legendre's integral with 50 digits.

use lemnis_models::component::model::Model;
use lemnis_models::kernel::variable::{Role, Type};
use lemnis_models::luffing::double_link::geometry::Geometry;
use lemnis_models::luffing::double_link::parameters::{Driven, Jib, Lengths, Parameters};
use lemnis_models::luffing::double_link::pole::Pole;
use lemnis_models::luffing::double_link::position::Position;
use lemnis_models::luffing::double_link::velocity::Velocity;
use lemnis_models::parts::closure::Closure;
use lemnis_models::parts::four_bar::Branch;
use lemnis_models::scene::Scene;
use num_dual::{Dual2_64, Dual64};
use std::f64::consts::PI;

use four_bars::{NAMES, REFERENCE, Row, linkage};

#[path = "common/four_bars.rs"]
mod four_bars;

#[test]
fn benchmark_a02_agrees_with_its_closed_form() {
    for (windows, reference, steps) in [(2, REFERENCE[0], 20_000), (40, REFERENCE[1], 20_000)] {
        let (angle, passages) = Row::new(windows).run(steps);
        // The free end of the first bar, in m: its error is that of the angle times 1 m.
        let error = (angle - reference).abs();
        println!("N = {windows}: phi(20 s) = {angle}, {passages} passages, error {error:.1e}");
        assert_eq!(passages, 20, "half turns, each through a singular position");
        assert!(error <= 1e-6, "N = {windows}: {angle} {reference}");
    }
}

/// In a change point itself, and on both sides of it, the bars and their derivatives are those of the
/// branch: with parallel bars follower and crank move alike; the crossed linkage mirrors there.
#[test]
fn the_branch_is_kept_exactly_in_a_change_point() {
    for turns in [0.0, 1.0, -3.0, 1e3] {
        for offset in [0.0, 1e-300, 1e-15, -1e-15, 1e-8, -1e-3, 0.1] {
            for bars in [[1.0; 4], [2.0, 5.0, 2.0, 5.0]] {
                let theta = Dual2_64::new(turns * PI + offset, 1.0, 0.0);
                let parallel = Closure::new(&linkage(bars, Branch::Left), theta, &NAMES).expect("closes");
                assert_eq!(parallel.follower, parallel.crank);
                assert_eq!((parallel.coupler.x.re, parallel.coupler.y.re), (bars[3], 0.0));
            }
            // Crossed: the coupler turns against the crank, twice in one turn through the frame's line.
            let bars = [2.0, 5.0, 2.0, 5.0];
            let theta = Dual2_64::new(turns * PI + offset, 1.0, 0.0);
            let crossed = Closure::new(&linkage(bars, Branch::Right), theta, &NAMES).expect("closes");
            let lengths = [crossed.coupler, crossed.follower].map(|v| v.map(|x| x.re).norm());
            assert!(
                (lengths[0] - 5.0).abs() < 1e-14 && (lengths[1] - 2.0).abs() < 1e-14,
                "{lengths:?}"
            );
            // Velocity of K along both bars vanishes: K stays on its circles.
            let loop_speed = [crossed.coupler, crossed.follower].map(|v| v.map(|x| x.re).dot(&v.map(|x| x.v1)).abs());
            assert!(loop_speed.iter().all(|x| *x < 1e-12), "{loop_speed:?}");
            let turn = crossed.follower.map(|x| x.v1).norm();
            assert!(turn > 0.5 && turn.is_finite(), "{turns} {offset}: {turn}");
        }
    }
}

/// Boom, rear arm, rocker and frame, in m: parallelogram, the same crossed, kites, rhombus.
const BARS: [[f64; 4]; 5] = [
    [20.0, 5.0, 20.0, 5.0],
    [4.0, 9.0, 4.0, 9.0],
    [7.0, 7.0, 3.0, 3.0],
    [3.0, 8.0, 8.0, 3.0],
    [6.0, 6.0, 6.0, 6.0],
];

/// Angular velocities in change points and beside them are the derivatives of the angles on the branch, whichever bar is
/// driven and however the frame lies; the head moves as the joint and the jib say.
#[test]
fn velocities_are_those_of_the_branch() {
    let (mut worst, mut compared) = (0.0_f64, 0);
    let either = |bars| [true, false].map(|level| (bars, level));
    let ways =
        [Driven::Boom, Driven::Rocker].map(|driven| [Branch::Left, Branch::Right].map(|branch| (driven, branch)));
    for (bars, level) in BARS.into_iter().flat_map(either) {
        for (driven, branch) in ways.into_iter().flatten() {
            let [x_1, x_2, x_3, x_56] = bars;
            let (x_5, x_6) = if level { (x_56, 0.0) } else { (0.0, x_56) };
            let parameters = Parameters {
                lengths: Lengths {
                    x_1,
                    x_2,
                    x_3,
                    x_4: 10.0,
                    x_5,
                    x_6,
                    x_8: 0.0,
                },
                jib: Jib::Angle(2.8),
                weights: None,
                anchors: None,
                cylinder: None,
                balance: None,
                driven,
                branch,
            };
            let g = Geometry::new(&parameters).expect("exists");
            let [crank, follower] = if driven == Driven::Boom { [x_1, x_3] } else { [x_3, x_1] };
            // Twice in a turn in one line; with a diagonal that vanishes instead, two bars are free to turn there.
            let passes = crank + x_56 == x_2 + follower && (crank - x_56).abs() == (x_2 - follower).abs();
            assert_eq!(g.linkage.keeps_branch(), passes, "{bars:?} {driven:?}");
            assert!(g.linkage.change_points().count() == if passes { 2 } else { 1 });
            if !passes {
                continue;
            }
            let foot = g.linkage.change_points().next().expect("two");
            let d = Geometry::new(&parameters.map(&mut |_, x| Dual64::from_re(x))).expect("exists");
            for turn in [0.0, 0.5, 1.0, 1.5, 2.0, 7.0] {
                for offset in [0.0, 1e-300, 1e-15, -1e-12, 1e-8, -1e-3, 0.3] {
                    let theta = foot + turn * PI + offset;
                    let (Some(p), Some(q)) = (Position::new(&g, theta), Position::new(&d, Dual64::new(theta, 1.0)))
                    else {
                        // A vanishing diagonal leaves two bars free to turn.
                        assert!(
                            x_1 == x_56 && x_1 != x_2 || x_3 == x_56 && x_3 != x_2,
                            "{bars:?} at {theta}"
                        );
                        continue;
                    };
                    let v = Velocity::new(&p);
                    let follower = match driven {
                        Driven::Boom => q.x_3,
                        Driven::Rocker => q.x_1,
                    };
                    let turned = |bar: lemnis_models::parts::plane::Point<Dual64>| {
                        (bar.x.re * bar.y.eps - bar.y.re * bar.x.eps) / (bar.x.re * bar.x.re + bar.y.re * bar.y.re)
                    };
                    if let Some((o1p, at)) = Pole::new(&g, &p, &v).finite() {
                        // The jib turns about it, and it lies on the boom's line.
                        let from = p.a - at;
                        let moved = [-from.y * v.i_2 - v.da.x, from.x * v.i_2 - v.da.y];
                        let off = p.x_1 * (o1p / x_1) - at;
                        let size = 1e-13 * (1.0 + v.i_2.abs()) * (40.0 + o1p.abs());
                        assert!(moved.iter().all(|x| x.abs() < size), "{bars:?} at {theta}: {moved:?}");
                        assert!(off.norm() < size, "{bars:?} at {theta}: {off:?}");
                    } else {
                        assert!(v.i_2.abs() < 1e-15, "{bars:?} at {theta}");
                    }
                    let expected = [turned(q.x_2), turned(follower), q.a.x.eps, q.a.y.eps];
                    for (found, expected) in [v.i_2, v.i_follower, v.da.x, v.da.y].into_iter().zip(expected) {
                        let error = (found - expected).abs() / (1.0 + expected.abs());
                        assert!(
                            error < 1e-12,
                            "{bars:?} {driven:?} {branch:?} at {theta}: {found} {expected}"
                        );
                        (worst, compared) = (worst.max(error), compared + 1);
                    }
                }
            }
        }
    }
    println!("{compared} velocities, largest error {worst:.1e}");
    assert!(compared > 1000);
}

const PARALLEL: &str = r#"
name = "Parallel"
title = "A parallelogram"
[luffing]
driven = "boom"
branch = "left"
X_1 = "20 m"
X_2 = "5 m"
X_3 = "20 m"
X_4 = "10 m"
X_5 = "5 m"
X_6 = "0 m"
beta_0 = "180 deg"
X_8 = "0 m"
[luffing.motion]
from = "-180 deg"
to = "200 deg"
step = "10 deg"
speed = "1 deg/s"
"#;

/// Bodies, load and drive of the same in motion.
const MOVING: &str = r#"
[luffing.weights]
G_1 = "100 kN"
s_1 = "1 m"
chi_1 = "0 deg"
G_2 = "50 kN"
s_2 = "2 m"
chi_2 = "180 deg"
G_3 = "40 kN"
s_3 = "1 m"
chi_3 = "0 deg"
[luffing.drive]
kind = "rack"
E_x = "30 m"
E_y = "-40 m"
s_d = "7 m"
chi_d = "0 deg"
[luffing.dynamics]
J_1 = "1000 kg.m2"
J_2 = "50000 kg.m2"
J_3 = "10000 kg.m2"
M_A = "0 kN.m"
"#;

fn built(text: &str) -> Model {
    let scene = Scene::parse(text).unwrap_or_else(|mistakes| panic!("{mistakes:?}"));
    scene.model().expect("built")
}

fn index(model: &Model, id: &str) -> usize {
    let found = model.variables().iter().position(|variable| variable.symbol.id == id);
    found.unwrap_or_else(|| panic!("{id}"))
}

/// Every result is a number, but for the place of a centre that is said to lie at infinity.
fn sound(model: &mut Model, case: &str) {
    let far = index(model, "P.at_infinity");
    let far = model.get(far) == Ok(1.0);
    for at in 0..model.variables().len() {
        let variable = model.variables()[at];
        let value = model
            .get(at)
            .unwrap_or_else(|fault| panic!("{case}: {variable}: {}", fault.message));
        let centre = ["O1P", "P.x", "P.y"].contains(&variable.symbol.id);
        assert!(
            value.is_finite() || (centre && far && !value.is_nan()),
            "{case}: {variable} = {value}"
        );
        // An indicator says with the greatest number that its event cannot happen.
        let great = centre || variable.role == Role::Indicator || variable.kind != Type::Real;
        assert!(value.abs() < 1e12 || great, "{case}: {variable} = {value}");
    }
}

/// Without a load, a range may pass its change points: every result stays a number, exactly in them too.
#[test]
fn kinematics_pass() {
    let crossed = PARALLEL.replace("\"left\"", "\"right\"");
    let kite = PARALLEL
        .replace("X_2 = \"5 m\"", "X_2 = \"20 m\"")
        .replace("X_3 = \"20 m\"", "X_3 = \"5 m\"");
    let table = |text: &str| text.replace("driven =", "fidelity = \"table\"\ndriven =");
    let rocker = PARALLEL.replace("\"boom\"", "\"rocker\"");
    for text in [PARALLEL, &crossed, &kite, &rocker, &table(PARALLEL), &table(&crossed)] {
        let mut model = built(text);
        for half in -360..=400 {
            model.set(0, f64::from(half) * 0.5_f64.to_radians()).expect("an angle");
            sound(
                &mut model,
                &format!("{} at {} deg", text.replace('\n', " "), 0.5 * f64::from(half)),
            );
        }
        for offset in [1e-300, -1e-15, 1e-9] {
            model.set(0, offset).expect("an angle");
            sound(&mut model, text);
        }
    }
}

/// A crane in motion passes with the moment of its drive, its load on a rope or fixed to it: without friction it keeps its
/// energy, and its drive gives nothing. Forces in the pins are not finite there, and do not exist.
#[test]
fn motion_passes() {
    let text = PARALLEL.replace("X_8 = \"0 m\"", "X_8 = \"0 m\"\nQ = \"100 kN\"") + MOVING;
    for (level, more) in [("rigid", ""), ("swing", "l_R = \"6 m\"\n")] {
        let text = text.replace("driven =", &format!("fidelity = \"{level}\"\ndriven =")) + more;
        let mut model = built(&text);
        let ids = |model: &Model| model.variables().iter().map(|v| v.symbol.id).collect::<Vec<_>>();
        for gone in ["N_3", "F_B.x", "F_O1.y"] {
            assert!(!ids(&model).contains(&gone), "{gone}");
        }
        let [theta, omega, drive] = ["theta_1", "omega_1", "M_D"].map(|id| index(&model, id));
        // From below the first change point, fast enough to go over the top and on through the second.
        model.set(theta, (-40_f64).to_radians()).expect("a state");
        model.set(omega, 4.0).expect("a state");
        model.event().expect("closes");
        // Every point goes round a circle: boom and rocker about their feet, jib and load in one of 20 m.
        let turned = (100e3 + 40e3 + 150e3 * 400.0) / 9.81 + 1000.0 + 10_000.0;
        let energy = |[theta, omega]: [f64; 2]| {
            let height = lemnis_models::kernel::calc::Calc::sin(theta);
            0.5 * turned * omega * omega + (100e3 + 40e3 + 150e3 * 20.0) * height
        };
        let state = |model: &mut Model| [theta, omega].map(|at| model.get(at).expect("a state"));
        let (mut passed, start) = (0, state(&mut model));
        for step in 0..2000 {
            let before = state(&mut model);
            let time = 1e-3 * f64::from(step);
            model.advance(time, time + 1e-3).expect("closes");
            let now = state(&mut model);
            sound(&mut model, level);
            assert_eq!(model.get(drive), Ok(0.0));
            if now[1] == 0.0 {
                break;
            }
            let lost = energy(now) - energy(start);
            assert!(
                level == "swing" || lost.abs() < 1e-9 * energy(start),
                "{lost} J at {now:?}"
            );
            passed += u32::from((before[0] / PI).floor() != (now[0] / PI).floor());
        }
        println!(
            "{level}: from {start:?} to {:?}, {passed} change points passed",
            state(&mut model)
        );
        assert!(passed >= 2, "{level}: {passed}");
    }
}

/// With the least change of one length a linkage loses its change points: by these there is no derivative, but by all else.
#[test]
fn lengths_that_undo_the_change_points_have_no_derivative() {
    let text = PARALLEL.replace("X_8 = \"0 m\"", "X_8 = \"0 m\"\nQ = \"100 kN\"") + MOVING;
    let moving = text.replace("driven =", "fidelity = \"rigid\"\ndriven =");
    for (text, unknowns) in [
        (PARALLEL, &["A.y", "V_AY"][..]),
        (&moving, &["A.y", "der(omega_1)", "M_R"]),
    ] {
        let model = built(text);
        for unknown in unknowns {
            let at = index(&model, unknown);
            let by = |id: &str| {
                let known = model.variables()[index(&model, id)].quantity();
                model.derivative(&mut model.tangent(&|quantity| f64::from(quantity == known)), at)
            };
            for id in ["X_1", "X_2", "X_3", "X_5", "X_6"] {
                let fault = by(id).expect_err("none");
                assert!(fault.outside && fault.message.contains(id), "{}", fault.message);
            }
            for id in ["theta_1", "omega_1", "X_4", "beta_0", "X_8"] {
                assert!(by(id).is_ok_and(f64::is_finite), "{unknown} by {id}");
            }
        }
    }
}

/// A range that keeps clear of the change points has forces in the pins; set to one from outside, the model refuses these
/// alone, with the angle, and goes on.
#[test]
fn forces_in_the_pins_end_at_a_change_point() {
    let text = PARALLEL.replace("X_8 = \"0 m\"", "X_8 = \"0 m\"\nQ = \"100 kN\"");
    let text = text
        .replace("\"-180 deg\"", "\"20 deg\"")
        .replace("\"200 deg\"", "\"160 deg\"");
    let mut model = built(&text);
    let [rocker, drive, speed] = ["N_3", "M_D", "V_AY"].map(|id| index(&model, id));
    for degrees in [0.0, 1e-300, 180.0, -360.0] {
        model.set(0, f64::to_radians(degrees)).expect("an angle");
        let fault = model.get(rocker).expect_err("not finite");
        assert!(
            fault.outside && fault.message.contains("bars lie in one line there"),
            "{}",
            fault.message
        );
        for at in [drive, speed] {
            assert!(
                model.get(at).is_ok_and(|value| value.is_finite() && value != 0.0),
                "{degrees}"
            );
        }
        model.set(0, 1.0).expect("an angle");
        assert!(model.get(rocker).is_ok_and(f64::is_finite));
    }
}

//! Screw and pinion of a drive that pushes along a line, the pinion in a sector, and the crank with its rod.

use lemnis_models::component::model::Model;
use lemnis_models::component::stages::Rows;
use lemnis_models::drive::gear::{Gear, Pinion};
use lemnis_models::drive::screw::Screw;
use lemnis_models::drive::shaft::{Gearing, Shaft};
use lemnis_models::drive::symbols as s;
use lemnis_models::kernel::calc::Calc;
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::parts::plane::{Point, length};
use lemnis_models::scene::Scene;
use proptest::prelude::*;

const READY: &str = include_str!("../scenes/portal_004_screw.toml");
const SECTOR: &str = include_str!("../scenes/portal_004_sector.toml");
const CRANK: &str = include_str!("../scenes/portal_004_crank.toml");

fn index(model: &Model, name: &str) -> usize {
    let found = model.variables().iter().position(|variable| variable.name() == name);
    found.unwrap_or_else(|| panic!("no {name}"))
}

fn at(model: &mut Model, angle: f64, name: &str) -> f64 {
    model.set(0, angle).expect("an angle");
    let index = index(model, name);
    model.get(index).expect("exists")
}

fn of<T: Rows<f64>>(made: &T, symbol: &'static Symbol) -> f64 {
    let row = T::ROWS.iter().position(|known| *known == symbol).expect("a result");
    made.row(row as u8, 0).expect("exists")
}

/// Torque without friction, lengthening, shortening, in N·m under a force (N).
fn torques(gear: Gear<f64>, f_d: f64) -> [f64; 3] {
    let shaft = Shaft::new(&Gearing::new(&gear), f_d, 0.0);
    [&s::T_D, &s::T_D_OUT, &s::T_D_IN].map(|symbol| of(&shaft, symbol))
}

/// A screw jack's calculator on the Web, with a square thread: d_2 = 50 mm, lead 10 mm, μ = 0.12, 10 kN: λ = 3.643°,
/// ρ = 6.843°, T = 46.269 N·m, efficiency 34.4 %.
#[test]
fn a_screw_jack() {
    let screw = Screw {
        d_2: 0.05,
        p_h: 0.01,
        mu_d: 0.12,
        beta_d: 0.0,
    };
    let gearing = Gearing::new(&Gear::Screw(screw));
    let angle = |symbol| of(&gearing, symbol).to_degrees();
    assert!((angle(&s::LAMBDA_D) - 3.643).abs() < 5e-4);
    assert!((angle(&s::RHO_D) - 6.843).abs() < 5e-4);
    assert!((angle(&s::LOCK_D) - (6.843 - 3.643)).abs() < 1e-3);
    let [free, out, back] = torques(Gear::Screw(screw), 10e3);
    assert!((out - 46.269).abs() < 5e-4, "{out}");
    assert!((free / out - 0.344).abs() < 5e-4, "{}", free / out);
    // It locks itself: the load must be turned down, 10 kN · 25 mm · tan(3.643° − 6.843°) = 250 N·m · (−0.0559).
    assert!((back + 13.977).abs() < 5e-3, "{back}");
}

/// A trapezoidal thread, by hand: cos 15° = 0.965926, tan ρ′ = 0.12 / 0.965926 = 0.124233, ρ′ = 7.0818°.
#[test]
fn a_flank_adds_friction() {
    let screw = Screw {
        d_2: 0.112,
        p_h: 0.014,
        mu_d: 0.12,
        beta_d: 15_f64.to_radians(),
    };
    let found = of(&Gearing::new(&Gear::Screw(screw)), &s::RHO_D);
    assert!((found.to_degrees() - 7.0818).abs() < 5e-5, "{}", found.to_degrees());
}

proptest! {
    /// Friction takes work in each sense of the motion, whichever way the force acts; with none all three are one, and a
    /// force the other way round asks for the torques of the other sense.
    #[test]
    fn friction_takes_work(
        d_2 in 0.01..0.5_f64, lead in 0.02..1.5_f64, mu in 0.0..0.5_f64, flank in 0.0..0.6_f64, eta in 0.3..1.0_f64,
        force in -1e6..1e6_f64,
    ) {
        let screw = |mu_d| Gear::Screw(Screw { d_2, p_h: lead * d_2, mu_d, beta_d: flank });
        let pinion = |eta_d| Gear::Pinion(Pinion { r_z: d_2, eta_d });
        for (gear, smooth) in [(screw(mu), screw(0.0)), (pinion(eta), pinion(1.0))] {
            let [free, out, back] = torques(gear, force);
            let scale = 1e-12 * free.abs().max(1.0);
            prop_assert!(out >= free - scale && back <= free + scale, "{free} {out} {back}");
            for torque in torques(smooth, force) {
                prop_assert!((torque - free).abs() <= scale, "{torque} {free}");
            }
            let other = torques(gear, -force);
            prop_assert!((other[0] + free).abs() <= scale && (other[1] + back).abs() <= scale);
        }
    }
}

/// Over the whole stroke the work of screw or pinion without friction is that of the drive's moment, ∫ T dα = ∫ F ds = ∫ M_D dθ
/// by Simpson's rule; each of its positions turns by what the drive lengthens.
#[test]
fn its_work_is_that_of_the_moment() {
    const PARTS: u32 = 4000;
    let [from, to] = [44_f64, 82.0].map(f64::to_radians);
    let step = (to - from) / f64::from(PARTS);
    // Travel in one turn; all travel of a sector is its pitch radius times the angle, that of a crank an angle.
    for (text, turn, stroke) in [
        (READY, 0.014, Ok("L_d")),
        (SECTOR, 0.15 * std::f64::consts::TAU, Err(4.0 * (to - from))),
        (CRANK, std::f64::consts::TAU, Ok("theta_cr")),
    ] {
        let mut model = Scene::parse(text).expect("legal").model().expect("exists");
        let (mut by_shaft, mut by_force, mut by_moment, mut turns) = (0.0, 0.0, 0.0, 0.0);
        for i in 0..=PARTS {
            let angle = from + f64::from(i) * step;
            let weight = step / 3.0
                * match i {
                    0 | PARTS => 1.0,
                    i if i % 2 == 1 => 4.0,
                    _ => 2.0,
                };
            let omega = at(&mut model, angle, "omega_1");
            let speed = at(&mut model, angle, "n_d") * std::f64::consts::TAU / omega;
            by_shaft += weight * at(&mut model, angle, "T_d") * speed;
            by_force += weight * at(&mut model, angle, "F_d") * at(&mut model, angle, "v_d") / omega;
            by_moment += weight * at(&mut model, angle, "M_D");
            turns += weight * speed / std::f64::consts::TAU;
        }
        for by_drive in [by_shaft, by_force] {
            assert!(
                (by_drive - by_moment).abs() <= 1e-12 * by_moment.abs(),
                "{by_drive} {by_moment}"
            );
        }
        let stroke = stroke.map_or_else(|all| all, |name| at(&mut model, to, name) - at(&mut model, from, name));
        assert!((turns * turn - stroke).abs() <= 1e-10, "{turns} {stroke}");
    }
}

/// F_t = M / r at every angle, T = F_t r_z; the frame carries it at right angles to the line from the foot to the pinion, which
/// a mere moment does not load.
#[test]
fn a_sector_by_hand() {
    let mut model = Scene::parse(SECTOR).expect("legal").model().expect("exists");
    let bare = SECTOR.find("[luffing.drive]").expect("there");
    let mut moment = Scene::parse(&SECTOR[..bare]).expect("legal").model().expect("exists");
    let (sin, cos) = Calc::sin_cos(100_f64.to_radians());
    for degrees in [44.0, 60.5, 82.0_f64] {
        let angle = degrees.to_radians();
        let m_d = at(&mut model, angle, "M_D");
        let force = at(&mut model, angle, "F_d");
        assert_eq!(m_d.to_bits(), at(&mut moment, angle, "M_D").to_bits());
        assert!((force - m_d / 4.0).abs() <= 1e-14 * force.abs());
        assert!((at(&mut model, angle, "T_d") - force * 0.15).abs() <= 1e-14 * force.abs());
        let by_hand = if force > 0.0 {
            force * 0.15 / 0.95
        } else {
            force * 0.15 * 0.95
        };
        assert!((at(&mut model, angle, "T_d.out") - by_hand).abs() <= 1e-14 * force.abs());
        for (name, part) in [("F_O1.x", -sin), ("F_O1.y", cos)] {
            let carried = at(&mut moment, angle, name) - at(&mut model, angle, name);
            let scale = at(&mut moment, angle, name).abs() + force.abs();
            assert!((carried - force * part).abs() <= 1e-13 * scale, "{name} {carried}");
        }
    }
}

/// At three angles by the two circles on which crank and rod meet, and at each the torque by moments about both pivots.
#[test]
fn a_crank_by_hand() {
    let mut model = Scene::parse(CRANK).expect("legal").model().expect("exists");
    let bare = CRANK.find("[luffing.drive]").expect("there");
    let mut moment = Scene::parse(&CRANK[..bare]).expect("legal").model().expect("exists");
    for degrees in [44.0, 63.0, 82.0_f64] {
        let angle = degrees.to_radians();
        let (sin, cos) = Calc::sin_cos(angle);
        // Joint on the boom, and from the crank's centre to it.
        let joint = [6.0 * cos, 6.0 * sin];
        let (x, y) = (joint[0] + 3.7, joint[1] - 8.2);
        let distance = length(Point::new(x, y));
        // Law of cosines; the pin lies on the left of the line from the centre to the joint.
        let along = (2.1 * 2.1 - 7.0 * 7.0 + distance * distance) / (2.0 * distance);
        let across = (2.1 * 2.1 - along * along).sqrt();
        let pin = [
            -3.7 + (along * x - across * y) / distance,
            8.2 + (along * y + across * x) / distance,
        ];
        let rod = [(joint[0] - pin[0]) / 7.0, (joint[1] - pin[1]) / 7.0];
        let about_foot = joint[0] * rod[1] - joint[1] * rod[0];
        let about_centre = (pin[0] + 3.7) * rod[1] - (pin[1] - 8.2) * rod[0];
        let m_d = at(&mut moment, angle, "M_D");
        let close = |found: f64, by_hand: f64| (found - by_hand).abs() <= 1e-12 * by_hand.abs();
        for (name, by_hand) in [
            ("h_d", about_foot),
            ("h_cr", about_centre),
            ("M_D", m_d),
            ("F_d", m_d / about_foot),
            ("T_d", m_d / about_foot * about_centre),
            ("T_cr", m_d / about_foot * about_centre),
        ] {
            let found = at(&mut model, angle, name);
            assert!(close(found, by_hand), "{degrees}° {name}: {found} {by_hand}");
        }
        let [out, back] = ["T_d.out", "T_d.in"].map(|name| at(&mut model, angle, name));
        let free = m_d / about_foot * about_centre;
        let (costs, gives) = (free / 0.95, free * 0.95);
        let by_hand = if m_d / about_foot > 0.0 {
            [costs, gives]
        } else {
            [gives, costs]
        };
        assert!(
            close(out, by_hand[0]) && close(back, by_hand[1]),
            "{out} {back} {by_hand:?}"
        );
        for (name, part) in [("F_O1.x", rod[0]), ("F_O1.y", rod[1])] {
            let carried = at(&mut moment, angle, name) - at(&mut model, angle, name);
            let scale = at(&mut moment, angle, name).abs() + (m_d / about_foot).abs();
            assert!(
                (carried - m_d / about_foot * part).abs() <= 1e-13 * scale,
                "{name} {carried}"
            );
        }
    }
}

/// Towards a dead point the torque falls to nothing with the root of the way that is left, and the crank turns ever faster; its
/// power stays that of the moment. Beyond it the angle is refused.
#[test]
fn a_crank_at_its_dead_point() {
    let mut model = Scene::parse(CRANK).expect("legal").model().expect("exists");
    // Where the joint is r + l away from the centre, by bisection.
    let away = |angle: f64| {
        let (sin, cos) = Calc::sin_cos(angle);
        length(Point::new(6.0 * cos + 3.7, 6.0 * sin - 8.2)) - 9.1
    };
    let (mut inside, mut outside) = (44_f64.to_radians(), 40_f64.to_radians());
    assert!(away(inside) < 0.0 && away(outside) > 0.0);
    for _ in 0..60 {
        let middle = f64::midpoint(inside, outside);
        if away(middle) < 0.0 {
            inside = middle;
        } else {
            outside = middle;
        }
    }
    let mut last = f64::INFINITY;
    for place in 4..12 {
        let angle = inside + 0.1_f64.powi(place);
        let [torque, speed, moment, omega] = ["T_d", "n_d", "M_D", "omega_1"].map(|name| at(&mut model, angle, name));
        let power = torque * speed * std::f64::consts::TAU;
        assert!((power - moment * omega).abs() <= 1e-12 * power.abs(), "{power}");
        let fallen = (torque / last).abs();
        assert!(
            place == 4 || (fallen - 0.1_f64.sqrt()).abs() < 2e-3,
            "{place}: {fallen}"
        );
        last = torque;
    }
    model.set(0, inside - 1e-6).expect("the linkage closes");
    let index = index(&model, "F_d");
    let refused = model.get(index).expect_err("beyond the dead point");
    assert!(
        refused.message.contains("crank and rod do not meet there"),
        "{}",
        refused.message
    );
}

/// What a drive has too much or too little, what cannot turn, and what no level has.
#[test]
fn what_cannot_be_is_refused() {
    let moving = include_str!("../scenes/portal_004_motion.toml");
    let with_pinion = moving.replacen(
        "kind   = \"rack\"",
        "kind = \"rack\"\nr_z = \"200 mm\"\neta_d = \"0.9\"",
        1,
    );
    let slow = moving.replacen("[luffing.dynamics]", "[luffing.dynamics]\nt_s = \"10000 s\"", 1);
    for (text, said) in [
        (READY.replace("\"screw\"", "\"rack\""), "a rack has no d_2"),
        (
            READY.replace("mu_d   = \"0.12\"", ""),
            "`mu_d` is missing in [luffing.drive]",
        ),
        (
            READY.replace("\"14 mm\"", "\"140 mm\"").replace("\"0.12\"", "\"90\""),
            "no torque turns the screw",
        ),
        (with_pinion, "at rest alone"),
        (
            SECTOR.replace("delta_s", "#"),
            "`delta_s` is missing in [luffing.drive] of the kind \"sector\"",
        ),
        (
            SECTOR.replace("r_s ", "s_d = \"3 m\"\nr_s "),
            "a sector has no s_d, which is of a cylinder, rack, screw, crank or rope",
        ),
        (
            READY.replace("chi_d ", "#"),
            "`chi_d` is missing in [luffing.drive] of the kind \"screw\"",
        ),
        (
            CRANK.replace("\"7 m\"", "\"6.8 m\""),
            "crank and rod do not meet over the whole working range",
        ),
        (
            CRANK.replace("\"7 m\"", "\"30 m\""),
            "crank and rod meet the anchor on the driving link at no angle",
        ),
        (
            CRANK.replace("\nbranch = \"left\"      ", "\n#"),
            "`branch` is missing in [luffing.drive] of the kind \"crank\"",
        ),
        (
            SECTOR.replace("r_s ", "branch = \"left\"\nr_s "),
            "a sector has no branch, which is of a crank",
        ),
        (
            SECTOR.replace("r_s ", "r_cr = \"1 m\"\nr_s "),
            "a sector has no r_cr, which is of a crank",
        ),
        (
            moving.replacen(
                "kind   = \"rack\"",
                "kind = \"crank\"\nr_cr = \"2 m\"\nl_cr = \"9 m\"\nbranch = \"left\"\neta_d = \"1\"",
                1,
            ),
            "at rest alone",
        ),
        (slow, "t_s = 10000 s is more than 100 times"),
        (
            READY
                .replace("\"screw\"", "\"rack\"")
                .replace("d_2 ", "#")
                .replace("p_h ", "#")
                .replace("mu_d ", "#")
                .replace("beta_d ", "#"),
            "a limit lock_d",
        ),
    ] {
        let found = Scene::parse(&text).expect_err(said);
        assert!(
            found
                .iter()
                .any(|told| told.message.contains(said) && told.help.is_some()),
            "{said}: {found:?}"
        );
    }
}

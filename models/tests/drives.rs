//! Every kind of drive on every luffing system that has one: the same results, whatever link it turns.

#[path = "common/driven_systems.rs"]
mod driven_systems;

use std::f64::consts::TAU;

use driven_systems::{KINDS, SYSTEMS, System, close, index, model};
use lemnis_models::component::model::Model;
use lemnis_models::kernel::calc::Calc;
use lemnis_models::parts::plane::{Point, cross, length};
use lemnis_models::scene::Scene;

fn at<const N: usize>(model: &mut Model, angle: f64, names: [&str; N]) -> [f64; N] {
    model.set(0, angle).expect("an angle");
    names.map(|name| {
        let index = index(model, name);
        model.get(index).expect("exists")
    })
}

/// F ds = T dα = M dφ without friction, over the whole stroke by Simpson's rule and at every position of it; a line gets as
/// much longer as its speed says.
#[test]
fn the_work_of_every_drive_is_that_of_the_moment() {
    const PARTS: u32 = 4000;
    for system in &SYSTEMS {
        let [from, to] = system.range.map(f64::to_radians);
        let step = (to - from) / f64::from(PARTS);
        for kind in KINDS {
            let mut model = model(&system.driven(kind));
            let (mut by_force, mut by_moment, mut by_shaft, mut travel) = (0.0, 0.0, 0.0, 0.0);
            for i in 0..=PARTS {
                let angle = from + f64::from(i) * step;
                let weight = step / 3.0
                    * match i {
                        0 | PARTS => 1.0,
                        i if i % 2 == 1 => 4.0,
                        _ => 2.0,
                    };
                let [force, speed, moment, omega] = at(&mut model, angle, ["F_d", "v_d", "M_D", system.rate]);
                assert!(close(force * speed, moment * omega, 1e-12), "{kind} at {angle}");
                by_force += weight * force * speed / omega;
                by_moment += weight * moment;
                travel += weight * speed / omega;
                if kind != "cylinder" {
                    let [torque, turns] = at(&mut model, angle, ["T_d", "n_d"]);
                    assert!(close(torque * turns * TAU, moment * omega, 1e-12), "{kind} at {angle}");
                    by_shaft += weight * torque * turns * TAU / omega;
                }
            }
            assert!(close(by_force, by_moment, 1e-12), "{kind}: {by_force} {by_moment}");
            assert!(kind == "cylinder" || close(by_shaft, by_moment, 1e-12), "{kind}");
            if ["cylinder", "rack", "screw", "rope"].contains(&kind) {
                let [longer] = at(&mut model, to, ["L_d"]);
                let [before] = at(&mut model, from, ["L_d"]);
                assert!(
                    close(travel, longer - before, 1e-11),
                    "{kind}: {travel} {}",
                    longer - before
                );
            }
        }
    }
}

/// At one angle of each system by coordinates of anchors, crank and rod: the link's arm lies along the link, whose direction
/// is the coordinate's, or of the ellipsograph's link the other way. What the drive pushes with, the frame carries.
#[test]
fn every_drive_by_hand() {
    for system in &SYSTEMS {
        let angle = system.range.iter().sum::<f64>().to_radians() / 2.0;
        let mut bare = model(&system.bare());
        let [m_d, o1_x, o1_y] = at(&mut bare, angle, ["M_D", "F_O1.x", "F_O1.y"]);
        let link = system.sense * angle;
        let (sin, cos) = Calc::sin_cos(link);
        let (e, joint) = (Point::from(system.e), Point::new(system.s_d * cos, system.s_d * sin));
        let apart = joint - e;
        let distance = length(apart);
        let [r, l] = system.bars;
        // Crank and rod meet on the left of the line from E to the joint.
        let along = (r * r - l * l + distance * distance) / (2.0 * distance);
        let across = (r * r - along * along).sqrt();
        let pin = e + (apart * along + Point::new(-apart.y, apart.x) * across) / distance;
        let (sin, cos) = Calc::sin_cos(100_f64.to_radians());
        for kind in KINDS {
            let (direction, arm) = match kind {
                "sector" => (Point::new(-sin, cos), 4.0),
                "crank" => ((joint - pin) / l, cross(joint, joint - pin) / l),
                _ => (apart / distance, cross(joint, apart) / distance),
            };
            let force = system.sense * m_d / arm;
            let mut model = model(&system.driven(kind));
            let [h_d, found, moment] = at(&mut model, angle, ["h_d", "F_d", "M_D"]);
            assert!(
                close(h_d, arm, 1e-12) && close(found, force, 1e-12),
                "{kind}: {h_d} {arm} {found} {force}"
            );
            assert_eq!(moment.to_bits(), m_d.to_bits());
            let carried = at(&mut model, angle, ["F_O1.x", "F_O1.y"]);
            let scale = o1_x.abs() + o1_y.abs() + force.abs();
            for (without, with, part) in [(o1_x, carried[0], direction.x), (o1_y, carried[1], direction.y)] {
                assert!(
                    (without - with - force * part).abs() <= 1e-13 * scale,
                    "{kind}: {without} {with}"
                );
            }
            let by_shaft = match kind {
                "rack" | "sector" => force * 0.15,
                "screw" => force * 0.014 / TAU,
                "rope" => force * 0.35 / 6.0,
                "crank" => force * cross(pin - e, joint - pin) / l,
                _ => continue,
            };
            let [torque] = at(&mut model, angle, ["T_d"]);
            assert!(close(torque, by_shaft, 1e-12), "{kind}: {torque} {by_shaft}");
            if kind == "rope" {
                // Where it pulls, winding costs more than running out gives back; nothing wound pushes.
                let pull = -force / 6.0;
                let [out, back] = if pull > 0.0 {
                    [pull * 0.9, pull / 0.9]
                } else {
                    [pull / 0.9, pull * 0.9]
                };
                let told = at(&mut model, angle, ["S_l", "S_l.out", "S_l.in", "T_d.out", "T_d.in"]);
                for (told, by_hand) in told.into_iter().zip([pull, out, back, -out * 0.35, -back * 0.35]) {
                    assert!(close(told, by_hand, 1e-12), "{told} {by_hand}");
                }
            }
        }
    }
}

/// Towards an angle at which the line points at the pivot the force grows without bound and the speed falls to nothing; the
/// power stays that of the moment.
#[test]
fn a_line_through_the_pivot() {
    let system = &SYSTEMS[1];
    let dead = 48_f64.to_radians();
    let (sin, cos) = Calc::sin_cos(-dead);
    let place = format!(
        "E_x = \"{:?} m\"\nE_y = \"{:?} m\"\ns_d = \"5 m\"\nchi_d = \"0 deg\"",
        2.0 * cos,
        2.0 * sin
    );
    let mut model = model(&system.with("rack", &place));
    for side in [-1.0, 1.0] {
        let mut last = 0.0;
        for place in 1..12 {
            let angle = dead + side * 0.1_f64.powi(place);
            let [force, speed, moment, omega] = at(&mut model, angle, ["F_d", "v_d", "M_D", "omega"]);
            assert!(close(force * speed, moment * omega, 1e-12), "{place}");
            assert!(force.abs() > 5.0 * last || place < 3, "{place}: {force}");
            last = force.abs();
        }
    }
    // Opposite ways on both sides.
    let [before] = at(&mut model, dead - 1e-6, ["F_d"]);
    let [after] = at(&mut model, dead + 1e-6, ["F_d"]);
    assert!(before * after < 0.0);
}

/// Towards a dead point of the crank the torque falls with the root of the way that is left; the power stays that of the
/// moment. Beyond it the angle is refused by the link's name.
#[test]
fn a_crank_of_the_link_at_its_dead_point() {
    let system = &SYSTEMS[1];
    let text = system
        .driven("crank")
        .replace("\"5.7 m\"", "\"4.7 m\"")
        .replace("\"25 deg\"", "\"40 deg\"");
    let mut model = model(&text);
    let away = |angle: f64| {
        let (sin, cos) = Calc::sin_cos(angle);
        length(Point::new(5.0 * cos + 2.0, 6.0 - 5.0 * sin)) - 7.0
    };
    let (mut inside, mut outside) = (40_f64.to_radians(), 20_f64.to_radians());
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
        let [torque, turns, moment, omega] = at(&mut model, angle, ["T_d", "n_d", "M_D", "omega"]);
        assert!(close(torque * turns * TAU, moment * omega, 1e-12), "{place}");
        let fallen = (torque / last).abs();
        assert!(
            place == 4 || (fallen - 0.1_f64.sqrt()).abs() < 2e-3,
            "{place}: {fallen}"
        );
        last = torque;
    }
    model.set(0, inside - 1e-6).expect("the boom is there");
    let force = index(&model, "F_d");
    let refused = model.get(force).expect_err("beyond the dead point").message;
    assert!(
        refused.starts_with("theta_l = ") && refused.contains("crank and rod do not meet there"),
        "{refused}"
    );
}

/// At the level `table` every result keeps to its tolerance.
#[test]
fn a_table_of_every_drive() {
    for system in &SYSTEMS[1..] {
        let [from, to] = system.range.map(f64::to_radians);
        for kind in KINDS {
            let scene = Scene::parse(&system.driven(kind)).expect("legal");
            let mut exact = scene.model().expect("exists");
            let mut table = scene.at("table").model().expect("exists");
            for name in ["F_d", "v_d", "T_d", "T_d.out", "T_d.in", "F_O1.x"] {
                if kind == "cylinder" && name.starts_with('T') {
                    continue;
                }
                let sample = |model: &mut Model| -> Vec<f64> {
                    let angle = |i: u32| from + (to - from) * f64::from(i) / 97.0;
                    (0..=97).map(|i| at(model, angle(i), [name])[0]).collect()
                };
                let (all, found) = (sample(&mut exact), sample(&mut table));
                let ends = all.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], x| {
                    [least.min(*x), most.max(*x)]
                });
                let size = ends[1] - ends[0];
                for (x, y) in all.iter().zip(&found) {
                    assert!((x - y).abs() <= 1e-6 * size.max(x.abs()), "{kind} {name}: {x} {y}");
                }
            }
        }
    }
}

/// A rope behind a boom without a balance pulls all over its range; in front of it, it would have to push.
#[test]
fn a_rope_that_would_have_to_push() {
    let trunk = &SYSTEMS[2];
    let mut least = [0.0; 2];
    for (least, [x, y]) in least.iter_mut().zip([[-3.7, 8.2], [6.0, -2.0]]) {
        let text = System { e: [x, y], ..*trunk }.driven("rope");
        let (balance, limits) = ("[luffing.balance]", "[luffing.limits]");
        let [balance, limits] = [balance, limits].map(|table| text.find(table).expect("there"));
        let text = format!("{}{}", &text[..balance], &text[limits..]);
        let sheet = Scene::parse(&text).expect("legal").sheet();
        let pulls = sheet
            .checks()
            .find(|check| check.id == "drive_pulls")
            .expect("asked of every rope");
        assert_eq!(pulls.passed(), pulls.value >= 0.0);
        let [from, to] = trunk.range.map(f64::to_radians);
        let mut model = model(&text);
        let pull = |i: u32| at(&mut model, from + (to - from) * f64::from(i) / 500.0, ["S_l"])[0];
        let by_scan = (0..=500).map(pull).fold(f64::INFINITY, f64::min);
        assert!(
            (pulls.value - by_scan).abs() <= 1e-4 * by_scan.abs(),
            "{} {by_scan}",
            pulls.value
        );
        *least = pulls.value;
    }
    assert!(least[0] > 0.0 && least[1] < 0.0, "{least:?}");
}

/// What a drive has too much or too little, what it does not reach, and where there is none.
#[test]
fn what_cannot_be_is_refused() {
    const ROPE: &str = include_str!("../scenes/rope_luffing.toml");
    let [_, guide, trunk] = &SYSTEMS;
    let moving = guide.driven("rack").replace(
        "[luffing.balance]",
        "[luffing.dynamics]\nJ_b = \"900000 kg.m2\"\nJ_l = \"90000 kg.m2\"\n\n[luffing.balance]",
    );
    let moving = moving.replace("Q    =", "fidelity = \"rigid\"\nQ    =");
    for (text, said) in [
        (
            guide.driven("crank").replace("\"5.7 m\"", "\"4.7 m\""),
            "crank and rod do not meet over the whole working range",
        ),
        (
            trunk.driven("crank").replace("\"7.2 m\"", "\"30 m\""),
            "crank and rod meet the anchor on the driving link at no angle",
        ),
        (
            trunk.driven("rack").replace("chi_d", "#"),
            "`chi_d` is missing in [luffing.drive] of the kind \"rack\"",
        ),
        (
            guide.driven("sector").replace("r_s ", "s_d = \"3 m\"\nr_s "),
            "a sector has no s_d",
        ),
        (
            guide.driven("cylinder").replace("\"220 mm\"", "\"420 mm\""),
            "the rod d_r = 420 mm does not fit",
        ),
        (
            guide
                .driven("rack")
                .replace("epsilon_Y =", "lock_d = \"1 deg\"\nepsilon_Y ="),
            "a limit lock_d",
        ),
        (moving, "at rest alone"),
        (
            guide.driven("rope").replace("m_r", "#"),
            "`m_r` is missing in [luffing.drive] of the kind \"rope\"",
        ),
        (
            guide.driven("rack").replace("r_z ", "r_tr = \"1 m\"\nr_z "),
            "a rack has no r_tr, which is of a rope",
        ),
        (format!("{ROPE}\n[luffing.drive]\nkind = \"rack\"\n"), "drive"),
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

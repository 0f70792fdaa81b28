//! Speed against accuracy of the default crane at each level.

use lemnis_models::scene::Scene;
use lemnis_trade::realtime::Paces;
use lemnis_trade::setting::{Method, Setting, index};
use lemnis_trade::trade::{Failure, SAMPLE, Trade};

#[path = "../../tests/common/levels.rs"]
mod levels;

/// The default scene with these tables, a quick cycle over a part of the range, and a line at its top.
fn scene(level: &str, top: &str) -> Scene {
    let text = levels::scene(level)
        .text()
        .replacen("[project]", &format!("{top}\n[project]"), 1);
    let mut lines: Vec<&str> = text.lines().collect();
    lines.retain(|line| !line.starts_with("M_A ") && !line.starts_with("u_v "));
    let text = lines
        .join("\n")
        .replacen("to    = \"120 deg\"", "to    = \"80 deg\"", 1);
    let text = text.replacen("speed = \"1 deg/s\"", "speed = \"4 deg/s\"", 1);
    Scene::parse(&text).unwrap_or_else(|found| panic!("{found:?}\n{text}"))
}

fn trade(scene: &Scene) -> Trade {
    Trade::new(scene, SAMPLE, 0, &|| {}).unwrap_or_else(|failure| panic!("{failure}"))
}

/// All levels run, two codes agree on each, and what is measured is the same again.
#[test]
fn every_level_has_a_reference_of_two_codes() {
    let scene = scene("hydraulic with swing", "");
    let steps = std::cell::Cell::new(0);
    let first = Trade::new(&scene, SAMPLE, 0, &|| steps.set(steps.get() + 1)).expect("agrees");
    assert_eq!(steps.get(), Trade::steps(&scene, SAMPLE));
    let found: Vec<&str> = first.references.iter().map(|reference| reference.level).collect();
    assert_eq!(found, ["table", "static", "rigid", "swing", "hydraulic"]);
    for reference in &first.references[2..] {
        let apart = reference.apart.as_ref().expect("two codes");
        println!("{}: {apart:?}", reference.level);
        // Far below what a user sees; explicit levels agree to rounding.
        assert!(apart.part < if reference.level == "hydraulic" { 1e-7 } else { 1e-10 });
    }
    let second = trade(&scene);
    assert!(first.rows.iter().zip(&second.rows).all(|(a, b)| {
        (a.setting, a.work, a.cost, &a.errors, a.front) == (b.setting, b.work, b.cost, &b.errors, b.front)
    }));
}

/// The ready-made portal crane runs against its upper stop at 63.5 s: the head's blow lets go of the load, which the
/// rope catches 4.6 ms later. The second code looks every 5 ms and met both within one look.
#[test]
fn a_load_that_is_caught_at_once() {
    let scene = Scene::parse(include_str!("../../scenes/portal_004_motion.toml")).expect("reads");
    let found = trade(&scene);
    for reference in &found.references[2..] {
        let apart = reference.apart.as_ref().expect("two codes");
        println!("{}: {apart:?}", reference.level);
        assert!(apart.part < 1e-9, "{}: {apart:?}", reference.level);
    }
}

/// Runge and Kutta's fourth order, seen in the errors: half the step, a sixteenth of the error.
#[test]
fn the_order_of_the_solver_is_seen() {
    let found = trade(&scene("swing", "accuracy = { \"phi_R\" = \"1 deg\" }"));
    let error = |step| {
        let setting = |row: &&lemnis_trade::trade::Row| {
            row.setting
                == Setting {
                    level: "swing",
                    method: Method::Explicit(step),
                }
        };
        let row = found.rows.iter().find(setting).expect("ran");
        row.errors[0].expect("modelled").numerical.max
    };
    let order = (error(0.1) / error(0.05)).log2();
    println!("order {order}");
    assert!((order - 4.0).abs() < 0.5);
    assert!(error(0.01) < 1e-9);
}

/// The cheapest that is good enough: coarse demands are met by a level without states, a swinging load needs one
/// that has it, and what no level reaches is named.
#[test]
fn the_choice_follows_the_demand() {
    let level = |accuracy: &str| {
        let found = trade(&scene("swing", accuracy));
        found.choice().map(|row| row.setting.level)
    };
    assert_eq!(level("accuracy = { \"A.x\" = \"1 m\" }"), Some("table"));
    assert_eq!(level("accuracy = { \"A.x\" = \"1 mm\" }"), Some("swing"));
    assert_eq!(
        level("accuracy = { \"A.x\" = \"1 m\", \"phi_R\" = \"1 deg\" }"),
        Some("swing")
    );
    let found = trade(&scene("swing", "accuracy = { \"A.x\" = \"1e-9 mm\" }"));
    assert!(found.choice().is_none());
    let (best, missed) = found.missed().expect("measured");
    assert_eq!((best.setting.level, missed.len(), missed[0].result), ("swing", 1, 0));
    assert!(missed[0].off > 1e-12);
}

/// Errors are what an independent comparison of two runs gives: the sum of the two parts bounds the whole.
#[test]
fn errors_add_up() {
    let found = trade(&scene("swing", ""));
    for row in &found.rows {
        for errors in row.errors.iter().flatten() {
            let bound = errors.numerical.max + errors.modelling.max;
            assert!(errors.total.max <= bound * (1.0 + 1e-12) + 1e-15, "{}", row.setting);
            assert!(errors.total.rms <= errors.total.max * (1.0 + 1e-12));
        }
    }
}

/// A scene's own command: levels without it are led along and are no substitute.
#[test]
fn a_command_of_the_scene_is_kept() {
    let text = levels::scene("hydraulic")
        .text()
        .replacen("to    = \"120 deg\"", "to    = \"63 deg\"", 1);
    let found = trade(&Scene::parse(&text).expect("reads"));
    assert_eq!((found.command, found.duration), (Some("u_v"), 3.0));
    assert!(
        found
            .rows
            .iter()
            .all(|row| row.follows == (row.setting.level != "hydraulic"))
    );
    assert!(found.rows.iter().any(|row| row.front) && found.rows.iter().all(|row| !(row.front && row.follows)));
}

/// The second code uses nothing of the first one's solver: with the tolerance of the first ruined, they part, and
/// the message names both numbers.
#[test]
fn two_codes_that_part_are_named() {
    use lemnis_trade::library::Library;
    let scene = scene("hydraulic", "");
    let setting = Setting::fine(&scene, "hydraulic");
    let mut coarse = Setting {
        method: Method::Implicit(0.1),
        ..setting
    }
    .model(&scene, 0.1)
    .expect("built");
    let mut fine = setting.model(&scene, 0.1).expect("built");
    let mut library = setting.model(&scene, 0.1).expect("built");
    let valve = index(&fine, "u_v").expect("exists");
    for model in [&mut coarse, &mut fine, &mut library] {
        model.set(valve, 0.3).expect("allowed");
    }
    coarse.advance(0.0, 0.1).expect("moves");
    fine.advance(0.0, 0.1).expect("moves");
    let mut solver = Library::new(&library, setting.method, 0.1);
    solver.advance(&mut library, setting.method, 0.0, 0.1).expect("moves");
    let pressure = index(&fine, "p_A").expect("exists");
    let [coarse, fine, library] = [coarse, fine, library].map(|mut model| model.get(pressure).expect("exists"));
    assert!((fine - library).abs() < 1e-6 * fine, "{fine} {library}");
    assert!(
        (coarse - library).abs() > 100.0 * (fine - library).abs(),
        "{coarse} {fine} {library}"
    );

    let apart = lemnis_trade::trade::Apart {
        result: "p_A".into(),
        time: 0.1,
        values: [1e5, 2e5],
        part: 0.5,
    };
    let symbol = levels::model("hydraulic").variables()[pressure].symbol;
    let message = Failure::Apart("hydraulic", apart, symbol).to_string();
    assert!(
        message.contains("p_A at 0.1 s is 0.1 MPa by our solver and 0.2 MPa"),
        "{message}"
    );
}

/// Eight cylinders with the PLC: the command is an input at both levels, the samples are events of the second code too.
#[test]
fn a_steering_with_its_plc() {
    let text = include_str!("../../scenes/boat_hoist_003_hydraulic.toml");
    let (before, motion) = text.split_once("[steering.motion]").expect("there");
    let (motion, after) = motion.split_once("\n\n").expect("an empty line");
    let motion = motion
        .lines()
        .map(|line| match line.split('=').next().unwrap_or_default().trim() {
            "to" => "to = \"-9 deg\"",
            "step" => "step = \"0.5 deg\"",
            _ => line,
        });
    let motion: Vec<&str> = motion.collect();
    let accuracy = "accuracy = { \"theta[1]\" = \"0.1 deg\" }\n";
    let text = format!("{accuracy}{before}[steering.motion]{}\n\n{after}", motion.join("\n"));
    let scene = Scene::parse(&text).unwrap_or_else(|found| panic!("{found:?}"));
    let found = trade(&scene);
    let apart = found.references[1].apart.as_ref().expect("two codes");
    println!("{apart:?}");
    assert!(found.references[1].level == "hydraulic" && apart.part < 1e-6);
    let off = |row: &lemnis_trade::trade::Row| row.errors[0].expect("modelled");
    let (first, last) = (&found.rows[1], &found.rows[found.rows.len() - 1]);
    // The cylinders lag behind the command; finer tolerances are dearer and nearer.
    assert!(off(&found.rows[0]).modelling.max > 1e-4 && found.rows[0].setting.level == "kinematic");
    assert!(off(first).numerical.max > 10.0 * off(last).numerical.max && first.cost < last.cost);
}

/// Steps of a millisecond: what one takes is bounded, whatever happens in it, and every turn of the motion is the same.
#[test]
fn communication_steps_are_bounded() {
    let scene = scene("swing", "");
    let steps = 150_000;
    let paces = Paces::new(&scene, 1e-3, steps, &|| {}).unwrap_or_else(|fault| panic!("{}", fault.message));
    let found: Vec<&str> = paces.levels.iter().map(|pace| pace.level).collect();
    assert_eq!(found, ["table", "static", "rigid", "swing"]);
    for pace in &paces.levels {
        println!("{pace:?}");
        assert!(0.0 < pace.median && pace.median <= pace.nearly_all && pace.nearly_all <= pace.worst);
        assert!(pace.rates <= pace.most_rates);
    }
    // A step of RK4 has four, and as many more each time that an event is located: fewer than 64 halvings of one step.
    for pace in &paces.levels[2..] {
        assert!((4..=4 * 64).contains(&pace.most_rates), "{pace:?}");
    }
    assert!(paces.levels[..2].iter().all(|pace| pace.most_rates == 0));
    // What no machine keeps to.
    let hurried = Paces { sample: 0.0, ..paces };
    assert!(hurried.largest().is_none());
}

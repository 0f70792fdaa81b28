//! The hopper of a crane: closed forms at any contents, what an event leaves, the same bits for any steps, no mass lost.

#[path = "common/named.rs"]
mod named;

use lemnis_models::component::model::Model;
use lemnis_models::hopper::flow::decided;
use lemnis_models::scene::Scene;

use named::{get, index, model, near, set};

const READY: &str = include_str!("../scenes/hopper.toml");

fn still() -> String {
    let (head, rest) = READY.split_once("m_h   =").expect("its start");
    let (_, rest) = rest.split_once("[hopper.motion]").expect("its range");
    format!("{head}\n[hopper.motion]{rest}").replace("fidelity = \"flow\"", "fidelity = \"static\"")
}

/// With a grab of 8 t each 60 s and a feeder that takes 125 kg/s, at contents of 10 t; slower, the grab feeds it no more.
#[test]
fn the_steady_balance() {
    let mut still = model(&still());
    set(&mut still, "m_h", 10e3);
    let wanted = [
        ("q_g", 8e3 / 60.0),
        ("k_q", 16.0 / 15.0),
        ("t_c_max", 64.0),
        ("m_br", 11_250.0),
        ("d_m", 7e3),
        ("m_need", 18_250.0),
        ("m_res", 5_750.0),
        ("V_max", 24e3 / 850.0),
        ("G_h", 98_100.0),
        ("phi_h", 10.0 / 24.0),
        ("V_h", 10e3 / 850.0),
        ("n_g", 1.75),
        ("t_run", 80.0),
        ("t_full", 14e3 / (25.0 / 3.0)),
    ];
    for (name, wanted) in wanted {
        near(get(&mut still, name), wanted, 1e-13 * wanted);
    }
    assert_eq!(get(&mut still, "t_low"), f64::INFINITY);
    set(&mut still, "t_c", 80.0);
    near(get(&mut still, "t_low"), 400.0, 1e-10);
    assert_eq!(get(&mut still, "t_full"), f64::INFINITY);
    // The feeder takes more than the grab brings while it empties itself: the pause alone counts.
    set(&mut still, "t_d", 70.0);
    near(get(&mut still, "d_m"), -750.0, 1e-9);
    near(get(&mut still, "m_need"), 11_250.0, 1e-9);
    for contents in [-1.0, 24_000.1] {
        set_anyway(&mut still, contents);
    }
}

/// Contents that no hopper has are refused, and what was there stays.
fn set_anyway(model: &mut Model, contents: f64) {
    let at = index(model, "m_h");
    let before = get(model, "G_h");
    let weight = index(model, "G_h");
    let fault = model
        .set(at, contents)
        .and_then(|()| model.get(weight))
        .expect_err("no hopper");
    assert!(fault.message.contains("m_h = "), "{}", fault.message);
    set(model, "m_h", 10e3);
    assert_eq!(get(model, "G_h"), before);
}

#[test]
fn what_an_event_decides() {
    for (contents, gain, mode) in [
        (24.0, 1.0, 1.0),
        (24.0, 0.0, 1.0),
        (24.0, -1.0, 0.0),
        (0.0, -1.0, -1.0),
        (0.0, 0.0, -1.0),
        (0.0, 1.0, 0.0),
        (12.0, 1.0, 0.0),
    ] {
        assert_eq!(decided(contents, 24.0, gain), mode);
    }
}

/// The run of the ready scene in steps of a length, with what it has at 660 s.
fn run(step: f64) -> [u64; 4] {
    let mut model = model(READY);
    let mut at = 0.0;
    while at < 660.0 {
        let next = (at + step).min(660.0);
        model.advance(at, next).expect("runs");
        let [held, into, out, spilled] = ["m_h", "m_in", "m_out", "m_s"].map(|name| get(&mut model, name));
        near(held + out + spilled, 10e3 + into, 1e-12 * 74e3);
        assert!((0.0..=24e3).contains(&held), "{held}");
        at = next;
    }
    ["m_h", "m_in", "m_out", "m_s"].map(|name| get(&mut model, name).to_bits())
}

#[test]
fn any_step_gives_the_same_bits() {
    let found = run(0.5);
    let wanted = [13_250.0, 64e3, 55_250.0, 5_500.0];
    for (found, wanted) in found.map(f64::from_bits).into_iter().zip(wanted) {
        near(found, wanted, 1e-8);
    }
    for step in [0.37, 7.0, 660.0] {
        assert_eq!(run(step), found, "{step}");
    }
}

/// What an importer's step leaves beyond an end is spilled, or was not taken.
#[test]
fn nothing_is_lost_beyond_an_end() {
    let (head, rest) = READY.split_once("q_in  =").expect("commands");
    let (_, rest) = rest.split_once("[hopper.motion]").expect("its range");
    let mut model = model(&format!("{head}\n[hopper.motion]{rest}"));
    for (contents, held, out, spilled) in [(24_001.0, 24e3, 0.0, 1.0), (-2.0, 0.0, -2.0, 0.0)] {
        model.set_states(&[contents, 0.0, 0.0, 0.0]).expect("finite");
        assert!(model.event().expect("decided"), "it jumps");
        for (name, wanted) in [("m_h", held), ("m_out", out), ("m_s", spilled)] {
            near(get(&mut model, name), wanted, 1e-9);
        }
        assert!(!model.event().expect("decided"), "it is decided");
    }
}

/// The book's checks are passed, and the levels are what the scene has.
#[test]
fn the_ready_scene() {
    let scene = Scene::parse(READY).unwrap_or_else(|mistakes| panic!("{mistakes:?}"));
    assert_eq!(scene.levels(), ["static", "flow"]);
    let sheet = scene.sheet();
    assert_eq!(sheet.identities.len(), 2);
    for check in sheet.identities.iter().chain(&sheet.requirements) {
        assert!(check.passed(), "{} by {}", check.id, check.value);
    }
    assert!(sheet.cycle.is_some_and(|cycle| cycle.ended.is_none()));
}

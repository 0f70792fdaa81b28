//! A crane that is slewed at a given speed while it luffs: centrifugal forces as load cases have them, for every luffing system,
//! balance and drive; as a crane that slews by itself at that speed; equilibrium and energy.

#[path = "common/balances.rs"]
#[allow(dead_code, reason = "not every test uses all of it")]
mod balances;
#[path = "common/driven.rs"]
#[allow(dead_code, reason = "not every test uses all of it")]
mod driven;
#[path = "common/named.rs"]
#[allow(dead_code, reason = "not every test uses all of it")]
mod named;

use std::f64::consts::TAU;

use driven::{blown, moving};
use lemnis_models::component::model::Model;
use lemnis_models::kernel::variable::Role;
use lemnis_models::scene::Scene;
use named::{get, model, set};

/// Places over the working range, of no particular kind.
const PARTS: [f64; 5] = [0.031, 0.2718, 0.5772, 0.7321, 0.9431];
/// Slewing speed of the cases of every system, in 1/s.
const SPEED: f64 = 1.3 / 60.0;
/// Gravity of the systems (m/s²).
const G: f64 = 9.81;

/// All but a counterweight on a straight rail, whose distance from the slewing axis is not known.
fn slewed() -> impl Iterator<Item = (String, String)> {
    blown().filter(|(_, text)| !text.contains("straight_rail"))
}

/// At a place of the working range, as a part of it.
fn at(model: &mut Model, part: f64) -> f64 {
    let places = model.positions();
    let (from, to) = (places[0], places[places.len() - 1]);
    let place = from + part * (to - from);
    model.set(0, place).expect("within the range");
    place
}

/// Square of the load's distance from the slewing axis at a place (rad), changed by the coordinate: by differences of the sixth
/// order.
fn twice_reach_times_travel(still: &mut Model, place: f64) -> f64 {
    let step = 2e-3;
    let mut square = |by: f64| {
        still.set(0, place + by * step).expect("in reach");
        get(still, "R").powi(2)
    };
    let [near, next, far] = [1.0, 2.0, 3.0].map(|by| square(by) - square(-by));
    (45.0 * near - 9.0 * next + far) / (60.0 * step)
}

#[test]
fn the_moment_is_that_of_the_cases_and_of_the_load_at_the_head() {
    let omega = TAU * SPEED;
    for (name, text) in slewed() {
        let text = text.replace("\"0.8\"", "\"1\"");
        let mut still = model(&text);
        let mut moves = model(&moving(&text, "rigid", "n_sm = \"1.3 1/min\""));
        let load = get(&mut still, "Q") / G;
        for part in PARTS {
            let place = at(&mut moves, part);
            at(&mut still, part);
            let bodies = get(&mut still, "M_r_centrifugal[1]");
            let found = get(&mut moves, "M_Omega");
            let wanted = bodies + 0.5 * omega * omega * load * twice_reach_times_travel(&mut still, place);
            assert!(bodies != 0.0 && wanted != bodies, "{name}");
            let size = bodies.abs().max(wanted.abs());
            assert!((found - wanted).abs() <= 1e-9 * size, "{name}: {found} {wanted}");
        }
    }
}

/// A free crane under a moment of its slewing drive that keeps its speed moves as one that is slewed so, and its pins carry the
/// same.
#[test]
fn a_crane_that_slews_by_itself_at_that_speed_luffs_the_same() {
    let pins = [
        "F_B.x", "F_B.y", "F_C.x", "F_C.y", "F_O1.x", "F_O1.y", "F_O3.x", "F_O3.y",
    ];
    let all = slewed().filter(|(_, text)| text.contains("\"jib\""));
    let mut looked = 0;
    for (name, text) in all {
        let given = "M_A = \"9 MN.m\"\nn_sm = \"1.3 1/min\"\n";
        let own =
            "M_A = \"9 MN.m\"\n[luffing.slewing]\nJ_sl = \"5000 t.m2\"\nomega_sl = \"0.1361356816555577 rad/s\"\n";
        let mut given = model(&moving(&text, "rigid", given));
        let mut own = model(&moving(&text, "rigid", own));
        let speed = get(&mut own, "omega_sl");
        assert!((speed / TAU / SPEED - 1.0).abs() < 1e-15, "{speed}");
        let rate = given.variables().iter().find(|v| v.symbol.id.starts_with("der(omega"));
        let rate = rate.expect("a rate").name();
        let driven = given.variables()[0].name().replace("theta", "omega");
        for part in PARTS {
            for model in [&mut given, &mut own] {
                at(model, part);
                set(model, &driven, 0.021);
                model.update().expect("closes");
            }
            for told in pins.iter().copied().chain([rate.as_str()]) {
                let [one, other] = [&mut given, &mut own].map(|model| get(model, told));
                let size = if told == rate { one.abs() } else { 3e6 };
                assert!(
                    one != 0.0 && (one - other).abs() <= 1e-12 * size,
                    "{name}, {told}: {one} {other}"
                );
            }
            looked += 1;
        }
    }
    assert!(looked >= 20, "{looked}");
}

/// In the manoeuvres of the book: equilibrium of all bodies asks for the moment that the drive gives, and no energy is lost.
#[test]
fn equilibrium_of_the_bodies_has_the_centrifugal_forces() {
    for (name, text) in slewed() {
        let more = "M_A = \"9 MN.m\"\nM_S = \"9 MN.m\"\np_wm = \"350 Pa\"\nsigma_m = \"2 deg\"\nn_sm = \"1.4 1/min\"\n";
        let text = moving(&text, "rigid", more);
        let scene = Scene::parse(&text).unwrap_or_else(|found| panic!("{name}: {found:?}"));
        let sheet = scene.sheet();
        let checks = sheet.identities.iter().filter(|check| check.id.starts_with("motion_"));
        let mut told = 0;
        for check in checks {
            let most = if check.id == "motion_forces" { 1e-11 } else { 1e-5 };
            assert!(check.value <= most, "{name}: {} {:e}", check.id, check.value);
            told += 1;
        }
        assert_eq!(told, 2, "{name}");
    }
}

/// A cylinder's oil sees the same moment: what slewing changes of the acceleration.
#[test]
fn beside_oil_it_is_the_same_moment() {
    let scene = include_str!("../scenes/luffing_cylinder.toml");
    let alone = |line: &&str| !["l_R ", "c_v ", "M_F "].iter().any(|key| line.starts_with(key));
    let lines = scene.lines().filter(alone).map(|line| line.to_owned() + "\n");
    let told = lines
        .collect::<String>()
        .replacen("[luffing.dynamics]", "[luffing.dynamics]\nn_sm = \"0 1/min\"", 1);
    let mut oil = model(&told);
    let rigid = driven::without(&told, "luffing.hydraulics");
    let mut bare = model(&rigid.replace("\"hydraulic\"", "\"rigid\""));
    for part in PARTS {
        let changes = [&mut oil, &mut bare].map(|model| {
            at(model, part);
            set(model, "omega_1", 0.021);
            model.update().expect("closes");
            let [still, slewed] = [0.0, SPEED].map(|speed| {
                set(model, "n_sm", speed);
                get(model, "der(omega_1)")
            });
            slewed - still
        });
        assert!(
            changes[0] != 0.0 && (changes[0] - changes[1]).abs() <= 1e-12 * changes[0].abs(),
            "{changes:?}"
        );
    }
}

/// No slewing changes no bit of what moves.
#[test]
fn a_speed_of_nought_changes_nothing() {
    for (name, text) in slewed().filter(|(name, _)| ["lever", "guided", "compensated"].contains(&name.as_str())) {
        let told = "M_A = \"9 MN.m\"\n";
        let mut with = model(&moving(&text, "rigid", &format!("{told}n_sm = \"0 1/min\"\n")));
        let mut without = model(&moving(&text, "rigid", told));
        for i in 0..50 {
            for model in [&mut with, &mut without] {
                let (from, to) = (f64::from(i) / 20.0, f64::from(i + 1) / 20.0);
                model.advance(from, to).expect("moves");
            }
        }
        let states = without
            .variables()
            .iter()
            .filter(|variable| variable.role == Role::State);
        for state in states.map(|state| state.name()).collect::<Vec<_>>() {
            let [one, other] = [&mut with, &mut without].map(|model| get(model, &state).to_bits());
            assert_eq!(one, other, "{name}: {state}");
        }
    }
}

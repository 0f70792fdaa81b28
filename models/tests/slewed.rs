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
        "F_B.x", "F_B.y", "F_C.x", "F_C.y", "F_O1.x", "F_O1.y", "F_O3.x", "F_O3.y", "N_t", "N_l", "T_dyn", "S_h", "N_b",
    ];
    let mut looked = 0;
    for (name, text) in slewed() {
        // More would take the pull out of a tie.
        let lift = if name == "trunk" { "200 kN.m" } else { "9 MN.m" };
        let given = format!("M_A = \"{lift}\"\nn_sm = \"1.3 1/min\"\n");
        let own = format!(
            "M_A = \"{lift}\"\n[luffing.slewing]\nJ_sl = \"5000 t.m2\"\nomega_sl = \"0.1361356816555577 rad/s\"\n"
        );
        let mut given = model(&moving(&text, "rigid", &given));
        let mut own = model(&moving(&text, "rigid", &own));
        let speed = get(&mut own, "omega_sl");
        assert!((speed / TAU / SPEED - 1.0).abs() < 1e-15, "{speed}");
        let rate = given.variables().iter().find(|v| v.symbol.id.starts_with("der(omega"));
        let rate = rate.expect("a rate").name();
        let coordinate = given.variables()[0].name();
        let driven = match coordinate.as_str() {
            "phi" => "omega".to_owned(),
            of_link => of_link.replace("theta", "omega"),
        };
        let here: Vec<_> = pins
            .iter()
            .filter(|pin| given.variables().iter().any(|v| v.name() == **pin))
            .collect();
        assert!(here.len() >= 4, "{name}");
        for part in PARTS {
            for model in [&mut given, &mut own] {
                at(model, part);
                set(model, &driven, 0.021);
                model.update().expect("closes");
            }
            for told in here.iter().map(|pin| **pin).chain([rate.as_str()]) {
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
    assert!(looked >= 40, "{looked}");
}

/// Whether in the book's manoeuvres of a scene equilibrium of all bodies asks for the moment that the drive gives, and no energy is
/// lost.
fn adds_up(name: &str, text: &str) {
    let scene = Scene::parse(text).unwrap_or_else(|found| panic!("{name}: {found:?}"));
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

/// In the manoeuvres of the book: equilibrium of all bodies asks for the moment that the drive gives, and no energy is lost.
#[test]
fn equilibrium_of_the_bodies_has_the_centrifugal_forces() {
    for (name, text) in slewed() {
        let more = "M_A = \"9 MN.m\"\nM_S = \"9 MN.m\"\np_wm = \"350 Pa\"\nsigma_m = \"2 deg\"\nn_sm = \"1.4 1/min\"\n";
        let text = moving(&text, "rigid", more);
        adds_up(&name, &text);
    }
}

/// With a boom and its trunk that lead the load's rope over sheaves.
fn leading() -> impl Iterator<Item = (String, String)> {
    let sheave = |on: &str, x: f64, y: f64| {
        format!("[[luffing.rope.sheave]]\non = \"{on}\"\nx_r = \"{x} m\"\ny_r = \"{y} m\"\n")
    };
    let (on_trunk, on_frame) = (sheave("trunk", -1.0, 1.5), sheave("frame", -5.0, 11.0));
    let rope = format!("\n[luffing.rope]\nm_h = \"4\"\nh_Q = \"12 m\"\n{on_trunk}{on_frame}");
    let led = slewed().filter(|(name, _)| name == "trunk");
    slewed().chain(led.map(move |(_, text)| ("led".to_owned(), text + &rope)))
}

/// The same of a single boom while it slews by itself, rigid and with a load that swings, in wind and on a slope.
#[test]
fn so_has_a_crane_that_slews_by_itself() {
    let slope = "[luffing.slewing.slope]\ngamma_s = \"2 deg\"\nG_u = \"900 kN\"\nr_u = \"-1.5 m\"\n";
    let slewing = "[luffing.slewing]\nJ_sl = \"5000 t.m2\"\nM_sl = \"90 kN.m\"\nA_ws = \"30 m2\"\nr_ws = \"6 m\"\npsi_sl = \"40 deg\"\n";
    let air = "[luffing.air]\nv_air = \"7 m/s\"\nchi_air = \"50 deg\"\n";
    let rope = "[luffing.hoisting]\nl_R = \"12 m\"\nv_h = \"0.1 m/s\"\na_h = \"0.3 m/s2\"\n";
    for (name, text) in leading().filter(|(_, text)| !text.contains("\"jib\"")) {
        let own = format!("M_A = \"9 MN.m\"\nM_S = \"9 MN.m\"\nstep = \"1 ms\"\n{slewing}{slope}{air}");
        let swings = format!("{own}{rope}");
        for (level, more) in [("rigid", own), ("swing", swings)] {
            let text = moving(&text, level, &more);
            adds_up(&format!("{name}, {level}"), &text);
        }
    }
}

/// Moments of a slope on both joints belong to one height of the weights: what the one changes by the other's coordinate, the other
/// does by its own; at a quarter turn the plane is level, and ahead of the slope it is that of a crane which does not turn.
#[test]
fn a_slope_is_one_height_of_all_weights() {
    let slope = "[luffing.slewing]\nJ_sl = \"5000 t.m2\"\n[luffing.slewing.slope]\ngamma_s = \"3 deg\"\nG_u = \"900 kN\"\n\
        r_u = \"-1.5 m\"\n";
    for (name, text) in leading() {
        let mut leans = model(&moving(&text, "rigid", &format!("M_A = \"9 MN.m\"\n{slope}")));
        let mut flat = model(&moving(&text, "rigid", "M_A = \"9 MN.m\"\nsigma_m = \"3 deg\"\n"));
        for part in PARTS {
            let place = at(&mut leans, part);
            let step = 1e-3;
            let mut moments = |theta: f64, psi: f64| {
                leans.set(0, theta).expect("within reach");
                set(&mut leans, "psi_sl", psi);
                ["M_gammal", "M_gamma"].map(|told| get(&mut leans, told))
            };
            let sixth = |of: &mut dyn FnMut(f64) -> f64| {
                let [near, next, far] = [1.0, 2.0, 3.0].map(|by| of(by * step) - of(-by * step));
                (45.0 * near - 9.0 * next + far) / (60.0 * step)
            };
            let psi = 0.7;
            let lifting = sixth(&mut |by| moments(place, psi + by)[0]);
            let turning = sixth(&mut |by| moments(place + by, psi)[1]);
            let ahead = moments(place, 0.0);
            assert!(
                turning != 0.0 && (lifting - turning).abs() <= 1e-9 * turning.abs().max(ahead[0].abs()),
                "{name}: {lifting} {turning}"
            );
            assert_eq!(ahead[1], 0.0, "{name}");
            at(&mut flat, part);
            let plane = get(&mut flat, "M_slope");
            assert!(
                (ahead[0] - plane).abs() <= 1e-12 * plane.abs(),
                "{name}: {} {plane}",
                ahead[0]
            );
        }
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

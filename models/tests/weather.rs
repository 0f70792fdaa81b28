//! Wind on the bodies of a mechanism and the slope of the ground, in motion: the same moments as in load cases, forces by
//! Newton and Euler, for every luffing system, balance and drive; energy.

#[path = "common/balances.rs"]
#[allow(dead_code, reason = "not every test uses all of it")]
mod balances;
#[path = "common/driven.rs"]
#[allow(dead_code, reason = "not every test uses all of it")]
mod driven;
#[path = "common/named.rs"]
#[allow(dead_code, reason = "not every test uses all of it")]
mod named;

use driven::{blown, moving};
use lemnis_models::component::model::Model;
use lemnis_models::kernel::variable::Role;
use lemnis_models::scene::Scene;
use named::{get, index, model, set};

/// Places over the working range, of no particular kind.
const PARTS: [f64; 5] = [0.031, 0.2718, 0.5772, 0.7321, 0.9431];
/// Wind and slope of both cases of every system.
const WEATHER: [(f64, f64); 2] = [(17.0, 1.0), (-17.0, -1.0)];

/// At rest at a part of the working range.
fn at(model: &mut Model, part: f64) {
    let places = model.positions();
    let (from, to) = (places[0], places[places.len() - 1]);
    model.set(0, from + part * (to - from)).expect("within the range");
}

/// Every system at rest and, at level rigid with more keys of its dynamics, in motion: with all of the load, at places of the
/// range, under the weather of each case, of which the number is told.
fn in_every_case(more: &str, mut look: impl FnMut(&str, usize, [&mut Model; 2])) {
    for (name, text) in blown() {
        let mut still = model(&text.replace("\"0.8\"", "\"1\""));
        let mut moves = model(&moving(&text, "rigid", more));
        for (case, (wind, slope)) in (1..).zip(WEATHER) {
            set(&mut moves, "v_wm", wind);
            set(&mut moves, "sigma_m", f64::to_radians(slope));
            for part in PARTS {
                at(&mut still, part);
                at(&mut moves, part);
                look(&name, case, [&mut still, &mut moves]);
            }
        }
    }
}

#[test]
fn moments_of_wind_and_slope_are_those_of_the_same_case() {
    in_every_case("", |name, case, [still, moves]| {
        for (moment, of_case) in [("M_wind", "M_r_wind"), ("M_slope", "M_r_slope")] {
            let wanted = get(still, &format!("{of_case}[{case}]"));
            let found = get(moves, moment);
            assert!(wanted != 0.0, "{name}");
            assert!(
                (found - wanted).abs() <= 1e-12 * wanted.abs(),
                "{name}: {found} {wanted}"
            );
        }
    });
}

/// What friction and brake hold is the sum of the static moments of the same case; as a part of the load's.
#[test]
fn what_holds_a_mechanism_at_rest_is_the_sum_of_its_case() {
    in_every_case("M_S = \"1e9 N.m\"", |name, case, [still, moves]| {
        let parts = ["M_r_load", "M_r_wind", "M_r_slope"].map(|of| get(still, &format!("{of}[{case}]")));
        let own = get(still, "M_r_own");
        let size = parts.iter().fold(own.abs(), |most, part| most.max(part.abs()));
        let (found, wanted) = (get(moves, "M_R"), -(own + parts.iter().sum::<f64>()));
        assert!(
            (found - wanted).abs() <= 1e-12 * size,
            "{name}: {found} {wanted} of {size}"
        );
    });
}

/// A gust pushes a free mechanism as its moment says: by what it changes of the acceleration, over the inertia that a moment
/// of the drive has.
#[test]
fn a_gust_accelerates_like_a_moment_of_the_drive() {
    for (name, text) in blown().filter(|(name, _)| name != "compensated") {
        let mut moves = model(&moving(&text, "rigid", "M_A = \"9 MN.m\""));
        at(&mut moves, 0.4);
        let rate = moves
            .variables()
            .iter()
            .find(|v| v.symbol.id.starts_with("der(omega"))
            .map(|v| v.name());
        let rate = rate.expect("a rate");
        let mut accelerates = |pressure: f64, slope: f64, moment: f64| {
            set(&mut moves, "p_wm", pressure);
            set(&mut moves, "sigma_m", slope);
            set(&mut moves, "M_A", moment);
            [
                get(&mut moves, &rate),
                get(&mut moves, "M_wind"),
                get(&mut moves, "M_slope"),
            ]
        };
        let [calm, ..] = accelerates(0.0, 0.0, 9e6);
        let [gust, wind, slope] = accelerates(400.0, 0.03, 9e6);
        let [driven, ..] = accelerates(0.0, 0.0, 9e6 + wind + slope);
        assert!(
            calm != gust && (gust - driven).abs() <= 1e-12 * gust.abs().max(calm.abs()),
            "{name}: {gust} {driven}"
        );
    }
}

/// In the manoeuvres of the book: equilibrium of all bodies asks for the moment that the drive gives, and no energy is lost.
#[test]
fn equilibrium_of_the_bodies_has_the_wind() {
    let named = ["lever", "tail", "compensated", "guided", "trunk", "by its rocker"];
    for (name, text) in blown().filter(|(name, _)| named.contains(&name.as_str())) {
        for (level, slews) in [("rigid", false), ("swing", false), ("rigid", true), ("swing", true)] {
            if slews && !text.contains("\"jib\"") {
                continue;
            }
            let rope = if level == "swing" { "l_R = \"12 m\"\n" } else { "" };
            let more = match slews {
                true => "[luffing.slewing]\nJ_sl = \"5000 t.m2\"\nc_sl = \"900 kN.m.s\"\nM_sl = \"300 kN.m\"\n",
                false => "sigma_m = \"2 deg\"\n",
            };
            let wind = "M_A = \"9 MN.m\"\nM_S = \"9 MN.m\"\np_wm = \"350 Pa\"\nv_wm = \"-9 m/s\"\n";
            let text = moving(&text, level, &format!("{wind}{rope}{more}"));
            let scene = Scene::parse(&text).unwrap_or_else(|found| panic!("{name}: {found:?}"));
            let sheet = scene.sheet();
            let checks: Vec<_> = sheet
                .identities
                .iter()
                .filter(|check| check.id.starts_with("motion_"))
                .collect();
            assert_eq!(checks.len(), 2, "{name}");
            for check in checks {
                let most = if check.id == "motion_forces" { 1e-11 } else { 1e-5 };
                assert!(check.value <= most, "{name}, {level}: {} {:e}", check.id, check.value);
            }
        }
    }
}

/// No wind and no slope change no bit, whatever the cases have of areas.
#[test]
fn calm_air_on_level_ground_changes_nothing() {
    for (name, text) in blown().filter(|(name, _)| name == "lever" || name == "guided") {
        let told = "M_A = \"9 MN.m\"\nl_R = \"12 m\"";
        let mut with = model(&moving(&text, "swing", told));
        let bare: String = text
            .lines()
            .filter(|line| !line.starts_with("A_w"))
            .map(|line| line.to_owned() + "\n")
            .collect();
        let mut without = model(&moving(&bare, "swing", told));
        for i in 0..50 {
            for model in [&mut with, &mut without] {
                model
                    .advance(f64::from(i) / 20.0, f64::from(i + 1) / 20.0)
                    .expect("moves");
            }
        }
        let told = ["M_R", "S_R", "F_A.x", "F_A.y", "F_O1.x", "F_O1.y"];
        let states = without
            .variables()
            .iter()
            .filter(|variable| variable.role == Role::State);
        let compared: Vec<String> = states
            .map(|state| state.name())
            .chain(told.map(str::to_owned))
            .collect();
        for name_of in compared {
            let [one, other] = [&mut with, &mut without].map(|model| {
                let at = index(model, &name_of);
                model.get(at).map(f64::to_bits).ok()
            });
            assert_eq!(one, other, "{name}: {name_of}");
        }
    }
}

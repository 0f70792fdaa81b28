//! Corner loads of a crane on a portal: against a 40-digit oracle of springs and levers, a maker's sums, closed forms, and
//! what must be the same of a crane that is turned, mirrored or twice as heavy.

#[path = "common/named.rs"]
mod named;
#[path = "common/supports.rs"]
mod supports;

use std::f64::consts::{FRAC_PI_2, TAU};
use std::fmt::Write;

use lemnis_models::scene::Scene;

use named::{get, index, model, near, set};
use supports::{compared, tables};

const READY: &str = include_str!("../scenes/portal_corner_loads.toml");
const ORACLE: &str = include_str!("../../tests/oracles/portal_corners.csv");
const CIRCLE: [f64; 2] = [0.0, 360.0];

/// A scene of base and gauge, bodies of portal and upper works, wind (pressure, direction, areas), load and reach.
fn scene(
    [a, b]: [&str; 2],
    portal: &str,
    upper: &str,
    wind: Option<[&str; 3]>,
    [load, reach]: [&str; 2],
    [from, to]: [f64; 2],
) -> String {
    let mut text = format!(
        "name = \"Test\"\ntitle = \"Test\"\n[supports]\nkind = \"portal\"\nframe = \"rigid\"\na = \"{a} m\"\nb = \"{b} m\"\n\
         Q = {{ input = \"{load} N\" }}\nR = {{ input = \"{reach} m\" }}\n"
    );
    tables(&mut text, "corners", &[("n_w", "")], "4;4;6;8");
    tables(&mut text, "portal", &[("G_p", "N"), ("x_p", "m"), ("y_p", "m")], portal);
    tables(&mut text, "upper", &[("G_u", "N"), ("r_u", "m")], upper);
    if let Some([pressure, to, areas]) = wind {
        let _ = writeln!(text, "[supports.wind]\np_w = \"{pressure} Pa\"\nchi_w = \"{to} rad\"");
        tables(&mut text, "wind.areas", &[("A_w", "m2"), ("h_w", "m")], areas);
    }
    let _ = writeln!(
        text,
        "[supports.motion]\nfrom = \"{from} deg\"\nto = \"{to} deg\"\nstep = \"15 deg\"\nspeed = \"9 deg/s\""
    );
    text
}

fn scene_of(row: &[&str]) -> String {
    let wind = (row[4] != "0.0").then_some([row[4], row[5], row[6]]);
    scene([row[0], row[1]], row[2], row[3], wind, [row[7], row[8]], CIRCLE)
}

fn numbers(list: &str) -> Vec<f64> {
    list.split(' ')
        .map(|number| number.parse().expect("a number"))
        .collect()
}

#[test]
fn the_oracle() {
    let (mut lifted, mut rows) = (0, 0);
    for line in ORACLE.lines().skip(1) {
        let row: Vec<&str> = line.split(',').collect();
        let number = |at: usize| row[at].parse::<f64>().expect("a number");
        let mut model = model(&scene_of(&row));
        set(&mut model, "psi", number(9));
        let v = number(10);
        let size = number(0).max(number(1));
        near(get(&mut model, "V"), v, 1e-15 * v);
        near(get(&mut model, "M_x"), number(11), 1e-13 * v * size);
        near(get(&mut model, "M_y"), number(12), 1e-13 * v * size);
        for (name, at) in [("N_4", 13), ("N_r", 14), ("N_h", 15)] {
            for (corner, wanted) in (1..).zip(numbers(row[at])) {
                near(get(&mut model, &format!("{name}[{corner}]")), wanted, 1e-12 * v);
            }
        }
        for (edge, wanted) in (1..).zip(row[16].split(';')) {
            let found = get(&mut model, &format!("K[{edge}]"));
            match wanted.parse::<f64>() {
                Ok(wanted) => near(found, wanted, 1e-10 * wanted.abs()),
                Err(_) => assert_eq!(found, f64::INFINITY),
            }
        }
        near(get(&mut model, "N_cir"), number(17), 1e-12 * v);
        near(get(&mut model, "N_4_cir"), number(19), 1e-12 * v);
        let turns = (get(&mut model, "psi_cir") - number(18)) / TAU;
        // A golden section finds the place of a peak to the root of its digits.
        near(turns, turns.round(), 1e-12);
        let four = numbers(row[13]);
        let pulls = four.iter().position(|load| *load < 0.0);
        assert_eq!(get(&mut model, "lifts"), f64::from(u8::from(pulls.is_some())));
        assert_eq!(get(&mut model, "leg"), pulls.map_or(1.0, |leg| leg as f64 + 2.0));
        assert_eq!(get(&mut model, "z.lift") < 0.0, pulls.is_some());
        (rows, lifted) = (rows + 1, lifted + usize::from(pulls.is_some()));
        // The identities of the book hold, and the greatest of the range are those of the oracle.
        let sheet = Scene::parse(&scene_of(&row)).expect("it stands").sheet();
        assert_eq!(sheet.identities.len(), 5);
        for check in &sheet.identities {
            assert!(
                check.value <= check.limit,
                "{} of row {rows}: {}",
                check.id,
                check.value
            );
        }
        let greatest = |id: &str| {
            let found = sheet.governing.iter().find(|found| found.symbol.id == id);
            found.expect("governing").value
        };
        near(greatest("N_r_max"), number(17), 1e-12 * v);
        near(greatest("N_h_max"), number(20), 1e-12 * v);
        near(greatest("N_4_min"), number(19), 1e-12 * v);
    }
    assert_eq!(rows, 32);
    assert!(lifted >= 5, "{lifted}");
}

/// A maker's portal crane (Rothe Erde): load 220 kN at 23 m, boom 75 kN at 11 m, upper works 450 kN at 0.75 m and
/// counterweight 900 kN at 3 m behind, wind 27 kN at 6.5 m in the boom's direction.
#[test]
fn the_sums_of_a_maker() {
    let upper = "75000 11;450000 -0.75;900000 -3";
    let wind = Some(["270", "0", "100 6.5"]);
    for (load, wind, weight, moment) in [
        ("220000", wind, 1645e3, 3023.0e3),
        ("275000", None, 1700e3, 4112.5e3),
        ("220000", None, 1645e3, 2847.5e3),
    ] {
        let text = scene(["10.5", "10.5"], "0 0 0", upper, wind, [load, "23"], [-30.0, 30.0]);
        let mut model = model(&text);
        set(&mut model, "psi", 0.0);
        near(get(&mut model, "V"), weight, 1e-9);
        near(get(&mut model, "M_y"), moment, 1e-8);
        near(get(&mut model, "M_x"), 0.0, 1e-8);
    }
}

/// On the diagonal of a square, V/4 + (M/2) √2/a; along a side two corners bear alike; the hinged portal by hand.
#[test]
fn by_hand() {
    let text = scene(["8", "8"], "800000 0 0", "", None, ["100000", "12"], CIRCLE);
    let mut model = model(&text);
    set(&mut model, "psi", FRAC_PI_2 / 2.0);
    let most = 225e3 + 600e3 * 2.0_f64.sqrt() / 8.0;
    near(get(&mut model, "N_r[2]"), most, 1e-9);
    near(get(&mut model, "N_cir"), most, 1e-9);
    set(&mut model, "psi", 0.0);
    // 900 kN (1/2 + 1200/7200) (1/2) on each corner in front.
    for (corner, rigid, hinged) in [
        (1, 300e3, 300e3),
        (2, 300e3, 300e3),
        (3, 150e3, 150e3),
        (4, 150e3, 150e3),
    ] {
        near(get(&mut model, &format!("N_r[{corner}]")), rigid, 1e-9);
        near(get(&mut model, &format!("N_h[{corner}]")), hinged, 1e-9);
    }
    // M_s = 800 kN · 4 m, M_o = 100 kN · 8 m about the edge in front; about all others the load holds.
    near(get(&mut model, "K[1]"), 4.0, 1e-14);
    for edge in 2..=4 {
        assert_eq!(get(&mut model, &format!("K[{edge}]")), f64::INFINITY);
    }
    for (name, wanted) in [
        ("N[2]", 300e3),
        ("F_w[2]", 75e3),
        ("F_w[4]", 150e3 / 8.0),
        ("H[2]", 30e3),
    ] {
        near(get(&mut model, name), wanted, 1e-9);
    }
}

/// A leg is lifted just where the load on four would be zero, and the loads go through there without a jump; what tips has
/// none.
#[test]
fn a_leg_lifts_and_the_crane_tips() {
    let mut model = model(&scene(["8", "8"], "800000 0 0", "", None, ["100000", "12"], CIRCLE));
    set(&mut model, "psi", FRAC_PI_2 / 2.0);
    // x + y = 1 of their halves: Q R √2 / (V · 4) = 1.
    let load = 3200e3 / (12.0 * 2.0_f64.sqrt() - 4.0);
    for (part, lifts) in [(1.0 - 1e-9, 0.0), (1.0 + 1e-9, 1.0)] {
        set(&mut model, "Q", load * part);
        assert_eq!(get(&mut model, "lifts"), lifts);
        assert_eq!(get(&mut model, "leg"), if lifts == 0.0 { 1.0 } else { 5.0 });
        near(get(&mut model, "N_r[4]"), 0.0, 1e-2);
        near(get(&mut model, "N_r[2]"), (800e3 + load) / 2.0, 1e-2);
    }
    set(&mut model, "psi", 0.0);
    set(&mut model, "Q", 500e3);
    let at = index(&model, "N_r[1]");
    let fault = model.get(at).expect_err("it tips");
    let wanted = "psi = 0 deg: with Q = 500 kN the crane tips over its edge in front: M_y = 6000 kN.m, where V a/2 = 5200 kN.m holds it";
    assert!(fault.outside && fault.message.starts_with(wanted), "{}", fault.message);
    assert!(get(&mut model, "K[1]") < 1.0 && get(&mut model, "z.lift") < 0.0);
}

/// Exact derivatives against differences, of a leg that is lifted too.
#[test]
fn derivatives() {
    let mut model = model(READY);
    let (mut count, mut lifted) = (0, 0);
    for (psi, load) in [(40.0, 157e3), (133.0, 400e3), (305.0, 430e3)] {
        set(&mut model, "psi", f64::to_radians(psi));
        set(&mut model, "Q", load);
        lifted += usize::from(get(&mut model, "lifts") == 1.0);
        count += compared(&mut model, &["omega", "s", "n_w"], &["lifts", "leg"]);
    }
    assert!(count > 2000 && lifted > 0, "{count} {lifted}");
}

/// Turned by a quarter, with base and gauge changed, each corner has the load of the one before; mirrored, of the one
/// across the rails; twice as heavy, twice as much.
#[test]
fn turned_mirrored_and_heavier() {
    let line = ORACLE.lines().nth(20).expect("a row");
    let row: Vec<&str> = line.split(',').collect();
    let psi: f64 = row[9].parse().expect("an angle");
    let mut plain = model(&scene_of(&row));
    set(&mut plain, "psi", psi);
    let changed =
        |portal: &dyn Fn(f64, f64, f64) -> [f64; 3], wind: &dyn Fn(f64) -> f64, ends: [usize; 2], weight: f64| {
            let bodies = row[2].split(';').map(|body| {
                let [g, x, y] = numbers(body).try_into().expect("three numbers");
                portal(g, x, y).map(|number| number.to_string()).join(" ")
            });
            let portal = bodies.collect::<Vec<_>>().join(";");
            let bodies = row[3].split(';').map(|body| {
                let place = numbers(body);
                format!("{} {}", place[0] * weight, place[1])
            });
            let upper = bodies.collect::<Vec<_>>().join(";");
            let load = (row[7].parse::<f64>().expect("a load") * weight).to_string();
            let pressure = (row[4].parse::<f64>().expect("a pressure") * weight).to_string();
            let to = wind(row[5].parse().expect("a direction")).to_string();
            let blown = (row[4] != "0.0").then_some([pressure.as_str(), to.as_str(), row[6]]);
            model(&scene(
                [row[ends[0]], row[ends[1]]],
                &portal,
                &upper,
                blown,
                [&load, row[8]],
                CIRCLE,
            ))
        };
    let mut turned = changed(&|g, x, y| [g, -y, x], &|to| to + FRAC_PI_2, [1, 0], 1.0);
    let mut mirrored = changed(&|g, x, y| [g, x, -y], &|to| -to, [0, 1], 1.0);
    let mut heavy = changed(&|g, x, y| [2.0 * g, x, y], &|to| to, [0, 1], 2.0);
    set(&mut turned, "psi", psi + FRAC_PI_2);
    set(&mut mirrored, "psi", -psi);
    set(&mut heavy, "psi", psi);
    for name in ["N_4", "N_r", "N_h"] {
        for corner in 1..=4 {
            let wanted = get(&mut plain, &format!("{name}[{corner}]"));
            let next = corner % 4 + 1;
            near(get(&mut turned, &format!("{name}[{next}]")), wanted, 1e-9);
            let across = [2, 1, 4, 3][corner - 1];
            near(get(&mut mirrored, &format!("{name}[{across}]")), wanted, 1e-9);
            near(get(&mut heavy, &format!("{name}[{corner}]")), 2.0 * wanted, 1e-9);
        }
    }
}

//! A mobile crane on its supports: against a 50-digit oracle that knows no polygon and no formula of tipping, closed forms
//! of textbooks, and its own load chart looked through in fine steps.

#[path = "common/named.rs"]
mod named;
#[path = "common/supports.rs"]
mod supports;

use std::fmt::Write;

use lemnis_models::kernel::variable::Role;
use lemnis_models::scene::Scene;

use named::{get, index, model, near, set};
use supports::{compared, tables};

const READY: &str = include_str!("../scenes/mobile_crane.toml");
const ORACLE: &str = include_str!("../../tests/oracles/mobile_crane.csv");

/// The scene of a row of the oracle, which stands at its slewing angle.
fn scene_of(row: &[&str]) -> (String, f64) {
    let number = |at: usize| row[at].parse::<f64>().expect("a number");
    let (psi, wind) = (number(11), number(15));
    let mut text = String::from("name = \"Test\"\ntitle = \"Test\"\n[supports]\nkind = \"mobile\"\n");
    for (key, at, unit) in [("l", 9, "m"), ("phi", 10, "rad"), ("Q", 12, "N"), ("G_h", 13, "N")] {
        let _ = writeln!(text, "{key} = \"{} {unit}\"", row[at]);
    }
    let caps: Vec<String> = row[0].split(';').map(|point| format!("{point} {}", row[4])).collect();
    tables(
        &mut text,
        "points",
        &[("x", "m"), ("y", "m"), ("N_cap", "N")],
        &caps.join(";"),
    );
    tables(
        &mut text,
        "carrier",
        &[("G_c", "N"), ("x_c", "m"), ("y_c", "m"), ("h_c", "m")],
        row[1],
    );
    tables(&mut text, "upper", &[("G_u", "N"), ("r_u", "m"), ("h_u", "m")], row[2]);
    let _ = writeln!(text, "[supports.boom]\nphi_max = \"85 deg\"");
    for (key, at) in [("x_F", 5), ("h_F", 6), ("d_A", 7), ("l_0", 8)] {
        let _ = writeln!(text, "{key} = \"{} m\"", row[at]);
    }
    tables(
        &mut text,
        "boom.parts",
        &[("G_p", "N"), ("q_p", "N/m"), ("s_p", "m"), ("kappa_p", "")],
        row[3],
    );
    if number(14) != 0.0 {
        let _ = writeln!(text, "[supports.slope]\ngamma_s = \"{} rad\"", row[14]);
        let area = wind * 9.81 / 100.0;
        let _ = writeln!(
            text,
            "[supports.wind]\nv_w = \"10 m/s\"\nc_p = \"1 kg/m3\"\na_Q = \"{area:e} m2/kg\""
        );
    }
    let (from, to) = (psi - 1e-6, psi + 1e-6);
    let _ = writeln!(
        text,
        "[supports.motion]\nfrom = \"{from} rad\"\nto = \"{to} rad\"\nstep = \"1e-6 rad\"\nspeed = \"1 deg/s\""
    );
    (text, psi)
}

#[test]
fn the_oracle() {
    let (mut lifted, mut full, mut within) = (0, 0, 0);
    for line in ORACLE.lines().skip(1) {
        let row: Vec<&str> = line.split(',').collect();
        let (text, psi) = scene_of(&row);
        let mut model = model(&text);
        set(&mut model, "psi", psi);
        let wanted = |at: usize| row[at].parse::<f64>().ok();
        for (name, at) in [("R", 16), ("H_A", 17), ("P", 18), ("s_back", 19), ("Q_N", 20)] {
            let (found, wanted) = (get(&mut model, name), wanted(at).unwrap_or(f64::INFINITY));
            within += usize::from(name == "P" && wanted.is_infinite());
            full += usize::from(name == "Q_N" && wanted.is_finite());
            let same = found == wanted || ((found - wanted) / wanted).abs() < 2e-12;
            assert!(same, "{name}: {found}, {wanted} in {line}");
        }
        let forces: Vec<f64> = row[21]
            .split(' ')
            .map(|force| force.parse().expect("a number"))
            .collect();
        let whole: f64 = forces.iter().sum();
        for (number, wanted) in (1..).zip(&forces) {
            near(get(&mut model, &format!("N[{number}]")), *wanted, 2e-13 * whole);
            lifted += usize::from(*wanted == 0.0);
        }
        near(get(&mut model, "V"), whole, 1e-14 * whole);
    }
    assert!(
        lifted > 10 && full > 20 && within > 0,
        "{lifted} lifted, {full} full, {within} within"
    );
}

/// A plain crane on a rectangle of 2a × 2b, all weights at the slewing axis but the boom's, which is at its head.
fn plain(keys: &str, tables: &str) -> String {
    format!(
        "name = \"Test\"\ntitle = \"Test\"\n[supports]\nkind = \"mobile\"\nl = \"20 m\"\n{keys}\n\
         [[supports.points]]\nx = \"2 m\"\ny = \"-3 m\"\n[[supports.points]]\nx = \"2 m\"\ny = \"3 m\"\n\
         [[supports.points]]\nx = \"-2 m\"\ny = \"3 m\"\n[[supports.points]]\nx = \"-2 m\"\ny = \"-3 m\"\n\
         [[supports.carrier]]\nG_c = \"300 kN\"\nx_c = \"0 m\"\n\
         [supports.boom]\nx_F = \"0 m\"\nh_F = \"2 m\"\nl_0 = \"20 m\"\nphi_max = \"89 deg\"\n\
         [[supports.boom.parts]]\nG_p = \"20 kN\"\ns_p = \"10 m\"\n\
         [supports.motion]\nfrom = \"0 deg\"\nto = \"360 deg\"\nstep = \"5 deg\"\nspeed = \"6 deg/s\"\n{tables}\n"
    )
}

/// Q = (G_0 b − G_b (x_b − b)) / (K (R − b)) [Ports001, 7.1.4], (P − 0.1 F) / 1.25 [ISO 4305], and a part of P.
#[test]
fn textbook_ratings_over_one_side() {
    // Over the front the line is 2 m before the axis; the boom's weight stands at half its reach.
    let (reach, front) = (8.0, 2.0);
    let tips = (300e3 * front - 20e3 * (reach / 2.0 - front)) / (reach - front);
    let head = 20e3 * 10.0 / 20.0;
    let bases = [
        ("kind = \"safety\"\nK_t = \"1.33\"", tips / 1.33),
        ("kind = \"factors\"", (tips - 0.1 * head) / 1.25),
        ("kind = \"part\"\nnu = \"85 %\"", 0.85 * tips),
    ];
    for (basis, rated) in bases {
        let mut model = model(&plain(
            "R = \"8 m\"\nQ = \"20 kN\"",
            &format!("[supports.rating]\n{basis}"),
        ));
        near(get(&mut model, "P"), tips, 1e-9);
        near(get(&mut model, "Q_rat"), rated, 1e-9);
        near(get(&mut model, "eta"), 20e3 / rated, 1e-14);
        assert_eq!(get(&mut model, "governs"), 1.0);
    }
}

/// V/4 + (M/2) √(1/a² + 1/b²) at tan ψ = a/b, not on the diagonal of the supports, while none lifts.
#[test]
fn the_greatest_corner_of_a_rectangle() {
    let scene = Scene::parse(&plain("R = \"6 m\"\nQ = \"20 kN\"", "")).expect("read");
    let (a, b, force, moment) = (4.0, 6.0, 340e3, 20e3 * 6.0 + 20e3 * 3.0);
    let sheet = scene.sheet();
    let found = sheet
        .governing
        .iter()
        .find(|found| found.symbol.id == "N_i_max")
        .expect("there");
    let wanted = force / 4.0 + moment / 2.0 * libm::sqrt(1.0 / (a * a) + 1.0 / (b * b));
    near(found.value, wanted, 1e-9);
    let (_, psi) = found.at.expect("an angle");
    near(libm::fabs(libm::tan(psi)), a / b, 1e-9);
    assert!(sheet.checks().all(|check| check.passed()));
}

/// Grab and hook count as load, and the impact takes its part.
#[test]
fn gross_and_net() {
    let keys = "R = \"8 m\"\nQ = \"20 kN\"\nG_h = \"6 kN\"\nphi_Q = \"1.3\"";
    let mut model = model(&plain(keys, ""));
    let rated = get(&mut model, "Q_rat");
    near(get(&mut model, "Q_g"), 1.3 * 26e3, 1e-9);
    near(get(&mut model, "Q_net"), rated / 1.3 - 6e3, 1e-9);
    near(get(&mut model, "eta"), 1.3 * 26e3 / rated, 1e-14);
    // At its net rated load it is used in full.
    let net = get(&mut model, "Q_net");
    set(&mut model, "Q", net);
    near(get(&mut model, "eta"), 1.0, 1e-14);
    assert_eq!([get(&mut model, "warns"), get(&mut model, "stops")], [1.0, 0.0]);
    set(&mut model, "Q", net * 1.0001);
    assert_eq!(get(&mut model, "stops"), 1.0);
}

/// A load within the supports tips nothing, and is limited by strength alone.
#[test]
fn a_load_within_the_supports() {
    let strength = "[[supports.strength]]\nof = \"tackle\"\nQ_s = \"50 kN\"";
    for (tables, rated, part) in [("", f64::INFINITY, 0.0), (strength, 50e3, 0.4)] {
        let mut model = model(&plain("R = \"1.9 m\"\nQ = \"20 kN\"", tables));
        assert_eq!([get(&mut model, "P"), get(&mut model, "Q_rat")], [f64::INFINITY, rated]);
        near(get(&mut model, "eta"), part, 1e-15);
        let mut tangent = model.tangent(&|(symbol, _)| f64::from(symbol.id == "psi"));
        let at = index(&model, "eta");
        assert_eq!(model.derivative(&mut tangent, at).expect("a derivative"), 0.0);
    }
}

/// A short base with a heavy counterweight may tip backward: nothing is permitted, whatever the load.
#[test]
fn tipping_backward_is_not_permitted() {
    let heavy = "[[supports.upper]]\nG_u = \"100 kN\"\nr_u = \"-5 m\"\n[supports.chart]\nlengths = [\"20 m\"]\n\
                 R_from = \"2 m\"\nR_to = \"14 m\"\nR_step = \"4 m\"";
    let mut model = model(&plain("R = { input = \"14 m\" }\nQ = \"10 kN\"", heavy));
    // Without load 420 kN stand 0.857 m behind the axis, of 2 m: 28.6 % are left in front.
    near(get(&mut model, "s_back"), (2.0 - (500e3 - 140e3) / 420e3) / 4.0, 1e-14);
    assert_eq!(get(&mut model, "governs"), 1.0);
    set(&mut model, "R", 2.0);
    near(get(&mut model, "s_back"), (2.0 - (500e3 - 20e3) / 420e3) / 4.0, 1e-14);
    set(&mut model, "s_lim", 0.22);
    assert_eq!(
        [
            get(&mut model, "governs"),
            get(&mut model, "Q_rat"),
            get(&mut model, "stops")
        ],
        [7.0, 0.0, 1.0]
    );
    assert_eq!(get(&mut model, "eta"), f64::INFINITY);
}

/// The chart of the ready scene in its cells: the least of 2400 angles is not below it, and hardly above.
#[test]
fn the_chart_holds_at_every_angle() {
    let caps = READY
        .replace("x = \"2.2 m\"\n", "x = \"2.2 m\"\nN_cap = \"190 kN\"\n")
        .replace("x = \"-2.9 m\"\n", "x = \"-2.9 m\"\nN_cap = \"190 kN\"\n");
    for text in [READY, &caps] {
        let scene = Scene::parse(text).expect("read");
        let sheet = scene.sheet();
        let [chart] = sheet.charts.as_slice() else {
            panic!("one chart")
        };
        let mut model = scene.model().expect("built");
        let (mut governs, mut cells) = (Vec::new(), 0);
        for (row, mark) in chart.points.rows.iter().zip(&chart.marks).step_by(7) {
            let [length, reach, _, _, _, load, net] = row[..] else {
                panic!("seven columns")
            };
            set(&mut model, "l", length);
            set(&mut model, "R", reach);
            let mut least = f64::INFINITY;
            for i in 0..=2400 {
                set(&mut model, "psi", (60.0 + 240.0 * f64::from(i) / 2400.0).to_radians());
                least = least.min(get(&mut model, "Q_rat"));
            }
            assert!(load <= least * (1.0 + 1e-12), "{length} {reach}: {load} {least} {mark}");
            assert!(load >= least * (1.0 - 1e-5), "{length} {reach}: {load} {least} {mark}");
            near(net, if load > 0.0 { load - 2746.8 } else { 0.0 }, 1e-6);
            governs.push(*mark);
            cells += 1;
        }
        governs.sort_unstable();
        governs.dedup();
        let wanted = if text == READY {
            ["boom", "stability"]
        } else {
            ["boom", "support"]
        };
        assert!(cells > 10 && governs == wanted, "{cells} {governs:?}");
    }
}

/// Between its cells the chart gives what the next greater reach and the next longer boom permit, and nothing beyond.
#[test]
fn the_chart_is_never_read_upward() {
    let scene = Scene::parse(READY).expect("read");
    let chart = scene.sheet().charts.remove(0);
    let cell = |length: f64, reach: f64| {
        let found = chart
            .points
            .rows
            .iter()
            .find(|row| row[0] == length && (row[1] - reach).abs() < 1e-9);
        found.map(|row| row[5])
    };
    let mut model = scene.model().expect("built");
    let mut read = |length: f64, reach: f64| {
        set(&mut model, "l", length);
        set(&mut model, "R", reach);
        get(&mut model, "Q_ch")
    };
    for (length, reach, l, r) in [
        (17.7, 8.0, 17.7, 8.0),
        (17.7, 7.2, 17.7, 8.0),
        (15.0, 8.0, 17.7, 8.0),
        (14.1, 8.000_001, 17.7, 9.0),
        (25.0, 5.5, 25.0, 6.0),
    ] {
        assert_eq!(read(length, reach), cell(l, r).expect("a cell"), "{length} {reach}");
    }
    assert_eq!(cell(17.7, 17.0), None);
    assert_eq!(read(17.7, 16.3), 0.0, "beyond what the chart has of the boom");
    let at = |read: &mut dyn FnMut(f64, f64) -> f64, reach: f64| read(25.0, reach);
    let steps: Vec<f64> = (0..200).map(|i| at(&mut read, 5.0 + f64::from(i) * 0.09)).collect();
    assert!(
        steps.windows(2).all(|pair| pair[1] <= pair[0]),
        "it never grows with the reach"
    );
}

/// Every result by every input and parameter against differences, on a slope in the wind and with full supports.
#[test]
fn derivatives() {
    let caps = READY
        .replace("y = \"3 m\"\n", "y = \"3 m\"\nN_cap = \"160 kN\"\n")
        .replace("y = \"-3 m\"\n", "y = \"-3 m\"\nN_cap = \"160 kN\"\n");
    let mut model = model(
        &caps
            .replace("input = \"8 m\"", "input = \"8.3 m\"")
            .replace("input = \"17.7 m\"", "input = \"18.2 m\""),
    );
    // No two sides are parallel: a support is the farthest from a line, and no other one as far.
    for (name, place) in [("x[1]", 2.3), ("y[2]", 3.2), ("x[4]", -2.8)] {
        set(&mut model, name, place);
    }
    // A part of the boom's extension has ends.
    let given = ["omega", "s", "k_w", "phi_min", "phi_max", "s_lim"];
    let mut count = 0;
    for psi in [70.0, 133.0, 215.0] {
        set(&mut model, "psi", f64::to_radians(psi));
        count += compared(&mut model, &given, &["governs", "warns", "stops"]);
    }
    assert!(count > 3000, "{count}");
}

/// Turned as a whole, the crane is the same; twice as heavy with twice the load, twice of everything.
#[test]
fn turned_and_scaled() {
    let row = ORACLE.lines().nth(20).expect("a row");
    let row: Vec<&str> = row.split(',').collect();
    let (text, psi) = scene_of(&row);
    let mut one = model(&text);
    set(&mut one, "psi", psi);
    let turn = 0.7_f64;
    let turned = |list: &str, places: [usize; 2]| {
        let each = list.split(';').map(|line| {
            let mut numbers: Vec<f64> = line
                .split(' ')
                .map(|number| number.parse().expect("a number"))
                .collect();
            let [x, y] = places.map(|place| numbers[place]);
            let (sin, cos) = libm::sincos(turn);
            (numbers[places[0]], numbers[places[1]]) = (cos * x - sin * y, sin * x + cos * y);
            numbers.iter().map(f64::to_string).collect::<Vec<_>>().join(" ")
        });
        each.collect::<Vec<_>>().join(";")
    };
    let (points, carrier) = (turned(row[0], [0, 1]), turned(row[1], [1, 2]));
    let other = (psi + turn).to_string();
    let mut around = row.clone();
    (around[0], around[1], around[11]) = (&points, &carrier, &other);
    let (text, _) = scene_of(&around);
    let mut two = model(&text);
    set(&mut two, "psi", psi + turn);
    for name in ["P", "s_back", "Q_N", "a", "N[1]", "N[2]", "N[3]", "N[4]", "eta"] {
        let (found, wanted) = (get(&mut two, name), get(&mut one, name));
        assert!(
            (found - wanted).abs() <= 1e-11 * wanted.abs().max(1.0),
            "{name}: {found} {wanted}"
        );
    }
    let before: Vec<f64> = ["P", "Q_rat", "N[1]"].map(|name| get(&mut one, name)).into();
    for by in 0..one.variables().len() {
        let variable = one.variables()[by];
        let weighs = ["G_c", "G_u", "G_p", "q_p", "Q", "G_h", "N_cap"].contains(&variable.symbol.id);
        if weighs && variable.role != Role::Output {
            let value = one.get(by).expect("known");
            one.set(by, 2.0 * value).expect("allowed");
        }
    }
    for (name, before) in ["P", "Q_rat", "N[1]"].into_iter().zip(before) {
        let now = get(&mut one, name);
        assert!((now - 2.0 * before).abs() <= 1e-12 * before, "{name}");
    }
}

/// What tips has no forces, and says which load would be too much.
#[test]
fn a_crane_that_tips_has_no_forces() {
    let mut model = model(&plain("R = \"8 m\"\nQ = { input = \"20 kN\" }", ""));
    set(&mut model, "Q", 200e3);
    let at = index(&model, "N[1]");
    let fault = model.get(at).expect_err("it tips");
    assert!(
        fault.outside && fault.message.contains("psi = 0 deg: the crane tips") && fault.message.contains("P = 93.3"),
        "{}",
        fault.message
    );
    assert!(get(&mut model, "a") < 0.0 && get(&mut model, "eta") > 1.0);
}

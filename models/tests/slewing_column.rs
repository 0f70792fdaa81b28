//! A column in three bearings: against a 40-digit oracle that solves its five reactions at once, closed forms, and what must
//! be the same of a column that is mirrored, longer or without what it need not have.

#[path = "common/named.rs"]
#[allow(dead_code, reason = "not every test uses all of it")]
mod named;
#[path = "common/supports.rs"]
mod supports;

use std::fmt::Write;

use lemnis_models::scene::Scene;

use named::{get, model, near, set};
use supports::{compared, slewing};

const READY: &str = include_str!("../scenes/slewing_column.toml");
const ORACLE: &str = include_str!("../../tests/oracles/slewing_column.csv");

/// What a scene of a test says.
#[derive(Clone, Copy)]
struct Said<'a> {
    height: &'a str,
    upper: &'a str,
    areas: &'a str,
    /// Slope (rad) and height of the load's suspension.
    slope: Option<[&'a str; 2]>,
    cases: &'a str,
    load: [&'a str; 2],
    /// Sizes and coefficients of friction of the bearings.
    bearings: Option<[&'a str; 2]>,
    balance: Option<&'a str>,
}

/// Upper works and load, one case without wind.
const PLAIN: Said<'static> = Said {
    height: "5",
    upper: "400000 -0.5 3;100000 8 12",
    areas: "",
    slope: None,
    cases: "1 0 0",
    load: ["50000", "20"],
    bearings: Some(["1 0.2 0.5 0.4 0.3 0", "0.1 0.05 0.08"]),
    balance: Some("4"),
};

fn scene(said: &Said<'_>) -> String {
    let ([load, reach], height) = (said.load, said.height);
    let mut text = format!(
        "name = \"Test\"\ntitle = \"Test\"\n[supports]\nkind = \"column\"\nh_uf = \"{height} m\"\nQ = {{ input = \"{load} N\" }}\n\
         R = {{ input = \"{reach} m\" }}\n"
    );
    slewing(&mut text, said.upper, said.areas, said.cases, said.slope);
    let mut table = |name: &str, unit: &str, keys: &[&str], numbers: &str| {
        let _ = writeln!(text, "[supports.{name}]");
        for (key, number) in keys.iter().zip(numbers.split(' ')) {
            let _ = writeln!(text, "{key} = \"{number}{unit}\"");
        }
    };
    if let Some([sizes, friction]) = said.bearings {
        table("bearings", " m", &["D_u", "b_u", "D_f", "b_f", "D_p", "d_i"], sizes);
        table("friction", "", &["mu_u", "mu_f", "mu_p"], friction);
    }
    if let Some(place) = said.balance {
        table("counterweight", " m", &["r_d"], place);
    }
    text + "[supports.motion]\nfrom = \"-180 deg\"\nto = \"180 deg\"\nstep = \"15 deg\"\nspeed = \"9 deg/s\"\n"
}

fn scene_of(row: &[&str]) -> String {
    scene(&Said {
        height: row[0],
        upper: row[1],
        areas: row[2],
        slope: (!row[3].is_empty()).then_some([row[3], row[4]]),
        cases: row[5],
        load: [row[6], row[7]],
        bearings: Some([row[9], row[10]]),
        balance: Some(row[11]),
    })
}

fn rows() -> Vec<Vec<&'static str>> {
    let rows: Vec<Vec<_>> = ORACLE.lines().skip(1).map(|line| line.split(',').collect()).collect();
    assert_eq!(rows.len(), 30);
    rows
}

fn number(text: &str) -> f64 {
    text.parse().expect("a number")
}

#[test]
fn the_oracle() {
    let mut greatest = 0.0_f64;
    for row in rows() {
        let mut model = model(&scene_of(&row));
        set(&mut model, "psi", number(row[8]));
        let (h, reach) = (number(row[0]), number(row[7]));
        for (case, wanted) in (1..).zip(row[12].split(';')) {
            let wanted: Vec<f64> = wanted.split(' ').map(number).collect();
            // Moments of single weights cancel in their sum.
            let size = wanted[0] * (1.0 + reach / h);
            let sizes: Vec<f64> = row[9].split(' ').map(number).collect();
            let [upper, foot] = [size / (sizes[0] * sizes[1]), size / (sizes[2] * sizes[3])];
            let names = ["V", "H_u", "H_f", "M_fb", "p_u", "p_f", "p_p"];
            let sizes = [wanted[0], size, size, size * sizes[0], upper, foot, wanted[6]];
            for ((name, wanted), size) in names.iter().zip(&wanted).zip(sizes) {
                let found = get(&mut model, &format!("{name}[{case}]"));
                greatest = greatest.max((found - wanted).abs() / size);
                near(found, *wanted, 1e-14 * size);
            }
        }
        near(get(&mut model, "G_d"), number(row[13]), 1e-9);
        let scene = Scene::parse(&scene_of(&row)).expect("a scene");
        for check in &scene.sheet().identities {
            assert!(check.value <= check.limit, "{}: {}", check.id, check.value);
        }
    }
    println!("greatest difference {greatest:e}");
}

/// H_u = H_f = M/h_uf without wind and slope; 600 kN·m over 5 m. The counterweight found leaves ±Q R/2.
#[test]
fn without_wind_on_level_ground() {
    let mut plain = model(&scene(&PLAIN));
    for psi in [0.0, 1.0, -2.5] {
        set(&mut plain, "psi", psi);
        // −200 + 800 + 1000 kN·m.
        assert_eq!(get(&mut plain, "M[1]"), 1600e3);
        assert_eq!(get(&mut plain, "H_u[1]"), 320e3);
        assert_eq!(get(&mut plain, "H_f[1]"), 320e3);
        assert_eq!(get(&mut plain, "V[1]"), 550e3);
        assert_eq!(get(&mut plain, "H[1]"), 0.0);
    }
    // A full pivot: D/3. 0.1 · 320 · 0.5 + 0.05 · 320 · 0.25 + 0.08 · 550 · 0.1.
    near(get(&mut plain, "R_p"), 0.1, 1e-17);
    near(get(&mut plain, "M_fb[1]"), (16.0 + 4.0 + 4.4) * 1e3, 1e-10);
    // (600 + 500) / 4.
    near(get(&mut plain, "G_d"), 275e3, 1e-9);
    let with = format!("{};275000 -4 2", PLAIN.upper);
    let moment = |load| {
        let mut model = model(&scene(&Said {
            upper: &with,
            load: [load, "20"],
            ..PLAIN
        }));
        get(&mut model, "M_l[1]")
    };
    assert_eq!((moment("0"), moment("50000")), (-500e3, 500e3));
}

/// Of a thin ring half of the diameter; between full and thin it grows.
#[test]
fn the_pivot() {
    let radius = |inner: &str| {
        let sizes = format!("1 0.2 0.5 0.4 0.3 {inner}");
        let mut model = model(&scene(&Said {
            bearings: Some([&sizes, "0.1 0.05 0.08"]),
            ..PLAIN
        }));
        get(&mut model, "R_p")
    };
    let all = ["0", "0.1", "0.2", "0.29999999"].map(radius);
    assert!(all.is_sorted());
    near(all[3], 0.15, 1e-8);
    // 2/3 (R³ − r³)/(R² − r²).
    near(
        all[2],
        2.0 / 3.0 * (0.15_f64.powi(3) - 0.001) / (0.15_f64.powi(2) - 0.01),
        1e-16,
    );
}

/// Exact derivatives against differences.
#[test]
fn derivatives() {
    let mut count = 0;
    for text in std::iter::once(READY.to_owned()).chain(rows().iter().map(|row| scene_of(row))) {
        let mut model = model(&text);
        for psi in [0.7, 2.3, -1.9] {
            set(&mut model, "psi", psi);
            count += compared(&mut model, &["omega", "s"], &[]);
        }
    }
    assert!(count > 50_000, "{count}");
}

/// Mirrored, all but the sides are the same; on bearings twice as far from each other the foot bears half.
#[test]
fn mirrored_and_longer() {
    let windy = Said {
        areas: "30 4;20 12",
        cases: "1 250 0.7;1.25 100 -1.9",
        ..PLAIN
    };
    let mut plain = model(&scene(&windy));
    let mut mirrored = model(&scene(&Said {
        cases: "1 250 -0.7;1.25 100 1.9",
        ..windy
    }));
    let mut longer = model(&scene(&Said { height: "10", ..windy }));
    set(&mut plain, "psi", 0.4);
    set(&mut mirrored, "psi", -0.4);
    set(&mut longer, "psi", 0.4);
    for case in 1..=2 {
        for name in ["V", "H_ul", "H_ut", "H_u", "H_f", "M_fb"] {
            let name = format!("{name}[{case}]");
            let side = if name.contains("ut") { -1.0 } else { 1.0 };
            let wanted = get(&mut plain, &name);
            near(get(&mut mirrored, &name), side * wanted, 1e-9);
        }
        let name = format!("H_f[{case}]");
        near(2.0 * get(&mut longer, &name), get(&mut plain, &name), 1e-9);
    }
}

/// A column without sizes, friction and counterweight has none of their results.
#[test]
fn what_it_need_not_have() {
    let bare = model(&scene(&Said {
        bearings: None,
        balance: None,
        ..PLAIN
    }));
    let ids: Vec<&str> = bare.variables().iter().map(|variable| variable.symbol.id).collect();
    assert!(ids.contains(&"H_u"));
    for id in ["p_u", "M_fb", "R_p", "G_d", "S_u", "F_w"] {
        assert!(!ids.contains(&id), "{id}");
    }
}

#[test]
fn what_cannot_be_is_told() {
    let text = scene(&PLAIN);
    for (old, new, told) in [
        (
            "d_i = \"0 m\"",
            "d_i = \"0.3 m\"",
            "a pivot of D_p = 300 mm with d_i = 300 mm within",
        ),
        (
            "[supports.bearings]\nD_u = \"1 m\"\nb_u = \"0.2 m\"\nD_f = \"0.5 m\"\nb_f = \"0.4 m\"\nD_p = \"0.3 m\"\nd_i = \"0 m\"\n",
            "",
            "friction of bearings without sizes",
        ),
        (
            "h_uf = \"5 m\"",
            "h_uf = \"0 m\"",
            "`supports.h_uf`: 0 m is not allowed",
        ),
        ("G_u = \"400000 N\"", "G_u = \"-1 N\"", "-1 N is not allowed"),
    ] {
        assert!(text.contains(old), "{old}");
        let found = Scene::parse(&text.replacen(old, new, 1)).expect_err(told);
        assert!(
            found.iter().any(|mistake| mistake.message.contains(told)),
            "{told}: {found:?}"
        );
        assert!(found.iter().all(|mistake| mistake.help.is_some()), "{found:?}");
    }
}

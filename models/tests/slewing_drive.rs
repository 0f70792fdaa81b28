//! The drive of a crane that slews on a support: against an oracle that pushes in space and integrates, closed forms, and
//! what must be the same of a crane that is mirrored, or that has two drives.

#[path = "common/named.rs"]
#[allow(dead_code, reason = "not every test uses all of it")]
mod named;
#[path = "common/supports.rs"]
mod supports;

use std::f64::consts::TAU;
use std::fmt::Write;

use lemnis_models::scene::Scene;

use named::{get, model, near, set};
use supports::{compared, tables};

const READY: &str = include_str!("../scenes/slewing_portal.toml");
const ORACLE: &str = include_str!("../../tests/oracles/slewing_drive.csv");

fn number(text: &str) -> f64 {
    text.parse().expect("a number")
}

/// Keys with their units, and a line of numbers for them.
fn line(text: &mut String, name: &str, keys: &[(&str, &str)], numbers: &str) {
    let _ = writeln!(text, "[supports.{name}]");
    for ((key, unit), number) in keys.iter().zip(numbers.split(' ')) {
        let _ = writeln!(text, "{key} = \"{number} {unit}\"");
    }
}

/// A column whose drive is that of a row of the oracle.
fn scene_of(row: &[&str]) -> String {
    let (h, bearings) = row[7].split_once(' ').expect("several");
    let mut text = format!(
        "name = \"Test\"\ntitle = \"Test\"\n[supports]\nkind = \"column\"\nh_uf = \"{h} m\"\nQ = {{ input = \"{} N\" }}\n\
         R = {{ input = \"{} m\" }}\n",
        row[4], row[5]
    );
    tables(&mut text, "upper", &[("G_u", "N"), ("r_u", "m"), ("h_u", "m")], row[0]);
    tables(&mut text, "areas", &[("A_w", "m2"), ("h_w", "m"), ("r_w", "m")], row[1]);
    let case = [
        ("k_Q", ""),
        ("p_w", "Pa"),
        ("chi_w", "rad"),
        ("n_s", "1/s"),
        ("alpha_Q", "rad"),
        ("K_b", ""),
    ];
    tables(&mut text, "load_cases", &case, row[3]);
    if !row[2].is_empty() {
        line(
            &mut text,
            "slope",
            &[("gamma", "rad"), ("h_Q", "m")],
            &format!("{} 18", row[2]),
        );
    }
    let sizes = [
        ("D_u", "m"),
        ("b_u", "m"),
        ("D_f", "m"),
        ("b_f", "m"),
        ("D_p", "m"),
        ("d_i", "m"),
    ];
    line(&mut text, "bearings", &sizes, bearings);
    line(
        &mut text,
        "friction",
        &[("mu_u", ""), ("mu_f", ""), ("mu_p", "")],
        row[8],
    );
    let drive = [
        ("J_e", "kg.m2"),
        ("z_d", ""),
        ("i_sl", ""),
        ("eta_sl", ""),
        ("P_N", "W"),
        ("n_N", "1/s"),
        ("lambda_M", ""),
        ("k_a", ""),
        ("J_M", "kg.m2"),
    ];
    line(&mut text, "slewing_drive", &drive, row[9]);
    if !row[10].is_empty() {
        let _ = writeln!(text, "l_R = \"{} m\"", row[10]);
    }
    text += "heating = 1\n";
    line(
        &mut text,
        "slewing_drive.brake",
        &[("T_b", "N.m"), ("tau_b", "s")],
        row[11],
    );
    line(&mut text, "slewing_drive.coupling", &[("k_lim", "")], row[12]);
    let pinion = [
        ("r_z", "m"),
        ("r_g", "m"),
        ("K_F", ""),
        ("Y_F", ""),
        ("b_z", "m"),
        ("m_t", "m"),
        ("alpha_t", "rad"),
        ("E_t", "Pa"),
        ("nu_t", ""),
    ];
    let (numbers, inside) = row[13].rsplit_once(' ').expect("several");
    line(&mut text, "slewing_drive.pinion", &pinion, numbers);
    let side = if number(inside) == 1.0 { "inside" } else { "outside" };
    let _ = writeln!(text, "teeth = \"{side}\"");
    text + "[supports.motion]\nfrom = \"-180 deg\"\nto = \"180 deg\"\nstep = \"15 deg\"\nspeed = \"9 deg/s\"\n"
}

fn rows() -> Vec<Vec<&'static str>> {
    let rows: Vec<Vec<_>> = ORACLE.lines().skip(1).map(|line| line.split(',').collect()).collect();
    assert_eq!(rows.len(), 24);
    rows
}

/// Moments to 1e-13 of what acts about the axis, which is made of single weights; the rest to 1e-12 of its own.
#[test]
fn the_oracle() {
    const NAMES: [&str; 16] = [
        "M_z", "M_st", "J_c", "R_o", "P_M", "P_lr", "t_start", "a_start", "T_hs", "t_stop", "psi_stop", "a_stop",
        "T_c", "F_t", "sigma_Fz", "sigma_Hz",
    ];
    for row in rows() {
        let text = scene_of(&row);
        let mut model = model(&text);
        set(&mut model, "psi", number(row[6]));
        for (case, wanted) in (1..).zip(row[14].split(';')) {
            let wanted: Vec<f64> = wanted.split(' ').map(number).collect();
            for (name, wanted) in NAMES.iter().zip(&wanted) {
                if *name == "R_o" && row[10].is_empty() {
                    continue;
                }
                let size = if *name == "M_z" {
                    0.1 * get(&mut model, "M_u").abs()
                } else {
                    wanted.abs()
                };
                let size = if *name == "T_hs" { size.max(1e-2) } else { size };
                let found = get(&mut model, &format!("{name}[{case}]"));
                assert!(
                    found == *wanted || (found - wanted).abs() <= 1e-12 * size,
                    "{name}: {found} {wanted}"
                );
            }
        }
        let scene = Scene::parse(&text).expect("a scene");
        let sheet = scene.sheet();
        for check in &sheet.identities {
            assert!(check.value <= check.limit, "{}: {}", check.id, check.value);
        }
        let rms = sheet
            .summary
            .iter()
            .find(|found| found.symbol.id == "P_sl_rms")
            .expect("there");
        near(rms.value, number(row[15]), 1e-6 * number(row[15]));
    }
}

/// Without friction and losses the wind across is a sine, and its power's root mean square 0.707 of the greatest.
#[test]
fn wind_alone_heats_with_0_707() {
    // On level ground, without sway.
    let row = &rows()[2];
    let mut text = scene_of(row);
    for (key, value) in [("mu_u", "0"), ("mu_f", "0"), ("mu_p", "0"), ("eta_sl", "1")] {
        let at = text.find(&format!("{key} = ")).expect("there");
        let end = at + text[at..].find('\n').expect("a line");
        text.replace_range(at..end, &format!("{key} = \"{value}\""));
    }
    let sheet = Scene::parse(&text).expect("a scene").sheet();
    let rms = sheet.summary.iter().find(|found| found.symbol.id == "P_sl_rms");
    let mut model = model(&text);
    let greatest = get(&mut model, "p_w[1]") * get(&mut model, "S_r").abs() * TAU * get(&mut model, "n_s[1]");
    let each = greatest / get(&mut model, "z_d");
    near(rms.expect("there").value, each * 0.5_f64.sqrt(), 1e-6 * each);
}

/// Exact derivatives against differences; a case in which nothing slews has none by its speed.
#[test]
fn derivatives() {
    let mut count = 0;
    let rows = rows();
    let moving = (0..rows.len()).filter(|number| number % 5 != 0).step_by(3);
    let scenes = moving.map(|number| (scene_of(&rows[number]), ""));
    for (text, still) in scenes.chain([(READY.to_owned(), "n_s")]) {
        let mut model = model(&text);
        for psi in [0.7, 2.3, -1.9] {
            set(&mut model, "psi", psi);
            count += compared(&mut model, &["omega", "s", "z_d", still], &["lifts"]);
        }
    }
    assert!(count > 50_000, "{count}");
}

/// Mirrored, the moment about the axis is opposite and the rest is the same; two drives have half each.
#[test]
fn mirrored_and_shared() {
    for row in rows().iter().step_by(5) {
        let text = scene_of(row);
        let mut own = model(&text);
        let turned = |text: &str| {
            let mirrored = |line: &str| match line.strip_prefix("chi_w = \"") {
                Some(rest) if rest.starts_with('-') => format!("chi_w = \"{}", &rest[1..]),
                Some(rest) => format!("chi_w = \"-{rest}"),
                None => line.to_owned(),
            };
            text.lines()
                .map(mirrored)
                .fold(String::new(), |all, line| all + &line + "\n")
        };
        let mut mirrored = model(&turned(&text));
        let psi = number(row[6]);
        set(&mut own, "psi", psi);
        set(&mut mirrored, "psi", -psi);
        for case in 1..=2 {
            let outer = format!("M_z[{case}]");
            near(get(&mut mirrored, &outer), -get(&mut own, &outer), 1e-9);
            for name in ["M_st", "P_lr", "t_start", "t_stop", "T_c", "F_t"] {
                let name = format!("{name}[{case}]");
                let wanted = get(&mut own, &name);
                near(get(&mut mirrored, &name), wanted, 1e-12 * wanted.abs());
            }
        }
        let drives = row[9].split(' ').nth(1).expect("there");
        let doubled = text.replacen(
            &format!("z_d = \"{drives} \""),
            &format!("z_d = \"{} \"", 2.0 * number(drives)),
            1,
        );
        let mut double = model(&doubled);
        set(&mut double, "psi", psi);
        near(2.0 * get(&mut double, "P_M[1]"), get(&mut own, "P_M[1]"), 1e-9);
        near(get(&mut double, "M_st[1]"), get(&mut own, "M_st[1]"), 1e-9);
    }
}

#[test]
fn what_cannot_be_is_told() {
    for (old, new, told) in [
        ("z_d      = \"2\"", "z_d      = \"1.5\"", "z_d = 1.5"),
        (
            "heating  = 1 ",
            "heating  = 4 ",
            "heating in load case 4, and there are 3",
        ),
        ("heating  = 1 ", "heating  = 3 ", "in load case 3 nothing slews"),
        ("r_w = \"-0.5 m\"", "", "`r_w` is missing here"),
        ("n_s   = \"0 1/min\"", "", "`n_s` is missing here"),
        ("K_b   = \"1.1\"", "", "`K_b` is missing here"),
        ("alpha_Q = \"0 deg\"", "", "`alpha_Q` is missing here"),
        ("teeth   = \"outside\"", "teeth   = \"inside\"\n#", ""),
        (
            "r_g     = \"2.2 m\"\nteeth   = \"outside\"",
            "r_g = \"0.1 m\"\nteeth = \"inside\"",
            "a ring of r_g = 0.1 m with teeth inside",
        ),
        (
            "[supports.slewing_drive.brake]\nT_b   = \"250 N.m\"\ntau_b = \"0.3 s\"\n",
            "",
            "a coupling without a brake",
        ),
        (
            "i_sl     = \"640\"\n",
            "",
            "`i_sl` is missing in [supports.slewing_drive]",
        ),
        (
            "[supports.slewing_drive.brake]",
            "[[supports.slewing_drive.stages]]\ni_g = \"52\"\neta_g = \"90 %\"\n[supports.slewing_drive.brake]",
            "`i_sl` beside [[supports.slewing_drive.stages]], of which it follows",
        ),
        (
            "teeth   = \"outside\"",
            "teeth = \"outside\"\neta_r = \"95 %\"",
            "`eta_r` without [[supports.slewing_drive.stages]]",
        ),
    ] {
        assert!(READY.contains(old), "{old}");
        let found = match (Scene::parse(&READY.replacen(old, new, 1)), told) {
            (Ok(_), "") => continue,
            (Ok(_), _) => panic!("{told}"),
            (Err(found), _) => found,
        };
        assert!(
            !told.is_empty() && found.iter().any(|mistake| mistake.message.contains(told)),
            "{told}: {found:?}"
        );
        assert!(found.iter().all(|mistake| mistake.help.is_some()), "{found:?}");
    }
}

/// A row of the oracle with stages, pinion and ring in the place of ratio and efficiency, to which they come.
fn staged(row: &[&str]) -> String {
    let text = scene_of(row);
    let value = |name: &str| {
        let at = text.find(&format!("\n{name} = \"")).expect("there") + name.len() + 5;
        number(text[at..].split([' ', '"']).next().expect("a number"))
    };
    let (ratio, eta, [own, ring]) = (value("i_sl"), value("eta_sl"), [value("r_z"), value("r_g")]);
    let third = eta.cbrt();
    let mut staged = String::new();
    for line in text
        .lines()
        .filter(|line| !line.starts_with("i_sl = ") && !line.starts_with("eta_sl = "))
    {
        staged += line;
        staged.push('\n');
        if line.starts_with("r_g = ") {
            let _ = writeln!(staged, "eta_r = \"{third:?}\"");
        }
    }
    let of = |i: f64| format!("[[supports.slewing_drive.stages]]\ni_g = \"{i:?}\"\neta_g = \"{third:?}\"\n");
    staged + &of(3.7) + &of(ratio * own / ring / 3.7)
}

/// Stages of the same ratio and efficiency give the same results; from shaft to shaft power falls by the losses.
#[test]
fn a_gear_of_stages() {
    for row in rows() {
        let (mut own, mut staged) = (model(&scene_of(&row)), model(&staged(&row)));
        for model in [&mut own, &mut staged] {
            set(model, "psi", number(row[6]));
        }
        for name in [
            "i_sl",
            "eta_sl",
            "P_M[1]",
            "t_start[1]",
            "T_c[1]",
            "F_t[1]",
            "t_stop[1]",
            "sigma_Hz[2]",
        ] {
            let wanted = get(&mut own, name);
            let found = get(&mut staged, name);
            assert!(
                found == wanted || (found - wanted).abs() <= 1e-12 * wanted.abs(),
                "{name}: {found} {wanted}"
            );
        }
        let mut of = |name: &str| get(&mut staged, name);
        let close = |found: f64, wanted: f64| near(found, wanted, 1e-12 * wanted.abs());
        close(of("P_g0"), of("P_M[1]"));
        close(of("n_g0"), of("n_mot[1]"));
        let (mut power, mut speed, mut push) = (of("P_g0"), of("n_g0"), of("T_gp0"));
        for stage in 1..=2 {
            let [i, eta] = ["i_g", "eta_g"].map(|name| of(&format!("{name}[{stage}]")));
            (power, speed, push) = (power * eta, speed / i, push * i * eta);
            close(of(&format!("P_g[{stage}]")), power);
            close(of(&format!("n_g[{stage}]")), speed);
            close(of(&format!("T_g[{stage}]")) * TAU * speed, power);
            close(of(&format!("T_gp[{stage}]")), push);
        }
        // All pinions turn the crane.
        close(power * of("eta_r") * of("z_d"), of("M_st[1]") * TAU * of("n_s[1]"));
        close(speed * of("r_z") / of("r_g"), of("n_s[1]"));
        // The tooth's force in the start is that of the shaft, where the first case asks for most.
        let tooth = |case: u32, of: &mut dyn FnMut(&str) -> f64| of(&format!("F_t[{case}]"));
        let most = tooth(1, &mut of).max(tooth(2, &mut of));
        close(of("T_gp[2]") * of("eta_r"), most * of("r_z"));
    }
}

/// Exact derivatives by stages and pinion against differences.
#[test]
fn derivatives_by_stages() {
    let mut model = model(&staged(&rows()[4]));
    set(&mut model, "psi", 0.7);
    let count = compared(&mut model, &["omega", "s", "z_d"], &[]);
    assert!(count > 5_000, "{count}");
}

/// Exact derivatives of an engine's start against differences.
#[test]
fn derivatives_of_an_engine() {
    let points = [(400, 200), (800, 290), (1200, 330), (1450, 270), (1800, 120)];
    let mut start = String::from(
        "[supports.slewing_drive.start]\nkind = \"engine\"\nn_idle = \"450 1/min\"\nn_gov = \"1700 1/min\"\n",
    );
    for (n, torque) in points {
        let _ = writeln!(
            start,
            "[[supports.slewing_drive.start.curve]]\nn_en = \"{n} 1/min\"\nT_en = \"{torque} N.m\""
        );
    }
    let mut text = READY.to_owned();
    for (old, new) in [
        ("i_sl     = \"640\"", "i_sl = \"1000\""),
        ("P_N      = \"22 kW\"", "P_N = \"40 kW\""),
        ("n_N      = \"960 1/min\"", "n_N = \"1500 1/min\""),
        (
            "[supports.slewing_drive.brake]",
            &format!("{start}[supports.slewing_drive.brake]"),
        ),
    ] {
        assert!(text.contains(old), "{old}");
        text = text.replacen(old, new, 1);
    }
    let mut model = model(&text);
    for psi in [0.7, -1.9] {
        set(&mut model, "psi", psi);
        let count = compared(&mut model, &["omega", "s", "z_d", "n_s"], &["lifts"]);
        assert!(count > 5_000, "{count}");
    }
}

//! The plain boom on a luffing rope, with and without rope compensation: hand calculations, virtual work against equilibrium at random, and limits.

use lemnis_models::component::model::Model;
use lemnis_models::kernel::calc::Calc;
use lemnis_models::scene::Scene;
use proptest::prelude::*;

const READY: &str = include_str!("../scenes/rope_luffing.toml");
const COMPENSATED: &str = include_str!("../scenes/rope_compensation.toml");

/// A boom of 30 m whose head lies on its line, over round numbers.
fn text(change: &[(&str, &str)]) -> String {
    let mut keys = vec![
        ("l", "30 m"),
        ("X_8", "2 m"),
        ("Q", "100 kN"),
        ("E_x", "-5 m"),
        ("E_y", "12 m"),
        ("s_K", "30 m"),
        ("m_l", "6"),
        ("eta_l", "0.9"),
        ("B_x", "0 m"),
        ("B_y", "10 m"),
        ("m_h", "2"),
        ("eta_h", "0.95"),
        ("h_Q", "15 m"),
        ("G_b", "60 kN"),
        ("r_b", "14 m"),
        ("from", "30 deg"),
        ("to", "75 deg"),
    ];
    let mut kind = "rope";
    for (name, value) in change {
        match keys.iter_mut().find(|(known, _)| known == name) {
            Some(key) => key.1 = value,
            None => {
                keys.push((name, value));
                kind = "rope_compensation";
            }
        }
    }
    let line = |names: &[&str]| -> String {
        let given = keys
            .iter()
            .filter(|(name, value)| names.contains(name) && !value.is_empty());
        given.map(|(name, value)| format!("{name} = \"{value}\"\n")).collect()
    };
    format!(
        "name = \"Rope\"\ntitle = \"Rope\"\n[luffing]\nkind = \"{kind}\"\n{}[luffing.tackle]\n{}[luffing.hoist_rope]\n{}\
         [luffing.weights]\n{}[luffing.motion]\n{}step = \"1 deg\"\nspeed = \"1 deg/s\"\n",
        line(&["l", "X_8", "Q"]),
        line(&["E_x", "E_y", "s_K", "m_l", "eta_l"]),
        line(&["B_x", "B_y", "m_k", "eta_k", "m_h", "eta_h", "h_Q"]),
        line(&["G_b", "r_b"]),
        line(&["from", "to"])
    )
}

fn scene(change: &[(&str, &str)]) -> Scene {
    Scene::parse(&text(change)).unwrap_or_else(|found| panic!("{found:?}"))
}

fn index(model: &Model, name: &str) -> usize {
    let found = model.variables().iter().position(|variable| variable.name() == name);
    found.unwrap_or_else(|| panic!("no {name}"))
}

fn at(model: &mut Model, degrees: f64, name: &str) -> f64 {
    model.set(0, degrees.to_radians()).expect("an angle");
    let index = index(model, name);
    model.get(index).expect("exists")
}

/// Straight lines and lever arms by coordinates, at 30° and 60°.
#[test]
fn by_hand() {
    let mut model = scene(&[]).model().expect("exists");
    // A = K = 30 (cos 30°, sin 30°) = (25.980762, 15). E = (−5, 12): line K–E = (−30.980762, −3),
    // length √(959.807621 + 9) = 31.125675 m; arm (25.980762 · (−3) − 15 · (−30.980762)) / 31.125675
    //   = (−77.942286 + 464.711432) / 31.125675 = 12.426046 m.
    // B = (0, 10): line A–B = (−25.980762, −5), length √(675 + 25) = 26.457513 m;
    //   arm (25.980762 · (−5) − 15 · (−25.980762)) / 26.457513 = (−129.903811 + 389.711432) / 26.457513 = 9.819805 m.
    // Moment 60 kN · 14 m · cos 30° = 727.461339, load 100 · 25.980762 = 2598.076211 kN·m, hoist rope 50 · 9.819805.
    // T = (727.461339 + 2598.076211 − 490.990254) / 12.426046 = 228.113402 kN.
    // Load: y' = 25.980762 − 9.819805 / 2 = 21.070860 m, M_Q = 2107.085958 kN·m. The start: y_Q = 15 − 15 = 0.
    let first = [
        ("L_T", 31.125_675),
        ("h_T", 12.426_046),
        ("h_S", 9.819_805),
        ("T", 228_113.40),
        ("M_Q", 2_107_085.96),
        ("Y_Q", 0.0),
        ("l_l", 186.754_05),
    ];
    // 60°: A = (15, 25.980762). K–E = (−20, −13.980762), length √(400 + 195.461712) = 24.402084 m;
    //   arm (15 · (−13.980762) − 25.980762 · (−20)) / 24.402084 = 309.903811 / 24.402084 = 12.699892 m.
    // A–B = (−15, −15.980762), length √(225 + 255.384758) = 21.917681 m;
    //   arm (−239.711432 + 389.711432) / 21.917681 = 6.843790 m.
    // T = (60 · 14 / 2 + 1500 − 50 · 6.843790) / 12.699892 = (420 + 1500 − 342.189508) / 12.699892 = 124.238105 kN.
    // y_Q = 25.980762 + (21.917681 − 26.457513) / 2 − 15 = 8.710846 m. Raised, the hoist rope runs out:
    //   S_h = 100 · 0.95 / 2 = 47.5 kN, T = (1920 − 325.080032) / 12.699892 = 125.585321 kN,
    //   S_l = 125.585321 / (6 · 0.9) = 23.256541 kN. Lowered: S_h = 100 / (2 · 0.95) = 52.631579 kN,
    //   T = (1920 − 360.199482) / 12.699892 = 122.819982 kN, S_l = 122.819982 · 0.9 / 6 = 18.422997 kN.
    let second = [
        ("L_T", 24.402_084),
        ("h_T", 12.699_892),
        ("h_S", 6.843_790),
        ("T", 124_238.105),
        ("Y_Q", 8.710_846),
        ("S_h.up", 47_500.0),
        ("S_l.up", 23_256.541),
        ("S_h.down", 52_631.579),
        ("S_l.down", 18_422.997),
    ];
    for (degrees, list) in [(30.0, &first[..]), (60.0, &second[..])] {
        for (name, expected) in list {
            let found = at(&mut model, degrees, name);
            assert!(
                (found - expected).abs() <= 1e-6 * expected.abs().max(1.0),
                "{name} at {degrees}: {found} {expected}"
            );
        }
    }
}

/// Without own weight the empty boom needs no pull; with many falls of the hoist tackle its rope loses its say.
#[test]
fn limits_of_the_rope() {
    let mut light = scene(&[("Q", "0 kN"), ("G_b", "0 kN")]).model().expect("exists");
    let mut falls = scene(&[("m_h", "1e6"), ("B_y", "0.5 m")]).model().expect("exists");
    for degrees in [30.0, 52.5, 75.0] {
        assert_eq!(at(&mut light, degrees, "T"), 0.0);
        let (rise, moment) = (at(&mut falls, degrees, "A.x"), at(&mut falls, degrees, "M_Q"));
        assert!((moment - 100e3 * rise).abs() <= 1e-5 * moment, "{moment}");
        let below = at(&mut falls, degrees, "A.y") - at(&mut falls, degrees, "Y_Q");
        assert!((below - 15.0).abs() <= 1e-4, "{below}");
    }
}

/// The rod of the tackle loses its pull where load and weight stand over the foot: with the hoist rope through the foot
/// and the head on the boom's line, upright.
#[test]
fn the_boom_falls_back_beyond_upright() {
    let scene = scene(&[("B_y", "0 m"), ("B_x", "0.0001 m"), ("to", "80 deg")]);
    let sheet = scene.sheet();
    for id in ["fall_back", "fall_back_empty"] {
        let check = sheet.requirements.iter().find(|check| check.id == id).expect("checked");
        assert!(
            (check.value.to_degrees() - 90.0).abs() < 1e-3,
            "{id} {}",
            check.value.to_degrees()
        );
        assert!(check.passed());
    }
}

#[test]
fn what_cannot_be_is_refused() {
    for (change, said) in [
        (&[("B_x", "3 m"), ("B_y", "3 m")][..], "the boom meets the sheave B"),
        (&[("E_x", "5 m"), ("E_y", "-4 m")], "would have to push"),
        (&[("E_x", "15 m"), ("E_y", "25.980762113533160 m")], "its ends meet"),
    ] {
        let found = Scene::parse(&text(change)).expect_err(said);
        assert!(
            found.iter().any(|f| f.message.contains(said) && f.help.is_some()),
            "{said}: {found:?}"
        );
    }
}

#[test]
fn every_check_of_the_ready_scenes_passes() {
    for ready in [READY, COMPENSATED] {
        let scene = Scene::parse(ready).unwrap_or_else(|found| panic!("{found:?}"));
        let sheet = scene.sheet();
        assert!(sheet.requirements.len() >= 3 && !sheet.identities.is_empty());
        for check in sheet.checks() {
            assert!(check.passed(), "{} {}", check.id, check.value);
        }
    }
}

/// Three parts, two falls, at 60°, over the numbers of `by_hand`: A = (15, 25.980762), |AB| = 21.917681 m, h_S = 6.843790 m,
/// h_T = 12.699892 m; at the start, 30°, |AB| = 26.457513 m.
#[test]
fn compensation_by_hand() {
    let mut model = scene(&[("m_k", "3"), ("eta_k", "0.9")]).model().expect("exists");
    // y_Q = 25.980762 + (21.917681 − 26.457513) · 3/2 − 15 = 4.171014 m.
    // y' = 15 − 6.843790 · 3/2 = 4.734315 m, M_Q = 473.431560 kN·m. S_h = 50 kN, F_k = 150 kN;
    // by powers 100 · 15 − 150 · 6.843790 = 473.4315 kN·m.
    // T = (420 + 1500 − 150 · 6.843790) / 12.699892 = (1920 − 1026.568440) / 12.699892 = 70.349540 kN.
    // Raised, the rope runs out: S_h = 47.5, F_k = 3 · 47.5 · 0.9 = 128.25 kN,
    //   T = (1920 − 128.25 · 6.843790) / 12.699892 = (1920 − 877.716016) / 12.699892 = 82.070303 kN.
    // Lowered: S_h = 52.631579, F_k = 3 · 52.631579 / 0.9 = 175.438596 kN,
    //   T = (1920 − 175.438596 · 6.843790) / 12.699892 = (1920 − 1200.664842) / 12.699892 = 56.641046 kN.
    for (name, expected) in [
        ("Y_Q", 4.171_014),
        ("M_Q", 473_431.56),
        ("M_Q.P", 473_431.56),
        ("F_k", 150_000.0),
        ("T", 70_349.54),
        ("F_k.up", 128_250.0),
        ("T.up", 82_070.30),
        ("F_k.down", 175_438.596),
        ("T.down", 56_641.05),
    ] {
        let found = at(&mut model, 60.0, name);
        assert!(
            (found - expected).abs() <= 1e-6 * expected,
            "{name}: {found} {expected}"
        );
    }
}

/// One part is the plain rope, to the bit.
#[test]
fn one_part_is_the_plain_rope() {
    let mut plain = scene(&[]).model().expect("exists");
    let mut one = scene(&[("m_k", "1")]).model().expect("exists");
    let names: Vec<String> = plain.variables().iter().map(|variable| variable.name()).collect();
    for degrees in [30.0, 47.3, 75.0] {
        for name in &names[1..] {
            let (a, b) = (at(&mut plain, degrees, name), at(&mut one, degrees, name));
            assert_eq!(a.to_bits(), b.to_bits(), "{name} at {degrees}");
        }
        assert_eq!(
            at(&mut one, degrees, "F_k").to_bits(),
            at(&mut one, degrees, "S_h").to_bits()
        );
    }
}

/// Without parts the load hangs from the head; with as many parts as falls the level error falls as 1/H with the height H of
/// B above the foot: |AB| = H − y_A + x_A² / (2H) + …, so that y_Q goes by x_A² / (2H).
#[test]
fn limits_of_the_compensation() {
    let mut none = scene(&[("m_k", "0")]).model().expect("exists");
    for degrees in [30.0, 52.5, 75.0] {
        let below = at(&mut none, degrees, "A.y") - at(&mut none, degrees, "Y_Q");
        assert!((below - 15.0).abs() <= 1e-13, "{below}");
        assert_eq!(at(&mut none, degrees, "F_k"), 0.0);
    }
    let mut ends = scene(&[]).model().expect("exists");
    let [out, inside] = [30.0, 75.0].map(|degrees| at(&mut ends, degrees, "A.x"));
    let limit = (out * out - inside * inside) / 2.0;
    let mut last = f64::INFINITY;
    for height in [1e3, 1e4, 1e5, 1e6] {
        let high = format!("{height:e} m");
        let mut model = scene(&[("m_k", "2"), ("B_y", &high)]).model().expect("exists");
        let error = at(&mut model, 30.0, "Delta_Y") * height / limit - 1.0;
        // What is left of it goes by 1/H too, down to the rounding of H².
        assert!(
            error.abs() <= last / 9.0 + 1e-16 * height * height / limit,
            "{height}: {error}"
        );
        assert!(
            error.abs() <= 40.0 / height + 1e-16 * height * height / limit,
            "{height}: {error}"
        );
        last = error.abs();
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    /// The tackle's moment by equilibrium against the power of load and weight, and the rope's power against both.
    #[test]
    fn virtual_work_is_equilibrium(
        l in 5.0..60.0_f64, e_x in -20.0..0.0_f64, e_y in 1.0..30.0_f64, s_k in 0.3..1.0_f64,
        b_x in -10.0..-0.5_f64, b_y in 0.0..30.0_f64, m_k in 0.0..6.0_f64, m_h in 1.0..6.0_f64, q in 0.0..500.0_f64, g in 0.0..300.0_f64,
        degrees in 15.0..70.0_f64,
    ) {
        let number = |value: f64, unit: &str| format!("{value:?} {unit}");
        let (l, s_k) = (number(l, "m"), number(s_k * l, "m"));
        let (e_x, e_y) = (number(e_x, "m"), number(e_y, "m"));
        let (b_x, b_y) = (number(b_x, "m"), number(b_y, "m"));
        let (m_k, m_h, q, g) = (format!("{m_k:?}"), format!("{m_h:?}"), number(q, "kN"), number(g, "kN"));
        let change = [
            ("l", &*l), ("s_K", &*s_k), ("E_x", &*e_x), ("E_y", &*e_y), ("B_x", &*b_x), ("B_y", &*b_y),
            ("m_k", &*m_k), ("m_h", &*m_h), ("Q", &*q), ("G_b", &*g), ("r_b", "2 m"), ("from", "10 deg"), ("to", "72 deg"),
        ];
        // Where the tackle would have to push there is nothing to compare.
        if let Ok(scene) = Scene::parse(&text(&change)) {
            let mut model = scene.model().expect("exists");
            let mut get = |name| at(&mut model, degrees, name);
            let (m_d, m_q, m_g) = (get("M_D"), get("M_Q"), get("M_G"));
            let scale = m_q.abs().max(m_g.abs()).max((get("F_k") * get("h_S")).abs()).max(1.0);
            prop_assert!((m_d - m_q - m_g).abs() <= 1e-12 * scale, "{m_d} {m_q} {m_g}");
            prop_assert!((get("M_Q.P") - m_q).abs() <= 1e-12 * scale, "{m_q}");
            let power = m_d * get("omega");
            prop_assert!((get("P_l") - power).abs() <= 1e-12 * scale, "{power}");
            // The foot carries what hangs on the boom, less what its ropes carry.
            let (t, f_k) = (get("T"), get("F_k"));
            let fall = get("E_y") - get("s_K") * Calc::sin(degrees.to_radians());
            let up = get("F_O1.y") + t * fall / get("L_T") + f_k * (get("B_y") - get("A.y")) / get("L_S");
            let down = get("Q") + get("G_b");
            prop_assert!((up - down).abs() <= 1e-11 * (down + t.abs() + f_k), "{up} {down}");
        }
    }
}

/// A kind that there is not, or that is no text, is one mistake, not one for every key of another kind.
#[test]
fn a_kind_that_there_is_not() {
    for (kind, label) in [("\"ropes\"", "`ropes` is none of them"), ("3", "a TOML integer")] {
        let wrong = READY.replace("kind = \"rope\"", &format!("kind = {kind}"));
        let found = Scene::parse(&wrong).expect_err("no such kind");
        let [one] = found.as_slice() else { panic!("{found:?}") };
        assert_eq!(
            one.message,
            "`luffing.kind` is not one of double_link, rope, rope_compensation, ellipsograph, curved_trunk"
        );
        assert_eq!(one.label, label);
        assert_eq!(&wrong[one.span.clone()], kind);
    }
}

/// An empty table of weights is told by what it lacks, also where a balance and a position of the book need it.
#[test]
fn weights_of_which_all_is_missing() {
    let balance = "[luffing.balance]\nkind = \"tail\"\nG_c = \"9 kN\"\nr_c = \"1 m\"\nchi_c = \"0 deg\"\n";
    let scene = text(&[("G_b", ""), ("r_b", "")]) + balance + "[book]\npositions = [\"from\"]\n";
    let found = Scene::parse(&scene).expect_err("no weights");
    let missing = |key: &str| {
        found
            .iter()
            .any(|told| told.message.starts_with(&format!("`{key}` is missing")))
    };
    assert!(missing("G_b") && missing("r_b") && found.len() == 2, "{found:?}");
}

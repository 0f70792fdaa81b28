//! A floating crane: published numbers, box hulls in closed form, sections against the box that they make, areas against
//! energy, derivatives against differences, and what cannot be.

#[path = "common/named.rs"]
mod named;

use std::fmt::Write as _;

use lemnis_models::component::model::Model;
use lemnis_models::kernel::calc::Calc;
use lemnis_models::scene::Scene;

use named::{get, index, model, near, set};

const READY: &str = include_str!("../scenes/floating_static.toml");
const LUFFS: &str = include_str!("../scenes/floating_crane.toml");
const G: f64 = 9.81;

/// A box (m) in water of 1 t/m³ with one mass (t) at a height (m), a load (t) at a reach and a height (m).
fn scene([l, b, d]: [f64; 3], [mass, height]: [f64; 2], [load, reach, high]: [f64; 3], more: &str) -> String {
    format!(
        "name = \"Box\"\ntitle = \"Box\"\n[hull]\nrho_w = \"1000 kg/m3\"\nL = \"{l} m\"\nB = \"{b} m\"\nD = \"{d} m\"\n\
         Q = {{ input = \"{load} t\" }}\nR = {{ input = \"{reach} m\" }}\n{more}\n[[hull.masses]]\nG_m = \"{mass} t\"\n\
         x_m = \"0 m\"\nz_m = \"{height} m\"\n[hull.pedestal]\nx_s = \"0 m\"\nh_s = \"{high} m\"\n[hull.motion]\nfrom = \"0 deg\"\n\
         to = \"90 deg\"\nstep = \"15 deg\"\nspeed = \"1 deg/s\"\n"
    )
}

fn rad(degrees: f64) -> f64 {
    degrees.to_radians()
}

/// Δ 6000 t, KB 3, KM 6, KG 5.5 m: GZ(25°) = 0.35 m, 2094.9 t·m.
#[test]
fn the_published_lever_at_25_degrees() {
    let b = 216_f64.sqrt();
    let mut model = model(&scene(
        [1000.0 / b, b, 12.0],
        [6000.0, 5.5],
        [0.0, 0.0, 5.5],
        "heels = [\"25 deg\"]",
    ));
    for (name, wanted) in [("T_0", 6.0), ("z_B", 3.0), ("BM", 3.0), ("z_G", 5.5), ("GM", 0.5)] {
        near(get(&mut model, name), wanted, 1e-12);
    }
    let (sin, cos) = Calc::sin_cos(rad(25.0));
    let wanted = (0.5 + 1.5 * (sin / cos) * (sin / cos)) * sin;
    for name in ["GZ[1]", "GZ_w[1]"] {
        near(get(&mut model, name), wanted, 1e-12);
        near(get(&mut model, name), 0.35, 5e-3);
        near(6000.0 * get(&mut model, name), 2094.9, 0.05);
    }
    let area = 0.5 * (1.0 - cos) + 1.5 * (1.0 / cos + cos - 2.0);
    for name in ["e[1]", "e_w[1]"] {
        near(get(&mut model, name), area, 1e-12);
    }
}

/// A box of 65 × 12 × 8 m at a draft of 4 m, KG 4 m: 3198 t of salt water, BM 3 m, GM 1 m; 278.9 t·m at 5° with 3200 t.
#[test]
fn the_published_box() {
    let text = scene([65.0, 12.0, 8.0], [3198.0, 4.0], [0.0, 0.0, 4.0], "heels = [\"5 deg\"]");
    let mut model = model(&text.replace("1000 kg", "1025 kg"));
    for (name, wanted) in [
        ("W", 3198e3 * G),
        ("T_0", 4.0),
        ("BM", 3.0),
        ("GM", 1.0),
        ("I_T", 65.0 * 144.0),
    ] {
        near(get(&mut model, name), wanted, 1e-12 * wanted);
    }
    near(3200.0 * get(&mut model, "GM") * Calc::sin(rad(5.0)), 278.9, 0.05);
}

/// Δ 9900 t, KM 7.3, KG 6.4 m, two lifts of 50 t: KG 6.456, GM 0.844 m, list 6.087° by the metacentric height.
#[test]
fn the_published_list() {
    let b = (4.3_f64 * 72.0).sqrt();
    let mut model = model(&scene(
        [10_000.0 / (6.0 * b), b, 12.0],
        [9900.0, 6.4],
        [100.0, 9.0, 12.0],
        "",
    ));
    set(&mut model, "psi_sl", rad(90.0));
    near(get(&mut model, "z_G"), 6.456, 1e-12);
    near(get(&mut model, "GM"), 0.844, 1e-12);
    near(get(&mut model, "phi_M").to_degrees(), 6.087, 5e-4);
    // The true list is smaller: the wall-sided form GM t + BM t³/2 = M/W.
    let t = Calc::sin(get(&mut model, "phi")) / Calc::sin_cos(get(&mut model, "phi")).1;
    near(0.844 * t + 2.15 * t * t * t, 0.09, 1e-13);
}

/// Heel and trim of a box at once, before the deck's edge: its prism of water in closed form.
#[test]
fn a_box_heels_and_trims_in_closed_form() {
    let [l, b, t, kg, q, r, h]: [f64; 7] = [50.0, 20.0, 2.5, 4.0, 60.0, 22.0, 25.0];
    let mass = l * b * t - q;
    let mut model = model(&scene([l, b, 6.0], [mass, kg], [q, r, h], ""));
    for degrees in [0.0, 20.0, 45.0, 70.0, 90.0] {
        set(&mut model, "psi_sl", rad(degrees));
        let [a, across] = ["t_theta", "t_phi"].map(|name| get(&mut model, name));
        let (sin, cos) = Calc::sin_cos(rad(degrees));
        let weight = l * b * t;
        // Centre of buoyancy of a box cut by a plane that meets its sides alone.
        let centre = [
            l * l * a / (12.0 * t),
            b * b * across / (12.0 * t),
            t / 2.0 + (l * l * a * a + b * b * across * across) / (24.0 * t),
        ];
        let gravity = [q * r * cos / weight, q * r * sin / weight, (mass * kg + q * h) / weight];
        let arm = [0, 1, 2].map(|i| centre[i] - gravity[i]);
        near(arm[0] + a * arm[2], 0.0, 1e-12);
        near(arm[1] + across * arm[2], 0.0, 1e-12);
        near(get(&mut model, "T"), t, 1e-12);
        let free = 6.0 - t + l / 2.0 * a - b / 2.0 * across;
        near(
            get(&mut model, "f_3"),
            free / (1.0 + a * a + across * across).sqrt(),
            1e-12,
        );
    }
}

/// Sections of a box, with a point in the middle of the side: the same hull as L, B and D.
fn by_sections(text: &str, [l, b, d]: [f64; 3], count: usize) -> String {
    let mut cut = String::new();
    for i in 0..count {
        let x = l * (i as f64 / (count - 1) as f64 - 0.5);
        let half = b / 2.0;
        writeln!(
            cut,
            "[[hull.sections]]\nx_h = \"{x} m\"\npoints = [\"0 m, 0 m\", \"{half} m, 0 m\", \"{half} m, {} m\", \"{half} m, {d} m\"]",
            d / 2.0
        )
        .expect("a text");
    }
    text.replace(&format!("L = \"{l} m\"\nB = \"{b} m\"\nD = \"{d} m\"\n"), "")
        .replace("[[hull.masses]]", &format!("{cut}[[hull.masses]]"))
}

#[test]
fn sections_make_the_same_box() {
    let size = [50.0, 20.0, 6.0];
    let heels = "heels = [\"10 deg\", \"40 deg\", \"70 deg\"]\nphi_f = \"40 deg\"";
    let text = scene(size, [2440.0, 4.0], [60.0, 22.0, 25.0], heels);
    let names = [
        "T", "phi", "theta", "f_low", "GM", "GM_L", "x_B", "phi_d", "phi_b", "A_res", "GZ[1]", "GZ[2]", "GZ[3]", "e[3]",
    ];
    let [mut built, mut cut] = [text.clone(), by_sections(&text, size, 5)].map(|text| model(&text));
    for degrees in [10.0, 60.0] {
        for model in [&mut built, &mut cut] {
            set(model, "psi_sl", rad(degrees));
        }
        for name in names {
            let wanted = get(&mut built, name);
            near(get(&mut cut, name), wanted, 1e-11 * wanted.abs().max(1.0));
        }
    }
}

/// The heel beyond the deck's edge of a box that has turned by 90°: it floats on its side, in closed form.
#[test]
fn the_lever_beyond_deck_and_bilge() {
    // Half deep, the centre of gravity in the middle: a box is a box from its side too.
    let (b, d) = (12.0, 8.0);
    let mut model = model(&scene(
        [65.0, b, d],
        [65.0 * b * d / 2.0, 2.0],
        [0.0, 0.0, 2.0],
        "heels = [\"80 deg\"]",
    ));
    // At 80° the water passes through the middle of the section: a parallelogram cut off by a line through its centre, at
    // 10° to the deck's normal, between bottom and deck.
    let slope = Calc::sin(rad(10.0)) / Calc::sin_cos(rad(10.0)).1;
    let half = b / 2.0;
    // The wet half: strips along z of a breadth half ± slope (z − d/2).
    let strips = 200_000;
    let (mut volume, mut side, mut up) = (0.0, 0.0, 0.0);
    for i in 0..strips {
        let z = d * (f64::from(i) + 0.5) / f64::from(strips);
        let from = slope * (z - d / 2.0);
        let width = half - from;
        volume += width;
        side += width * (from + width / 2.0);
        up += width * z;
    }
    let [y, z] = [side / volume, up / volume];
    let (sin, cos) = Calc::sin_cos(rad(80.0));
    near(get(&mut model, "GZ[1]"), y * cos + (z - 2.0) * sin, 1e-9);
}

/// Load lost: areas and roll against the closed form of a box before the deck's edge, e = GM (1 − cos φ) + BM/2 (1/cos φ +
/// cos φ − 2), and against an integration of the lever.
#[test]
fn a_load_is_lost() {
    let [l, b, q, r] = [50.0, 20.0, 60.0, 22.0];
    let more = "phi_f = \"12 deg\"\n[hull.loss]\nkind = \"ratio\"";
    let text = scene([l, b, 6.0], [2440.0, 4.0], [q, r, 25.0], "");
    let text = text.replace("[[hull.masses]]", &format!("{more}\n[[hull.masses]]"));
    let text = text
        .replacen("phi_f = \"12 deg\"\n", "", 1)
        .replace("rho_w", "phi_f = \"12 deg\"\nrho_w");
    let mut model = model(&text);
    set(&mut model, "psi_sl", rad(90.0));
    let heel = get(&mut model, "phi");
    let t = 2440.0 / (l * b);
    let (bm, gm) = (b * b / (12.0 * t), t / 2.0 + b * b / (12.0 * t) - 4.0);
    let area = |phi: f64| {
        let cos = Calc::sin_cos(phi).1;
        gm * (1.0 - cos) + bm / 2.0 * (1.0 / cos + cos - 2.0)
    };
    near(get(&mut model, "phi_Q0"), 0.0, 1e-13);
    near(get(&mut model, "A_I"), area(heel), 1e-13);
    near(get(&mut model, "A_II"), area(rad(12.0)), 1e-13);
    // Alike on both sides: it rolls as far as it came from.
    near(get(&mut model, "phi_2"), -heel, 1e-10);
    near(get(&mut model, "d_A"), area(rad(12.0)) - 1.4 * area(heel), 1e-13);
    let lever = |phi: f64| {
        let (sin, cos) = Calc::sin_cos(phi);
        (gm + bm / 2.0 * (sin / cos) * (sin / cos)) * sin
    };
    let steps = 1000;
    let sum: f64 = (0..steps)
        .map(|i| lever(heel * (f64::from(i) + 0.5) / f64::from(steps)) * heel / f64::from(steps))
        .sum();
    near(get(&mut model, "A_I"), sum, 1e-8);
}

/// A sudden wind on a box before the deck's edge: rest, roll and the moment that capsizes in closed form.
#[test]
fn a_sudden_wind() {
    let more = "[hull.gust]\np_g = \"5000 Pa\"\nphi_a = \"3 deg\"\n\
                [hull.wind]\np_w = \"0 Pa\"\nchi_w = \"0 deg\"\nz_l = \"0 m\"\n[[hull.wind.areas]]\nA_w = \"100 m2\"\n\
                z_w = \"10 m\"\n";
    let text = scene(
        [50.0, 20.0, 6.0],
        [2440.0, 4.0],
        [60.0, 22.0, 25.0],
        "phi_f = \"12 deg\"",
    );
    let mut model = model(&text.replace("[hull.motion]", &format!("{more}[hull.motion]")));
    set(&mut model, "psi_sl", rad(90.0));
    let weight = 2500e3 * G;
    let (bm, gm) = (
        400.0 / 30.0,
        1.25 + 400.0 / 30.0 - (2440.0 * 4.0 + 60.0 * 25.0) / 2500.0,
    );
    let [load, gust] = [60e3 * G * 22.0 / weight, 5000.0 * 100.0 * 10.0 / weight];
    near(get(&mut model, "M_g"), 5e6, 1e-6);
    let slope = |heel: f64| Calc::sin(heel) / Calc::sin_cos(heel).1;
    let t = slope(get(&mut model, "phi_s"));
    near(gm * t + bm / 2.0 * t * t * t, load + gust, 1e-13);
    let rise = |heel: f64, lever: f64| {
        let (sin, cos) = Calc::sin_cos(heel);
        gm * (1.0 - cos) + bm / 2.0 * (1.0 / cos + cos - 2.0) - lever * sin
    };
    let from = get(&mut model, "phi") - rad(3.0);
    let rolls = get(&mut model, "phi_dyn");
    assert!(rolls > get(&mut model, "phi_s"));
    near(rise(rolls, load + gust), rise(from, load + gust), 1e-13);
    // The curve of areas bends upward up to the last heel: the line ends there.
    let end = rad(12.0);
    let moment = weight * (rise(end, load) - rise(from, load)) / (end - from);
    near(get(&mut model, "M_c"), moment, 1e-9 * moment);
    near(get(&mut model, "K_c"), moment / 5e6, 1e-9 * moment / 5e6);
}

/// The area under the lever of the ready scene, tanks and deck's edge included, against the energy: by the midpoint rule, with
/// the first term of what it leaves, h²/24 of the change of the slope.
#[test]
fn areas_are_energies() {
    let list: Vec<String> = (0..600)
        .map(|i| format!("\"{} deg\"", 0.05 + 0.1 * f64::from(i)))
        .collect();
    let (mut levers, mut whole, step) = (Vec::new(), 0.0, rad(0.1));
    for part in list.chunks(60) {
        let text = READY.replace(
            "[\"5 deg\", \"10 deg\", \"15 deg\", \"20 deg\", \"30 deg\"]",
            &format!("[{}, \"60 deg\"]", part.join(", ")),
        );
        let mut model = model(&text);
        levers.extend((1..=part.len()).map(|i| get(&mut model, &format!("GZ[{i}]"))));
        whole = get(&mut model, &format!("e[{}]", part.len() + 1));
    }
    let sum: f64 = levers.iter().map(|lever| lever * step).sum();
    let slopes = [levers[0] / (step / 2.0), (levers[599] - levers[598]) / step];
    near(sum + step * step / 24.0 * (slopes[1] - slopes[0]), whole, 1e-8);
}

/// Exact derivatives against central differences, by inputs and parameters.
#[test]
fn derivatives() {
    let mut model = model(READY);
    set(&mut model, "psi_sl", rad(50.0));
    let results = [
        "phi", "theta", "T", "f_low", "GM", "GZ[3]", "e[3]", "A_res", "phi_2", "A_I", "A_II", "phi_Q0", "phi_d",
    ];
    let by = [
        "psi_sl", "R", "Q", "B", "L", "D", "h_s", "x_m[2]", "G_m[3]", "h_t[1]", "b_t[2]", "y_t[1]", "p_w", "phi_h[3]",
    ];
    differences(&mut model, &by, &results);
}

/// As in motion, of a crane that luffs: static results, accelerations and the drives' moments, by states, commands and parameters.
#[test]
fn derivatives_of_a_crane_that_luffs() {
    // With its commands as inputs.
    let lines = LUFFS.lines().map(|line| match line.split_once(" = { between") {
        Some((command, _)) => format!("{command} = \"0 deg/s\"\n"),
        None => format!("{line}\n"),
    });
    let mut model = model(&lines.collect::<String>());
    for (name, value) in [
        ("psi_sl", rad(50.0)),
        ("theta_1", rad(60.0)),
        ("omega_sl", 0.05),
        ("omega_1", 0.01),
        ("omega_x", 0.02),
        ("omega_y", -0.01),
    ] {
        set(&mut model, name, value);
    }
    let results = [
        "R",
        "h_s",
        "phi",
        "theta",
        "T",
        "W_c",
        "M_Tc",
        "M_Vc",
        "M_sl0",
        "M_10",
        "S_R",
        "M_sl",
        "M_1",
        "der(v_G)",
        "der(omega_x)",
        "der(omega_y)",
        "der(w_x)",
        "der(omega_1)",
    ];
    let by = [
        "psi_sl",
        "theta_1",
        "omega_sl",
        "omega_1",
        "omega_x",
        "omega_y",
        "r_x",
        "Q",
        "h_1",
        "x_s",
        "G_u[1]",
        "y_u[2]",
        "z_u[3]",
        "J_x",
        "T_1",
        "omega_csl",
        "omega_c1",
    ];
    differences(&mut model, &by, &results);
}

fn differences(model: &mut Model, by: &[&str], results: &[&str]) {
    for by in by {
        let at = index(model, by);
        let value = get(model, by);
        let quantity = model.variables()[at].quantity();
        let step = 1e-5 * value.abs().max(1e-3);
        for result in results {
            let of = index(model, result);
            let mut tangent = model.tangent(&|other| f64::from(other == quantity));
            let exact = model.derivative(&mut tangent, of).expect("smooth here");
            let mut ends = [step, -step].map(|step| {
                set(model, by, value + step);
                get(model, result)
            });
            set(model, by, value);
            ends[0] -= ends[1];
            let difference = ends[0] / (2.0 * step);
            let size = get(model, result).abs().max(1e-3) / value.abs().max(1e-3);
            assert!(
                (exact - difference).abs() <= 1e-6 * size.max(exact.abs()),
                "{result} by {by}: {exact}, {difference}"
            );
        }
    }
}

/// What was asked before changes no bit.
#[test]
fn results_do_not_depend_on_the_past() {
    let ask = |model: &mut Model| ["phi", "theta", "T", "phi_2", "GZ[5]"].map(|name| get(model, name).to_bits());
    let mut fresh = model(READY);
    set(&mut fresh, "psi_sl", 1.0);
    let wanted = ask(&mut fresh);
    let mut used = model(READY);
    for psi in [0.0, 3.0, 5.0, 1.0] {
        set(&mut used, "psi_sl", psi);
        ask(&mut used);
    }
    assert_eq!(ask(&mut used), wanted);
}

/// No number where nothing floats upright: each says what it is by its figures.
#[test]
fn what_cannot_be() {
    let refused = |text: String| {
        let found = Scene::parse(&text).expect_err("not possible");
        found.into_iter().map(|mistake| mistake.message).collect::<String>()
    };
    let size = [50.0, 20.0, 6.0];
    let high = refused(scene(size, [2440.0, 20.0], [0.0, 22.0, 25.0], ""));
    assert!(
        high.contains("GM = -") && high.contains("lolls to a heel of about"),
        "{high}"
    );
    let heavy = refused(scene(size, [6100.0, 1.0], [0.0, 22.0, 25.0], ""));
    assert!(
        heavy.contains("it sinks") && heavy.contains("nabla = 6100 m3"),
        "{heavy}"
    );
    let wet = refused(scene(size, [2440.0, 4.0], [600.0, 22.0, 25.0], ""));
    assert!(
        wet.contains("deck is under water") && wet.contains("f_low = -"),
        "{wet}"
    );
}

/// The book's checks are passed.
#[test]
fn the_ready_scene() {
    let scene = Scene::parse(READY).unwrap_or_else(|mistakes| panic!("{mistakes:?}"));
    assert_eq!(scene.levels(), ["static"]);
    let sheet = scene.sheet();
    assert_eq!((sheet.identities.len(), sheet.requirements.len()), (2, 12));
    for check in sheet.checks() {
        assert!(check.passed(), "{} by {}", check.id, check.value);
    }
}

/// GM = T/2 + B²/(12 T) − z_G of a box, with its own load and with that of a further case, each against a limit of its own.
#[test]
fn the_least_metacentric_height_is_judged() {
    let ([l, b, d], [mass, low], [load, high]) = ([60.0, 24.0, 4.5], [2000.0, 4.0], [50.0, 30.0]);
    let height = |load: f64| {
        let draft = (mass + load) / (l * b);
        draft / 2.0 + b * b / (12.0 * draft) - (mass * low + load * high) / (mass + load)
    };
    let wanted = [height(load), height(20.0)];
    for (part, passes) in [(0.999, true), (1.001, false)] {
        let [own, other] = wanted.map(|height| format!("{} m", part * height));
        let text = scene([l, b, d], [mass, low], [load, 5.0, high], "load_case = \"A\"")
            + &format!(
                "[[hull.load_cases]]\nname = \"B\"\nQ_k = \"20 t\"\nGM_min = \"{other}\"\n\
                 [hull.limits]\nGM_min = {{ value = \"{own}\", source = \"2008 IS Code, A 2.2.4\" }}\n"
            );
        let sheet = Scene::parse(&text).expect("legal").sheet();
        let cases = sheet.cases.as_ref().expect("two cases");
        let judged: Vec<_> = (cases.judged.iter())
            .filter(|one| one.check.id == "afloat_metacentric")
            .collect();
        assert_eq!(judged.len(), 2);
        for (one, wanted) in judged.iter().zip(wanted) {
            near(one.check.value, wanted, 1e-12);
            assert_eq!(one.check.passed(), passes);
            let source = one.criterion.as_ref().map(|text| text.english().to_owned());
            assert_eq!(source.as_deref(), (one.case == 0).then_some("2008 IS Code, A 2.2.4"));
        }
        let own = sheet
            .checks()
            .find(|check| check.id == "afloat_metacentric")
            .expect("asked");
        near(own.value, wanted[0], 1e-12);
    }
}

//! The single boom on guide and link: hand calculations, its bars as circles and lines, virtual work against equilibrium at
//! random and over all decades of length, every kind of balance.

use lemnis_models::component::model::Model;
use lemnis_models::kernel::calc::Calc;
use lemnis_models::scene::Scene;
use proptest::prelude::*;

const READY: &str = include_str!("../scenes/ellipsograph.toml");

/// Link and lower part of 10 m, and the upper part; over round numbers.
fn text(a: &str, rest: &str) -> String {
    format!(
        "name = \"Guide\"\ntitle = \"Guide\"\n[luffing]\nkind = \"ellipsograph\"\nc = \"10 m\"\na = \"{a}\"\nX_8 = \"2 m\"\n\
         Q = \"100 kN\"\n[luffing.motion]\nfrom = \"20 deg\"\nto = \"80 deg\"\nstep = \"1 deg\"\nspeed = \"1 deg/s\"\n{rest}"
    )
}

const WEIGHTS: &str =
    "[luffing.weights]\nG_b = \"60 kN\"\nr_b = \"8 m\"\nchi_b = \"0 deg\"\nG_l = \"20 kN\"\nr_l = \"5 m\"\n";

fn model(text: &str) -> Model {
    let scene = Scene::parse(text).unwrap_or_else(|found| panic!("{found:?}"));
    scene.model().expect("exists")
}

fn at(model: &mut Model, degrees: f64, name: &str) -> f64 {
    model.set(0, degrees.to_radians()).expect("an angle");
    let index = model.variables().iter().position(|variable| variable.name() == name);
    let index = index.unwrap_or_else(|| panic!("no {name}"));
    model.get(index).expect("exists")
}

/// At 30° with c = 10 m and a = 15 m, and without the difference of the two.
#[test]
fn by_hand() {
    // C = (8.660254, −5), B = (0, −10), A = C + 15 (0.866025, 0.5) = (21.650635, 2.5). P = (17.320508, −10).
    // M_Q = 100 · (21.650635 − 17.320508) = 433.012702 kN·m. Own weights: boom's centre at 8 · 0.866025 = 6.928203 m, link's
    // at 5 · 0.866025 = 4.330127 m: M_G = 60 · (6.928203 − 17.320508) − 20 · 4.330127 = −623.538291 − 86.602540 = −710.140831.
    // M_D = −277.128129 kN·m. Boom about C: 100 · (21.650635 − 8.660254) + 60 · (6.928203 − 8.660254) = 1299.038106 −
    // 103.923048 = 1195.115057 kN·m over C above B, 5 m: F_B = 239.023011 kN. On the boom at C: (−239.023011, 160) kN.
    // Along the link (0.866025, −0.5): 239.023011 · 0.866025 + 160 · 0.5 = 286.999999; on the frame also the link's 20 kN.
    let expected = [
        ("theta_l", -std::f64::consts::FRAC_PI_6),
        ("A.x", 21.650_635),
        ("A.y", 2.5),
        ("B.y", -10.0),
        ("R", 23.650_635),
        ("P.x", 17.320_508),
        ("P.y", -10.0),
        ("M_Q", 433_012.702),
        ("M_Q.P", 433_012.702),
        ("M_G", -710_140.831),
        ("M_D", -277_128.129),
        ("F_B.x", 239_023.011),
        ("F_C.x", -239_023.011),
        ("F_C.y", 160_000.0),
        ("N_l", 287_000.0),
        ("F_O1.x", -239_023.011),
        ("F_O1.y", 180_000.0),
        // 1 deg/s: x′_A = −25 · 0.5, y′_A = 5 · 0.866025, y′_B = −17.320508 m.
        ("V_AX", -0.218_166_156),
        ("V_AY", 0.075_574_973),
        ("V_B", -0.302_299_894),
        ("omega_l", -0.017_453_293),
        ("P_D", -4_836.798_3),
    ];
    let mut model = model(&text("15 m", WEIGHTS));
    for (name, expected) in expected {
        let found = at(&mut model, 30.0, name);
        assert!(
            (found - expected).abs() <= 3e-8 * expected.abs(),
            "{name}: {found} {expected}"
        );
    }
}

/// With both parts of the boom equal the head moves level, and the load has no moment: by virtual work, by the instantaneous
/// centre below the head, and by the forces of guide and link, to 1e-13 of Q x_A.
#[test]
fn the_head_moves_level() {
    let mut model = model(&text("10 m", ""));
    for step in 0..=600 {
        let degrees = 20.0 + 0.1 * f64::from(step);
        let mut get = |name| at(&mut model, degrees, name);
        let scale = 100e3 * get("A.x");
        let by_pins = get("C.y") * get("F_C.x") - get("C.x") * get("F_C.y");
        for moment in [get("M_Q"), get("M_Q.P"), get("M_D"), by_pins] {
            assert!(moment.abs() <= 1e-13 * scale, "{degrees}: {moment}");
        }
        assert!(get("A.y").abs() <= 1e-13 * get("A.x"), "{}", get("A.y"));
        assert!((get("P.x") - get("A.x")).abs() <= 1e-13 * get("A.x"));
    }
}

/// Balances of every kind at the link: the residual vanishes for the exact ones, the whole moment is what the drive gives.
#[test]
fn balances_of_every_kind() {
    // G_b (2c − r_b) + G_l r_l = 60 · 12 + 20 · 5 = 820 kN·m.
    let exact = "kind = \"tail\"\nG_c = \"410 kN\"\nr_c = \"2 m\"\nchi_c = \"0 deg\"\n";
    let parallel = "kind = \"parallelogram\"\nG_c = \"205 kN\"\nr_c = \"4 m\"\nchi_c = \"0 deg\"\nr_1 = \"2 m\"\n\
                    alpha_K = \"90 deg\"\nd_1 = \"5 m\"\ndelta_1 = \"170 deg\"\n";
    let curved = "kind = \"curved_rail\"\nG_c = \"300 kN\"\nr_1 = \"9 m\"\nalpha_K = \"60 deg\"\nL_r = \"20 m\"\ny_0 = \"8 m\"\n\
                  phi_0 = \"-50 deg\"\n";
    let straight = "kind = \"straight_rail\"\nG_c = \"90 kN\"\nr_1 = \"9 m\"\nalpha_K = \"0 deg\"\nH_x = \"-1 m\"\n\
                    H_y = \"6 m\"\nlambda = \"80 deg\"\n";
    let lever = "kind = \"lever\"\nbranch = \"left\"\nd_1 = \"8 m\"\ndelta_1 = \"100 deg\"\nr_1 = \"3 m\"\n\
                 alpha_K = \"20 deg\"\nl_1 = \"8 m\"\nR_1 = \"3 m\"\nchi_5 = \"150 deg\"\nM_5 = \"500 kN.m\"\n";
    for (kind, vanishes) in [
        (exact, true),
        (parallel, true),
        (curved, true),
        (straight, false),
        (lever, false),
    ] {
        let scene = text("15 m", &format!("{WEIGHTS}[luffing.balance]\n{kind}"));
        let scene = Scene::parse(&scene).unwrap_or_else(|found| panic!("{kind}: {found:?}"));
        let mut model = scene.model().expect("exists");
        for degrees in [20.0, 36.5, 50.0, 80.0] {
            let mut get = |name| at(&mut model, degrees, name);
            let (m_q, m_g, m_d) = (get("M_Q"), get("M_G"), get("M_D"));
            let (m_0, m_ur, left) = (get("M_0"), get("M_ur"), get("dM"));
            let scale = m_q.abs().max(m_g.abs()).max(m_ur.abs());
            assert_eq!(m_0.to_bits(), m_g.to_bits());
            assert!((m_0 + m_ur - left).abs() <= 1e-13 * scale);
            assert!((m_q + left - m_d).abs() <= 1e-13 * scale, "{kind}");
            assert!((get("M_sum") - m_d).abs() <= 1e-13 * scale);
            assert!((get("M_D_0") - m_q - m_g).abs() <= 1e-13 * scale);
            if vanishes {
                assert!(left.abs() <= 1e-12 * scale, "{kind} {degrees}: {left}");
            }
        }
        let sheet = scene.sheet();
        assert_eq!(sheet.identities.len(), 4, "energy, centre, power, equilibrium");
        for check in sheet.checks() {
            assert!(check.passed(), "{kind} {} {}", check.id, check.value);
        }
    }
}

#[test]
fn what_cannot_be_is_refused() {
    let level = [
        ("from = \"20 deg\"", "from = \"-5 deg\""),
        ("to = \"80 deg\"", "to = \"180 deg\""),
    ];
    for (old, new) in level {
        let found = Scene::parse(&text("10 m", "").replace(old, new)).expect_err(new);
        let [one] = found.as_slice() else { panic!("{found:?}") };
        assert!(one.message.contains("the boom lies level at phi ="), "{}", one.message);
        assert!(one.help.is_some());
    }
    // The working range is none of the angle's.
    let mut model = model(&text("10 m", ""));
    model.set(0, 0.0).expect("an angle");
    let guide = model.variables().iter().position(|variable| variable.name() == "F_B.x");
    let fault = model.get(guide.expect("there")).expect_err("no force holds the head");
    assert!(
        fault.outside && fault.message.contains("the boom lies level"),
        "{}",
        fault.message
    );
    assert_eq!(at(&mut model, 0.0, "B.y"), 0.0);
}

#[test]
fn every_check_of_the_ready_scene_passes() {
    let scene = Scene::parse(READY).unwrap_or_else(|found| panic!("{found:?}"));
    let sheet = scene.sheet();
    assert_eq!((sheet.requirements.len(), sheet.identities.len()), (5, 4));
    for check in sheet.checks() {
        assert!(check.passed(), "{} {}", check.id, check.value);
    }
}

/// What is greatest by amount keeps to its limit by amount: the drive of the ready scene holds the boom back, by 37.8 kN·m.
#[test]
fn a_limit_is_one_of_the_amount() {
    for (limit, passes) in [("38 kN.m", true), ("37 kN.m", false)] {
        let text = READY.replace("M_D_max   = \"50 kN.m\"", &format!("M_D_max = \"{limit}\""));
        let sheet = Scene::parse(&text).expect("legal").sheet();
        let check = sheet.requirements.iter().find(|check| check.id == "ellipsograph_drive");
        let check = check.expect("checked");
        assert!((check.value - 37_771.0).abs() < 1.0, "{}", check.value);
        assert_eq!(check.passed(), passes, "{limit}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    /// The bars as circles and lines, over all decades of length: B and C and O1 at their distances, A on the boom's line, the
    /// drive's moment by the forces of the link against virtual work.
    #[test]
    fn bars_and_forces_agree(
        lengths in [(-3..5_i32, 1.0..10.0_f64), (-4..6_i32, 1.0..10.0_f64)], q in 1.0..1e6_f64, g_b in 1.0..1e6_f64,
        r_b in 0.1..3.0_f64, chi in -30.0..30.0_f64, g_l in 1.0..1e5_f64, r_l in 0.1..1.0_f64, degrees in 1.0..179.0_f64,
    ) {
        let [c, a] = lengths.map(|(decade, number)| number * 10_f64.powi(decade));
        let weights = format!(
            "[luffing.weights]\nG_b = \"{g_b:e} N\"\nr_b = \"{:e} m\"\nchi_b = \"{chi} deg\"\nG_l = \"{g_l:e} N\"\nr_l = \"{:e} m\"\n",
            r_b * c, r_l * c
        );
        let scene = text("10 m", &weights)
            .replace("c = \"10 m\"", &format!("c = \"{c:e} m\""))
            .replace("a = \"10 m\"", &format!("a = \"{a:e} m\""))
            .replace("100 kN", &format!("{q:e} N"))
            .replace("20 deg", "1 deg")
            .replace("80 deg", "179 deg");
        let mut model = model(&scene);
        let mut get = |name| at(&mut model, degrees, name);
        let (joint, head, foot) = ([get("C.x"), get("C.y")], [get("A.x"), get("A.y")], get("B.y"));
        let long = c + a;
        prop_assert!((Calc::sqrt(joint[0] * joint[0] + joint[1] * joint[1]) - c).abs() <= 1e-14 * c);
        prop_assert!((Calc::sqrt(joint[0] * joint[0] + (joint[1] - foot).powi(2)) - c).abs() <= 1e-14 * c);
        let reach = Calc::sqrt(head[0] * head[0] + (head[1] - foot).powi(2));
        prop_assert!((reach - long).abs() <= 1e-14 * long, "{reach} {long}");
        let beside = head[0] * (joint[1] - foot) - (head[1] - foot) * joint[0];
        prop_assert!(beside.abs() <= 1e-14 * long * c, "{beside}");
        // About O1: the boom's force on the link, the link's weight, the drive.
        let force = [get("F_C.x"), get("F_C.y")];
        let boom = [joint[0] * force[1], joint[1] * force[0]];
        let link = g_l * r_l * joint[0];
        let scale = boom[0].abs().max(boom[1].abs()).max(link.abs()).max(f64::MIN_POSITIVE);
        prop_assert!((get("M_D") - (boom[1] - boom[0] - link)).abs() <= 1e-11 * scale);
        prop_assert!((get("M_Q") - get("M_Q.P")).abs() <= 1e-14 * q * long);
        prop_assert!((get("F_B.x") + force[0]).abs() == 0.0);
        // The power of load and weights is that of the drive: heights by their change over a small turn, both ways.
        let turn = 1e-4_f64;
        let mut height = |degrees: f64| {
            let b_y = at(&mut model, degrees, "B.y");
            let (sin, _) = Calc::sin_cos((degrees + chi).to_radians());
            q * at(&mut model, degrees, "A.y") + g_b * (b_y + r_b * c * sin) + g_l * r_l * 0.5 * b_y
        };
        let rise = (height(degrees + turn) - height(degrees - turn)) / (2.0 * turn.to_radians());
        let scale = q * long + g_b * (c + r_b * c) + g_l * c;
        prop_assert!((rise - at(&mut model, degrees, "M_D")).abs() <= 1e-8 * scale, "{rise}");
    }
}

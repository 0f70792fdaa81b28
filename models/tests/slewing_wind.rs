//! Wind on what slews by itself: its moment by hand, a pendulum about the direction to which it blows, what holds it.

#[path = "common/named.rs"]
mod named;

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use lemnis_models::scene::Scene;

use named::{get, index, model, near, set};

const G: f64 = 9.81;
/// Inertia without the load (kg·m²), load (kg), reach (m), wind area (m²) with its place (m), density of the air (kg/m³).
const J: f64 = 5e6;
const MASS: f64 = 10e3;
const R: f64 = 20.0;
const AREA: f64 = 120.0;
const PLACE: f64 = 7.0;
const RHO: f64 = 1.25;

fn scene(level: &str, keys: &str, air: &str) -> String {
    format!(
        "name = \"Test\"\ntitle = \"Test\"\n[slewing]\nfidelity = \"{level}\"\nR = \"20 m\"\nQ = \"10 t\"\nJ_sl = \"5e6 kg.m2\"\n\
         A_ws = \"120 m2\"\nr_ws = \"7 m\"\n{keys}\n[slewing.motion]\nfrom = \"0 deg\"\nto = \"90 deg\"\nstep = \"5 deg\"\n\
         speed = \"6 deg/s\"\n[slewing.air]\nrho_air = \"1.25 kg/m3\"\n{air}\n"
    )
}

/// Greatest moment (N·m) of a wind (m/s).
fn most(speed: f64) -> f64 {
    0.5 * RHO * speed * speed.abs() * AREA * PLACE
}

/// Time (s) of a full swing of a pendulum with a frequency (rad/s) of small swings, from rest at an angle (rad): by the mean of
/// Gauss.
fn swing(own: f64, from: f64) -> f64 {
    let (mut a, mut b) = (1.0, libm::cos(0.5 * from));
    for _ in 0..8 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    TAU / (own * a)
}

/// M_ws = ½ ρ v |v| A_ws r_ws sin(χ − ψ), with the wind from either side; the drive gives what friction and slope leave.
#[test]
fn moment_of_the_wind_by_hand() {
    let keys = "c_sl = \"100 kN.m.s\"\nM_Fsl = \"30 kN.m\"";
    let slope = "v_air = \"12 m/s\"\nchi_air = \"75 deg\"\n[slewing.slope]\ngamma_s = \"1 deg\"\nG_u = \"200 kN\"\nr_u = \"-1 m\"";
    let mut model = model(&scene("static", keys, slope));
    let omega = 6.0 * PI / 180.0;
    for psi in [-2.0, 0.0, 0.7, 3.0] {
        for (speed, to) in [(12.0, 75.0), (-12.0, 75.0), (12.0, -105.0), (0.0, 75.0), (30.0, 10.0)] {
            set(&mut model, "psi_sl", psi);
            set(&mut model, "v_air", speed);
            set(&mut model, "chi_air", to * PI / 180.0);
            let wind = most(speed) * libm::sin(to * PI / 180.0 - psi);
            let tilt = -(-200e3 + MASS * G * R) * libm::sin(PI / 180.0) * libm::sin(psi);
            near(get(&mut model, "p_ws"), 0.5 * RHO * speed * speed.abs(), 1e-12 * 600.0);
            near(get(&mut model, "M_ws"), wind, 1e-12 * most(30.0));
            near(
                get(&mut model, "M_st"),
                100e3 * omega + 30e3 - tilt - wind,
                1e-12 * most(30.0),
            );
        }
    }
}

/// Without friction all that slews is a pendulum about the direction to which the wind blows, as wide swings have it too, and its
/// energy ½ J ω² − M cos(χ − ψ) stays.
#[test]
fn a_weather_vane() {
    for (from, level, inertia) in [
        (0.01, "rigid", J + MASS * R * R),
        (2.5, "rigid", J + MASS * R * R),
        (1.0, "swing", J),
    ] {
        // A load that swings, and weighs next to nothing, is no part of what slews.
        let rope = if level == "swing" { "l_R = \"15 m\"\n" } else { "" };
        let text = scene(
            level,
            &format!("{rope}psi_sl = \"{} rad\"", 0.3 - from),
            "v_air = \"15 m/s\"\nchi_air = \"0.3 rad\"",
        );
        let text = if level == "swing" {
            text.replace("\"10 t\"", "\"1e-6 kg\"")
        } else {
            text
        };
        let mut model = model(&text);
        let time = swing((most(15.0) / inertia).sqrt(), from);
        model.advance(0.0, 0.25 * time).expect("runs");
        near(get(&mut model, "psi_sl"), 0.3, 1e-7 * from);
        let energy = most(15.0) * (1.0 - libm::cos(from));
        near(
            0.5 * inertia * get(&mut model, "omega_sl").powi(2),
            energy,
            1e-7 * energy,
        );
        model.advance(0.25 * time, 0.5 * time).expect("runs");
        near(get(&mut model, "psi_sl"), 0.3 + from, 1e-7 * from);
    }
}

/// Friction holds a wind a little weaker than itself, from either side, and not one that is a little stronger.
#[test]
fn friction_holds_the_wind() {
    for side in [1.0, -1.0] {
        let text = scene("rigid", "M_Fsl = \"100 kN.m\"", "");
        let mut model = model(&text);
        let holds = (100e3 / most(1.0)).sqrt();
        set(&mut model, "chi_air", side * FRAC_PI_2);
        set(&mut model, "v_air", holds * (1.0 - 1e-7));
        model.advance(0.0, 5.0).expect("runs");
        near(get(&mut model, "psi_sl"), 0.0, 0.0);
        near(get(&mut model, "M_Rsl"), -side * 100e3, 1.0);
        set(&mut model, "v_air", holds * (1.0 + 1e-7));
        model.advance(5.0, 10.0).expect("runs");
        assert!(side * get(&mut model, "psi_sl") > 0.0, "it turns");
    }
}

/// Derivatives of moment and acceleration in angle, wind and direction against differences, in still air too.
#[test]
fn derivatives_against_differences() {
    let mut model = model(&scene("rigid", "omega_sl = \"3 deg/s\"", "v_air = \"15 m/s\""));
    for (speed, to) in [(15.0, 0.4), (-8.0, 2.0), (0.0, 1.0)] {
        set(&mut model, "v_air", speed);
        set(&mut model, "chi_air", to);
        for (given, step) in [("psi_sl", 1e-5), ("v_air", 1e-6), ("chi_air", 1e-5)] {
            let mut tangent = model.tangent(&|quantity| f64::from(quantity.0.id == given));
            for result in ["M_ws", "der(omega_sl)"] {
                let at = index(&model, result);
                let found = model.derivative(&mut tangent, at).expect("known");
                let here = get(&mut model, given);
                let ends = [here - step, here + step].map(|value| {
                    set(&mut model, given, value);
                    get(&mut model, result)
                });
                set(&mut model, given, here);
                let size = if result == "M_ws" { 1.0 } else { 1.0 / J };
                near(found, (ends[1] - ends[0]) / (2.0 * step), 1e-8 * size * most(15.0));
            }
        }
    }
}

/// What a scene does not have is not there, and what is asked of it is told with what to do.
#[test]
fn area_wind_and_load_belong_together() {
    let told = |text: &str| match Scene::parse(text) {
        Ok(_) => String::new(),
        Err(mistakes) => mistakes.iter().map(|mistake| format!("{mistake:?}")).collect(),
    };
    let good = scene("rigid", "", "v_air = \"15 m/s\"");
    assert_eq!(told(&good), "");
    for (text, says) in [
        (good.replace("r_ws = \"7 m\"\n", ""), "A_ws of what slews, without r_ws"),
        (
            good.replace("A_ws = \"120 m2\"\n", ""),
            "r_ws of what slews, without A_ws",
        ),
        (
            good.split("[slewing.air]").next().expect("one").to_owned(),
            "without wind",
        ),
        (
            good.replace("v_air", "c_wQ = \"1\"\nv_air"),
            "`c_wQ` without a swinging load",
        ),
        (
            good.replace("A_ws = \"120 m2\"\nr_ws = \"7 m\"\n", ""),
            "`air` without a swinging load",
        ),
        (
            scene(
                "static",
                "",
                "v_air = { between = \"linear\", over = [[\"0 s\", \"1 m/s\"], [\"5 s\", \"9 m/s\"]] }",
            ),
            "`v_air` over time",
        ),
        (
            scene("swing", "l_R = \"15 m\"", "d_Q = \"1 kN.s/m\"\nv_air = \"15 m/s\""),
            "`Q_air` is missing",
        ),
    ] {
        assert!(told(&text).contains(says), "{says}: {}", told(&text));
    }
    let names = |text: &str| model(text).variables().iter().map(|v| v.name()).collect::<Vec<_>>();
    let without = good.replace("A_ws = \"120 m2\"\nr_ws = \"7 m\"\n", "");
    let without = names(without.split("[slewing.air]").next().expect("one"));
    assert!(
        !without
            .iter()
            .any(|name| ["v_air", "chi_air", "M_ws", "p_ws", "rho_air"].contains(&name.as_str()))
    );
    assert!(names(&good).iter().any(|name| name == "M_ws"));
}

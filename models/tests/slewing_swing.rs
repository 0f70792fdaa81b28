//! Slewing by itself with a load that swings: pendulums in closed form, the steady circle, what is conserved, a slope, blows.

#[path = "common/named.rs"]
mod named;

use std::f64::consts::TAU;

use lemnis_models::component::model::Model;

use named::{get, model, near, set};

const G: f64 = 9.81;
/// Inertia of what slews (kg·m²), the load (kg), reach and rope (m).
const J: f64 = 5e6;
const MASS: f64 = 10e3;
const R: f64 = 20.0;
const L: f64 = 15.0;

fn scene(keys: &str, slope: &str) -> String {
    format!(
        "name = \"Test\"\ntitle = \"Test\"\n[slewing]\nfidelity = \"swing\"\nR = \"20 m\"\nQ = \"10 t\"\nJ_sl = \"5e6 kg.m2\"\n\
         l_R = \"15 m\"\n{keys}\n[slewing.motion]\nfrom = \"0 deg\"\nto = \"90 deg\"\nstep = \"5 deg\"\nspeed = \"6 deg/s\"\n\
         {slope}\n"
    )
}

const LOAD: [&str; 6] = ["x_Q", "y_Q", "z_Q", "v_Qx", "v_Qy", "v_Qz"];

/// Place and velocity of the load against the ground, in the frame that slews, and the slewing speed.
fn whole(model: &mut Model) -> ([f64; 3], [f64; 3], f64) {
    let [x, y, z, v_x, v_y, v_z] = LOAD.map(|name| get(model, name));
    let omega = get(model, "omega_sl");
    let place = [x + R, y, z];
    (place, [v_x - omega * z, v_y, v_z + omega * place[0]], omega)
}

fn energy(model: &mut Model) -> f64 {
    let (place, velocity, omega) = whole(model);
    let square: f64 = velocity.iter().map(|v| v * v).sum();
    0.5 * J * omega * omega + MASS * (0.5 * square + G * place[1])
}

fn angular_momentum(model: &mut Model) -> f64 {
    let (place, velocity, omega) = whole(model);
    J * omega + MASS * (place[0] * velocity[2] - place[2] * velocity[0])
}

/// T = 2π √(l/g), a part in 10⁷ longer at 1 mrad: forward with slewing free, as the load does not turn it then, and
/// sideways where the brake holds; sideways with slewing free the crane swings against it, with g/l (1 + m R²/J).
#[test]
fn small_pendulums() {
    let alone = (G / L).sqrt();
    let against = (G / L * (1.0 + MASS * R * R / J)).sqrt();
    for (keys, angle, own) in [
        ("phi_R = \"0.001 rad\"", "phi_R", alone),
        ("chi_R = \"0.001 rad\"", "chi_R", alone),
        ("chi_R = \"0.001 rad\"", "chi_R", against),
    ] {
        let mut model = model(&scene(keys, ""));
        if (angle, own) == ("chi_R", alone) {
            set(&mut model, "M_Bsl", 1000e3);
        }
        model.advance(0.0, TAU / own).expect("runs");
        near(get(&mut model, angle), 1e-3, 2e-9);
        model.advance(TAU / own, 1.25 * TAU / own).expect("runs");
        near(get(&mut model, angle), 0.0, 2e-8);
    }
}

/// tan φ = ω² (R + l sin φ)/g: there the load stays, and S_R = m g/cos φ.
#[test]
fn the_steady_circle() {
    let omega = 0.3_f64;
    let mut phi = 0.0_f64;
    for _ in 0..200 {
        phi = libm::atan(omega * omega * (R + L * libm::sin(phi)) / G);
    }
    let text = scene(&format!("phi_R = \"{phi} rad\"\nomega_sl = \"{omega} rad/s\""), "");
    let mut model = model(&text);
    for name in ["der(v_Qx)", "der(v_Qy)", "der(v_Qz)", "der(omega_sl)"] {
        near(get(&mut model, name), 0.0, 1e-13);
    }
    near(get(&mut model, "S_R"), MASS * G / libm::cos(phi), 1e-8);
    model.advance(0.0, 60.0).expect("runs");
    near(get(&mut model, "psi_sl"), omega * 60.0, 1e-9);
    near(get(&mut model, "phi_R"), phi, 1e-10);
}

/// A load let go in a wide swing, slewing free: energy and angular momentum stay.
#[test]
fn what_is_conserved() {
    let mut model = model(&scene(
        "phi_R = \"50 deg\"\nchi_R = \"-35 deg\"\nomega_sl = \"10 deg/s\"\n[slewing.dynamics]\nstep = \"2 ms\"",
        "",
    ));
    let before = (energy(&mut model), angular_momentum(&mut model));
    let size = 0.5 * J * get(&mut model, "omega_sl").powi(2) + MASS * G * L;
    for step in 0..60 {
        model.advance(f64::from(step), f64::from(step + 1)).expect("runs");
        near(energy(&mut model), before.0, 1e-10 * size);
        near(angular_momentum(&mut model), before.1, 1e-9 * before.1.abs());
    }
    let place = LOAD[..3].iter().map(|name| get(&mut model, name).powi(2)).sum::<f64>();
    near(place.sqrt(), L, 1e-12);
    assert_eq!(get(&mut model, "W_blow"), 0.0);
}

/// On a slope a load that hangs where gravity wants it asks slewing for what it asks where it is fixed to the head.
#[test]
fn a_slope_at_rest() {
    let slope = "[slewing.slope]\ngamma_s = \"2 deg\"\nG_u = \"500 kN\"\nr_u = \"-1 m\"";
    for psi in [0.0_f64, 0.7, -2.0] {
        let gamma = 2_f64.to_radians();
        let (steep, aside, ahead) = (libm::sin(gamma), libm::sin(psi), libm::cos(psi));
        // Downhill in the frame that slews.
        let chi = libm::asin(-steep * aside);
        let phi = libm::atan2(steep * ahead, libm::cos(gamma));
        let keys =
            format!("phi_R = \"{phi} rad\"\nchi_R = \"{chi} rad\"\npsi_sl = \"{psi} rad\"\nM_Fsl = \"1000 kN.m\"");
        let mut swinging = model(&scene(&keys, slope));
        swinging.event().expect("decided");
        let fixed = scene(&format!("psi_sl = \"{psi} rad\"\nM_Fsl = \"1000 kN.m\""), slope);
        let mut fixed = model(&fixed.replace("\"swing\"", "\"rigid\"").replace("l_R = \"15 m\"\n", ""));
        let wanted = get(&mut fixed, "M_Rsl");
        near(get(&mut swinging, "M_Rsl"), wanted, 1e-12 * 200e3);
        near(get(&mut swinging, "S_R"), MASS * G, 1e-8);
        for name in ["der(v_Qx)", "der(v_Qy)", "der(v_Qz)"] {
            near(get(&mut swinging, name), 0.0, 1e-13);
        }
        near(get(&mut swinging, "M_gammau"), 500e3 * steep * aside, 1e-8);
    }
}

const AIR: &str =
    "[slewing.air]\nQ_air = \"10 t\"\nd_Q = \"150 N.s/m\"\nc_wQ = \"1.2\"\nA_Q = \"14 m2\"\nrho_air = \"1.25 kg/m3\"\n";

/// tan φ = F/(m g) with F = (d_Q + ½ ρ c A v) v: in a steady wind the load hangs still, downwind at every slewing angle, and
/// the crane that nothing holds does not turn where that is straight ahead.
#[test]
fn a_steady_wind() {
    let (speed, to) = (12.0, 0.4);
    let force = (150.0 + 0.5 * 1.25 * 1.2 * 14.0 * speed) * speed;
    let lean = libm::atan2(force, MASS * G);
    for psi in [to, 0.0, -1.3, 2.5] {
        let (ahead, aside) = (libm::cos(to - psi), libm::sin(to - psi));
        let chi = libm::asin(libm::sin(lean) * aside);
        let phi = libm::atan2(libm::sin(lean) * ahead, libm::cos(lean));
        let keys = format!("phi_R = \"{phi} rad\"\nchi_R = \"{chi} rad\"\npsi_sl = \"{psi} rad\"");
        let wind = format!("{AIR}v_air = \"{speed} m/s\"\nchi_air = \"{to} rad\"");
        let mut model = model(&scene(&keys, &wind));
        if psi != to {
            set(&mut model, "M_Bsl", 1000e3);
        }
        model.event().expect("decided");
        for name in ["der(v_Qx)", "der(v_Qy)", "der(v_Qz)", "der(omega_sl)"] {
            near(get(&mut model, name), 0.0, 1e-13);
        }
        near(get(&mut model, "F_air"), force, 1e-9);
        near(get(&mut model, "P_air"), 0.0, 1e-9);
        near(
            get(&mut model, "S_R"),
            (force * force + (MASS * G).powi(2)).sqrt(),
            1e-8,
        );
    }
}

/// A load let go in a wide swing while the crane turns in the wind: energy falls by what the air takes, by Simpson's rule.
#[test]
fn the_air_takes_energy() {
    let keys = "phi_R = \"40 deg\"\nchi_R = \"-35 deg\"\nomega_sl = \"10 deg/s\"\n[slewing.dynamics]\nstep = \"1 ms\"";
    let wind = format!("{AIR}v_air = \"9 m/s\"\nchi_air = \"80 deg\"");
    let mut model = model(&scene(keys, &wind));
    let (before, step, mut taken) = (energy(&mut model), 0.01, 0.0);
    let mut powers = vec![get(&mut model, "P_air")];
    for i in 0..1000 {
        model
            .advance(f64::from(i) * step, f64::from(i + 1) * step)
            .expect("runs");
        powers.push(get(&mut model, "P_air"));
    }
    for three in powers.windows(3).step_by(2) {
        taken += step / 3.0 * (three[0] + 4.0 * three[1] + three[2]);
    }
    let after = energy(&mut model);
    assert!((before - after).abs() > 1e4, "{before} {after}");
    near(after, before - taken, 1e-7 * MASS * G * L);
}

/// Small swings decay with δ = d_Q/m: after n periods to e^(−n π δ/ω), ω² = g/l − δ²/4, of what they began with.
#[test]
fn small_swings_decay() {
    let delta: f64 = 0.05;
    let air = format!("[slewing.air]\nQ_air = \"10 t\"\nd_Q = \"{} N.s/m\"", delta * MASS);
    let omega = (G / L - delta * delta / 4.0).sqrt();
    for angle in ["phi_R", "chi_R"] {
        let keys = format!("{angle} = \"0.0001 rad\"\n[slewing.dynamics]\nstep = \"5 ms\"");
        let mut model = model(&scene(&keys, &air));
        set(&mut model, "M_Bsl", 1000e3);
        model.advance(0.0, 3.0 * TAU / omega).expect("runs");
        near(
            get(&mut model, angle),
            1e-4 * libm::exp(-1.5 * TAU * delta / omega),
            1e-11,
        );
    }
}

/// Slewing meets its stop at 0.3 rad/s with the load behind it or ahead: what the blow takes is what the energy lacks, and
/// no angular momentum is asked for: the stop gives it.
#[test]
fn blows() {
    for chi in [-20.0, 0.0, 25.0] {
        let keys = format!(
            "chi_R = \"{chi} deg\"\nomega_sl = \"0.3 rad/s\"\npsi_max = \"1 deg\"\n[slewing.dynamics]\nstep = \"1 ms\""
        );
        let mut model = model(&scene(&keys, ""));
        let before = energy(&mut model);
        model.advance(0.0, 10.0).expect("runs");
        let lost = get(&mut model, "W_blow");
        assert!(lost > 0.5 * J * 0.08, "{lost}");
        near(energy(&mut model), before - lost, 1e-9 * before.abs().max(lost));
    }
}

/// Thrown over its head the load leaves its rope slack, flies, and is caught: the rope never pushes and never is longer
/// than it is, and blows take all that the energy lacks.
#[test]
fn a_slack_rope_catches_its_load() {
    let mut model = model(&scene(
        "phi_R = \"120 deg\"\nchi_R = \"10 deg\"\nM_Bsl = \"1e6 kN.m\"\n[slewing.dynamics]\nstep = \"1 ms\"",
        "",
    ));
    model.event().expect("decided");
    let before = energy(&mut model);
    let (mut slack, mut caught) = (false, false);
    for step in 0..400 {
        let from = f64::from(step) * 0.05;
        model.advance(from, from + 0.05).expect("runs");
        let pull = get(&mut model, "S_R");
        assert!(pull >= 0.0, "{pull}");
        let distance = LOAD[..3]
            .iter()
            .map(|name| get(&mut model, name).powi(2))
            .sum::<f64>()
            .sqrt();
        assert!(distance <= L * (1.0 + 1e-11), "{distance}");
        slack |= pull == 0.0;
        caught |= slack && pull > 0.0;
        let lost = get(&mut model, "W_blow");
        near(energy(&mut model), before - lost, 1e-9 * MASS * G * L);
    }
    assert!(slack && caught && get(&mut model, "W_blow") > 0.0);
}

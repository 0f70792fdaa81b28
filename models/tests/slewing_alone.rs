//! Slewing by itself, against closed forms of one shaft: a drive against friction, a pendulum on a slope, a brake, an end
//! stop; inputs instead of what nothing else gives.

#[path = "common/named.rs"]
mod named;
#[path = "common/resumed.rs"]
mod resumed;

use std::f64::consts::TAU;

use lemnis_models::kernel::variable::Role;
use lemnis_models::registry::dependencies;

use named::{get, index, model, near, set};

const READY: &str = include_str!("../scenes/slewing.toml");
const SWINGING: &str = include_str!("../scenes/slewing_swing.toml");

/// Inertia of what slews, in kg·m², and the load's, which is 10 t at 20 m.
const J: f64 = 5e6 + 10e3 * 400.0;

fn scene(keys: &str, slope: &str) -> String {
    format!(
        "name = \"Test\"\ntitle = \"Test\"\n[slewing]\nfidelity = \"rigid\"\nR = \"20 m\"\nQ = \"10 t\"\nJ_sl = \"5e6 kg.m2\"\n\
         {keys}\n[slewing.motion]\nfrom = \"0 deg\"\nto = \"90 deg\"\nstep = \"5 deg\"\nspeed = \"6 deg/s\"\n{slope}\n"
    )
}

/// ω = (M − M_F)/c (1 − e^(−c t/J)).
#[test]
fn a_drive_against_friction() {
    let mut model = model(&scene(
        "M_sl = \"300 kN.m\"\nM_Fsl = \"40 kN.m\"\nc_sl = \"900 kN.m.s\"",
        "",
    ));
    let (moment, c) = (260e3, 900e3);
    for (from, to) in [(0.0, 3.7), (3.7, 20.0)] {
        model.advance(from, to).expect("runs");
        let decay = libm::exp(-c * to / J);
        let steady = moment / c;
        near(get(&mut model, "omega_sl"), steady * (1.0 - decay), 1e-12);
        let angle = steady * (to - J / c * (1.0 - decay));
        near(get(&mut model, "psi_sl"), angle, 1e-11);
        near(get(&mut model, "der(omega_sl)"), moment / J * decay, 1e-13);
        near(get(&mut model, "F_t"), 10e3 * 20.0 * moment / J * decay, 1e-7);
    }
}

/// Friction holds what is less than it, the slope's moment included; beyond it breaks loose.
#[test]
fn friction_and_brake_hold() {
    let slope = "[slewing.slope]\ngamma_s = \"1 deg\"\nG_u = \"0 kN\"\nr_u = \"0 m\"";
    let weight = 10e3 * 9.81 * 20.0 * libm::sin(1_f64.to_radians());
    let mut model = model(&scene("M_Fsl = \"20 kN.m\"\npsi_sl = \"90 deg\"", slope));
    near(get(&mut model, "M_gamma"), -weight, 1e-9);
    set(&mut model, "M_Bsl", 15e3);
    model.advance(0.0, 5.0).expect("runs");
    assert_eq!(get(&mut model, "psi_sl"), 90_f64.to_radians());
    near(get(&mut model, "M_Rsl"), weight, 1e-9);
    assert_eq!(get(&mut model, "der(omega_sl)"), 0.0);
    // It needs 34.24 kN·m, and 35 kN·m hold.
    set(&mut model, "M_Bsl", weight - 20e3 - 1.0);
    model.advance(5.0, 5.1).expect("runs");
    assert!(get(&mut model, "omega_sl") < 0.0, "downhill");
}

/// t = J ω/M, ψ = J ω²/(2 M), and there it stays.
#[test]
fn a_brake_stops_it() {
    let mut model = model(&scene("M_Fsl = \"30 kN.m\"\nomega_sl = \"-6 deg/s\"", ""));
    set(&mut model, "M_Bsl", 120e3);
    let omega = -6_f64.to_radians();
    let angle = -0.5 * J * omega * omega / 150e3;
    let time = J * omega.abs() / 150e3;
    model.advance(0.0, time * 0.999).expect("runs");
    assert!(get(&mut model, "omega_sl") < 0.0);
    model.advance(time * 0.999, time * 1.001).expect("runs");
    assert_eq!(get(&mut model, "omega_sl"), 0.0);
    near(get(&mut model, "psi_sl"), angle, 1e-12);
    model.advance(time * 1.001, 2.0 * time).expect("runs");
    near(get(&mut model, "psi_sl"), angle, 1e-12);
    assert_eq!(get(&mut model, "W_blow"), 0.0);
}

/// T = 2π √(J / ((G_u r_u + Q R) sin γ)), less than a part in 10⁷ longer at 1 mrad.
#[test]
fn a_pendulum_on_a_slope() {
    let slope = "[slewing.slope]\ngamma_s = \"3 deg\"\nG_u = \"1000 kN\"\nr_u = \"-1.5 m\"";
    let mut model = model(&scene("psi_sl = \"0.001 rad\"", slope));
    let stiffness = (10e3 * 9.81 * 20.0 - 1000e3 * 1.5) * libm::sin(3_f64.to_radians());
    let period = TAU * (J / stiffness).sqrt();
    model.advance(0.0, period).expect("runs");
    near(get(&mut model, "psi_sl"), 1e-3, 1e-10);
    near(get(&mut model, "omega_sl"), 0.0, 1e-3 * TAU / period * 1e-6);
    // Kinetic and potential energy at a quarter of the period are those at its start.
    model.advance(period, 1.25 * period).expect("runs");
    let (psi, omega) = (get(&mut model, "psi_sl"), get(&mut model, "omega_sl"));
    let (whole, now) = (
        stiffness * (1.0 - libm::cos(1e-3)),
        0.5 * J * omega * omega + stiffness * (1.0 - libm::cos(psi)),
    );
    near(now, whole, 1e-9 * whole);
}

/// What moved is lost, and the stop then holds any drive that presses against it.
#[test]
fn an_end_stop_takes_all_speed() {
    let mut model = model(&scene("M_sl = \"100 kN.m\"\npsi_max = \"30 deg\"", ""));
    let stop = 30_f64.to_radians();
    let time = (2.0 * stop * J / 100e3).sqrt();
    model.advance(0.0, time + 0.5).expect("runs");
    assert_eq!(get(&mut model, "omega_sl"), 0.0);
    near(get(&mut model, "psi_sl"), stop, 1e-12);
    near(get(&mut model, "W_blow"), 100e3 * stop, 1e-6);
    near(get(&mut model, "M_Rsl"), -100e3, 1e-9);
    set(&mut model, "M_sl", -100e3);
    model.advance(time + 0.5, time + 1.5).expect("runs");
    near(get(&mut model, "psi_sl"), stop - 0.5 * 100e3 / J, 1e-12);
}

/// A reach that is an input is one, whatever follows from it does, and the states stay where they are.
#[test]
fn what_nothing_gives_is_an_input() {
    let mut model = model(READY);
    let roles: Vec<_> = ["R", "Q", "J_sl", "J_tot"]
        .map(|name| model.variables()[index(&model, name)].role)
        .into();
    assert_eq!(roles, [Role::Input, Role::Input, Role::Parameter, Role::Output]);
    model.advance(0.0, 2.0).expect("runs");
    let before = (get(&mut model, "psi_sl"), get(&mut model, "omega_sl"));
    set(&mut model, "R", 10.0);
    assert_eq!((get(&mut model, "psi_sl"), get(&mut model, "omega_sl")), before);
    near(get(&mut model, "J_tot"), 9e6 + 16e3 * 100.0, 1e-6);
    let known = &dependencies(&model)[index(&model, "der(omega_sl)")];
    for name in ["R", "Q", "M_sl", "omega_sl", "psi_sl"] {
        assert!(known.contains(&(name, None)), "{name}: {known:?}");
    }
    let fixed = READY.replace("{ input = \"25 m\" }", "\"25 m\"");
    let model = named::model(&fixed);
    assert_eq!(model.variables()[index(&model, "R")].role, Role::Parameter);
}

/// Every derivative of rates and results by states and inputs, against differences; at rest and in motion.
#[test]
fn derivatives() {
    for (text, turning) in [(READY, true), (READY, false), (SWINGING, true), (SWINGING, false)] {
        let mut model = model(text);
        if turning {
            set(&mut model, "M_Bsl", 1e3);
            model.advance(0.0, 3.0).expect("runs");
        } else {
            set(&mut model, "M_Bsl", 1e6);
            model.event().expect("held");
        }
        let variables = model.variables().to_vec();
        let known: Vec<usize> = (0..variables.len())
            .filter(|i| matches!(variables[*i].role, Role::State | Role::Input))
            .filter(|i| turning || variables[*i].role == Role::Input)
            .collect();
        let mut compared = 0;
        for by in known {
            let symbol = variables[by].quantity();
            let mut tangent = model.tangent(&|quantity| f64::from(quantity == symbol));
            let at = model.get(by).expect("known");
            let near = 1e-5 * at.abs().max(1e-3);
            let mut beside = [0, 1].map(|_| model.clone());
            for (model, sign) in beside.iter_mut().zip([-1.0, 1.0]) {
                model.set(by, at + sign * near).expect("allowed");
            }
            for of in 0..variables.len() {
                if !matches!(variables[of].role, Role::Output | Role::Rate) {
                    continue;
                }
                let exact = model.derivative(&mut tangent, of).expect("a derivative");
                let [low, high] = beside.each_mut().map(|model| model.get(of).expect("a result"));
                let size = model.get(of).expect("a result").abs().max(low.abs());
                let rough = (high - low) / (2.0 * near);
                let allowed = 1e-8 * rough.abs() + 1e-13 * size / near + 1e-12;
                assert!(
                    (exact - rough).abs() <= allowed,
                    "{} by {}",
                    variables[of],
                    variables[by]
                );
                compared += 1;
            }
        }
        assert!(compared > 30, "{compared}");
    }
}

/// A state that was written out goes on in another model with the same bits.
#[test]
fn states_go_on() {
    for text in [READY, SWINGING] {
        let mut model = resumed::goes_on(text, 4.0, 200);
        assert!(get(&mut model, "W_blow") > 0.0, "it met its stop");
    }
}

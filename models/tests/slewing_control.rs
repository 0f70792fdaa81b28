//! The slewing controller: its samples against the recurrence of a rigid shaft in closed form, that against the continuous
//! loop, limit, ramp and anti-windup; shaped commands against what two and three pulses leave of a swing.

#[path = "common/named.rs"]
mod named;

use std::f64::consts::{FRAC_PI_2, TAU};

use lemnis_models::component::model::Model;
use lemnis_models::kernel::course::{Between, Course};
use lemnis_models::scene::Scene;

use named::{get, model, near, set};

const G: f64 = 9.81;
/// Inertia (kg·m²), gains (N·m·s, N·m) and cycle (s).
const J: f64 = 4e6;
const K_P: f64 = 6e6;
const K_I: f64 = 5e6;
const CYCLE: f64 = 0.05;

/// A rigid shaft of 4e6 kg·m² without friction: keys of slewing, and of its controller.
fn rigid(keys: &str, cycle: f64, control: &str) -> Model {
    model(&shaft(keys, &format!("T_csl = \"{cycle} s\""), control))
}

fn shaft(keys: &str, cycle: &str, control: &str) -> String {
    format!(
        "name = \"Test\"\ntitle = \"Test\"\n[slewing]\nfidelity = \"rigid\"\nR = \"20 m\"\nQ = \"0 t\"\nJ_sl = \"4e6 kg.m2\"\n{keys}\n\
         [slewing.control]\nK_psl = \"6000 kN.m.s\"\nK_isl = \"5000 kN.m\"\n{cycle}\n{control}\n\
         [slewing.motion]\nfrom = \"0 deg\"\nto = \"90 deg\"\nstep = \"5 deg\"\nspeed = \"6 deg/s\"\n"
    )
}

/// The same without a cycle.
fn continuous_shaft(keys: &str, control: &str) -> Model {
    model(&shaft(keys, "", control))
}

const FREE: &str = "a_sl = \"1e3 rad/s2\"\nM_maxsl = \"1e9 kN.m\"";

/// Error after k samples of a step of 1: e_k = r^k (cos kθ + B sin kθ) with r² = 1 − p + q, 2 r cos θ = 2 − p and
/// e_1 = 1 − p, where p = K_p T_c/J and q = K_i T_c²/J.
fn sampled(k: i32, cycle: f64) -> f64 {
    let (p, q) = (K_P * cycle / J, K_I * cycle * cycle / J);
    let r = (1.0 - p + q).sqrt();
    let theta = libm::acos((2.0 - p) / (2.0 * r));
    let b = ((1.0 - p) / r - libm::cos(theta)) / libm::sin(theta);
    let at = f64::from(k) * theta;
    libm::pow(r, f64::from(k)) * (libm::cos(at) + b * libm::sin(at))
}

/// The same at a time (s) of the loop that is never sampled: ζ ω_0 = K_p/(2 J), ω_0² = K_i/J.
fn continuous(t: f64) -> f64 {
    let decay = K_P / (2.0 * J);
    let own = (K_I / J - decay * decay).sqrt();
    libm::exp(-decay * t) * (libm::cos(own * t) - decay / own * libm::sin(own * t))
}

#[test]
fn a_step_of_the_command_is_the_recurrence_in_closed_form() {
    let mut model = rigid("", CYCLE, &format!("omega_csl = \"0.1 rad/s\"\n{FREE}"));
    near(get(&mut model, "omega_0sl"), (K_I / J).sqrt(), 1e-12);
    near(get(&mut model, "zeta_sl"), K_P / (2.0 * (K_I * J).sqrt()), 1e-12);
    model.start().expect("starts");
    for k in 1..=200 {
        let at = f64::from(k) * CYCLE;
        model.advance(at - CYCLE, at).expect("runs");
        near(get(&mut model, "omega_sl"), 0.1 * (1.0 - sampled(k, CYCLE)), 1e-13);
    }
}

/// The closed forms of both loops, which differ by the cycle in proportion, and the model at three cycles.
#[test]
fn the_shorter_the_cycle_the_nearer_the_continuous_loop() {
    let off = [0.04, 0.02, 0.01, 0.005].map(|cycle| {
        let samples = (2.0_f64 / cycle).round() as i32;
        let mut model = rigid("", cycle, &format!("omega_csl = \"0.1 rad/s\"\n{FREE}"));
        model.start().expect("starts");
        model.advance(0.0, 2.0).expect("runs");
        near(
            get(&mut model, "omega_sl"),
            0.1 * (1.0 - sampled(samples, cycle)),
            1e-12,
        );
        (1.0 - get(&mut model, "omega_sl") / 0.1) - continuous(2.0)
    });
    for pair in off.windows(2) {
        near(pair[0] / pair[1], 2.0, 0.1);
    }
    assert!(off[3].abs() < 5e-3, "{off:?}");
}

/// At its limit the drive gives ω = M_max t/J, and the integral waits: what follows is the recurrence from there, with
/// nothing wound up.
#[test]
fn the_limit_holds_and_nothing_winds_up() {
    let mut model = rigid(
        "",
        CYCLE,
        "omega_csl = \"0.2 rad/s\"\na_sl = \"1e3 rad/s2\"\nM_maxsl = \"100 kN.m\"",
    );
    model.start().expect("starts");
    let mut k = 0;
    while get(&mut model, "M_sl") == 100e3 {
        assert_eq!(get(&mut model, "M_isl").to_bits(), 0.0_f64.to_bits());
        k += 1;
        let at = f64::from(k) * CYCLE;
        model.advance(at - CYCLE, at).expect("runs");
        near(get(&mut model, "omega_sl"), 100e3 * at / J, 1e-12);
        model.event().expect("samples");
    }
    // K_p e falls below the limit at e = 1/60 rad/s.
    assert_eq!(k, ((0.2 - 100e3 / K_P) / (100e3 / J) / CYCLE).ceil() as i32);
    let left = 0.2 - get(&mut model, "omega_sl");
    for n in 1..=100 {
        let at = f64::from(k + n) * CYCLE;
        model.advance(at - CYCLE, at).expect("runs");
        near(get(&mut model, "omega_sl"), 0.2 - left * sampled(n, CYCLE), 1e-12);
    }
}

/// The set point rises by a T_c in each sample, and stays at the command.
#[test]
fn the_set_point_is_on_a_ramp() {
    let mut model = rigid(
        "",
        CYCLE,
        "omega_csl = \"0.1 rad/s\"\na_sl = \"0.03 rad/s2\"\nM_maxsl = \"1e9 kN.m\"",
    );
    model.start().expect("starts");
    for k in 1..=100 {
        near(
            get(&mut model, "omega_ssl"),
            (0.03 * f64::from(k) * CYCLE).min(0.1),
            1e-14,
        );
        let at = f64::from(k) * CYCLE;
        model.advance(at - CYCLE, at).expect("runs");
        model.event().expect("samples");
    }
    assert_eq!(get(&mut model, "omega_ssl").to_bits(), 0.1_f64.to_bits());
}

/// Friction and a slope at rest: in the end the integral gives c ω + M_F, and the speed is the commanded one.
#[test]
fn no_error_is_left_in_the_end() {
    let keys = "c_sl = \"600 kN.m.s\"\nM_Fsl = \"40 kN.m\"";
    let mut model = rigid(keys, CYCLE, &format!("omega_csl = \"0.1 rad/s\"\n{FREE}"));
    model.start().expect("starts");
    model.advance(0.0, 60.0).expect("runs");
    near(get(&mut model, "omega_sl"), 0.1, 1e-12);
    near(get(&mut model, "M_isl"), 600e3 * 0.1 + 40e3, 1e-5);
    near(get(&mut model, "M_sl"), 600e3 * 0.1 + 40e3, 1e-5);
}

/// Stable is 2 K_p T_c < 4 J + K_i T_c², of which the last is but 0.08 % here: gains set in the model are looked at, too.
#[test]
fn gains_that_swing_up_are_refused_where_they_are_set_too() {
    for (gain, runs) in [(1.99 * J / CYCLE, true), (2.01 * J / CYCLE, false)] {
        let mut model = rigid("", CYCLE, &format!("omega_csl = \"0.1 rad/s\"\n{FREE}"));
        set(&mut model, "K_psl", gain);
        let started = model.start().and_then(|()| model.advance(0.0, 1.0));
        assert_eq!(started.is_ok(), runs, "{gain}: {started:?}");
        assert!(runs || started.is_err_and(|fault| fault.message.contains("swings up")));
    }
}

/// A continuous controller whose integral asks for twice the limit, while the speed is above the set point: it falls as the error
/// has it from the first instant, M_i = 2 M_max − K_i ∫|e| dt, under the moment of the limit, ω̇ = M_max/J.
#[test]
fn beyond_the_limit_an_error_that_asks_for_less_is_integrated() {
    let text = "omega_csl = \"0 rad/s\"\na_sl = \"1 rad/s2\"\nM_maxsl = \"100 kN.m\"";
    let mut model = continuous_shaft("omega_sl = \"0.001 rad/s\"", text);
    model.start().expect("starts");
    // The set point comes down from the speed at the start.
    model.advance(0.0, 0.01).expect("runs");
    set(&mut model, "epsilon_sl", 200e3 / K_I);
    set(&mut model, "omega_sl", 0.001);
    let before = get(&mut model, "omega_rsl");
    model.advance(0.01, 0.11).expect("runs");
    let fallen = 0.001 * 0.1 + 0.5 * (100e3 / J) * 0.01;
    near(before, 0.0, 1e-15);
    near(get(&mut model, "omega_sl"), 0.001 + 100e3 / J * 0.1, 1e-12);
    near(get(&mut model, "epsilon_sl"), 200e3 / K_I - fallen, 1e-12);
    near(get(&mut model, "M_sl"), 100e3, 0.0);
}

/// What was saved between two samples goes on in the same bits.
#[test]
fn a_saved_state_goes_on_in_the_same_bits() {
    let mut model = rigid("", CYCLE, &format!("omega_csl = \"0.1 rad/s\"\n{FREE}"));
    model.start().expect("starts");
    model.advance(0.0, 0.37).expect("runs");
    let saved = model.state();
    let numbers = model.numbers(&saved);
    let mut ends = Vec::new();
    for by_numbers in [false, true] {
        let state = if by_numbers {
            model.state_of(&numbers).expect("its own numbers")
        } else {
            model.state()
        };
        model.set_state(&state);
        model.set_time(0.37);
        model.advance(0.37, 1.91).expect("runs");
        ends.push(["omega_sl", "psi_sl", "M_sl", "M_isl", "omega_ssl"].map(|name| get(&mut model, name).to_bits()));
        // Elsewhere meanwhile.
        set(&mut model, "omega_csl", 0.1);
    }
    assert_eq!(ends[0], ends[1]);
}

/// A set point that goes straight down to zero with its command is at zero then and stays, and is not a rounding beside it.
#[test]
fn a_set_point_comes_to_zero_with_its_command() {
    let command = "omega_csl = { between = \"linear\", over = [[\"0 s\", \"0 deg/s\"], [\"1.7 s\", \"3.1 deg/s\"],\n\
                   [\"5.3 s\", \"3.1 deg/s\"], [\"8.9 s\", \"0 deg/s\"]] }";
    let mut model = continuous_shaft("", &format!("{command}\n{FREE}"));
    model.start().expect("starts");
    model.advance(0.0, 8.0).expect("runs");
    assert!(get(&mut model, "omega_rsl") > 0.01);
    model.advance(8.0, 8.9).expect("runs");
    assert_eq!(
        ["omega_rsl", "der(omega_rsl)"].map(|name| get(&mut model, name)),
        [0.0; 2]
    );
}

/// A shaped course is half of itself, and half of itself half a period later, at any time; one of three pulses is a quarter, a
/// half and a quarter of itself; one against two periods is each half again in halves.
#[test]
fn a_shaped_course_is_the_sum_of_its_pulses() {
    let rows = vec![[0.5, 0.0], [2.5, 3.0], [7.25, 3.0], [8.0, -5.0], [11.0, 0.0]];
    for between in [Between::Linear, Between::Steps] {
        let plain = Course {
            rows: rows.clone(),
            between,
            shaped: None,
        };
        let (halves, quarters) = ([0.5; 2], [0.25, 0.5, 0.25]);
        for (periods, pulses, weights, lates) in [
            (&[3.3][..], 2, &halves[..], &[0.0, 1.65][..]),
            (&[3.3], 3, &quarters, &[0.0, 1.65, 3.3]),
            (&[3.3, 0.9], 2, &[0.25; 4], &[0.0, 1.65, 0.45, 2.1]),
        ] {
            let shaped = plain.clone().shaped(periods, pulses);
            for i in 0..4000 {
                // Off all breaks.
                let t = 0.00037 + f64::from(i) * 0.004;
                let late = weights.iter().zip(lates);
                let expected: f64 = late.map(|(part, late)| part * plain.at(t - late, t - late)[0]).sum();
                near(shaped.at(t, t)[0], expected, 1e-12);
            }
            assert_eq!(shaped.rows.len(), 5 * weights.len());
            near(shaped.end(), 11.0 + lates[lates.len() - 1], 1e-12);
            assert_eq!(shaped.plain(), plain);
        }
    }
}

/// Amplitude (m) of the sideways swing after a command that ends at rest, of a rope's length (m), with its scene's `shaped`.
fn left(length: f64, shaped: &str) -> f64 {
    let text = format!(
        "name = \"Test\"\ntitle = \"Test\"\n[slewing]\nfidelity = \"swing\"\nR = \"20 m\"\nQ = \"1 kg\"\nJ_sl = \"4e6 kg.m2\"\n\
         l_R = \"{length} m\"\n[slewing.control]\nK_psl = \"16e3 kN.m.s\"\nK_isl = \"16e3 kN.m\"\nT_csl = \"2 ms\"\n{FREE}\n\
         omega_csl = {{ between = \"linear\", {shaped} over = [[\"0 s\", \"0 deg/s\"], [\"2 s\", \"0.1 deg/s\"],\n\
         [\"13 s\", \"0.1 deg/s\"], [\"14 s\", \"0 deg/s\"], [\"60 s\", \"0 deg/s\"]] }}\n\
         [slewing.dynamics]\nstep = \"20 ms\"\n\
         [slewing.motion]\nfrom = \"0 deg\"\nto = \"90 deg\"\nstep = \"5 deg\"\nspeed = \"6 deg/s\"\n"
    );
    let mut model = Scene::parse(&text).expect("valid").mechanism.model().expect("runs");
    model.start().expect("starts");
    model.advance(0.0, 50.0).expect("runs");
    let own = (G / length).sqrt();
    let (z, v_z, omega) = (
        get(&mut model, "z_Q"),
        get(&mut model, "v_Qz"),
        get(&mut model, "omega_sl"),
    );
    let amplitude = (z * z + v_z * v_z / (own * own)).sqrt();
    // The crane is at rest but for what the load pulls it along: m g R φ through J s² + K_p s + K_i of a loop that is never sampled.
    // Samples add a part in proportion to their cycle, 1.6 % at 50 ms: it is short here.
    let (stiff, damped) = (16e6 - 4e6 * own * own, 16e6 * own);
    let pulled = G * 20.0 * amplitude / length * own / (stiff * stiff + damped * damped).sqrt();
    assert!(omega.abs() <= 1.001 * pulled, "{omega} of {pulled}");
    amplitude
}

/// ρ = |cos(π/2 T_sh/T)|: the loop is linear and the load too light to move the crane, so each of the two halves leaves the
/// same swing, half a period T_sh later. No swing is left on the rope it is shaped for. Three pulses leave the square of it, two periods
/// the product of what each leaves.
#[test]
fn a_shaped_command_leaves_what_its_pulses_leave() {
    let period = 7.8;
    let fitting = G * (period / TAU) * (period / TAU);
    let mut table = Vec::new();
    for part in [0.7, 0.8, 0.9, 1.0, 1.1, 1.2, 1.3] {
        let length = part * fitting;
        let plain = left(length, "");
        let two = left(length, "shaped = \"7.8 s\",") / plain;
        let three = left(length, "shaped = \"7.8 s\", pulses = 3,") / plain;
        let expected = libm::cos(FRAC_PI_2 / part.sqrt()).abs();
        table.push((part, two, expected));
        table.push((part, three, expected * expected));
        let both = left(length, "shaped = [\"7.8 s\", \"3.1 s\"],") / plain;
        let other = libm::cos(FRAC_PI_2 * 3.1 / 7.8 / part.sqrt()).abs();
        table.push((part, both, expected * other));
    }
    for (part, measured, expected) in table {
        println!("l = {part} l_0: left {measured:.6}, closed form {expected:.6}");
        near(measured, expected, 2e-4);
    }
}

//! The rope of a drive in motion, on every luffing system that has one: at rest as at the level `static`, in motion by hand.

#[path = "common/driven_systems.rs"]
mod driven_systems;

use driven_systems::{MOTOR, SHAFT, System, close, get, hung, index, model, put, systems, turning};
use lemnis_models::kernel::variable::Role;
use lemnis_models::scene::Scene;

/// Falls, and efficiency of tackle and drum.
const TACKLE: [f64; 2] = [6.0, 0.9];

/// On the other side of the link than where its rope pulls without a balance.
const BEHIND: [[f64; 2]; 3] = [[6.0, -2.0], [-2.0, -6.0], [6.0, -2.0]];

#[test]
fn what_a_brake_holds_is_what_equilibrium_asks_for() {
    for system in &systems() {
        for (level, motor) in [("rigid", ""), ("rigid", MOTOR), ("swing", ""), ("swing", MOTOR)] {
            let mut moving = model(&hung(system, level, motor));
            let mut still = model(&hung(system, "static", ""));
            put(&mut moving, &[("M_S", 1e9)]);
            moving.start().expect("its brake holds it");
            let [from, to] = system.range.map(f64::to_radians);
            for i in 0..=60 {
                let at = from + (to - from) * f64::from(i) / 60.0;
                for model in [&mut moving, &mut still] {
                    model.set(0, at).expect("an angle");
                    model.update().expect("exists");
                }
                put(&mut moving, &[(system.rate, 0.0)]);
                moving.update().expect("its brake holds it");
                let found = get(&mut moving, ["S_lm", "S_lm.out", "S_lm.in", "F_d", "M_D"]);
                let expected = get(&mut still, ["S_l", "S_l.out", "S_l.in", "F_d", "M_D"]);
                for (found, expected) in found.into_iter().zip(expected) {
                    assert!(close(found, expected, 1e-12), "{level} at {at}: {found} {expected}");
                }
                assert!(found[0] > 0.0);
            }
        }
    }
}

/// M_D = M_A − J ψ′ (ψ′ α + ψ″ ω²), which is the rope's pull on its falls times its arm; power is that of the moment.
#[test]
fn what_a_motor_leaves_for_the_rope() {
    for system in &systems() {
        for (level, motor) in [("rigid", ""), ("rigid", MOTOR), ("swing", MOTOR)] {
            let mut model = model(&hung(system, level, motor));
            for (part, omega, driving) in [(0.2, 0.03, 1.0), (0.5, -0.04, 0.9), (0.8, 0.02, 1.1)] {
                let [from, to] = system.range.map(f64::to_radians);
                let angle = from + part * (to - from);
                let mut still = driven_systems::model(&hung(system, "static", ""));
                still.set(0, angle).expect("an angle");
                let [needed] = get(&mut still, ["M_D"]);
                model.set(0, angle).expect("an angle");
                put(&mut model, &[(system.rate, omega), ("M_A", driving * needed)]);
                model.update().expect("its rope pulls");
                let rate = format!("der({})", system.rate);
                let [alpha, m_d, f_d, v_d, pull, out, back, arm] = get(
                    &mut model,
                    [&rate, "M_D", "F_d", "v_d", "S_lm", "S_lm.out", "S_lm.in", "h_d"],
                );
                let [turn, change] = if motor.is_empty() {
                    [0.0; 2]
                } else {
                    turning(system, angle)
                };
                let lags = SHAFT[0] * turn * (turn * alpha + change * omega * omega);
                let size = 1e-12 * (needed.abs() + lags.abs());
                assert!(
                    (m_d - (driving * needed - lags)).abs() <= 10.0 * size,
                    "{m_d} {needed} {lags}"
                );
                assert!((f_d * arm - system.sense * m_d).abs() <= size);
                assert!((f_d * v_d - m_d * omega).abs() <= size * omega.abs());
                let [falls, efficiency] = TACKLE;
                assert!(close(pull, -f_d / falls, 1e-12) && pull > 0.0);
                assert!(close(out, pull * efficiency, 1e-12) && close(back, pull / efficiency, 1e-12));
            }
        }
    }
}

/// It is told where it would have to push, at rest before anything moves and, on no motor's shaft, in motion where it is asked to.
#[test]
fn a_rope_that_would_have_to_push_ends_the_motion() {
    for (system, e) in systems().iter().zip(BEHIND) {
        let mut model = model(&hung(system, "rigid", ""));
        let event = index(&model, "z.pull");
        assert_eq!(model.variables()[event].role, Role::Indicator);
        put(&mut model, &[("M_A", -1e8 * system.sense)]);
        let refused = model.start().expect_err("it would push").message;
        assert!(
            refused.contains("the luffing rope is slack, it would have to push with")
                && refused.contains("[cases.motor]"),
            "{refused}"
        );
        let front = System { e, ..*system };
        let found = Scene::parse(&hung(&front, "rigid", "")).expect_err("it would push");
        assert!(
            found
                .iter()
                .any(|told| told.message.contains("would have to push with") && told.help.is_some()),
            "{found:?}"
        );
        Scene::parse(&hung(&front, "static", "")).expect("a requirement there");
    }
}

/// Every derivative that the FMU gives of the pull, against differences of the values that it gives.
#[test]
fn derivatives_are_those_of_the_values() {
    for system in &systems() {
        let mut model = model(&hung(system, "swing", MOTOR));
        let middle = system.range.iter().sum::<f64>().to_radians() / 2.0;
        model.set(0, middle).expect("an angle");
        put(
            &mut model,
            &[(system.rate, 0.02), ("M_A", 1e6 * system.sense), ("phi_R", 0.03)],
        );
        model.update().expect("its rope pulls");
        let pull = index(&model, "S_lm");
        let mut compared = 0;
        for name in ["E_x", "s_d", "m_r", "J_M", "l_M", "M_A", system.rate, "phi_R", "Q"] {
            let known = index(&model, name);
            let (x, variable) = (model.get(known).expect("exists"), model.variables()[known]);
            let h = 1e-4 * x.abs().max(1e-2);
            let at = |value: f64| {
                let mut moved = model.clone();
                moved.set(known, value).expect("allowed");
                moved.update().expect("its rope pulls");
                moved.get(pull).expect("exists")
            };
            let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|part| at(x + part * h));
            let by_values = (a - d + 8.0 * (c - b)) / (12.0 * h);
            let mut tangent = model.tangent(&|(symbol, number)| f64::from((symbol, number) == variable.quantity()));
            let found = model.derivative(&mut tangent, pull).expect("exists");
            let size = found.abs() + b.abs() / x.abs().max(1e-2);
            assert!((found - by_values).abs() <= 1e-8 * size, "{name}: {found} {by_values}");
            compared += usize::from(found != 0.0);
        }
        assert!(compared >= 8, "{compared}");
    }
}

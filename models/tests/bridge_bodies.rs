//! Spreader and load of a container bridge as two bodies in motion: derivatives against differences, a saved state, what a jump of
//! the hoist's speed keeps, and what is refused. The motion itself: `tests/test_bridge_bodies.py`.

#[path = "common/named.rs"]
mod named;
#[path = "common/resumed.rs"]
mod resumed;

use lemnis_models::component::model::Model;
use lemnis_models::kernel::calc::Calc;
use lemnis_models::scene::Scene;

use named::{get, index, model, near, set};

const READY: &str = include_str!("../scenes/bridge_slings.toml");

/// The ready scene without commands, with a sway at the start.
fn free(phi: &str) -> String {
    let (head, rest) = READY.split_once("# Shaped against").expect("its commands");
    let (_, rest) = rest.split_once("[trolley.tow]").expect("its rope");
    format!("{head}\nphi_R = \"{phi}\"\n[trolley.tow]{rest}")
}

fn refused(text: &str) -> String {
    let mistakes = Scene::parse(text).expect_err("refused");
    mistakes
        .iter()
        .map(|mistake| format!("{}: {}; ", mistake.message, mistake.help.as_deref().unwrap_or_default()))
        .collect()
}

/// Somewhere in a motion while it is hoisted.
fn amid() -> Model {
    let mut moving = model(&free("3 deg"));
    for (name, value) in [
        ("a_t", 0.4),
        ("v_h", -0.7),
        ("v_t", 1.5),
        ("phi_R", 0.2),
        ("psi_s", -0.35),
        ("w_phi", 0.15),
        ("w_psi", -0.4),
        ("zeta_f", 0.2),
    ] {
        set(&mut moving, name, value);
    }
    moving.start().expect("it begins");
    moving
}

/// Every derivative of rates and pulls by states, inputs and parameters.
#[test]
fn derivatives_are_those_of_the_values() {
    let moving = amid();
    let results = [
        "der(phi_R)",
        "der(psi_s)",
        "der(w_phi)",
        "der(w_psi)",
        "der(v_t)",
        "x_Q",
        "y_Q",
        "N_s",
        "S_R",
        "S_s1",
        "S_s2",
        "F_dr",
        "P_dr",
        "z.slings",
        "z.sea",
        "z.land",
    ];
    let mut compared = 0;
    for name in [
        "phi_R", "psi_s", "w_phi", "w_psi", "l_R", "v_t", "a_t", "v_h", "Q", "G_s", "a_o", "a_u", "b_o", "l_s", "e_s",
        "e_1", "i_1", "zeta_f",
    ] {
        let known = index(&moving, name);
        let (mut own, variable) = (moving.clone(), moving.variables()[known]);
        let x = own.get(known).expect("exists");
        for result in results {
            let found = index(&own, result);
            let h = 1e-4 * x.abs().max(1e-1);
            let at = |value: f64| {
                let mut moved = own.clone();
                moved.set(known, value).expect("allowed");
                moved.update().expect("exists");
                moved.get(found).expect("exists")
            };
            let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|part| at(x + part * h));
            let by_values = (a - d + 8.0 * (c - b)) / (12.0 * h);
            let mut tangent = own.tangent(&|(symbol, number)| f64::from((symbol, number) == variable.quantity()));
            let by_rule = own.derivative(&mut tangent, found).expect("exists");
            let size = by_rule.abs() + b.abs() / x.abs().max(1e-1);
            assert!(
                (by_rule - by_values).abs() <= 1e-8 * size,
                "{name} {result}: {by_rule} {by_values}"
            );
            compared += usize::from(by_rule != 0.0);
        }
    }
    assert!(compared >= 190, "{compared}");
}

/// The ready scene goes on with the same bits from a state that was written out, while it starts and while it stands.
#[test]
fn a_saved_state_goes_on() {
    // In the first pulse, and while the load is lowered.
    for begun in [4.3, 34.1] {
        resumed::goes_on(READY, begun, 20);
    }
}

/// A jump of the hoist's speed pulls along ropes and slings: of both bodies nothing changes but by impulses along those lines.
/// On parallel ropes and slings that hang askew the load's speed across its slings stays, and that of both across the ropes.
#[test]
fn a_jump_of_the_hoist_keeps_what_is_across() {
    let mut moving = model(&free("3 deg").replace("a_u = \"1.8 m\"", "a_u = \"2.4 m\""));
    for (name, value) in [("phi_R", 0.3), ("psi_s", -0.5), ("w_phi", 0.2), ("w_psi", -0.3)] {
        set(&mut moving, name, value);
    }
    let across = |moving: &mut Model| {
        let [phi, psi, omega, spin, v_h] =
            ["phi_R", "psi_s", "omega_R", "omega_psi", "v_h"].map(|name| get(moving, name));
        let [(up, along), (load_up, load_along)] = [phi, psi].map(Calc::sin_cos);
        // The joint goes as the spreader, which does not turn.
        let joint = [12.0 * omega * along - v_h * up, 12.0 * omega * up + v_h * along];
        let load = [joint[0] + 12.0 * spin * load_along, joint[1] + 12.0 * spin * load_up];
        let momentum = 20e3 * (joint[0] * along + joint[1] * up) + 6e3 * (load[0] * along + load[1] * up);
        [momentum, load[0] * load_along + load[1] * load_up]
    };
    let before = across(&mut moving);
    set(&mut moving, "v_h", 1.5);
    let after = across(&mut moving);
    near(after[0] / before[0], 1.0, 1e-12);
    near(after[1], before[1], 1e-12);
    assert!((get(&mut moving, "omega_psi") + 0.3).abs() > 0.05);
}

/// A start beyond what the ropes allow, a load that is none, and slings that push, are told.
#[test]
fn what_cannot_be_is_told() {
    let told = refused(&free("50 deg"));
    assert!(
        told.starts_with("phi_R = 50 deg is more than the four ropes allow, 48.5904 deg"),
        "{told}"
    );
    let told = refused(&free("3 deg").replace("Q       = \"6 t\"", "Q       = \"0 t\""));
    assert!(told.starts_with("Q = 0: nothing hangs on the slings"), "{told}");
    // Thrown over the joint.
    let mut moving = model(&free("3 deg"));
    set(&mut moving, "psi_s", 1.4);
    set(&mut moving, "w_psi", 1.0);
    moving.start().expect("it begins");
    let fault = (0..100).find_map(|i| moving.advance(0.1 * f64::from(i), 0.1 * f64::from(i + 1)).err());
    let message = fault.expect("it ends").message;
    assert!(
        message.contains("the slings are slack, they would have to push with"),
        "{message}"
    );
}

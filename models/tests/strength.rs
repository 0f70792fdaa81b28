//! Strength of luffing drives. Beside the oracle of statics (`tests/test_strength.py`): where curves meet, what a pull, a slack
//! rope and a wider pin do, and what cannot be.

#[path = "common/named.rs"]
#[allow(dead_code, reason = "not every test uses all of it")]
mod named;

use lemnis_models::kernel::calc::Calc;
use lemnis_models::parts::buckling::{critical, meeting};
use lemnis_models::scene::Scene;
use named::{get, model, near, set};
use num_dual::Dual64;

const RACK: &str = include_str!("../scenes/portal_004_drive.toml");
const ROPE: &str = include_str!("../scenes/rope_luffing_drive.toml");
const SCREW: &str = include_str!("../scenes/portal_004_screw.toml");

/// Euler's and Johnson's curves have one value and one slope where they meet, at half the yield point.
#[test]
fn both_curves_of_buckling_meet_with_one_tangent() {
    for steel in [[210e9, 355e6], [70e9, 95e6], [1e9, 9e8]] {
        let meets = meeting(steel);
        let dual = steel.map(Dual64::from_re);
        let at = |x: f64| critical(Dual64::new(x, 1.0), meeting(dual), dual);
        let [below, above] = [at(meets * (1.0 - 1e-15)), at(meets)];
        for both in [below, above] {
            near(both.re, steel[1] / 2.0, 1e-14 * steel[1]);
        }
        near(below.eps, above.eps, 1e-13 * above.eps.abs());
        // A short bar bears its yield point, a long one less and less.
        near(critical(0.0, meets, steel), steel[1], 0.0);
        assert!(critical(10.0 * meets, meets, steel) < steel[1] / 190.0);
        assert!(Calc::value(at(2.0 * meets)) < Calc::value(at(0.5 * meets)));
    }
}

/// A pull does not buckle a bar; a push does as its safety asks, and the longer the bar the more.
#[test]
fn only_a_push_buckles() {
    let mut drive = model(RACK);
    let (mut pushed, mut pulled) = (0, 0);
    for place in drive.positions() {
        drive.set(0, place).expect("in the range");
        for case in 1..=3 {
            let [force, used] = ["F_r", "u_k"].map(|name| get(&mut drive, &format!("{name}[{case}]")));
            let bears = get(&mut drive, "N_cr");
            if force > 0.0 {
                near(used, 4.0 * force / bears, 1e-14 * used);
                pushed += 1;
            } else {
                near(used, 0.0, 0.0);
                pulled += 1;
            }
        }
    }
    assert!(pushed > 50 && pulled > 10, "{pushed} {pulled}");
}

#[test]
fn more_steel_is_less_stress() {
    let mut drive = model(RACK);
    let all = ["u_k[2]", "sigma_F[2]", "sigma_H[2]", "p_b[2]", "tau_p[2]"];
    let before = all.map(|name| get(&mut drive, name));
    for (name, by) in [("A_k", 2.0), ("b_f", 4.0)] {
        let value = get(&mut drive, name);
        set(&mut drive, name, by * value);
    }
    for pin in 1..=7 {
        let value = get(&mut drive, &format!("d_p[{pin}]"));
        set(&mut drive, &format!("d_p[{pin}]"), 2.0 * value);
    }
    let after = all.map(|name| get(&mut drive, name));
    for ((before, after), less) in before.into_iter().zip(after).zip([2.0, 4.0, 2.0, 2.0, 4.0]) {
        near(after * less, before, 1e-14 * before);
    }
}

/// Where the tackle would have to press, its rope is slack: it is not used, and its pull is told as negative.
#[test]
fn a_rope_that_would_press_is_slack() {
    let mut drive = model(ROPE);
    let mut slack = 0;
    for place in drive.positions() {
        drive.set(0, place).expect("in the range");
        let [force, pull, used] = ["F_r[3]", "S_w[3]", "u_w[3]"].map(|name| get(&mut drive, name));
        near(pull, -force / (8.0 * 0.93), 1e-12 * pull.abs());
        if force > 0.0 {
            assert!(pull < 0.0 && used == 0.0);
            slack += 1;
        }
    }
    assert!(slack > 0);
}

#[test]
fn what_cannot_be_is_told() {
    let change = |text: &str, old: &str, new: &str| {
        assert!(text.contains(old), "{old}");
        text.replacen(old, new, 1)
    };
    let rack = |old, new| change(RACK, old, new);
    let nut = "\n[cases.nut]\nd_3 = \"90 mm\"\nH_1 = \"7 mm\"\nP_1 = \"14 mm\"\nl_n = \"0.2 m\"\n";
    let rope = "\n[cases.rope]\nF_min = \"90 kN\"\nZ_p = \"5\"\nd_w = \"20 mm\"\nD_tr = \"0.5 m\"\nD_sh = \"0.5 m\"\n";
    for (text, told) in [
        (rack("i_min   = \"40.4 mm\"\n", ""), "without its cross-section"),
        (
            rack("r_z    = \"200 mm\"", "#").replacen("eta_d  = \"0.97\"", "#", 1),
            "whose pinion is not told",
        ),
        (
            rack("sigma_H_max = \"1150 MPa\"", "#"),
            "without what is allowed of sigma_H_max",
        ),
        (
            rack("tau_p_max = \"90 MPa\"", "#"),
            "without what is allowed of tau_p_max",
        ),
        (
            rack("tau_p_max = \"90 MPa\"", "tau_p_max = \"90 MPa\"\np_n_max = \"9 MPa\""),
            "a limit p_n_max that this scene has no result for",
        ),
        (rack("at  = \"C\"\nd_p", "at  = \"B\"\nd_p"), "pin B has two sizes"),
        (rack("at  = \"C\"\nd_p", "at  = \"X\"\nd_p"), "no pin \"X\""),
        (
            rack("mu_k    = \"1\" ", "mu_k    = \"1\"\nl_0 = \"5 m\" "),
            "no free length",
        ),
        (RACK.to_owned() + nut, "[cases.nut] with a rack"),
        (RACK.to_owned() + rope, "[cases.rope] with a rack"),
        (
            change(SCREW, "d_3 = \"104 mm\"", "d_3 = \"112 mm\""),
            "does not fit the pitch diameter",
        ),
        (
            change(
                SCREW,
                "l_0     = \"2.5 m\"",
                "A_k = \"0.01 m2\"\ni_min = \"30 mm\"\nl_0     = \"2.5 m\"",
            ),
            "another cross-section than its own",
        ),
        (change(ROPE, "h_tr  = \"18\"", "#"), "without what is allowed of h_tr"),
        (ROPE.to_owned() + nut, "[cases.nut] with a luffing tackle"),
    ] {
        let found = Scene::parse(&text).err().unwrap_or_default();
        let all: Vec<&str> = found.iter().map(|mistake| mistake.message.as_str()).collect();
        assert!(all.iter().any(|message| message.contains(told)), "{told}: {all:?}");
    }
}

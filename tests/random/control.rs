//! What makes controllers legal: gains that are stable at their cycle, one command, no moment beside them.

use crate::scene::Node;

/// Keys of a controlled axis: the moment that its controller gives, and those of its table.
pub struct Axis {
    pub moment: &'static str,
    /// K_p, K_i, cycle, ramp, greatest moment.
    pub settings: [&'static str; 5],
    /// Speed over distance, greatest speed, speed and place commanded.
    pub approach: [&'static str; 2],
    pub commands: [&'static str; 2],
    /// Least ramp that a scene may give.
    pub least: f64,
}

pub const SLEWING: Axis = Axis {
    moment: "M_sl",
    settings: ["K_psl", "K_isl", "T_csl", "a_sl", "M_maxsl"],
    approach: ["K_psisl", "omega_maxsl"],
    commands: ["omega_csl", "psi_csl"],
    least: 0.0,
};

pub const LUFFING: Axis = Axis {
    moment: "M_A",
    settings: ["K_pA", "K_iA", "T_cA", "a_A", "M_maxA"],
    approach: ["K_thetaA", "omega_maxA"],
    commands: ["omega_cA", "theta_cA"],
    least: 0.0,
};

pub const HOIST: Axis = Axis {
    moment: "M_Mh",
    settings: ["K_ph", "K_ih", "T_ch", "a_ch", "M_maxh"],
    approach: ["K_lh", "v_maxh"],
    commands: ["v_ch", "l_ch"],
    least: 1e-3,
};

/// Of a motor under a controller, in N·m: less no scene gives.
const LEAST_MOMENT: f64 = 1e-6;

/// Sets the table of a controller: moment over acceleration at least, a speed that the axis may have, two places between
/// which it may be sent, its cycle (s).
pub fn controlled(control: &mut Node, axis: &Axis, inertia: f64, speed: f64, [from, to]: [f64; 2], cycle: f64) {
    let time = control.draw.scale[2];
    // p = K_p T_c/J up to 1, and q = K_i T_c²/J below it.
    let p = control.draw.between(0.05, 1.0);
    let q = p * control.draw.between(0.01, 0.5);
    let ramp = (speed.abs().max(1e-6) / (time * control.draw.between(0.1, 2.0))).max(axis.least);
    let limit = (inertia * ramp * control.draw.between(0.5, 5.0)).max(LEAST_MOMENT);
    let values = [p * inertia / cycle, q * inertia / (cycle * cycle), cycle, ramp, limit];
    for (name, value) in axis.settings.into_iter().zip(values) {
        control.set(name, value);
    }
    let [by_speed, by_place] = axis.commands;
    let to_place = control.draw.coin(0.5);
    control.keep(by_place, to_place);
    for name in axis.approach {
        control.keep(name, to_place);
    }
    if to_place {
        let place = from + (to - from) * control.draw.between(0.0, 1.0);
        let steep = control.draw.between(0.05, 1.0) / time;
        for (name, value) in [
            (by_place, place),
            (axis.approach[0], steep),
            (axis.approach[1], speed.abs().max(1e-6)),
        ] {
            control.set(name, value);
        }
        control.remove(&[by_speed]);
    } else {
        control.set(by_speed, speed);
    }
}

/// A cycle that sees a motion of a time (s): few digits of minutes, so that it is the same in every unit.
pub fn cycle(n: &mut Node) -> f64 {
    let time = n.draw.scale[2];
    let minutes = (time * n.draw.between(0.01, 0.05)).clamp(1.01e-4, 9.9) / 60.0;
    let few: f64 = format!("{minutes:.2e}").parse().expect("a number");
    60.0 * few
}

//! What the book tells of the hopper, in its order.

use crate::component::outline::Explained::Stage;
use crate::component::outline::{Greatest, Limit, Most, Outline, chapters};
use crate::hopper::symbols as s;
use crate::kernel::symbol::listed;

pub const OUTLINE: Outline = Outline {
    inputs: chapters!(hopper "", load "m_g", motion, limits),
    constants: &[
        ("hopper_balance", &[Stage("steady")]),
        ("hopper_capacity", &[Stage("capacity")]),
    ],
    sections: &[
        ("hopper_contents", &[Stage("held")]),
        ("hopper_times", &[Stage("times")]),
        ("hopper_flow", &[Stage("flow")]),
    ],
    table: listed!(s: PHI_H, V_H, G_H, N_G, T_RUN),
    curves: &[("hopper_weight", None, &s::G_H), ("hopper_run", None, &s::T_RUN)],
    extremes: &[
        Greatest::new(&s::G_H_MAX, Most::Greatest, &s::G_H),
        Greatest::new(&s::T_RUN_MAX, Most::Greatest, &s::T_RUN),
    ],
    summary: listed!(s: K_Q, T_C_MAX, M_NEED, M_RES),
    sensitivity: listed!(s: K_Q, M_NEED, M_RES, G_H_MAX),
    limits: &[
        Limit::at_least("hopper_fed", &s::K_Q),
        Limit::not_negative("hopper_reserve", &s::M_RES),
        Limit::at_most("hopper_weight", &s::G_H_MAX),
    ],
    uses: &[("hopper_state", listed!(s: M_IN, M_OUT, M_S))],
    forces: &[&s::G_H],
    worst: &[("greatest_contents", &s::G_H_MAX)],
};

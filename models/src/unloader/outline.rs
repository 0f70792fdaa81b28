//! What the book tells of a grab unloader, in its order.

use crate::component::outline::Explained::Stage;
use crate::component::outline::{Greatest, Limit, Most, Outline, chapters};
use crate::kernel::symbol::listed;
use crate::unloader::symbols as s;

pub const OUTLINE: Outline = Outline {
    inputs: chapters!(
        unloader "", load "Q_n", unloader_drums "drums", unloader_phases "phases",
        unloader_way "way", hook, motion, limits
    ),
    constants: &[
        ("unloader_phases", &[Stage("worked")]),
        ("unloader_duty", &[Stage("duty")]),
        ("unloader_on_way", &[Stage("on_way"), Stage("damped")]),
    ],
    sections: &[
        ("unloader_trolley", &[Stage("weight"), Stage("resisting")]),
        ("unloader_auxiliary", &[Stage("auxiliary")]),
        ("unloader_ropes", &[Stage("ropes")]),
        ("unloader_drums", &[Stage("turning")]),
        ("unloader_planetary", &[Stage("differentials"), Stage("circulating")]),
        ("unloader_swung", &[Stage("answer"), Stage("swung")]),
        ("unloader_motors", &[Stage("motors")]),
        ("unloader_lifted", &[Stage("lifted")]),
    ],
    table: listed!(s: F_R, F_D, T_1, T_2, P_H, P_C, P_T, P_CIRC),
    curves: &[
        ("unloader_speeds", None, &s::N_D),
        ("unloader_pulls", None, &s::S_R),
        ("unloader_powers", None, &s::P_D),
        ("unloader_suns", None, &s::P_S),
        ("unloader_rings", None, &s::P_R),
        ("unloader_circulating", None, &s::P_CIRC),
    ],
    extremes: &[
        Greatest::new(&s::S_MAX, Most::Greatest, &s::S_R),
        Greatest::new(&s::T_MIN, Most::Least, &s::T_LOW),
        Greatest::new(&s::P_T_MAX, Most::Amount, &s::P_T),
        Greatest::new(&s::P_CIRC_MAX, Most::Greatest, &s::P_CIRC),
        Greatest::new(&s::NU_MIN, Most::Least, &s::NU_P),
    ],
    summary: listed!(s: T_CYC, Q_CYC, K_P, P_H_RMS, P_C_RMS, P_T_RMS, ED_H, ED_C, ED_T),
    sensitivity: listed!(s: S_MAX, T_MIN, NU_MIN, K_P),
    limits: &[
        Limit::not_negative("unloader_slack", &s::T_MIN),
        Limit::at_least("unloader_ropes", &s::NU_MIN),
        Limit::at_least("unloader_rate", &s::Q_CYC),
        Limit::at_most("unloader_hoisting", &s::P_H_RMS),
        Limit::at_most("unloader_closing", &s::P_C_RMS),
        Limit::at_most("unloader_travelling", &s::P_T_RMS),
    ],
    uses: &[],
    forces: listed!(s: S_R, T_1, T_2, F_T),
    worst: &[("greatest_drum_pull", &s::S_MAX)],
};

//! What the book tells of the trolley of a container bridge, in its order.

use crate::bridge::symbols as s;
use crate::component::outline::Explained::Stage;
use crate::component::outline::{Greatest, Limit, Most, Outline, chapters};
use crate::kernel::symbol::listed;

/// The section of spreader and load as two bodies, with what starts leave in its table.
pub const SLINGS: &str = "bridge_slings";

pub const OUTLINE: Outline = Outline {
    inputs: chapters!(
        bridge "", load "Q", bridge_tow "tow", bridge_wheels "driven", bridge_sheaves "sheaves", bridge_brakes "brakes", bridge_ropes "ropes", bridge_slings "slings",
        bridge_travel "profile", hook, motion, limits
    ),
    constants: &[
        ("bridge_suspension", &[Stage("hanging")]),
        (SLINGS, &[Stage("slung")]),
        ("bridge_skew", &[Stage("skew")]),
        ("bridge_profiles", &[Stage("profiles")]),
        ("bridge_feedback", &[Stage("damped")]),
        ("bridge_cycle", &[Stage("cycle")]),
    ],
    sections: &[
        ("bridge_rails", &[Stage("weight"), Stage("rails")]),
        ("bridge_list", &[Stage("listing")]),
        ("bridge_travel", &[Stage("passed"), Stage("forces")]),
        ("bridge_spreader", &[Stage("posture"), Stage("turning")]),
        (
            "bridge_motion",
            &[
                Stage("answer"),
                Stage("swung"),
                Stage("rates"),
                Stage("borne"),
                Stage("pulls"),
                Stage("led"),
            ],
        ),
        ("bridge_powers", &[Stage("powers")]),
        ("bridge_wheels", &[Stage("grip")]),
        ("bridge_brakes", &[Stage("braking"), Stage("sliding")]),
        ("bridge_tow", &[Stage("towed")]),
    ],
    table: listed!(s: R_1, R_2, F_R, P_T, K_AD, T_1, T_2, F_1, F_2, NU),
    curves: &[
        ("bridge_sea", None, &s::R_1),
        ("bridge_land", None, &s::R_2),
        ("bridge_sag_sea", None, &s::F_1),
        ("bridge_sag_land", None, &s::F_2),
    ],
    extremes: &[
        Greatest::new(&s::R_1_MAX, Most::Greatest, &s::R_1),
        Greatest::new(&s::R_2_MIN, Most::Least, &s::R_2),
        Greatest::new(&s::F_RT_MAX, Most::Amount, &s::F_R),
        Greatest::new(&s::P_TT_MAX, Most::Amount, &s::P_T),
        Greatest::new(&s::F_TOW_MAX, Most::Greatest, &s::F_TOW),
        Greatest::new(&s::NU_TOW_MIN, Most::Least, &s::NU),
        Greatest::new(&s::K_AD_MIN, Most::Least, &s::K_AD),
    ],
    summary: listed!(s: T_CYC, NU_BR, S_BR, K_BR, BETA_L, L_E, K_OMEGA, PHI_P1, PHI_P2, PHI_P3, PHI_P4, RHO_P1, RHO_P2, RHO_P3, RHO_P4),
    sensitivity: listed!(s: F_RT_MAX, K_OMEGA, NU_TOW_MIN, K_AD_MIN),
    limits: &[
        Limit::at_most("bridge_cycle", &s::T_CYC),
        Limit::at_most("bridge_power", &s::P_TT_MAX),
        Limit::at_most("bridge_rail", &s::R_1_MAX),
        Limit::at_most("bridge_sag", &s::F_TOW_MAX),
        Limit::at_least("bridge_rope", &s::NU_TOW_MIN),
        Limit::at_least("bridge_grip", &s::K_AD_MIN),
        Limit::at_least("bridge_brake", &s::NU_BR),
        Limit::at_most("bridge_stop", &s::S_BR),
        Limit::at_least("bridge_sliding", &s::K_BR),
        Limit::at_most("bridge_list", &s::BETA_L),
    ],
    uses: &[],
    forces: listed!(s: F_R, R_1, R_2, T_1, T_2),
    worst: &[("greatest_rail_load", &s::R_1_MAX)],
};

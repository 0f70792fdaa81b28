//! What the book tells of a double link, in its order.

use crate::balance;
use crate::balance::symbols as b;
use crate::component::description::Vocabulary;
use crate::component::outline::Explained::{Rows, Stage};
use crate::component::outline::{Greatest, Limit, Most, Outline, chapters, joined};
use crate::drive;
use crate::drive::outline as o;
use crate::drive::symbols as d;
use crate::kernel::gravity;
use crate::kernel::symbol::{Symbol, listed};
use crate::luffing::double_link::moving;
use crate::luffing::double_link::moving::symbols as m;
use crate::luffing::double_link::symbols as s;
use crate::luffing::led::outline::{LED, LEVEL as LED_LEVEL};
use crate::luffing::led::symbols as w;
use crate::luffing::moving::control;
use crate::luffing::moving::outline::MOVED;
use crate::luffing::resistances::outline::{EXTREMES, LIMITS, SUMMARY, USES};
use crate::luffing::resistances::symbols::{M_R_SUM, P_I};
use crate::luffing::strength::outline::WorkedOutline;
use crate::luffing::{resistances, strength};
use crate::parts::{
    air, ground, hanging, hydraulics, motor, shaping, side_wind, slope, starts, teeth, turntable, turntable_control,
};

pub const OUTLINE: Outline = Outline {
    inputs: chapters! {
        geometry "", rope, sheaves "rope.sheave", weights, drive, balance, load "Q", motion, moving "dynamics", luffing_control "control", hoisting, hoisting_control "hoisting.control", air, ground, slewing, slope "slewing.slope", slewing_control "slewing.control", oil "hydraulics",
        cases, case "cases.case", case_bodies "cases.body", case_pins "cases.pin", case_motor "cases.motor", case_start "cases.start", case_curve "cases.start.curve", case_brake "cases.brake", case_second_brake "cases.second_brake",
        case_buckling "cases.buckling", case_teeth "cases.teeth", case_nut "cases.nut", case_pin_sizes "cases.pin_size", limits
    },
    constants: &[
        ("geometry_constants", &[Stage("geometry")]),
        ("balance_constants", &[Stage("balancing")]),
        o::CRANK_CONSTANTS,
        o::GEARING,
    ],
    sections: &[
        ("position", &[Stage("position")]),
        ("angles", &[Rows(listed!(s: THETA_3, THETA_1, ALPHA_1, Y, L, MU))]),
        ("velocity", &[Stage("velocity"), Stage("head"), Rows(&[&s::BETA])]),
        ("pole", &[Stage("pole")]),
        LED,
        ("load_moment", &[Stage("load_moment"), Stage("by_pole")]),
        ("weight_moment", &[Stage("own")]),
        o::CRANK,
        o::LINE,
        ("balance", &[Stage("residual"), Stage("balanced")]),
        ("pin_forces", &[Stage("held"), Stage("push"), Stage("feet")]),
        o::SHAFT,
        ("published_forms", &[Stage("published")]),
    ],
    table: &[
        &s::THETA_3,
        &s::THETA_1,
        &s::R,
        &s::A_Y,
        &w::Y_Q,
        &s::ALPHA,
        &s::ALPHA_1,
        &s::MU,
        &s::V_AX,
        &s::M_Q,
        &s::M_D,
        &s::F_D,
    ],
    curves: &[
        ("li2022_fig_3", Some(&s::P_X), &s::P_Y),
        ("li2022_fig_4", None, &s::THETA_3),
        ("li2022_fig_4", None, &s::THETA_1),
        ("li2022_fig_5", None, &s::ALPHA_1),
        ("li2022_fig_6", Some(&s::R), &s::A_Y),
        ("led_path", Some(&s::R), &w::Y_Q),
        ("li2022_fig_7", None, &s::V_AX),
        ("li2022_fig_8", None, &s::M_Q),
    ],
    extremes: &joined::<_, 12, 31, 43>(
        [
            Greatest::new(&s::R_MAX, Most::Greatest, &s::R),
            Greatest::new(&s::R_MIN, Most::Least, &s::R),
            Greatest::new(&s::MU_MIN, Most::Least, &s::MU),
            Greatest::new(&s::V_AX_MAX, Most::Amount, &s::V_AX),
            Greatest::new(&s::M_Q_MAX, Most::Amount, &s::M_Q),
            Greatest::new(&s::M_D_MAX, Most::Amount, &s::M_D),
            Greatest::new(&s::N_3_MAX, Most::Amount, &s::N_3),
            o::FORCE_MAX,
            o::TORQUE_OUT_MAX,
            o::TORQUE_IN_MAX,
            o::PULL_MIN,
            o::PULL_MAX,
        ],
        EXTREMES,
    ),
    summary: &joined::<_, 9, 6, 15>(
        [
            &s::DELTA_Y,
            &s::EPSILON_Y,
            &w::DELTA_YQ,
            &w::EPSILON_YQ,
            &s::C_Q,
            &s::C_G,
            &d::LAMBDA_D,
            &d::RHO_D,
            &d::LOCK_D,
        ],
        SUMMARY,
    ),
    sensitivity: &[
        &s::MU_MIN,
        &s::EPSILON_Y,
        &w::EPSILON_YQ,
        &s::R_MAX,
        &s::M_Q_MAX,
        &s::F_D_MAX,
        &b::DM_MAX,
        &b::N_MAX,
    ],
    limits: &joined::<_, 12, 19, 31>(
        [
            Limit::at_least("transmission_angle", &s::MU_MIN),
            Limit::at_most("level_error", &s::EPSILON_Y),
            LED_LEVEL,
            Limit::at_most("balance_residual", &b::DM_MAX),
            Limit::at_least("balance_transmission", &b::GAMMA_MIN),
            Limit::at_most("balance_rod", &b::N_MAX),
            o::LOCKS,
            o::TORQUE_OUT,
            o::TORQUE_IN,
            o::PULLS,
            o::PULL,
            Limit::at_most("motion_swing", &m::PHI_MAX),
        ],
        LIMITS,
    ),
    uses: &joined::<_, 13, 3, 16>(MOVED, USES),
    forces: &[
        &s::F_O1X,
        &s::F_O1Y,
        &s::F_O3X,
        &s::F_O3Y,
        &s::F_BX,
        &s::F_BY,
        &s::F_CX,
        &s::F_CY,
        &s::N_3,
        &s::M_D,
        &s::F_D,
        &b::N_1,
        &b::F_KX,
        &b::F_KY,
        &b::F_MX,
        &b::F_MY,
    ],
    worst: &[("governing", &s::M_Q_MAX), ("dM_max", &b::DM_MAX)],
};

/// Its words, and those of parts that others have too.
pub const VOCABULARY: Vocabulary = Vocabulary {
    words: "symbol",
    own: &[
        s::ALL,
        w::ALL,
        balance::symbols::ALL,
        drive::symbols::ALL,
        moving::symbols::ALL,
        crate::luffing::moving::symbols::ALL,
        resistances::symbols::ALL,
        motor::ALL,
        starts::ALL,
        teeth::ALL,
        strength::symbols::ALL,
        air::ALL,
        ground::ALL,
        hanging::ALL,
        turntable::ALL,
        turntable_control::ALL,
        side_wind::ALL,
        slope::ALL,
        shaping::ALL,
        control::luffing::ALL,
        control::hoist::ALL,
        gravity::ALL,
        hydraulics::symbols::ALL,
    ],
    shared: &[],
};

/// Its unbalanced moments, each that has an exact one of its own before that.
pub const SIDE_BY_SIDE: &[&Symbol] = listed!(s:
    M_U_LOAD, M_U_ROPE, M_U_TIE, M_X_TIE, M_U_TRUNK, M_X_TRUNK, M_U_TIE_WIND, M_X_TIE_WIND, M_U_TRUNK_WIND, M_X_TRUNK_WIND,
    M_U_BOOM_WIND, M_X_BOOM_WIND, M_U_BOOM, M_X_BOOM
);

/// How they are worked out where the sum of the case is greatest.
pub const UNBALANCED: &[WorkedOutline] = &[(
    "worked_unbalanced",
    &M_R_SUM,
    &[
        ("unbalanced_weights", &[Stage("unbalanced")]),
        ("unbalanced_case", &[Stage("unbalanced_case")]),
    ],
    &[&P_I, &s::W_UL, &s::W_UX, &s::S_UX, &s::S_UB],
)];

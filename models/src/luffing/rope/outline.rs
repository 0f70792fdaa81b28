//! What the book tells of a boom on a luffing rope, in its order.

use crate::balance::symbols as b;
use crate::component::outline::Explained::Stage;
use crate::component::outline::{Greatest, Limit, Most, Outline, Purpose, chapters, joined};
use crate::kernel::symbol::listed;
use crate::luffing::moving::control::SETTINGS;
use crate::luffing::moving::symbols as m;
use crate::luffing::resistances::outline::{EXTREMES, LIMITS, SUMMARY, USES};
use crate::luffing::rope::symbols as s;
use crate::parts::turntable;

/// What given quantities of its own are for that no formula has.
const OWN_USES: [Purpose; 6] = [
    ("unloaded", &[&s::ETA_H]),
    ("start", &[&m::L_R, &m::PHI_R, &turntable::CHI_R]),
    ("friction", listed!(turntable: C_SL, M_F_SL)),
    ("stops", listed!(turntable: PSI_MIN, PSI_MAX)),
    ("hoist", &[&m::V_H, &m::A_H]),
    ("control", SETTINGS),
];

pub const OUTLINE: Outline = Outline {
    inputs: chapters!(geometry "", tackle, hoist_rope, weights, balance, load "Q", motion, moving "dynamics", luffing_control "control", hoisting, air, ground, slewing, slope "slewing.slope", slewing_control "slewing.control",
        cases, case "cases.case", case_bodies "cases.body", case_pins "cases.pin", case_motor "cases.motor", case_start "cases.start", case_curve "cases.start.curve", case_brake "cases.brake", case_second_brake "cases.second_brake",
        case_rope "cases.rope", case_pin_sizes "cases.pin_size", limits),
    constants: &[
        ("rope_constants", &[Stage("level")]),
        ("balance_constants", &[Stage("balancing")]),
    ],
    sections: &[
        ("rope_position", &[Stage("position")]),
        ("rope_tackle", &[Stage("falls")]),
        ("rope_path", &[Stage("stretch"), Stage("path")]),
        ("rope_velocity", &[Stage("travel"), Stage("speeds")]),
        ("rope_load", &[Stage("hanging")]),
        ("rope_weight", &[Stage("own")]),
        ("balance", &[Stage("residual"), Stage("balanced")]),
        ("rope_pull", &[Stage("carried"), Stage("pull"), Stage("power")]),
        ("rope_losses", &[Stage("losses")]),
    ],
    table: listed!(s: R, A_Y, Y_Q, L_T, L_L, L_H, V_Q, M_Q, M_D, T, N_B),
    curves: &[
        ("rope_path", Some(&s::R), &s::Y_Q),
        ("rope_moment", None, &s::M_D),
        ("rope_pull", None, &s::T),
        ("rope_drum", None, &s::S_L_UP),
    ],
    extremes: &joined::<_, 7, 31, 38>(
        [
            Greatest::new(&s::R_MAX, Most::Greatest, &s::R),
            Greatest::new(&s::R_MIN, Most::Least, &s::R),
            Greatest::new(&s::M_Q_MAX, Most::Amount, &s::M_Q),
            Greatest::new(&s::T_MAX, Most::Greatest, &s::T),
            Greatest::new(&s::S_L_MAX, Most::Greatest, &s::S_L_UP),
            Greatest::new(&s::N_B_MAX, Most::Amount, &s::N_B),
            Greatest::new(&s::P_L_MAX, Most::Amount, &s::P_L),
        ],
        EXTREMES,
    ),
    summary: &joined::<_, 6, 6, 12>(
        [
            &s::DELTA_Y,
            &s::EPSILON_Y,
            &s::DELTA_L_T,
            &s::L_L_MAX,
            &s::PHI_T,
            &s::PHI_T0,
        ],
        SUMMARY,
    ),
    sensitivity: &[&s::EPSILON_Y, &s::R_MAX, &s::T_MAX, &s::N_B_MAX, &b::DM_MAX],
    limits: &joined::<_, 9, 19, 28>(
        [
            Limit::at_most("level_error", &s::EPSILON_Y),
            Limit::at_most("rope_pull", &s::T_MAX),
            Limit::at_most("rope_drum", &s::S_L_MAX),
            Limit::beyond("fall_back", &s::PHI_T),
            Limit::beyond("fall_back_empty", &s::PHI_T0),
            Limit::at_most("balance_residual", &b::DM_MAX),
            Limit::at_least("balance_transmission", &b::GAMMA_MIN),
            Limit::at_most("balance_rod", &b::N_MAX),
            Limit::at_most("motion_swing", &m::PHI_MAX),
        ],
        LIMITS,
    ),
    uses: &joined::<Purpose, 6, 3, 9>(OWN_USES, USES),
    forces: listed!(s: F_O1X, F_O1Y, N_B, T, T_UP, S_L_UP, S_H_UP, M_D),
    worst: &[("greatest_pull", &s::T_MAX)],
};

//! What the book tells of a boom with a curved trunk, in its order.

use crate::balance::symbols as b;
use crate::component::outline::Explained::Stage;
use crate::component::outline::{Greatest, Limit, Most, Outline, Purpose, chapters, joined};
use crate::drive::outline as o;
use crate::drive::symbols as d;
use crate::luffing::curved_trunk::symbols as s;
use crate::luffing::led::outline::{LED, LEVEL as LED_LEVEL};
use crate::luffing::led::symbols as w;
use crate::luffing::moving::outline::MOVED;
use crate::luffing::moving::symbols as m;
use crate::luffing::resistances::outline::{EXTREMES, LIMITS, SUMMARY, USES};

/// What given quantities of its own are for that no formula has.
const OWN_USES: [Purpose; 1] = [("tail_points", &[&s::X_T, &s::Y_T])];

pub const OUTLINE: Outline = Outline {
    inputs: chapters!(geometry "", rope, sheaves "rope.sheave", tail, tail_points "tail.points", weights, drive, balance, load "Q", motion, moving "dynamics", luffing_control "control", hoisting, hoisting_control "hoisting.control", air, ground, slewing, slope "slewing.slope", slewing_control "slewing.control", oil "hydraulics",
        cases, case "cases.case", case_bodies "cases.body", case_pins "cases.pin", case_motor "cases.motor", case_start "cases.start", case_curve "cases.start.curve", case_brake "cases.brake", case_second_brake "cases.second_brake",
        case_buckling "cases.buckling", case_teeth "cases.teeth", case_nut "cases.nut", case_pin_sizes "cases.pin_size", limits),
    constants: &[
        ("trunk_tail", &[Stage("tail")]),
        ("balance_constants", &[Stage("balancing")]),
        o::CRANK_CONSTANTS,
        o::GEARING,
    ],
    sections: &[
        ("trunk_contact", &[Stage("contact")]),
        ("trunk_position", &[Stage("position")]),
        ("trunk_velocity", &[Stage("travel"), Stage("speeds")]),
        ("trunk_pole", &[Stage("pole")]),
        LED,
        ("trunk_load", &[Stage("hanging")]),
        ("trunk_weight", &[Stage("own")]),
        o::CRANK,
        o::LINE,
        ("balance", &[Stage("residual"), Stage("balanced")]),
        (
            "trunk_pins",
            &[
                Stage("pins"),
                Stage("push"),
                Stage("bearing"),
                Stage("pressure"),
                Stage("power"),
            ],
        ),
        o::SHAFT,
    ],
    table: &[
        &s::R,
        &s::A_Y,
        &w::Y_Q,
        &s::ALPHA,
        &s::W,
        &s::F,
        &s::MU,
        &s::V_AX,
        &s::M_Q,
        &s::M_D,
        &d::F_D,
        &s::N_T,
        &s::Q_T,
    ],
    curves: &[
        ("trunk_path", Some(&s::R), &s::A_Y),
        ("led_path", Some(&s::R), &w::Y_Q),
        ("trunk_velocity", Some(&s::R), &s::V_AX),
        ("trunk_moment", None, &s::M_D),
        ("trunk_wrap", None, &s::W),
        ("trunk_tie", None, &s::N_T),
    ],
    extremes: &joined::<_, 17, 31, 48>(
        [
            Greatest::new(&s::R_MAX, Most::Greatest, &s::R),
            Greatest::new(&s::R_MIN, Most::Least, &s::R),
            Greatest::new(&s::W_MAX, Most::Greatest, &s::W),
            Greatest::new(&s::W_MIN, Most::Least, &s::W),
            Greatest::new(&s::MU_MIN, Most::Least, &s::MU),
            Greatest::new(&s::V_AX_MAX, Most::Amount, &s::V_AX),
            Greatest::new(&s::M_Q_MAX, Most::Amount, &s::M_Q),
            Greatest::new(&s::M_D_MAX, Most::Amount, &s::M_D),
            o::FORCE_MAX,
            o::TORQUE_OUT_MAX,
            o::TORQUE_IN_MAX,
            o::PULL_MIN,
            o::PULL_MAX,
            Greatest::new(&s::N_T_MAX, Most::Greatest, &s::N_T),
            Greatest::new(&s::N_T_MIN, Most::Least, &s::N_T),
            Greatest::new(&s::Q_T_MAX, Most::Greatest, &s::Q_T),
            Greatest::new(&s::P_T_MAX, Most::Greatest, &s::P_T),
        ],
        EXTREMES,
    ),
    summary: &joined::<_, 7, 6, 13>(
        [
            &s::DELTA_Y,
            &s::EPSILON_Y,
            &w::DELTA_YQ,
            &w::EPSILON_YQ,
            &d::LAMBDA_D,
            &d::RHO_D,
            &d::LOCK_D,
        ],
        SUMMARY,
    ),
    sensitivity: &[
        &s::EPSILON_Y,
        &w::EPSILON_YQ,
        &s::R_MAX,
        &s::M_Q_MAX,
        &s::M_D_MAX,
        &d::F_D_MAX,
        &s::N_T_MAX,
        &b::DM_MAX,
    ],
    limits: &joined::<_, 17, 19, 36>(
        [
            Limit::at_most("level_error", &s::EPSILON_Y),
            LED_LEVEL,
            Limit::at_least("trunk_transmission", &s::MU_MIN),
            Limit::at_least("trunk_wrap", &s::W_MIN),
            Limit::at_most("trunk_drive", &s::M_D_MAX),
            Limit::at_most("trunk_tie", &s::N_T_MAX),
            Limit::not_negative("trunk_slack", &s::N_T_MIN),
            Limit::at_most("trunk_pressure", &s::P_T_MAX),
            o::LOCKS,
            o::TORQUE_OUT,
            o::TORQUE_IN,
            o::PULLS,
            o::PULL,
            Limit::at_most("balance_residual", &b::DM_MAX),
            Limit::at_least("balance_transmission", &b::GAMMA_MIN),
            Limit::at_most("balance_rod", &b::N_MAX),
            Limit::at_most("motion_swing", &m::PHI_MAX),
        ],
        LIMITS,
    ),
    uses: &joined::<_, 1, 16, 17>(OWN_USES, joined::<_, 13, 3, 16>(MOVED, USES)),
    forces: &[
        &s::N_T,
        &s::Q_T,
        &s::P_T,
        &s::F_BX,
        &s::F_BY,
        &s::F_O1X,
        &s::F_O1Y,
        &s::M_D,
        &d::F_D,
    ],
    worst: &[("greatest_tie", &s::N_T_MAX), ("trunk_speed", &s::V_AX_MAX)],
};

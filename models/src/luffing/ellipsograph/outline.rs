//! What the book tells of a boom on guide and link, in its order.

use crate::balance::symbols as b;
use crate::component::outline::Explained::Stage;
use crate::component::outline::{Greatest, Limit, Most, Outline, chapters, joined};
use crate::drive::outline as o;
use crate::drive::symbols as d;
use crate::luffing::ellipsograph::symbols as s;
use crate::luffing::moving::outline::MOVED;
use crate::luffing::moving::symbols as m;
use crate::luffing::resistances::outline::{EXTREMES, LIMITS, SUMMARY, USES};

pub const OUTLINE: Outline = Outline {
    inputs: chapters!(geometry "", weights, drive, balance, load "Q", motion, moving "dynamics", luffing_control "control", hoisting, hoisting_control "hoisting.control", air, ground, slewing, slope "slewing.slope", slewing_control "slewing.control", oil "hydraulics",
        cases, case "cases.case", case_bodies "cases.body", case_pins "cases.pin", case_motor "cases.motor", case_start "cases.start", case_curve "cases.start.curve", case_brake "cases.brake", case_second_brake "cases.second_brake",
        case_buckling "cases.buckling", case_teeth "cases.teeth", case_nut "cases.nut", case_pin_sizes "cases.pin_size", limits),
    constants: &[
        ("ellipsograph_axes", &[Stage("axes")]),
        ("balance_constants", &[Stage("balancing")]),
        o::CRANK_CONSTANTS,
        o::GEARING,
    ],
    sections: &[
        ("ellipsograph_position", &[Stage("position")]),
        ("ellipsograph_pole", &[Stage("pole")]),
        ("ellipsograph_velocity", &[Stage("travel"), Stage("speeds")]),
        ("ellipsograph_load", &[Stage("hanging")]),
        ("ellipsograph_weight", &[Stage("own")]),
        o::CRANK,
        o::LINE,
        ("balance", &[Stage("residual"), Stage("balanced")]),
        ("ellipsograph_drive", &[Stage("needed"), Stage("power"), Stage("push")]),
        ("ellipsograph_pins", &[Stage("pins")]),
        o::SHAFT,
    ],
    table: &[
        &s::R,
        &s::A_Y,
        &s::B_Y,
        &s::V_AX,
        &s::V_B,
        &s::M_Q,
        &s::M_D,
        &d::F_D,
        &s::F_BX,
        &s::N_L,
        &s::F_O1X,
        &s::F_O1Y,
    ],
    curves: &[
        ("ellipsograph_path", Some(&s::R), &s::A_Y),
        ("ellipsograph_velocity", Some(&s::R), &s::V_AX),
        ("ellipsograph_moment", None, &s::M_D),
        ("ellipsograph_guide", None, &s::F_BX),
        ("ellipsograph_link", None, &s::N_L),
    ],
    extremes: &joined::<_, 12, 31, 43>(
        [
            Greatest::new(&s::R_MAX, Most::Greatest, &s::R),
            Greatest::new(&s::R_MIN, Most::Least, &s::R),
            Greatest::new(&s::V_AX_MAX, Most::Amount, &s::V_AX),
            Greatest::new(&s::M_Q_MAX, Most::Amount, &s::M_Q),
            Greatest::new(&s::M_D_MAX, Most::Amount, &s::M_D),
            o::FORCE_MAX,
            o::TORQUE_OUT_MAX,
            o::TORQUE_IN_MAX,
            o::PULL_MIN,
            o::PULL_MAX,
            Greatest::new(&s::F_B_MAX, Most::Amount, &s::F_BX),
            Greatest::new(&s::N_L_MAX, Most::Amount, &s::N_L),
        ],
        EXTREMES,
    ),
    summary: &joined::<_, 6, 6, 12>(
        [
            &s::DELTA_Y,
            &s::EPSILON_Y,
            &s::DELTA_B,
            &d::LAMBDA_D,
            &d::RHO_D,
            &d::LOCK_D,
        ],
        SUMMARY,
    ),
    sensitivity: &[
        &s::EPSILON_Y,
        &s::R_MAX,
        &s::M_D_MAX,
        &d::F_D_MAX,
        &s::F_B_MAX,
        &s::N_L_MAX,
        &b::DM_MAX,
    ],
    limits: &joined::<_, 13, 19, 32>(
        [
            Limit::at_most("level_error", &s::EPSILON_Y),
            Limit::at_most("ellipsograph_drive", &s::M_D_MAX),
            Limit::at_most("ellipsograph_guide", &s::F_B_MAX),
            Limit::at_most("ellipsograph_link", &s::N_L_MAX),
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
    uses: &joined::<_, 13, 3, 16>(MOVED, USES),
    forces: &[
        &s::F_BX,
        &s::F_CX,
        &s::F_CY,
        &s::N_L,
        &s::F_O1X,
        &s::F_O1Y,
        &s::M_D,
        &d::F_D,
    ],
    worst: &[
        ("ellipsograph_guide", &s::F_B_MAX),
        ("ellipsograph_speed", &s::V_AX_MAX),
    ],
};

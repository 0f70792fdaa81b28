//! What the book tells of a boom on guide and link, in its order.

use crate::balance::symbols as b;
use crate::component::outline::Explained::Stage;
use crate::component::outline::{Greatest, Limit, Most, Outline, chapters};
use crate::kernel::symbol::listed;
use crate::luffing::ellipsograph::symbols as s;
use crate::luffing::moving::symbols as m;

pub const OUTLINE: Outline = Outline {
    inputs: chapters!(geometry "", weights, balance, load "Q", motion, moving "dynamics", hoisting, limits),
    constants: &[
        ("ellipsograph_axes", &[Stage("axes")]),
        ("balance_constants", &[Stage("balancing")]),
    ],
    sections: &[
        ("ellipsograph_position", &[Stage("position")]),
        ("ellipsograph_pole", &[Stage("pole")]),
        ("ellipsograph_velocity", &[Stage("travel"), Stage("speeds")]),
        ("ellipsograph_load", &[Stage("hanging")]),
        ("ellipsograph_weight", &[Stage("own")]),
        ("balance", &[Stage("residual"), Stage("balanced")]),
        ("ellipsograph_drive", &[Stage("drive"), Stage("power")]),
        ("ellipsograph_pins", &[Stage("pins")]),
        ("ellipsograph_bodies", &[Stage("built")]),
        ("ellipsograph_motion", &[Stage("moves")]),
    ],
    table: listed!(s: R, A_Y, B_Y, V_AX, V_B, M_Q, M_D, F_BX, N_L, F_O1X, F_O1Y),
    curves: &[
        ("ellipsograph_path", Some(&s::R), &s::A_Y),
        ("ellipsograph_velocity", Some(&s::R), &s::V_AX),
        ("ellipsograph_moment", None, &s::M_D),
        ("ellipsograph_guide", None, &s::F_BX),
        ("ellipsograph_link", None, &s::N_L),
    ],
    extremes: &[
        Greatest::new(&s::R_MAX, Most::Greatest, &s::R),
        Greatest::new(&s::R_MIN, Most::Least, &s::R),
        Greatest::new(&s::V_AX_MAX, Most::Amount, &s::V_AX),
        Greatest::new(&s::M_Q_MAX, Most::Amount, &s::M_Q),
        Greatest::new(&s::M_D_MAX, Most::Amount, &s::M_D),
        Greatest::new(&s::F_B_MAX, Most::Amount, &s::F_BX),
        Greatest::new(&s::N_L_MAX, Most::Amount, &s::N_L),
    ],
    summary: &[&s::DELTA_Y, &s::EPSILON_Y, &s::DELTA_B],
    sensitivity: &[
        &s::EPSILON_Y,
        &s::R_MAX,
        &s::M_D_MAX,
        &s::F_B_MAX,
        &s::N_L_MAX,
        &b::DM_MAX,
    ],
    limits: &[
        Limit::at_most("level_error", &s::EPSILON_Y),
        Limit::at_most("ellipsograph_drive", &s::M_D_MAX),
        Limit::at_most("ellipsograph_guide", &s::F_B_MAX),
        Limit::at_most("ellipsograph_link", &s::N_L_MAX),
        Limit::at_most("balance_residual", &b::DM_MAX),
        Limit::at_least("balance_transmission", &b::GAMMA_MIN),
        Limit::at_most("balance_rod", &b::N_MAX),
    ],
    uses: &[("start", &[&m::L_R, &m::PHI_R]), ("hoist", &[&m::V_H, &m::A_H])],
    forces: listed!(s: F_BX, F_CX, F_CY, N_L, F_O1X, F_O1Y, M_D),
    worst: &[
        ("ellipsograph_guide", &s::F_B_MAX),
        ("ellipsograph_speed", &s::V_AX_MAX),
    ],
};

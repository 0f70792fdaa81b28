//! What books of luffing mechanisms in motion tell alike.

use crate::component::outline::Purpose;
use crate::drive::symbols as d;
use crate::kernel::symbol::{Symbol, listed};
use crate::luffing::moving::control::SETTINGS;
use crate::luffing::moving::symbols as m;
use crate::parts::hydraulics::symbols as h;
use crate::parts::turntable;

/// What given quantities of motion, hoist, oil and slewing are for that no formula has.
pub const MOVED: [Purpose; 13] = [
    ("annulus", &[&d::D_R]),
    ("start", &[&m::L_R, &m::PHI_R, &turntable::CHI_R]),
    ("hoist", &[&m::V_H, &m::A_H]),
    ("relief", listed!(m: P_R, K_R)),
    ("anti_cavitation", listed!(m: P_AC, K_AC)),
    ("load_holding", listed!(m: P_LH, I_LH, DP_LH, X_T)),
    ("pump_limits", listed!(m: P_P, Q_PMAX, P_PMAX)),
    ("tank", &[&m::P_TANK]),
    ("friction", listed!(turntable: C_SL, M_F_SL)),
    ("stops", listed!(turntable: PSI_MIN, PSI_MAX)),
    ("control", SETTINGS),
    ("drum_friction", &[&m::M_F_H]),
    ("shaft_brakes", &[&m::U_BR]),
];

/// Of the oil, of the rope, of a load put down, of controlled drives and of the wind on what slews, over a cycle of commands.
pub const FOLLOWED: &[&Symbol] = &[
    &h::Q_ACA,
    &h::Q_ACB,
    &h::Y_LHA,
    &h::Y_LHB,
    &h::P_S,
    &m::S_R,
    &m::H_G,
    &m::N_G,
    &m::M_A,
    &m::M_SL,
    &m::M_WS,
    &m::M_GAMMA,
    &m::M_M_H,
];

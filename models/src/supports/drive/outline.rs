//! What the book tells of a slewing drive.

use crate::component::outline::Explained::{Rows, Stage};
use crate::component::outline::{Greatest, Limit, Line, Most, SectionOutline};
use crate::component::whole::{How, Whole};
use crate::kernel::symbol::{Symbol, listed};
use crate::parts::starts::way::{ENGINED, RAMPED, SLIPPED};
use crate::supports::drive::moving::{RUBS, SLIPS};
use crate::supports::drive::symbols as s;

pub const CONSTANTS: [SectionOutline; 3] = [
    ("turning_gear", &[Stage("geared"), Stage("side")]),
    ("turning_works", &[Stage("works_turned")]),
    ("turning_mesh", &[Stage("meshed")]),
];

pub const SECTIONS: [SectionOutline; 9] = [
    ("turning_steady", &[Stage("swung")]),
    ("turning_moments", &[Stage("rubbing"), Stage("dry"), Stage("turned")]),
    ("turning_motor", &[Stage("motors")]),
    ("resistances_slip", &[Rows(SLIPPED)]),
    ("resistances_inverter", &[Rows(RAMPED)]),
    ("resistances_engine", &[Rows(ENGINED)]),
    ("turning_hold", &[Stage("holding")]),
    (
        "turning_stop",
        &[Stage("stopping"), Stage("pushed"), Stage("coupled"), Stage("slips")],
    ),
    ("turning_teeth", &[Stage("pinions")]),
];

pub const CURVES: [Line; 3] = [
    ("turning_outer", None, &s::M_Z),
    ("turning_steady", None, &s::M_ST),
    ("turning_stop", None, &s::T_STOP),
];

pub const EXTREMES: [Greatest; 22] = [
    Greatest::new(&s::M_ST_TOP, Most::Greatest, &s::M_ST),
    Greatest::new(&s::P_M_MAX, Most::Greatest, &s::P_M),
    Greatest::new(&s::U_M_MAX, Most::Greatest, &s::U_M),
    Greatest::new(&s::T_START_MAX, Most::Greatest, &s::T_START),
    Greatest::new(&s::A_START_MAX, Most::Greatest, &s::A_START),
    Greatest::new(&s::T_SLIP_MAX, Most::Greatest, &s::T_SLIP),
    Greatest::new(&s::A_SLIP_MAX, Most::Greatest, &s::A_SLIP),
    Greatest::new(&s::T_INV_MAX, Most::Greatest, &s::T_INV),
    Greatest::new(&s::A_INV_MAX, Most::Greatest, &s::A_INV),
    Greatest::new(&s::T_ENG_MAX, Most::Greatest, &s::T_ENG),
    Greatest::new(&s::A_ENG_MAX, Most::Greatest, &s::A_ENG),
    Greatest::new(&s::U_BS_MAX, Most::Greatest, &s::U_BS),
    Greatest::new(&s::T_STOP_MAX, Most::Greatest, &s::T_STOP),
    Greatest::new(&s::PSI_STOP_MAX, Most::Greatest, &s::PSI_STOP),
    Greatest::new(&s::A_STOP_MAX, Most::Greatest, &s::A_STOP),
    Greatest::new(&s::T_LIM_MAX, Most::Greatest, &s::T_LIM),
    SLIPS,
    RUBS,
    Greatest::new(&s::T_GP_MAX, Most::Greatest, &s::T_GP),
    Greatest::new(&s::F_T_MAX, Most::Greatest, &s::F_T),
    Greatest::new(&s::SIGMA_FZ_MAX, Most::Greatest, &s::SIGMA_FZ),
    Greatest::new(&s::SIGMA_HZ_MAX, Most::Greatest, &s::SIGMA_HZ),
];

/// Shafts of the gear, of which the last one is told.
pub const SHAFTS: &[SectionOutline] = &[("turning_shafts", &[Stage("carrying"), Stage("shafts")])];

/// Columns of their table, after the number of each.
pub const SHAFT_COLUMNS: &[&Symbol] = listed!(s: U_G, ETA_U, N_G, T_G, P_G, T_GP);

/// Of the motors over slewing there and back.
pub const WHOLE: [Whole; 2] = [
    Whole::new(&s::P_SL_RMS, How::RootMean(&s::TAU_S), &s::P_HS),
    Whole::new(&s::U_SL_RMS, How::RootMean(&s::TAU_S), &s::U_HS),
];

pub const SUMMARY: [&Symbol; 2] = [&s::P_SL_RMS, &s::U_SL_RMS];

pub const LIMITS: [Limit; 15] = [
    Limit::within("turning_heating", &s::U_SL_RMS, 1.0),
    Limit::within("turning_overload", &s::U_M_MAX, 1.0),
    Limit::at_most("turning_start", &s::T_START_MAX),
    Limit::at_most("turning_quick", &s::A_START_MAX),
    Limit::at_most("turning_slip", &s::T_SLIP_MAX),
    Limit::at_most("turning_slip_quick", &s::A_SLIP_MAX),
    Limit::at_most("turning_inverter", &s::T_INV_MAX),
    Limit::at_most("turning_inverter_quick", &s::A_INV_MAX),
    Limit::at_most("turning_engine", &s::T_ENG_MAX),
    Limit::at_most("turning_engine_quick", &s::A_ENG_MAX),
    Limit::within("turning_hold", &s::U_BS_MAX, 1.0),
    Limit::at_most("turning_stop", &s::T_STOP_MAX),
    Limit::at_most("turning_hard", &s::A_STOP_MAX),
    Limit::at_most("turning_bending", &s::SIGMA_FZ_MAX),
    Limit::at_most("turning_contact", &s::SIGMA_HZ_MAX),
];

//! What the book tells of the cases.

use crate::component::outline::Explained::{Rows, Stage};
use crate::component::outline::{Greatest, Limit, Line, Most, Purpose, joined};
use crate::component::whole::{How, Whole};
use crate::drive::symbols::H_D;
use crate::kernel::symbol::{Symbol, listed};
use crate::luffing::resistances::symbols as s;
use crate::luffing::strength::outline as strength;
use crate::luffing::strength::outline::WorkedOutline;
use crate::parts::starts::engine;
use crate::parts::starts::way::{ENGINED, RAMPED, SLIPPED};

/// What formulas of motor and brakes take from places and bodies, and what from the moments of the case.
pub const MOVED: &[&Symbol] = listed!(s: DS_S, DX_H, J_R);
const RESISTED: &[&Symbol] = listed!(s: DS_S, DX_H, J_R, M_R_INERTIA, M_R_FRICTION, M_R_SUM, F_R);
/// The same with the integrals of a start along the slip curve or an engine's.
const STARTED: &[&Symbol] = listed!(s: DS_S, DX_H, J_R, M_R_INERTIA, M_R_FRICTION, M_R_SUM, F_R, I_S, I_E);

/// What is worked out, each for the case and at the place in which a result is greatest by amount: id of the words, that
/// result, the formulas, and what they take from elsewhere; the first of them takes all of the bodies.
pub const WORKED: [WorkedOutline; 10] = joined(OWN_WORKED, strength::WORKED);

const OWN_WORKED: [WorkedOutline; 4] = [
    (
        "worked",
        &s::M_R_SUM,
        &[
            ("resistances_own", &[Stage("sums")]),
            ("resistances_case", &[Stage("resisted")]),
            ("resistances_sum", &[Stage("rubbed"), Stage("force")]),
        ],
        &[],
    ),
    (
        "worked_motor",
        &s::P_M,
        &[
            ("resistances_motor", &[Stage("motored")]),
            ("resistances_slip", &[Rows(SLIPPED)]),
            ("resistances_inverter", &[Rows(RAMPED)]),
            ("resistances_engine", &[Rows(ENGINED)]),
        ],
        STARTED,
    ),
    (
        "worked_holding",
        &s::T_K,
        &[("resistances_holding", &[Stage("holding")])],
        RESISTED,
    ),
    (
        "worked_stopping",
        &s::T_STOP,
        &[("resistances_stopping", &[Stage("stopped")])],
        RESISTED,
    ),
];

/// With those of strength.
pub const EXTREMES: [Greatest; 31] = joined(OWN_EXTREMES, strength::EXTREMES);

const OWN_EXTREMES: [Greatest; 20] = [
    Greatest::new(&s::M_R_OWN_MAX, Most::Amount, &s::M_R_OWN),
    Greatest::new(&s::M_R_LOAD_MAX, Most::Amount, &s::M_R_LOAD),
    Greatest::new(&s::M_R_SWAY_MAX, Most::Amount, &s::M_R_SWAY),
    Greatest::new(&s::M_R_WIND_MAX, Most::Amount, &s::M_R_WIND),
    Greatest::new(&s::M_R_CENTRIFUGAL_MAX, Most::Amount, &s::M_R_CENTRIFUGAL),
    Greatest::new(&s::M_R_INERTIA_MAX, Most::Amount, &s::M_R_INERTIA),
    Greatest::new(&s::M_R_SLOPE_MAX, Most::Amount, &s::M_R_SLOPE),
    Greatest::new(&s::M_R_FRICTION_MAX, Most::Amount, &s::M_R_FRICTION),
    Greatest::new(&s::M_R_MAX, Most::Amount, &s::M_R_SUM),
    Greatest::new(&s::F_R_MAX, Most::Amount, &s::F_R).with_pole(&H_D),
    Greatest::new(&s::T_M_MAX, Most::Amount, &s::T_M),
    Greatest::new(&s::P_M_MAX, Most::Greatest, &s::P_M),
    Greatest::new(&s::U_M_MAX, Most::Greatest, &s::U_M),
    Greatest::new(&s::T_START_MAX, Most::Greatest, &s::T_START),
    Greatest::new(&s::A_START_MAX, Most::Greatest, &s::A_START),
    Greatest::new(&s::T_K_MAX, Most::Greatest, &s::T_K),
    Greatest::new(&s::U_B_MAX, Most::Greatest, &s::U_B),
    Greatest::new(&s::T_STOP_MAX, Most::Greatest, &s::T_STOP),
    Greatest::new(&s::S_STOP_MAX, Most::Greatest, &s::S_STOP),
    Greatest::new(&s::A_STOP_MAX, Most::Greatest, &s::A_STOP),
];

/// Of the motor over its cycle.
pub const WHOLE: [Whole; 4] = [
    Whole::new(&s::P_RMS, How::RootMean(&s::TAU_H), &s::P_H),
    Whole::new(&s::U_RMS, How::RootMean(&s::TAU_H), &s::U_H),
    Whole::new(&s::T_LUFF, How::Integral, &s::TAU_H),
    Whole::new(&s::V_MEAN, How::Mean(&s::TAU_H), &s::V_H_A),
];

/// With those of strength.
pub const SUMMARY: [&Symbol; 6] = joined([&s::P_RMS, &s::U_RMS, &s::T_LUFF, &s::V_MEAN], strength::SUMMARY);

/// With those of strength.
pub const LIMITS: [Limit; 19] = joined(OWN_LIMITS, strength::LIMITS);

const OWN_LIMITS: [Limit; 6] = [
    Limit::within("motor_heating", &s::U_RMS, 1.0),
    Limit::within("motor_overload", &s::U_M_MAX, 1.0),
    Limit::within("brakes_hold", &s::U_B_MAX, 1.0),
    Limit::at_most("motor_start", &s::A_START_MAX),
    Limit::at_most("brakes_stop", &s::A_STOP_MAX),
    Limit::at_most("brakes_time", &s::T_STOP_MAX),
];

/// Columns of the tables over the working range.
pub const COLUMNS: &[&Symbol] = listed!(s:
    M_R_OWN, M_R_LOAD, M_R_SWAY, M_R_WIND, M_R_CENTRIFUGAL, M_R_INERTIA, M_R_SLOPE, M_R_FRICTION, M_R_SUM, F_R
);

/// Of motor and brakes.
pub const SHAFT_COLUMNS: &[&Symbol] = listed!(s:
    T_M, P_M, U_M, T_0, T_START, A_START, T_SLIP, A_SLIP, T_INV, A_INV, T_ENG, A_ENG, T_H, T_K, T_STOP, S_STOP, A_STOP
);

/// With those of strength.
pub const CURVES: [Line; 16] = joined(OWN_CURVES, strength::CURVES);

const OWN_CURVES: [Line; 12] = [
    ("resistance_own", None, &s::M_R_OWN),
    ("resistance_load", None, &s::M_R_LOAD),
    ("resistance_sway", None, &s::M_R_SWAY),
    ("resistance_wind", None, &s::M_R_WIND),
    ("resistance_centrifugal", None, &s::M_R_CENTRIFUGAL),
    ("resistance_inertia", None, &s::M_R_INERTIA),
    ("resistance_slope", None, &s::M_R_SLOPE),
    ("resistance_friction", None, &s::M_R_FRICTION),
    ("resistance_sum", None, &s::M_R_SUM),
    ("resistance_force", None, &s::F_R),
    ("motor_power", None, &s::P_M),
    ("brake_torque", None, &s::T_K),
];

/// What given quantities are for that no formula has.
pub const USES: [Purpose; 3] = [
    ("case_bodies", listed!(s: J_S, A_W, C_W, S_W, CHI_W)),
    ("case_pins", listed!(s: MU_P, R_P)),
    engine::USE,
];

//! What the book tells of strength.

use crate::component::outline::Explained::Stage;
use crate::component::outline::{Greatest, Limit, Line, Most, SectionOutline};
use crate::drive::symbols::{H_D, L_D};
use crate::kernel::symbol::{Symbol, listed};
use crate::luffing::resistances::symbols::F_R;
use crate::luffing::strength::symbols as s;

/// What is worked out: id of the words, the result that is greatest there, the formulas, and what they take from elsewhere.
pub type WorkedOutline = (
    &'static str,
    &'static Symbol,
    &'static [SectionOutline],
    &'static [&'static Symbol],
);

pub const WORKED: [WorkedOutline; 6] = [
    (
        "worked_buckling",
        &s::U_K,
        &[("strength_buckling", &[Stage("slender"), Stage("buckled")])],
        &[&L_D, &F_R],
    ),
    (
        "worked_teeth",
        &s::SIGMA_F,
        &[("strength_teeth", &[Stage("mesh"), Stage("toothed")])],
        &[&F_R],
    ),
    (
        "worked_nut",
        &s::SIGMA_V,
        &[("strength_nut", &[Stage("core"), Stage("threaded")])],
        &[&F_R],
    ),
    (
        "worked_cylinder",
        &s::P_C,
        &[("strength_cylinder", &[Stage("pressed")])],
        &[&F_R],
    ),
    (
        "worked_rope",
        &s::U_W,
        &[("strength_rope", &[Stage("ratios"), Stage("tensed")])],
        &[&F_R],
    ),
    ("worked_pins", &s::P_B, &[("strength_pins", &[Stage("sheared")])], &[]),
];

pub const EXTREMES: [Greatest; 11] = [
    Greatest::new(&s::LAMBDA_K_MAX, Most::Greatest, &s::LAMBDA_K),
    Greatest::new(&s::U_K_MAX, Most::Greatest, &s::U_K).with_pole(&H_D),
    Greatest::new(&s::SIGMA_F_MAX, Most::Greatest, &s::SIGMA_F).with_pole(&H_D),
    Greatest::new(&s::SIGMA_H_MAX, Most::Greatest, &s::SIGMA_H).with_pole(&H_D),
    Greatest::new(&s::P_N_MAX, Most::Greatest, &s::P_N).with_pole(&H_D),
    Greatest::new(&s::SIGMA_V_MAX, Most::Greatest, &s::SIGMA_V).with_pole(&H_D),
    Greatest::new(&s::P_C_MAX, Most::Greatest, &s::P_C).with_pole(&H_D),
    Greatest::new(&s::U_W_MAX, Most::Greatest, &s::U_W),
    Greatest::new(&s::S_W_MIN, Most::Least, &s::S_W),
    Greatest::new(&s::P_B_MAX, Most::Greatest, &s::P_B),
    Greatest::new(&s::TAU_P_MAX, Most::Greatest, &s::TAU_P),
];

pub const SUMMARY: [&Symbol; 2] = [&s::H_TR, &s::H_SH];

pub const LIMITS: [Limit; 13] = [
    Limit::at_most("strength_slenderness", &s::LAMBDA_K_MAX),
    Limit::within("strength_buckling", &s::U_K_MAX, 1.0),
    Limit::at_most("strength_bending", &s::SIGMA_F_MAX),
    Limit::at_most("strength_contact", &s::SIGMA_H_MAX),
    Limit::at_most("strength_nut", &s::P_N_MAX),
    Limit::at_most("strength_screw", &s::SIGMA_V_MAX),
    Limit::at_most("strength_cylinder", &s::P_C_MAX),
    Limit::within("strength_rope", &s::U_W_MAX, 1.0),
    Limit::at_least("strength_slack", &s::S_W_MIN),
    Limit::at_least("strength_drum", &s::H_TR),
    Limit::at_least("strength_sheave", &s::H_SH),
    Limit::at_most("strength_pressure", &s::P_B_MAX),
    Limit::at_most("strength_shear", &s::TAU_P_MAX),
];

/// Columns of the tables over the working range.
pub const COLUMNS: &[&Symbol] = listed!(s: LAMBDA_K, U_K, SIGMA_F, SIGMA_H, P_N, SIGMA_V, P_C, S_W, U_W, P_B, TAU_P);

pub const CURVES: [Line; 4] = [
    ("strength_buckling", None, &s::U_K),
    ("strength_contact", None, &s::SIGMA_H),
    ("strength_rope", None, &s::U_W),
    ("strength_pressure", None, &s::P_B),
];

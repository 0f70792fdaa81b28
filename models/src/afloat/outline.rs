//! What the book tells of a floating crane, in its order.

use crate::afloat::symbols as s;
use crate::component::outline::Explained::Stage;
use crate::component::outline::{Greatest, Limit, Most, Outline, SectionOutline, chapters};
use crate::kernel::symbol::listed;
use crate::luffing::aboard::{THETA_A, THETA_E};
use crate::luffing::kinds::GIVEN;

/// Levers at heels, of which the book tells one with its formulas and all in a table.
pub const LEVERS: &[SectionOutline] = &[("afloat_levers", &[Stage("levers")])];

/// What a further load case comes to, of which the book tells one with its formulas and all in a table.
pub const CASES: &[SectionOutline] = &[("afloat_cases", &[Stage("outcomes")])];

/// The section of openings, which are all in its table.
pub const OPENINGS: &str = "afloat_openings";

pub const OUTLINE: Outline = Outline {
    inputs: chapters!(
        afloat_hull "", afloat_sections "sections", afloat_masses "masses", afloat_tanks "tanks", load "Q", load "R",
        afloat_crane "pedestal", afloat_turning "turning", carried_luffing "luffing", carried_weights "luffing.weights",
        carried_balance "luffing.balance", carried_inertias "luffing.dynamics", carried_range "luffing.motion", afloat_wind "wind", afloat_areas "wind.areas", afloat_openings "openings", afloat_tow "tow", afloat_flooded "flooded", afloat_loss "loss", afloat_gust "gust",
        afloat_cases "load_cases",
        afloat_dynamics "dynamics", afloat_start, motion, limits
    ),
    constants: &[("afloat_weights", &[Stage("dead")])],
    sections: &[
        (
            "carried_luffing",
            &[Stage("luffed"), Stage("luffed_rates"), Stage("hung")],
        ),
        ("afloat_turning", &[Stage("crane")]),
        ("afloat_load", &[Stage("loaded")]),
        ("afloat_upright", &[Stage("upright")]),
        ("afloat_small", &[Stage("small")]),
        ("afloat_posture", &[Stage("posture")]),
        ("afloat_holding", &[Stage("holding")]),
        (OPENINGS, &[Stage("flooding")]),
        ("afloat_residual", &[Stage("residual")]),
        ("afloat_lost", &[Stage("lost")]),
        ("afloat_gust", &[Stage("struck")]),
        ("afloat_riding", &[Stage("riding"), Stage("wetted"), Stage("clear")]),
        ("afloat_forces", &[Stage("forces")]),
        ("afloat_head", &[Stage("head")]),
        ("afloat_swaying", &[Stage("luffs"), Stage("swaying")]),
        ("afloat_drives", &[Stage("drives")]),
    ],
    table: listed!(s: PHI, THETA, T, F_LOW, PHI_M, THETA_M, PHI_2, PHI_DYN, M_SL0, M_10),
    curves: &[
        ("afloat_heel", None, &s::PHI),
        ("afloat_trim", None, &s::THETA),
        ("afloat_freeboard", None, &s::F_LOW),
    ],
    extremes: &[
        Greatest::new(&s::PHI_MAX, Most::Amount, &s::PHI),
        Greatest::new(&s::THETA_MAX, Most::Amount, &s::THETA),
        Greatest::new(&s::BETA_MAX, Most::Greatest, &s::BETA),
        Greatest::new(&s::F_MIN, Most::Least, &s::F_LOW),
        Greatest::new(&s::F_O_MIN, Most::Least, &s::F_O),
        Greatest::new(&s::PHI_O_MIN, Most::Least, &s::PHI_O),
        Greatest::new(&s::A_RES_MIN, Most::Least, &s::A_RES),
        Greatest::new(&s::PHI_2_MAX, Most::Amount, &s::PHI_2),
        Greatest::new(&s::D_A_MIN, Most::Least, &s::D_A),
        Greatest::new(&s::PHI_DYN_MAX, Most::Amount, &s::PHI_DYN),
        Greatest::new(&s::K_C_MIN, Most::Least, &s::K_C),
        Greatest::new(&s::GM_MIN, Most::Least, &s::GM),
        Greatest::new(&s::U_MAX, Most::Greatest, &s::U_K),
    ],
    summary: listed!(s: GM),
    sensitivity: listed!(s: PHI_MAX, F_MIN, D_A_MIN),
    limits: &[
        Limit::at_most("afloat_heel", &s::PHI_MAX),
        Limit::at_most("afloat_trim", &s::THETA_MAX),
        Limit::at_least("afloat_freeboard", &s::F_MIN),
        Limit::at_least("afloat_openings", &s::F_O_MIN),
        Limit::at_least("afloat_flooding", &s::PHI_O_MIN),
        Limit::at_least("afloat_residual", &s::A_RES_MIN),
        Limit::at_most("afloat_roll", &s::PHI_2_MAX),
        Limit::not_negative("afloat_lost", &s::D_A_MIN),
        Limit::at_most("afloat_dynamic", &s::PHI_DYN_MAX),
        Limit::at_least("afloat_capsizing", &s::K_C_MIN),
        Limit::at_least("afloat_metacentric", &s::GM_MIN),
        Limit::within("afloat_cases", &s::U_MAX, 1.0),
    ],
    uses: &[
        ("afloat_shape", listed!(s: L, B, D, X_H)),
        ("afloat_tank", listed!(s: D_T)),
        ("afloat_compartment", listed!(s: MU_F, L_F, B_F, D_F, X_F, Y_F, Z_F)),
        ("afloat_areas", listed!(s: PHI_F)),
        (
            "afloat_cases",
            listed!(s: Q_K, R_K, THETA_1K, PSI_K, P_WK, CHI_WK, P_GK, F_PK, CHI_P, Z_P, Z_LP),
        ),
        ("afloat_rolled", listed!(s: PHI_A)),
        ("afloat_told", listed!(s: PHI_H)),
        ("hook", &[&s::L_R]),
        ("start", listed!(s: PSI_SL, THETA_1)),
        ("carried_range", &[&THETA_A, &THETA_E]),
        ("carried_bars", GIVEN),
        ("afloat_inertia", listed!(s: X_U, Y_U, Z_U, J_X, J_Y)),
    ],
    forces: listed!(s: M_L, M_T, M_SL0, M_10),
    worst: &[("greatest_heel", &s::PHI_MAX), ("greatest_trim", &s::THETA_MAX)],
};

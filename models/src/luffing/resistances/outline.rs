//! What the book tells of the cases.

use crate::component::outline::Explained::Stage;
use crate::component::outline::{Greatest, Line, Most, Purpose, SectionOutline};
use crate::drive::symbols::H_D;
use crate::kernel::symbol::{Symbol, listed};
use crate::luffing::resistances::symbols as s;

/// Worked out where most is asked, for the case in which it is.
pub const SECTIONS: &[SectionOutline] = &[
    ("resistances_own", &[Stage("sums")]),
    ("resistances_case", &[Stage("resisted")]),
    ("resistances_sum", &[Stage("rubbed"), Stage("force")]),
];

pub const EXTREMES: [Greatest; 10] = [
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
];

/// Columns of the tables over the working range.
pub const COLUMNS: &[&Symbol] = listed!(s:
    M_R_OWN, M_R_LOAD, M_R_SWAY, M_R_WIND, M_R_CENTRIFUGAL, M_R_INERTIA, M_R_SLOPE, M_R_FRICTION, M_R_SUM, F_R
);

pub const CURVES: &[Line] = &[
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
];

/// What given quantities are for that no formula has.
pub const USES: [Purpose; 2] = [
    ("case_bodies", listed!(s: J_S, A_W, C_W, S_W, CHI_W)),
    ("case_pins", listed!(s: MU_P, R_P)),
];

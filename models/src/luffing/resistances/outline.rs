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
    Greatest::new(&s::M_OWN_MAX, Most::Amount, &s::M_OWN),
    Greatest::new(&s::M_LOAD_MAX, Most::Amount, &s::M_LOAD),
    Greatest::new(&s::M_SWAY_MAX, Most::Amount, &s::M_SWAY),
    Greatest::new(&s::M_WIND_MAX, Most::Amount, &s::M_WIND),
    Greatest::new(&s::M_CENTRIFUGAL_MAX, Most::Amount, &s::M_CENTRIFUGAL),
    Greatest::new(&s::M_INERTIA_MAX, Most::Amount, &s::M_INERTIA),
    Greatest::new(&s::M_SLOPE_MAX, Most::Amount, &s::M_SLOPE),
    Greatest::new(&s::M_FRICTION_MAX, Most::Amount, &s::M_FRICTION),
    Greatest::new(&s::M_SUM_MAX, Most::Amount, &s::M_SUM),
    Greatest::new(&s::F_R_MAX, Most::Amount, &s::F_R).with_pole(&H_D),
];

/// Columns of the tables over the working range.
pub const COLUMNS: &[&Symbol] = listed!(s:
    M_OWN, M_LOAD, M_SWAY, M_WIND, M_CENTRIFUGAL, M_INERTIA, M_SLOPE, M_FRICTION, M_SUM, F_R
);

pub const CURVES: &[Line] = &[
    ("resistance_own", None, &s::M_OWN),
    ("resistance_load", None, &s::M_LOAD),
    ("resistance_sway", None, &s::M_SWAY),
    ("resistance_wind", None, &s::M_WIND),
    ("resistance_centrifugal", None, &s::M_CENTRIFUGAL),
    ("resistance_inertia", None, &s::M_INERTIA),
    ("resistance_slope", None, &s::M_SLOPE),
    ("resistance_friction", None, &s::M_FRICTION),
    ("resistance_sum", None, &s::M_SUM),
    ("resistance_force", None, &s::F_R),
];

/// What given quantities are for that no formula has.
pub const USES: [Purpose; 2] = [
    ("case_bodies", listed!(s: J_S, A_W, C_W, S_W, CHI_W)),
    ("case_pins", listed!(s: MU_P, R_P)),
];

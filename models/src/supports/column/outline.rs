//! What the book tells of a column, in its order.

use crate::component::outline::Explained::Stage;
use crate::component::outline::{Greatest, Limit, Line, Most, Outline, SectionOutline, chapters, joined};
use crate::kernel::symbol::listed;
use crate::luffing::aboard::{OMEGA_1, THETA_1, THETA_A, THETA_E};
use crate::luffing::kinds::GIVEN;
use crate::parts::starts::engine;
use crate::supports::column::symbols as s;
use crate::supports::drive::moving;
use crate::supports::drive::outline as drive;
use crate::supports::drive::symbols as d;
use crate::supports::upper::symbols as u;

pub const OUTLINE: Outline = Outline {
    inputs: chapters!(
        column "", load "Q", load "R", upper_bodies "upper",
        carried_luffing "luffing", carried_weights "luffing.weights", carried_balance "luffing.balance", carried_inertias "luffing.dynamics", carried_range "luffing.motion",
        upper_slope "slope", upper_areas "areas",
        upper_cases "load_cases", column_bearings "bearings", column_friction "friction",
        column_counterweight "counterweight", turning_drive "slewing_drive", turning_stages "slewing_drive.stages", case_start "slewing_drive.start", case_curve "slewing_drive.start.curve", turning_brake "slewing_drive.brake", turning_coupling "slewing_drive.coupling", turning_pinion "slewing_drive.pinion",
        slewing, air "slewing.air", motion, limits
    ),
    constants: &CONSTANTS,
    sections: &SECTIONS,
    table: listed!(s: M_ALL, H_U_ALL, H_F_ALL),
    curves: &CURVES,
    extremes: &EXTREMES,
    summary: &drive::SUMMARY,
    sensitivity: listed!(s: H_U_TOP, H_F_TOP, M_FB_MAX),
    limits: &LIMITS,
    uses: &[
        ("upper_heights", listed!(u: H_U, H_1)),
        ("carried_range", &[&THETA_A, &THETA_E, &OMEGA_1]),
        ("carried_angle", &[&THETA_1]),
        ("carried_bars", GIVEN),
        ("upper_cases", listed!(u: K_Q, P_W, CHI_W)),
        ("upper_cases", listed!(d: N_S, ALPHA_Q, K_B)),
        engine::USE,
        moving::USES[0],
        moving::USES[1],
        moving::USES[2],
    ],
    forces: listed!(s: V, H, M, H_U, H_F),
    worst: &[("greatest_bearing_force", &s::H_U_TOP)],
};

const CONSTANTS: [SectionOutline; 7] = joined(OWN_CONSTANTS, drive::CONSTANTS);

const OWN_CONSTANTS: [SectionOutline; 4] = [
    ("carried_luffing", &[Stage("luffed"), Stage("spun")]),
    ("upper_weights", &[Stage("upper")]),
    ("column_counterweight", &[Stage("evened")]),
    ("column_pivot", &[Stage("pivot")]),
];

const SECTIONS: [SectionOutline; 13] = joined(OWN_SECTIONS, drive::SECTIONS);

const OWN_SECTIONS: [SectionOutline; 4] = [
    ("upper_loads", &[Stage("loads")]),
    ("column_forces", &[Stage("forces")]),
    ("column_pressure", &[Stage("pressures")]),
    ("column_friction", &[Stage("turning")]),
];

const CURVES: [Line; 7] = joined(OWN_CURVES, drive::CURVES);

const OWN_CURVES: [Line; 4] = [
    ("upper_moment", None, &s::M),
    ("upper_horizontal", None, &s::H),
    ("column_upper", None, &s::H_U),
    ("column_foot", None, &s::H_F),
];

const EXTREMES: [Greatest; 31] = joined(OWN_EXTREMES, drive::EXTREMES);

const OWN_EXTREMES: [Greatest; 9] = [
    Greatest::new(&s::V_TOP, Most::Greatest, &s::V),
    Greatest::new(&s::H_TOP, Most::Greatest, &s::H),
    Greatest::new(&s::M_TOP, Most::Greatest, &s::M),
    Greatest::new(&s::H_U_TOP, Most::Greatest, &s::H_U),
    Greatest::new(&s::H_F_TOP, Most::Greatest, &s::H_F),
    Greatest::new(&s::P_U_MAX, Most::Greatest, &s::P_U),
    Greatest::new(&s::P_F_MAX, Most::Greatest, &s::P_F),
    Greatest::new(&s::P_P_MAX, Most::Greatest, &s::P_P),
    Greatest::new(&s::M_FB_MAX, Most::Greatest, &s::M_FB),
];

const LIMITS: [Limit; 20] = joined(OWN_LIMITS, drive::LIMITS);

const OWN_LIMITS: [Limit; 5] = [
    Limit::at_most("column_upper", &s::H_U_TOP),
    Limit::at_most("column_foot", &s::H_F_TOP),
    Limit::at_most("column_upper_pressure", &s::P_U_MAX),
    Limit::at_most("column_foot_pressure", &s::P_F_MAX),
    Limit::at_most("column_pivot_pressure", &s::P_P_MAX),
];

//! What the book tells of a slewing ring, in its order.

use crate::component::outline::Explained::Stage;
use crate::component::outline::{Greatest, Limit, Line, Most, Outline, SectionOutline, chapters, joined};
use crate::kernel::symbol::listed;
use crate::luffing::aboard::{OMEGA_1, THETA_1, THETA_A, THETA_E};
use crate::luffing::kinds::GIVEN;
use crate::parts::starts::engine;
use crate::supports::drive::moving;
use crate::supports::drive::outline as drive;
use crate::supports::drive::symbols as d;
use crate::supports::ring::symbols as s;
use crate::supports::upper::symbols as u;

pub const OUTLINE: Outline = Outline {
    inputs: chapters!(
        ring_raceway "", load "Q", load "R", upper_bodies "upper",
        carried_luffing "luffing", carried_weights "luffing.weights", carried_balance "luffing.balance", carried_inertias "luffing.dynamics", carried_range "luffing.motion",
        upper_slope "slope", upper_areas "areas",
        upper_cases "load_cases", ring_contact "contact", ring_capacity "capacity", ring_curve "capacity.curve",
        ring_friction "friction", ring_maker "maker_friction", ring_bolts "bolts", ring_life "life", turning_drive "slewing_drive", turning_stages "slewing_drive.stages", case_start "slewing_drive.start", case_curve "slewing_drive.start.curve", turning_brake "slewing_drive.brake", turning_coupling "slewing_drive.coupling", turning_pinion "slewing_drive.pinion",
        slewing, air "slewing.air", motion, limits
    ),
    constants: &CONSTANTS,
    sections: &SECTIONS,
    table: listed!(s: M_ALL, H_ALL, P_ALL),
    curves: &CURVES,
    extremes: &EXTREMES,
    summary: &drive::SUMMARY,
    sensitivity: listed!(s: P_TOP, U_ST_MAX, M_TOP),
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
        ("ring_curve", listed!(s: F_CURVE, M_CURVE)),
    ],
    forces: listed!(s: V, H, M, P_MAX, P_MIN),
    worst: &[("greatest_rolling_force", &s::P_TOP)],
};

const CONSTANTS: [SectionOutline; 7] = joined(OWN_CONSTANTS, drive::CONSTANTS);

const OWN_CONSTANTS: [SectionOutline; 4] = [
    ("carried_luffing", &[Stage("luffed"), Stage("spun")]),
    ("upper_weights", &[Stage("upper")]),
    ("ring_alone", &[Stage("alone")]),
    ("ring_hardness", &[Stage("hardness")]),
];

const SECTIONS: [SectionOutline; 16] = joined(OWN_SECTIONS, drive::SECTIONS);

const OWN_SECTIONS: [SectionOutline; 7] = [
    ("upper_loads", &[Stage("loads")]),
    ("ring_elements", &[Stage("spreads")]),
    ("ring_contact", &[Stage("stresses")]),
    ("ring_static", &[Stage("statics")]),
    ("ring_friction", &[Stage("turning"), Stage("makers")]),
    ("ring_bolts", &[Stage("bolted")]),
    ("ring_life", &[Stage("lives")]),
];

const CURVES: [Line; 8] = joined(OWN_CURVES, drive::CURVES);

const OWN_CURVES: [Line; 5] = [
    ("upper_moment", None, &s::M),
    ("upper_horizontal", None, &s::H),
    ("upper_vertical", None, &s::V),
    ("ring_greatest", None, &s::P_MAX),
    ("ring_least", None, &s::P_MIN),
];

const EXTREMES: [Greatest; 38] = joined(OWN_EXTREMES, drive::EXTREMES);

const OWN_EXTREMES: [Greatest; 16] = [
    Greatest::new(&s::V_TOP, Most::Greatest, &s::V),
    Greatest::new(&s::H_TOP, Most::Greatest, &s::H),
    Greatest::new(&s::M_TOP, Most::Greatest, &s::M),
    Greatest::new(&s::P_TOP, Most::Greatest, &s::P_MAX),
    Greatest::new(&s::P_LOW, Most::Least, &s::P_MIN),
    Greatest::new(&s::Q_LOW, Most::Least, &s::Q_FAR),
    Greatest::new(&s::U_H_MAX, Most::Greatest, &s::U_H),
    Greatest::new(&s::U_ST_MAX, Most::Greatest, &s::U_ST),
    Greatest::new(&s::S_0_MIN, Most::Least, &s::S_0),
    Greatest::new(&s::M_FN_MAX, Most::Greatest, &s::M_FN),
    Greatest::new(&s::M_FM_MAX, Most::Greatest, &s::M_FM),
    Greatest::new(&s::F_B_MAX, Most::Greatest, &s::F_B),
    Greatest::new(&s::S_B_MIN, Most::Least, &s::S_B),
    Greatest::new(&s::F_K_MIN, Most::Least, &s::F_K),
    Greatest::new(&s::S_H_MIN, Most::Least, &s::S_H),
    Greatest::new(&s::L_10_MIN, Most::Least, &s::L_10),
];

const LIMITS: [Limit; 24] = joined(OWN_LIMITS, drive::LIMITS);

const OWN_LIMITS: [Limit; 9] = [
    Limit::at_most("ring_force", &s::P_TOP),
    Limit::at_least("ring_uplift", &s::Q_LOW),
    Limit::at_most("ring_contact", &s::U_H_MAX),
    Limit::at_most("ring_use", &s::U_ST_MAX),
    Limit::at_least("ring_safety", &s::S_0_MIN),
    Limit::at_least("ring_bolts", &s::S_B_MIN),
    Limit::not_negative("ring_joint", &s::F_K_MIN),
    Limit::at_least("ring_slip", &s::S_H_MIN),
    Limit::at_least("ring_life", &s::L_10_MIN),
];

//! What the book tells of a column, in its order.

use crate::component::outline::Explained::Stage;
use crate::component::outline::{Greatest, Limit, Most, Outline, chapters};
use crate::kernel::symbol::listed;
use crate::supports::column::symbols as s;
use crate::supports::upper::symbols as u;

pub const OUTLINE: Outline = Outline {
    inputs: chapters!(
        column "", load "Q", load "R", upper_bodies "upper", upper_slope "slope", upper_areas "areas",
        upper_cases "load_cases", column_bearings "bearings", column_friction "friction",
        column_counterweight "counterweight", motion, limits
    ),
    constants: &[
        ("upper_weights", &[Stage("upper")]),
        ("column_counterweight", &[Stage("evened")]),
        ("column_pivot", &[Stage("pivot")]),
    ],
    sections: &[
        ("upper_loads", &[Stage("loads")]),
        ("column_forces", &[Stage("forces")]),
        ("column_pressure", &[Stage("pressures")]),
        ("column_friction", &[Stage("turning")]),
    ],
    table: listed!(s: M_ALL, H_U_ALL, H_F_ALL),
    curves: &[
        ("upper_moment", None, &s::M),
        ("upper_horizontal", None, &s::H),
        ("column_upper", None, &s::H_U),
        ("column_foot", None, &s::H_F),
    ],
    extremes: &[
        Greatest::new(&s::V_TOP, Most::Greatest, &s::V),
        Greatest::new(&s::H_TOP, Most::Greatest, &s::H),
        Greatest::new(&s::M_TOP, Most::Greatest, &s::M),
        Greatest::new(&s::H_U_TOP, Most::Greatest, &s::H_U),
        Greatest::new(&s::H_F_TOP, Most::Greatest, &s::H_F),
        Greatest::new(&s::P_U_MAX, Most::Greatest, &s::P_U),
        Greatest::new(&s::P_F_MAX, Most::Greatest, &s::P_F),
        Greatest::new(&s::P_P_MAX, Most::Greatest, &s::P_P),
        Greatest::new(&s::M_FB_MAX, Most::Greatest, &s::M_FB),
    ],
    summary: &[],
    sensitivity: listed!(s: H_U_TOP, H_F_TOP, M_FB_MAX),
    limits: &[
        Limit::at_most("column_upper", &s::H_U_TOP),
        Limit::at_most("column_foot", &s::H_F_TOP),
        Limit::at_most("column_upper_pressure", &s::P_U_MAX),
        Limit::at_most("column_foot_pressure", &s::P_F_MAX),
        Limit::at_most("column_pivot_pressure", &s::P_P_MAX),
    ],
    uses: &[
        ("upper_heights", listed!(u: H_U)),
        ("upper_cases", listed!(u: K_Q, P_W, CHI_W)),
    ],
    forces: listed!(s: V, H, M, H_U, H_F),
    worst: &[("greatest_bearing_force", &s::H_U_TOP)],
};

//! What the book tells of a mobile crane, in its order.

use crate::component::outline::Explained::Stage;
use crate::component::outline::{Bound, Greatest, Limit, Most, Outline, chapters};
use crate::kernel::symbol::listed;
use crate::supports::mobile::symbols as s;

pub const OUTLINE: Outline = Outline {
    inputs: chapters!(
        mobile_place "", mobile_points "points", mobile_carrier "carrier", mobile_upper "upper", mobile_boom "boom",
        mobile_parts "boom.parts", load "Q", load "G_h", load "phi_Q", slope, mobile_wind "wind", mobile_rating "rating", mobile_chart "chart", motion, limits
    ),
    constants: &[
        ("mobile_boom", &[Stage("pose"), Stage("boom")]),
        ("mobile_weights", &[Stage("dead"), Stage("leaning")]),
        ("mobile_payload", &[Stage("payload")]),
    ],
    sections: &[
        ("mobile_tipping", &[Stage("tipping"), Stage("behind")]),
        ("mobile_support", &[Stage("bearable")]),
        ("mobile_rated", &[Stage("rated"), Stage("utilised")]),
        ("mobile_ground", &[Stage("ground")]),
        (
            "mobile_forces",
            &[Stage("springs"), Stage("forces"), Stage("pressures")],
        ),
    ],
    table: listed!(s: P, Q_ST, Q_RAT, Q_NET, ETA, S_BACK, A, N_I_MAX),
    curves: &[
        ("mobile_tipping", None, &s::P),
        ("mobile_rated", None, &s::Q_RAT),
        ("mobile_utilisation", None, &s::ETA),
        ("mobile_forces", None, &s::N),
    ],
    extremes: &[
        Greatest::new(&s::P_MIN, Most::Least, &s::P),
        Greatest::new(&s::ETA_MAX, Most::Greatest, &s::ETA),
        Greatest::new(&s::A_MIN, Most::Least, &s::A),
        Greatest::new(&s::S_BACK_MIN, Most::Least, &s::S_BACK),
        Greatest::new(&s::N_I_MAX, Most::Greatest, &s::N),
        Greatest::new(&s::P_G_MAX, Most::Greatest, &s::P_G),
    ],
    summary: &[],
    sensitivity: listed!(s: P_MIN, ETA_MAX, N_I_MAX),
    limits: &[
        Limit {
            id: "mobile_utilisation",
            symbol: &s::ETA_MAX,
            at_most: true,
            bound: Bound::Fixed(1.0),
        },
        Limit::at_most("mobile_force", &s::N_I_MAX),
        Limit::at_most("mobile_pressure", &s::P_G_MAX),
    ],
    uses: &[
        ("mobile_chart", listed!(s: R_FROM, R_TO, R_STEP)),
        ("mobile_indicator", listed!(s: K_W)),
        ("mobile_permission", listed!(s: S_LIM)),
        ("mobile_angles", listed!(s: PHI_MIN, PHI_MAX)),
    ],
    forces: listed!(s: N, P_G, V),
    worst: &[("greatest_utilisation", &s::ETA_MAX)],
};

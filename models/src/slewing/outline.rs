//! What the book tells of slewing, in its order.

use crate::component::outline::Explained::Stage;
use crate::component::outline::{Greatest, Limit, Most, Outline, chapters};
use crate::kernel::symbol::listed;
use crate::parts::{turntable, turntable_control};
use crate::slewing::symbols as s;

pub const OUTLINE: Outline = Outline {
    inputs: chapters!(slewing "", slope, load "Q", hook, air, control, coupling, motion, limits),
    constants: &[
        ("slewing_inertia", &[Stage("carried"), Stage("total")]),
        ("slewing_regulated", &[Stage("regulated")]),
    ],
    sections: &[
        ("slewing_slope", &[Stage("tilt")]),
        ("slewing_wind", &[Stage("wind")]),
        ("slewing_steady", &[Stage("steady")]),
        ("slewing_circle", &[Stage("circling")]),
        ("slewing_control", &[Stage("sampled")]),
        ("slewing_regulation", &[Stage("regulation")]),
        ("motion_air", &[Stage("stream")]),
        ("slewing_swing", &[Stage("leaning"), Stage("swinging")]),
        ("slewing_motion", &[Stage("resisting"), Stage("turned")]),
        ("slewing_coupling", &[Stage("passing"), Stage("coupled")]),
        ("slewing_winding", &[Stage("winding")]),
    ],
    table: listed!(s: M_GAMMA, M_WS, M_ST, P_ST, F_N, M_R_SL, D_OMEGA_SL, F_T, S_R),
    curves: &[
        ("slewing_slope", None, &s::M_GAMMA),
        ("slewing_wind", None, &s::M_WS),
        ("slewing_steady", None, &s::M_ST),
        ("slewing_acceleration", None, &s::D_OMEGA_SL),
    ],
    extremes: &[
        Greatest::new(&s::M_GAMMA_MAX, Most::Amount, &s::M_GAMMA),
        Greatest::new(&s::M_WS_MAX, Most::Amount, &s::M_WS),
        Greatest::new(&s::M_ST_MAX, Most::Amount, &s::M_ST),
        Greatest::new(&s::P_ST_MAX, Most::Amount, &s::P_ST),
    ],
    summary: &[],
    sensitivity: &[&s::M_ST_MAX, &s::P_ST_MAX],
    limits: &[
        Limit::at_most("slewing_moment", &s::M_ST_MAX),
        Limit::at_most("slewing_power", &s::P_ST_MAX),
    ],
    uses: &[
        ("stops", listed!(turntable: PSI_MIN, PSI_MAX)),
        (
            "control",
            listed!(turntable_control: K_I_SL, A_SL, M_MAX_SL, T_C_SL, OMEGA_S_SL, OMEGA_MAX_SL, K_PSI_SL),
        ),
        ("start", &[&s::PSI_SL]),
        ("hook", &[&s::L_R, &s::PHI_R, &s::CHI_R]),
    ],
    forces: listed!(s: M_ST, F_N, F_T, S_R),
    worst: &[("greatest_moment", &s::M_ST_MAX)],
};

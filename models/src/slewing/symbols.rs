//! Every quantity of slewing by itself, besides those of its joint.

use crate::component::description::Vocabulary;
pub use crate::kernel::gravity::G;
use crate::kernel::symbol::symbols;
pub use crate::parts::air::{CHI_AIR, F_AIR, P_AIR, RHO_AIR, V_AIR};
pub use crate::parts::hanging::{
    ALPHA_0SL, D_V_QX, D_V_QY, D_V_QZ, D_X_Q, D_Y_Q, D_Z_Q, L_R, PHI_R, S_R, V_QX, V_QY, V_QZ, X_Q, Y_Q, Z_Q, Z_ROPE,
};
pub use crate::parts::side_wind::{A_WS, M_WS, P_WS, R_WS};
use crate::parts::slip;
pub use crate::parts::slip::{
    D_OMEGA_D, D_PSI_SLIP, E_D, J_D, M_CD, M_LIM, M_RD, OMEGA_D, P_SLIP, PSI_SLIP, SLIP, W_SLIP, WAY_D, Z_C_LOOSE,
    Z_C_REST, Z_D_LOOSE, Z_D_REST,
};
pub use crate::parts::slope::{G_U, GAMMA_S, M_GAMMA, R_U};
pub use crate::parts::turntable::{
    CHI_R, D_OMEGA_SL, D_PSI_SL, J_SL, M_B_SL, M_R_SL, M_SL, OMEGA_SL, PSI_SL, Z_SL_HIGH, Z_SL_LOOSE, Z_SL_LOW,
    Z_SL_REST,
};
pub use crate::parts::turntable_control::{
    D_EPSILON_SL, D_OMEGA_R_SL, E_R_SL, M_A_SL, M_I_SL, OMEGA_0_SL, OMEGA_C_SL, OMEGA_S_SL, PSI_C_SL, Z_SL_LIMIT,
    Z_SL_RAMP, Z_SL_WIND, ZETA_SL,
};

symbols! {
    // Given.
    FROM: "from" "psi_a" RAD / DEG, "Slewing angle at the start of the working range.", "input";
    TO: "to" "psi_e" RAD / DEG, "Slewing angle at the end of the working range.", "input";
    R: "R" "R" M / M [not_negative], "Reach: distance of the load from the slewing axis.", "input";
    Q: "Q" "Q" N / KN [not_negative], "Weight of the load on its hook.", "input";
    STEP: "step" "h" S / MS [positive], "Longest step of the solver.", "input";

    // Results at any angle.
    MASS_Q: "mass_Q" "m_Q" KG / T [not_negative], "Mass of the load: weight over g.", "derived";
    J_Q: "J_Q" "J_Q" KG_M2 / T_M2 [not_negative], "Inertia of the load about the slewing axis.", "derived";
    J_TOT: "J_tot" "J_\"tot\"" KG_M2 / T_M2 [not_negative], "Inertia of all that slews about the slewing axis, with the load.", "[Ports001, 6.5]";
    M_ST: "M_st" "M_\"st\"" N_M / KN_M, "Moment that the drive must give to slew steadily counter-clockwise.", "[Ports001, 6.4]";
    P_ST: "P_st" "P_\"st\"" W / KW, "Power of the drive while the crane slews steadily; negative where slope or wind drives it.", "derived";
    F_N: "F_n" "F_n" N / KN [not_negative], "Horizontal force towards the axis that keeps the load on its circle.", "Newton and Euler";
    E_SL: "E_sl" "E_\"sl\"" J / KJ [not_negative], "Kinetic energy of slewing.", "Newton and Euler";

    // Results in motion.
    F_T: "F_t" "F_t" N / KN, "Horizontal force along its circle that accelerates the load; positive counter-clockwise.", "Newton and Euler";
    M_GAMMA_U: "M_gammau" "M_(gamma \"u\")" N_M / KN_M, "Moment on the slope of all that slews without the load, about the slewing axis; positive counter-clockwise.", "virtual work";
    W_BLOW: "W_blow" "W_\"blow\"" J / KJ [not_negative], "Energy that blows have taken.", "Newton and Euler";
    SLACK: "slack" "sigma" ONE / ONE, "Whether the rope hangs slack (1) or is taut (0).", "state";
    WAY: "way" "w" ONE / ONE, "Whether slewing rests (0), or which way it turns (1, -1).", "state";

    // The whole range.
    M_GAMMA_MAX: "M_gamma_max" "M_(gamma,max)" N_M / KN_M, "Greatest moment of the slope in the working range, by amount.", "derived";
    M_WS_MAX: "M_ws_max" "M_(\"ws\",max)" N_M / KN_M, "Greatest moment of the wind in the working range, by amount.", "derived";
    M_ST_MAX: "M_st_max" "M_(\"st\",max)" N_M / KN_M, "Greatest moment of steady slewing in the working range, by amount.", "derived";
    P_ST_MAX: "P_st_max" "P_(\"st\",max)" W / KW, "Greatest power of steady slewing in the working range, by amount.", "derived";
    AGREEMENT: "agreement" "delta" ONE / ONE, "Difference of two independent ways, relative to the largest value.", "derived";
}

/// Words for what a coupling has that slips.
pub static SLIPPING: Vocabulary = Vocabulary {
    words: "slip_symbol",
    own: &[slip::ALL],
    shared: &[],
};

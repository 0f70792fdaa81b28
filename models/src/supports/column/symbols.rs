//! Quantities of a column besides those of what slews on it.

use crate::kernel::symbol::symbols;
pub use crate::supports::drive::symbols::{J_D, M_FS, M_FS0, M_LC, RHO_C};
pub use crate::supports::upper::symbols::{
    AGREEMENT, H, H_1, H_L, H_T, H_TOP, M, M_ALL, M_L, M_T, M_TOP, OMEGA, PSI, Q, R, THETA_1, V, V_TOP,
};

symbols! {
    // Given.
    H_UF: "h_uf" "h_\"uf\"" M / M [positive], "Distance of the bearings along the column: the foot bearing lies this far below the upper one.", "input";
    D_U: "D_u" "D_\"u\"" M / MM [positive], "Diameter of the upper bearing.", "input";
    B_U: "b_u" "b_\"u\"" M / MM [positive], "Length of the upper bearing.", "input";
    D_F: "D_f" "D_\"f\"" M / MM [positive], "Diameter of the foot bearing.", "input";
    B_F: "b_f" "b_\"f\"" M / MM [positive], "Length of the foot bearing.", "input";
    D_P: "D_p" "D_\"p\"" M / MM [positive], "Outer diameter of the pivot that bears the weight.", "input";
    D_I: "d_i" "d_\"i\"" M / MM [not_negative], "Inner diameter of the pivot; zero where it is full.", "input";
    MU_U: "mu_u" "mu_\"u\"" ONE / ONE [not_negative, unconfirmed], "Friction coefficient of the upper bearing.", "input";
    MU_F: "mu_f" "mu_\"f\"" ONE / ONE [not_negative, unconfirmed], "Friction coefficient of the foot bearing.", "input";
    MU_P: "mu_p" "mu_\"p\"" ONE / ONE [not_negative, unconfirmed], "Friction coefficient of the pivot.", "input";
    R_D: "r_d" "r_d" M / M [positive], "Distance behind the slewing axis at which the balancing counterweight would lie.", "input";

    // Bearings in a case.
    H_UL: "H_ul" "H_(\"ul\" i)" N / KN, "Part of the force on the upper bearing along the boom; positive forward.", "equilibrium";
    H_UT: "H_ut" "H_(\"ut\" i)" N / KN, "Part of the force on the upper bearing across the boom; positive to the left.", "equilibrium";
    H_U: "H_u" "H_(\"u\" i)" N / KN [not_negative], "Force on the upper bearing, square to the column.", "[Ports001, 6.3.2]";
    H_F: "H_f" "H_(\"f\" i)" N / KN [not_negative], "Force on the foot bearing, square to the column, against the direction of the moment.", "[Ports001, 6.3.2]";
    H_U_ALL: "H_u_all" "H_\"u,all\"" N / KN, "Greatest force on the upper bearing of all load cases.", "derived";
    H_F_ALL: "H_f_all" "H_\"f,all\"" N / KN, "Greatest force on the foot bearing of all load cases.", "derived";

    // Friction, pressure.
    R_P: "R_p" "R_\"p\"" M / MM, "Radius at which the friction of the pivot acts, where it is pressed evenly: a third of the diameter of a full one, half of that of a thin ring.", "[Ports001, 6.3.2]";
    M_FU: "M_fu" "M_(\"fu\" i)" N_M / KN_M, "Friction moment of the upper bearing.", "[Ports001, 6.3.2]";
    M_FF: "M_ff" "M_(\"ff\" i)" N_M / KN_M, "Friction moment of the foot bearing.", "[Ports001, 6.3.2]";
    M_FP: "M_fp" "M_(\"fp\" i)" N_M / KN_M, "Friction moment of the pivot.", "[Ports001, 6.3.2]";
    M_FB: "M_fb" "M_(\"fb\" i)" N_M / KN_M, "Friction moment of the three bearings.", "[Ports001, 6.3.2]";
    P_U: "p_u" "p_(\"u\" i)" PA / MPA, "Mean pressure in the upper bearing, over diameter and length.", "derived";
    P_F: "p_f" "p_(\"f\" i)" PA / MPA, "Mean pressure in the foot bearing, over diameter and length.", "derived";
    P_P: "p_p" "p_(\"p\" i)" PA / MPA, "Mean pressure on the pivot.", "derived";

    // Counterweight.
    G_D: "G_d" "G_d" N / KN, "Weight to be added there so that the moment without load is minus that with it; negative where the upper works have too much of it.", "[Ports001, 3.2.1]";
    M_D: "M_d" "M_d" N_M / KN_M, "Moment that then remains, forward with the load and backward without it.", "[Ports001, 3.2.1]";

    // The whole range.
    H_U_TOP: "H_u_top" "H_\"u,max\"" N / KN, "Greatest force on the upper bearing in the working range.", "derived";
    H_F_TOP: "H_f_top" "H_\"f,max\"" N / KN, "Greatest force on the foot bearing in the working range.", "derived";
    M_FB_MAX: "M_fb_max" "M_\"fb,max\"" N_M / KN_M, "Greatest friction moment in the working range.", "derived";
    P_U_MAX: "p_u_max" "p_\"u,max\"" PA / MPA, "Greatest mean pressure in the upper bearing in the working range.", "derived";
    P_F_MAX: "p_f_max" "p_\"f,max\"" PA / MPA, "Greatest mean pressure in the foot bearing in the working range.", "derived";
    P_P_MAX: "p_p_max" "p_\"p,max\"" PA / MPA, "Greatest mean pressure on the pivot in the working range.", "derived";
}

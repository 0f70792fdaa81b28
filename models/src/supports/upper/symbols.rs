//! Quantities of what slews on a support, and of the forces and the moment that it brings there.

use crate::kernel::symbol::symbols;
pub use crate::luffing::aboard::{R, THETA_1};

symbols! {
    // Given.
    PSI: "psi" "psi" RAD / DEG, "Slewing angle of the boom; positive counter-clockwise, seen from above. On a slope it counts from the downhill direction.", "input";
    OMEGA: "omega" "omega" RAD_PER_S / DEG_PER_S, "Angular velocity of slewing.", "input";
    FROM: "from" "psi_a" RAD / DEG, "Slewing angle at the start of the working range.", "input";
    TO: "to" "psi_e" RAD / DEG, "Slewing angle at the end of the working range.", "input";
    Q: "Q" "Q" N / KN [not_negative], "Weight of the load with hook block or grab.", "input";
    G_U: "G_u" "G_(u i)" N / KN [not_negative], "Weight of a body of the upper works.", "input";
    R_U: "r_u" "r_(u i)" M / M, "Centre of gravity of a body of the upper works, in front of the slewing axis; negative behind it.", "input";
    H_U: "h_u" "h_(u i)" M / M, "Centre of gravity of a body of the upper works, above the slewing support.", "input";
    A_W: "A_w" "A_(\"w\" i)" M2 / M2 [not_negative], "Wind area of what slews, with its shape coefficient.", "input";
    H_W: "h_w" "h_(\"w\" i)" M / M, "Centre of a wind area, above the slewing support.", "input";
    GAMMA: "gamma" "gamma" RAD / DEG [from_to(0.0, 0.5)], "Slope on which the crane stands.", "input";
    H_1: "h_1" "h_1" M / M, "Height of the luffing mechanism's foot above the slewing support.", "input";
    H_Q: "h_Q" "h_Q" M / M, "Height above the slewing support of the point from which the load hangs.", "input";
    K_Q: "k_Q" "k_(Q i)" ONE / ONE [not_negative], "Factor by which the load counts in the case.", "input";
    P_W: "p_w" "p_(\"w\" i)" PA / PA [not_negative], "Pressure of the wind in the case.", "input";
    CHI_W: "chi_w" "chi_(\"w\" i)" RAD / DEG, "Direction to which the wind blows in the case, counted as the slewing angle.", "input";

    // What slews.
    G_0: "G_0" "G_0" N / KN, "Weight of the upper works.", "derived";
    M_U: "M_u" "M_u" N_M / KN_M, "Moment of the upper works' weight about the slewing axis; positive in the boom's direction.", "equilibrium";
    S_U: "S_u" "S_u" N_M / KN_M, "Sum of the upper works' weights with their heights above the slewing support.", "derived";
    A_SUM: "A_sum" "A_\"w\"" M2 / M2, "Sum of the wind areas.", "derived";
    S_W: "S_w" "S_\"w\"" M3 / M3, "Sum of the wind areas with their heights above the slewing support.", "derived";

    // Loads of a case.
    Q_C: "Q_c" "Q_i" N / KN, "Load as it counts in the case.", "derived";
    G_S: "G_s" "G_(s i)" N / KN, "Weight of all that slews in the case.", "derived";
    M_V: "M_v" "M_(\"v\" i)" N_M / KN_M, "Moment of the weights square to the slewing plane; positive in the boom's direction.", "equilibrium";
    M_GAMMA: "M_gamma" "M_(gamma i)" N_M / KN_M, "Moment of the weights down the slope at their heights; in the downhill direction.", "equilibrium";
    BETA_W: "beta_w" "beta_i" RAD / DEG, "Direction to which the wind blows, from that of the boom.", "derived";
    F_W: "F_w" "F_(\"w\" i)" N / KN, "Force of the wind.", "[Ports001, 6.1]";
    M_W: "M_w" "M_(\"w\" i)" N_M / KN_M, "Moment of the wind about the slewing support, in its direction.", "equilibrium";
    M_L: "M_l" "M_(\"l\" i)" N_M / KN_M, "Part of the moment along the boom; positive where it loads the slewing support in front.", "equilibrium";
    M_T: "M_t" "M_(\"t\" i)" N_M / KN_M, "Part of the moment across the boom; positive where it loads the slewing support on the left.", "equilibrium";
    H_L: "H_l" "H_(\"l\" i)" N / KN, "Part of the horizontal force along the boom; positive forward.", "equilibrium";
    H_T: "H_t" "H_(\"t\" i)" N / KN, "Part of the horizontal force across the boom; positive to the left.", "equilibrium";
    V: "V" "V_i" N / KN, "Vertical force on the slewing support: along the slewing axis.", "[Ports001, 6.1]";
    H: "H" "H_i" N / KN, "Horizontal force on the slewing support: square to the slewing axis.", "[Ports001, 6.1]";
    M: "M" "M_i" N_M / KN_M, "Overturning moment on the slewing support.", "[Ports001, 6.1]";
    M_ALL: "M_all" "M_\"all\"" N_M / KN_M, "Greatest overturning moment of all load cases.", "derived";
    H_ALL: "H_all" "H_\"all\"" N / KN, "Greatest horizontal force of all load cases.", "derived";

    // The whole range.
    V_TOP: "V_top" "V_max" N / KN, "Greatest vertical force in the working range.", "derived";
    H_TOP: "H_top" "H_max" N / KN, "Greatest horizontal force in the working range.", "derived";
    M_TOP: "M_top" "M_max" N_M / KN_M, "Greatest overturning moment in the working range.", "derived";
    AGREEMENT: "agreement" "delta" ONE / ONE, "Difference of two independent ways, relative to the largest value.", "derived";
}

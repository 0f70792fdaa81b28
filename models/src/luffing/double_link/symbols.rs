//! Every quantity of the double-link luffing mechanism.

use std::f64::consts::{FRAC_PI_2, TAU};

pub use crate::drive::symbols::{F_D, F_D_MAX, H_D, L_D, L_DX, L_DY, Q_D, R_DX, R_DY, V_D};
use crate::kernel::symbol::{Range, symbols};

symbols! {
    // Inputs and coordinates.
    THETA_1: "theta_1" "theta_1" RAD / DEG, "Boom angle O1B above the horizontal, counter-clockwise positive.", "[Li2022, Fig. 2]";
    THETA_3: "theta_3" "theta_3" RAD / DEG, "Rocker angle O3C above the horizontal, counter-clockwise positive.", "[Li2022, eq. 5]";
    OMEGA_1: "omega_1" "omega_1" RAD_PER_S / DEG_PER_S, "Angular velocity of the boom; positive raises it.", "[Li2022, Fig. 2]";
    OMEGA_3: "omega_3" "omega_3" RAD_PER_S / DEG_PER_S, "Angular velocity of the rocker; positive turns it to the rear.", "[Li2022, eq. 9]";
    Q: "Q" "Q" N / KN [not_negative], "Weight of the load at A, downwards positive.", "[Li2022, Fig. 2]";

    // Dimensions.
    X_1: "X_1" "X_1" M / M [positive], "Length of the boom O1B.", "[Li2022, Fig. 2]";
    X_2: "X_2" "X_2" M / M [positive], "Length of the rear arm BC of the jib.", "[Li2022, Fig. 2]";
    X_3: "X_3" "X_3" M / M [positive], "Length of the rocker O3C.", "[Li2022, Fig. 2]";
    X_4: "X_4" "X_4" M / M [positive], "Length of the front arm BA of the jib.", "[Li2022, Fig. 2]";
    X_5: "X_5" "X_5" M / M, "Horizontal distance of the rocker's foot O3 behind O1.", "[Li2022, Fig. 2]";
    X_6: "X_6" "X_6" M / M, "Height of the rocker's foot O3 above O1.", "[Li2022, Fig. 2]";
    X_7: "X_7" "X_7" M / M, "Sag of the jib: distance of B below the line CA.", "[Li2022, Fig. 2]";
    BETA_0: "beta_0" "beta_0" RAD / DEG [within(Range::new(0.0, TAU).above())], "Angle of the jib at B, counter-clockwise from BA to BC.", "[Li2022, eq. 6]";
    AC: "AC" "overline(A C)" M / M [positive], "Distance from the tail C to the head A of the jib.", "[Li2022, eq. 6]";
    X_8: "X_8" "X_8" M / M, "Distance of the boom's foot O1 in front of the slewing axis.", "[Li2022, Fig. 2]";

    // Constants of the geometry.
    X_56: "X_56" "X_56" M / M, "Distance between the feet O1 and O3.", "[Li2022, eq. 1]";
    THETA_56: "theta_56" "theta_56" RAD / DEG, "Direction of the frame from the foot of the driving link to the other foot.", "[Li2022, Fig. 2]";
    THETA_S: "theta_s" "theta_s" RAD / DEG, "Lower dead point: coupler and driven link stretched in one line.", "derived";
    THETA_S2: "theta_s2" "theta'_s" RAD / DEG, "Upper dead point: coupler and driven link stretched in one line.", "derived";
    THETA_F: "theta_f" "theta_f" RAD / DEG, "Dead point: coupler and driven link folded in one line.", "derived";
    THETA_F2: "theta_f2" "theta'_f" RAD / DEG, "Other dead point: coupler and driven link folded in one line.", "derived";
    KAPPA_X: "kappa.x" "kappa_x" ONE / ONE, "Component of the jib's front arm along its rear arm, over the rear arm's length.", "[Li2022, Fig. 2]";
    KAPPA_Y: "kappa.y" "kappa_y" ONE / ONE, "Component of the jib's front arm across its rear arm, over the rear arm's length.", "[Li2022, Fig. 2]";
    EPSILON_A: "epsilon_A" "epsilon_A" RAD / DEG, "Angle from the jib's axis CA to its front arm BA.", "[Li2022, eq. 7]";

    // Position.
    B_X: "B.x" "x_B" M / M, "Boom O1B, forward component; the boom head B, as O1 is the origin.", "[Li2022, eq. 8]";
    B_Y: "B.y" "y_B" M / M, "Boom O1B, upward component; the boom head B, as O1 is the origin.", "[Li2022, eq. 8]";
    X_2X: "X_2.x" "X_(2 x)" M / M, "Rear arm BC, forward component.", "[Li2022, eq. 3]";
    X_2Y: "X_2.y" "X_(2 y)" M / M, "Rear arm BC, upward component.", "[Li2022, eq. 3]";
    X_2RX: "X_2r.x" "X'_(2 x)" M / M, "Rear arm CB, forward component.", "[Li2022, eq. 3]";
    X_2RY: "X_2r.y" "X'_(2 y)" M / M, "Rear arm CB, upward component.", "[Li2022, eq. 3]";
    X_3X: "X_3.x" "X_(3 x)" M / M, "Rocker O3C, forward component.", "[Li2022, eq. 3]";
    X_3Y: "X_3.y" "X_(3 y)" M / M, "Rocker O3C, upward component.", "[Li2022, eq. 3]";
    L_X: "L.x" "L_x" M / M, "Diagonal O3B, forward component.", "[Li2022, eq. 4]";
    L_Y: "L.y" "L_y" M / M, "Diagonal O3B, upward component.", "[Li2022, eq. 4]";
    L: "L" "L" M / M [not_negative], "Diagonal O3B.", "[Li2022, eq. 4]";
    Y_X: "Y.x" "Y_x" M / M, "Diagonal O1C, forward component.", "[Li2022, eq. 4]";
    Y_Y: "Y.y" "Y_y" M / M, "Diagonal O1C, upward component.", "[Li2022, eq. 4]";
    Y: "Y" "Y" M / M [not_negative], "Diagonal O1C.", "[Li2022, eq. 4]";
    SIGMA_S: "sigma_s" "sigma_s" M2 / M2, "Margin to the stretched dead points: zero where coupler and driven link are in one line.", "derived";
    SIGMA_F: "sigma_f" "sigma_f" M2 / M2, "Margin to the folded dead points: zero where coupler and driven link coincide in direction.", "derived";
    K: "K" "K" M2 / M2, "Four times the area of the triangle of diagonal, coupler and driven link; its sign is the branch of assembly.", "derived";
    C_X: "C.x" "x_C" M / M, "Jib tail C, forward of O1.", "[Li2022, eq. 3]";
    C_Y: "C.y" "y_C" M / M, "Jib tail C, above O1.", "[Li2022, eq. 3]";
    A_X: "A.x" "x_A" M / M, "Jib head A, forward of O1.", "[Li2022, eq. 8]";
    A_Y: "A.y" "Y_A" M / M, "Jib head A, above O1.", "[Li2022, eq. 8]";
    R: "R" "R" M / M, "Reach: distance of A from the slewing axis.", "[Li2022, eq. 8]";
    ALPHA: "alpha" "alpha" RAD / DEG, "Angle of the jib's front arm BA above the horizontal.", "[Li2022, eq. 6]";
    ALPHA_1: "alpha_1" "alpha_1" RAD / DEG, "Angle of the jib's axis CA above the horizontal.", "[Li2022, eq. 7]";
    MU: "mu" "mu" RAD / DEG [from_to(0.0, FRAC_PI_2)], "Transmission angle between coupler and driven link, 0 to 90 degrees.", "derived";

    // Velocity.
    DK: "dK" "K'" M2 / M2, "Change of K for one radian of the driving link.", "derived";
    I_21: "i_21" "i_(2 1)" ONE / ONE, "Angular velocity of the jib, seen from the boom, over the driving rocker's.", "derived";
    I_23: "i_23" "i_(2 3)" ONE / ONE, "Angular velocity of the jib, seen from the rocker, over the driving boom's.", "derived";
    I_1: "i_1" "i_1" ONE / ONE, "Ratio of the boom's angular velocity to the driving rocker's.", "[Li2022, eq. 9]";
    I_2: "i_2" "i_2" ONE / ONE, "Ratio of the jib's angular velocity to the driving link's.", "[Li2022, eq. 9]";
    I_3: "i_3" "i_3" ONE / ONE, "Ratio of the rocker's angular velocity to the driving boom's.", "[Li2022, eq. 9]";
    DA_X: "dA.x" "x'_A" M / M, "Forward travel of A for one radian of the driving link.", "[Li2022, eq. 10]";
    DA_Y: "dA.y" "Y'_A" M / M, "Rise of A for one radian of the driving link.", "[Li2022, eq. 10]";
    V_AX: "V_AX" "V_(A X)" M_PER_S / M_PER_S, "Horizontal velocity of A, forward positive.", "[Li2022, eq. 10]";
    V_AY: "V_AY" "V_(A Y)" M_PER_S / M_PER_S, "Vertical velocity of A, upward positive.", "[Li2022, eq. 10]";
    BETA: "beta" "beta" RAD / DEG, "Direction of A's velocity above the horizontal when the driving link turns positively.", "[Li2022, eq. 10]";
    O1P: "O1P" "overline(O_1 P)" M / M [infinite("where boom and rocker are parallel")], "Distance of the instantaneous centre from O1 along the boom, towards B positive.", "[Li2022, eq. 1]";
    P_X: "P.x" "x_P" M / M [infinite("where boom and rocker are parallel")], "Instantaneous centre of the jib, forward of O1.", "[Li2022, eq. 1]";
    P_Y: "P.y" "y_P" M / M [infinite("where boom and rocker are parallel")], "Instantaneous centre of the jib, above O1.", "[Li2022, eq. 1]";
    P_AT_INFINITY: "P.at_infinity" "\"P at infinity\"" ONE / ONE [boolean], "True where boom and rocker are parallel: the jib moves without turning.", "[Li2022, 2.1]";

    // Loads.
    M_Q: "M_Q" "M_Q" N_M / KN_M, "Luffing moment of the load by virtual work; positive lowers the boom.", "[Li2022, eq. 11]";
    M_Q_P: "M_Q.P" "M_(Q,P)" N_M / KN_M, "Luffing moment of the load by the instantaneous centre; positive lowers the boom.", "[Li2022, eq. 11]";
    G_1: "G_1" "G_1" N / KN [not_negative, tunable], "Weight of the boom.", "[Balance004, Fig. 1]";
    S_1: "s_1" "s_1" M / M [not_negative, tunable], "Centre of gravity of the boom from O1.", "[Balance004, Fig. 1]";
    CHI_1: "chi_1" "chi_1" RAD / DEG [tunable], "Centre of gravity of the boom, counter-clockwise from O1B.", "[Balance004, Fig. 1]";
    G_2: "G_2" "G_2" N / KN [not_negative, tunable], "Weight of the jib.", "[Balance004, Fig. 1]";
    S_2: "s_2" "s_2" M / M [not_negative, tunable], "Centre of gravity of the jib from B.", "[Balance004, Fig. 1]";
    CHI_2: "chi_2" "chi_2" RAD / DEG [tunable], "Centre of gravity of the jib, counter-clockwise from BC.", "[Balance004, Fig. 1]";
    G_3: "G_3" "G_3" N / KN [not_negative, tunable], "Weight of the rocker.", "[Balance004, Fig. 1]";
    S_3: "s_3" "s_3" M / M [not_negative, tunable], "Centre of gravity of the rocker from O3.", "[Balance004, Fig. 1]";
    CHI_3: "chi_3" "chi_3" RAD / DEG [tunable], "Centre of gravity of the rocker, counter-clockwise from O3C.", "[Balance004, Fig. 1]";
    R_1X: "r_1.x" "x_(S 1)" M / M, "Centre of gravity of the boom, forward of O1.", "[Balance004, Fig. 1]";
    R_1Y: "r_1.y" "y_(S 1)" M / M, "Centre of gravity of the boom, above O1.", "[Balance004, Fig. 1]";
    R_2X: "r_2.x" "x_(S 2)" M / M, "Centre of gravity of the jib, forward of B.", "[Balance004, Fig. 1]";
    R_2Y: "r_2.y" "y_(S 2)" M / M, "Centre of gravity of the jib, above B.", "[Balance004, Fig. 1]";
    R_3X: "r_3.x" "x_(S 3)" M / M, "Centre of gravity of the rocker, forward of O3.", "[Balance004, Fig. 1]";
    R_3Y: "r_3.y" "y_(S 3)" M / M, "Centre of gravity of the rocker, above O3.", "[Balance004, Fig. 1]";
    M_G: "M_G" "M_G" N_M / KN_M, "Moment of the own weights about the foot of the driving link; positive lowers it.", "[Balance004, eq. 1]";
    M_D: "M_D" "M_D" N_M / KN_M, "Moment that the drive must give to the driving link; positive turns it counter-clockwise.", "equilibrium";
    M_1: "M_1" "M_1" N_M / KN_M, "Moment of the boom's weight about O1, clockwise positive.", "equilibrium";
    M_3: "M_3" "M_3" N_M / KN_M, "Moment of the rocker's weight about O3, clockwise positive.", "equilibrium";
    M_B: "M_B" "M_B" N_M / KN_M, "Moment of load and jib weight about B, clockwise positive.", "equilibrium";
    M_C: "M_C" "M_C" N_M / KN_M, "Moment of load and jib weight about C, counter-clockwise positive.", "equilibrium";
    F_BX: "F_B.x" "F_(B x)" N / KN, "Force of the boom on the jib at B, forward.", "equilibrium";
    F_BY: "F_B.y" "F_(B y)" N / KN, "Force of the boom on the jib at B, upward.", "equilibrium";
    F_CX: "F_C.x" "F_(C x)" N / KN, "Force of the rocker on the jib at C, forward.", "equilibrium";
    F_CY: "F_C.y" "F_(C y)" N / KN, "Force of the rocker on the jib at C, upward.", "equilibrium";
    F_O1X: "F_O1.x" "F_(O 1 x)" N / KN, "Force of the frame on the boom at O1, forward.", "equilibrium";
    F_O1Y: "F_O1.y" "F_(O 1 y)" N / KN, "Force of the frame on the boom at O1, upward.", "equilibrium";
    F_O3X: "F_O3.x" "F_(O 3 x)" N / KN, "Force of the frame on the rocker at O3, forward.", "equilibrium";
    F_O3Y: "F_O3.y" "F_(O 3 y)" N / KN, "Force of the frame on the rocker at O3, upward.", "equilibrium";
    N_3: "N_3" "N_3" N / KN, "Axial force in the rocker at C, tension positive.", "equilibrium";

    // The whole range of motion.
    DELTA_Y: "Delta_Y" "Delta Y_A" M / M [not_negative], "Level error: greatest less smallest height of A over the working range.", "[Li2022, 6]";
    EPSILON_Y: "epsilon_Y" "epsilon_Y" ONE / PERCENT [not_negative], "Level error over the reach covered.", "[Li2022, 6]";
    R_MAX: "R_max" "R_max" M / M, "Greatest reach of the working range.", "[Li2022, 5]";
    R_MIN: "R_min" "R_min" M / M, "Smallest reach of the working range.", "[Li2022, 5]";
    MU_MIN: "mu_min" "mu_min" RAD / DEG [from_to(0.0, FRAC_PI_2)], "Smallest transmission angle of the working range.", "derived";
    M_Q_MAX: "M_Q_max" "M_(Q,max)" N_M / KN_M, "Greatest luffing moment of the load in the working range, by amount.", "[Li2022, 5]";
    V_AX_MAX: "V_AX_max" "V_(A X,max)" M_PER_S / M_PER_S, "Greatest horizontal velocity of A in the working range, by amount.", "[Li2022, 5]";
    M_D_MAX: "M_D_max" "M_(D,max)" N_M / KN_M, "Greatest moment of the drive in the working range, by amount.", "equilibrium";
    N_3_MAX: "N_3_max" "N_(3,max)" N / KN, "Greatest axial force in the rocker in the working range, by amount; tension positive.", "equilibrium";
    FROM: "from" "theta_a" RAD / DEG, "Angle of the driving link at the start of the working range.", "input";
    TO: "to" "theta_e" RAD / DEG, "Angle of the driving link at the end of the working range.", "input";
    W_Q: "W_Q" "W_Q" J / KJ, "Work of the luffing moment over the working range.", "virtual work";
    W_Y: "W_Y" "Q thin Delta Y" J / KJ, "Load times its rise over the working range.", "virtual work";
    AGREEMENT: "agreement" "delta" ONE / ONE, "Difference of two independent ways, relative to the largest value.", "derived";

    // The publication's own forms.
    THETA_0: "theta_0" "theta_0" RAD / DEG, "Inclination of the frame O3O1 below the horizontal.", "[Li2022, eq. 1]";
    L_LI: "L.Li" "L" M / M, "Diagonal O3B by the law of cosines.", "[Li2022, eq. 4]";
    THETA_3_LI: "theta_3.Li" "theta_3" RAD / DEG, "Rocker angle by the law of cosines.", "[Li2022, eq. 5]";
    Y_LI: "Y.Li" "Y" M / M, "Diagonal O1C by the law of cosines.", "[Li2022, eq. 4]";
    ALPHA_LI: "alpha.Li" "alpha" RAD / DEG, "Angle of the front arm by the law of cosines.", "[Li2022, eq. 6]";
    ALPHA_1_LI: "alpha_1.Li" "alpha_1" RAD / DEG, "Angle of the jib's axis by the law of cosines.", "[Li2022, eq. 7]";
    O1P_LI: "O1P.Li" "overline(O_1 P)" M / M, "Distance of the instantaneous centre from O1.", "[Li2022, eq. 1]";

    // The publication's unbalanced moments, beside the exact ones.
    M_U_LOAD: "M_u_load" "M_(\"u\" Q i)" N_M / KN_M, "Unbalanced moment of the load, which does not move level, by the ratios of angular velocities, for one radian of the luffing angle; positive raises the boom.", "[Ports001, 5.10.3.1]";
    M_U_ROPE: "M_u_rope" "M_(\"u\" T i)" N_M / KN_M, "Unbalanced moment of the swaying rope's horizontal pull, by the ratios of angular velocities, for one radian of the luffing angle; positive raises the boom.", "[Ports001, 5.10.3.2]";
    M_U_TIE: "M_u_tie" "M_(\"u\" l)" N_M / KN_M, "Unbalanced moment of half the rocker's weight at the jib's tail, for one radian of the luffing angle; positive raises the boom.", "[Ports001, 5.10.3.3]";
    M_U_TRUNK: "M_u_trunk" "M_(\"u\" x)" N_M / KN_M, "Unbalanced moment of the jib's weight, by the ratios of angular velocities, for one radian of the luffing angle; positive raises the boom.", "[Ports001, 5.10.3.4]";
    M_U_TIE_WIND: "M_u_tie_wind" "M_(\"u\" w l i)" N_M / KN_M, "Unbalanced moment of half the wind on the rocker at the jib's tail, for one radian of the luffing angle; positive raises the boom.", "[Ports001, 5.10.3.5]";
    M_U_TRUNK_WIND: "M_u_trunk_wind" "M_(\"u\" w x i)" N_M / KN_M, "Unbalanced moment of the wind on the jib, by the ratios of angular velocities, for one radian of the luffing angle; positive raises the boom.", "[Ports001, 5.10.3.6]";
    M_U_BOOM_WIND: "M_u_boom_wind" "M_(\"u\" w b i)" N_M / KN_M, "Unbalanced moment of the wind on the boom, by the ratios of angular velocities, for one radian of the luffing angle; positive raises the boom.", "[Ports001, 5.10.3.7]";
    M_U_BOOM: "M_u_boom" "M_(\"u\" b)" N_M / KN_M, "Unbalanced moment of the boom's weight, by the ratios of angular velocities, for one radian of the luffing angle; positive raises the boom.", "[Ports001, 5.10.3.8]";
    M_X_TIE: "M_x_tie" "M_(l)" N_M / KN_M, "Moment of the rocker's weight as it is distributed, for one radian of the luffing angle; positive raises the boom.", "virtual work";
    M_X_TRUNK: "M_x_trunk" "M_(x)" N_M / KN_M, "Moment of the jib's weight by derivatives of its height, for one radian of the luffing angle; positive raises the boom.", "virtual work";
    M_X_TIE_WIND: "M_x_tie_wind" "M_(w l i)" N_M / KN_M, "Moment of the wind on the rocker in the centres of its areas, for one radian of the luffing angle; positive raises the boom.", "virtual work";
    M_X_TRUNK_WIND: "M_x_trunk_wind" "M_(w x i)" N_M / KN_M, "Moment of the wind on the jib by derivatives of its places, for one radian of the luffing angle; positive raises the boom.", "virtual work";
    M_X_BOOM_WIND: "M_x_boom_wind" "M_(w b i)" N_M / KN_M, "Moment of the wind on the boom by derivatives of its places, for one radian of the luffing angle; positive raises the boom.", "virtual work";
    M_X_BOOM: "M_x_boom" "M_(b)" N_M / KN_M, "Moment of the boom's weight by derivatives of its height, for one radian of the luffing angle; positive raises the boom.", "virtual work";
    W_UL: "W_ul" "W_l" M2 / M2 [not_negative], "Areas of the rocker times drag coefficients.", "virtual work";
    W_UX: "W_ux" "W_x" M2 / M2 [not_negative], "Areas of the jib times drag coefficients.", "virtual work";
    S_UX: "S_ux" "S_x" M3 / M3, "These times the heights of their centres above the boom's head.", "virtual work";
    S_UB: "S_ub" "S_b" M3 / M3, "Areas of the boom times drag coefficients and the heights of their centres above its foot.", "virtual work";
    E_Q: "e_Q" "e_Q" M / M, "Rise of the load for one radian of the luffing angle: its unbalanced moment over its weight.", "[Ports001, 5.10.2.2]";
    C_Q: "C_Q" "C_Q" ONE / PERCENT [not_negative], "Coefficient of the load's unbalanced moment: its greatest amount over the load and the greatest reach.", "[Ports001, 5.10.2.2]";
    C_G: "C_G" "C_G" ONE / PERCENT [not_negative, infinite("where own weights have no moment")], "Coefficient of the unbalanced moment of own weights: its greatest amount with the counterweight over that without.", "[Ports001, 5.10.5.3]";
}

//! Every quantity of the balance of the boom system.

use std::f64::consts::FRAC_PI_2;

use crate::kernel::symbol::symbols;

symbols! {
    // Coordinate and boom.
    PHI: "phi" "phi" RAD / DEG, "Boom angle above the horizontal, counter-clockwise positive.", "[Balance004, Fig. 1]";
    G_B: "G_b" "G_b" N / KN, "Weight of a plain boom.", "[Ports001, 2.1.1]";
    R_B: "r_b" "r_b" M / M, "Distance of the plain boom's centre of gravity from its foot.", "[Ports001, 2.1.1]";
    CHI_B: "chi_b" "chi_b" RAD / DEG, "Angle from the boom's axis to its centre of gravity, counter-clockwise positive.", "[Ports001, 2.1.1]";
    M_0: "M_0" "M_0" N_M / KN_M, "Moment of the boom system's weights about the boom foot; positive raises the boom.", "[Balance004, eq. 1]";
    M_0_P: "M_0.P" "M_0" N_M / KN_M, "Moment of the boom system's weights by the power about instant centres; positive raises the boom.", "[Ports001, 9]";
    U_0: "U_0" "U_0" J / KJ, "Potential energy of the boom system, from the height of the boom foot.", "derived";

    // Dimensions of the balances.
    G_C: "G_c" "G_c" N / KN [not_negative, tunable], "Weight of the counterweight.", "[Ports001, 2.1]";
    R_C: "r_c" "r_c" M / M [not_negative], "Distance of the counterweight from the axis it turns about.", "[Ports001, 2.1]";
    CHI_C: "chi_c" "chi_c" RAD / DEG, "Angle from the boom's rearward extension to the counterweight's arm, counter-clockwise positive.", "[Ports001, 2.1.1]";
    D_1: "d_1" "d_1" M / M [positive], "Distance of the lever's pivot from the boom foot.", "[Balance004, Fig. 2]";
    DELTA_1: "delta_1" "delta_1" RAD / DEG, "Direction from the boom foot to the lever's pivot.", "[Balance004, Fig. 2]";
    R_K: "r_1" "r_1" M / M [positive], "Distance of the rod's or rope's joint on the boom from the boom foot.", "[Balance004, Fig. 2]";
    ALPHA_K: "alpha_K" "alpha_K" RAD / DEG, "Angle from the boom's axis to the joint on the boom, counter-clockwise positive; alpha_1 in the publication.", "[Balance004, Fig. 2]";
    L_1: "l_1" "l_1" M / M [positive], "Length of the coupling rod.", "[Balance004, Fig. 2]";
    R_L: "R_1" "R_1" M / M [positive], "Distance of the rod's joint on the lever from the lever's pivot.", "[Balance004, Fig. 2]";
    CHI_5: "chi_5" "chi_5" RAD / DEG, "Angle from the lever's rod arm to its counterweight arm, counter-clockwise positive.", "[Balance004, Fig. 2]";
    M_5: "M_5" "M_5" N_M / KN_M [not_negative, tunable], "Weight of the counterweight times its arm.", "[Balance004, eq. 2]";
    S_5: "s_5" "s_5" M / M [positive], "Arm of the counterweight on the lever.", "[Balance004, Fig. 2]";
    H_X: "H_x" "x_H" M / M, "Guide pulley, forward of the boom foot.", "[Ports001, 2.1.4]";
    H_Y: "H_y" "y_H" M / M, "Guide pulley, above the boom foot.", "[Ports001, 2.1.4]";
    LAMBDA: "lambda" "lambda" RAD / DEG [not_negative], "Slope of the straight rail below the horizontal, rearward; 90 deg is a vertical one.", "[Ports001, 2.1.4]";
    L_R: "L_r" "L_r" M / M [positive], "Length of the rope between boom and trolley.", "[Ports001, 2.1.5]";
    Y_0: "y_0" "y_0" M / M, "Height of the trolley at the reference angle.", "[Ports001, 2.1.5]";
    PHI_0: "phi_0" "phi_0" RAD / DEG, "Boom angle at which the trolley has its reference height.", "[Ports001, 2.1.5]";

    // Closure of the lever's linkage.
    D_1X: "d_1.x" "d_(1 x)" M / M, "Lever's pivot, forward of the boom foot.", "[Balance004, Fig. 2]";
    D_1Y: "d_1.y" "d_(1 y)" M / M, "Lever's pivot, above the boom foot.", "[Balance004, Fig. 2]";
    F_1: "f_1" "f_1" M / M, "Frame of the balance linkage: distance of the two pivots.", "[Balance004, Fig. 2]";
    DELTA_F: "delta_f" "delta_f" RAD / DEG, "Direction of the frame of the balance linkage.", "[Balance004, Fig. 2]";
    PHI_S: "phi_s" "phi_s" RAD / DEG, "Lower dead point: rod and lever stretched in one line.", "derived";
    PHI_S2: "phi_s2" "phi'_s" RAD / DEG, "Upper dead point: rod and lever stretched in one line.", "derived";
    PHI_F: "phi_f" "phi_f" RAD / DEG, "Dead point: rod and lever folded in one line.", "derived";
    PHI_F2: "phi_f2" "phi'_f" RAD / DEG, "Other dead point: rod and lever folded in one line.", "derived";
    PHI_K: "phi_K" "phi_K" RAD / DEG, "Direction from the boom foot to the joint on the boom.", "[Balance004, Fig. 2]";
    K_X: "K.x" "x_K" M / M, "Joint on the boom, forward of the boom foot.", "[Balance004, Fig. 2]";
    K_Y: "K.y" "y_K" M / M, "Joint on the boom, above the boom foot.", "[Balance004, Fig. 2]";
    A_1X: "a_1.x" "a_(1 x)" M / M, "Diagonal from the lever's pivot to the joint on the boom, forward component.", "[Balance004, Fig. 2]";
    A_1Y: "a_1.y" "a_(1 y)" M / M, "Diagonal from the lever's pivot to the joint on the boom, upward component.", "[Balance004, Fig. 2]";
    A_1: "a_1" "a_1" M / M, "Diagonal from the lever's pivot to the joint on the boom.", "[Balance004, Fig. 2]";
    SIGMA_S1: "sigma_s1" "sigma_(s 1)" M2 / M2, "Margin to the stretched dead points of the balance linkage.", "derived";
    SIGMA_F1: "sigma_f1" "sigma_(f 1)" M2 / M2, "Margin to the folded dead points of the balance linkage.", "derived";
    K_1: "K_1" "K_1" M2 / M2, "Four times the area of the triangle of diagonal, rod and lever; its sign is the branch of assembly.", "derived";
    R_1X: "R_1.x" "R_(1 x)" M / M, "Lever's rod arm, forward component.", "[Balance004, Fig. 2]";
    R_1Y: "R_1.y" "R_(1 y)" M / M, "Lever's rod arm, upward component.", "[Balance004, Fig. 2]";
    L_1X: "l_1.x" "l_(1 x)" M / M, "Coupling rod from boom to lever, forward component.", "[Balance004, Fig. 2]";
    L_1Y: "l_1.y" "l_(1 y)" M / M, "Coupling rod from boom to lever, upward component.", "[Balance004, Fig. 2]";

    // Results at one position.
    PSI: "psi" "psi" RAD / DEG, "Angle of the counterweight's arm above the horizontal.", "[Balance004, Fig. 2]";
    I_5: "i_5" "i_5" ONE / ONE, "Lever's angular velocity over the boom's.", "[Ports001, 4.1]";
    GAMMA: "gamma" "gamma" RAD / DEG [from_to(0.0, FRAC_PI_2)], "Transmission angle between rod and lever, 0 to 90 deg.", "[Balance004, Fig. 2]";
    H_1: "h_1" "h_1" M / M, "Distance of the boom foot from the line of the rod; positive where a pull raises the boom.", "[Ports001, eq. 5.2.3]";
    H_5: "h_5" "h_5" M / M, "Distance of the lever's pivot from the line of the rod; where it has the sign of the boom's, lever and boom turn alike.", "[Ports001, eq. 5.2.4]";
    N_1: "N_1" "N_1" N / KN, "Force in the coupling rod or rope, tension positive.", "equilibrium";
    C_5X: "C_5.x" "x_5" M / M, "Counterweight, forward of the boom foot.", "[Ports001, 2.1]";
    C_5Y: "C_5.y" "y_5" M / M, "Counterweight, above the boom foot.", "[Ports001, 2.1]";
    U_5: "U_5" "U_5" J / KJ, "Potential energy of the counterweight, up to a constant.", "derived";
    M_UR: "M_ur" "M_(u r)" N_M / KN_M, "Moment of the balance about the boom foot; positive raises the boom.", "[Balance004, eq. 2]";
    DM: "dM" "Delta M" N_M / KN_M, "Residual moment about the boom foot; positive raises the boom.", "[Balance004, eq. 3]";
    M_SUM: "M_sum" "M_Sigma" N_M / KN_M, "Total moment of load, weights and balance about the boom foot; positive raises the boom.", "equilibrium";
    M_D_0: "M_D_0" "M_(D 0)" N_M / KN_M, "Moment that the drive would have to give to the driving link without the balance.", "virtual work";
    F_D_0: "F_d_0" "F_(d 0)" N / KN [infinite("where the drive points at the foot of its bar")], "Force that the drive would need without the balance, push positive.", "equilibrium";
    DM_5: "dM_5" "Delta M_5" N_M / KN_M [infinite("where the lever comes to rest")], "Residual moment about the lever's pivot, of the same power as the one about the boom foot.", "[Ports001, eq. 5.2.6]";
    F_KX: "F_K.x" "F_(K x)" N / KN, "Force of the balance on the boom, forward component.", "equilibrium";
    F_KY: "F_K.y" "F_(K y)" N / KN, "Force of the balance on the boom, upward component.", "equilibrium";
    F_MX: "F_M.x" "F_(M x)" N / KN, "Force of the frame on the lever's pivot, guide pulley or rail, forward component.", "equilibrium";
    F_MY: "F_M.y" "F_(M y)" N / KN, "Force of the frame on the lever's pivot, guide pulley or rail, upward component.", "equilibrium";
    S_R: "s_r" "s_r" M / M, "Rope from the joint on the boom to the guide pulley.", "[Ports001, 2.1.4]";
    W_R: "w_r" "w_r" M / M, "Horizontal projection of the trolley's rope.", "[Ports001, 2.1.5]";
    T_Y: "t.y" "t_y" M / M, "Rise of the trolley for one radian of the boom.", "derived";

    // Results of the working range.
    DM_MAX: "dM_max" "abs(Delta M)_max" N_M / KN_M [not_negative], "Greatest residual moment about the boom foot, by amount.", "[Balance004, F1]";
    DM_5_MAX: "dM_5_max" "abs(Delta M_5)_max" N_M / KN_M [not_negative, infinite("where the lever comes to rest")], "Greatest residual moment about the lever's pivot, by amount.", "[Ports001, eq. 5.2.6]";
    E: "E" "E" J / KJ [not_negative], "Integral of the amount of the residual moment over the working range.", "[Balance004, F2]";
    E_PLUS: "E_plus" "E_(+)" J / KJ [not_negative], "Integral of the residual moment where it raises the boom, over the working range.", "[Balance004, F2]";
    GAMMA_MIN: "gamma_min" "gamma_min" RAD / DEG [from_to(0.0, FRAC_PI_2)], "Smallest transmission angle of the working range.", "[Balance004, F3]";
    N_MAX: "N_max" "abs(N_1)_max" N / KN [not_negative], "Greatest force in the rod or rope, by amount.", "derived";
    DELTA_Y_5: "Delta_y_5" "Delta y_5" M / M [not_negative], "Difference of the counterweight's greatest and smallest height.", "[Ports001, eq. 5.2.1]";
    M_PLUS: "M_plus" "M^+" N_M / KN_M, "Least residual moment that turns the boom inwards at both ends.", "[Balance004, eq. 6-7]";
    DM_50: "dM_50" "abs(Delta M)_50" N_M / KN_M, "Residual that half of all builds stay below.", "derived";
    DM_95: "dM_95" "abs(Delta M)_95" N_M / KN_M, "Residual that 95 % of all builds stay below.", "derived";

    // Given to the synthesis.
    PSI_1: "psi_1" "psi_1" RAD / DEG, "Angle of the counterweight's arm at the first chosen position.", "[Balance004, eq. 4]";
    T_L: "t_l" "t_l" M / MM, "Tolerance of every length, to both sides.", "given";
    T_A: "t_a" "t_alpha" RAD / DEG, "Tolerance of every angle, to both sides.", "given";
    T_W: "t_w" "t_G" ONE / PERCENT, "Tolerance of every weight, to both sides, relative.", "given";
}

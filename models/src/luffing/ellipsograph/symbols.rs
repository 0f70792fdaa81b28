//! Every quantity of the boom on guide and link, besides those of its weight and its angle, which balances share.

use crate::kernel::symbol::symbols;

pub use crate::balance::symbols::{CHI_B, G_B, R_B};

symbols! {
    OMEGA: "omega" "omega" RAD_PER_S / DEG_PER_S, "Angular velocity of the boom; positive raises it.", "[Ports001, 5.9.2.3]";
    Q: "Q" "Q" N / KN [not_negative], "Weight of the load, downwards positive.", "[Ports001, 5.9.2.3]";

    // Bars.
    C: "c" "c" M / M [positive], "Length of the link from O1 to C, and of the boom from its foot B to C.", "[Ports001, 5.9.2.3]";
    A: "a" "a" M / M [positive], "Length of the boom from C to its head A.", "[Ports001, 5.9.2.3]";
    X_8: "X_8" "X_8" M / M, "Distance of the link's pivot O1, and of the guide, in front of the slewing axis.", "[Ports001, 5.9.2.3]";
    G_L: "G_l" "G_l" N / KN [not_negative], "Weight of the link.", "[Ports001, 5.9]";
    R_L: "r_l" "r_l" M / M, "Distance of the link's centre of gravity from O1, towards C positive.", "[Ports001, 5.9]";

    // Position.
    E_1: "e_1" "e_1" M / M, "Level half axis of the ellipse on which the head moves.", "[Ports001, 5.9.2.3]";
    E_2: "e_2" "e_2" M / M, "Upright half axis of that ellipse; negative where the head lies below the level of O1.", "[Ports001, 5.9.2.3]";
    THETA_L: "theta_l" "theta_l" RAD / DEG, "Direction of the link from O1 to C: the boom's angle, the other way.", "[Ports001, 5.9.2.3]";
    C_X: "C.x" "x_C" M / M, "Joint C of boom and link, forward of O1.", "derived";
    C_Y: "C.y" "y_C" M / M, "Joint C of boom and link, above O1.", "derived";
    B_Y: "B.y" "y_B" M / M, "Foot B of the boom in its guide, above O1.", "derived";
    A_X: "A.x" "x_A" M / M, "Head A of the boom, forward of O1.", "derived";
    A_Y: "A.y" "y_A" M / M, "Head A of the boom, above O1; the load keeps its distance below it.", "[Ports001, 5.9.2.3]";
    R: "R" "R" M / M, "Reach: distance of A from the slewing axis.", "derived";
    P_X: "P.x" "x_P" M / M, "Instantaneous centre of the boom, forward of O1.", "[Ports001, 5.9]";
    P_Y: "P.y" "y_P" M / M, "Instantaneous centre of the boom, above O1.", "[Ports001, 5.9]";

    // Velocity.
    DA_X: "dA.x" "x'_A" M / M, "Forward travel of A for one radian of the boom.", "derived";
    DA_Y: "dA.y" "y'_A" M / M, "Rise of A for one radian of the boom.", "derived";
    DB_Y: "dB.y" "y'_B" M / M, "Rise of the foot B for one radian of the boom.", "derived";
    V_AX: "V_AX" "V_(A X)" M_PER_S / M_PER_S, "Horizontal velocity of A, forward positive.", "derived";
    V_AY: "V_AY" "V_(A Y)" M_PER_S / M_PER_S, "Vertical velocity of A, upward positive.", "derived";
    V_B: "V_B" "V_B" M_PER_S / M_PER_S, "Velocity of the foot B in its guide, upward positive.", "derived";
    OMEGA_L: "omega_l" "omega_l" RAD_PER_S / DEG_PER_S, "Angular velocity of the link, counter-clockwise positive.", "derived";

    // Moments.
    M_Q: "M_Q" "M_Q" N_M / KN_M, "Moment of the load by virtual work, for the boom's angle; positive lowers the boom.", "[Ports001, 5.9.2.3]";
    M_Q_P: "M_Q.P" "M_(Q,P)" N_M / KN_M, "The same by the instantaneous centre.", "[Ports001, 5.9]";
    M_G: "M_G" "M_G" N_M / KN_M, "Moment of the weights of boom and link, for the boom's angle; positive lowers the boom.", "virtual work";
    M_D: "M_D" "M_D" N_M / KN_M, "Moment that the drive must give to the link about O1; positive raises the boom and lowers the link.", "virtual work";
    P_D: "P_D" "P_D" W / KW, "Power of the drive; positive where it gives it.", "virtual work";

    // Forces, of rest or of the motion.
    S_BX: "S_b.x" "x_S" M / M, "Centre of gravity of the boom, forward of O1.", "derived";
    M_C: "M_C" "M_C" N_M / KN_M, "Moment of load and own weight of the boom about C; positive lowers the head.", "equilibrium";
    F_BX: "F_B.x" "F_(B x)" N / KN, "Force of the guide on the boom's foot B, forward.", "equilibrium";
    F_CX: "F_C.x" "F_(C x)" N / KN, "Force of the link on the boom at C, forward.", "equilibrium";
    F_CY: "F_C.y" "F_(C y)" N / KN, "Force of the link on the boom at C, upward.", "equilibrium";
    N_L: "N_l" "N_l" N / KN, "Axial force in the link at C, tension positive.", "equilibrium";
    F_O1X: "F_O1.x" "F_(O 1 x)" N / KN, "Force of the frame on the link at O1, forward.", "equilibrium";
    F_O1Y: "F_O1.y" "F_(O 1 y)" N / KN, "Force of the frame on the link at O1, upward.", "equilibrium";

    // In motion.
    J_B: "J_b" "J_b" KG_M2 / T_M2 [not_negative], "Inertia of the boom about its centre of gravity.", "input";
    J_L: "J_l" "J_l" KG_M2 / T_M2 [not_negative], "Inertia of the link about its centre of gravity.", "input";
    MASS_B: "mass_b" "m_b" KG / T, "Mass of the boom, with the load where it hangs on no rope: weight over g.", "derived";
    MASS_L: "mass_l" "m_l" KG / T, "Mass of the link: weight over g.", "derived";
    J_BQ: "J_bQ" "J_(b Q)" KG_M2 / T_M2, "Inertia of the boom with the load about their common centre of gravity.", "derived";
    S_MX: "S_m.x" "x_m" M / M, "Centre of gravity of the boom, with the load where it hangs on no rope, forward of O1.", "derived";
    S_MY: "S_m.y" "y_m" M / M, "Centre of gravity of the boom, with the load where it hangs on no rope, above O1.", "derived";
    DS_MX: "dS_m.x" "x'_m" M / M, "Forward travel of this centre of gravity for one radian of the boom.", "derived";
    DS_MY: "dS_m.y" "y'_m" M / M, "Rise of this centre of gravity for one radian of the boom.", "derived";
    DS_LX: "dS_l.x" "x'_l" M / M, "Forward travel of the link's centre of gravity for one radian of the boom.", "derived";
    DS_LY: "dS_l.y" "y'_l" M / M, "Rise of the link's centre of gravity for one radian of the boom.", "derived";
    I_RB: "I_rb" "I_b" KG_M2 / T_M2, "Inertia of the boom, reduced to its angle.", "Lagrange";
    DI_RB: "dI_rb" "I'_b" KG_M2 / T_M2, "Change of the boom's reduced inertia for one radian of it.", "Lagrange";
    M_BC: "M_bC" "M_(b C)" N_M / KN_M, "Moment of the rope and of the boom's weight and inertia about C; clockwise positive.", "Newton and Euler";
    F_ILX: "F_il.x" "F_(i l x)" N / KN, "Inertia of the link, forward.", "Newton and Euler";
    F_ILY: "F_il.y" "F_(i l y)" N / KN, "Weight and inertia of the link, upward.", "Newton and Euler";
    M_LO: "M_lO" "M_(l O)" N_M / KN_M, "Moment of the link's weight and inertia about O1; clockwise positive.", "Newton and Euler";
    I_RL: "I_rl" "I_l" KG_M2 / T_M2, "Inertia of the link, reduced to the boom's angle.", "Lagrange";
    DI_RL: "dI_rl" "I'_l" KG_M2 / T_M2, "Change of the link's reduced inertia for one radian of the boom.", "Lagrange";
    D_PHI: "der(phi)" "dot(phi)" RAD_PER_S / DEG_PER_S, "Rate of the boom's angle.", "state";
    D_OMEGA: "der(omega)" "dot(omega)" RAD_PER_S2 / RAD_PER_S2, "Angular acceleration of the boom.", "equations of motion";

    // The whole range of motion.
    R_MAX: "R_max" "R_max" M / M, "Greatest reach of the working range.", "derived";
    R_MIN: "R_min" "R_min" M / M, "Smallest reach of the working range.", "derived";
    DELTA_Y: "Delta_Y" "Delta y_A" M / M [not_negative], "Level error: greatest less smallest height of the head over the working range.", "[Ports001, 5.9.2.3]";
    EPSILON_Y: "epsilon_Y" "epsilon_Y" ONE / PERCENT [not_negative], "Level error over the reach covered.", "[Ports001, 5.9.2.3]";
    DELTA_B: "Delta_B" "Delta y_B" M / M [not_negative], "Travel of the foot in its guide over the working range.", "derived";
    V_AX_MAX: "V_AX_max" "V_(A X,max)" M_PER_S / M_PER_S, "Greatest horizontal velocity of A in the working range, by amount.", "derived";
    M_Q_MAX: "M_Q_max" "M_(Q,max)" N_M / KN_M, "Greatest moment of the load in the working range, by amount.", "[Ports001, 5.9.2.3]";
    M_D_MAX: "M_D_max" "M_(D,max)" N_M / KN_M, "Greatest moment of the drive in the working range, by amount.", "virtual work";
    F_B_MAX: "F_B_max" "F_(B,max)" N / KN, "Greatest force of the guide on the foot in the working range, by amount.", "equilibrium";
    N_L_MAX: "N_l_max" "N_(l,max)" N / KN, "Greatest axial force in the link in the working range, by amount; tension positive.", "equilibrium";

    FROM: "from" "phi_a" RAD / DEG, "Angle of the boom at the start of the working range.", "input";
    TO: "to" "phi_e" RAD / DEG, "Angle of the boom at the end of the working range.", "input";
    AGREEMENT: "agreement" "delta" ONE / ONE, "Difference of two independent ways, relative to the largest value.", "derived";
}

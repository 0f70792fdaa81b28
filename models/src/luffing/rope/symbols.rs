//! Every quantity of the boom on a luffing rope, besides those of its weight and its angle, which balances share.

use crate::kernel::symbol::{Range, symbols};

symbols! {
    OMEGA: "omega" "omega" RAD_PER_S / DEG_PER_S, "Angular velocity of the boom; positive raises it.", "[Ports001, 5.1]";
    Q: "Q" "Q" N / KN [not_negative], "Weight of the load on its hook, downwards positive.", "[Ports001, 5.1]";

    // Boom.
    L: "l" "l" M / M [positive], "Length of the boom from its foot O1 to its head A, along its line.", "[Ports001, 5.1]";
    F_A: "f_A" "f_A" M / M, "Offset of the head A from the boom's line, to its upper side positive.", "[Ports001, 5.1]";
    X_8: "X_8" "X_8" M / M, "Distance of the boom's foot O1 in front of the slewing axis.", "[Ports001, 5.1]";

    // Luffing tackle and hoist rope.
    E_X: "E_x" "x_E" M / M, "Point E of the luffing tackle on the frame, forward of O1.", "[Ports001, 5.1]";
    E_Y: "E_y" "y_E" M / M, "Point E of the luffing tackle on the frame, above O1.", "[Ports001, 5.1]";
    S_K: "s_K" "s_K" M / M [positive], "Point K of the luffing tackle on the boom, from O1.", "[Ports001, 5.1]";
    CHI_K: "chi_K" "chi_K" RAD / DEG, "Point K of the luffing tackle on the boom, counter-clockwise from its line.", "[Ports001, 5.1]";
    M_L: "m_l" "m_l" ONE / ONE [positive], "Falls of the luffing tackle.", "[Ports001, 5.1]";
    ETA_L: "eta_l" "eta_l" ONE / ONE [within(Range::new(0.0, 1.0).above())], "Efficiency of the whole luffing tackle.", "[Ports001, 5.1]";
    B_X: "B_x" "x_B" M / M, "Sheave B of the hoist rope on the frame, forward of O1.", "[Ports001, 5.1]";
    B_Y: "B_y" "y_B" M / M, "Sheave B of the hoist rope on the frame, above O1.", "[Ports001, 5.1]";
    ETA_H: "eta_h" "eta_h" ONE / ONE [within(Range::new(0.0, 1.0).above())], "Efficiency of the whole hoist tackle.", "[Ports001, 5.1]";
    M_K: "m_k" "m_k" ONE / ONE [not_negative], "Parts of the hoist rope between the head A and the sheaves at B, all that run there.", "[Ports001, 5.2.3.1]";
    ETA_K: "eta_k" "eta_k" ONE / ONE [within(Range::new(0.0, 1.0).above())], "Efficiency of all parts of the hoist rope between A and B.", "[Ports001, 5.2.3.1]";
    H_Q: "h_Q" "h_Q" M / M [not_negative], "Height of the head A above the load at the start of the working range.", "[Ports001, 5.1]";

    // Position.
    A_X: "A.x" "x_A" M / M, "Boom head A, forward of O1.", "derived";
    A_Y: "A.y" "y_A" M / M, "Boom head A, above O1.", "derived";
    R: "R" "R" M / M, "Reach: distance of A from the slewing axis.", "derived";
    K_LX: "K_l.x" "x_K" M / M, "Point K of the luffing tackle, forward of O1.", "derived";
    K_LY: "K_l.y" "y_K" M / M, "Point K of the luffing tackle, above O1.", "derived";
    L_TX: "L_T.x" "L_(T x)" M / M, "Luffing tackle from K to E, forward component.", "derived";
    L_TY: "L_T.y" "L_(T y)" M / M, "Luffing tackle from K to E, upward component.", "derived";
    L_T: "L_T" "L_T" M / M [not_negative], "Length of the luffing tackle between K and E.", "derived";
    H_T: "h_T" "h_T" M / M, "Lever arm of the luffing tackle about O1; positive where its pull raises the boom.", "[Ports001, 5.1]";
    L_L: "l_l" "l_l" M / M [not_negative], "Rope in the luffing tackle: what its drum takes in is what this loses.", "derived";
    L_SX: "L_S.x" "L_(S x)" M / M, "Hoist rope from A to B, forward component.", "derived";
    L_SY: "L_S.y" "L_(S y)" M / M, "Hoist rope from A to B, upward component.", "derived";
    L_S: "L_S" "overline(A B)" M / M [not_negative], "Hoist rope between the head A and the sheave B.", "[Ports001, 5.2.3]";
    H_S: "h_S" "h_S" M / M, "Lever arm of the hoist rope about O1; positive where its pull raises the boom.", "[Ports001, 5.1]";
    C_Q: "c_Q" "c_Q" M / M, "Height of the load less that of the head, without the rope between A and B.", "[Ports001, 5.2.3]";
    Y_Q: "Y_Q" "y_Q" M / M, "Height of the load above O1 with the hoist drum at rest.", "[Ports001, 5.2.3]";
    Y_QA: "Y_Q_a" "y_(Q a)" M / M, "Height of the load above O1 at the start of the working range.", "[Ports001, 5.2.3]";
    L_H: "l_h" "l_h" M / M, "Hoist rope that its drum would have to take in, or pay out where negative, to bring the load to the height of the start.", "derived";

    // Velocity.
    DA_X: "dA.x" "x'_A" M / M, "Forward travel of A for one radian of the boom.", "derived";
    DA_Y: "dA.y" "y'_A" M / M, "Rise of A for one radian of the boom.", "derived";
    V_AX: "V_AX" "V_(A X)" M_PER_S / M_PER_S, "Horizontal velocity of A, forward positive.", "derived";
    V_AY: "V_AY" "V_(A Y)" M_PER_S / M_PER_S, "Vertical velocity of A, upward positive.", "derived";
    V_Q: "V_Q" "V_Q" M_PER_S / M_PER_S, "Vertical velocity of the load with the hoist drum at rest, upward positive.", "derived";
    V_L: "v_l" "v_l" M_PER_S / M_PER_S, "Speed of the luffing rope at its drum; positive where the drum takes it in.", "derived";

    // Forces without losses.
    S_H: "S_h" "S_h" N / KN, "Pull of the hoist rope, without losses.", "[Ports001, 5.1]";
    F_K: "F_k" "F_k" N / KN, "Pull of all parts of the hoist rope between A and B, without losses.", "[Ports001, 5.2.4.1]";
    M_Q: "M_Q" "M_Q" N_M / KN_M, "Moment of the load about O1 by virtual work; positive lowers the boom.", "[Ports001, 5.2.3]";
    M_Q_P: "M_Q.P" "M_(Q,P)" N_M / KN_M, "The same by what load and hoist rope do at the head while the boom turns about O1.", "[Ports001, 5.9.2.4]";
    M_G: "M_G" "M_G" N_M / KN_M, "Moment of the boom's weight about O1; positive lowers the boom.", "[Ports001, 5.1]";
    M_W: "M_w" "M_w" N_M / KN_M, "Moment of load, own weight and balance about O1, without the pull of the hoist rope; positive lowers the boom.", "[Ports001, 5.1]";
    M_D: "M_D" "M_D" N_M / KN_M, "Moment that the luffing tackle must give to the boom; positive raises it.", "[Ports001, 5.1]";
    T: "T" "T" N / KN, "Pull of the luffing tackle, without losses; where negative the boom falls back on a slack rope.", "[Ports001, 5.1]";
    F_O1X: "F_O1.x" "F_(O 1 x)" N / KN, "Force of the frame on the boom at O1, forward.", "equilibrium";
    F_O1Y: "F_O1.y" "F_(O 1 y)" N / KN, "Force of the frame on the boom at O1, upward.", "equilibrium";
    N_B: "N_b" "N_b" N / KN, "Axial force in the boom at its foot, tension positive.", "equilibrium";
    P_L: "P_l" "P_l" W / KW, "Power of the luffing rope at its drum, without losses; positive where the drum gives it.", "virtual work";

    // With losses.
    S_H_UP: "S_h.up" "S_(h, arrow.t)" N / KN, "Pull of the hoist rope, with losses, while the boom is raised.", "[Ports001, 5.1]";
    S_H_DOWN: "S_h.down" "S_(h, arrow.b)" N / KN, "Pull of the hoist rope, with losses, while the boom is lowered.", "[Ports001, 5.1]";
    F_K_UP: "F_k.up" "F_(k, arrow.t)" N / KN, "Pull of all parts of the hoist rope between A and B, with losses, while the boom is raised.", "[Ports001, 5.2.4.1]";
    F_K_DOWN: "F_k.down" "F_(k, arrow.b)" N / KN, "Pull of all parts of the hoist rope between A and B, with losses, while the boom is lowered.", "[Ports001, 5.2.4.1]";
    T_UP: "T.up" "T_(arrow.t)" N / KN, "Pull of the luffing tackle, with losses in the hoist rope, while the boom is raised.", "[Ports001, 5.1]";
    T_DOWN: "T.down" "T_(arrow.b)" N / KN, "Pull of the luffing tackle, with losses in the hoist rope, while the boom is lowered.", "[Ports001, 5.1]";
    S_L_UP: "S_l.up" "S_(l, arrow.t)" N / KN, "Pull of the luffing rope at its drum, with losses, while the boom is raised.", "[Ports001, 5.1]";
    S_L_DOWN: "S_l.down" "S_(l, arrow.b)" N / KN, "Pull of the luffing rope at its drum, with losses, while the boom is lowered.", "[Ports001, 5.1]";

    // In motion.
    J_B: "J_b" "J_b" KG_M2 / T_M2 [not_negative], "Inertia of the boom about its centre of gravity.", "input";
    MASS_B: "mass_b" "m_b" KG / T, "Mass of the boom: weight over g.", "derived";
    S_BX: "S_b.x" "x_S" M / M, "Centre of gravity of the boom, forward of O1.", "derived";
    S_BY: "S_b.y" "y_S" M / M, "Centre of gravity of the boom, above O1.", "derived";
    DH_S: "dh_S" "h'_S" M / M, "Change of the hoist rope's lever arm for one radian of the boom.", "derived";
    I_RB: "I_rb" "I_b" KG_M2 / T_M2, "Inertia of the boom about its foot.", "Lagrange";
    DI_RB: "dI_rb" "I'_b" KG_M2 / T_M2, "Change of the boom's inertia for one radian of it.", "Lagrange";
    M_BO: "M_bO" "M_(b O)" N_M / KN_M, "Moment of the boom's weight and inertia about O1; clockwise positive.", "Newton and Euler";
    T_DYN: "T_dyn" "T_\"dyn\"" N / KN, "Pull of the luffing tackle as motor and brake give it; zero where the tackle is slack.", "equations of motion";
    D_PHI: "der(phi)" "dot(phi)" RAD_PER_S / DEG_PER_S, "Rate of the boom's angle.", "state";
    D_OMEGA: "der(omega)" "dot(omega)" RAD_PER_S2 / RAD_PER_S2, "Angular acceleration of the boom.", "equations of motion";

    // The whole range of motion.
    R_MAX: "R_max" "R_max" M / M, "Greatest reach of the working range.", "derived";
    R_MIN: "R_min" "R_min" M / M, "Smallest reach of the working range.", "derived";
    DELTA_Y: "Delta_Y" "Delta y_Q" M / M [not_negative], "Level error: greatest less smallest height of the load over the working range.", "[Ports001, 5.2.3]";
    EPSILON_Y: "epsilon_Y" "epsilon_Y" ONE / PERCENT [not_negative], "Level error over the reach covered.", "[Ports001, 5.2.3]";
    DELTA_L_T: "Delta_L_T" "Delta L_T" M / M [not_negative], "Stroke of the luffing tackle over the working range.", "derived";
    L_L_MAX: "l_l_max" "l_(l,max)" M / M [not_negative], "Rope that the luffing drum takes in over the working range.", "derived";
    PHI_T: "phi_T" "phi_T" RAD / DEG [infinite("where the tackle pulls as far as its line passes above the foot")], "Boom angle at which the tackle's pull vanishes under load: beyond it the boom falls back.", "[Ports001, 5.1]";
    PHI_T0: "phi_T0" "phi_(T 0)" RAD / DEG [infinite("where the tackle pulls as far as its line passes above the foot")], "Boom angle at which the tackle's pull vanishes without load: beyond it the boom falls back.", "[Ports001, 5.1]";
    M_Q_MAX: "M_Q_max" "M_(Q,max)" N_M / KN_M, "Greatest moment of the load in the working range, by amount.", "[Ports001, 5.2.3]";
    T_MAX: "T_max" "T_max" N / KN, "Greatest pull of the luffing tackle in the working range.", "equilibrium";
    S_L_MAX: "S_l_max" "S_(l,max)" N / KN, "Greatest pull of the luffing rope in the working range, with losses, while the boom is raised.", "equilibrium";
    N_B_MAX: "N_b_max" "N_(b,max)" N / KN, "Greatest axial force in the boom in the working range, by amount; tension positive.", "equilibrium";
    P_L_MAX: "P_l_max" "P_(l,max)" W / KW, "Greatest luffing power in the working range, by amount.", "derived";

    FROM: "from" "phi_a" RAD / DEG, "Angle of the boom at the start of the working range.", "input";
    TO: "to" "phi_e" RAD / DEG, "Angle of the boom at the end of the working range.", "input";
    AGREEMENT: "agreement" "delta" ONE / ONE, "Difference of two independent ways, relative to the largest value.", "derived";
}

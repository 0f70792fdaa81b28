//! Every quantity of the boom with a curved trunk, besides those of the boom's weight and angle, which balances share.

use std::f64::consts::FRAC_PI_2;

use crate::kernel::symbol::symbols;

pub use crate::balance::symbols::{CHI_B, G_B, R_B};

symbols! {
    OMEGA: "omega" "omega" RAD_PER_S / DEG_PER_S, "Angular velocity of the boom; positive raises it.", "[Ports001, 5.2.3.3]";
    Q: "Q" "Q" N / KN [not_negative], "Weight of the load, downwards positive.", "[Ports001, 5.2.3.3]";

    // Bars and tie.
    B: "b" "b" M / M [positive], "Length of the boom from its foot O1 to its head B.", "[Ports001, 5.10.1.1]";
    A: "a" "a" M / M [positive], "Length of the trunk from B to its head A.", "[Ports001, 5.10.1.1]";
    L_T: "L_t" "L_t" M / M [positive], "Length of the tie from its clamp on the tail to its point O3 of the frame.", "[Ports001, 5.2.4.3]";
    O3_X: "O3_x" "x_(O 3)" M / M, "The tie's point O3 of the frame, forward of O1.", "[Ports001, 5.2.4.3]";
    O3_Y: "O3_y" "y_(O 3)" M / M, "The tie's point O3 of the frame, above O1.", "[Ports001, 5.2.4.3]";
    X_8: "X_8" "X_8" M / M, "Distance of the boom's foot O1 in front of the slewing axis.", "[Ports001, 5.2.3.3]";
    G_T: "G_t" "G_t" N / KN [not_negative], "Weight of the trunk.", "[Ports001, 5.10.3.4]";
    R_T: "r_t" "r_t" M / M [not_negative], "Distance of the trunk's centre of gravity from B.", "[Ports001, 5.10.3.4]";
    CHI_T: "chi_t" "chi_t" RAD / DEG, "Angle from the trunk's line from B to A to its centre of gravity, counter-clockwise positive.", "[Ports001, 5.10.3.4]";

    // Tail, in the trunk's own frame: from B, along the line to A and square to it.
    Z_X: "Z_x" "x_Z" M / M, "Centre Z of the tail's arc, from B along the trunk's line towards A.", "[Ports001, 5.2.4.3]";
    Z_Y: "Z_y" "y_Z" M / M, "Centre Z of the tail's arc, square to the trunk's line, upper side positive.", "[Ports001, 5.2.4.3]";
    RHO: "rho" "rho" M / M [positive], "Radius of the tail's arc.", "[Ports001, 5.2.4.3]";
    ZETA_F: "zeta_f" "zeta_f" RAD / DEG, "Direction from Z to the front end of the tail, counter-clockwise from the trunk's line.", "[Ports001, 5.2.4.3]";
    ZETA_R: "zeta_r" "zeta_r" RAD / DEG, "Direction from Z to the rear end of the tail, counter-clockwise from the trunk's line.", "[Ports001, 5.2.4.3]";
    X_T: "x_t" "x_t" M / M, "Point of the tail, from B along the trunk's line towards A.", "[Ports001, 5.2.4.3]";
    Y_T: "y_t" "y_t" M / M, "Point of the tail, square to the trunk's line, upper side positive.", "[Ports001, 5.2.4.3]";
    B_T: "b_t" "b_t" M / MM [positive], "Width of the tie on the tail.", "[Ports001, 5.2.4.3]";
    W_A: "w_a" "w_a" M / M [not_negative], "Length of the tail from end to end.", "derived";

    // Closure by the length of the tie.
    B_X: "B.x" "x_B" M / M, "Head B of the boom, forward of O1.", "derived";
    B_Y: "B.y" "y_B" M / M, "Head B of the boom, above O1.", "derived";
    D_X: "d.x" "d_x" M / M, "From B to O3, forward component.", "derived";
    D_Y: "d.y" "d_y" M / M, "From B to O3, upward component.", "derived";
    D_2: "d2" "d^2" M2 / M2, "Square of the distance of B and O3.", "derived";
    D_O3: "d_O3" "d_(O 3)" M / M, "Distance of B and O3.", "derived";
    ZETA_0: "zeta_0" "zeta_0" RAD / DEG, "Direction from Z to the point of contact, found by Newton's method.", "derived";
    U0_X: "u_0.x" "u_(0 x)" ONE / ONE, "Direction of the free tie as found, along the trunk's line.", "derived";
    U0_Y: "u_0.y" "u_(0 y)" ONE / ONE, "Direction of the free tie as found, square to the trunk's line.", "derived";
    C0_X: "c_0.x" "c_(0 x)" M / M, "Point of contact as found, along the trunk's line.", "derived";
    C0_Y: "c_0.y" "c_(0 y)" M / M, "Point of contact as found, square to the trunk's line.", "derived";
    W_0: "w_0" "w_0" M / M, "Length of the tie on the tail as found.", "derived";
    RHO_0: "rho_0" "rho_0" M / M, "Radius of the tail at the point of contact as found.", "derived";
    DRHO_0: "drho_0" "rho'_0" M / M, "Change of the tail's radius for one radian of its turn.", "derived";
    F_0: "f_0" "f_0" M / M, "Free part of the tie as found.", "derived";
    H_0: "h_0" "h_0" M / M, "Lever arm of the tie about B as found.", "derived";
    V0_X: "v_0.x" "v_(0 x)" M / M, "From B to the end of the tie as found, along the trunk's line.", "derived";
    V0_Y: "v_0.y" "v_(0 y)" M / M, "From B to the end of the tie as found, square to the trunk's line.", "derived";
    DELTA_ZETA: "delta_zeta" "delta_zeta" RAD / DEG, "Last step of Newton's method: what is left is rounding.", "derived";

    // Position.
    U_X: "u.x" "u_x" ONE / ONE, "Direction of the free tie towards O3, along the trunk's line.", "derived";
    U_Y: "u.y" "u_y" ONE / ONE, "Direction of the free tie towards O3, square to the trunk's line.", "derived";
    C_X: "c.x" "c_x" M / M, "Point of contact T, from B along the trunk's line.", "derived";
    C_Y: "c.y" "c_y" M / M, "Point of contact T, square to the trunk's line.", "derived";
    W: "w" "w" M / M, "Length of the tie that lies on the tail, from the clamp to T.", "[Ports001, 5.2.4.3]";
    F: "f" "f" M / M, "Free part of the tie from T to O3.", "[Ports001, 5.2.4.3]";
    RHO_T: "rho_t" "rho_t" M / M, "Radius of the tail at T.", "[Ports001, 5.2.4.3]";
    V_X: "v.x" "v_x" M / M, "From B to O3, along the trunk's line.", "derived";
    V_Y: "v.y" "v_y" M / M, "From B to O3, square to the trunk's line.", "derived";
    K_X: "k.x" "k_x" ONE / ONE, "Direction of the trunk from B to A, forward component.", "derived";
    K_Y: "k.y" "k_y" ONE / ONE, "Direction of the trunk from B to A, upward component.", "derived";
    ALPHA: "alpha" "alpha" RAD / DEG, "Angle of the trunk's line from B to A above the horizontal.", "[Ports001, 5.2.3.3]";
    A_X: "A.x" "x_A" M / M, "Head A of the trunk, forward of O1.", "[Ports001, 5.2.3.3]";
    A_Y: "A.y" "y_A" M / M, "Head A of the trunk, above O1; the load keeps its distance below it.", "[Ports001, 5.2.3.3]";
    T_X: "T.x" "x_T" M / M, "Point of contact T, where the tie leaves the tail, forward of O1.", "[Ports001, 5.2.3.3]";
    T_Y: "T.y" "y_T" M / M, "Point of contact T, where the tie leaves the tail, above O1.", "[Ports001, 5.2.3.3]";
    E_TX: "e_t.x" "e_x" ONE / ONE, "Direction of the free tie from T to O3, forward component.", "derived";
    E_TY: "e_t.y" "e_y" ONE / ONE, "Direction of the free tie from T to O3, upward component.", "derived";
    R: "R" "R" M / M, "Reach: distance of A from the slewing axis.", "derived";
    H_T: "h_t" "h_t" M / M, "Lever arm of the tie about B; positive where its pull raises A.", "[Ports001, 5.2.3.3]";
    MU: "mu" "mu" RAD / DEG [from_to(0.0, FRAC_PI_2)], "Transmission angle between the free tie and the line from B to T, 0 to 90 deg.", "derived";

    // Velocity.
    H_O: "h_O" "h_O" M / M, "Lever arm of the tie about O1; positive where its pull raises the boom.", "derived";
    I_2: "i_2" "i_2" ONE / ONE, "Trunk's angular velocity over the boom's.", "derived";
    P_X: "P.x" "x_P" M / M [infinite("where the boom is parallel to the tie")], "Instantaneous centre of the trunk, forward of O1: on the lines of boom and free tie.", "[Ports001, 5.2.3.3]";
    P_Y: "P.y" "y_P" M / M [infinite("where the boom is parallel to the tie")], "Instantaneous centre of the trunk, above O1.", "[Ports001, 5.2.3.3]";
    DA_X: "dA.x" "x'_A" M / M, "Forward travel of A for one radian of the boom.", "derived";
    DA_Y: "dA.y" "y'_A" M / M, "Rise of A for one radian of the boom.", "derived";
    V_AX: "V_AX" "V_(A X)" M_PER_S / M_PER_S, "Horizontal velocity of A, forward positive.", "derived";
    V_AY: "V_AY" "V_(A Y)" M_PER_S / M_PER_S, "Vertical velocity of A, upward positive.", "derived";
    OMEGA_2: "omega_2" "omega_2" RAD_PER_S / DEG_PER_S, "Angular velocity of the trunk, counter-clockwise positive.", "derived";

    // Moments about O1.
    M_Q: "M_Q" "M_Q" N_M / KN_M, "Moment of the load by virtual work, for the boom's angle; positive lowers the boom.", "[Ports001, 5.9]";
    M_Q_P: "M_Q.P" "M_(Q,P)" N_M / KN_M, "The same by the instantaneous centre.", "[Ports001, 5.9]";
    S_BX: "S_b.x" "x_(S b)" M / M, "Centre of gravity of the boom, forward of O1.", "derived";
    S_BY: "S_b.y" "y_(S b)" M / M, "Centre of gravity of the boom, above O1.", "derived";
    S_TX: "S_t.x" "x_(S t)" M / M, "Centre of gravity of the trunk, forward of B.", "derived";
    S_TY: "S_t.y" "y_(S t)" M / M, "Centre of gravity of the trunk, above B.", "derived";
    M_G: "M_G" "M_G" N_M / KN_M, "Moment of the weights of boom and trunk, for the boom's angle; positive lowers the boom.", "virtual work";
    M_D: "M_D" "M_D" N_M / KN_M, "Moment that the drive must give to the boom about O1; positive raises it.", "equilibrium";
    P_D: "P_D" "P_D" W / KW, "Power of the drive; positive where it gives it.", "equilibrium";

    // Forces, of rest.
    M_B: "M_B" "M_B" N_M / KN_M, "Moment of load and own weight of the trunk about B; positive lowers A.", "equilibrium";
    N_T: "N_t" "N_t" N / KN, "Force in the tie; negative where it would have to push: it is slack, and does not hold this position.", "equilibrium";
    F_BX: "F_B.x" "F_(B x)" N / KN, "Force of the boom on the trunk at B, forward.", "equilibrium";
    F_BY: "F_B.y" "F_(B y)" N / KN, "Force of the boom on the trunk at B, upward.", "equilibrium";
    F_O1X: "F_O1.x" "F_(O 1 x)" N / KN, "Force of the frame on the boom at O1, forward.", "equilibrium";
    F_O1Y: "F_O1.y" "F_(O 1 y)" N / KN, "Force of the frame on the boom at O1, upward.", "equilibrium";
    Q_T: "q_t" "q_t" N_PER_M / KN_PER_M, "Line load of the tie on the tail at T.", "equilibrium";
    P_T: "p_t" "p_t" PA / MPA, "Pressure of the tie on the tail at T.", "equilibrium";

    // In motion.
    J_B: "J_b" "J_b" KG_M2 / T_M2 [not_negative], "Inertia of the boom about its centre of gravity.", "input";
    J_T: "J_t" "J_t" KG_M2 / T_M2 [not_negative], "Inertia of the trunk about its centre of gravity.", "input";
    MASS_B: "mass_b" "m_b" KG / T, "Mass of the boom: weight over g.", "derived";
    MASS_T: "mass_t" "m_t" KG / T, "Mass of the trunk, with the load where it hangs on no rope: weight over g.", "derived";
    J_TQ: "J_tQ" "J_(t Q)" KG_M2 / T_M2, "Inertia of the trunk with the load about their common centre of gravity.", "derived";
    B_E: "b_e" "b_e" M / M, "Head B of the boom from O1, along the free tie.", "derived";
    T_E: "t_e" "t_e" M / M, "Point of contact T from B, along the free tie.", "derived";
    DPSI_T: "dpsi_t" "psi'_t" ONE / ONE, "Turning of the free tie over that of the boom.", "derived";
    DI_2: "di_2" "i'_2" ONE / ONE, "Change of the ratio of the angular velocities for one radian of the boom.", "derived";
    DS_BX: "dS_b.x" "x'_(S b)" M / M, "Forward travel of the boom's centre of gravity for one radian of the boom.", "derived";
    DS_BY: "dS_b.y" "y'_(S b)" M / M, "Rise of the boom's centre of gravity for one radian of the boom.", "derived";
    S_MX: "S_m.x" "x_m" M / M, "Centre of gravity of the trunk, with the load where it hangs on no rope, forward of B.", "derived";
    S_MY: "S_m.y" "y_m" M / M, "Centre of gravity of the trunk, with the load where it hangs on no rope, above B.", "derived";
    DS_MX: "dS_m.x" "x'_m" M / M, "Forward travel of this centre of gravity for one radian of the boom.", "derived";
    DS_MY: "dS_m.y" "y'_m" M / M, "Rise of this centre of gravity for one radian of the boom.", "derived";
    DDS_MX: "ddS_m.x" "x''_m" M / M, "Change of its forward travel for one radian of the boom.", "derived";
    DDS_MY: "ddS_m.y" "y''_m" M / M, "Change of its rise for one radian of the boom.", "derived";
    I_RB: "I_rb" "I_b" KG_M2 / T_M2, "Inertia of the boom, reduced to its angle.", "Lagrange";
    DI_RB: "dI_rb" "I'_b" KG_M2 / T_M2, "Change of the boom's reduced inertia for one radian of it.", "Lagrange";
    I_RT: "I_rt" "I_t" KG_M2 / T_M2, "Inertia of the trunk, reduced to the boom's angle.", "Lagrange";
    DI_RT: "dI_rt" "I'_t" KG_M2 / T_M2, "Change of the trunk's reduced inertia for one radian of the boom.", "Lagrange";
    F_ITX: "F_it.x" "F_(i t x)" N / KN, "Inertia of the trunk, forward; with the load where it hangs on no rope.", "Newton and Euler";
    F_ITY: "F_it.y" "F_(i t y)" N / KN, "Weight and inertia of the trunk, upward; with the load where it hangs on no rope.", "Newton and Euler";
    M_TB: "M_tB" "M_(t B)" N_M / KN_M, "Moment of the rope and of the trunk's weight and inertia about B; clockwise positive.", "Newton and Euler";
    M_BO: "M_bO" "M_(b O)" N_M / KN_M, "Moment of the boom's weight and inertia about O1; clockwise positive.", "Newton and Euler";
    Z_TIE: "z.tie" "z_t" N / KN, "Falls below zero where the tie would have to push: there this motion ends.", "event";
    D_PHI: "der(phi)" "dot(phi)" RAD_PER_S / DEG_PER_S, "Rate of the boom's angle.", "state";
    D_OMEGA: "der(omega)" "dot(omega)" RAD_PER_S2 / RAD_PER_S2, "Angular acceleration of the boom.", "equations of motion";

    // The whole range of motion.
    R_MAX: "R_max" "R_max" M / M, "Greatest reach of the working range.", "derived";
    R_MIN: "R_min" "R_min" M / M, "Smallest reach of the working range.", "derived";
    DELTA_Y: "Delta_Y" "Delta y_A" M / M [not_negative], "Level error: greatest less smallest height of the head over the working range.", "[Ports001, 5.2.4.3]";
    EPSILON_Y: "epsilon_Y" "epsilon_Y" ONE / PERCENT [not_negative], "Level error over the reach covered.", "[Ports001, 5.2.4.3]";
    W_MAX: "w_max" "w_max" M / M, "Greatest length of the tie on the tail in the working range.", "derived";
    W_MIN: "w_min" "w_min" M / M, "Smallest length of the tie on the tail in the working range.", "derived";
    MU_MIN: "mu_min" "mu_min" RAD / DEG [from_to(0.0, FRAC_PI_2)], "Smallest transmission angle of the working range.", "derived";
    V_AX_MAX: "V_AX_max" "V_(A X,max)" M_PER_S / M_PER_S, "Greatest horizontal velocity of A in the working range, by amount.", "derived";
    M_Q_MAX: "M_Q_max" "M_(Q,max)" N_M / KN_M, "Greatest moment of the load in the working range, by amount.", "[Ports001, 5.9]";
    M_D_MAX: "M_D_max" "M_(D,max)" N_M / KN_M, "Greatest moment of the drive in the working range, by amount.", "equilibrium";
    N_T_MAX: "N_t_max" "N_(t,max)" N / KN, "Greatest force in the tie in the working range.", "equilibrium";
    N_T_MIN: "N_t_min" "N_(t,min)" N / KN, "Smallest force in the tie in the working range.", "equilibrium";
    Q_T_MAX: "q_t_max" "q_(t,max)" N_PER_M / KN_PER_M, "Greatest line load of the tie on the tail in the working range.", "equilibrium";
    P_T_MAX: "p_t_max" "p_(t,max)" PA / MPA, "Greatest pressure of the tie on the tail in the working range.", "equilibrium";

    FROM: "from" "phi_a" RAD / DEG, "Angle of the boom at the start of the working range.", "input";
    TO: "to" "phi_e" RAD / DEG, "Angle of the boom at the end of the working range.", "input";
    AGREEMENT: "agreement" "delta" ONE / ONE, "Difference of two independent ways, relative to the largest value.", "derived";
}

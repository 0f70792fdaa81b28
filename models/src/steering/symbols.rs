//! Every quantity of the steering.

use crate::symbol::symbols;

symbols! {
    // Command and motion.
    THETA_B: "theta_b" "theta_b" RAD / DEG, "Commanded angle of the base group, counter-clockwise from straight ahead.", "[Zhang2016, 2]";
    R_T: "R_t" "R_t" M / M, "Turning radius: from the machine's middle line to the turning centre, left positive.", "derived";
    OMEGA_S: "omega_s" "omega_s" RAD_PER_S / DEG_PER_S, "Steering speed: rate of the commanded angle.", "input";
    V_T: "v_t" "v_t" M_PER_S / M_PER_MIN, "Travel speed: that of the fastest group; positive travels forward.", "input";
    THETA: "theta" "theta_i" RAD / DEG, "Heading of a group, counter-clockwise from straight ahead.", "[Zhang2016, eq. 1-9]";
    V: "v" "v_i" M_PER_S / M_PER_MIN, "Rolling speed of a group along its heading; negative rolls backwards.", "rigid body";
    OMEGA: "omega" "omega" RAD_PER_S / DEG_PER_S, "Angular velocity of the machine, counter-clockwise positive.", "rigid body";
    V_MX: "v_M.x" "v_(M x)" M_PER_S / M_PER_MIN, "Velocity of the machine's middle, forward.", "rigid body";
    V_MY: "v_M.y" "v_(M y)" M_PER_S / M_PER_MIN, "Velocity of the machine's middle, to the left.", "rigid body";
    X_M: "M.x" "x_M" M / M, "Middle between foremost and rearmost axle line.", "derived";
    Y_M: "M.y" "y_M" M / M, "Middle between the outermost groups to the left and to the right.", "derived";
    O_X: "O.x" "x_O" M / M, "Turning centre, forward.", "[Zhang2016, Fig. 3]";
    O_Y: "O.y" "y_O" M / M, "Turning centre, to the left.", "[Zhang2016, Fig. 3]";
    DELTA: "delta" "delta_i" RAD / DEG, "Error of a group's angle.", "derived";

    // The paper's layout.
    S_T: "S" "S" M / M, "Track: distance between the groups of the two sides.", "[Zhang2016, Fig. 3]";
    L_1: "L_1" "L_1" M / M, "Half the distance between the inner axles.", "[Zhang2016, Fig. 3]";
    L_2: "L_2" "L_2" M / M, "Half the distance between the outer axles.", "[Zhang2016, Fig. 3]";
    THETA_1: "theta_1" "theta_1" RAD / DEG, "Angle of groups 1 and, with the opposite sign, 4.", "[Zhang2016, eq. 1, 7]";
    THETA_2: "theta_2" "theta_2" RAD / DEG, "Angle of groups 2 and, with the opposite sign, 3.", "[Zhang2016, eq. 2, 8]";
    THETA_5: "theta_5" "theta_5" RAD / DEG, "Angle of groups 5 and, with the opposite sign, 8.", "[Zhang2016, eq. 3, 5]";
    THETA_6: "theta_6" "theta_6" RAD / DEG, "Angle of groups 6 and, with the opposite sign, 7.", "[Zhang2016, eq. 4, 6]";
    THETA_P: "theta_P" "theta_P" RAD / DEG, "Amount of the outer groups' angle when turning on the spot.", "[Zhang2016, eq. 9]";

    // Resistance.
    W: "W" "W" N / KN, "Weight of machine and load.", "input";
    G: "G" "G_i" N / KN, "Vertical load of a group.", "[Zhang2016, 3]";
    F_T: "f_t" "f_t" ONE / ONE, "Coefficient of sliding friction between tyre and ground.", "[Zhang2016, 3]";
    P_T: "p_t" "p_t" PA / MPA, "Tyre pressure.", "[Zhang2016, 3]";
    K_V: "k_v" "k_v" ONE / ONE, "How many times the resistance to steering is smaller while travelling.", "[Zhang2016, 3]";
    T_R: "T_r" "T_r" N_M / KN_M, "Resistance of a group to steering at standstill.", "[Zhang2016, 3]";
    T_RX: "T_rx" "T_(r x)" N_M / KN_M, "Resistance of a group to steering while travelling.", "[Zhang2016, 3]";

    // Slewing ring.
    F_A: "F_a" "F_a" N / KN, "Vertical force on the slewing ring of a group.", "[Zhang2016, 4]";
    L_MAX: "L_max" "L_max" M / M, "Greatest arm of the vertical force about the ring's axis.", "[Zhang2016, 4]";
    F_S: "F_s" "F_s" ONE / ONE, "Safety factor of the slewing ring.", "[Zhang2016, 4]";
    K_TEST: "k_test" "k_\"test\"" ONE / ONE, "Test load over rated load.", "[Zhang2016, 4]";
    F_A_REF: "F_a_ref" "F'_a" N / KN, "Static reference force of the slewing ring.", "[Zhang2016, 4]";
    M_REF: "M_ref" "M'" N_M / KN_M, "Static reference moment of the slewing ring.", "[Zhang2016, 4]";
    F_BOLT: "F_bolt" "F_\"bolt\"" N / KN, "Total force on the bolts of the slewing ring.", "[Zhang2016, 4]";
    M_BOLT: "M_bolt" "M_\"bolt\"" N_M / KN_M, "Total moment on the bolts of the slewing ring.", "[Zhang2016, 4]";
    MU_R: "mu_r" "mu_r" ONE / ONE, "Coefficient of friction of the slewing ring.", "input";
    D_L: "D_L" "D_L" M / MM, "Diameter of the slewing ring's raceway.", "input";
    M_F: "M_f" "M_f" N_M / KN_M, "Friction moment of the slewing ring.", "makers' catalogues";

    // Cylinder.
    R_C: "R_c" "overline(o c)" M / M, "Arm of the cylinder on its group.", "[Zhang2016, Fig. 5]";
    ALPHA: "alpha" "alpha" RAD / DEG, "Angle of the arm with the group straight ahead, counter-clockwise from straight ahead.", "[Zhang2016, Fig. 5]";
    L_X: "l_x" "l_x" M / MM, "Stroke of the cylinder.", "[Zhang2016, 5.1]";
    L_A: "l_A" "l_A" M / MM, "Length of the retracted cylinder less its stroke.", "[Zhang2016, 5.1]";
    L_0: "l_0" "overline(b c)" M / M, "Length of the cylinder with the group straight ahead.", "[Zhang2016, Fig. 5]";
    C_X: "c.x" "x_c" M / M, "Rod end of the cylinder with the group straight ahead, forward of the group's axis.", "[Zhang2016, Fig. 5]";
    C_Y: "c.y" "y_c" M / M, "Rod end of the cylinder with the group straight ahead, left of the group's axis.", "[Zhang2016, Fig. 5]";
    B_X: "b.x" "x_b" M / M, "Foot of the cylinder, forward of the group's axis.", "[Zhang2016, Fig. 5]";
    B_Y: "b.y" "y_b" M / M, "Foot of the cylinder, left of the group's axis.", "[Zhang2016, Fig. 5]";
    L_C: "R" "R(theta)" M / M, "Length of the cylinder.", "[Zhang2016, Fig. 6]";
    OD: "od" "overline(o d)" M / M, "Lever arm of the cylinder: dR/dtheta, positive where a push turns the group counter-clockwise.", "[Zhang2016, Fig. 6]";
    M_OUT: "m_out" "m_\"out\"" M / MM, "Stroke left over when the cylinder is longest.", "[Zhang2016, 5.1]";
    M_IN: "m_in" "m_\"in\"" M / MM, "Stroke left over when the cylinder is shortest.", "[Zhang2016, 5.1]";

    // Sizing.
    T_G: "T_g" "T_g" N_M / KN_M, "Moment that the cylinder must overcome: resistance to steering and friction of the ring.", "[Zhang2016, 5.2]";
    F_G: "f_g" "f_g" N / KN, "Force of the cylinder.", "[Zhang2016, 5.2]";
    P: "p" "p" PA / MPA, "Oil pressure.", "[Zhang2016, 5.3]";
    D: "d" "d" M / MM, "Diameter of the piston rod.", "[Zhang2016, 5.3]";
    D_G_MIN: "D_g_min" "D_(g,min)" M / MM, "Smallest bore that pulls with the force.", "[Zhang2016, 5.3]";
    D_G: "D_g" "D_g" M / MM, "Bore of the cylinder.", "[ISO 3320]";
    A_G: "A_g" "A_g" M2 / M2, "Working area of the cylinder: bore where it lengthens, annulus where it shortens.", "derived";
    Q_G: "q_g" "q_g" M3_PER_S / L_PER_MIN, "Oil flow to the cylinder; negative where it shortens.", "derived";
    N: "n" "n" PER_S / PER_MIN, "Speed of the pump.", "input";
    ETA: "eta_v" "eta_v" ONE / ONE, "Volumetric efficiency of the pump.", "input";
    V_P: "V_p" "V_p" M3 / CM3, "Displacement of the pump, per turn.", "derived";
    K_R: "k_r" "k_r" ONE / ONE, "Pressure of the relief valve over the working pressure.", "input";
    P_R: "p_r" "p_r" PA / MPA, "Pressure at which the relief valve opens.", "derived";
    E: "E" "E" PA / MPA, "Young's modulus of the rod.", "input";
    L_K: "l_k" "l_k" M / M, "Buckling length of the cylinder.", "input";
    NU: "nu" "nu" ONE / ONE, "Safety against buckling.", "input";
    F_K: "F_k" "F_k" N / KN, "Push that the rod bears with its safety against buckling.", "Euler";
}

//! Every quantity of the steering.

use std::f64::consts::{PI, TAU};

use crate::kernel::symbol::{Enumeration, symbols};

pub static MODES: Enumeration = Enumeration {
    name: "Mode",
    items: &[
        ("straight", "All groups straight ahead."),
        ("crab", "All groups at the commanded angle."),
        ("crosswise", "All groups at a right angle; positive travel goes left."),
        ("front_axle", "Turning centre on the rearmost axle line."),
        ("rear_axle", "Turning centre on the foremost axle line."),
        ("all_wheel", "Turning centre midway between foremost and rearmost axle."),
        ("pivot", "About the machine's middle; positive travel turns left."),
        ("corner", "About a corner of the outline."),
        ("free", "About the commanded centre."),
    ],
};

pub static COMMANDS: Enumeration = Enumeration {
    name: "Command",
    items: &[
        ("angle", "Angle of the base group: theta_b."),
        ("radius", "From the machine's middle line to the turning centre: R_t."),
        ("centre", "The turning centre: x_c, y_c."),
    ],
};

pub static CORNERS: Enumeration = Enumeration {
    name: "Corner",
    items: &[
        ("front_left", "Front left."),
        ("rear_left", "Rear left."),
        ("rear_right", "Rear right."),
        ("front_right", "Front right."),
    ],
};

/// Farther from the origin than this, in m, no group stands.
pub const FARTHEST: f64 = 1e4;

symbols! {
    // Command and motion.
    THETA_B: "theta_b" "theta_b" RAD / DEG [from_to(-PI, PI)], "Commanded angle of the base group, counter-clockwise from straight ahead.", "[Zhang2016, 2]";
    R_T: "R_t" "R_t" M / M, "Commanded radius: from the machine's middle line to the turning centre, left positive.", "derived";
    X_C: "x_c" "x_(O c)" M / M, "Commanded turning centre, forward.", "input";
    Y_C: "y_c" "y_(O c)" M / M, "Commanded turning centre, to the left.", "input";
    MODE: "mode" "m" ONE / ONE [one_of(&MODES)], "Travel mode.", "[Zhang2016, 2]";
    COMMAND: "command" "k_c" ONE / ONE [one_of(&COMMANDS)], "What commands front-axle, rear-axle and all-wheel steering.", "input";
    CORNER: "corner" "k_e" ONE / ONE [one_of(&CORNERS)], "Corner of the outline about which the mode corner turns.", "input";
    X: "x" "x_i" M / M [from_to(-FARTHEST, FARTHEST)], "Axis of a steered group, forward.", "input";
    Y: "y" "y_i" M / M [from_to(-FARTHEST, FARTHEST)], "Axis of a steered group, to the left.", "input";
    X_B: "x_b" "x_B" M / M, "Axis of the base group, forward.", "input";
    Y_B: "y_b" "y_B" M / M, "Axis of the base group, to the left.", "input";
    X_F: "x_F" "x_F" M / M, "Foremost axle line.", "derived";
    X_R: "x_R" "x_R" M / M, "Rearmost axle line.", "derived";
    Y_L: "y_L" "y_L" M / M, "Outermost group to the left.", "derived";
    Y_R: "y_R" "y_R" M / M, "Outermost group to the right.", "derived";
    E_F: "e_F" "x_(e F)" M / M, "Front of the machine's outline.", "input";
    E_R: "e_R" "x_(e R)" M / M, "Rear of the machine's outline.", "input";
    E_LEFT: "e_left" "y_(e L)" M / M, "Left side of the machine's outline.", "input";
    E_RIGHT: "e_right" "y_(e R)" M / M, "Right side of the machine's outline.", "input";
    THETA_MIN: "theta_min" "theta_min" RAD / DEG, "Greatest angle that a group turns clockwise, negative.", "input";
    THETA_MAX: "theta_max" "theta_max" RAD / DEG, "Greatest angle that a group turns counter-clockwise.", "input";
    FORBIDDEN_FROM: "forbidden_from" "theta_(f i)" RAD / DEG, "Start of a range of angles through which a group must not turn.", "input";
    FORBIDDEN_TO: "forbidden_to" "theta_(g i)" RAD / DEG, "End of this range.", "input";
    OMEGA_S: "omega_s" "omega_s" RAD_PER_S / DEG_PER_S, "Steering speed: rate of the commanded angle.", "input";
    V_T: "v_t" "v_t" M_PER_S / M_PER_MIN, "Travel speed: that of the fastest group; positive travels forward.", "input";
    THETA: "theta" "theta_i" RAD / DEG, "Heading of a group, counter-clockwise from straight ahead.", "[Zhang2016, eq. 1-9]";
    V: "v" "v_i" M_PER_S / M_PER_MIN, "Rolling speed of a group along its heading; negative rolls backwards.", "rigid body";
    U_X: "u.x" "u_(x i)" M / M, "Rolling direction of a group, forward: what a turn about the centre gives it.", "rigid body";
    U_Y: "u.y" "u_(y i)" M / M, "Rolling direction of a group, to the left.", "rigid body";
    U: "u" "u_i" M / M, "Speed of a group over the turn about the centre.", "rigid body";
    U_MAX: "u_max" "u_max" M / M, "Greatest of these over all groups.", "rigid body";
    UD_X: "u_d.x" "u'_(x i)" M / M, "Change of the rolling direction with the commanded angle, forward.", "derived";
    UD_Y: "u_d.y" "u'_(y i)" M / M, "Change of the rolling direction with the commanded angle, to the left.", "derived";
    C_I: "c_i" "c_i" ONE / ONE, "Cosine of a group's heading.", "derived";
    S_I: "s_i" "s_i" ONE / ONE, "Sine of a group's heading.", "derived";
    THETA_DOT: "theta_dot" "omega_i" RAD_PER_S / DEG_PER_S, "Rate of a group's angle while the commanded angle moves at the steering speed.", "derived";
    MARGIN: "margin" "Delta theta" RAD / DEG, "Smallest angle that is left between a group and an end of its range; negative beyond it.", "derived";
    REACHABLE: "reachable" "r" ONE / ONE [boolean], "Whether every group can stand as commanded.", "derived";
    OMEGA: "omega" "omega" RAD_PER_S / DEG_PER_S, "Angular velocity of the machine, counter-clockwise positive.", "rigid body";
    V_MX: "v_M.x" "v_(M x)" M_PER_S / M_PER_MIN, "Velocity of the machine's middle, forward.", "rigid body";
    V_MY: "v_M.y" "v_(M y)" M_PER_S / M_PER_MIN, "Velocity of the machine's middle, to the left.", "rigid body";
    M_X: "M.x" "x_M" M / M, "Middle between foremost and rearmost axle line.", "derived";
    M_Y: "M.y" "y_M" M / M, "Middle between the outermost groups to the left and to the right.", "derived";
    O_X: "O.x" "x_O" M / M [infinite("where the machine does not turn")], "Turning centre, forward.", "[Zhang2016, Fig. 3]";
    O_Y: "O.y" "y_O" M / M [infinite("where the machine does not turn")], "Turning centre, to the left.", "[Zhang2016, Fig. 3]";
    O_AT_INFINITY: "O.at_infinity" "O_infinity" ONE / ONE [boolean], "Whether the turning centre lies at infinity.", "derived";
    R_O: "R_O" "R_O" M / M [infinite("where the machine does not turn")], "Turning radius: distance of the turning centre from the machine's middle.", "derived";
    R_IN: "R_in" "R_1" M / M [not_negative, infinite("where the machine does not turn")], "Inner radius of the lane that the outline sweeps.", "rigid body";
    R_OUT: "R_out" "R_2" M / M [not_negative, infinite("where the machine does not turn")], "Outer radius of the lane that the outline sweeps.", "rigid body";
    B_S: "b_s" "b_s" M / M, "Width of the lane that the outline sweeps.", "rigid body";
    E_O: "e_O" "e_O" M / M, "Greatest distance at which an axle line passes the turning centre.", "derived";
    FROM: "from" "theta_a" RAD / DEG, "Commanded angle at the start of the working range.", "input";
    TO: "to" "theta_e" RAD / DEG, "Commanded angle at the end of the working range.", "input";
    DELTA: "delta" "delta_i" RAD / DEG, "Greatest error of a group's angle.", "derived";
    RESOLUTION: "resolution" "q_e" RAD / DEG [from_to(0.0, 0.2)], "Step of the encoders of the groups' angles.", "input";
    DEAD_BAND: "dead_band" "b_v" M / MM [from_to(0.0, 1.0)], "Dead band of a cylinder: its stroke before its valve opens.", "input";
    SLIP_LIMIT: "slip_limit" "sigma_lim" ONE / PERCENT, "Slip that is allowed.", "input";
    SLIP_ALONE: "slip_alone" "sigma_(0 i)" ONE / PERCENT, "Slip of a group by its own error alone, were the machine to keep its motion.", "derived";
    SLIP: "slip" "sigma_i" ONE / PERCENT, "Slip of a group: its greatest sideways speed over the travel speed, for all signs of the angle errors.", "least squares";
    SLIP_MAX: "slip_max" "sigma_max" ONE / PERCENT, "Greatest slip of all groups.", "least squares";
    SLIP_WORK: "slip_work" "sigma_w" ONE / PERCENT, "Greatest slip of all groups in the working range.", "least squares";

    // Out of reach, and from mode to mode.
    THETA_BN: "theta_b_n" "theta_(b n)" RAD / DEG, "Angle that all groups can follow and that is nearest to the commanded one, or to the direction of travel of the modes straight and crosswise.", "derived";
    R_TN: "R_t_n" "R_(t n)" M / M, "Radius that all groups can follow and that is nearest to the commanded one.", "derived";
    X_C_N: "x_c_n" "x_(O n)" M / M, "Turning centre that all groups can follow and that is nearest to the commanded one, to the middle or to the corner, forward.", "derived";
    Y_C_N: "y_c_n" "y_(O n)" M / M, "Turning centre that all groups can follow, nearest to the one commanded, to the middle or to the corner, to the left.", "derived";
    THETA_N: "theta_n" "theta_(n i)" RAD / DEG, "Heading of a group at the nearest command that all groups can follow; straight ahead where there is none.", "derived";
    V_C_MAX: "v_c_max" "v_(c,max)" M_PER_S / MM_PER_S [above_to(0.0, 10.0)], "Speed limit of the steering cylinders.", "input";
    V_C_WORK: "v_c_work" "v_(c,w)" M_PER_S / MM_PER_S, "Greatest speed of a cylinder in the working range at the steering speed.", "derived";
    THETA_S: "theta_s" "theta_(s i)" RAD / DEG, "Set point of a group's heading: after a change of mode it moves to the new one within the cylinders' speed limit.", "derived";
    V_S: "v_s" "v_(s i)" M_PER_S / M_PER_MIN, "Set point of a group's rolling speed along its set point of heading; zero while the machine must stand.", "derived";
    T_X: "t_x" "t_x" S / S [infinite("where it is not possible")], "Duration of the last change of mode.", "derived";
    T_LEFT: "t_left" "t_r" S / S [infinite("where it is not possible")], "What is left of the duration of the change of mode.", "derived";
    T_C: "t_c" "t" S / S, "Time since the change of mode.", "derived";
    STAND: "stand" "k_s" ONE / ONE [boolean], "Whether the machine must stand during the last change of mode.", "derived";
    Q_X_MAX: "q_x_max" "q_(x,max)" M3_PER_S / L_PER_MIN, "Greatest oil flow of all cylinders together in a change of mode.", "derived";

    // The paper's layout.
    NUMBER: "number" "i" ONE / ONE, "Number of a group, in the order of the scene.", "input";
    S: "S" "S" M / M, "Track: distance between the groups of the two sides.", "[Zhang2016, Fig. 3]";
    L_1: "L_1" "L_1" M / M, "Half the distance between the inner axles.", "[Zhang2016, Fig. 3]";
    L_2: "L_2" "L_2" M / M, "Half the distance between the outer axles.", "[Zhang2016, Fig. 3]";
    THETA_1: "theta_1" "theta_1" RAD / DEG, "Angle of groups 1 and, with the opposite sign, 4.", "[Zhang2016, eq. 1, 7]";
    THETA_2: "theta_2" "theta_2" RAD / DEG, "Angle of groups 2 and, with the opposite sign, 3.", "[Zhang2016, eq. 2, 8]";
    THETA_5: "theta_5" "theta_5" RAD / DEG, "Angle of groups 5 and, with the opposite sign, 8.", "[Zhang2016, eq. 3, 5]";
    THETA_6: "theta_6" "theta_6" RAD / DEG, "Angle of groups 6 and, with the opposite sign, 7.", "[Zhang2016, eq. 4, 6]";
    THETA_P: "theta_P" "theta_P" RAD / DEG, "Amount of the outer groups' angle when turning on the spot.", "[Zhang2016, eq. 9]";

    // Resistance.
    W: "W" "W" N / KN [not_negative], "Weight of machine and load.", "input";
    X_G: "x_G" "x_G" M / M, "Centre of gravity, forward.", "input";
    Y_G: "y_G" "y_G" M / M, "Centre of gravity, to the left.", "input";
    G: "G" "G_i" N / KN [not_negative], "Vertical load of a group.", "[Zhang2016, 3]";
    F_T: "f_t" "f_t" ONE / ONE [from_to(0.0, 2.0), tunable], "Coefficient of sliding friction between tyre and ground.", "[Zhang2016, 3]";
    P_T: "p_t" "p_t" PA / MPA [above_to(0.0, 1e7), tunable], "Tyre pressure.", "[Zhang2016, 3]";
    K_V: "k_v" "k_v" ONE / ONE [from_to(1.0, 10.0), tunable], "Ratio of the resistance to steering at standstill to that while travelling.", "[Zhang2016, 3]";
    T_R: "T_r" "T_(r i)" N_M / KN_M, "Resistance of a group to steering at standstill.", "[Zhang2016, 3]";
    T_RX: "T_rx" "T_(r x i)" N_M / KN_M, "Resistance of a group to steering while travelling.", "[Zhang2016, 3]";

    // Slewing ring.
    F_A: "F_a" "F_a" N / KN, "Vertical force on the slewing ring of a group.", "[Zhang2016, 4]";
    L_MAX: "L_max" "L_max" M / M [from_to(0.0, 100.0)], "Greatest arm of the vertical force about the ring's axis.", "[Zhang2016, 4]";
    F_S: "F_s" "F_s" ONE / ONE [from_to(1.0, 10.0)], "Safety factor of the slewing ring.", "[Zhang2016, 4]";
    K_TEST: "k_test" "k_t" ONE / ONE [from_to(1.0, 10.0)], "Test load over rated load.", "[Zhang2016, 4]";
    F_A_REF: "F_a_ref" "F'_a" N / KN, "Static reference force of the slewing ring.", "[Zhang2016, 4]";
    M_REF: "M_ref" "M'" N_M / KN_M, "Static reference moment of the slewing ring.", "[Zhang2016, 4]";
    F_BOLT: "F_bolt" "F_b" N / KN, "Total force on the bolts of the slewing ring.", "[Zhang2016, 4]";
    M_BOLT: "M_bolt" "M_b" N_M / KN_M, "Total moment on the bolts of the slewing ring.", "[Zhang2016, 4]";
    POINT: "point" "i" ONE / ONE, "Number of a point of the load curves, of the ring and then of its bolts.", "input";
    F_CURVE: "F_curve" "F_(c i)" N / KN, "Force at a point of a load curve of the slewing ring.", "input";
    M_CURVE: "M_curve" "M_(c i)" N_M / KN_M, "Moment that may act with this force.", "input";
    M_RING: "M_ring" "M_(c r)" N_M / KN_M, "Moment that the ring bears with its reference force.", "[Zhang2016, 4]";
    M_BOLTS: "M_bolts" "M_(c b)" N_M / KN_M, "Moment that the bolts bear with their force.", "[Zhang2016, 4]";
    MU_R: "mu_r" "mu_r" ONE / ONE [from_to(0.0, 1.0)], "Coefficient of friction of the slewing ring.", "input";
    D_L: "D_L" "D_L" M / MM [above_to(0.0, 100.0)], "Diameter of the slewing ring's raceway.", "input";
    M_F: "M_f" "M_(f i)" N_M / KN_M, "Friction moment of a group's slewing ring.", "[Rothe Erde]";

    // Cylinder.
    R_C: "R_c" "overline(o c)" M / M [above_to(0.0, 10.0)], "Arm of the cylinder on its group.", "[Zhang2016, Fig. 5]";
    ALPHA: "alpha" "alpha" RAD / DEG [from_to(-TAU, TAU)], "Angle of the arm with the group straight ahead, counter-clockwise from straight ahead.", "[Zhang2016, Fig. 5]";
    L_X_NEXT: "l_x_next" "l_(x,n)" M / MM, "Shortest stroke of the example list that covers the range.", "[Zhang2016, 5.1]";
    L_X: "l_x" "l_x" M / MM [above_to(0.0, 10.0)], "Stroke of the cylinder.", "[Zhang2016, 5.1]";
    L_A: "l_A" "l_A" M / MM [from_to(0.0, 10.0)], "Length of the retracted cylinder less its stroke.", "[Zhang2016, 5.1]";
    L_0: "l_0" "overline(b c)" M / M, "Length of the cylinder with the group straight ahead.", "[Zhang2016, Fig. 5]";
    C_X: "c.x" "x_c" M / M, "Rod end of the cylinder with the group straight ahead, forward of the group's axis.", "[Zhang2016, Fig. 5]";
    C_Y: "c.y" "y_c" M / M, "Rod end of the cylinder with the group straight ahead, left of the group's axis.", "[Zhang2016, Fig. 5]";
    B_X: "b.x" "x_b" M / M, "Foot of the cylinder, forward of the group's axis.", "[Zhang2016, Fig. 5]";
    B_Y: "b.y" "y_b" M / M, "Foot of the cylinder, left of the group's axis.", "[Zhang2016, Fig. 5]";
    R: "R" "R_i" M / M, "Length of a group's cylinder.", "[Zhang2016, Fig. 6]";
    CT_X: "c_t.x" "x_(c i)" M / M, "Rod end of the cylinder with the group turned, forward of the group's axis.", "[Zhang2016, Fig. 6]";
    CT_Y: "c_t.y" "y_(c i)" M / M, "Rod end of the cylinder with the group turned, left of the group's axis.", "[Zhang2016, Fig. 6]";
    OD: "od" "d_(o i)" M / M, "Lever arm of a group's cylinder: dR/dtheta, positive where a push turns the group counter-clockwise.", "[Zhang2016, Fig. 6]";
    R_MAX: "R_max" "R_max" M / M, "Greatest length of a cylinder over its group's range.", "[Zhang2016, 5.1]";
    R_MIN: "R_min" "R_min" M / M, "Smallest length of a cylinder over its group's range.", "[Zhang2016, 5.1]";
    OD_MIN: "od_min" "d_(o,min)" M / M, "Smallest lever arm of a cylinder over its group's range, by amount.", "[Zhang2016, 5.2]";
    M_OUT: "m_out" "m_1" M / MM, "Stroke left over when the cylinder is longest.", "[Zhang2016, 5.1]";
    M_IN: "m_in" "m_2" M / MM, "Stroke left over when the cylinder is shortest.", "[Zhang2016, 5.1]";

    // Sizing.
    T_G: "T_g" "T_(g i)" N_M / KN_M, "Moment that a group's cylinder must overcome at standstill: resistance to steering and friction of the ring.", "[Zhang2016, 5.2]";
    T_GX: "T_gx" "T_(g x i)" N_M / KN_M, "Moment that the group's cylinder overcomes while travelling.", "[Zhang2016, 5.2]";
    F_GX: "f_gx" "f_(g x i)" N / KN, "Force of a group's cylinder while travelling.", "[Zhang2016, 5.2]";
    V_C: "v_c" "v_(c i)" M_PER_S / MM_PER_S, "Speed of a group's cylinder, lengthening positive.", "derived";
    Q_SUM: "q_sum" "q" M3_PER_S / L_PER_MIN, "Oil flow of all cylinders together, by amount.", "derived";
    F_G: "f_g" "f_(g i)" N / KN, "Force of a group's cylinder against the resistance at standstill, by amount.", "[Zhang2016, 5.2]";
    P: "p" "p" PA / MPA [above_to(0.0, 1e8)], "Oil pressure.", "[Zhang2016, 5.3]";
    D: "d" "d" M / MM, "Diameter of the piston rod.", "[Zhang2016, 5.3]";
    N_G: "n_G" "n_G" ONE / ONE, "Number of steered groups.", "derived";
    X_S: "x_S" "x_S" M / M, "Mean of the axes of all groups, forward.", "derived";
    Y_S: "y_S" "y_S" M / M, "Mean of the axes of all groups, to the left.", "derived";
    S_XX: "S_xx" "S_(x x)" M2 / M2, "Sum of the squares of the groups' distances from their mean, forward.", "derived";
    S_YY: "S_yy" "S_(y y)" M2 / M2, "Sum of the squares of the groups' distances from their mean, to the left.", "derived";
    S_XY: "S_xy" "S_(x y)" M2 / M2, "Sum of the products of the groups' distances from their mean, forward and to the left.", "derived";
    E_SX: "e_sx" "e_x" M / M, "Centre of gravity, forward of the mean of the axes.", "derived";
    E_SY: "e_sy" "e_y" M / M, "Centre of gravity, to the left of the mean of the axes.", "derived";
    D_SX: "d_sx" "d_x" M / M, "Axis of a group, forward of the mean of the axes.", "derived";
    D_SY: "d_sy" "d_y" M / M, "Axis of a group, to the left of the mean of the axes.", "derived";
    G_MAX: "G_max" "G_max" N / KN, "Greatest vertical load of a group.", "derived";
    T_G_MAX: "T_g_max" "T_(g,max)" N_M / KN_M, "Greatest moment that a cylinder must overcome at standstill.", "[Zhang2016, 5.2]";
    F_G_MAX: "f_g_max" "f_(g,max)" N / KN, "Greatest force of a cylinder: at the smallest lever arm, at standstill.", "[Zhang2016, 5.2]";
    F_G_WORK: "f_g_work" "f_(g,w)" N / KN, "Greatest force of a cylinder in the working range, at standstill.", "[Zhang2016, 5.2]";
    Q_MODE: "q_mode" "q_m" M3_PER_S / L_PER_MIN, "Greatest oil flow of all cylinders together in a mode, at the steering speed.", "derived";
    Q_MAX: "q_max" "q_max" M3_PER_S / L_PER_MIN, "Greatest oil flow of all cylinders together, of all modes at the steering speed.", "derived";
    MARGIN_MIN: "margin_min" "Delta theta_min" RAD / DEG, "Smallest angle that is left to an end of a group's range in the working range.", "derived";
    B_S_MAX: "b_s_max" "b_(s,max)" M / M, "Greatest width of the swept lane in the working range.", "rigid body";
    R_O_MIN: "R_O_min" "R_(O,min)" M / M [infinite("where the machine does not turn")], "Smallest turning radius in the working range.", "derived";
    RING_USE: "ring_use" "k_1" ONE / PERCENT, "Moment on the ring over what its load curve bears; infinite where the force alone is too great.", "[Zhang2016, 4]";
    BOLT_USE: "bolt_use" "k_2" ONE / PERCENT, "Moment on the bolts over what their load curve bears; infinite where the force alone is too great.", "[Zhang2016, 4]";
    AGREEMENT: "agreement" "delta" ONE / ONE, "Difference of two independent ways, relative to the largest value.", "derived";
    D_G_MIN: "D_g_min" "D_(g,min)" M / MM, "Smallest bore that pulls with the force.", "[Zhang2016, 5.3]";
    D_G_NEXT: "D_g_next" "D_(g,n)" M / MM, "Next bore of the series of ISO 3320.", "[ISO 3320]";
    D_G: "D_g" "D_g" M / MM, "Bore of the cylinder.", "[ISO 3320]";
    A_G: "A_g" "A_(g i)" M2 / M2, "Working area of the cylinder: bore where it lengthens, annulus where it shortens.", "derived";
    Q_G: "q_g" "q_(g i)" M3_PER_S / L_PER_MIN, "Oil flow to a group's cylinder; negative where it shortens.", "derived";
    N: "n" "n" PER_S / PER_MIN [above_to(0.0, 200.0)], "Speed of the pump.", "input";
    ETA_V: "eta_v" "eta_v" ONE / ONE [above_to(0.0, 1.0)], "Volumetric efficiency of the pump.", "input";
    V_P: "V_p" "V_p" M3 / CM3, "Displacement of the pump, per turn.", "derived";
    P_H: "P_h" "P_h" W / KW, "Hydraulic power of the greatest flow at the working pressure, without losses.", "derived";
    K_R: "k_r" "k_r" ONE / ONE [from_to(1.0, 2.0)], "Pressure of the relief valve over the working pressure.", "input";
    P_R: "p_r" "p_r" PA / MPA, "Pressure at which the relief valve opens.", "derived";
    E: "E" "E" PA / MPA [above_to(0.0, 1e12)], "Young's modulus of the rod.", "input";
    L_K: "l_k" "l_k" M / M, "Buckling length of the cylinder.", "input";
    NU: "nu" "nu" ONE / ONE [from_to(1.0, 20.0)], "Safety against buckling.", "input";
    F_K: "F_k" "F_k" N / KN, "Permissible buckling load of the rod, its safety included.", "Euler";
    LAMBDA: "lambda" "lambda" ONE / ONE, "Slenderness of the rod: its buckling length over its radius of gyration, a fourth of its diameter.", "Euler";
    SIGMA_E: "sigma_E" "sigma_E" PA / MPA, "Critical stress of the rod; the buckling load holds where it is below the steel's limit of proportionality.", "Euler";
}

//! Every quantity of a mobile crane on its supports.

use std::f64::consts::FRAC_PI_2;

pub use crate::kernel::gravity::G;
use crate::kernel::symbol::{Enumeration, Range, symbols};

/// What a rated load is limited by.
pub static GOVERNING: Enumeration = Enumeration {
    name: "Governing",
    items: &[
        ("stability", "The load that would tip the crane."),
        ("support", "What a support can bear."),
        ("boom", "Strength of the boom."),
        ("rope", "Strength of the hoist rope."),
        ("tackle", "Strength of hook block and tackle."),
        ("cylinder", "Strength of the luffing cylinder."),
        (
            "forbidden",
            "Nothing is permitted: without its load the crane is not safe against tipping backward.",
        ),
    ],
};

symbols! {
    // Given.
    PSI: "psi" "psi" RAD / DEG, "Slewing angle of the boom from the carrier's front; positive counter-clockwise, seen from above.", "input";
    OMEGA: "omega" "omega" RAD_PER_S / DEG_PER_S, "Angular velocity of slewing.", "input";
    FROM: "from" "psi_a" RAD / DEG, "Slewing angle at the start of the working range.", "input";
    TO: "to" "psi_e" RAD / DEG, "Slewing angle at the end of the working range.", "input";
    X: "x" "x_i" M / M, "Support, forward of the slewing axis.", "input";
    Y: "y" "y_i" M / M, "Support, to the left of the slewing axis.", "input";
    N_CAP: "N_cap" "N_(\"cap\" i)" N / KN [positive], "Force that the ground may give to a support at most.", "input";
    A_P: "A_p" "A_p" M2 / M2 [positive], "Area of the pad under a support.", "input";
    G_C: "G_c" "G_(c i)" N / KN [not_negative], "Weight of a body of the carrier.", "input";
    X_C: "x_c" "x_(c i)" M / M, "Centre of gravity of a body of the carrier, forward of the slewing axis.", "input";
    Y_C: "y_c" "y_(c i)" M / M, "Centre of gravity of a body of the carrier, to the left of the slewing axis.", "input";
    H_C: "h_c" "h_(c i)" M / M, "Centre of gravity of a body of the carrier, above the ground.", "input";
    G_U: "G_u" "G_(u i)" N / KN [not_negative], "Weight of a body of the upper works.", "input";
    R_U: "r_u" "r_(u i)" M / M, "Centre of gravity of a body of the upper works, in front of the slewing axis; negative behind it.", "input";
    H_U: "h_u" "h_(u i)" M / M, "Centre of gravity of a body of the upper works, above the ground.", "input";
    G_P: "G_p" "G_(p i)" N / KN [not_negative], "Weight of a part of the boom.", "input";
    Q_P: "q_p" "q_(p i)" N_PER_M / KN_PER_M [not_negative], "Weight that a part of the boom gains for each metre of its extension: inserts of a lattice boom.", "input";
    S_P: "s_p" "s_(p i)" M / M, "Centre of gravity of a part of the boom from the foot, along the boom, at its shortest.", "input";
    KAPPA_P: "kappa_p" "kappa_(p i)" ONE / ONE [from_to(0.0, 1.0)], "Part of the boom's extension by which the centre of gravity of a part moves outwards: 0 of the base, 1 of the head.", "input";
    X_F: "x_F" "x_F" M / M, "Boom foot, in front of the slewing axis.", "input";
    H_F: "h_F" "h_F" M / M [not_negative], "Boom foot, above the ground.", "input";
    D_A: "d_A" "d_A" M / M, "Distance of the load's rope from the boom's line at the head; positive on its lower side.", "input";
    L_0: "l_0" "l_0" M / M [positive], "Length of the boom at its shortest, from foot to head.", "input";
    PHI_MIN: "phi_min" "phi_min" RAD / DEG [from_to(-FRAC_PI_2, FRAC_PI_2)], "Least angle of the boom.", "input";
    PHI_MAX: "phi_max" "phi_max" RAD / DEG [from_to(-FRAC_PI_2, FRAC_PI_2)], "Greatest angle of the boom.", "input";
    L: "l" "l" M / M [positive], "Length of the boom from foot to head.", "input";
    PHI: "phi" "phi" RAD / DEG, "Angle of the boom from the horizontal.", "derived";
    R: "R" "R" M / M, "Reach: distance of the load from the slewing axis, without load on level ground.", "derived";
    Q: "Q" "Q" N / KN [not_negative], "Weight of the load on hook or in grab.", "input";
    G_H: "G_h" "G_h" N / KN [not_negative], "Weight of hook block or grab with its ropes, which counts as load.", "input";
    PHI_Q: "phi_Q" "phi_Q" ONE / ONE [within(Range::new(1.0, 10.0)), unconfirmed], "Impact factor of load and grab, 1 of a hook.", "input";
    GAMMA_S: "gamma_s" "gamma_\"s\"" RAD / DEG [from_to(0.0, 0.5)], "Slope on which the crane stands, downhill in the direction of the boom; uphill for tipping backward.", "input";
    V_W: "v_w" "v_w" M_PER_S / M_PER_S [not_negative], "Wind speed, in the direction of the boom.", "input";
    C_P: "c_p" "c_p" KG_PER_M3 / KG_PER_M3 [positive, unconfirmed], "Dynamic pressure of the wind over the square of its speed.", "input";
    A_Q: "a_Q" "a_Q" M2_PER_KG / M2_PER_T [not_negative, unconfirmed], "Wind area of the load with its shape coefficient, over its mass.", "input";
    K_P: "k_P" "k_P" ONE / ONE [positive, unconfirmed], "Factor of the load against tipping.", "[ISO 4305]";
    K_F: "k_F" "k_F" ONE / ONE [not_negative, unconfirmed], "Factor of the boom's weight at its head against tipping.", "[ISO 4305]";
    NU: "nu" "nu" ONE / PERCENT [above_to(0.0, 1.0), unconfirmed], "Rated load as part of the tipping load.", "input";
    K_T: "K_t" "K_t" ONE / ONE [positive, unconfirmed], "Tipping load over rated load.", "[Ports001, 7.1.4]";
    S_LIM: "s_lim" "s_\"lim\"" ONE / PERCENT [from_to(0.0, 1.0), unconfirmed], "Least part of the weight on the boom's side without load, against tipping backward.", "input";
    K_W: "k_w" "k_w" ONE / PERCENT [above_to(0.0, 1.0), unconfirmed], "Utilisation from which the load indicator warns.", "input";
    R_FROM: "R_from" "R_a" M / M [positive], "Least reach of the load chart.", "input";
    R_TO: "R_to" "R_e" M / M [positive], "Greatest reach of the load chart.", "input";
    R_STEP: "R_step" "Delta R" M / M [positive], "Step of the load chart's reach.", "input";

    // The boom.
    E_L: "e_l" "e_l" M / M, "Extension of the boom: its length over that at its shortest.", "derived";
    H_A: "H_A" "H_A" M / M, "Boom head, above the ground.", "derived";
    V_B: "V_b" "V_b" N / KN, "Weight of the boom.", "derived";
    M_B: "M_b" "M_b" N_M / KN_M, "Moment of the boom's weight about its foot, were it horizontal.", "derived";
    F_B: "F_b" "F_b" N / KN, "Weight of the boom as it acts at its head.", "[ISO 4305]";

    // Weights.
    V_C: "V_c" "V_c" N / KN, "Weight of the carrier.", "derived";
    M_CX: "M_cx" "M_(c x)" N_M / KN_M, "Moment of the carrier's weight, forward of the slewing axis.", "derived";
    M_CY: "M_cy" "M_(c y)" N_M / KN_M, "Moment of the carrier's weight, to the left of the slewing axis.", "derived";
    M_U: "M_u" "M_u" N_M / KN_M, "Moment of the weights of upper works and boom about the slewing axis, positive in the boom's direction.", "derived";
    V_0: "V_0" "V_0" N / KN, "Weight of the crane without load.", "derived";
    Z_0: "Z_0" "Z_0" N_M / KN_M, "Weight of the crane without load times its height above the ground.", "derived";
    P_W: "p_w" "p_w" PA / PA [not_negative], "Dynamic pressure of the wind.", "derived";
    W_Q: "w_Q" "w_Q" ONE / PERCENT [not_negative], "Wind on the load over its weight.", "derived";
    M_E: "M_e" "M_e" N_M / KN_M, "Moment of upper works and boom in the boom's direction, on the slope.", "derived";
    M_R: "M_r" "M_r" N_M / KN_M, "Moment of upper works and boom in the boom's direction, on the slope that falls to its rear.", "derived";
    R_E: "R_E" "R_E" M / M, "Reach at which the load acts on level ground as it does with slope and wind.", "derived";

    // Tipping.
    N_X: "n_x" "n_x" ONE / ONE, "Direction square to the governing tipping line, away from the crane, forward.", "derived";
    N_Y: "n_y" "n_y" ONE / ONE, "Direction square to the governing tipping line, away from the crane, to the left.", "derived";
    D_T: "d_t" "d_t" M / M, "Distance of the governing tipping line from the slewing axis; positive where that lies inside.", "derived";
    C_T: "c_t" "c_t" ONE / ONE, "Cosine of the angle between the boom and the direction square to the governing tipping line.", "derived";
    M_S: "M_S" "M_S" N_M / KN_M, "Stabilising moment of the crane without load about the governing tipping line.", "[Ports001, 7.1.4]";
    A_T: "a_t" "a_t" M / M, "Lever arm of the load about the governing tipping line.", "[Ports001, 7.1.4]";
    P: "P" "P" N / KN [infinite("where the load lies within the supports")], "Tipping load: the least load on the boom's head, hook block included, that tips the crane.", "[Ports001, 7.1.4]";
    N_RX: "n_rx" "n_(r x)" ONE / ONE, "Direction square to the most unfavourable tipping line behind the boom, away from the crane, forward.", "derived";
    N_RY: "n_ry" "n_(r y)" ONE / ONE, "Direction square to the most unfavourable tipping line behind the boom, away from the crane, to the left.", "derived";
    D_R: "d_r" "d_r" M / M, "Distance of that line from the slewing axis; positive where the axis lies inside.", "derived";
    B_R: "b_r" "b_r" M / M, "Distance of that line from the support farthest from it.", "derived";
    M_SR: "M_Sr" "M_(S r)" N_M / KN_M, "Stabilising moment of the crane without load about that line.", "derived";
    S_BACK: "s_back" "s_\"back\"" ONE / PERCENT, "Least part of the crane's weight without load that is left on the side opposite to a tipping line behind the boom.", "derived";

    // What is permitted.
    Q_ST: "Q_st" "Q_\"st\"" N / KN [infinite("where the load lies within the supports")], "Load that stability permits.", "[Ports001, 7.1.4]";
    N_0: "N_0" "N_0" N / KN, "Force on the governing support without load.", "equilibrium";
    N_Q: "n_Q" "n_Q" ONE / ONE, "Force on the governing support for each unit of load.", "equilibrium";
    Q_N: "Q_N" "Q_N" N / KN [infinite("where no support reaches what it can bear")], "Load at which a support reaches what it can bear.", "equilibrium";
    Q_S: "Q_s" "Q_s" N / KN [infinite("where no strength is given")], "Load that the strength of boom, ropes and cylinder permits, from its tables.", "input";
    Q_RAT: "Q_rat" "Q_\"rat\"" N / KN [infinite("where nothing limits it")], "Rated load with hook block or grab: the least that anything permits.", "derived";
    Q_NET: "Q_net" "Q_\"net\"" N / KN [infinite("where nothing limits it")], "Rated load without hook block or grab.", "derived";
    GOVERNS: "governs" "\"governs\"" ONE / ONE [one_of(&GOVERNING)], "What limits the rated load.", "derived";
    Q_G: "Q_g" "Q_g" N / KN, "Load with hook block or grab, with its impact factor.", "derived";
    ETA: "eta" "eta" ONE / PERCENT [infinite("where no load is permitted")], "Utilisation of the rated load.", "derived";
    Q_CH: "Q_ch" "Q_\"ch\"" N / KN [infinite("where nothing limits it")], "Rated load of the load chart: of the next greater reach and the next longer boom there; zero beyond them.", "derived";
    ETA_CH: "eta_ch" "eta_\"ch\"" ONE / PERCENT [infinite("where the load chart permits no load")], "Utilisation of the load chart.", "derived";
    WARNS: "warns" "\"warns\"" ONE / ONE [boolean], "Whether the load indicator warns.", "derived";
    STOPS: "stops" "\"stops\"" ONE / ONE [boolean], "Whether the load limiter stops: the load is more than rated, or none is permitted.", "derived";
    Z_WARN: "z.warn" "z_1" ONE / ONE, "Falls below zero where the load indicator begins to warn.", "event";
    Z_STOP: "z.stop" "z_2" ONE / ONE, "Falls below zero where the load limiter begins to stop.", "event";

    // Supports under load.
    V: "V" "V" N / KN, "Force of the ground on all supports.", "equilibrium";
    X_V: "x_V" "x_V" M / M, "Where the force of the ground acts, forward of the slewing axis.", "equilibrium";
    Y_V: "y_V" "y_V" M / M, "Where the force of the ground acts, to the left of the slewing axis.", "equilibrium";
    A: "a" "a" M / M, "Distance of the ground's force from the nearest tipping line; negative where the crane tips.", "derived";
    N_N: "n_n" "n" ONE / ONE, "Number of supports that bear.", "derived";
    X_M: "x_m" "x_m" M / M, "Mean of the supports that bear, forward.", "derived";
    Y_M: "y_m" "y_m" M / M, "Mean of the supports that bear, to the left.", "derived";
    S_XX: "S_xx" "S_(x x)" M2 / M2, "Sum of the squares of their distances from the mean, forward.", "derived";
    S_YY: "S_yy" "S_(y y)" M2 / M2, "Sum of the squares of their distances from the mean, to the left.", "derived";
    S_XY: "S_xy" "S_(x y)" M2 / M2, "Sum of the products of their distances from the mean, forward and to the left.", "derived";
    E_X: "e_x" "e_x" M / M, "Force of the ground, forward of the mean.", "derived";
    E_Y: "e_y" "e_y" M / M, "Force of the ground, to the left of the mean.", "derived";
    D_X: "d_x" "d_x" M / M, "Support, forward of the mean.", "derived";
    D_Y: "d_y" "d_y" M / M, "Support, to the left of the mean.", "derived";
    T_X: "t_x" "t_x" PER_M / PER_M, "Growth of a support's share for each metre forward.", "derived";
    T_Y: "t_y" "t_y" PER_M / PER_M, "Growth of a support's share for each metre to the left.", "derived";
    N: "N" "N_i" N / KN [not_negative], "Force of the ground on a support; zero where it is lifted.", "equilibrium";
    P_G: "p_g" "p_(g i)" PA / MPA [not_negative], "Pressure on the ground under the pad of a support.", "derived";

    // The whole range.
    P_MIN: "P_min" "P_min" N / KN [infinite("where the load lies within the supports")], "Least tipping load of the working range.", "derived";
    ETA_MAX: "eta_max" "eta_max" ONE / PERCENT [infinite("where no load is permitted")], "Greatest utilisation of the rated load in the working range.", "derived";
    A_MIN: "a_min" "a_min" M / M, "Least distance of the ground's force from a tipping line in the working range.", "derived";
    S_BACK_MIN: "s_back_min" "s_(\"back\",min)" ONE / PERCENT, "Least part of the weight on the boom's side without load in the working range.", "derived";
    N_I_MAX: "N_i_max" "N_max" N / KN, "Greatest force on a support in the working range.", "derived";
    P_G_MAX: "p_g_max" "p_(g,max)" PA / MPA, "Greatest pressure on the ground in the working range.", "derived";
    AGREEMENT: "agreement" "delta" ONE / ONE, "Difference of two independent ways, relative to the largest value.", "derived";
}

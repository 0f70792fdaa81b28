//! Every quantity of a crane on a portal.

pub use crate::kernel::gravity::G;
use crate::kernel::symbol::{Enumeration, Range, symbols};
pub use crate::luffing::aboard::{R, THETA_1};
pub use crate::parts::motor::{J_M, LAMBDA_M, P_N};

/// The leg that is lifted.
pub static LEGS: Enumeration = Enumeration {
    name: "Leg",
    items: &[
        ("none", "All four legs bear."),
        (
            "front_right",
            "The leg of corner 1, in front on the right rail, is lifted.",
        ),
        (
            "front_left",
            "The leg of corner 2, in front on the left rail, is lifted.",
        ),
        ("rear_left", "The leg of corner 3, behind on the left rail, is lifted."),
        (
            "rear_right",
            "The leg of corner 4, behind on the right rail, is lifted.",
        ),
    ],
};

symbols! {
    // Given.
    PSI: "psi" "psi" RAD / DEG, "Slewing angle of the boom from the direction of the rails; positive counter-clockwise, seen from above.", "input";
    OMEGA: "omega" "omega" RAD_PER_S / DEG_PER_S, "Angular velocity of slewing.", "input";
    FROM: "from" "psi_a" RAD / DEG, "Slewing angle at the start of the working range.", "input";
    TO: "to" "psi_e" RAD / DEG, "Slewing angle at the end of the working range.", "input";
    A: "a" "a" M / M [positive], "Base: distance of the corners along the rails.", "input";
    B: "b" "b" M / M [positive], "Gauge: distance of the rails.", "input";
    N_W: "n_w" "n_(\"w\" i)" ONE / ONE [within(Range::new(1.0, 64.0))], "Number of wheels in the bogies of a corner.", "input";
    G_P: "G_p" "G_(p i)" N / KN [not_negative], "Weight of a body of the portal.", "input";
    X_P: "x_p" "x_(p i)" M / M, "Centre of gravity of a body of the portal, forward of the slewing axis.", "input";
    Y_P: "y_p" "y_(p i)" M / M, "Centre of gravity of a body of the portal, to the left of the slewing axis.", "input";
    G_U: "G_u" "G_(u i)" N / KN [not_negative], "Weight of a body of the upper works.", "input";
    R_U: "r_u" "r_(u i)" M / M, "Centre of gravity of a body of the upper works, in front of the slewing axis; negative behind it.", "input";
    Q: "Q" "Q" N / KN [not_negative], "Weight of the load with hook block or grab.", "input";
    G_H0: "G_h0" "G_\"h0\"" N / KN [not_negative], "Weight of the hopper on the portal, with its feeder, empty.", "input";
    X_H: "x_h" "x_\"h\"" M / M, "Centre of gravity of the hopper with its contents, forward of the slewing axis.", "input";
    Y_H: "y_h" "y_\"h\"" M / M, "Centre of gravity of the hopper with its contents, to the left of the slewing axis.", "input";
    Q_H: "Q_h" "Q_\"h\"" N / KN [not_negative], "Weight of what lies in the hopper.", "input";
    Q_HF: "Q_hf" "Q_\"hf\"" N / KN [positive], "Weight of what lies in the hopper when it is full.", "input";
    P_W: "p_w" "p_\"w\"" PA / PA [not_negative], "Pressure of the wind.", "input";
    CHI_W: "chi_w" "chi_\"w\"" RAD / DEG, "Direction to which the wind blows, from the direction of the rails; positive counter-clockwise, seen from above.", "input";
    A_W: "A_w" "A_(\"w\" i)" M2 / M2 [not_negative], "Wind area with its shape coefficient.", "input";
    H_W: "h_w" "h_(\"w\" i)" M / M [not_negative], "Centre of a wind area, above the rails.", "input";
    K_L: "k_l" "k_\"l\"" ONE / ONE [not_negative, unconfirmed], "Lateral force of a corner's wheels over what the corner bears.", "input";
    V_T: "v_t" "v_\"t\"" M_PER_S / M_PER_MIN [positive], "Speed of travel.", "input";
    A_T: "a_t" "a_\"t\"" M_PER_S2 / M_PER_S2 [positive], "Acceleration of a start of travel.", "input";
    GAMMA_T: "gamma_t" "gamma_\"t\"" RAD / DEG [from_to(0.0, 0.1)], "Slope of the rails, up which the crane travels, and down which it is to stop.", "input";
    D_T: "D_t" "D_\"t\"" M / MM [positive], "Diameter of the wheels.", "input";
    D_J: "d_j" "d_\"j\"" M / MM [not_negative], "Diameter at which the wheels' bearings rub.", "input";
    F_R: "f_r" "f_\"r\"" M / MM [not_negative, unconfirmed], "Lever arm of the rolling resistance.", "input";
    MU_J: "mu_j" "mu_\"j\"" ONE / ONE [from_to(0.0, 1.0), unconfirmed], "Friction coefficient of the wheels' bearings.", "input";
    BETA_T: "beta_t" "beta_\"t\"" ONE / ONE [within(Range::new(1.0, 10.0)), unconfirmed], "Factor of the wheels' resistance for flanges that rub on the rails.", "input";
    MU_A: "mu_a" "mu_\"a\"" ONE / ONE [above_to(0.0, 1.0), unconfirmed], "Coefficient of adhesion between wheel and rail.", "input";
    F_BR: "F_br" "F_\"br\"" N / KN [positive], "Force of the brakes of travel at the driven wheels, all together.", "input";
    K_W: "k_w" "k_\"w\"" ONE / ONE [positive, unconfirmed], "Safety with which brakes, clamps and anchors hold the wind.", "input";
    N_DR: "n_dr" "n_(\"dr\" i)" ONE / ONE [within(Range::new(0.0, 64.0))], "Number of driven wheels of a corner, which are braked too.", "input";
    Z_M: "z_m" "z_\"m\"" ONE / ONE [within(Range::new(1.0, 64.0))], "Number of travel motors.", "input";
    I_T: "i_t" "i_\"t\"" ONE / ONE [positive], "Ratio of a motor's speed to that of the wheels.", "input";
    ETA_T: "eta_t" "eta_\"t\"" ONE / ONE [above_to(0.0, 1.0)], "Efficiency between motor and wheels.", "input";
    P_S: "p_s" "p_\"s\"" PA / PA [positive], "Pressure of the wind out of service.", "input";
    Z_C: "z_c" "z_\"c\"" ONE / ONE [within(Range::new(1.0, 64.0))], "Number of rail clamps.", "input";
    F_C: "F_c" "F_\"c\"" N / KN [positive], "Force along the rails that a rail clamp holds.", "input";

    // Weights.
    V_H: "V_h" "V_\"h\"" N / KN [not_negative], "Weight of the hopper with its contents.", "[Ports001, 7.2.5]";
    U_H: "u_h" "u_\"h\"" ONE / ONE, "Weight of what lies in the hopper over that when it is full.", "derived";
    V_0: "V_0" "V_0" N / KN, "Weight of the crane without load.", "derived";
    M_PX: "M_px" "M_(p x)" N_M / KN_M, "Moment of the portal's weight about the axis along the rails; positive loads the left rail.", "equilibrium";
    M_PY: "M_py" "M_(p y)" N_M / KN_M, "Moment of the portal's weight about the axis across the rails; positive loads the corners in front.", "equilibrium";
    M_U: "M_u" "M_u" N_M / KN_M, "Moment of the upper works' weight about the slewing axis; positive in the boom's direction.", "equilibrium";
    M_W: "M_w" "M_\"w\"" N_M / KN_M, "Moment of the wind about the rails' height, in its direction.", "equilibrium";
    M_WX: "M_wx" "M_(\"w\" x)" N_M / KN_M, "Moment of the wind about the axis along the rails; positive loads the left rail.", "equilibrium";
    M_WY: "M_wy" "M_(\"w\" y)" N_M / KN_M, "Moment of the wind about the axis across the rails; positive loads the corners in front.", "equilibrium";
    M_0X: "M_0x" "M_(0 x)" N_M / KN_M, "Moment of all that does not slew about the axis along the rails; positive loads the left rail.", "equilibrium";
    M_0Y: "M_0y" "M_(0 y)" N_M / KN_M, "Moment of all that does not slew about the axis across the rails; positive loads the corners in front.", "equilibrium";

    // Load on the portal.
    V: "V" "V" N / KN, "Weight of the crane with its load.", "[Ports001, 7.2]";
    M: "M" "M" N_M / KN_M, "Moment of all that slews, with the load, about the slewing axis; positive in the boom's direction.", "[Ports001, 7.2]";
    M_X: "M_x" "M_x" N_M / KN_M, "Moment about the axis along the rails; positive loads the left rail.", "[Ports001, 7.2]";
    M_Y: "M_y" "M_y" N_M / KN_M, "Moment about the axis across the rails; positive loads the corners in front.", "[Ports001, 7.2]";

    // Corners.
    N_4: "N_4" "N_(4 i)" N / KN, "What a corner of the rigid portal bears while all four legs stand on the rails; negative where its leg would have to pull.", "[Ports001, 7.2]";
    N_LOW: "N_low" "N_\"low\"" N / KN, "Least of the four corner loads of the rigid portal while all four legs stand on the rails.", "derived";
    LIFTS: "lifts" "\"lifts\"" ONE / ONE [boolean], "Whether a leg of the rigid portal is lifted.", "derived";
    LEG: "leg" "\"leg\"" ONE / ONE [one_of(&LEGS)], "Which leg of the rigid portal is lifted.", "derived";
    Z_LIFT: "z.lift" "z_1" ONE / ONE, "Falls below zero where a leg of the rigid portal is lifted.", "event";
    N_R: "N_r" "N_(\"r\" i)" N / KN [not_negative], "What a corner of the rigid portal bears; zero where its leg is lifted and the three others bear all.", "[Ports001, 7.2]";
    N_H: "N_h" "N_(\"h\" i)" N / KN [not_negative], "What a corner of the hinged portal bears.", "[Ports001, 7.2]";
    D_N: "d_N" "Delta N_i" N / KN, "What a corner of the rigid portal bears more than that of the hinged one.", "derived";
    N: "N" "N_i" N / KN [not_negative], "What a corner bears, by the kind of the portal.", "derived";
    N_TOP: "N_top" "N_\"top\"" N / KN [not_negative], "Greatest of the four corner loads.", "derived";
    F_W: "F_w" "F_(\"w\" i)" N / KN [not_negative], "Wheel load of a corner.", "derived";
    H: "H" "H_i" N / KN [not_negative], "Lateral force of a corner's wheels.", "derived";

    // Tipping.
    M_ST: "M_st" "M_(\"s\" i)" N_M / KN_M, "Stabilising moment of the crane without load about an edge: 1 in front, 2 the left rail, 3 behind, 4 the right rail.", "[Ports001, 7.1.4]";
    M_OV: "M_ov" "M_(\"o\" i)" N_M / KN_M, "Moment of load and wind that tips the crane about an edge; negative where they hold it.", "[Ports001, 7.1.4]";
    K: "K" "K_i" ONE / ONE [infinite("where load and wind do not tip the crane about this edge")], "Safety against tipping about an edge: 1 in front, 2 the left rail, 3 behind, 4 the right rail.", "[Ports001, 7.1.4]";

    // Travel.
    W: "w" "w" ONE / ONE [not_negative], "Resistance of the wheels without flanges, over what they bear.", "equilibrium";
    A_SUM: "A_sum" "A_\"w\"" M2 / M2 [not_negative], "Sum of the wind areas.", "derived";
    F_0: "F_0" "F_0" N / KN [not_negative], "Resistance of the wheels without flanges.", "equilibrium";
    F_F: "F_f" "F_\"f\"" N / KN [not_negative], "Resistance of the wheels with their flanges.", "equilibrium";
    F_GAMMA: "F_gamma" "F_gamma" N / KN [not_negative], "Force down the slope of the rails.", "equilibrium";
    F_WT: "F_wt" "F_\"wt\"" N / KN [not_negative], "Force of the wind along the rails.", "equilibrium";
    F_T: "F_t" "F_\"t\"" N / KN [not_negative], "Force that steady travel asks for, up the slope and into the wind.", "equilibrium";
    F_A: "F_a" "F_\"a\"" N / KN [not_negative], "Force that accelerates the crane with its load.", "Newton and Euler";
    F_TA: "F_ta" "F_\"ta\"" N / KN [not_negative], "Force that a start of travel asks of the driven wheels.", "Newton and Euler";
    N_T: "n_t" "n_\"t\"" PER_S / PER_MIN, "Speed of the motors.", "derived";
    P_T: "P_t" "P_\"t\"" W / KW, "Power of each motor in steady travel.", "derived";
    U_T: "u_t" "u_\"t\"" ONE / ONE, "Power of each motor in steady travel over its rated power.", "derived";
    M_J: "m_J" "m_J" KG / T, "Mass at the wheels that is as hard to accelerate as the shafts of all motors.", "Newton and Euler";
    P_A: "P_a" "P_\"a\"" W / KW, "Power of each motor at the end of a start.", "Newton and Euler";
    U_A: "u_a" "u_\"a\"" ONE / ONE, "Power of each motor at the end of a start over the greatest that it may give.", "derived";
    F_DO: "F_do" "F_\"do\"" N / KN, "Force that drives the crane on that is to stop: wind from behind and the slope, less the wheels' resistance.", "equilibrium";
    F_HD: "F_hd" "F_\"hd\"" N / KN, "Force that the brakes must hold at work; negative where the wheels' resistance holds it.", "equilibrium";
    U_HD: "u_hd" "u_\"hd\"" ONE / ONE, "What the brakes must hold at work over their force.", "derived";
    A_BR: "a_br" "a_\"br\"" M_PER_S2 / M_PER_S2, "Deceleration of a stop by the brakes.", "Newton and Euler";
    T_BR: "t_br" "t_\"br\"" S / S, "Time of a stop by the brakes.", "derived";
    S_BR: "s_br" "s_\"br\"" M / M, "Way of a stop by the brakes.", "derived";
    F_TB: "F_tb" "F_\"tb\"" N / KN, "Force of the driven wheels on the rails in a stop: that of the brakes, less what stops the motors' shafts.", "Newton and Euler";
    N_ALL: "n_all" "n_\"dr\"" ONE / ONE, "Number of all driven wheels.", "derived";
    F_1A: "F_1a" "F_\"1a\"" N / KN, "Force of a driven wheel in a start.", "derived";
    F_1B: "F_1b" "F_\"1b\"" N / KN, "Force of a driven wheel in a stop.", "derived";
    F_AD: "F_ad" "F_(\"ad\" i)" N / KN [not_negative], "Force that a wheel of a corner can give before it slips.", "Coulomb";
    K_ST: "k_st" "k_(\"st\" i)" ONE / ONE [infinite("where the corner has no driven wheels")], "Safety of a corner's driven wheels against slipping in a start.", "Coulomb";
    K_BR: "k_br" "k_(\"br\" i)" ONE / ONE [infinite("where the corner has no driven wheels")], "Safety of a corner's driven wheels against sliding in a stop.", "Coulomb";

    // Out of service.
    F_SW: "F_sw" "F_\"sw\"" N / KN [not_negative], "Force of the wind out of service, along the rails.", "equilibrium";
    M_SW: "M_sw" "M_\"sw\"" N_M / KN_M [not_negative], "Moment of the wind out of service about the rails' height.", "equilibrium";
    F_0S: "F_0s" "F_\"0s\"" N / KN [not_negative], "Resistance of the wheels without flanges, of the crane without load.", "equilibrium";
    F_GS: "F_gs" "F_(gamma \"s\")" N / KN [not_negative], "Force down the slope of the rails, of the crane without load.", "equilibrium";
    F_CL: "F_cl" "F_\"cl\"" N / KN, "Force along the rails that all rail clamps must hold; negative where the wheels' resistance holds it.", "equilibrium";
    F_C1: "F_c1" "F_\"c1\"" N / KN, "Force along the rails that a rail clamp must hold.", "derived";
    U_C: "u_c" "u_\"c\"" ONE / ONE, "What a rail clamp must hold over what it holds.", "derived";
    K_S: "K_s" "K_(\"s\" i)" ONE / ONE [infinite("where the wind has no moment")], "Safety against tipping about an edge by the wind out of service, without load, untied: 1 in front, 2 the left rail, 3 behind, 4 the right rail.", "equilibrium";
    U: "U" "U_i" N / KN, "Pull down that the anchors across from an edge must give together against the wind out of service; negative where none is needed.", "equilibrium";

    // The full circle, in closed form.
    N_MEAN: "N_mean" "N_\"mean\"" N / KN, "What the most loaded corner of the rigid portal bears on the mean of all slewing angles, on four legs.", "derived";
    N_AMP: "N_amp" "N_\"amp\"" N / KN [not_negative], "Amplitude of the corner loads of the rigid portal on four legs, as the crane slews.", "derived";
    N_CIR: "N_cir" "N_\"cir\"" N / KN, "Greatest corner load of the rigid portal at any slewing angle.", "derived";
    PSI_CIR: "psi_cir" "psi_\"cir\"" RAD / DEG, "Slewing angle of the greatest corner load of the rigid portal.", "derived";
    N_4_CIR: "N_4_cir" "N_(4,\"cir\")" N / KN, "Least corner load of the rigid portal on four legs at any slewing angle; negative where a leg is lifted.", "derived";

    // The whole range.
    N_R_MAX: "N_r_max" "N_(\"r\",max)" N / KN, "Greatest corner load of the rigid portal in the working range.", "derived";
    N_H_MAX: "N_h_max" "N_(\"h\",max)" N / KN, "Greatest corner load of the hinged portal in the working range.", "derived";
    D_N_MAX: "d_N_max" "Delta N_max" N / KN, "Greatest difference of the corner loads of rigid and hinged portal in the working range, by amount.", "derived";
    F_W_MAX: "F_w_max" "F_(\"w\",max)" N / KN, "Greatest wheel load in the working range.", "derived";
    H_MAX: "H_max" "H_max" N / KN, "Greatest lateral force of a corner's wheels in the working range.", "derived";
    N_4_MIN: "N_4_min" "N_(4,min)" N / KN, "Least corner load of the rigid portal on four legs in the working range; negative where a leg is lifted.", "derived";
    K_MIN: "K_min" "K_min" ONE / ONE [infinite("where load and wind tip the crane about no edge")], "Least safety against tipping in the working range.", "derived";
    K_ST_MIN: "k_st_min" "k_\"st,min\"" ONE / ONE [infinite("where no wheel is asked for a force")], "Least safety of driven wheels against slipping in a start in the working range.", "derived";
    K_BR_MIN: "k_br_min" "k_\"br,min\"" ONE / ONE [infinite("where no wheel is asked for a force")], "Least safety of driven wheels against sliding in a stop in the working range.", "derived";
    K_S_MIN: "K_s_min" "K_(\"s\",min)" ONE / ONE [infinite("where the wind has no moment")], "Least safety against tipping by the wind out of service in the working range.", "derived";
    U_MAX: "U_max" "U_max" N / KN, "Greatest pull down of the anchors across from an edge in the working range; negative where none is needed.", "derived";
    AGREEMENT: "agreement" "delta" ONE / ONE, "Difference of two independent ways, relative to the largest value.", "derived";
}

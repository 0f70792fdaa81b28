//! Every quantity of a crane on a portal.

use crate::kernel::symbol::{Enumeration, Range, symbols};

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
    R: "R" "R" M / M, "Reach: distance of the load from the slewing axis.", "input";
    Q: "Q" "Q" N / KN [not_negative], "Weight of the load with hook block or grab.", "input";
    P_W: "p_w" "p_\"w\"" PA / PA [not_negative], "Pressure of the wind.", "input";
    CHI_W: "chi_w" "chi_\"w\"" RAD / DEG, "Direction to which the wind blows, from the direction of the rails; positive counter-clockwise, seen from above.", "input";
    A_W: "A_w" "A_(\"w\" i)" M2 / M2 [not_negative], "Wind area with its shape coefficient.", "input";
    H_W: "h_w" "h_(\"w\" i)" M / M [not_negative], "Centre of a wind area, above the rails.", "input";
    K_L: "k_l" "k_\"l\"" ONE / ONE [not_negative, unconfirmed], "Lateral force of a corner's wheels over what the corner bears.", "input";

    // Weights.
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
    AGREEMENT: "agreement" "delta" ONE / ONE, "Difference of two independent ways, relative to the largest value.", "derived";
}

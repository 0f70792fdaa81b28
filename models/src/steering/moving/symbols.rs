//! Quantities of the groups in motion.

use crate::kernel::symbol::{COARSEST, symbols};
pub use crate::parts::hydraulics::symbols::{CAVITATES, Z_VACUUM};
pub use crate::steering::symbols::{
    DELTA, F_G, F_GX, G, MARGIN, OD, OMEGA, Q_G, Q_SUM, R, SLIP, SLIP_MAX, T_GX, T_LEFT, THETA, THETA_DOT, THETA_N,
    THETA_S, V, V_C, V_MX, V_MY, V_S,
};

symbols! {
    // Given. Beyond its range a number is a slip of the pen; a shorter cycle would be an endless run of samples.
    J: "J" "J" KG_M2 / KG_M2 [positive], "Inertia of a group about its axis.", "input";
    STEP: "step" "h" S / MS [positive], "Longest step of the solver.", "input";
    V_0: "V_0" "V_0" M3 / L [positive], "Oil left in a chamber at the piston's end.", "input";
    V_1: "V_1" "V_1" M3 / L [positive], "Oil in each port of the valve.", "input";
    Q_N: "Q_N" "Q_N" M3_PER_S / L_PER_MIN [positive], "Rated flow of the valve, fully open.", "input";
    DP_N: "dp_N" "Delta p_N" PA / MPA [positive], "Pressure difference over one edge of the valve at the rated flow.", "input";
    X_0: "x_0" "x_0" ONE / PERCENT [from_to(0.0, 0.9)], "Overlap of the valve: part of the spool's stroke to either side of its middle in which no edge is open.", "input";
    DP_L: "dp_L" "Delta p_L" PA / MPA [positive], "Pressure difference over each line from valve to cylinder at the rated flow.", "input";
    BETA_E: "beta_E" "beta_E" PA / MPA [positive], "Bulk modulus of the oil with its walls.", "input";
    P_R: "p_R" "p_R" PA / MPA [positive], "Opening pressure of the relief valves at a cylinder's ports.", "input";
    K_R: "k_R" "k_R" M3_PER_SPA / L_PER_MINMPA [not_negative], "Flow of a relief valve over the excess of pressure.", "input";
    K_L: "k_L" "k_L" M3_PER_SPA / L_PER_MINMPA [not_negative], "Leakage past the piston over the difference of pressure.", "input";
    OMEGA_V: "omega_v" "omega_v" RAD_PER_S / RAD_PER_S [positive], "Natural frequency of the valve's spool.", "input";
    ZETA_V: "zeta_v" "zeta_v" ONE / ONE [not_negative], "Damping ratio of the valve's spool.", "input";
    P_P: "p_P" "p_P" PA / MPA [not_negative], "Pressure of the pump above the tank's.", "input";
    TOL: "tol" "epsilon" ONE / ONE [from_to(1e-12, COARSEST)], "Relative tolerance of the solver.", "input";
    T_C: "T_c" "T_c" S / MS [from_to(1e-4, 10.0)], "Cycle of the PLC: time from one sample to the next.", "input";
    K_P: "k_P" "k_P" PER_RAD / PER_RAD [not_negative], "Proportional gain: command of the valve over the error of the angle.", "input";
    K_I: "k_I" "k_I" PER_RAD_S / PER_RAD_S [not_negative], "Integral gain: command of the valve over the integral of the error.", "input";
    U_V_MAX: "u_v_max" "u_(v,max)" ONE / ONE [above_to(0.0, 1.0)], "Greatest command of a valve, by amount.", "input";

    // States, each for every group.
    OMEGA_G: "omega_g" "omega_(g i)" RAD_PER_S / DEG_PER_S, "Angular velocity of a group, counter-clockwise positive.", "equations of motion";
    P_1: "p_1" "p_(1 i)" PA / MPA, "Pressure in the valve's port on the side of the bore.", "equations of motion";
    P_2: "p_2" "p_(2 i)" PA / MPA, "Pressure in the valve's port on the side of the annulus.", "equations of motion";
    P_A: "p_A" "p_(A i)" PA / MPA, "Pressure in the chamber of the bore.", "equations of motion";
    P_B: "p_B" "p_(B i)" PA / MPA, "Pressure in the chamber of the annulus.", "equations of motion";
    X_V: "x_v" "x_(v i)" ONE / ONE, "Spool of a group's valve, from -1 to 1 of its stroke.", "equations of motion";
    V_V: "v_v" "v_(v i)" PER_S / PER_S, "Speed of the valve's spool, over its stroke.", "equations of motion";

    // Results.
    Q_P: "Q_P" "Q_P" M3_PER_S / L_PER_MIN, "Oil flow that the pump delivers to all valves.", "equations of motion";
    THETA_W: "theta_w" "theta_(w i)" RAD / DEG, "Heading that the command wants of a group, within its range.", "[Zhang2016, eq. 1-9]";
    E: "e" "e_i" RAD / DEG, "What a group lacks of the heading wanted.", "derived";
    U_V: "u_v" "u_(v i)" ONE / ONE, "Command of a group's valve, held by the PLC from sample to sample; positive lengthens the cylinder.", "[Zhang2016, 7]";
    DU_V: "du_v" "abs(Delta u_v)" ONE / ONE [not_negative], "Greatest change of a valve's command from one sample of the PLC to the next.", "derived";
    F_C: "f_c" "f_(c i)" N / KN, "Force of a group's cylinder by its pressures; push positive.", "equations of motion";
    M_R: "M_R" "M_(R i)" N_M / KN_M, "Moment of tyres, slewing ring and end stop on a group; positive turns it counter-clockwise.", "equations of motion";
    Q_V: "q_v" "q_(v i)" M3_PER_S / L_PER_MIN, "Oil flow from the pump through a group's valve.", "equations of motion";

    // What the book tells besides.
    TAU: "tau" "tau" S / S, "Time from the start of the movement.", "derived";
    OMEGA_C: "omega_c" "omega_c" RAD_PER_S / RAD_PER_S, "Angular velocity of a group below which its resistance is in proportion to it.", "assumption";
    N_E: "n_e" "n_(e i)" ONE / ONE, "Whole steps that the encoder of a group counts, rounded to the nearest.", "derived";
    THETA_E: "theta_e" "theta_(e i)" RAD / DEG, "Heading of a group as the PLC reads it.", "derived";
    E_E: "e_e" "e_(e i)" RAD / DEG, "What a group lacks of the heading wanted, as the PLC reads it.", "derived";
    I_E: "I_e" "I_(e i)" RAD_S / RAD_S, "Sum of the errors times the cycle that the PLC holds of a group.", "[Zhang2016, 7]";
    I_N: "I_n" "I_(n i)" RAD_S / RAD_S, "The same after this sample, unless the command is at its limit.", "[Zhang2016, 7]";
    U_F: "u_f" "u_(f i)" ONE / ONE, "What the control loop asks for, without limit.", "[Zhang2016, 7]";
    U_N: "u_n" "u_(n i)" ONE / ONE, "Command of a group's valve from this sample to the next.", "[Zhang2016, 7]";
    P_MIN: "p_min" "p_min" PA / MPA, "Least pressure of the oil.", "derived";

    // Rates of the states.
    D_THETA: "der(theta)" "dot(theta)_i" RAD_PER_S / DEG_PER_S, "Rate of a group's heading.", "equations of motion";
    D_OMEGA_G: "der(omega_g)" "dot(omega)_(g i)" RAD_PER_S2 / RAD_PER_S2, "Angular acceleration of a group.", "equations of motion";
    D_P_1: "der(p_1)" "dot(p)_(1 i)" PA_PER_S / MPA_PER_S, "Rate of the pressure in the port of the bore.", "equations of motion";
    D_P_2: "der(p_2)" "dot(p)_(2 i)" PA_PER_S / MPA_PER_S, "Rate of the pressure in the port of the annulus.", "equations of motion";
    D_P_A: "der(p_A)" "dot(p)_(A i)" PA_PER_S / MPA_PER_S, "Rate of the pressure in the chamber of the bore.", "equations of motion";
    D_P_B: "der(p_B)" "dot(p)_(B i)" PA_PER_S / MPA_PER_S, "Rate of the pressure in the chamber of the annulus.", "equations of motion";
    D_X_V: "der(x_v)" "dot(x)_(v i)" PER_S / PER_S, "Rate of the valve's spool.", "equations of motion";
    D_V_V: "der(v_v)" "dot(v)_(v i)" PER_S2 / PER_S2, "Acceleration of the valve's spool.", "equations of motion";

    // Event indicators: an event is where one changes its sign.
    Z_OPEN_1: "z.open_1" "z_(1 i)" ONE / ONE, "Falls below zero where the valve closes the edges that lengthen the cylinder.", "event";
    Z_OPEN_2: "z.open_2" "z_(2 i)" ONE / ONE, "Falls below zero where the valve closes the edges that shorten the cylinder.", "event";
    Z_RELIEF_1: "z.relief_1" "z_(3 i)" PA / MPA, "Falls below zero where the relief valve on the side of the bore opens.", "event";
    Z_RELIEF_2: "z.relief_2" "z_(4 i)" PA / MPA, "Falls below zero where the relief valve on the side of the annulus opens.", "event";
    Z_MIN: "z.min" "z_(5 i)" RAD / DEG, "Falls below zero where a group meets the stop at its least angle.", "event";
    Z_MAX: "z.max" "z_(6 i)" RAD / DEG, "Falls below zero where a group meets the stop at its greatest angle.", "event";
}

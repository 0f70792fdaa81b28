//! Quantities of the mechanism in motion.

use crate::symbol::symbols;

symbols! {
    // Given.
    J_1: "J_1" "J_1" KG_M2 / KG_M2, "Inertia of the boom about its centre of gravity.", "input";
    J_2: "J_2" "J_2" KG_M2 / KG_M2, "Inertia of the jib about its centre of gravity.", "input";
    J_3: "J_3" "J_3" KG_M2 / KG_M2, "Inertia of the rocker about its centre of gravity.", "input";
    C_V: "c_v" "c_v" N_M_S / KN_M_S, "Viscous friction at the driven bar: moment over angular velocity.", "input";
    M_C: "M_C" "M_C" N_M / KN_M, "Dry friction at the driven bar: the moment that it holds, and that it sets against motion.", "input";
    G: "g" "g" M_PER_S2 / M_PER_S2, "Acceleration of gravity.", "input";
    STEP: "step" "h" S / MS, "Longest step of the solver.", "input";

    // Commands.
    M_A: "M_A" "M_A" N_M / KN_M, "Moment of the drive on the driven bar; positive turns it counter-clockwise.", "input";
    M_B: "M_B" "M_B" N_M / KN_M, "Moment of the brake, added to the dry friction.", "input";
    V_H: "v_h" "v_h" M_PER_S / M_PER_S, "Speed of the hoist rope at the head; positive lowers the load.", "input";

    // States.
    PHI: "phi" "phi" RAD / DEG, "Angle of the rope from the vertical; positive swings the load forward.", "equations of motion";
    OMEGA_PHI: "omega_phi" "omega_phi" RAD_PER_S / DEG_PER_S, "Angular velocity of the rope.", "equations of motion";
    L_R: "l_R" "l_R" M / M, "Length of the rope from the head to the load.", "equations of motion";
    S_Q: "s_Q" "s_Q" M / M, "Distance of the load from the head: the rope's length, or less where it is slack.", "equations of motion";
    V_Q: "v_Q" "v_Q" M_PER_S / M_PER_S, "Speed of the load away from the head.", "equations of motion";

    // Results.
    M_R: "M_R" "M_R" N_M / KN_M, "Moment of friction, brake and end stop on the driven bar; positive turns it counter-clockwise.", "equations of motion";
    S_R: "S_R" "S_R" N / KN, "Force in the rope; zero where it is slack.", "equations of motion";

    // Rates of the states.
    D_THETA_1: "der(theta_1)" "dot(theta)_1" RAD_PER_S / DEG_PER_S, "Rate of the boom's angle.", "equations of motion";
    D_OMEGA_1: "der(omega_1)" "dot(omega)_1" RAD_PER_S2 / RAD_PER_S2, "Angular acceleration of the boom.", "equations of motion";
    D_THETA_3: "der(theta_3)" "dot(theta)_3" RAD_PER_S / DEG_PER_S, "Rate of the rocker's angle.", "equations of motion";
    D_OMEGA_3: "der(omega_3)" "dot(omega)_3" RAD_PER_S2 / RAD_PER_S2, "Angular acceleration of the rocker.", "equations of motion";
    D_PHI: "der(phi)" "dot(phi)" RAD_PER_S / DEG_PER_S, "Rate of the rope's angle.", "equations of motion";
    D_OMEGA_PHI: "der(omega_phi)" "dot(omega)_phi" RAD_PER_S2 / RAD_PER_S2, "Angular acceleration of the rope.", "equations of motion";
    D_L_R: "der(l_R)" "dot(l)_R" M_PER_S / M_PER_S, "Rate of the rope's length.", "equations of motion";
    D_S_Q: "der(s_Q)" "dot(s)_Q" M_PER_S / M_PER_S, "Rate of the load's distance from the head.", "equations of motion";
    D_V_Q: "der(v_Q)" "dot(v)_Q" M_PER_S2 / M_PER_S2, "Acceleration of the load away from the head.", "equations of motion";

    // Event indicators: an event is where one falls below zero.
    Z_REST: "z.rest" "z_1" ONE / ONE, "Falls below zero where the driven bar comes to rest, or breaks loose backwards.", "event";
    Z_LOOSE: "z.loose" "z_2" ONE / ONE, "Falls below zero where the driven bar breaks loose forwards.", "event";
    Z_LOW: "z.low" "z_3" ONE / ONE, "Falls below zero where the driven bar meets its lower end stop.", "event";
    Z_HIGH: "z.high" "z_4" ONE / ONE, "Falls below zero where the driven bar meets its upper end stop.", "event";
    Z_ROPE: "z.rope" "z_5" ONE / ONE, "Falls below zero where the rope becomes slack or taut.", "event";
}

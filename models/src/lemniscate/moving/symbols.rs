//! Quantities of the mechanism in motion.

use crate::symbol::symbols;

symbols! {
    // Given.
    J_1: "J_1" "J_1" KG_M2 / KG_M2, "Inertia of the boom about its centre of gravity.", "input";
    J_2: "J_2" "J_2" KG_M2 / KG_M2, "Inertia of the jib about its centre of gravity.", "input";
    J_3: "J_3" "J_3" KG_M2 / KG_M2, "Inertia of the rocker about its centre of gravity.", "input";
    C_V: "c_v" "c_v" N_M_S / KN_M_S, "Viscous friction at the driven bar: moment over angular velocity.", "input";
    M_F: "M_F" "M_F" N_M / KN_M, "Dry friction at the driven bar: the moment that it holds, and that it sets against motion.", "input";
    G: "g" "g" M_PER_S2 / M_PER_S2, "Acceleration of gravity.", "input";
    STEP: "step" "h" S / MS, "Longest step of the solver. An explicit one is refused where the motion changes by more than itself within it.", "input";

    L_MIN: "l_min" "l_min" M / M, "Length of the cylinder retracted, between its anchors.", "input";
    L_MAX: "l_max" "l_max" M / M, "Length of the cylinder extended, between its anchors.", "input";
    V_0: "V_0" "V_0" M3 / L, "Oil left in a chamber at the piston's end.", "input";
    V_1: "V_1" "V_1" M3 / L, "Oil in each port of the valve.", "input";
    Q_N: "Q_N" "Q_N" M3_PER_S / L_PER_MIN, "Rated flow of the valve, fully open.", "input";
    DP_N: "dp_N" "Delta p_N" PA / BAR, "Pressure difference over one edge of the valve at the rated flow.", "input";
    DP_L: "dp_L" "Delta p_L" PA / BAR, "Pressure difference over each line from valve to cylinder at the rated flow.", "input";
    BETA_E: "beta_E" "beta_E" PA / MPA, "Bulk modulus of the oil with its walls.", "input";
    P_R: "p_R" "p_R" PA / BAR, "Opening pressure of the relief valves.", "input";
    K_R: "k_R" "k_R" M3_PER_SPA / M3_PER_SPA, "Flow of a relief valve over the excess of pressure.", "input";
    K_L: "k_L" "k_L" M3_PER_SPA / M3_PER_SPA, "Leakage past the piston over the difference of pressure.", "input";
    OMEGA_V: "omega_v" "omega_v" RAD_PER_S / RAD_PER_S, "Natural frequency of the valve's spool.", "input";
    ZETA_V: "zeta_v" "zeta_v" ONE / ONE, "Damping ratio of the valve's spool.", "input";
    TOL: "tol" "epsilon" ONE / ONE, "Relative tolerance of the implicit solver.", "input";

    // Slewing, given.
    J_SL: "J_sl" "J_\"sl\"" KG_M2 / KG_M2, "Inertia about the slewing axis of all that slews besides boom, jib, rocker, counterweight and load.", "input";
    C_SL: "c_sl" "c_\"sl\"" N_M_S / KN_M_S, "Viscous friction of slewing: moment over angular velocity.", "input";
    M_F_SL: "M_Fsl" "M_\"F sl\"" N_M / KN_M, "Dry friction of slewing: the moment that it holds, and that it sets against motion.", "input";
    PSI_MIN: "psi_min" "psi_\"min\"" RAD / DEG, "Slewing angle of the right end stop.", "input";
    PSI_MAX: "psi_max" "psi_\"max\"" RAD / DEG, "Slewing angle of the left end stop.", "input";

    // Commands.
    U_V: "u_v" "u_v" ONE / ONE, "Command of the valve from -1 to 1; positive lengthens the cylinder.", "input";
    P_P: "p_P" "p_P" PA / BAR, "Pressure of the pump above the tank's.", "input";
    M_A: "M_A" "M_A" N_M / KN_M, "Moment of the drive on the driven bar; positive turns it counter-clockwise.", "input";
    M_S: "M_S" "M_S" N_M / KN_M, "Moment of the brake, added to the dry friction.", "input";
    M_SL: "M_sl" "M_\"sl\"" N_M / KN_M, "Moment of the slewing drive; positive turns the crane counter-clockwise, seen from above.", "input";
    M_B_SL: "M_Bsl" "M_\"B sl\"" N_M / KN_M, "Moment of the slewing brake, added to its dry friction.", "input";
    V_H: "v_h" "v_h" M_PER_S / M_PER_S, "Speed of the hoist rope at the head; positive lowers the load.", "input";

    // States.
    PHI: "phi_R" "phi_R" RAD / DEG, "Angle of the rope from the vertical; positive swings the load forward.", "equations of motion";
    OMEGA_PHI: "omega_R" "omega_R" RAD_PER_S / DEG_PER_S, "Angular velocity of the rope.", "equations of motion";
    L_R: "l_R" "l_R" M / M, "Length of the rope from the head to the load.", "equations of motion";
    S_Q: "s_Q" "s_Q" M / M, "Distance of the load from the head: the rope's length, or less where it is slack.", "equations of motion";
    V_Q: "v_Q" "v_Q" M_PER_S / M_PER_S, "Speed of the load away from the head.", "equations of motion";

    // States of slewing, seen from the frame that slews.
    PSI_SL: "psi_sl" "psi_\"sl\"" RAD / DEG, "Slewing angle; positive counter-clockwise, seen from above.", "equations of motion";
    OMEGA_SL: "omega_sl" "omega_\"sl\"" RAD_PER_S / DEG_PER_S, "Angular velocity of slewing.", "equations of motion";
    X_Q: "x_Q" "x_Q" M / M, "Load, forward of the head.", "equations of motion";
    Y_Q: "y_Q" "y_Q" M / M, "Load, above the head.", "equations of motion";
    Z_Q: "z_Q" "z_Q" M / M, "Load, to the left of the head.", "equations of motion";
    V_QX: "v_Qx" "v_(Q x)" M_PER_S / M_PER_S, "Speed of the load forward, from the head.", "equations of motion";
    V_QY: "v_Qy" "v_(Q y)" M_PER_S / M_PER_S, "Speed of the load up, from the head.", "equations of motion";
    V_QZ: "v_Qz" "v_(Q z)" M_PER_S / M_PER_S, "Speed of the load to the left, from the head.", "equations of motion";

    P_1: "p_1" "p_1" PA / BAR, "Pressure in the valve's port on the side of the bore.", "equations of motion";
    P_2: "p_2" "p_2" PA / BAR, "Pressure in the valve's port on the side of the annulus.", "equations of motion";
    P_A: "p_A" "p_A" PA / BAR, "Pressure in the chamber of the bore.", "equations of motion";
    P_B: "p_B" "p_B" PA / BAR, "Pressure in the chamber of the annulus.", "equations of motion";
    X_V: "x_v" "x_v" ONE / ONE, "Spool of the valve, from -1 to 1 of its stroke.", "equations of motion";
    V_V: "v_v" "v_v" PER_S / PER_S, "Speed of the valve's spool, over its stroke.", "equations of motion";

    // Results.
    F_C: "F_c" "F_c" N / KN, "Force of the cylinder by its pressures; push positive.", "equations of motion";
    M_R: "M_R" "M_R" N_M / KN_M, "Moment of friction, brake and end stop on the driven bar; positive turns it counter-clockwise.", "equations of motion";
    M_R_SL: "M_Rsl" "M_\"R sl\"" N_M / KN_M, "Moment of friction, brake and end stop on slewing; positive counter-clockwise, seen from above.", "equations of motion";
    CHI_R: "chi_R" "chi_R" RAD / DEG, "Angle of the rope from the mechanism's plane; positive swings the load to the left.", "equations of motion";
    S_R: "S_R" "S_R" N / KN, "Force in the rope; zero where it is slack.", "equations of motion";

    // Rates of the states.
    D_THETA_1: "der(theta_1)" "dot(theta)_1" RAD_PER_S / DEG_PER_S, "Rate of the boom's angle.", "equations of motion";
    D_OMEGA_1: "der(omega_1)" "dot(omega)_1" RAD_PER_S2 / RAD_PER_S2, "Angular acceleration of the boom.", "equations of motion";
    D_THETA_3: "der(theta_3)" "dot(theta)_3" RAD_PER_S / DEG_PER_S, "Rate of the rocker's angle.", "equations of motion";
    D_OMEGA_3: "der(omega_3)" "dot(omega)_3" RAD_PER_S2 / RAD_PER_S2, "Angular acceleration of the rocker.", "equations of motion";
    D_PHI: "der(phi_R)" "dot(phi)_R" RAD_PER_S / DEG_PER_S, "Rate of the rope's angle.", "equations of motion";
    D_OMEGA_PHI: "der(omega_R)" "dot(omega)_R" RAD_PER_S2 / RAD_PER_S2, "Angular acceleration of the rope.", "equations of motion";
    D_L_R: "der(l_R)" "dot(l)_R" M_PER_S / M_PER_S, "Rate of the rope's length.", "equations of motion";
    D_S_Q: "der(s_Q)" "dot(s)_Q" M_PER_S / M_PER_S, "Rate of the load's distance from the head.", "equations of motion";
    D_V_Q: "der(v_Q)" "dot(v)_Q" M_PER_S2 / M_PER_S2, "Acceleration of the load away from the head.", "equations of motion";
    D_PSI_SL: "der(psi_sl)" "dot(psi)_\"sl\"" RAD_PER_S / DEG_PER_S, "Rate of the slewing angle.", "equations of motion";
    D_OMEGA_SL: "der(omega_sl)" "dot(omega)_\"sl\"" RAD_PER_S2 / RAD_PER_S2, "Angular acceleration of slewing.", "equations of motion";
    D_X_Q: "der(x_Q)" "dot(x)_Q" M_PER_S / M_PER_S, "Rate of the load's place forward of the head.", "equations of motion";
    D_Y_Q: "der(y_Q)" "dot(y)_Q" M_PER_S / M_PER_S, "Rate of the load's place above the head.", "equations of motion";
    D_Z_Q: "der(z_Q)" "dot(z)_Q" M_PER_S / M_PER_S, "Rate of the load's place to the left of the head.", "equations of motion";
    D_V_QX: "der(v_Qx)" "dot(v)_(Q x)" M_PER_S2 / M_PER_S2, "Acceleration of the load forward, from the head.", "equations of motion";
    D_V_QY: "der(v_Qy)" "dot(v)_(Q y)" M_PER_S2 / M_PER_S2, "Acceleration of the load up, from the head.", "equations of motion";
    D_V_QZ: "der(v_Qz)" "dot(v)_(Q z)" M_PER_S2 / M_PER_S2, "Acceleration of the load to the left, from the head.", "equations of motion";
    D_P_1: "der(p_1)" "dot(p)_1" PA_PER_S / BAR_PER_S, "Rate of the pressure in the port of the bore.", "equations of motion";
    D_P_2: "der(p_2)" "dot(p)_2" PA_PER_S / BAR_PER_S, "Rate of the pressure in the port of the annulus.", "equations of motion";
    D_P_A: "der(p_A)" "dot(p)_A" PA_PER_S / BAR_PER_S, "Rate of the pressure in the chamber of the bore.", "equations of motion";
    D_P_B: "der(p_B)" "dot(p)_B" PA_PER_S / BAR_PER_S, "Rate of the pressure in the chamber of the annulus.", "equations of motion";
    D_X_V: "der(x_v)" "dot(x)_v" PER_S / PER_S, "Rate of the valve's spool.", "equations of motion";
    D_V_V: "der(v_v)" "dot(v)_v" PER_S2 / PER_S2, "Acceleration of the valve's spool.", "equations of motion";

    // Event indicators: an event is where one falls below zero.
    Z_REST: "z.rest" "z_1" ONE / ONE, "Falls below zero where the driven bar comes to rest, or breaks loose backwards.", "event";
    Z_LOOSE: "z.loose" "z_2" ONE / ONE, "Falls below zero where the driven bar breaks loose forwards.", "event";
    Z_LOW: "z.low" "z_3" ONE / ONE, "Falls below zero where the driven bar meets its lower end stop.", "event";
    Z_HIGH: "z.high" "z_4" ONE / ONE, "Falls below zero where the driven bar meets its upper end stop.", "event";
    Z_SPOOL: "z.spool" "z_6" ONE / ONE, "Changes its sign where the valve's spool passes its middle.", "event";
    Z_RELIEF_1: "z.relief_1" "z_7" ONE / ONE, "Falls below zero where the relief valve on the side of the bore opens.", "event";
    Z_RELIEF_2: "z.relief_2" "z_8" ONE / ONE, "Falls below zero where the relief valve on the side of the annulus opens.", "event";
    Z_SL_REST: "z.sl_rest" "z_9" ONE / ONE, "Falls below zero where slewing comes to rest, or breaks loose to the right.", "event";
    Z_SL_LOOSE: "z.sl_loose" "z_10" ONE / ONE, "Falls below zero where slewing breaks loose to the left.", "event";
    Z_SL_LOW: "z.sl_low" "z_11" ONE / ONE, "Falls below zero where slewing meets its right end stop.", "event";
    Z_SL_HIGH: "z.sl_high" "z_12" ONE / ONE, "Falls below zero where slewing meets its left end stop.", "event";
    Z_ROPE: "z.rope" "z_5" ONE / ONE, "Falls below zero where the rope becomes slack or taut.", "event";
}

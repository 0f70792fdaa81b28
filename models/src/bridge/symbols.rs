//! Every quantity of the trolley of a container bridge.

pub use crate::bridge::bodies::symbols::{
    D_PSI_S, D_W_PHI, D_W_PSI, N_S, OMEGA_PSI, PSI_S, S_S1, S_S2, Z_LAND, Z_SEA, Z_SLINGS,
};
pub use crate::kernel::gravity::G;
use crate::kernel::symbol::{Range, symbols};
pub use crate::parts::hanging::{L_R, PHI_R, S_R, X_Q, Y_Q};
pub use crate::sway::pendulum::{A_L, D_L_R, D_OMEGA_R, D_PHI_R, D_V_T, D_X_T, DELTA_F, F_PHI, T_F, X_L, X_T, ZETA_F};

symbols! {
    // Given.
    V_T: "v_t" "v_\"t\"" M_PER_S / M_PER_S, "Speed of the trolley; positive to the sea side.", "input";
    A_T: "a_t" "a_\"t\"" M_PER_S2 / M_PER_S2, "Acceleration of the trolley; positive to the sea side.", "input";
    FROM: "from" "x_a" M / M, "Place of the trolley at the start of the working range.", "input";
    TO: "to" "x_e" M / M, "Place of the trolley at the end of the working range.", "input";
    V_H: "v_h" "v_\"h\"" M_PER_S / M_PER_S, "Hoisting speed of the ropes; positive upward.", "input";
    Q: "Q" "Q" N / KN [not_negative], "Weight of the container with its contents.", "input";
    G_T: "G_t" "G_\"t\"" N / KN [positive], "Weight of the trolley.", "input";
    G_S: "G_s" "G_\"s\"" N / KN [positive], "Weight of the spreader with its head block.", "input";
    MU_T: "mu_t" "mu" ONE / ONE [from_to(0.0, 1.0), unconfirmed], "Resistance of the trolley's wheels, over what they bear.", "input";
    P_W: "p_w" "p_\"w\"" PA / PA [not_negative], "Pressure of the wind, against the travel of the trolley.", "input";
    A_W: "A_w" "A_\"w\"" M2 / M2 [not_negative], "Wind area of trolley and load with its shape coefficient.", "input";
    GAMMA_B: "gamma_b" "gamma_\"b\"" RAD / DEG [from_to(-0.2, 0.2)], "Slope of the beam; positive where it rises to the sea side.", "input";
    ETA_D: "eta_d" "eta_\"d\"" ONE / ONE [above_to(0.0, 1.0)], "Efficiency between a motor and wheels or ropes.", "input";
    N_W: "n_w" "n_\"w\"" ONE / ONE [within(Range::new(2.0, 64.0))], "Number of the trolley's wheels.", "input";
    S_B: "s_b" "s_\"b\"" M / M [positive], "Distance of the two rails on which the bridge stands.", "input";
    ETA_R: "eta_r" "eta_\"r\"" ONE / ONE [above_to(0.0, 1.0), unconfirmed], "Efficiency of a rope sheave.", "input";
    N_DR: "n_dr" "n_\"dr\"" ONE / ONE [within(Range::new(1.0, 64.0))], "Number of driven wheels.", "input";
    MU_A: "mu_a" "mu_\"a\"" ONE / ONE [above_to(0.0, 1.0), unconfirmed], "Coefficient of adhesion between wheel and rail.", "input";
    T_0: "T_0" "T_0" N / KN [positive], "Tension of a tow rope on the slack side.", "input";
    Z_R: "z_r" "z" ONE / ONE [within(Range::new(1.0, 8.0))], "Number of tow ropes on each side.", "input";
    Q_R: "q_r" "q_\"r\"" N_PER_M / N_PER_M [positive], "Weight of a tow rope over its length.", "input";
    EA: "EA" "E A" N / MN [positive, unconfirmed], "Stiffness of a tow rope: modulus of elasticity times area of metal.", "input";
    F_B: "F_b" "F_\"b\"" N / KN [positive], "Least breaking force of a tow rope.", "input";
    X_1: "x_1" "x_1" M / M, "Place of the tow rope's sheave on the sea side.", "input";
    X_2: "x_2" "x_2" M / M, "Place of the tow rope's sheave on the land side.", "input";
    A_O: "a_o" "a_\"o\"" M / M [positive], "Half the distance of the ropes along the beam, on the trolley.", "input";
    A_U: "a_u" "a_\"u\"" M / M [positive], "Half the distance of the ropes along the beam, on the spreader.", "input";
    B_O: "b_o" "b_\"o\"" M / M [positive], "Half the distance of the ropes across the beam, on the trolley.", "input";
    B_U: "b_u" "b_\"u\"" M / M [positive], "Half the distance of the ropes across the beam, on the spreader.", "input";
    E_Q: "e_q" "e_Q" M / M [not_negative], "Centre of gravity of spreader and container, below the spreader's rope joints.", "input";
    I_Q: "i_q" "i_Q" M / M [positive], "Radius of gyration of spreader and container in the plane of the travel.", "input";
    I_Z: "i_z" "i_z" M / M [positive], "Radius of gyration of spreader and container about the vertical.", "input";
    D_Q: "d_q" "d_Q" M / M, "Distance of the centre of gravity of spreader and container from the middle, across the beam.", "input";
    E_X: "e_x" "e_x" M / M, "Distance of the centre of gravity of spreader and container from the middle, along the beam to the sea side.", "input";
    F_BR: "F_br" "F_\"br\"" N / KN [positive], "Force of the trolley's brakes at its wheels or its tow rope, all together.", "input";
    V_C: "v_c" "v_\"c\"" M_PER_S / M_PER_S [positive], "Speed that a start of the trolley comes to.", "input";
    A_C: "a_c" "a_\"c\"" M_PER_S2 / M_PER_S2 [positive], "Acceleration of a start.", "input";
    S_C: "s_c" "s_\"c\"" M / M [positive], "Way of the trolley from ship to quay.", "input";
    T_E: "t_e" "t_\"e\"" S / S [not_negative], "Time of a cycle besides the travel of the trolley.", "input";
    L_S: "l_s" "l_\"s\"" M / M [positive], "Length of the slings, from the spreader to the load's centre of gravity.", "input";
    E_S: "e_s" "e_\"s\"" M / M [not_negative], "Joints of the slings, below the spreader's rope joints.", "input";
    E_1: "e_1" "e_1" M / M [not_negative], "Centre of gravity of the spreader alone, below its rope joints.", "input";
    I_1: "i_1" "i_1" M / M [positive], "Radius of gyration of the spreader alone in the plane of the travel.", "input";
    STEP: "step" "h" S / S [positive], "Longest step of the solver.", "input";

    // The trolley.
    W: "W" "W" N / KN, "Weight of spreader and container.", "equilibrium";
    F_MU: "F_mu" "F_mu" N / KN [not_negative], "Resistance of the trolley's wheels.", "[Ports001, 7.4]";
    F_W: "F_w" "F_\"w\"" N / KN [not_negative], "Force of the wind on trolley and load.", "[Ports001, 7.4]";
    F_S: "F_s" "F_\"s\"" N / KN [not_negative], "Resistance of the sheaves that the hoisting ropes pass as the trolley travels.", "[Ports001, 7.4]";
    F_GAMMA: "F_gamma" "F_gamma" N / KN, "Force of the slope on trolley and load; positive where it asks for a push to the sea side.", "equilibrium";
    F_A: "F_a" "F_\"a\"" N / KN, "Force that accelerates the trolley and its load, which hangs back steadily; positive to the sea side.", "Newton and Euler";
    F_R: "F_r" "F_\"r\"" N / KN, "Force that the travel of the trolley asks for; positive to the sea side.", "[Ports001, 7.4]";
    P_T: "P_t" "P_\"t\"" W / KW, "Power of the travel motor; negative where it brakes.", "[Ports001, 7.4]";
    P_H: "P_h" "P_\"h\"" W / KW, "Power of the hoisting motor; negative where it brakes.", "[Ports001, 7.4]";
    N_R: "N_r" "N_\"r\"" N / KN [not_negative], "Load of a wheel of the trolley on the beam.", "equilibrium";
    R_1: "R_1" "R_1" N / KN, "Load of the sea side's rail by trolley and load.", "equilibrium";
    R_2: "R_2" "R_2" N / KN, "Load of the land side's rail by trolley and load; negative where they lift it.", "equilibrium";
    F_AD: "F_ad" "F_\"ad\"" N / KN, "Force that the driven wheels can give before they slip.", "Coulomb";
    K_AD: "k_ad" "k_\"ad\"" ONE / ONE [infinite("where the trolley asks for no force")], "Safety against slipping of the driven wheels.", "Coulomb";
    A_AD: "a_ad" "a_\"ad\"" M_PER_S2 / M_PER_S2, "Greatest acceleration of a start before the driven wheels slip.", "Coulomb";

    F_DO: "F_do" "F_\"do\"" N / KN, "Force that drives a trolley on that is to stop: wind from behind and the slope, less its resistances.", "[Ports001, 7.4]";
    F_BN: "F_bn" "F_\"bn\"" N / KN, "Force that a stop at the acceleration of a start asks of the brakes.", "Newton and Euler";
    NU_BR: "nu_br" "nu_\"br\"" ONE / ONE [infinite("where the resistances alone stop it")], "Force of the brakes over that which a stop asks for.", "derived";
    A_BR: "a_br" "a_\"br\"" M_PER_S2 / M_PER_S2, "Deceleration under all of the brakes' force.", "Newton and Euler";
    T_BR: "t_br" "t_\"br\"" S / S, "Time of a stop under all of the brakes' force.", "derived";
    S_BR: "s_br" "s_\"br\"" M / M, "Way of a stop under all of the brakes' force.", "derived";
    K_BR: "k_br" "k_\"br\"" ONE / ONE, "Safety of the braked wheels against sliding.", "Coulomb";

    // The tow rope.
    T_1: "T_1" "T_1" N / KN, "Tension of a tow rope on the sea side.", "equilibrium";
    T_2: "T_2" "T_2" N / KN, "Tension of a tow rope on the land side.", "equilibrium";
    F_1: "f_1" "f_1" M / M, "Sag of a tow rope on the sea side.", "equilibrium";
    F_2: "f_2" "f_2" M / M, "Sag of a tow rope on the land side.", "equilibrium";
    F_TOW: "f_tow" "f" M / M, "Greater of both sags.", "derived";
    DELTA_1: "delta_1" "delta_1" M / MM, "Stretch of a tow rope from its sheave on the sea side to the trolley.", "Hooke";
    DELTA_2: "delta_2" "delta_2" M / MM, "Stretch of a tow rope from its sheave on the land side to the trolley.", "Hooke";
    NU: "nu" "nu" ONE / ONE, "Least breaking force over tension of a tow rope.", "derived";

    // The suspension.
    C_R: "c_r" "c_\"r\"" M / M, "Half of how much closer the ropes are along the beam on the spreader than on the trolley; zero where they are parallel.", "derived";
    C_X: "c_x" "c_x" M / M, "The same across the beam.", "derived";
    H_R: "h_r" "h_\"r\"" M / M [positive], "Height of the trolley's rope joints above those of the spreader.", "derived";
    KAPPA_R: "kappa_r" "kappa" PER_M / PER_M, "Turn of the spreader against the sway, over its travel.", "derived";
    D_R: "D_r" "D" ONE / ONE, "Mass of the load that sways, over that of a load on parallel ropes.", "Lagrange";
    D_K: "D_k" "D_kappa" ONE / ONE, "That mass without what a change of the ropes' length takes of it.", "Lagrange";
    E_R: "E_r" "E" ONE / ONE, "What brings the load back, over that on parallel ropes.", "Lagrange";
    L_E: "l_e" "l_\"e\"" M / M [positive], "Length of the simple pendulum that sways as the load on its four ropes does.", "Lagrange";
    LAMBDA_E: "lambda_e" "lambda_\"e\"" ONE / ONE, "Change of that length over the change of the ropes' length.", "Lagrange";
    NU_X: "nu_x" "nu_x" ONE / ONE, "Part of the trolley's acceleration that the sway feels.", "Lagrange";
    OMEGA_E: "omega_e" "omega_\"e\"" RAD_PER_S / RAD_PER_S [positive], "Frequency of small sway on the four ropes.", "Lagrange";
    OMEGA_G: "omega_g" "omega_\"g\"" RAD_PER_S / RAD_PER_S [positive], "Frequency of a simple pendulum on one rope as long.", "derived";
    K_OMEGA: "k_omega" "k_omega" ONE / ONE, "The first of these frequencies over the second one.", "derived";
    T_S: "T_s" "T" S / S [positive], "Period of small sway on the four ropes.", "derived";
    T_G: "T_g" "T_\"g\"" S / S [positive], "Period of a simple pendulum on one rope as long.", "derived";
    U_L: "u_l" "u_\"l\"" M / M, "Travel of the spreader's middle to the sea side, by a load out of the middle along the beam.", "equilibrium";
    BETA_L: "beta_l" "beta_\"l\"" RAD / DEG, "List of the spreader; positive where its sea side hangs lower.", "equilibrium";
    S_R1: "S_r1" "S_1" N / KN, "Pull of a rope of the load on the sea side.", "equilibrium";
    S_R2: "S_r2" "S_2" N / KN, "Pull of a rope of the load on the land side.", "equilibrium";
    A_Z: "A_z" "A_z" M2 / M2, "Product of the ropes' arms about the vertical.", "derived";
    OMEGA_Z: "omega_z" "omega_z" RAD_PER_S / RAD_PER_S [positive], "Frequency of small skew: spreader and container turn about the vertical.", "Lagrange";
    T_Z: "T_z" "T_z" S / S [positive], "Period of small skew.", "derived";
    PSI_Z: "psi_z" "psi_z" RAD / DEG, "Skew while the trolley accelerates steadily, its load out of the middle.", "equilibrium";

    // Spreader and load as two bodies.
    MU_S: "mu_s" "mu_\"s\"" ONE / ONE [positive], "Weight of the spreader over that of the load.", "derived";
    D_S1: "D_s1" "D_1" ONE / ONE [positive], "Mass of the spreader alone that sways, over that of one on parallel ropes.", "Lagrange";
    E_S1: "E_s1" "E_1" ONE / ONE, "What brings the spreader alone back, over that on parallel ropes.", "Lagrange";
    E_S2: "E_s2" "E_\"s\"" ONE / ONE, "What brings a weight at the slings' joints back, over that on parallel ropes.", "Lagrange";
    A_S: "a_s" "a" ONE / ONE, "Mass of both bodies that travels with the spreader, over that of the load.", "Lagrange";
    B_S: "b_s" "b" ONE / ONE, "Travel of the slings' joints over that of the spreader's middle.", "derived";
    P_S: "p_s" "p" PER_S2 / PER_S2, "What brings both bodies back on the ropes, over the load's mass.", "Lagrange";
    Q_S: "q_s" "q" PER_S2 / PER_S2, "What brings the load back on its slings, over its mass.", "Lagrange";
    W_S: "w_s" "w" PER_S2 / PER_S2 [positive], "Sum that both frequencies are taken from: so nothing cancels.", "Lagrange";
    OMEGA_S1: "omega_s1" "omega_(\"s\" 1)" RAD_PER_S / RAD_PER_S [positive], "Lower frequency of small sway of spreader and load as two bodies.", "Lagrange";
    OMEGA_S2: "omega_s2" "omega_(\"s\" 2)" RAD_PER_S / RAD_PER_S [positive], "Upper frequency of small sway of spreader and load as two bodies.", "Lagrange";
    T_S1: "T_s1" "T_(\"s\" 1)" S / S [positive], "Period of the lower frequency.", "derived";
    T_S2: "T_s2" "T_(\"s\" 2)" S / S [positive], "Period of the upper frequency.", "derived";
    SIGMA_S1: "sigma_s1" "sigma_1" ONE / ONE, "Travel of the load by its slings over that of the spreader, at the lower frequency.", "Lagrange";
    SIGMA_S2: "sigma_s2" "sigma_2" ONE / ONE, "Travel of the load by its slings over that of the spreader, at the upper frequency.", "Lagrange";
    GAMMA_S1: "gamma_s1" "gamma_1" M / M, "Travel by which the load would hang back at the lower frequency under a steady acceleration of g.", "Lagrange";
    GAMMA_S2: "gamma_s2" "gamma_2" M / M, "Travel by which the load would hang back at the upper frequency under a steady acceleration of g.", "Lagrange";
    X_11: "x_11" "x_(1 1)" M / M [not_negative], "Travel of the load that a start leaves at the lower frequency where it is made for the period of that.", "equations of motion";
    X_12: "x_12" "x_(1 2)" M / M [not_negative], "Travel of the load that a start leaves at the upper frequency where it is made for the period of the lower one.", "equations of motion";
    X_21: "x_21" "x_(2 1)" M / M [not_negative], "Travel of the load that a start leaves at the lower frequency where it is made for the period of the upper one.", "equations of motion";
    X_1R: "x_1r" "x_(1 \"run\")" M / M [not_negative], "Greatest travel of the load from the trolley that a start leaves in a run of the model where it is made for the period of the lower frequency.", "equations of motion";
    X_2R: "x_2r" "x_(2 \"run\")" M / M [not_negative], "Greatest travel of the load from the trolley that a start leaves in a run of the model where it is made for the period of the upper frequency.", "equations of motion";
    X_22: "x_22" "x_(2 2)" M / M [not_negative], "Travel of the load that a start leaves at the upper frequency where it is made for the period of that.", "equations of motion";

    // Cycle and profiles.
    T_TR: "t_tr" "t_\"tr\"" S / S, "Time of the way, from rest to rest.", "derived";
    T_CYC: "t_cyc" "t_\"cyc\"" S / S, "Time of a cycle: two ways, and the rest.", "derived";
    A_P1: "a_p1" "a_(\"p\" 1)" M_PER_S2 / M_PER_S2, "Acceleration of the one pulse of a period's length.", "equations of motion";
    T_P1: "t_p1" "t_(\"p\" 1)" S / S, "Duration of the one pulse.", "equations of motion";
    PHI_P1: "phi_p1" "phi_(\"p\" 1)" RAD / DEG, "Greatest sway in the one pulse.", "equations of motion";
    RHO_P1: "rho_p1" "rho_(\"p\" 1)" RAD / DEG [not_negative], "Sway that the one pulse leaves where it is made for another period: in the formula for the simple pendulum's.", "equations of motion";
    A_P2: "a_p2" "a_(\"p\" 2)" M_PER_S2 / M_PER_S2, "Acceleration of the two equal pulses together.", "equations of motion";
    T_P2: "t_p2" "t_(\"p\" 2)" S / S, "Duration of the two equal pulses, half a period apart.", "equations of motion";
    PHI_P2: "phi_p2" "phi_(\"p\" 2)" RAD / DEG, "Greatest sway in the two equal pulses.", "equations of motion";
    RHO_P2: "rho_p2" "rho_(\"p\" 2)" RAD / DEG [not_negative], "Sway that the two equal pulses leave where they are made for another period: in the formula for the simple pendulum's.", "equations of motion";
    A_P3: "a_p3" "a_(\"p\" 3)" M_PER_S2 / M_PER_S2, "Acceleration of the start by sixths of a period.", "equations of motion";
    T_P3: "t_p3" "t_(\"p\" 3)" S / S, "Duration of the start by sixths: on, off, on for as long as it takes, off, on.", "equations of motion";
    PHI_P3: "phi_p3" "phi_(\"p\" 3)" RAD / DEG, "Greatest sway in the start by sixths: it hangs back steadily.", "equations of motion";
    RHO_P3: "rho_p3" "rho_(\"p\" 3)" RAD / DEG [not_negative], "Sway that the start by sixths leaves where it is made for another period: in the formula for the simple pendulum's.", "equations of motion";
    A_P4: "a_p4" "a_(\"p\" 4)" M_PER_S2 / M_PER_S2, "Acceleration of the three pulses together, of which the middle one is as great as both others.", "[Singer1990, 76–82]";
    T_P4: "t_p4" "t_(\"p\" 4)" S / S, "Duration of the three pulses, half a period apart.", "[Singer1990, 76–82]";
    PHI_P4: "phi_p4" "phi_(\"p\" 4)" RAD / DEG, "Greatest sway in the three pulses.", "equations of motion";
    RHO_P4: "rho_p4" "rho_(\"p\" 4)" RAD / DEG [not_negative], "Sway that the three pulses leave where they are made for another period: in the formula for the simple pendulum's.", "equations of motion";

    // In motion.
    F_DR: "F_dr" "F_\"dr\"" N / KN, "Force of the travel drive on a trolley whose load sways; positive to the sea side.", "Newton and Euler";
    P_DR: "P_dr" "P_\"dr\"" W / KW, "Power of the travel motor of a trolley whose load sways; negative where it brakes.", "derived";

    // The whole range.
    F_RT_MAX: "F_rt_max" "F_(\"r\",max)" N / KN, "Greatest force in the working range that the travel asks for, by amount.", "derived";
    P_TT_MAX: "P_tt_max" "P_(\"t\",max)" W / KW, "Greatest power of the travel motor in the working range, by amount.", "derived";
    R_1_MAX: "R_1_max" "R_(1,max)" N / KN, "Greatest load of the sea side's rail in the working range.", "derived";
    R_2_MIN: "R_2_min" "R_(2,min)" N / KN, "Least load of the land side's rail in the working range.", "derived";
    F_TOW_MAX: "f_tow_max" "f_max" M / M, "Greatest sag of a tow rope in the working range.", "derived";
    NU_TOW_MIN: "nu_tow_min" "nu_min" ONE / ONE, "Least safety of a tow rope in the working range.", "derived";
    K_AD_MIN: "k_ad_min" "k_(\"ad\",min)" ONE / ONE [infinite("where the trolley asks for no force")], "Least safety against slipping in the working range.", "derived";
    NUMBER: "number" "i" ONE / ONE, "Number of a start: one pulse, two equal pulses, sixths of a period, three pulses; plain under feedback.", "input";
    A_P: "a_p" "a_(\"p\" i)" M_PER_S2 / M_PER_S2, "Acceleration of a profile.", "equations of motion";
    T_P: "t_p" "t_(\"p\" i)" S / S, "Duration of a profile.", "equations of motion";
    PHI_P: "phi_p" "phi_(\"p\" i)" RAD / DEG, "Greatest sway in a profile.", "equations of motion";
    PHI_RUN: "phi_run" "phi_(\"run\" i)" RAD / DEG, "The same in a run of the model.", "equations of motion";
    RHO_E: "rho_e" "rho_(\"e\" i)" RAD / DEG [not_negative], "Sway that a profile leaves which has the period of the four ropes.", "equations of motion";
    RHO_RUN: "rho_run" "rho_(\"run\" i)" RAD / DEG [not_negative], "The same in a run of the model.", "equations of motion";
    RHO_G: "rho_g" "rho_(\"g\" i)" RAD / DEG [not_negative], "Sway that a profile leaves which has the simple pendulum's period.", "equations of motion";
    RHO_G_RUN: "rho_g_run" "rho_(\"gr\" i)" RAD / DEG [not_negative], "The same in a run of the model.", "equations of motion";
    RHO_LL: "rho_ll" "rho_(\"l\" i)" RAD / DEG [not_negative], "Sway that a profile leaves on ropes that are 10 % longer.", "equations of motion";
    AGREEMENT: "agreement" "delta" ONE / ONE, "Difference of two independent ways, relative to the largest value.", "derived";
}

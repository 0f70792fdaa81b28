//! Every quantity of a grab unloader.

pub use crate::kernel::gravity::G;
use crate::kernel::symbol::{Range, symbols};
pub use crate::parts::hanging::{L_R, PHI_R, Y_Q};
pub use crate::sway::pendulum::{A_L, D_L_R, D_OMEGA_R, D_PHI_R, D_V_T, D_X_T, X_L, X_T, ZETA_F};

symbols! {
    // Given.
    V_T: "v_t" "v_\"t\"" M_PER_S / M_PER_S, "Speed of the trolley; positive to the sea side.", "input";
    A_T: "a_t" "a_\"t\"" M_PER_S2 / M_PER_S2, "Acceleration of the trolley; positive to the sea side.", "input";
    FROM: "from" "v_a" M_PER_S / M_PER_S, "Speed of the trolley at the start of the working range.", "input";
    TO: "to" "v_e" M_PER_S / M_PER_S, "Speed of the trolley at the end of the working range.", "input";
    V_H: "v_h" "v_\"h\"" M_PER_S / M_PER_S, "Hoisting speed of the grab; positive upward.", "input";
    V_C: "v_c" "v_\"c\"" M_PER_S / M_PER_S, "Speed of the closing ropes against the hoisting ropes; positive where the grab closes.", "input";
    K_Q: "k_q" "k_Q" ONE / PERCENT [from_to(0.0, 1.0)], "Contents of the grab over its full load.", "input";
    LAMBDA_C: "lambda_c" "lambda" ONE / PERCENT [from_to(0.0, 1.0), unconfirmed], "Part of the weight of grab and contents that the closing ropes bear.", "input";
    G_G: "G_g" "G_\"g\"" N / KN [positive], "Weight of the empty grab.", "input";
    Q_N: "Q_n" "Q_n" N / KN [positive], "Weight of the full load in the grab.", "input";
    G_T: "G_t" "G_\"t\"" N / KN [positive], "Weight of the trolley.", "input";
    MU_T: "mu_t" "mu" ONE / ONE [from_to(0.0, 1.0), unconfirmed], "Resistance of the trolley's wheels, over what they bear.", "input";
    P_W: "p_w" "p_\"w\"" PA / PA [not_negative], "Pressure of the wind, against the travel of the trolley.", "input";
    A_W: "A_w" "A_\"w\"" M2 / M2 [not_negative], "Wind area of trolley and grab with its shape coefficient.", "input";
    ETA_R: "eta_r" "eta_\"r\"" ONE / ONE [above_to(0.0, 1.0), unconfirmed], "Efficiency of a rope sheave.", "input";
    ETA_D: "eta_d" "eta_\"d\"" ONE / ONE [above_to(0.0, 1.0)], "Efficiency between motor and rope.", "input";
    T_0: "T_0" "T_0" N / KN [positive], "Tension of the trolley's slack rope, by its permitted sag.", "input";
    G_A: "G_a" "G_\"a\"" N / KN [positive], "Weight of the auxiliary trolley.", "input";
    F_BA: "F_ba" "F_\"ba\"" N / KN [positive], "Least breaking force of a rope of the auxiliary trolley.", "input";
    Z_A: "z_a" "z_\"a\"" ONE / ONE [within(Range::new(1.0, 16.0))], "Number of the auxiliary trolley's own ropes.", "input";
    D_D: "d_d" "d_i" M / M [positive], "Diameter of a drum, to the middle of its rope.", "input";
    Z_R: "z_r" "z_i" ONE / ONE [within(Range::new(1.0, 16.0))], "Number of ropes that a drum winds; of the trolley's drum to each side.", "input";
    F_B: "F_b" "F_(\"b\" i)" N / KN [positive], "Least breaking force of a rope of a drum.", "input";
    K: "k" "k" ONE / ONE [positive], "Teeth of the ring gear over those of the sun.", "input";
    K_B: "k_b" "k_\"b\"" ONE / ONE [positive, unconfirmed], "Torque of a brake over that which it holds.", "input";
    PHI_2_MIN: "phi_2_min" "phi_(2,min)" ONE / ONE [within(Range::new(1.0, 10.0)), unconfirmed], "Least dynamic factor of a lifted load.", "[Ports001, 5.9.3]";
    BETA_2: "beta_2" "beta_2" S_PER_M / S_PER_M [not_negative, unconfirmed], "Rise of the dynamic factor with the hoisting speed.", "[Ports001, 5.9.3]";
    T_P: "t_p" "t_i" S / S [positive], "Duration of a phase of the cycle.", "input";
    V_HP: "v_hp" "v_(\"h\" i)" M_PER_S / M_PER_S, "Hoisting speed of the grab in a phase; positive upward.", "input";
    V_CP: "v_cp" "v_(\"c\" i)" M_PER_S / M_PER_S, "Speed of the closing ropes against the hoisting ropes in a phase; positive where the grab closes.", "input";
    V_TP: "v_tp" "v_(\"t\" i)" M_PER_S / M_PER_S, "Speed of the trolley in a phase; positive to the sea side.", "input";
    A_TP: "a_tp" "a_(\"t\" i)" M_PER_S2 / M_PER_S2, "Acceleration of the trolley in a phase; positive to the sea side.", "input";
    K_QP: "k_qp" "k_(Q i)" ONE / PERCENT [from_to(0.0, 1.0)], "Contents of the grab over its full load in a phase.", "input";
    LAMBDA_P: "lambda_p" "lambda_i" ONE / PERCENT [from_to(0.0, 1.0), unconfirmed], "Part of the weight of grab and contents that the closing ropes bear in a phase.", "input";
    V_M: "v_m" "v_\"m\"" M_PER_S / M_PER_S [positive], "Speed of the trolley on its way from ship to hopper.", "input";
    A_M: "a_m" "a_\"m\"" M_PER_S2 / M_PER_S2 [positive], "Acceleration of the trolley at both ends of its way.", "input";
    S_M: "s_m" "s_\"m\"" M / M [positive], "Way of the trolley from ship to hopper.", "input";
    STEP: "step" "h" S / S [positive], "Longest step of the solver.", "input";

    // The trolley.
    W: "W" "W" N / KN, "Weight of grab and contents.", "equilibrium";
    F_MU: "F_mu" "F_mu" N / KN [not_negative], "Resistance of the trolley's wheels.", "[Ports001, 7.5]";
    F_W: "F_w" "F_\"w\"" N / KN [not_negative], "Force of the wind on trolley and grab.", "[Ports001, 7.5]";
    F_S: "F_s" "F_\"s\"" N / KN [not_negative], "Resistance of the sheaves that the ropes pass as the trolley travels.", "[Ports001, 7.5]";
    F_A: "F_a" "F_\"a\"" N / KN, "Force that accelerates trolley and grab; positive to the sea side.", "Newton and Euler";
    F_R: "F_r" "F_\"r\"" N / KN, "Force that the travel of the trolley asks for; positive to the sea side.", "[Ports001, 7.5]";
    V_AUX: "v_aux" "v_\"aux\"" M_PER_S / M_PER_S, "Speed of the auxiliary trolley; positive to the sea side.", "[Ports001, 5.8.3]";
    D_L: "d_l" "dot(l)_\"r\"" M_PER_S / M_PER_S, "Rate at which travelling makes the rope longer between its drum and the grab.", "[Ports001, 5.8.3]";
    F_RA: "F_ra" "F_\"ra\"" N / KN, "Force that the travel of the auxiliary trolley asks for; positive to the sea side.", "[Ports001, 5.8.3]";
    T_AUX: "T_aux" "T_\"aux\"" N / KN, "Pull of the auxiliary trolley's own rope, to the land side.", "equilibrium";

    // Ropes of the trolley.
    F_T: "F_t" "F_\"t\"" N / KN, "Force of its ropes on the trolley: the tension of the sea side less that of the land side.", "equilibrium";
    T_1: "T_1" "T_1" N / KN, "Tension of the ropes on the trolley's sea side.", "equilibrium";
    T_2: "T_2" "T_2" N / KN, "Tension of the ropes on the trolley's land side.", "equilibrium";
    T_LOW: "T_low" "T_\"low\"" N / KN, "Smaller of both tensions; a rope that would have to push is slack.", "derived";
    F_D: "F_d" "F_\"d\"" N / KN, "Force at the drive of the trolley, for its speed; positive to the sea side.", "virtual work";
    SLACK: "slack" "\"slack\"" ONE / ONE [boolean], "Whether a rope of the trolley is slack.", "derived";
    Z_SLACK: "z.slack" "z_1" ONE / ONE, "Falls below zero where a rope of the trolley gets slack.", "event";

    // Drums.
    V_R: "v_r" "v_(\"r\" i)" M_PER_S / M_PER_S, "Speed with which a drum winds its rope.", "[Ports001, 5.8]";
    N_D: "n_d" "n_i" PER_S / PER_MIN, "Speed of a drum; positive where it winds.", "[Ports001, 5.8]";
    S_R: "S_r" "S_i" N / KN, "Greatest pull in the ropes of a drum, all together.", "equilibrium";
    F_I: "F_i" "F_i" N / KN, "Force of the ropes against which a drum winds.", "equilibrium";
    M_D: "M_d" "M_i" N_M / KN_M, "Torque that a drum needs; positive where it winds.", "equilibrium";
    P_D: "P_d" "P_i" W / KW, "Power that a drum needs; negative where it drives.", "derived";

    // Differentials.
    N_S: "n_s" "n_(\"s\" i)" PER_S / PER_MIN, "Speed of the sun of a drum's differential, which the hoisting or closing motor turns.", "[Ports001, 5.8.1]";
    N_R: "n_r" "n_(\"r\" i)" PER_S / PER_MIN, "Speed of the ring gear of a drum's differential, which the travel motor turns.", "[Ports001, 5.8.1]";
    T_S: "T_s" "T_(\"s\" i)" N_M / KN_M, "Torque on the sun of a drum's differential.", "[Ports001, 5.8.1]";
    T_R: "T_r" "T_(\"r\" i)" N_M / KN_M, "Torque on the ring gear of a drum's differential.", "[Ports001, 5.8.1]";
    P_S: "P_s" "P_(\"s\" i)" W / KW, "Power into the sun of a drum's differential.", "derived";
    P_R: "P_r" "P_(\"r\" i)" W / KW, "Power into the ring gear of a drum's differential; negative where it comes back.", "derived";
    N_DS: "n_ds" "n_(\"ds\" i)" PER_S / PER_MIN, "Speed of a drum while a brake holds the ring gear: the travel motor stands.", "[Ports001, 5.8.1]";
    N_DR: "n_dr" "n_(\"dr\" i)" PER_S / PER_MIN, "Speed of a drum while a brake holds the sun: the hoisting or closing motor stands.", "[Ports001, 5.8.1]";
    T_BS: "T_bs" "T_(\"bs\" i)" N_M / KN_M, "Torque of a brake on the sun of a drum's differential.", "equilibrium";
    T_BR: "T_br" "T_(\"br\" i)" N_M / KN_M, "Torque of a brake on the ring gear of a drum's differential.", "equilibrium";
    P_CIRC: "P_circ" "P_\"circ\"" W / KW [not_negative], "Power that goes round: from the ring gears of one side over the travel shaft to those of the other one.", "[Ports001, 5.8.1]";

    // Motors and load.
    P_H: "P_h" "P_\"h\"" W / KW, "Power of the hoisting motor; negative where it brakes.", "[Ports001, 5.9]";
    P_C: "P_c" "P_\"c\"" W / KW, "Power of the closing motor; negative where it brakes.", "[Ports001, 5.9]";
    P_T: "P_t" "P_\"t\"" W / KW, "Power of the travel motor; negative where it brakes.", "[Ports001, 5.9]";
    PHI_2: "phi_2" "phi_2" ONE / ONE, "Dynamic factor of the lifted load.", "[Ports001, 5.9.3]";
    W_2: "W_2" "W_2" N / KN, "Weight of grab and contents with the dynamic factor.", "[Ports001, 5.9.3]";

    // Sway of the grab.
    OMEGA_G: "omega_g" "omega_\"g\"" RAD_PER_S / RAD_PER_S [positive], "Frequency of small sway of the grab.", "equations of motion";
    T_G: "T_g" "T_\"g\"" S / S [positive], "Period of small sway of the grab.", "equations of motion";
    PHI_ST: "phi_st" "phi_\"st\"" RAD / DEG [not_negative], "Sway by which the grab hangs back steadily at the acceleration of the way.", "equations of motion";
    RHO_PL: "rho_pl" "rho_\"pl\"" RAD / DEG [not_negative], "Sway that a plain start leaves.", "equations of motion";
    T_PL: "t_pl" "t_\"pl\"" S / S, "Time of the way, plain.", "derived";
    T_PR: "t_pr" "t_\"pr\"" S / S, "Time of the way that is programmed by sixths of the period.", "[Ports001, 5.10]";
    T_WAY: "t_way" "t_i" S / S, "Time of a way, of feedback with one period of the sway after it.", "equations of motion";
    PHI_WAY: "phi_way" "phi_i" RAD / DEG [not_negative], "Greatest sway on a way.", "equations of motion";
    RHO_WAY: "rho_way" "rho_i" RAD / DEG [not_negative], "Greatest sway in a period after a way.", "equations of motion";
    RHO_LL: "rho_ll" "rho_(\"l\" i)" RAD / DEG [not_negative], "The same of ropes that are 10 % longer than thought.", "equations of motion";
    T_PG: "t_pg" "t" S / S, "Time since the start of the way.", "derived";
    A_PG: "a_pg" "a_\"pg\"" M_PER_S2 / M_PER_S2, "Acceleration of the programme by the predicted angle, from this time on; positive to the sea side.", "[Ports001, 5.10.2]";

    // Phases of the cycle.
    W_P: "W_p" "W_i" N / KN, "Weight of grab and contents in a phase.", "equilibrium";
    F_RP: "F_rp" "F_(\"r\" i)" N / KN, "Force that the travel of the trolley asks for in a phase; positive to the sea side.", "[Ports001, 7.5]";
    T_1P: "T_1p" "T_(1 i)" N / KN, "Tension of the ropes on the trolley's sea side in a phase.", "equilibrium";
    T_2P: "T_2p" "T_(2 i)" N / KN, "Tension of the ropes on the trolley's land side in a phase.", "equilibrium";
    F_DP: "F_dp" "F_(\"d\" i)" N / KN, "Force at the drive of the trolley in a phase, for its speed; positive to the sea side.", "virtual work";
    S_HP: "S_hp" "S_(\"h\" i)" N / KN [not_negative], "Greatest pull of a hoisting drum's ropes in a phase.", "equilibrium";
    S_CP: "S_cp" "S_(\"c\" i)" N / KN [not_negative], "Greatest pull of a closing drum's ropes in a phase.", "equilibrium";
    NU_P: "nu_p" "nu_i" ONE / ONE [infinite("where no rope is under tension")], "Least breaking force over pull of all ropes in a phase.", "derived";
    P_HP: "P_hp" "P_(\"h\" i)" W / KW, "Power of the hoisting motor in a phase.", "[Ports001, 5.9]";
    P_CP: "P_cp" "P_(\"c\" i)" W / KW, "Power of the closing motor in a phase.", "[Ports001, 5.9]";
    P_TP: "P_tp" "P_(\"t\" i)" W / KW, "Power of the travel motor in a phase.", "[Ports001, 5.9]";

    T_HP: "t_hp" "t_(\"h\" i)" S / S [not_negative], "Time for which the hoisting motor turns in a phase.", "derived";
    T_CP: "t_cp" "t_(\"c\" i)" S / S [not_negative], "Time for which the closing motor turns in a phase.", "derived";
    T_TP: "t_tp" "t_(\"t\" i)" S / S [not_negative], "Time for which the travel motor turns in a phase.", "derived";

    // The cycle.
    T_CYC: "t_cyc" "t_\"cyc\"" S / S, "Time of a cycle.", "derived";
    Q_CYC: "q_cyc" "q" KG_PER_S / T_PER_H, "Rate of the unloader: a full load in each cycle.", "derived";
    W_MAX: "W_max" "W_max" N / KN, "Greatest weight of grab and contents in the cycle.", "derived";
    K_P: "k_p" "K_p" ONE / ONE, "Load spectrum factor.", "[Ports001, 5.9.1]";
    P_H_RMS: "P_h_rms" "P_(\"h\",\"rms\")" W / KW, "Root mean square of the hoisting motor's power over the cycle.", "[Ports001, 5.9.1]";
    P_C_RMS: "P_c_rms" "P_(\"c\",\"rms\")" W / KW, "Root mean square of the closing motor's power over the cycle.", "[Ports001, 5.9.1]";
    P_T_RMS: "P_t_rms" "P_(\"t\",\"rms\")" W / KW, "Root mean square of the travel motor's power over the cycle.", "[Ports001, 5.9.1]";
    ED_H: "ED_h" "\"ED\"_\"h\"" ONE / PERCENT [from_to(0.0, 1.0)], "Cyclic duration factor of the hoisting motor: part of the cycle for which it turns.", "[Ports001, 5.9.1]";
    ED_C: "ED_c" "\"ED\"_\"c\"" ONE / PERCENT [from_to(0.0, 1.0)], "Cyclic duration factor of the closing motor: part of the cycle for which it turns.", "[Ports001, 5.9.1]";
    ED_T: "ED_t" "\"ED\"_\"t\"" ONE / PERCENT [from_to(0.0, 1.0)], "Cyclic duration factor of the travel motor: part of the cycle for which it turns.", "[Ports001, 5.9.1]";

    // The whole range.
    S_MAX: "S_max" "S_max" N / KN, "Greatest pull in the ropes of a drum in the working range.", "derived";
    T_MIN: "T_min" "T_min" N / KN, "Least tension of a rope of the trolley in the working range; negative where it is slack.", "derived";
    P_T_MAX: "P_t_max" "P_(\"t\",max)" W / KW, "Greatest power of the travel motor in the working range, by amount.", "derived";
    P_CIRC_MAX: "P_circ_max" "P_(\"circ\",max)" W / KW, "Greatest power in the working range that goes round.", "derived";
    NU_MIN: "nu_min" "nu_min" ONE / ONE [infinite("where no rope is under tension")], "Least breaking force over pull of all ropes in all phases.", "derived";
    N_1: "n_1" "n_1" PER_S / PER_MIN, "Speed of drum 1.", "[Ports001, 5.8]";
    N_2: "n_2" "n_2" PER_S / PER_MIN, "Speed of drum 2.", "[Ports001, 5.8]";
    N_3: "n_3" "n_3" PER_S / PER_MIN, "Speed of drum 3.", "[Ports001, 5.8]";
    N_4: "n_4" "n_4" PER_S / PER_MIN, "Speed of drum 4.", "[Ports001, 5.8]";
    NUMBER: "number" "i" ONE / ONE, "Number of a phase, of a drum, of a way.", "input";
    AGREEMENT: "agreement" "delta" ONE / ONE, "Difference of two independent ways, relative to the largest value.", "derived";
}

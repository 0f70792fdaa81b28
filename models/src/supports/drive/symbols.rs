//! Quantities of a slewing drive besides those that any motor with a brake has.

pub use crate::drive::symbols::R_Z;
pub use crate::kernel::gravity::G;
use crate::kernel::symbol::symbols;
pub use crate::parts::hanging::L_R;
pub use crate::parts::motor::{
    A_START, A_START_MAX, A_STOP, A_STOP_MAX, J_K, J_M, J_START, K_A, K_B, LAMBDA_M, N_MOT, N_N, N_S, OMEGA_B, P_M,
    P_M_MAX, P_N, PSI_B, T_0, T_B, T_START, T_START_MAX, T_STOP, T_STOP_MAX, TAU_B, U_M, U_M_MAX,
};
pub use crate::parts::slip::{J_D, M_LIM};
pub use crate::parts::starts::{A_ENG, A_INV, A_SLIP, T_ENG, T_INV, T_SLIP};
pub use crate::parts::teeth::{ALPHA_T, E_T, K_F, M_T, NU_T, RHO_C, Y_F};

symbols! {
    // Given.
    ALPHA_Q: "alpha_Q" "alpha_(Q i)" RAD / DEG [from_to(0.0, 1.0)], "Sway of the load's rope across the boom in a case, against a start and with a stop; where zero the load has its inertia instead.", "[Ports001, 6.5.1]";
    Z_D: "z_d" "z_d" ONE / ONE [from_to(1.0, 16.0)], "Number of drives, all alike.", "input";
    I_SL: "i_sl" "i_\"sl\"" ONE / ONE [positive], "Turns of a motor for one of the crane.", "[Ports001, 6.5.4]";
    ETA_SL: "eta_sl" "eta_\"sl\"" ONE / ONE [above_to(0.0, 1.0)], "Efficiency of all between motor and slewing axis.", "[Ports001, 6.5.2]";
    I_G: "i_g" "i_(g i)" ONE / ONE [positive], "Turns of the shaft before a gear stage for one of the shaft behind it.", "[Ports001, 6.5.4]";
    ETA_G: "eta_g" "eta_(g i)" ONE / ONE [above_to(0.0, 1.0)], "Efficiency of a gear stage.", "[Ports001, 6.5.4]";
    ETA_R: "eta_r" "eta_r" ONE / ONE [above_to(0.0, 1.0)], "Efficiency of pinion and toothed ring with the bearings of the pinion's shaft.", "[Ports001, 6.5.4]";
    K_LIM: "k_lim" "k_\"lim\"" ONE / ONE [positive, unconfirmed], "Torque at which the coupling slips over the greatest that it transmits at work.", "[Ports001, 6.5.4]";
    R_G: "r_g" "r_g" M / M [positive], "Pitch radius of the toothed ring about the slewing axis.", "[Ports001, 6.5.4]";
    B_Z: "b_z" "b_\"z\"" M / MM [positive], "Width of the teeth.", "input";

    J_E: "J_e" "J_e" KG_M2 / T_M2 [not_negative], "Inertias of all bodies of the upper works about upright axes through their centres of gravity, together.", "[Ports001, 6.5.1]";
    R_W: "r_w" "r_(\"w\" i)" M / M, "Centre of a wind area, in front of the slewing axis; negative behind it.", "[Ports001, 6.5.1]";

    // What slews.
    J_0: "J_0" "J_0" KG_M2 / T_M2, "Inertia of the upper works about the slewing axis.", "[Ports001, 6.5.1]";
    S_R: "S_r" "S_r" M3 / M3, "Sum of the wind areas with their distances in front of the slewing axis.", "derived";

    // About the slewing axis, in a case.
    OMEGA_C: "Omega_c" "Omega_i" RAD_PER_S / RAD_PER_S, "Angular velocity of slewing in a case.", "derived";
    THETA_0: "theta_0" "theta_(0 i)" RAD / DEG, "Outswing of the load as a search has found it.", "derived";
    THETA_Q: "theta_Q" "theta_i" RAD / DEG, "Outswing of the load on its rope while the crane slews steadily.", "equilibrium";
    R_O: "R_o" "R_i" M / M, "Distance of the load that swings out from the slewing axis.", "equilibrium";
    J_QC: "J_Qc" "J_(Q i)" KG_M2 / T_M2, "Inertia of the load about the slewing axis; none where its sway is given.", "[Ports001, 6.5.1]";
    J_C: "J_c" "J_i" KG_M2 / T_M2, "Inertia of all that slews about the slewing axis.", "[Ports001, 6.5.1]";
    M_GZ: "M_gz" "M_(gamma z i)" N_M / KN_M, "Moment of the weights on the slope about the slewing axis; positive counter-clockwise, seen from above.", "[Ports001, 6.5.1]";
    M_WZ: "M_wz" "M_(\"w\" z i)" N_M / KN_M, "Moment of the wind about the slewing axis; positive counter-clockwise, seen from above.", "[Ports001, 6.5.1]";
    M_Z: "M_z" "M_(z i)" N_M / KN_M, "Moment of slope and wind about the slewing axis; positive counter-clockwise, seen from above.", "equilibrium";
    M_AQ: "M_aQ" "M_(alpha i)" N_M / KN_M, "Moment of the swaying load's rope about the slewing axis.", "[Ports001, 6.5.1]";
    M_FS: "M_fs" "M_(\"f\" i)" N_M / KN_M, "Friction moment of the slewing support that the drive overcomes: the greatest of the forms that the scene gives.", "[Ports001, 6.5.1]";
    M_FS0: "M_fs0" "M_(\"f\" 0)" N_M / KN_M, "Friction moment of the slewing support in the load case of heating, which slewing in motion has.", "[Ports001, 6.5.1]";
    M_ST: "M_st" "M_(\"st\" i)" N_M / KN_M, "Moment against steady slewing, that way round in which slope and wind resist.", "[Ports001, 6.5.1]";

    // At a motor's shaft, in a case.
    P_CCW: "P_ccw" "P_(\"l\" i)" W / KW, "Power of a motor while the crane slews counter-clockwise, seen from above.", "[Ports001, 6.5.2]";
    P_CW: "P_cw" "P_(\"r\" i)" W / KW, "Power of a motor while the crane slews clockwise, seen from above.", "[Ports001, 6.5.2]";
    P_LR: "P_lr" "P_(\"lr\" i)" W / KW, "Root mean square of a motor's powers in slewing to either side.", "[Ports001, 6.5.2]";
    M_J: "M_J" "M_(J i)" N_M / KN_M, "Moment at the slewing axis that accelerates all that slews in a start.", "[Ports001, 6.5.1]";
    T_P: "T_p" "T_(\"p\" i)" N_M / N_M, "Greatest torque of a motor on the way of a start.", "[Ports001, 6.5.2]";
    ALPHA_P: "alpha_p" "dot(omega)_(\"p\" i)" RAD_PER_S2 / RAD_PER_S2, "Acceleration of a motor's shaft under this torque.", "derived";
    M_HS: "M_hs" "M_(\"h\" i)" N_M / KN_M, "Moment of slope, wind and sway that the brakes hold.", "[Ports001, 6.5.4]";
    T_HS: "T_hs" "T_(\"h\" i)" N_M / N_M, "Torque that a brake must have to hold that with the safety asked for, the losses helping.", "[Ports001, 6.5.4]";
    U_BS: "u_bs" "u_(\"b\" i)" ONE / ONE, "The same over the torque that it has.", "derived";
    T_W: "T_w" "T_(\"w\" i)" N_M / N_M, "Torque at a motor's shaft against slewing with slope and wind from behind, without inertia; negative where they drive.", "[Ports001, 6.5.4]";
    ALPHA_F: "alpha_f" "dot(omega)_(\"f\" i)" RAD_PER_S2 / RAD_PER_S2, "Deceleration of a motor's shaft with slope and wind from behind, before the brake acts.", "[Ports001, 6.5.4]";
    ALPHA_W: "alpha_w" "dot(omega)_(\"w\" i)" RAD_PER_S2 / RAD_PER_S2, "Deceleration of a motor's shaft with slope and wind from behind, the brake acting.", "[Ports001, 6.5.4]";
    PSI_STOP: "psi_stop" "psi_(s i)" RAD / DEG [infinite("where the brakes do not stop the drive")], "Angle through which the crane slews in the longest stop.", "[Ports001, 6.5.4]";
    T_AG: "T_ag" "T_(\"a\" i)" N_M / N_M, "Torque at a motor's shaft against slewing into slope and wind, without inertia.", "[Ports001, 6.5.4]";
    ALPHA_AG: "alpha_ag" "dot(omega)_(\"a\" i)" RAD_PER_S2 / RAD_PER_S2, "Deceleration of a motor's shaft into slope and wind, the brake acting.", "[Ports001, 6.5.4]";
    T_C: "T_c" "T_(\"c\" i)" N_M / N_M, "Greatest torque that the coupling transmits in start and stop.", "[Ports001, 6.5.4]";
    T_LIM: "T_lim" "T_(\"lim\" i)" N_M / N_M, "Torque at which the coupling must slip, for a case.", "[Ports001, 6.5.4]";
    M_LC: "M_lc" "M_(\"lim\" i)" N_M / KN_M, "Moment at the slewing axis at which all couplings slip together, for a case.", "[Ports001, 6.5.4]";
    F_T: "F_t" "F_(\"t\" i)" N / KN, "Tangential force of a pinion on the toothed ring.", "[Ports001, 6.5.4]";
    SIGMA_FZ: "sigma_Fz" "sigma_(F z i)" PA / MPA, "Bending stress at the root of the teeth.", "[Ports001, 6.5.4]";
    SIGMA_HZ: "sigma_Hz" "sigma_(H z i)" PA / MPA, "Contact pressure of the teeth at the pitch point.", "[Ports001, 6.5.4]";

    // Shafts from a motor to its pinion, in the case of heating.
    SHAFT: "shaft" "i" ONE / ONE, "Number of a shaft: the motor's is 0, the pinion's the last.", "derived";
    N_G0: "n_g0" "n_(g 0)" PER_S / PER_MIN, "Speed of a motor's shaft in the case of heating.", "derived";
    T_G0: "T_g0" "T_(g 0)" N_M / N_M, "Torque of a motor's shaft against steady slewing in the case of heating.", "[Ports001, 6.5.2]";
    P_G0: "P_g0" "P_(g 0)" W / KW, "Power of a motor's shaft against steady slewing in the case of heating.", "[Ports001, 6.5.2]";
    T_GP0: "T_gp0" "T_(\"gp\" 0)" N_M / N_M, "Greatest torque that a motor gives to its gear in a start, of all load cases.", "[Ports001, 6.5.2]";
    U_G: "u_g" "u_(g i)" ONE / ONE, "Turns of a motor for one of the shaft.", "[Ports001, 6.5.4]";
    ETA_U: "eta_u" "eta_(u i)" ONE / ONE, "Efficiency between a motor and the shaft.", "[Ports001, 6.5.4]";
    N_G: "n_g" "n_(g i)" PER_S / PER_MIN, "Speed of the shaft in the case of heating.", "[Ports001, 6.5.4]";
    T_G: "T_g" "T_(g i)" N_M / KN_M, "Torque of the shaft against steady slewing in the case of heating.", "[Ports001, 6.5.4]";
    P_G: "P_g" "P_(g i)" W / KW, "Power of the shaft against steady slewing in the case of heating.", "[Ports001, 6.5.4]";
    T_GP: "T_gp" "T_(\"gp\" i)" N_M / KN_M, "Greatest torque of the shaft in a start, of all load cases.", "[Ports001, 6.5.4]";
    P_HS: "P_hs" "P_\"h\"" W / KW, "Root mean square of a motor's powers to either side, in the case of heating.", "[Ports001, 6.5.2]";
    U_HS: "u_hs" "u_\"h\"" ONE / ONE, "The same over the rated power.", "derived";
    TAU_S: "tau_s" "tau_\"s\"" S / S, "Time for one radian of slewing in the case of heating.", "derived";

    // The whole range.
    M_ST_TOP: "M_st_top" "M_\"st,max\"" N_M / KN_M, "Greatest moment against steady slewing.", "derived";
    P_SL_RMS: "P_sl_rms" "P_\"rms\"" W / KW, "Root mean square of a motor's power over slewing there and back through the working range, in the case of heating.", "[Ports001, 6.5.2]";
    U_SL_RMS: "u_sl_rms" "u_\"rms\"" ONE / ONE, "The same over the rated power.", "derived";
    T_SLIP_MAX: "t_slip_max" "t_(k,max)" S / S [infinite("where the motor cannot start")], "Longest start along the motor's slip curve.", "derived";
    A_SLIP_MAX: "a_slip_max" "a_(k,max)" M_PER_S2 / M_PER_S2, "Greatest mean acceleration of the head in such a start.", "derived";
    T_INV_MAX: "t_inv_max" "t_(u,max)" S / S [infinite("where the motor cannot start")], "Longest start on the inverter.", "derived";
    A_INV_MAX: "a_inv_max" "a_(u,max)" M_PER_S2 / M_PER_S2, "Greatest mean acceleration of the head in such a start.", "derived";
    T_ENG_MAX: "t_eng_max" "t_(e,max)" S / S [infinite("where the motor cannot start")], "Longest start by the clutch and along the engine's torque curve.", "derived";
    A_ENG_MAX: "a_eng_max" "a_(e,max)" M_PER_S2 / M_PER_S2, "Greatest mean acceleration of the head in such a start.", "derived";
    U_BS_MAX: "u_bs_max" "u_\"b,max\"" ONE / ONE, "Greatest torque that a brake must have over the one that it has.", "derived";
    PSI_STOP_MAX: "psi_stop_max" "psi_\"s,max\"" RAD / DEG [infinite("where the brakes do not stop the drive")], "Greatest angle of a stop.", "derived";
    T_LIM_MAX: "T_lim_max" "T_\"lim\"" N_M / N_M, "Torque at which the coupling must slip.", "derived";
    T_GP_MAX: "T_gp_max" "T_\"gp,max\"" N_M / KN_M, "Greatest torque of a shaft of the gear in a start.", "derived";
    F_T_MAX: "F_t_max" "F_\"t,max\"" N / KN, "Greatest tangential force of a pinion.", "derived";
    SIGMA_FZ_MAX: "sigma_Fz_max" "sigma_(F z,max)" PA / MPA, "Greatest bending stress at the root of the teeth.", "derived";
    SIGMA_HZ_MAX: "sigma_Hz_max" "sigma_(H z,max)" PA / MPA, "Greatest contact pressure of the teeth.", "derived";
}

//! Every quantity of what a luffing drive must overcome.
//!
//! The luffing angle is the coordinate of the mechanism: the angle of its boom, or of the rocker where that is driven.

use std::f64::consts::{FRAC_PI_3, FRAC_PI_6};

use crate::kernel::symbol::{Range, symbols};
pub use crate::parts::motor::{
    A_START, A_START_MAX, A_STOP, A_STOP_MAX, J_K, J_M, J_START, K_A, K_B, LAMBDA_M, N_MOT, N_N, N_S, OMEGA_B, P_M,
    P_M_MAX, P_N, PSI_B, T_0, T_B, T_START, T_START_MAX, T_STOP, T_STOP_MAX, TAU_B, U_M, U_M_MAX,
};
pub use crate::parts::starts::{
    A_ENG, A_INV, A_SLIP, I_E, I_S, N_0, S_F, S_K, T_BD, T_E_LEAST, T_E_MAX, T_ENG, T_INV, T_LEAST, T_SLIP, T_U,
};

symbols! {
    // Given: of each case.
    K_Q: "k_Q" "k_(Q i)" ONE / ONE [not_negative], "Part of the scene's load that hangs on the hook in a case.", "input";
    ALPHA_S: "alpha_s" "alpha_(s i)" RAD / DEG [within(Range::new(-FRAC_PI_3, FRAC_PI_3))], "Sway of the load's rope in the boom's plane in a case; where positive the rope pulls the head outward.", "[Ports001, 5.5.3]";
    P_W: "p_w" "p_(w i)" PA / PA, "Wind pressure in a case, besides that of a wind speed; positive from the rear.", "[Ports001, 5.5.4]";
    V_W: "v_w" "v_(w i)" M_PER_S / M_PER_S, "Wind speed in a case; positive from the rear.", "[Ports001, 5.5.4]";
    SIGMA: "sigma" "sigma_i" RAD / DEG [within(Range::new(-FRAC_PI_6, FRAC_PI_6))], "Slope of the ground in a case; positive where the front is lower.", "input";
    V_S: "v_s" "v_(s i)" M_PER_S / MM_PER_S, "Speed of the drive in a case: of its length, lengthening positive, of a sector's teeth, or of a crank's pin counter-clockwise.", "[Ports001, 5.5]";
    A_S: "a_s" "a_(s i)" M_PER_S2 / M_PER_S2, "Acceleration of the drive in a case, as its speed is counted.", "[Ports001, 5.5.5]";
    C_AIR: "c_air" "c_\"air\"" KG_PER_M3 / KG_PER_M3 [not_negative], "Pressure of the wind over the square of its speed.", "input";

    // Given: of each body.
    J_S: "J_s" "J_(s i)" KG_M2 / T_M2 [not_negative], "Inertia of the body about its centre of gravity.", "input";
    A_W: "A_w" "A_(w i)" M2 / M2 [not_negative], "Area of the body that the wind meets.", "[Ports001, 5.5.4]";
    C_W: "c_w" "c_(w i)" ONE / ONE [not_negative], "Drag coefficient of this area.", "input";
    S_W: "s_w" "s_(w i)" M / M, "Centre of this area, from the body's first joint.", "input";
    CHI_W: "chi_w" "chi_(w i)" RAD / DEG, "Centre of this area, counter-clockwise from the body's line.", "input";

    // Given: of each pin.
    MU_P: "mu_p" "mu_(p i)" ONE / ONE [not_negative], "Friction in the pin, or in the guide.", "input";
    R_P: "r_p" "r_(p i)" M / MM [not_negative], "Radius of the pin; none of a guide.", "input";

    // Given: of the motor and its brakes.
    L_M: "l_M" "l_M" M / MM [positive], "Travel of the drive for one turn of the motor: that of a pinion, 2 π r, or a screw's lead, over the ratio of the gear.", "input";
    ETA_M: "eta_M" "eta_M" ONE / ONE [within(Range::new(0.0, 1.0))], "Efficiency of all between motor and drive.", "[Ports001, 5.6]";
    T_B2: "T_b2" "T_(b 2)" N_M / N_M [positive], "Torque of the second brake on the motor's shaft.", "[Ports001, 5.7]";
    TAU_B2: "tau_b2" "tau_(b 2)" S / S [not_negative], "Time after which the second brake acts.", "[Ports001, 5.7]";

    // What the bodies come to at a position.
    DS_S: "ds_s" "s'_d" M / M, "Travel of the drive for one radian of the luffing angle.", "dual numbers";
    DDS_S: "dds_s" "s''_d" M / M, "Change of that for one radian of the luffing angle.", "dual numbers";
    DX_H: "dx_h" "x'_A" M / M, "Forward travel of the head for one radian of the luffing angle.", "dual numbers";
    DY_H: "dy_h" "y'_A" M / M, "Rise of the head for one radian of the luffing angle.", "dual numbers";
    DY_L: "dy_l" "y'_(Q)" M / M, "Rise of the load for one radian of the luffing angle, the hoist's drum at rest.", "dual numbers";
    W_GX: "W_Gx" "W_(G x)" N_M / KN_M, "Weights of all bodies times their forward travel for one radian of the luffing angle.", "virtual work";
    W_GY: "W_Gy" "W_(G y)" N_M / KN_M, "Weights of all bodies times their rise for one radian of the luffing angle.", "virtual work";
    V_CA: "V_cA" "V_(c A)" M3 / M3, "Areas times drag coefficients times the forward travel of their centres for one radian of the luffing angle.", "virtual work";
    J_R: "J_r" "J_r" KG_M2 / T_M2, "Inertia of all bodies, reduced to the luffing angle; the hanging load has none.", "Lagrange";
    DJ_R: "dJ_r" "J'_r" KG_M2 / T_M2, "Change of the reduced inertia for one radian of the luffing angle.", "Lagrange";
    DI_Z: "dI_z" "I'_z" KG_M2 / T_M2, "Change of the inertia of all bodies about the slewing axis for one radian of the luffing angle.", "Lagrange";
    D_P: "D_p" "D_p" KG_M2 / T_M2, "Masses times distance of their centres from the slewing axis times the forward travel of these for one radian of the luffing angle.", "[Ports001, 5.5.6]";
    M_MU: "M_mu" "M_(mu i)" N_M / KN_M, "Friction in all pins for one radian of the luffing angle, whichever way it turns.", "virtual work";

    // In each case.
    P_I: "p_i" "p_i" PA / PA, "Wind pressure in a case; positive from the rear.", "[Ports001, 5.5.4]";
    OMEGA_S: "Omega_s" "Omega_i" RAD_PER_S / RAD_PER_S, "Angular velocity of slewing in a case.", "[Ports001, 5.5.6]";
    OMEGA_R: "omega_r" "omega_(r i)" RAD_PER_S / DEG_PER_S, "Rate of the luffing angle in a case.", "[Ports001, 5.5.5]";
    DOMEGA_R: "domega_r" "dot(omega)_(r i)" RAD_PER_S2 / RAD_PER_S2, "Acceleration of the luffing angle in a case.", "[Ports001, 5.5.5]";
    M_R_OWN: "M_r_own" "M_(r G)" N_M / KN_M, "Moment of the own weights and the counterweight for one radian of the luffing angle; positive raises the boom.", "[Ports001, 5.5.1]";
    M_R_LOAD: "M_r_load" "M_(r Q i)" N_M / KN_M, "Moment of the load for one radian of the luffing angle; positive raises the boom.", "[Ports001, 5.5.2]";
    M_R_SWAY: "M_r_sway" "M_(r alpha i)" N_M / KN_M, "Moment of the swaying rope's pull for one radian of the luffing angle; positive raises the boom.", "[Ports001, 5.5.3]";
    M_R_WIND: "M_r_wind" "M_(r w i)" N_M / KN_M, "Moment of the wind for one radian of the luffing angle; positive raises the boom.", "[Ports001, 5.5.4]";
    M_R_CENTRIFUGAL: "M_r_centrifugal" "M_(r Omega i)" N_M / KN_M, "Moment of the bodies' centrifugal forces for one radian of the luffing angle; positive raises the boom.", "[Ports001, 5.5.6]";
    M_R_POINTS: "M_r_points" "M_(r Omega i,p)" N_M / KN_M, "The same as if each body were in its centre of gravity.", "[Ports001, 5.5.6]";
    M_R_INERTIA: "M_r_inertia" "M_(r J i)" N_M / KN_M, "Moment of the bodies' inertia for one radian of the luffing angle; positive raises the boom.", "[Ports001, 5.5.5]";
    M_R_SLOPE: "M_r_slope" "M_(r sigma i)" N_M / KN_M, "Moment of weights and load by the slope for one radian of the luffing angle; positive raises the boom.", "virtual work";
    M_R_FRICTION: "M_r_friction" "M_(r mu i)" N_M / KN_M, "Moment of the friction in the pins for one radian of the luffing angle, against the motion; positive raises the boom.", "virtual work";
    M_R_SUM: "M_r_sum" "M_(r i)" N_M / KN_M, "Sum of all moments that the drive must overcome; positive raises the boom, and what the drive gives is its opposite.", "[Ports001, 5.5]";
    F_R: "F_r" "F_(r i)" N / KN [infinite("where the drive points at the foot of its bar")], "Force that the drive must give; positive where it presses its ends apart.", "[Ports001, 5.5]";

    // At the motor's shaft in each case.
    T_M: "T_M" "T_(M i)" N_M / N_M [infinite("where the drive points at the foot of its bar")], "Torque at the motor's shaft; positive where the drive presses its ends apart.", "[Ports001, 5.6]";
    P_C: "P_c" "P_(c i)" W / KW, "Root mean square of the powers of the way there and of the way back, on which friction is turned round.", "[Ports001, 5.6]";
    M_R_HELD: "M_r_held" "M_(r h i)" N_M / KN_M, "Sum of all moments but those of friction and inertia, which the brakes must hold; positive raises the boom.", "[Ports001, 5.7]";
    T_H: "T_H" "T_(H i)" N_M / N_M [infinite("where the drive points at the foot of its bar")], "Torque at the motor's shaft that all but friction and inertia asks for, without losses; positive where the drive presses its ends apart.", "[Ports001, 5.7]";
    T_K1: "T_K1" "T_(K i,1)" N_M / N_M [infinite("where the drive points at the foot of its bar")], "Torque that the brakes must have, without losses.", "[Ports001, 5.7]";
    T_K: "T_K" "T_(K i)" N_M / N_M [infinite("where the drive points at the foot of its bar")], "Torque that the brakes must have, the losses helping.", "[Ports001, 5.7]";
    U_B: "u_B" "u_(B i)" ONE / ONE [infinite("where the drive points at the foot of its bar")], "Torque that the brakes must have over the one that they have.", "[Ports001, 5.7]";
    ALPHA_B: "alpha_b" "alpha_(b i)" RAD_PER_S2 / RAD_PER_S2, "Deceleration of the motor's shaft from then on.", "[Ports001, 5.7]";
    S_STOP: "s_stop" "s_(s i)" M / MM [infinite("where the brakes do not stop the drive")], "Travel of the drive in it.", "[Ports001, 5.7]";
    P_H: "P_h" "P_h" W / KW, "Root mean square of both ways' powers in the case of heating.", "[Ports001, 5.6]";
    U_H: "u_h" "u_h" ONE / ONE, "The same over the rated power.", "[Ports001, 5.6]";
    TAU_H: "tau_h" "tau_h" S / S, "Time for one radian of the luffing angle in the case of heating.", "[Ports001, 5.6]";
    V_H_A: "v_h_A" "v_(h A)" M_PER_S / M_PER_S, "Horizontal speed of the head in the case of heating.", "[Ports001, 5.6]";

    // Over the working range and all cases.
    M_R_OWN_MAX: "M_r_own_max" "M_(r G,max)" N_M / KN_M, "Greatest moment of the own weights and the counterweight in the working range, by amount.", "[Ports001, 5.5.1]";
    M_R_LOAD_MAX: "M_r_load_max" "M_(r Q,max)" N_M / KN_M, "Greatest moment of the load in all cases, by amount.", "[Ports001, 5.5.2]";
    M_R_SWAY_MAX: "M_r_sway_max" "M_(r alpha,max)" N_M / KN_M, "Greatest moment of the swaying rope's pull in all cases, by amount.", "[Ports001, 5.5.3]";
    M_R_WIND_MAX: "M_r_wind_max" "M_(r w,max)" N_M / KN_M, "Greatest moment of the wind in all cases, by amount.", "[Ports001, 5.5.4]";
    M_R_CENTRIFUGAL_MAX: "M_r_centrifugal_max" "M_(r Omega,max)" N_M / KN_M, "Greatest moment of the bodies' centrifugal forces in all cases, by amount.", "[Ports001, 5.5.6]";
    M_R_INERTIA_MAX: "M_r_inertia_max" "M_(r J,max)" N_M / KN_M, "Greatest moment of the bodies' inertia in all cases, by amount.", "[Ports001, 5.5.5]";
    M_R_SLOPE_MAX: "M_r_slope_max" "M_(r sigma,max)" N_M / KN_M, "Greatest moment by the slope in all cases, by amount.", "virtual work";
    M_R_FRICTION_MAX: "M_r_friction_max" "M_(r mu,max)" N_M / KN_M, "Greatest moment of the friction in the pins in all cases, by amount.", "virtual work";
    M_R_MAX: "M_r_max" "M_(r,max)" N_M / KN_M, "Greatest sum of all moments that the drive must overcome in all cases, by amount.", "[Ports001, 5.5]";
    F_R_MAX: "F_r_max" "F_(r,max)" N / KN [infinite("where the drive points at the foot of its bar")], "Greatest force that the drive must give in all cases, by amount; positive where it presses its ends apart.", "[Ports001, 5.5]";
    T_M_MAX: "T_M_max" "T_(M,max)" N_M / N_M [infinite("where the drive points at the foot of its bar")], "Greatest torque at the motor's shaft in all cases, by amount.", "[Ports001, 5.6]";
    T_K_MAX: "T_K_max" "T_(K,max)" N_M / N_M [infinite("where the drive points at the foot of its bar")], "Greatest torque that the brakes must have, in all cases.", "[Ports001, 5.7]";
    U_B_MAX: "u_B_max" "u_(B,max)" ONE / ONE [infinite("where the drive points at the foot of its bar")], "Greatest torque that the brakes must have over the one that they have.", "[Ports001, 5.7]";
    S_STOP_MAX: "s_stop_max" "s_(s,max)" M / MM [infinite("where the brakes do not stop the drive")], "Longest travel of the drive in a stop.", "[Ports001, 5.7]";
    P_RMS: "P_rms" "P_\"rms\"" W / KW, "Root mean square in time of the motor's power over luffing in and out in the case of heating.", "[Ports001, 5.6]";
    U_RMS: "u_rms" "u_\"rms\"" ONE / ONE, "The same over the rated power.", "[Ports001, 5.6]";
    T_LUFF: "t_luff" "t_L" S / S, "Time of luffing through the working range in the case of heating.", "[Ports001, 5.6]";
    V_MEAN: "v_mean" "v_\"m\"" M_PER_S / M_PER_MIN, "Mean horizontal speed of the head in that time.", "[Ports001, 5.6]";
    AGREEMENT_R: "agreement_r" "delta" ONE / ONE, "Difference of two independent ways, relative to the largest value.", "derived";

    // Of each body and each pin at a position, in tables.
    MASS_K: "mass_k" "m_k" KG / T, "Mass of a body: weight over g.", "derived";
    X_K: "x_k" "x_k" M / M, "Centre of gravity of a body, forward of the slewing axis.", "derived";
    DX_K: "dx_k" "x'_k" M / M, "Its forward travel for one radian of the luffing angle.", "dual numbers";
    DY_K: "dy_k" "y'_k" M / M, "Its rise for one radian of the luffing angle.", "dual numbers";
    I_K: "i_k" "i_k" ONE / ONE, "Turn of a body for one radian of the luffing angle.", "dual numbers";
    J_RK: "J_rk" "J_(r k)" KG_M2 / T_M2, "Inertia of a body, reduced to the luffing angle.", "Lagrange";
    DJ_RK: "dJ_rk" "J'_(r k)" KG_M2 / T_M2, "Change of that for one radian of the luffing angle.", "Lagrange";
    DI_ZK: "dI_zk" "I'_(z k)" KG_M2 / T_M2, "Change of a body's inertia about the slewing axis for one radian of the luffing angle.", "Lagrange";
    V_CAK: "V_cAk" "V_(c A k)" M3 / M3, "Areas of a body times drag coefficients times the forward travel of their centres for one radian of the luffing angle.", "virtual work";
    F_PK: "F_pk" "F_(p k)" N / KN, "Force in a pin, or of a guide.", "equilibrium";
    L_PK: "l_pk" "l_(p k)" M / MM, "Way of a pin's surface, or along a guide, for one radian of the luffing angle.", "dual numbers";
    M_MUK: "M_muk" "M_(mu k)" N_M / KN_M, "Friction of a pin for one radian of the luffing angle: its coefficient times force times way.", "virtual work";
}

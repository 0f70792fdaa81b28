//! The controller of luffing.

use crate::kernel::keys::keys;
use crate::kernel::schema::Key;
use crate::kernel::symbol::symbols;
use crate::luffing::moving::control::luffing as s;
use crate::luffing::moving::symbols::M_A;
use crate::parts::control::reading::TABLE;
use crate::parts::control::{ContinuousAxis, DriveAxis};

symbols! {
    K_P_A: "K_pA" "K_\"p A\"" N_M_S / KN_M_S [positive], "Proportional gain of the luffing controller: moment over the error of the speed.", "input";
    K_I_A: "K_iA" "K_\"i A\"" N_M / KN_M [positive], "Integral gain of the luffing controller: moment over the integral of that error.", "input";
    T_C_A: "T_cA" "T_\"c A\"" S / MS [from_to(1e-4, 10.0)], "Cycle of the luffing controller: time from one sample to the next.", "input";
    A_A: "a_A" "a_\"A\"" RAD_PER_S2 / RAD_PER_S2 [positive], "Greatest acceleration of the luffing controller's set point.", "input";
    M_MAX_A: "M_maxA" "M_\"max A\"" N_M / KN_M [positive], "Greatest moment of the luffing drive under its controller, by amount.", "input";
    K_THETA_A: "K_thetaA" "K_(theta A)" PER_S / PER_S [positive], "Angular velocity of the driving link asked for over the angle that is left to the commanded one.", "input";
    OMEGA_MAX_A: "omega_maxA" "omega_\"max A\"" RAD_PER_S / DEG_PER_S [positive], "Greatest angular velocity with which the controller luffs to a commanded angle.", "input";
    OMEGA_C_A: "omega_cA" "omega_\"c A\"" RAD_PER_S / DEG_PER_S, "Commanded angular velocity of the driving link.", "input";
    THETA_C_A: "theta_cA" "theta_\"c A\"" RAD / DEG, "Commanded angle of the driving link.", "input";
    OMEGA_S_A: "omega_sA" "omega_\"s A\"" RAD_PER_S / DEG_PER_S, "Set point of the luffing controller since its last sample.", "derived";
    M_I_A: "M_iA" "M_\"i A\"" N_M / KN_M, "Integral part of the moment since the last sample of the luffing controller.", "derived";
    M_H_A: "M_hA" "M_\"h A\"" N_M / KN_M, "Moment that the luffing controller holds since its last sample.", "derived";
    E_THETA_A: "e_thetaA" "e_(theta A)" RAD / DEG, "Angle that is left to the commanded angle of the driving link.", "derived";
    OMEGA_W_A: "omega_wA" "omega_\"w A\"" RAD_PER_S / DEG_PER_S, "Angular velocity at which luffing goes to its commanded angle: from it the set point's acceleration stops it there.", "derived";
    OMEGA_N_A: "omega_nA" "omega_\"n A\"" RAD_PER_S / DEG_PER_S, "Set point of the luffing controller from this sample to the next.", "derived";
    E_N_A: "e_nA" "e_\"n A\"" RAD_PER_S / DEG_PER_S, "Error of the angular velocity of the driving link at a sample.", "derived";
    M_A_A: "M_aA" "M_\"a A\"" N_M / KN_M, "Moment that the luffing controller asks for, before its limit.", "derived";
    M_IN_A: "M_inA" "M_\"i,n A\"" N_M / KN_M, "Integral part of the moment after this sample, unless the limit holds it.", "derived";
    M_N_A: "M_nA" "M_\"n A\"" N_M / KN_M, "Moment of the luffing drive from this sample to the next.", "derived";
    OMEGA_R_A: "omega_rA" "omega_\"r A\"" RAD_PER_S / DEG_PER_S, "Set point of the continuous luffing controller.", "derived";
    EPSILON_A: "epsilon_rA" "epsilon_\"r A\"" RAD / DEG, "Integral of the error of the angular velocity of the driving link, as its continuous controller has it.", "derived";
    E_R_A: "e_rA" "e_\"r A\"" RAD_PER_S / DEG_PER_S, "Error of the angular velocity of the driving link: set point of the continuous controller less speed.", "derived";
    D_OMEGA_R_A: "der(omega_rA)" "dot(omega)_\"r A\"" RAD_PER_S2 / RAD_PER_S2, "Angular acceleration of the continuous luffing controller's set point.", "derived";
    D_EPSILON_A: "der(epsilon_rA)" "dot(epsilon)_\"r A\"" RAD_PER_S / DEG_PER_S, "Rate of the integral of the error of luffing: that error, unless the limit of the moment holds the integral.", "derived";
    OMEGA_T_A: "omega_tA" "omega_\"t A\"" RAD_PER_S / DEG_PER_S, "Commanded angular velocity to which the set point of the continuous luffing controller is going.", "state";
    D_OMEGA_C_A: "der(omega_cA)" "dot(omega)_\"c A\"" RAD_PER_S2 / RAD_PER_S2, "Rate of the commanded angular velocity of luffing, where that goes straight from value to value.", "derived";
    THETA_T_A: "theta_tA" "theta_\"t A\"" RAD / DEG, "Commanded angle to which the continuous luffing controller is going.", "state";
    D_THETA_C_A: "der(theta_cA)" "dot(theta)_\"c A\"" RAD_PER_S / DEG_PER_S, "Rate of the commanded angle of the driving link, where that goes straight from value to value.", "derived";
    WAY_R_A: "way_rA" "w_\"r A\"" ONE / ONE, "Whether the set point of the continuous luffing controller is at its command (0), or which way it goes (1, -1); how it follows the speed that a commanded place asks for: the greatest (0), from which it stops there (2), in proportion to what is left (3).", "state";
    HOLD_A: "hold_A" "l_\"A\"" ONE / ONE, "Whether the moment of the continuous luffing controller is within its limit (0), or at it, with the sign of the moment: the integral waits (1), falls (2), keeps the moment at the limit (3).", "state";
    Z_A_RAMP: "z.luffing_ramp" "z_27" ONE / ONE, "Falls below zero where the set point of the continuous luffing controller reaches its command.", "event";
    Z_A_LIMIT: "z.luffing_limit" "z_28" ONE / ONE, "Falls below zero where the moment that the continuous luffing controller asks for meets its limit or comes back within it.", "event";
    Z_A_WIND: "z.luffing_wind" "z_29" ONE / ONE, "Falls below zero where the integral of the continuous luffing controller begins or ceases to wait at the limit.", "event";
}

pub static AXIS: DriveAxis = DriveAxis {
    settings: [&K_P_A, &K_I_A, &T_C_A, &A_A, &M_MAX_A],
    approach: [&K_THETA_A, &OMEGA_MAX_A],
    commands: [&OMEGA_C_A, &THETA_C_A],
    held: [&OMEGA_S_A, &M_I_A, &M_H_A],
    sample: [&E_THETA_A, &OMEGA_W_A, &OMEGA_N_A, &E_N_A, &M_A_A, &M_IN_A, &M_N_A],
    drive: &M_A,
    reversed: false,
    continuous: [&CONTINUOUS, &TO_PLACE],
};

/// What it is without a cycle.
pub static CONTINUOUS: ContinuousAxis = ContinuousAxis {
    states: [&OMEGA_R_A, &EPSILON_A],
    past: [&OMEGA_T_A, &D_OMEGA_C_A, &WAY_R_A, &HOLD_A],
    law: [&E_R_A, &M_A_A],
};

/// The same where its place is commanded.
pub static TO_PLACE: ContinuousAxis = ContinuousAxis {
    states: [&OMEGA_R_A, &EPSILON_A],
    past: [&THETA_T_A, &D_THETA_C_A, &WAY_R_A, &HOLD_A],
    law: [&E_R_A, &M_A_A],
};

/// The table of a scene whose luffing has a controller.
pub const CONTROL: Key = Key::part(TABLE, KEYS, "Controller of luffing, and its command.");

static KEYS: &[Key] = keys! { s:
    K_P_A > 0, K_I_A > 0, T_C_A > 0 [optional], A_A > 0, M_MAX_A > 0, OMEGA_C_A [over_time, optional], THETA_C_A [over_time, optional],
    K_THETA_A > 0 [optional], OMEGA_MAX_A > 0 [optional]
};

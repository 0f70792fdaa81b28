//! The controller of slewing.

use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, Values};
use crate::kernel::symbol::{Symbol, symbols};
use crate::parts::control::reading::TABLE;
use crate::parts::control::{ContinuousAxis, DriveAxis};
use crate::parts::turntable::M_SL;
use crate::parts::turntable_control as s;

symbols! {
    K_P_SL: "K_psl" "K_\"p sl\"" N_M_S / KN_M_S [positive], "Proportional gain of the slewing controller: moment over the error of the speed.", "input";
    K_I_SL: "K_isl" "K_\"i sl\"" N_M / KN_M [positive], "Integral gain of the slewing controller: moment over the integral of that error.", "input";
    T_C_SL: "T_csl" "T_\"c sl\"" S / MS [from_to(1e-4, 10.0)], "Cycle of the slewing controller: time from one sample to the next.", "input";
    A_SL: "a_sl" "a_\"sl\"" RAD_PER_S2 / RAD_PER_S2 [positive], "Greatest acceleration of the slewing controller's set point.", "input";
    M_MAX_SL: "M_maxsl" "M_\"max sl\"" N_M / KN_M [positive], "Greatest moment of the slewing drive under its controller, by amount.", "input";
    K_PSI_SL: "K_psisl" "K_(psi \"sl\")" PER_S / PER_S [positive], "Speed of slewing asked for over the angle that is left to the commanded one.", "input";
    OMEGA_MAX_SL: "omega_maxsl" "omega_\"max sl\"" RAD_PER_S / DEG_PER_S [positive], "Greatest angular velocity with which the controller slews to a commanded angle.", "input";
    OMEGA_C_SL: "omega_csl" "omega_\"c sl\"" RAD_PER_S / DEG_PER_S, "Commanded angular velocity of slewing.", "input";
    PSI_C_SL: "psi_csl" "psi_\"c sl\"" RAD / DEG, "Commanded slewing angle.", "input";
    OMEGA_S_SL: "omega_ssl" "omega_\"s sl\"" RAD_PER_S / DEG_PER_S, "Set point of the slewing controller since its last sample.", "derived";
    M_I_SL: "M_isl" "M_\"i sl\"" N_M / KN_M, "Integral part of the moment since the last sample of the slewing controller.", "derived";
    M_H_SL: "M_hsl" "M_\"h sl\"" N_M / KN_M, "Moment that the slewing controller holds since its last sample.", "derived";
    E_PSI_SL: "e_psisl" "e_(psi \"sl\")" RAD / DEG, "Angle that is left to the commanded slewing angle.", "derived";
    OMEGA_W_SL: "omega_wsl" "omega_\"w sl\"" RAD_PER_S / DEG_PER_S, "Angular velocity at which slewing goes to its commanded angle: from it the set point's acceleration stops it there.", "derived";
    OMEGA_N_SL: "omega_nsl" "omega_\"n sl\"" RAD_PER_S / DEG_PER_S, "Set point of the slewing controller from this sample to the next.", "derived";
    E_N_SL: "e_nsl" "e_\"n sl\"" RAD_PER_S / DEG_PER_S, "Error of the angular velocity of slewing at a sample.", "derived";
    M_A_SL: "M_asl" "M_\"a sl\"" N_M / KN_M, "Moment that the slewing controller asks for, before its limit.", "derived";
    M_IN_SL: "M_insl" "M_\"i,n sl\"" N_M / KN_M, "Integral part of the moment after this sample, unless the limit holds it.", "derived";
    M_N_SL: "M_nsl" "M_\"n sl\"" N_M / KN_M, "Moment of the slewing drive from this sample to the next.", "derived";
    OMEGA_R_SL: "omega_rsl" "omega_\"r sl\"" RAD_PER_S / DEG_PER_S, "Set point of the continuous slewing controller.", "derived";
    EPSILON_SL: "epsilon_sl" "epsilon_\"sl\"" RAD / DEG, "Integral of the error of the angular velocity of slewing, as its continuous controller has it.", "derived";
    E_R_SL: "e_rsl" "e_\"r sl\"" RAD_PER_S / DEG_PER_S, "Error of the angular velocity of slewing: set point of the continuous controller less speed.", "derived";
    D_OMEGA_R_SL: "der(omega_rsl)" "dot(omega)_\"r sl\"" RAD_PER_S2 / RAD_PER_S2, "Angular acceleration of the continuous slewing controller's set point.", "derived";
    D_EPSILON_SL: "der(epsilon_sl)" "dot(epsilon)_\"sl\"" RAD_PER_S / DEG_PER_S, "Rate of the integral of the error: that error, unless the limit of the moment holds the integral.", "derived";
    OMEGA_T_SL: "omega_tsl" "omega_\"t sl\"" RAD_PER_S / DEG_PER_S, "Commanded angular velocity to which the set point of the continuous slewing controller is going.", "state";
    D_OMEGA_C_SL: "der(omega_csl)" "dot(omega)_\"c sl\"" RAD_PER_S2 / RAD_PER_S2, "Rate of the commanded angular velocity of slewing, where that goes straight from value to value.", "derived";
    PSI_T_SL: "psi_tsl" "psi_\"t sl\"" RAD / DEG, "Commanded angle to which the continuous slewing controller is going.", "state";
    D_PSI_C_SL: "der(psi_csl)" "dot(psi)_\"c sl\"" RAD_PER_S / DEG_PER_S, "Rate of the commanded slewing angle, where that goes straight from value to value.", "derived";
    WAY_R_SL: "way_rsl" "w_\"r sl\"" ONE / ONE, "Whether the set point of the continuous slewing controller is at its command (0), or which way it goes (1, -1); how it follows the speed that a commanded place asks for: the greatest (0), from which it stops there (2), in proportion to what is left (3).", "state";
    HOLD_SL: "hold_sl" "l_\"sl\"" ONE / ONE, "Whether the moment of the continuous slewing controller is within its limit (0), or at it, with the sign of the moment: the integral waits (1), falls (2), keeps the moment at the limit (3).", "state";
    Z_SL_RAMP: "z.sl_ramp" "z_24" ONE / ONE, "Falls below zero where the set point of the continuous slewing controller reaches its command.", "event";
    Z_SL_LIMIT: "z.sl_limit" "z_25" ONE / ONE, "Falls below zero where the moment that the continuous slewing controller asks for meets its limit or comes back within it.", "event";
    Z_SL_WIND: "z.sl_wind" "z_26" ONE / ONE, "Falls below zero where the integral of the continuous slewing controller begins or ceases to wait at the limit.", "event";
    OMEGA_0_SL: "omega_0sl" "omega_\"0 sl\"" RAD_PER_S / RAD_PER_S, "Natural frequency of all that slews under its controller, undamped.", "derived";
    ZETA_SL: "zeta_sl" "zeta_\"sl\"" ONE / ONE, "Damping ratio of all that slews under its controller.", "derived";
}

pub static AXIS: DriveAxis = DriveAxis {
    settings: [&K_P_SL, &K_I_SL, &T_C_SL, &A_SL, &M_MAX_SL],
    approach: [&K_PSI_SL, &OMEGA_MAX_SL],
    commands: [&OMEGA_C_SL, &PSI_C_SL],
    held: [&OMEGA_S_SL, &M_I_SL, &M_H_SL],
    sample: [&E_PSI_SL, &OMEGA_W_SL, &OMEGA_N_SL, &E_N_SL, &M_A_SL, &M_IN_SL, &M_N_SL],
    drive: &M_SL,
    reversed: false,
    continuous: [&CONTINUOUS, &TO_PLACE],
};

/// What it is without a cycle.
pub static CONTINUOUS: ContinuousAxis = ContinuousAxis {
    states: [&OMEGA_R_SL, &EPSILON_SL],
    past: [&OMEGA_T_SL, &D_OMEGA_C_SL, &WAY_R_SL, &HOLD_SL],
    law: [&E_R_SL, &M_A_SL],
};

/// The same where its place is commanded.
pub static TO_PLACE: ContinuousAxis = ContinuousAxis {
    states: [&OMEGA_R_SL, &EPSILON_SL],
    past: [&PSI_T_SL, &D_PSI_C_SL, &WAY_R_SL, &HOLD_SL],
    law: [&E_R_SL, &M_A_SL],
};

/// The table of a scene whose slewing has a controller.
pub const CONTROL: Key = Key::part(TABLE, KEYS, "Controller of slewing, and its command.");

static KEYS: &[Key] = keys! { s:
    K_P_SL > 0, K_I_SL > 0, T_C_SL > 0 [optional], A_SL > 0, M_MAX_SL > 0, OMEGA_C_SL [over_time, optional], PSI_C_SL [over_time, optional],
    K_PSI_SL > 0 [optional], OMEGA_MAX_SL > 0 [optional]
};

/// Greatest angular velocities that a table with a controller asks for, each with table and key, in rad/s.
#[must_use]
pub fn fastest(slewing: &Values) -> Vec<(&Values, &'static str, f64)> {
    let of = |symbol: &'static Symbol| {
        let table = slewing.table(TABLE)?;
        Some((table, symbol.id, table.greatest(symbol.id)?))
    };
    [&OMEGA_C_SL, &OMEGA_MAX_SL].into_iter().filter_map(of).collect()
}

//! The controller of a hoist with a motor.

use crate::kernel::keys::keys;
use crate::kernel::schema::Key;
use crate::kernel::symbol::symbols;
use crate::luffing::moving::control::hoist as s;
use crate::luffing::moving::symbols::M_M_H;
use crate::parts::control::reading::TABLE;
use crate::parts::control::{ContinuousAxis, DriveAxis};

symbols! {
    K_PH: "K_ph" "K_\"p h\"" N_S / KN_S [positive], "Proportional gain of the hoist controller: moment over the error of the speed.", "input";
    K_IH: "K_ih" "K_\"i h\"" N / KN [positive], "Integral gain of the hoist controller: moment over the integral of that error.", "input";
    T_CH: "T_ch" "T_\"c h\"" S / MS [from_to(1e-4, 10.0)], "Cycle of the hoist controller: time from one sample to the next.", "input";
    A_CH: "a_ch" "a_\"c h\"" M_PER_S2 / M_PER_S2 [positive], "Greatest acceleration of the hoist controller's set point.", "input";
    M_MAXH: "M_maxh" "M_\"max h\"" N_M / KN_M [positive], "Greatest moment of the hoist motor under its controller, by amount.", "input";
    K_LH: "K_lh" "K_(l h)" PER_S / PER_S [positive], "Speed of the rope asked for over the length that is left to the commanded one.", "input";
    V_MAXH: "v_maxh" "v_\"max h\"" M_PER_S / M_PER_S [positive], "Greatest speed with which the hoist controller goes to a commanded length of the rope.", "input";
    V_CH: "v_ch" "v_\"c h\"" M_PER_S / M_PER_S, "Commanded speed of the hoist rope at the head; positive lowers the load.", "input";
    L_CH: "l_ch" "l_\"c h\"" M / M, "Commanded length of the rope from head to load.", "input";
    V_SH: "v_sh" "v_\"s h\"" M_PER_S / M_PER_S, "Set point of the hoist controller since its last sample.", "derived";
    M_IH: "M_ih" "M_\"i h\"" N_M / KN_M, "Integral part of the moment since the last sample of the hoist controller.", "derived";
    M_HH: "M_hh" "M_\"h h\"" N_M / KN_M, "Moment that the hoist controller holds since its last sample.", "derived";
    E_LH: "e_lh" "e_(l h)" M / M, "Length that is left to the commanded length of the rope.", "derived";
    V_WH: "v_wh" "v_\"w h\"" M_PER_S / M_PER_S, "Speed at which the hoist goes to its commanded length of rope: from it the set point's acceleration stops it there.", "derived";
    V_NH: "v_nh" "v_\"n h\"" M_PER_S / M_PER_S, "Set point of the hoist controller from this sample to the next.", "derived";
    E_NH: "e_nh" "e_\"n h\"" M_PER_S / M_PER_S, "Error of the rope's speed at a sample; positive where the load is to be lifted faster.", "derived";
    M_AH: "M_ah" "M_\"a h\"" N_M / KN_M, "Moment that the hoist controller asks for, before its limit.", "derived";
    M_INH: "M_inh" "M_\"i,n h\"" N_M / KN_M, "Integral part of the moment after this sample, unless the limit holds it.", "derived";
    M_NH: "M_nh" "M_\"n h\"" N_M / KN_M, "Moment of the hoist motor from this sample to the next.", "derived";
    V_R_H: "v_rh" "v_\"r h\"" M_PER_S / M_PER_S, "Set point of the continuous hoist controller.", "derived";
    EPSILON_H: "epsilon_rh" "epsilon_\"r h\"" M / M, "Integral of the error of the rope's speed, as the continuous hoist controller has it.", "derived";
    E_R_H: "e_rh" "e_\"r h\"" M_PER_S / M_PER_S, "Error of the rope's speed: speed less set point of the continuous controller; positive where the load is to be lifted faster.", "derived";
    D_V_R_H: "der(v_rh)" "dot(v)_\"r h\"" M_PER_S2 / M_PER_S2, "Acceleration of the continuous hoist controller's set point.", "derived";
    D_EPSILON_H: "der(epsilon_rh)" "dot(epsilon)_\"r h\"" M_PER_S / M_PER_S, "Rate of the integral of the error of the hoist: that error, unless the limit of the moment holds the integral.", "derived";
    V_T_H: "v_th" "v_\"t h\"" M_PER_S / M_PER_S, "Commanded speed to which the set point of the continuous hoist controller is going.", "state";
    D_V_CH: "der(v_ch)" "dot(v)_\"c h\"" M_PER_S2 / M_PER_S2, "Rate of the commanded hoisting speed, where that goes straight from value to value.", "derived";
    L_T_H: "l_th" "l_\"t h\"" M / M, "Commanded length of the rope to which the continuous hoist controller is going.", "state";
    D_L_CH: "der(l_ch)" "dot(l)_\"c h\"" M_PER_S / M_PER_S, "Rate of the commanded length of the rope, where that goes straight from value to value.", "derived";
    WAY_R_H: "way_rh" "w_\"r h\"" ONE / ONE, "Whether the set point of the continuous hoist controller is at its command (0), or which way it goes (1, -1); how it follows the speed that a commanded place asks for: the greatest (0), from which it stops there (2), in proportion to what is left (3).", "state";
    HOLD_H: "hold_h" "l_\"h\"" ONE / ONE, "Whether the moment of the continuous hoist controller is within its limit (0), or at it, with the sign of the moment: the integral waits (1), falls (2), keeps the moment at the limit (3).", "state";
    Z_H_RAMP: "z.hoist_ramp" "z_30" ONE / ONE, "Falls below zero where the set point of the continuous hoist controller reaches its command.", "event";
    Z_H_LIMIT: "z.hoist_limit" "z_31" ONE / ONE, "Falls below zero where the moment that the continuous hoist controller asks for meets its limit or comes back within it.", "event";
    Z_H_WIND: "z.hoist_wind" "z_32" ONE / ONE, "Falls below zero where the integral of the continuous hoist controller begins or ceases to wait at the limit.", "event";
}

pub static AXIS: DriveAxis = DriveAxis {
    settings: [&K_PH, &K_IH, &T_CH, &A_CH, &M_MAXH],
    approach: [&K_LH, &V_MAXH],
    commands: [&V_CH, &L_CH],
    held: [&V_SH, &M_IH, &M_HH],
    sample: [&E_LH, &V_WH, &V_NH, &E_NH, &M_AH, &M_INH, &M_NH],
    drive: &M_M_H,
    reversed: true,
    continuous: [&CONTINUOUS, &TO_PLACE],
};

/// What it is without a cycle.
pub static CONTINUOUS: ContinuousAxis = ContinuousAxis {
    states: [&V_R_H, &EPSILON_H],
    past: [&V_T_H, &D_V_CH, &WAY_R_H, &HOLD_H],
    law: [&E_R_H, &M_AH],
};

/// The same where its place is commanded.
pub static TO_PLACE: ContinuousAxis = ContinuousAxis {
    states: [&V_R_H, &EPSILON_H],
    past: [&L_T_H, &D_L_CH, &WAY_R_H, &HOLD_H],
    law: [&E_R_H, &M_AH],
};

/// The table of a scene whose hoist has a controller.
pub const CONTROL: Key = Key::part(TABLE, KEYS, "Controller of the hoist, and its command.");

static KEYS: &[Key] = keys! { s:
    K_PH > 0, K_IH > 0, T_CH > 0 [optional], A_CH > 0, M_MAXH > 0, V_CH [over_time, optional], L_CH [over_time, optional],
    K_LH > 0 [optional], V_MAXH > 0 [optional]
};

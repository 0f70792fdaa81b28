//! Starts of a motor from rest to the speed of a case: along its own curve of torque over slip, or on an inverter.
//!
//! | id | function | source |
//! |---|---|---|
//! | `starts.slip` | [`slip::Slipped::new`] | Kloss, by integration |
//! | `starts.inverter` | [`inverter::Ramped::new`] | equilibrium |

pub mod inverter;
pub mod scene;
pub mod slip;

use crate::kernel::group::quantities;
use crate::kernel::symbol::{Range, symbols};
use crate::parts::starts as s;

symbols! {
    LAMBDA_BD: "lambda_bd" "lambda_k" ONE / ONE [within(Range::new(1.0, 100.0).above())], "Breakdown torque of the motor over its rated torque.", "[Ports001, 5.6]";
    N_0: "n_0" "n_0" PER_S / PER_MIN [positive], "Synchronous speed of the motor.", "[Ports001, 5.6]";
    T_R: "t_r" "t_r" S / S [positive], "Time in which the inverter brings the motor up to its speed.", "[Ports001, 5.6]";
    LAMBDA_INV: "lambda_inv" "lambda_u" ONE / ONE [positive], "Greatest torque that the inverter lets the motor give, over its rated torque.", "[Ports001, 5.6]";
    S_K: "s_k" "s_k" ONE / ONE, "Slip at which the motor gives its breakdown torque; the curve passes the rated point.", "Kloss";
    T_BD: "T_bd" "T_k" N_M / N_M, "Breakdown torque of the motor.", "Kloss";
    S_F: "s_f" "s_(f i)" ONE / ONE, "Slip of the motor at the speed of the case.", "Kloss";
    T_LEAST: "T_least" "T_(s i)" N_M / N_M, "Least torque of the motor on the way from rest to the speed of the case: that at one of its ends.", "Kloss";
    I_S: "I_s" "I_(s i)" ONE / ONE [infinite("where the motor cannot start")], "Integral over the slip, from that of the case to one, of the breakdown torque over what the motor's torque has to spare.", "Kloss";
    T_SLIP: "t_slip" "t_(k i)" S / S [infinite("where the motor cannot start")], "Time of a start from this position along the motor's slip curve.", "[Ports001, 5.6]";
    A_SLIP: "a_slip" "a_(k i)" M_PER_S2 / M_PER_S2, "Mean horizontal acceleration of the head in such a start.", "[Ports001, 5.6]";
    T_U: "T_u" "T_u" N_M / N_M, "Greatest torque that the inverter lets the motor give.", "[Ports001, 5.6]";
    T_RAMP: "T_ramp" "T_(r i)" N_M / N_M, "Torque that the ramp of the inverter asks for from this position.", "[Ports001, 5.6]";
    T_INV: "t_inv" "t_(u i)" S / S [infinite("where the motor cannot start")], "Time of a start from this position on the inverter: that of its ramp, or longer where its limit is reached.", "[Ports001, 5.6]";
    A_INV: "a_inv" "a_(u i)" M_PER_S2 / M_PER_S2, "Mean horizontal acceleration of the head in such a start.", "[Ports001, 5.6]";
}

quantities! {
    /// A motor that starts along its slip curve: its breakdown torque over the rated one, synchronous speed (1/s).
    SlipStart { lambda: LAMBDA_BD, n_0: N_0 }
}

quantities! {
    /// One on an inverter: time of its ramp (s), greatest torque over the rated one.
    InverterStart { time: T_R, lambda: LAMBDA_INV }
}

/// A motor at its rated point: torque (N·m) and speed (1/s).
#[derive(Clone, Copy, Debug)]
pub struct RatedPoint<C> {
    pub torque: C,
    pub n: C,
}

/// What a start leads to, and what it must overcome, at the motor's shaft: speed (1/s, either sign), torque against steady motion
/// (N·m), inertia (kg·m²), and the horizontal speed of the head (m/s, not negative) in the end. Where the case does not `move`
/// there is no start.
#[derive(Clone, Copy, Debug)]
pub struct Starting<C> {
    pub moves: bool,
    pub n: C,
    pub against: C,
    pub inertia: C,
    pub head: C,
}

//! Starts of a motor from rest to the speed of a case: along its own curve of torque over slip, on an inverter, or of an engine
//! by a clutch and along its curve of torque over speed.
//!
//! | id | function | source |
//! |---|---|---|
//! | `starts.slip` | [`slip::Slipped::new`] | Kloss, by integration |
//! | `starts.inverter` | [`inverter::Ramped::new`] | equilibrium |
//! | `starts.engine` | [`engine::Engined::new`] | equilibrium, by integration |

pub mod engine;
pub mod inverter;
pub mod scene;
pub mod slip;
pub mod way;

use std::f64::consts::TAU;

use crate::kernel::calc::Calc;
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
    N_EN: "n_en" "n_(e i)" PER_S / PER_MIN [positive], "Speed at a point of the engine's torque curve.", "[Ports001, 6.5.3]";
    T_EN: "T_en" "T_(e i)" N_M / N_M [positive], "Torque at a point of the engine's torque curve.", "[Ports001, 6.5.3]";
    N_IDLE: "n_idle" "n_\"id\"" PER_S / PER_MIN [positive], "Speed of the engine at idle, at which the clutch slips until it holds.", "[Ports001, 6.5.3]";
    N_GOV: "n_gov" "n_\"gov\"" PER_S / PER_MIN [positive], "Greatest speed to which the governor lets the engine run.", "[Ports001, 6.5.3]";
    T_E_MAX: "T_e_max" "T_\"e,max\"" N_M / N_M, "Greatest torque of the engine between idle and governed speed.", "[Ports001, 6.5.3]";
    K_E: "k_e" "k_\"e\"" ONE / ONE, "Torque reserve of the engine: this torque over the rated one.", "[Ports001, 6.5.3]";
    T_ID: "T_id" "T_\"id\"" N_M / N_M, "Torque of the engine at idle, which the slipping clutch passes on.", "[Ports001, 6.5.3]";
    T_E_LEAST: "T_e_least" "T_(\"e,min\" i)" N_M / N_M, "Least torque of the engine on the way from idle to the speed of the case.", "[Ports001, 6.5.3]";
    T_CL: "t_cl" "t_(c i)" S / S [infinite("where the motor cannot start")], "Time in which the clutch slips in a start from this position.", "equilibrium";
    I_E: "I_e" "I_(e i)" ONE / ONE [infinite("where the motor cannot start")], "Integral over the speed in parts of that at idle, from there to that of the case, of the engine's greatest torque over what its torque has to spare.", "equilibrium";
    T_ENG: "t_eng" "t_(e i)" S / S [infinite("where the motor cannot start")], "Time of a start from this position by the clutch and along the engine's torque curve.", "[Ports001, 6.5.3]";
    N_WAY: "n_way" "n" PER_S / PER_MIN, "Speed on the way of a start: of the motor's shaft, of an engine that behind its clutch.", "derived";
    T_WAY: "T_way" "T" N_M / N_M, "Torque there on the way of a start.", "derived";
    A_ENG: "a_eng" "a_(e i)" M_PER_S2 / M_PER_S2, "Mean horizontal acceleration of the head in such a start.", "[Ports001, 6.5.3]";
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

impl<C: Calc> RatedPoint<C> {
    /// T_N = P_N / (2π n_N), of a power (W) at a speed (1/s).
    pub fn new(power: C, n: C) -> RatedPoint<C> {
        RatedPoint {
            torque: power / (C::constant(TAU) * n),
            n,
        }
    }
}

/// What a start leads to, and what it must overcome, at the motor's shaft: speed (1/s, either sign), torque against steady motion
/// (N·m), inertia (kg·m²), of which the motor's shaft has its own, and the horizontal speed of the head (m/s, not negative) in the end. Where the case does not `move`
/// there is no start.
#[derive(Clone, Copy, Debug)]
pub struct Starting<C> {
    pub moves: bool,
    pub n: C,
    pub against: C,
    pub inertia: C,
    pub own: C,
    pub head: C,
}

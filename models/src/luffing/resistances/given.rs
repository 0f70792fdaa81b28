//! What is given of cases, bodies and pins.

use crate::kernel::group::{group, quantities};
use crate::luffing::resistances::symbols as s;
pub use crate::parts::motor::{CaseBrake, CaseHold};

quantities! {
    /// A case: part of the load, sway (rad), wind (Pa, m/s), slope (rad), slewing (1/s), the drive's speed and acceleration.
    Case { k_q: K_Q, alpha: ALPHA_S, p: P_W, v_w: V_W, sigma: SIGMA, n: N_S, v: V_S, a: A_S }
}

quantities! {
    /// A body: its inertia (kg·m²), and an area (m²) with its drag coefficient and its centre (m, rad).
    CaseBody { j: J_S, area: A_W, drag: C_W, s: S_W, chi: CHI_W }
}

quantities! {
    /// A pin: its friction and its radius (m).
    CasePin { mu: MU_P, r: R_P }
}

quantities! {
    /// A motor: its rated power (W) and speed (1/s), greatest and mean starting torque over the rated one, inertia of its
    /// shaft (kg·m²); travel of the drive for one turn (m), and efficiency of what is between.
    CaseMotor { p_n: P_N, n_n: N_N, lambda: LAMBDA_M, k_a: K_A, j: J_M, l: L_M, eta: ETA_M }
}

quantities! {
    /// Another one, which acts after it.
    SecondBrake { torque: T_B2, delay: TAU_B2 }
}

/// What the scene has chosen.
#[derive(Clone, Debug, Default)]
pub struct CasesChoice {
    /// Of each given body, which of the mechanism's it is: its bars, then the counterweight.
    pub bodies: Vec<usize>,
    /// Of each given pin, which of the mechanism's it is.
    pub pins: Vec<usize>,
    /// Of each pin whose size is given, which of the mechanism's it is.
    pub sizes: Vec<usize>,
    /// The case of the motor's heating, from 0.
    pub heating: Option<usize>,
    /// Acceleration of gravity, in m/s².
    pub gravity: f64,
}
group!(CasesChoice);

//! What is given of a trolley: weights, wheels, rails, and what it is told.

use crate::bridge::symbols as s;
use crate::kernel::group::{group, quantities};

quantities! {
    /// Trolley and spreader: weights (N), resistance of the wheels, wind (Pa, m²), slope (rad), efficiency of the drives,
    /// wheels, distance of the rails (m).
    BridgeTrolley { g_t: G_T, g_s: G_S, mu: MU_T, p_w: P_W, a_w: A_W, gamma: GAMMA_B, eta_d: ETA_D, n_w: N_W, s_b: S_B }
}

quantities! {
    /// What trolley and hoist are told, and what hangs there: acceleration (m/s²), hoisting speed (m/s), weight (N).
    TrolleyCommand { a: A_T, v_h: V_H, q: Q }
}

quantities! {
    /// Efficiency of the sheaves that the hoisting ropes pass.
    PassedSheaves { eta_r: ETA_R }
}

quantities! {
    /// Driven wheels: their number, and their adhesion.
    DrivenWheels { n_dr: N_DR, mu_a: MU_A }
}

/// Sheaves that a hoisting rope passes as the trolley travels.
#[derive(Clone, Copy, Debug)]
pub struct SheaveCount(pub u8);
group!(SheaveCount);

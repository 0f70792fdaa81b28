//! What is given of a slewing drive.

use crate::kernel::group::{group, quantities};
use crate::supports::drive::symbols as s;

quantities! {
    /// Own inertias of what is turned (kg·m²); drives with their motors: number, ratio and efficiency to the slewing axis;
    /// rated power (W) and speed (1/s), greatest power and mean starting torque over the rated ones, inertia of the shaft
    /// (kg·m²).
    TurningDrive { j_e: J_E, z: Z_D, i: I_SL, eta: ETA_SL, p_n: P_N, n_n: N_N, lambda: LAMBDA_M, k_a: K_A, j: J_M }
}

quantities! {
    /// What the drive does in a load case: speed of slewing (1/s), sway of the load (rad).
    TurningCase { n_s: N_S, alpha: ALPHA_Q }
}

quantities! {
    /// How far in front of the slewing axis an area is on which the wind acts, in m.
    TurnedArea { r_w: R_W }
}

quantities! {
    /// Pinion and toothed ring (m), and their teeth: load factor, form factor, width and module (m), pressure angle (rad),
    /// Young's modulus (Pa) and Poisson's ratio.
    RingPinion { r_z: R_Z, r_g: R_G, k: K_F, y: Y_F, b: B_Z, m: M_T, alpha: ALPHA_T, e: E_T, nu: NU_T }
}

/// What the scene has chosen.
#[derive(Clone, Copy, Debug, Default)]
pub struct TurningChoice {
    /// The load case of the motors' heating, from 0.
    pub heating: usize,
    /// Whether the toothed ring has its teeth inside.
    pub inside: bool,
}
group!(TurningChoice);

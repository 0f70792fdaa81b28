//! What is given of the travel of a portal.

use crate::kernel::group::quantities;
use crate::supports::portal::symbols as s;

quantities! {
    /// Wheels and what resists them: diameter, that of their bearings, lever arm of rolling (m), friction of the bearings,
    /// factor of the flanges.
    PortalWheels { d_t: D_T, d_j: D_J, f_r: F_R, mu_j: MU_J, beta_t: BETA_T }
}

quantities! {
    /// Travel: speed (m/s), acceleration (m/s²), slope (rad), adhesion of the wheels, force of the brakes (N), safety with
    /// which the wind is held.
    PortalTravel { v_t: V_T, a_t: A_T, gamma_t: GAMMA_T, mu_a: MU_A, f_br: F_BR, k_w: K_W }
}

quantities! {
    /// Motors: their number, ratio and efficiency to the wheels; of each the rated power (W), the greatest over that, inertia of
    /// the shaft (kg·m²).
    PortalMotors { z_m: Z_M, i_t: I_T, eta_t: ETA_T, p_n: P_N, lambda: LAMBDA_M, j: J_M }
}

quantities! {
    /// Driven wheels of a corner.
    CornerDrive { n_dr: N_DR }
}

quantities! {
    /// Out of service: pressure of the wind (Pa), rail clamps with the force that each holds (N).
    PortalStorm { p_s: P_S, z_c: Z_C, f_c: F_C }
}

//! What is given of a slewing drive.

use crate::kernel::group::{by_map, group, quantities};
use crate::kernel::schema::Values;
use crate::kernel::symbol::Symbol;
use crate::supports::drive::symbols as s;

quantities! {
    /// Own inertias of what is turned (kg·m²), and the number of drives that turn it.
    TurnedByAll { j_e: J_E, z: Z_D }
}

quantities! {
    /// Ratio and efficiency of all between a motor and the slewing axis.
    WholeGear { i: I_SL, eta: ETA_SL }
}

quantities! {
    /// A motor: rated power (W) and speed (1/s), greatest power and mean starting torque over the rated ones, inertia of the
    /// shaft (kg·m²).
    SlewingMotor { p_n: P_N, n_n: N_N, lambda: LAMBDA_M, k_a: K_A, j: J_M }
}

quantities! {
    /// A gear stage: turns of the shaft before it for one of the shaft behind it, and its efficiency.
    GearStage { i: I_G, eta: ETA_G }
}

/// Drives with their motors, and their gear where the scene gives it as a whole.
#[derive(Clone, Copy, Debug)]
pub struct GivenDrive<C> {
    pub turned: TurnedByAll<C>,
    pub whole: Option<WholeGear<C>>,
    pub motor: SlewingMotor<C>,
}
by_map!(GivenDrive: 9);

impl<C: Copy> GivenDrive<C> {
    /// The same over another scalar.
    pub fn map<D>(&self, f: &mut dyn FnMut(&'static Symbol, C) -> D) -> GivenDrive<D> {
        GivenDrive {
            turned: self.turned.map(f),
            whole: self.whole.map(|whole| whole.map(f)),
            motor: self.motor.map(f),
        }
    }
}

impl GivenDrive<f64> {
    /// That of a scene; `None` where something is not given.
    pub fn read(v: &Values) -> Option<GivenDrive<f64>> {
        Some(GivenDrive {
            turned: TurnedByAll::read(v)?,
            whole: WholeGear::read(v),
            motor: SlewingMotor::read(v)?,
        })
    }
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

/// That the scene moves what slews.
#[derive(Clone, Copy, Debug)]
pub struct Moves;
group!(Moves);

/// What the scene has chosen.
#[derive(Clone, Copy, Debug, Default)]
pub struct TurningChoice {
    /// The load case of the motors' heating, from 0.
    pub heating: usize,
    /// Whether the toothed ring has its teeth inside.
    pub inside: bool,
}
group!(TurningChoice);

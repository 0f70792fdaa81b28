//! What resists the trolley, and the auxiliary trolley that keeps the length of the ropes.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::{One, quantities};
use crate::parts::travel::{along, passed, sense};
use crate::unloader::reeving::Reeving;
use crate::unloader::symbols as s;

quantities! {
    /// Grab and trolley: weights (N), resistance of the wheels, wind (Pa, m²), efficiencies of a sheave and of the drives.
    GrabTrolley { g_g: G_G, q_n: Q_N, g_t: G_T, mu: MU_T, p_w: P_W, a_w: A_W, eta_r: ETA_R, eta_d: ETA_D }
}

quantities! {
    /// What grab and ropes are told: hoisting and closing (m/s), contents, part of the closing ropes.
    GrabCommand { v_h: V_H, v_c: V_C, k_q: K_Q, lambda: LAMBDA_C }
}

quantities! {
    /// The auxiliary trolley.
    AuxiliaryTrolley { g_a: G_A }
}

quantities! {
    /// Its own rope: least breaking force (N), and how many they are.
    AuxiliaryRope { f_b: F_BA, z: Z_A }
}

/// W = G_g + k_Q Q_n, in N.
pub fn hanging<C: Calc>(unit: &GrabTrolley<C>, command: &GrabCommand<C>) -> C {
    (unit.g_g + command.k_q * unit.q_n).def(&s::W)
}

/// Wheels, wind, sheaves and inertia, in N: μ(G_t + W), p_w A_w, W(1 − η^n), (G_t + W) a/g. [Ports001, 7.5]
pub fn parts<C: Calc>(unit: &GrabTrolley<C>, sheaves: u8, gravity: C, weight: C, rate: C) -> [C; 4] {
    let borne = unit.g_t + weight;
    [
        unit.mu * borne,
        unit.p_w * unit.a_w,
        passed(weight, unit.eta_r, sheaves),
        borne / gravity * rate,
    ]
}

/// Forces against the trolley, in N, and their sum.
#[derive(Clone, Copy, Debug)]
pub struct TrolleyForces<C> {
    parts: [C; 4],
    pub total: C,
}
results! { TrolleyForces as f => {
    F_MU: f.parts[0];
    F_W: f.parts[1];
    F_S: f.parts[2];
    F_A: f.parts[3];
    F_R: f.total;
} }

impl<C: Calc> TrolleyForces<C> {
    /// F_r = ±(F_μ + F_w + F_s) + F_a. [Ports001, 7.5]
    pub fn new(
        reeving: &Reeving,
        unit: &GrabTrolley<C>,
        gravity: &One<C>,
        speed: &One<C>,
        rate: &One<C>,
        weight: &C,
    ) -> TrolleyForces<C> {
        let found = parts(unit, reeving.sheaves, **gravity, *weight, **rate);
        let names = [&s::F_MU, &s::F_W, &s::F_S, &s::F_A];
        let parts = std::array::from_fn(|i| found[i].def(names[i]));
        let sense = sense(speed.value(), rate.value());
        TrolleyForces {
            parts,
            total: along(parts, sense).over(**speed).def(&s::F_R),
        }
    }
}

/// What the auxiliary trolley asks for at half the acceleration (m/s²), in N; positive to the sea side.
pub fn auxiliary<C: Calc>(aux: &AuxiliaryTrolley<C>, mu: C, gravity: C, rate: C, sense: f64) -> C {
    let (wheels, inertia) = (mu * aux.g_a, aux.g_a / gravity * (rate / C::constant(2.0)));
    match sense {
        s if s > 0.0 => wheels + inertia,
        s if s < 0.0 => inertia - wheels,
        _ => inertia.over(wheels),
    }
}

/// The auxiliary trolley: its speed (m/s), how fast the ropes get longer (m/s), what it asks for and its rope's pull (N).
#[derive(Clone, Copy, Debug)]
pub struct AuxiliaryRun<C> {
    speed: C,
    longer: C,
    pub force: C,
    pull: C,
}
results! { AuxiliaryRun as a => { V_AUX: a.speed; D_L: a.longer; F_RA: a.force; T_AUX: a.pull; } }

impl<C: Calc> AuxiliaryRun<C> {
    /// v_aux = v_t/2, dl/dt = v_t − 2 v_aux, T_aux = 2 W − F_ra. [Ports001, 5.8.3]
    pub fn new(
        aux: &AuxiliaryTrolley<C>,
        unit: &GrabTrolley<C>,
        gravity: &One<C>,
        speed: &One<C>,
        rate: &One<C>,
        weight: &C,
    ) -> AuxiliaryRun<C> {
        let half = (**speed / C::constant(2.0)).def(&s::V_AUX);
        let way = sense(speed.value(), rate.value());
        let force = auxiliary(aux, unit.mu, **gravity, **rate, way);
        let force = force.over(**speed).def(&s::F_RA);
        AuxiliaryRun {
            speed: half,
            longer: (**speed - half.scaled(2.0)).def(&s::D_L),
            force,
            pull: (weight.scaled(2.0) - force).def(&s::T_AUX),
        }
    }
}

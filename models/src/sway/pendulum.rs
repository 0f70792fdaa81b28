//! A load that sways under a trolley on a straight beam, as a simple pendulum whose rope is reeled, and a trolley that answers to it.

use std::f64::consts::TAU;

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::{One, quantities};
use crate::kernel::symbol::{Range, symbols};

symbols! {
    X_T: "x_t" "x_\"t\"" M / M, "Place of the trolley on the beam, from the rail of the sea side; positive to the sea side.", "input";
    ZETA_F: "zeta_f" "zeta_\"f\"" ONE / ONE [within(Range::new(0.0, 0.95))], "Feedback of the sway: damping of small sway over the critical one, where the trolley goes faster in proportion to the sway.", "input";
    OMEGA_R: "omega_R" "omega_R" RAD_PER_S / DEG_PER_S, "Angular velocity of the sway.", "equations of motion";
    A_L: "a_l" "a_\"l\"" M_PER_S2 / M_PER_S2, "Acceleration of a trolley whose load sways: what it is told, and what the feedback adds; positive to the sea side.", "equations of motion";
    T_F: "T_f" "T_\"f\"" S / S [positive], "Period of small sway under feedback.", "equations of motion";
    DELTA_F: "delta_f" "delta_\"f\"" PER_S / PER_S [not_negative], "Rate at which feedback damps small sway: in the inverse of it, to 37 %.", "equations of motion";
    D_L_E: "d_l_e" "dot(l)_\"e\"" M_PER_S / M_PER_S, "Rate of the length of the simple pendulum.", "derived";
    X_L: "x_L" "x_L" M / M, "Place of the load along the beam, from the rail of the sea side.", "derived";
    F_PHI: "F_phi" "F_phi" N / KN, "Pull of the load on the trolley along the beam; positive to the sea side.", "equilibrium";
    D_X_T: "der(x_t)" "dot(x)_\"t\"" M_PER_S / M_PER_S, "Rate of the trolley's place.", "state";
    D_V_T: "der(v_t)" "dot(v)_\"t\"" M_PER_S2 / M_PER_S2, "Rate of the trolley's speed.", "state";
    D_PHI_R: "der(phi_R)" "dot(phi)_R" RAD_PER_S / DEG_PER_S, "Rate of the sway.", "state";
    D_OMEGA_R: "der(omega_R)" "dot(omega)_R" RAD_PER_S2 / RAD_PER_S2, "Angular acceleration of the sway.", "Lagrange";
    D_L_R: "der(l_R)" "dot(l)_R" M_PER_S / M_PER_S, "Rate of the ropes' length.", "state";
}

/// Of the load on its rope, and of its sway.
mod s {
    pub use super::*;
    pub use crate::parts::hanging::{L_R, PHI_R, S_R, X_Q, Y_Q};
}

quantities! {
    /// The load: its sway (rad) with the rate of that (rad/s), and the length of its ropes (m).
    SwayingLoad { phi: PHI_R, omega: OMEGA_R, l: L_R }
}

quantities! {
    /// Feedback of the sway.
    Feedback { zeta: ZETA_F }
}

/// The simple pendulum that sways as the load does: length (m) with its change over that of the ropes, part of the trolley's
/// acceleration that it feels, depth of its load at rest (m).
#[derive(Clone, Copy, Debug)]
pub struct HungLoad<C> {
    pub length: C,
    pub slope: C,
    pub felt: C,
    pub deep: C,
}

impl<C: Calc> Feedback<C> {
    /// a = a_t + 2 ζ √(g l) φ̇ + ζ √(g/l) l̇ φ, in m/s²: the trolley goes faster by 2 ζ √(g l) φ than it is told, whatever is hoisted,
    /// and as told when the load hangs at rest. [state feedback]
    pub fn answer(&self, told: C, load: &SwayingLoad<C>, gravity: C, [length, reeling]: [C; 2]) -> C {
        let gain = (self.zeta * (gravity * length).sqrt()).scaled(2.0);
        let grows = self.zeta * (gravity / length).sqrt() * reeling;
        (told + gain * load.omega + grows * load.phi).def(&A_L)
    }
}

/// Small sway under feedback: its period (s) and the rate at which it falls (1/s).
#[derive(Clone, Copy, Debug)]
pub struct Damped<C>([C; 2]);
results! { Damped as d => { T_F: d.0[0]; DELTA_F: d.0[1]; } }

impl<C: Calc> Damped<C> {
    /// T_f = 2π/(ω √(1 − (ν_x ζ)²)), δ_f = ν_x ζ ω, of a load that feels a part ν_x of the trolley's acceleration. [linear oscillator]
    pub fn new(feedback: &Feedback<C>, frequency: C, felt: Option<C>) -> Damped<C> {
        let zeta = felt.map_or(feedback.zeta, |felt| felt * feedback.zeta);
        let slower = (C::constant(1.0) - zeta.square()).sqrt();
        Damped([
            (C::constant(TAU) / (frequency * slower)).def(&T_F),
            (zeta * frequency).def(&DELTA_F),
        ])
    }
}

/// Rates of the sway, place of the load (m), force of the ropes and its part along the beam (N).
#[derive(Clone, Copy, Debug)]
pub struct Swung<C> {
    reeling: C,
    rates: [C; 3],
    place: [C; 3],
    force: C,
    pub pull_along: C,
}
results! { Swung as w => {
    D_L_E: w.reeling;
    D_PHI_R: w.rates[0];
    D_OMEGA_R: w.rates[1];
    D_L_R: w.rates[2];
    X_Q: w.place[0];
    Y_Q: w.place[1];
    X_L: w.place[2];
    S_R: w.force;
    F_PHI: w.pull_along;
} }

impl<C: Calc> Swung<C> {
    /// l φ̈ + 2 l̇ φ̇ + g sin φ = −ν_x a cos φ with the simple pendulum's length; S = W(g cos φ + l φ̇² − a sin φ)/g, under an
    /// acceleration of the trolley (m/s²) and a hoisting speed (m/s). (Lagrange)
    pub fn new(
        load: &SwayingLoad<C>,
        [rate, hoist]: [C; 2],
        gravity: &One<C>,
        place: C,
        weight: C,
        hanging: &HungLoad<C>,
    ) -> Swung<C> {
        let (sin, cos) = load.phi.sin_cos();
        let length = hanging.length;
        let reeling = (-hanging.slope * hoist).def(&D_L_E);
        let coriolis = (reeling * load.omega).scaled(2.0);
        let asked = coriolis + **gravity * sin + hanging.felt * rate * cos;
        let force = weight * (**gravity * cos + length * load.omega.square() - rate * sin) / **gravity;
        let force = force.def(&s::S_R);
        let forward = (length * sin).def(&s::X_Q);
        Swung {
            reeling,
            rates: [load.omega, (-asked / length).def(&D_OMEGA_R), -hoist],
            place: [
                forward,
                (length * (C::constant(1.0) - cos) - hanging.deep).def(&s::Y_Q),
                (place + forward).def(&X_L),
            ],
            force,
            pull_along: (force * sin).def(&F_PHI),
        }
    }
}

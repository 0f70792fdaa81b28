//! What the trolley weighs, what its travel asks for, what its wheels and the bridge's rails bear.

use crate::bridge::given::{BridgeTrolley, DrivenWheels, PassedSheaves, SheaveCount, TrolleyCommand};
use crate::bridge::symbols as s;
use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::parts::safety::safety;
use crate::parts::travel::{along, at_motor, passed, sense};

/// W = G_s + Q, in N.
pub fn carried<C: Calc>(unit: &BridgeTrolley<C>, command: &TrolleyCommand<C>) -> C {
    (unit.g_s + command.q).def(&s::W)
}

/// F_s = W(1 − η^n), in N. [Ports001, 7.4]
pub fn sheaves<C: Calc>(over: &PassedSheaves<C>, count: &SheaveCount, weight: &C) -> C {
    passed(*weight, over.eta_r, count.0).def(&s::F_S)
}

/// Forces against the trolley, in N, and their sum.
#[derive(Clone, Copy, Debug)]
pub struct TravelForces<C> {
    parts: [C; 4],
    passed: C,
    against: C,
    pub total: C,
}
results! { TravelForces as f => {
    F_MU: f.parts[0];
    F_W: f.parts[1];
    F_GAMMA: f.parts[2];
    F_A: f.parts[3];
    F_R: f.total;
} }

impl<C: Calc> TravelForces<C> {
    /// F_r = ±(F_μ + F_w + F_s) + F_γ + F_a, with F_a = (G_t + W) a/g: the load hangs back steadily. [Ports001, 7.4]
    pub fn new(
        unit: &BridgeTrolley<C>,
        gravity: &One<C>,
        command: &TrolleyCommand<C>,
        speed: &One<C>,
        weight: &C,
        sheaves: Option<&C>,
    ) -> TravelForces<C> {
        let borne = unit.g_t + *weight;
        let (sin, cos) = unit.gamma.sin_cos();
        let wheels = (unit.mu * borne * cos).def(&s::F_MU);
        let wind = (unit.p_w * unit.a_w).def(&s::F_W);
        let slope = (borne * sin).def(&s::F_GAMMA);
        let inertia = (borne / **gravity * command.a).def(&s::F_A);
        let none = C::constant(0.0);
        let passed = sheaves.copied().unwrap_or(none);
        let sense = sense(speed.value(), command.a.value());
        let total = along([wheels, wind, passed, slope + inertia], sense).over(**speed);
        TravelForces {
            parts: [wheels, wind, slope, inertia],
            passed,
            against: wheels + wind + passed,
            total: total.def(&s::F_R),
        }
    }

    /// What drives a trolley on that is to stop, in N: wind from behind and the slope, less wheels and sheaves.
    pub fn drives_on(&self) -> C {
        let [wheels, wind, slope, _] = self.parts;
        wind + slope.abs() - wheels - self.passed
    }

    /// The same with another force that accelerates, in N.
    pub fn with(&self, inertia: C, sense: f64) -> C {
        let [wheels, wind, slope, _] = self.parts;
        along([wheels, wind, self.passed, slope + inertia], sense)
    }
}

/// Powers of the motors, in W.
#[derive(Clone, Copy, Debug)]
pub struct BridgePowers<C>([C; 2]);
results! { BridgePowers as p => { P_T: p.0[0]; P_H: p.0[1]; } }

impl<C: Calc> BridgePowers<C> {
    /// P = F v/η where it drives, F v η where it brakes. [Ports001, 7.4]
    pub fn new(
        unit: &BridgeTrolley<C>,
        command: &TrolleyCommand<C>,
        speed: &One<C>,
        weight: &C,
        forces: &TravelForces<C>,
    ) -> BridgePowers<C> {
        BridgePowers([
            at_motor(forces.total * **speed, unit.eta_d).def(&s::P_T),
            at_motor(*weight * command.v_h, unit.eta_d).def(&s::P_H),
        ])
    }
}

/// Loads of a wheel and of the rails of sea and land side, in N.
#[derive(Clone, Copy, Debug)]
pub struct RailLoads<C> {
    wheel: C,
    sides: [C; 2],
}
results! { RailLoads as r => { N_R: r.wheel; R_1: r.sides[0]; R_2: r.sides[1]; } }

impl<C: Calc> RailLoads<C> {
    /// N = (G_t + W)/n, R_1 = (G_t + W)(1 + x/s), R_2 = −(G_t + W) x/s. (equilibrium)
    pub fn new(unit: &BridgeTrolley<C>, place: &One<C>, weight: &C) -> RailLoads<C> {
        let borne = unit.g_t + *weight;
        let part = **place / unit.s_b;
        RailLoads {
            wheel: (borne / unit.n_w).def(&s::N_R),
            sides: [
                (borne * (C::constant(1.0) + part)).def(&s::R_1),
                (-borne * part).def(&s::R_2),
            ],
        }
    }
}

/// Driven wheels: the force that they can give (N), their safety, the greatest acceleration of a start (m/s²).
#[derive(Clone, Copy, Debug)]
pub struct Grip<C> {
    pub force: C,
    safety: C,
    most: C,
}
results! { Grip as g => { F_AD: g.force; K_AD: g.safety; A_AD: g.most; } }

impl<C: Calc> Grip<C> {
    /// F_ad = μ_a n_dr/n (G_t + W) cos γ, k_ad = F_ad/|F_r|, a_ad = g (F_ad − F_μ − F_w − F_s)/(G_t + W) on a level beam. (Coulomb)
    pub fn new(
        driven: &DrivenWheels<C>,
        unit: &BridgeTrolley<C>,
        gravity: &One<C>,
        weight: &C,
        forces: &TravelForces<C>,
    ) -> Grip<C> {
        let borne = unit.g_t + *weight;
        let (_, cos) = unit.gamma.sin_cos();
        let force = (driven.mu_a * driven.n_dr / unit.n_w * borne * cos).def(&s::F_AD);
        Grip {
            force,
            safety: safety(force, forces.total.abs(), &s::K_AD),
            most: (**gravity * (force - forces.against) / borne).def(&s::A_AD),
        }
    }
}

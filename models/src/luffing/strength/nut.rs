//! Screw and nut.

use std::f64::consts::PI;

use crate::component::stages::{Found, absent, results};
use crate::drive::gear::Gear;
use crate::drive::shaft::Gearing;
use crate::kernel::calc::Calc;
use crate::luffing::strength::given::{Nut, under};
use crate::luffing::strength::symbols as s;

/// What carries, whatever the force.
#[derive(Clone, Copy, Debug)]
pub struct Core<C> {
    /// In m².
    area: C,
    flanks: C,
    /// Torque, in N·m, for one newton that the motion works against.
    arm: C,
}
results! { Core as c => { A_3: c.area; A_N: c.flanks; } }

impl<C: Calc> Core<C> {
    /// A_n = π d_2 H_1 l_n / P_1: as many turns carry as the nut has. [Ports001, 5.8]
    ///
    /// # Errors
    /// A drive without a screw.
    pub fn new(nut: &Nut<C>, gear: &Gear<C>, gearing: &Gearing<C>) -> Found<Core<C>> {
        let Gear::Screw(screw) = gear else { return Err(absent()) };
        let pi = C::constant(PI);
        Ok(Core {
            area: (pi * nut.d_3.square() / C::constant(4.0)).def(&s::A_3),
            flanks: (pi * screw.d_2 * nut.h_1 * nut.l_n / nut.p_1).def(&s::A_N),
            arm: gearing.against(),
        })
    }
}

/// Screw and nut under the force of a case: torque in N·m, stresses in Pa.
#[derive(Clone, Copy, Debug)]
pub struct Threaded<C> {
    pressure: C,
    torque: C,
    along: C,
    torsion: C,
    equivalent: C,
}
results! { each Threaded as t => {
    P_N: t.pressure;
    T_N: t.torque;
    SIGMA_D: t.along;
    TAU_D: t.torsion;
    SIGMA_V: t.equivalent;
} }

impl<C: Calc> Threaded<C> {
    /// p = F / A_n, σ = F / A_3, τ = 16 T / (π d_3³), σ_v = √(σ² + 3 τ²) (von Mises). [Ports001, 5.8]
    pub fn new(nut: &Nut<C>, core: &Core<C>, force: &C) -> Threaded<C> {
        let pressure = under(*force, |force| (force / core.flanks).def(&s::P_N));
        let torque = under(*force, |force| (force * core.arm).def(&s::T_N));
        let along = under(*force, |force| (force / core.area).def(&s::SIGMA_D));
        let torsion = under(torque, |torque| {
            let cubed = nut.d_3.square() * nut.d_3;
            (C::constant(16.0) * torque / (C::constant(PI) * cubed)).def(&s::TAU_D)
        });
        let equivalent = under(along, |along| {
            let both = along.square() + C::constant(3.0) * torsion.square();
            both.sqrt().def(&s::SIGMA_V)
        });
        Threaded {
            pressure,
            torque,
            along,
            torsion,
            equivalent,
        }
    }
}

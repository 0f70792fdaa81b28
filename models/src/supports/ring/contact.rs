//! Contact stress of the rolling elements by Hertz, against what the hardness of the raceway allows. [Ports001, 6.3.1.2]

use std::f64::consts::PI;

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::{One, quantities};
use crate::supports::ring::elements::RollingForces;
use crate::supports::ring::symbols as s;

quantities! {
    /// Rolling element and raceway, of the same steel, and the hardness.
    RollingContact { e: E, nu: NU, rho: RHO, k_hb: K_HB, hb: HB }
}

/// Modulus of the contact, and the stress that the hardness allows, in Pa.
#[derive(Clone, Copy, Debug)]
pub struct Hardness<C> {
    modulus: C,
    allowed: C,
}
results! { Hardness as h => { E_STAR: h.modulus; SIGMA_ALL: h.allowed; } }

impl<C: Calc> Hardness<C> {
    /// E* = E / (2 (1 − ν²)) of two bodies alike, σ_all = k_HB HB.
    pub fn new(contact: &RollingContact<C>) -> Hardness<C> {
        let (one, two) = (C::constant(1.0), C::constant(2.0));
        Hardness {
            modulus: (contact.e / (two * (one - contact.nu.square()))).def(&s::E_STAR),
            allowed: (contact.k_hb * contact.hb).def(&s::SIGMA_ALL),
        }
    }
}

/// Greatest contact stress of a case (Pa), and its part of what is allowed.
#[derive(Clone, Copy, Debug)]
pub struct ContactStress<C> {
    stress: C,
    used: C,
}
results! { each ContactStress as c => { SIGMA_H: c.stress; U_H: c.used; } }

impl<C: Calc> ContactStress<C> {
    /// On a line √(N E* / (π b ρ)), at a point (1/π) ∛(6 N E*² / ρ²). [Ports001, 6.3.1.2]
    pub fn new(
        contact: &RollingContact<C>,
        length: &Option<One<C>>,
        hardness: &Hardness<C>,
        spread: &RollingForces<C>,
    ) -> ContactStress<C> {
        let pi = C::constant(PI);
        let stress = match length {
            Some(length) => (spread.normal * hardness.modulus / (pi * **length * contact.rho)).sqrt(),
            None => (C::constant(6.0) * spread.normal * (hardness.modulus / contact.rho).square()).power([1, 3]) / pi,
        };
        let stress = stress.def(&s::SIGMA_H);
        ContactStress {
            stress,
            used: (stress / hardness.allowed).def(&s::U_H),
        }
    }
}

//! The drive's bar against buckling: a rack, a screw, a cylinder with its rod, the rod of a crank.

use std::f64::consts::PI;

use crate::component::stages::{Found, absent, results};
use crate::drive::line::Drive;
use crate::drive::mount::Bore;
use crate::kernel::calc::Calc;
use crate::luffing::strength::given::{Nut, Profile, Strut};
use crate::luffing::strength::symbols as s;
use crate::parts::buckling;

/// The bar at one position.
#[derive(Clone, Copy, Debug)]
pub struct Slender<C> {
    /// In m.
    length: C,
    lambda: C,
    meets: C,
    /// In Pa, and in N.
    stress: C,
    pub bears: C,
}
results! { Slender as k => {
    L_K: k.length;
    LAMBDA_K: k.lambda;
    LAMBDA_G: k.meets;
    SIGMA_CR: k.stress;
    N_CR: k.bears;
} }

impl<C: Calc> Slender<C> {
    /// l_k = μ_k (L_d − l_0): the drive's length changes with its position. A screw has the cross-section of its core, a
    /// cylinder that of its rod over the whole length, which is on the safe side. [Ports001, 5.8; Euler, Johnson]
    ///
    /// # Errors
    /// A drive that has no cross-section.
    pub fn new(
        strut: &Strut<C>,
        profile: &Option<Profile<C>>,
        nut: &Option<Nut<C>>,
        cylinder: &Option<Bore<C>>,
        drive: &Drive<C>,
    ) -> Found<Slender<C>> {
        let four = C::constant(4.0);
        let round = nut.map(|nut| nut.d_3).or(cylinder.map(|bore| bore.d_r));
        let length = (strut.mu * (drive.l_d - strut.l_0)).def(&s::L_K);
        let (area, lambda) = match (profile, round) {
            (Some(profile), _) => (profile.area, length / profile.radius),
            // The radius of gyration of a circle is a fourth of its diameter.
            (None, Some(d)) => (C::constant(PI) * d.square() / four, four * length / d),
            (None, None) => return Err(absent()),
        };
        let (steel, lambda) = ([strut.e, strut.sigma_y], lambda.def(&s::LAMBDA_K));
        let meets = buckling::meeting(steel).def(&s::LAMBDA_G);
        let stress = buckling::critical(lambda, meets, steel).def(&s::SIGMA_CR);
        Ok(Slender {
            length,
            lambda,
            meets,
            stress,
            bears: (stress * area).def(&s::N_CR),
        })
    }
}

/// u_k = S_k F / N_cr for a push (N) of the drive; nothing for a pull. [Ports001, 5.8]
pub fn buckled<C: Calc>(strut: &Strut<C>, slender: &Slender<C>, force: &C) -> C {
    if force.value() <= 0.0 {
        return C::constant(0.0).over(*force).over(strut.s).over(slender.bears);
    }
    if force.value().is_infinite() {
        return *force;
    }
    (strut.s * *force / slender.bears).def(&s::U_K)
}

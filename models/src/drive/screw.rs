//! Screw and nut.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::drive::symbols as s;
use crate::kernel::calc::Calc;
use crate::kernel::group::quantities;
use crate::kernel::number::short;

quantities! {
    /// Pitch diameter (m), lead (m), friction and flank angle (rad) of a screw.
    Screw { d_2: D_2, p_h: P_H, mu_d: MU_D, beta_d: BETA_D }
}

/// Angles of the thread, in rad.
#[derive(Clone, Copy, Debug)]
pub struct Thread<C> {
    pub lambda: C,
    pub rho: C,
    /// Angle of friction less lead angle: positive where the screw locks itself.
    pub lock: C,
}

impl<C: Calc> Thread<C> {
    /// tan λ = p_h / (π d_2), tan ρ′ = μ / cos β [Ports001, 5.3]
    pub fn new(screw: &Screw<C>) -> Thread<C> {
        let lambda = C::direction(C::constant(PI) * screw.d_2, screw.p_h).def(&s::LAMBDA_D);
        let rho = C::direction(screw.beta_d.sin_cos().1, screw.mu_d).def(&s::RHO_D);
        let lock = (rho - lambda).def(&s::LOCK_D);
        Thread { lambda, rho, lock }
    }
}

impl<C: Calc> Screw<C> {
    /// Torque, in N·m, for one newton that the motion works against, and for one that drives it:
    /// T = F d_2 / 2 · tan(λ ± ρ′). [Ports001, 5.3]
    pub fn arms(&self, thread: &Thread<C>) -> [C; 2] {
        let arm = |angle: C| {
            let (sin, cos) = angle.sin_cos();
            self.d_2 * sin / (C::constant(2.0) * cos)
        };
        [arm(thread.lambda + thread.rho), arm(thread.lambda - thread.rho)]
    }
}

impl Screw<f64> {
    /// What is said of a screw that its friction alone stops.
    #[must_use]
    pub fn stuck(&self) -> Option<String> {
        let thread = Thread::new(self);
        let sum = thread.lambda + thread.rho;
        (sum >= FRAC_PI_2 - 1e-9).then(|| {
            format!(
                "lead angle and angle of friction come to {} deg: no torque turns the screw against a force",
                short(sum.to_degrees())
            )
        })
    }
}

//! The boom system as a balance sees it: the moment of its weights about the boom foot, over the boom angle.

use num_dual::Dual64;

use crate::balance::symbols as s;
use crate::kernel::allowed::{FINITE, NOT_NEGATIVE, OutOfRange, check};
use crate::kernel::calc::Calc;
use crate::kernel::group::quantities;
use crate::parts::plane::{self, Point};

/// What has to be balanced, at any boom angle (rad).
pub trait Boom<C: Calc> {
    /// Moment and potential energy of the weights.
    ///
    /// # Errors
    /// An angle at which the boom system does not close, with the angles at which it does.
    fn at(&self, phi: C) -> Result<Load<C>, OutOfRange>;

    /// What each of at most three weights contributes to the moment, in N·m.
    ///
    /// # Errors
    /// As [`at`](Boom::at).
    fn parts(&self, phi: C) -> Result<[C; 3], OutOfRange>;

    /// The same moment by the power of each weight about the instant centre of its bar. [Ports001, 9]
    ///
    /// # Errors
    /// As [`at`](Boom::at).
    fn moment_by_power(&self, phi: C) -> Result<C, OutOfRange>;

    /// The moment, in N·m, with its derivative by the angle.
    ///
    /// # Errors
    /// As [`at`](Boom::at).
    fn slope(&self, phi: f64) -> Result<[f64; 2], OutOfRange>;

    /// Angles between which the boom can be, around `phi`.
    fn arc(&self, phi: f64) -> [f64; 2];
}

/// What the weights ask for at one boom angle.
#[derive(Clone, Copy, Debug)]
pub struct Load<C> {
    /// Moment about the boom foot, in N·m; positive raises the boom.
    pub m_0: C,
    /// Potential energy, in J, from the height of the boom foot.
    pub u_0: C,
}

quantities! {
    /// A boom without jib: weight (N), distance (m) and angle (rad) of its centre of gravity.
    Plain { g_b: G_B, r_b: R_B, chi_b: CHI_B }
}

impl<C: Calc> Plain<C> {
    /// # Errors
    /// A weight or a distance that is negative or no number.
    pub fn check(self) -> Result<Plain<C>, OutOfRange> {
        check(&s::G_B, self.g_b.value(), NOT_NEGATIVE)?;
        check(&s::R_B, self.r_b.value(), NOT_NEGATIVE)?;
        check(&s::CHI_B, self.chi_b.value(), FINITE)?;
        Ok(self)
    }
}

impl<C: Calc> Plain<C> {
    /// Moment and potential energy at a boom angle (rad), whatever it is.
    pub fn load(&self, phi: C) -> Load<C> {
        let (sin, cos) = (phi + self.chi_b).sin_cos();
        Load {
            m_0: (-(self.g_b * self.r_b * cos)).def(&s::M_0),
            u_0: (self.g_b * self.r_b * sin).def(&s::U_0),
        }
    }
}

impl<C: Calc> Boom<C> for Plain<C> {
    fn at(&self, phi: C) -> Result<Load<C>, OutOfRange> {
        Ok(self.load(phi))
    }

    fn parts(&self, phi: C) -> Result<[C; 3], OutOfRange> {
        let (m_0, nothing) = (self.at(phi)?.m_0, C::constant(0.0) * self.g_b * self.r_b);
        Ok([m_0, nothing, nothing])
    }

    fn moment_by_power(&self, phi: C) -> Result<C, OutOfRange> {
        self.at(phi).map(|load| load.m_0.def(&s::M_0_P))
    }

    fn slope(&self, phi: f64) -> Result<[f64; 2], OutOfRange> {
        let dual = self.map(&mut |_, value| Dual64::from_re(value.value()));
        let m_0 = dual.load(Dual64::new(phi, 1.0)).m_0;
        Ok([m_0.re, m_0.eps])
    }

    fn arc(&self, _: f64) -> [f64; 2] {
        FINITE
    }
}

/// The joint on the boom at `r` (m) and `alpha` (rad) from its axis.
pub fn joint<C: Calc>(phi: C, r: C, alpha: C) -> Point<C> {
    let (sin, cos) = (phi + alpha).def(&s::PHI_K).sin_cos();
    plane::def(Point::new(r * cos, r * sin), [&s::K_X, &s::K_Y])
}

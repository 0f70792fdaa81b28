//! Tail weight: a counterweight on the boom's rearward extension. Exact where
//! `G_c r_c = G_b r_b` and the foot lies on the line of both centres of gravity.

use std::f64::consts::PI;

use crate::balance::action::Action;
use crate::balance::symbols as s;
use crate::kernel::allowed::OutOfRange;
use crate::kernel::calc::Calc;
use crate::kernel::group::{quantities, sound};
use crate::parts::plane::{self, Point};

quantities! {
    /// Weight (N), distance from the boom foot (m), angle from the rearward extension (rad).
    Tail { g_c: G_C, r_c: R_C, chi_c: CHI_C }
}

impl<C: Calc> Tail<C> {
    /// # Errors
    /// A negative weight or distance, or what is no number.
    pub fn new(self) -> Result<Tail<C>, OutOfRange> {
        sound(&self)?;
        Ok(self)
    }

    fn psi(&self, phi: C) -> C {
        (phi + self.chi_c + C::constant(PI)).def(&s::PSI)
    }

    /// The counterweight from the boom foot, in m, at boom angle `phi` (rad).
    pub fn place(&self, phi: C) -> Point<C> {
        let (sin, cos) = self.psi(phi).sin_cos();
        Point::new(self.r_c * cos, self.r_c * sin)
    }

    /// At boom angle `phi` (rad). [Ports001, 2.1.1]
    pub fn at(&self, phi: C) -> Action<C> {
        let psi = self.psi(phi);
        let (sin, cos) = psi.sin_cos();
        let y_5 = (self.r_c * sin).def(&s::C_5Y);
        let nothing = C::constant(0.0) * self.g_c;
        Action {
            m_b: (-(self.g_c * self.r_c * cos)).def(&s::M_UR),
            u_5: (self.g_c * y_5).def(&s::U_5),
            y_5: Some(y_5),
            on_boom: plane::def(Point::new(nothing, -self.g_c), [&s::F_KX, &s::F_KY]),
            on_pivot: None,
            n_1: None,
            lever: None,
        }
    }
}

//! Parallelogram lever: the counterweight's lever stays parallel to the boom.
//! Exact under the same condition as the tail weight.

use std::f64::consts::PI;

use crate::balance::action::{Action, LeverTurn, RodLine};
use crate::balance::boom::joint;
use crate::balance::symbols as s;
use crate::kernel::allowed::OutOfRange;
use crate::kernel::calc::Calc;
use crate::kernel::group::{quantities, sound};
use crate::parts::plane::{self, Point};

quantities! {
    /// Counterweight (N) with its arm (m) and its angle (rad) from the rearward
    /// parallel of the boom; the rod's joints at `r_1` (m), `alpha_1` (rad) from
    /// foot and pivot; the pivot at `d_1` (m), `delta_1` (rad) from the foot,
    /// which are also length and direction of the rod.
    Parallelogram { g_c: G_C, r_c: R_C, chi_c: CHI_C, r_1: R_K, alpha_1: ALPHA_K, d_1: D_1, delta_1: DELTA_1 }
}

impl<C: Calc> Parallelogram<C> {
    /// # Errors
    /// A length of the linkage that is not positive, a negative weight or arm, or what is no number.
    pub fn new(self) -> Result<Parallelogram<C>, OutOfRange> {
        sound(&self)?;
        Ok(self)
    }

    /// Boom angles between two dead points, in rad, around `phi`.
    #[must_use]
    pub fn arc(&self, phi: f64) -> [f64; 2] {
        let dead = (self.delta_1 - self.alpha_1).value();
        let low = dead + ((phi - dead) / PI).floor() * PI;
        [low, low + PI]
    }

    fn psi(&self, phi: C) -> C {
        (phi + self.chi_c + C::constant(PI)).def(&s::PSI)
    }

    /// The counterweight from the boom foot, in m, at boom angle `phi` (rad).
    pub fn place(&self, phi: C) -> Point<C> {
        let (sin_1, cos_1) = self.delta_1.sin_cos();
        let (sin, cos) = self.psi(phi).sin_cos();
        Point::new(self.d_1 * cos_1 + self.r_c * cos, self.d_1 * sin_1 + self.r_c * sin)
    }

    /// How its rod carries a force on the counterweight at `place` (m).
    pub fn line(&self, phi: C, place: Point<C>) -> RodLine<C> {
        let k = joint(phi, self.r_1, self.alpha_1);
        let (sin, cos) = self.delta_1.sin_cos();
        let along = Point::new(cos, sin);
        let arm = place - along * self.d_1;
        RodLine {
            per_force: Point::new(-arm.y, arm.x) / plane::cross(k, along),
            along,
            rail: None,
        }
    }

    /// At boom angle `phi` (rad). [Ports001, 2.1.2]
    ///
    /// # Errors
    /// The dead point, where the rod points at the boom foot.
    pub fn at(&self, phi: C) -> Result<Action<C>, OutOfRange> {
        let k = joint(phi, self.r_1, self.alpha_1);
        let (sin, cos) = self.delta_1.sin_cos();
        let rod = plane::def(Point::new(self.d_1 * cos, self.d_1 * sin), [&s::L_1X, &s::L_1Y]);
        let h_1 = (plane::cross(k, rod) / self.d_1).def(&s::H_1);
        if h_1.value().abs() <= 4.0 * f64::EPSILON * self.r_1.value() {
            let what = "the rod points at the boom foot: a dead point";
            return Err(OutOfRange::new(&s::PHI, phi.value(), self.arc(phi.value()), what));
        }
        let psi = self.psi(phi);
        let (sin, cos) = psi.sin_cos();
        let y_5 = (self.r_c * sin).def(&s::C_5Y);
        let m_b = (-(self.g_c * self.r_c * cos)).def(&s::M_UR);
        let n_1 = (m_b / h_1).def(&s::N_1);
        let pull = Point::new(n_1 * rod.x / self.d_1, n_1 * rod.y / self.d_1);
        let on_boom = plane::def(pull, [&s::F_KX, &s::F_KY]);
        let on_pivot = plane::def(Point::new(on_boom.x, on_boom.y + self.g_c), [&s::F_MX, &s::F_MY]);
        let gamma = C::direction(plane::dot(k, rod).abs(), plane::cross(k, rod).abs()).def(&s::GAMMA);
        Ok(Action {
            m_b,
            u_5: (self.g_c * y_5).def(&s::U_5),
            y_5: Some(y_5),
            on_boom,
            on_pivot: Some(on_pivot),
            n_1: Some(n_1),
            lever: Some(LeverTurn {
                psi,
                i_5: C::constant(1.0).def(&s::I_5),
                i_1: C::constant(0.0),
                gamma,
            }),
        })
    }
}

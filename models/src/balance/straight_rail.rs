//! Rope over a guide pulley to a counterweight on a straight rail. The pulley
//! is a point.

use std::f64::consts::FRAC_PI_2;

use crate::balance::action::{Action, RodLine};
use crate::balance::boom::joint;
use crate::balance::symbols as s;
use crate::kernel::allowed::{OutOfRange, POSITIVE, check};
use crate::kernel::calc::Calc;
use crate::kernel::group::{quantities, sound};
use crate::parts::plane::{self, Point};

quantities! {
    /// Counterweight (N), rope's joint on the boom (m, rad), guide pulley (m),
    /// slope of the rail (rad): it runs down to the rear.
    StraightRail { g_c: G_C, r_1: R_K, alpha_1: ALPHA_K, h_x: H_X, h_y: H_Y, lambda: LAMBDA }
}

impl<C: Calc> StraightRail<C> {
    /// # Errors
    /// A joint at the boom foot, a negative weight, a rail that does not go down, or what is no number.
    pub fn new(self) -> Result<StraightRail<C>, OutOfRange> {
        check(&s::LAMBDA, self.lambda.value(), [0.0, FRAC_PI_2])?;
        sound(&self)?;
        Ok(self)
    }

    /// The counterweight along its rail, in m from a place that does not move, at boom angle `phi` (rad).
    pub fn place(&self, phi: C) -> Point<C> {
        let rope = Point::new(self.h_x, self.h_y) - joint(phi, self.r_1, self.alpha_1);
        let s_r = plane::length(rope).def(&s::S_R);
        let (sin, cos) = self.lambda.sin_cos();
        Point::new(s_r * cos, s_r * sin)
    }

    /// How its rope carries a force on the counterweight.
    pub fn line(&self, phi: C) -> RodLine<C> {
        let rope = Point::new(self.h_x, self.h_y) - joint(phi, self.r_1, self.alpha_1);
        let (sin, cos) = self.lambda.sin_cos();
        let up = Point::new(cos, sin);
        RodLine {
            per_force: -up,
            along: rope / plane::length(rope),
            rail: Some(up),
        }
    }

    /// At boom angle `phi` (rad). [Ports001, 2.1.4]
    ///
    /// # Errors
    /// A joint that coincides with the pulley.
    pub fn at(&self, phi: C) -> Result<Action<C>, OutOfRange> {
        let k = joint(phi, self.r_1, self.alpha_1);
        let rope = Point::new(self.h_x, self.h_y) - k;
        let s_r = plane::length(rope).def(&s::S_R);
        if s_r.value() <= 4.0 * f64::EPSILON * self.r_1.value() {
            let what = "the rope's joint coincides with the guide pulley";
            return Err(OutOfRange::new(&s::S_R, s_r.value(), POSITIVE, what));
        }
        let (sin, cos) = self.lambda.sin_cos();
        let n_1 = (self.g_c * sin).def(&s::N_1);
        let h_1 = (plane::cross(k, rope) / s_r).def(&s::H_1);
        let pull = Point::new(n_1 * rope.x / s_r, n_1 * rope.y / s_r);
        let on_boom = plane::def(pull, [&s::F_KX, &s::F_KY]);
        let y_5 = (s_r * sin).def(&s::C_5Y);
        Ok(Action {
            m_b: (n_1 * h_1).def(&s::M_UR),
            u_5: (self.g_c * y_5).def(&s::U_5),
            y_5: Some(y_5),
            on_boom,
            on_pivot: Some(plane::def(
                Point::new(on_boom.x + n_1 * cos, on_boom.y + n_1 * sin),
                [&s::F_MX, &s::F_MY],
            )),
            n_1: Some(n_1),
            lever: None,
        })
    }
}

//! Rope to a trolley on a curved rail. The rail follows from the condition that
//! the potential energy of boom and trolley stays what it is: the balance is
//! exact, for any boom.

use crate::balance::action::{Action, RodLine};
use crate::balance::boom::{Load, joint};
use crate::balance::symbols as s;
use crate::kernel::allowed::{FINITE, NOT_NEGATIVE, OutOfRange, POSITIVE, check};
use crate::kernel::calc::Calc;
use crate::kernel::group::quantities;
use crate::parts::plane::{self, Point};

quantities! {
    /// Trolley (N), rope's joint on the boom (m, rad), length of the rope (m),
    /// height of the trolley (m) at the reference angle (rad).
    RailDimensions { g_c: G_C, r_1: R_K, alpha_1: ALPHA_K, l_r: L_R, y_0: Y_0, phi_0: PHI_0 }
}

/// The balance of one boom, at no particular position.
#[derive(Clone, Copy, Debug)]
pub struct CurvedRail<C> {
    pub dimensions: RailDimensions<C>,
    /// Potential energy of the boom at the reference angle, in J.
    u_0: C,
}

impl<C: Copy> CurvedRail<C> {
    /// The same balance over another scalar.
    #[must_use]
    pub fn map<D>(&self, f: fn(C) -> D) -> CurvedRail<D> {
        CurvedRail {
            dimensions: self.dimensions.map(&mut |_, value| f(value)),
            u_0: f(self.u_0),
        }
    }
}

impl<C: Calc> CurvedRail<C> {
    /// `u_0` is the boom's potential energy (J) at a boom angle (rad).
    ///
    /// # Errors
    /// A weight or a length that is not positive, or a boom that does not close at the reference angle.
    pub fn new(
        dimensions: RailDimensions<C>,
        u_0: impl FnOnce(C) -> Result<C, OutOfRange>,
    ) -> Result<CurvedRail<C>, OutOfRange> {
        let d = &dimensions;
        check(&s::G_C, d.g_c.value(), POSITIVE)?;
        check(&s::R_K, d.r_1.value(), NOT_NEGATIVE)?;
        check(&s::ALPHA_K, d.alpha_1.value(), FINITE)?;
        check(&s::L_R, d.l_r.value(), POSITIVE)?;
        check(&s::Y_0, d.y_0.value(), FINITE)?;
        check(&s::PHI_0, d.phi_0.value(), FINITE)?;
        let u_0 = u_0(d.phi_0)?;
        Ok(CurvedRail { dimensions, u_0 })
    }

    /// The trolley's place on its rail, in m from the boom foot, at boom angle `phi` (rad) where the
    /// boom's potential energy is `u_0` (J).
    ///
    /// # Errors
    /// A rope that is too short to reach the rail.
    pub fn rail(&self, phi: C, u_0: C) -> Result<Point<C>, OutOfRange> {
        let d = &self.dimensions;
        let k = joint(phi, d.r_1, d.alpha_1);
        let y = (d.y_0 - (u_0 - self.u_0) / d.g_c).def(&s::C_5Y);
        let height = k.y - y;
        let square = (d.l_r - height) * (d.l_r + height);
        // At zero the rope hangs vertically.
        if square.value().is_nan() || square.value() <= 0.0 {
            let allowed = [height.value().abs(), f64::INFINITY];
            return Err(OutOfRange::new(
                &s::L_R,
                d.l_r.value(),
                allowed,
                "the rope does not reach the rail",
            ));
        }
        let w_r = square.sqrt().def(&s::W_R);
        Ok(Point::new((k.x - w_r).def(&s::C_5X), y))
    }

    /// How its rope carries a force on the trolley at `place` (m), which moves by `travel` (m) for one radian of the boom.
    pub fn line(&self, phi: C, place: Point<C>, travel: Point<C>) -> RodLine<C> {
        let d = &self.dimensions;
        let k = joint(phi, d.r_1, d.alpha_1);
        let along = (place - k) / d.l_r;
        RodLine {
            per_force: travel / plane::cross(k, along),
            along,
            rail: None,
        }
    }

    /// At boom angle `phi` (rad): the trolley in equilibrium between its weight,
    /// the rope and the rail, across which the rail pushes. [Ports001, 2.1.5]
    ///
    /// # Errors
    /// As [`rail`](CurvedRail::rail); a rope across the rail.
    pub fn at(&self, phi: C, boom: &Load<C>) -> Result<Action<C>, OutOfRange> {
        let d = &self.dimensions;
        let c = self.rail(phi, boom.u_0)?;
        let k = joint(phi, d.r_1, d.alpha_1);
        let rope = k - c;
        let t_y = (boom.m_0 / d.g_c).def(&s::T_Y);
        // Power of weight and rope on the trolley: the rail takes no part in it,
        // and the trolley's travel along the rope is the boom's across its arm.
        let h_1 = (-(plane::cross(k, rope) / d.l_r)).def(&s::H_1);
        let at_rest = boom.m_0.value() == 0.0;
        let n_1 = if at_rest {
            boom.m_0 / d.l_r
        } else {
            -(d.g_c * t_y / h_1)
        }
        .def(&s::N_1);
        // Infinite where the rope points at the foot.
        if !n_1.value().is_finite() || n_1.value() < 0.0 {
            let what = "the rope cannot raise the boom: it would have to push, or points at the boom foot";
            return Err(OutOfRange::new(&s::N_1, n_1.value(), NOT_NEGATIVE, what));
        }
        let pull = Point::new(-(n_1 * rope.x / d.l_r), -(n_1 * rope.y / d.l_r));
        let on_boom = plane::def(pull, [&s::F_KX, &s::F_KY]);
        Ok(Action {
            m_b: plane::cross(k, on_boom).def(&s::M_UR),
            u_5: (d.g_c * c.y).def(&s::U_5),
            y_5: Some(c.y),
            on_boom,
            on_pivot: Some(plane::def(
                Point::new(on_boom.x, on_boom.y + d.g_c),
                [&s::F_MX, &s::F_MY],
            )),
            n_1: Some(n_1),
            lever: None,
        })
    }
}

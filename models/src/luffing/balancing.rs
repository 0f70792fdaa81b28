//! A balance on a boom, and what the drive gives with and without it. The equations are those of [`crate::balance`].

use crate::balance::Balance;
use crate::balance::boom::Load;
use crate::balance::residual::Residual;
use crate::balance::scene::Form;
use crate::balance::symbols as s;
use crate::component::stages::{absent, results};
use crate::kernel::allowed::{FINITE, OutOfRange};
use crate::kernel::calc::Calc;
use crate::parts::plane::Point;

/// The balance of a boom, at no particular position.
#[derive(Clone, Copy, Debug)]
pub struct Balancing<C> {
    pub balance: Balance<C>,
    /// Boom angles (rad) between the dead points around the working range: beyond
    /// them the linkage would be another assembly of the same bars.
    arc: Option<[f64; 2]>,
}

impl<C: Calc> Balancing<C> {
    /// Assembled as at the boom angle `phi` (rad); `u_0` is the boom's potential energy (J) at a boom angle (rad).
    ///
    /// # Errors
    /// Quantities with which there is no such balance; what `u_0` objects to.
    pub fn new(
        form: &Form<C>,
        phi: f64,
        u_0: impl FnOnce(C) -> Result<C, OutOfRange>,
    ) -> Result<Balancing<C>, OutOfRange> {
        let balance = form.balance(u_0)?;
        let arc = match &balance {
            Balance::Lever(lever) => Some(lever.arc(phi)),
            Balance::Parallelogram(lever) => Some(lever.arc(phi)),
            _ => None,
        };
        Ok(Balancing { balance, arc })
    }

    /// The same over another scalar.
    #[must_use]
    pub fn map<D: Calc>(&self, f: fn(C) -> D) -> Balancing<D> {
        Balancing {
            balance: self.balance.map(f),
            arc: self.arc,
        }
    }

    /// At a boom angle (rad), with what the boom asks for there.
    ///
    /// # Errors
    /// A boom angle at which the balance cannot be, with those at which it can; a boom that stands still.
    pub fn at(&self, phi: C, load: impl FnOnce() -> Load<C>) -> Result<Residual<C>, OutOfRange> {
        self.reached(phi.value()).map_err(|(near, arc)| {
            let what = "the balance linkage cannot get to this angle without passing a dead point";
            OutOfRange::new(&s::PHI, near, arc, what)
        })?;
        let load = load();
        if !load.m_0.value().is_finite() {
            let what = "the boom stands still here: no moment about its foot balances it";
            return Err(OutOfRange::new(&s::M_0, load.m_0.value(), FINITE, what));
        }
        let action = self.balance.at(phi, &load)?;
        Ok(Residual::of(phi, load, action))
    }

    /// Whether the balance gets to a boom angle (rad); if not, the same angle near its arc, and the arc.
    fn reached(&self, phi: f64) -> Result<(), (f64, [f64; 2])> {
        let Some(arc) = self.arc else {
            return Ok(());
        };
        let turn = std::f64::consts::TAU;
        let near = phi - ((phi - f64::midpoint(arc[0], arc[1])) / turn).round() * turn;
        if (arc[0]..=arc[1]).contains(&near) {
            Ok(())
        } else {
            Err((near, arc))
        }
    }

    /// The counterweight at a boom angle (rad), in m from the boom foot, or on a straight rail from a place that does
    /// not move; `u_0` is the boom's potential energy (J) there. `None` where the balance cannot be.
    #[inline]
    pub fn place(&self, phi: C, u_0: impl FnOnce() -> C) -> Option<Point<C>> {
        self.reached(phi.value()).ok()?;
        self.balance.place(phi, u_0)
    }
}

/// Load, weights and balance together, against the mechanism without the balance.
#[derive(Clone, Copy, Debug)]
pub struct Balanced<C> {
    /// Total moment about the boom foot, in N·m; positive raises the boom.
    pub m_sum: C,
    /// Moment (N·m) that the drive would have to give without the balance, and its force (N).
    pub m_d_0: C,
    pub f_d_0: Option<C>,
}
results! { Balanced as b => {
    M_SUM: b.m_sum;
    M_D_0: b.m_d_0;
    F_D_0: b.f_d_0.ok_or_else(absent)?;
} }

impl<C: Calc> Balanced<C> {
    /// With the load's moment about the boom foot, load's and weights' moment about the foot of what is driven (N·m,
    /// positive where they lower it), and the force (N) that the drive needs for a moment, where there is a drive.
    pub fn new(
        residual: &Residual<C>,
        about_foot: C,
        [m_q, m_g]: [C; 2],
        force: impl FnOnce(C) -> Option<C>,
    ) -> Balanced<C> {
        let m_sum = (residual.dm - about_foot).def(&s::M_SUM);
        let m_d_0 = (m_q + m_g).def(&s::M_D_0);
        let f_d_0 = force(m_d_0);
        Balanced { m_sum, m_d_0, f_d_0 }
    }
}

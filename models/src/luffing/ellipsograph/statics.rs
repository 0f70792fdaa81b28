//! Moments for the boom's angle: what load, weights and drive do for one radian of it.

use crate::balance::boom::Load;
use crate::balance::residual::Residual;
use crate::balance::symbols as b;
use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::quantities;
use crate::luffing::ellipsograph::position::{Bars, GuidedPosition};
use crate::luffing::ellipsograph::symbols as s;
use crate::luffing::ellipsograph::velocity::GuidedTravel;
use crate::parts::plane::Point;

quantities! {
    /// Weights (N) of boom and link with their centres of gravity: from B and from the boom's line, and on the link.
    GuidedWeights { g_b: G_B, r_b: R_B, chi_b: CHI_B, g_l: G_L, r_l: R_L }
}

/// The load at the head.
#[derive(Clone, Copy, Debug)]
pub struct HeadLoad<C> {
    /// In N·m; positive lowers the boom.
    pub m_q: C,
    /// The same by the instantaneous centre.
    by_pole: C,
}
results! { HeadLoad as h => { M_Q: h.m_q; M_Q_P: h.by_pole; } }

impl<C: Calc> HeadLoad<C> {
    /// M_Q = Q y′_A [Ports001, 5.9.2.3]; M_Q = Q (x_A − x_P) [Ports001, 5.9]
    pub fn new(position: &GuidedPosition<C>, pole: &Point<C>, travel: &GuidedTravel<C>, q: &C) -> HeadLoad<C> {
        HeadLoad {
            m_q: (*q * travel.a.y).def(&s::M_Q),
            by_pole: (*q * (position.a.x - pole.x)).def(&s::M_Q_P),
        }
    }
}

/// Own weights of boom and link.
#[derive(Clone, Copy, Debug)]
pub struct WeightMoment<C> {
    /// As a balance on the link sees it: it raises the link where it lowers the boom.
    pub load: Load<C>,
    /// In N·m; positive lowers the boom.
    pub m_g: C,
}
results! { WeightMoment as w => { M_G: w.m_g; } }

impl<C: Calc> WeightMoment<C> {
    /// M_G = G_b y′_S − G_l r_l cos φ with y_S = y_B + r_b sin(φ + χ_b), by virtual work.
    pub fn new(bars: &Bars<C>, weights: &GuidedWeights<C>, phi: &C) -> WeightMoment<C> {
        let ((sin, cos), (sin_s, cos_s)) = (phi.sin_cos(), (*phi + weights.chi_b).sin_cos());
        let foot = C::constant(2.0) * bars.c;
        let of = |boom: C, link: C| weights.g_b * boom - weights.g_l * weights.r_l * link;
        let m_g = of(weights.r_b * cos_s - foot * cos, cos).def(&s::M_G);
        let load = Load {
            m_0: m_g.def(&b::M_0),
            u_0: of(weights.r_b * sin_s - foot * sin, sin).def(&b::U_0),
        };
        WeightMoment { load, m_g }
    }
}

/// Moment that is left for the drive, in N·m; a balance that raises the link lowers the boom.
pub fn needed<C: Calc>(hanging: &HeadLoad<C>, own: Option<&WeightMoment<C>>, residual: Option<&Residual<C>>) -> C {
    let m_d = own.map_or(hanging.m_q, |own| hanging.m_q + own.m_g);
    let m_d = residual.map_or(m_d, |left| m_d + left.action.m_b);
    m_d.def(&s::M_D)
}

/// Power of the drive, in W.
pub fn power<C: Calc>(needed: &C, omega: &C) -> C {
    (*needed * *omega).def(&s::P_D)
}

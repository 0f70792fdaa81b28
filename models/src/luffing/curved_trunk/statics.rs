//! Moments for the boom's angle: what load and weights do for one radian of it.

use crate::balance::boom::Load;
use crate::balance::symbols as b;
use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::quantities;
use crate::luffing::curved_trunk::leading::power;
use crate::luffing::curved_trunk::position::TrunkPosition;
use crate::luffing::curved_trunk::symbols as s;
use crate::luffing::curved_trunk::velocity::TrunkTravel;
use crate::luffing::led::path::LedRope;
use crate::luffing::led::pull::LedPull;
use crate::parts::plane::{self, Point};

quantities! {
    /// Weights (N) of boom and trunk with their centres of gravity, from O1 and from B.
    TrunkWeights { g_b: G_B, r_b: R_B, chi_b: CHI_B, g_t: G_T, r_t: R_T, chi_t: CHI_T }
}

/// The load at the trunk's head.
#[derive(Clone, Copy, Debug)]
pub struct TrunkLoad<C> {
    /// In N·m; positive lowers the boom.
    pub m_q: C,
    /// The same by the instantaneous centre.
    by_pole: C,
}
results! { TrunkLoad as h => { M_Q: h.m_q; M_Q_P: h.by_pole; } }

impl<C: Calc> TrunkLoad<C> {
    /// M_Q = Q y′_A, and M_Q = Q i_2 (x_A − x_P). [Ports001, 5.9] With the centre at infinity the trunk moves along with B.
    /// With a led rope M_Q = Q y′_Q, and the powers of the rope on boom and trunk. [Ports001, 5.9.2.4]
    pub fn new(
        position: &TrunkPosition<C>,
        travel: &TrunkTravel<C>,
        pole: &Point<C>,
        q: &C,
        led: Option<&LedRope<C>>,
        pulled: Option<&LedPull<C>>,
    ) -> TrunkLoad<C> {
        let by_pole = if travel.at_infinity() {
            *q * position.b.x
        } else {
            *q * travel.i_2 * (position.a.x - pole.x)
        };
        let rise = led.map_or(travel.a.y, |led| led.rise);
        let by_pole = pulled.map_or(by_pole, |pulled| by_pole - power(position, travel, pole, &pulled.on));
        TrunkLoad {
            m_q: (*q * rise).def(&s::M_Q),
            by_pole: by_pole.def(&s::M_Q_P),
        }
    }
}

/// Own weights of boom and trunk.
#[derive(Clone, Copy, Debug)]
pub struct TrunkWeight<C> {
    pub load: Load<C>,
    /// In N·m; positive lowers the boom.
    pub m_g: C,
    /// Moment (N·m) of the boom's weight about O1 and of the trunk's about B, both of which they lower.
    pub of_boom: C,
    pub of_trunk: C,
    /// The weights, in N.
    pub boom: C,
    pub trunk: C,
}
results! { TrunkWeight as w => { M_G: w.m_g; } }

impl<C: Calc> TrunkWeight<C> {
    /// M_G = G_b x_Sb + G_t (x_B + i_2 x_St), by virtual work.
    pub fn new(
        weights: &TrunkWeights<C>,
        phi: &C,
        position: &TrunkPosition<C>,
        travel: &TrunkTravel<C>,
    ) -> TrunkWeight<C> {
        let w = weights;
        let (sin, cos) = (*phi + w.chi_b).sin_cos();
        let s_b = plane::def(Point::new(w.r_b * cos, w.r_b * sin), [&s::S_BX, &s::S_BY]);
        let (sin, cos) = w.chi_t.sin_cos();
        let s_t = plane::turned(position.along, w.r_t * cos, w.r_t * sin);
        let s_t = plane::def(s_t, [&s::S_TX, &s::S_TY]);
        let of_boom = w.g_b * s_b.x;
        let m_g = (of_boom + w.g_t * (position.b.x + travel.i_2 * s_t.x)).def(&s::M_G);
        let load = Load {
            m_0: (-m_g).def(&b::M_0),
            u_0: (w.g_b * s_b.y + w.g_t * (position.b.y + s_t.y)).def(&b::U_0),
        };
        TrunkWeight {
            load,
            m_g,
            of_boom,
            of_trunk: w.g_t * s_t.x,
            boom: w.g_b,
            trunk: w.g_t,
        }
    }
}

//! Moments of load and own weights by virtual work.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::luffing::double_link::geometry::Geometry;
use crate::luffing::double_link::parameters::{Driven, Lengths, Weights};
use crate::luffing::double_link::pole::Pole;
use crate::luffing::double_link::position::Position;
use crate::luffing::double_link::symbols as s;
use crate::luffing::double_link::velocity::Velocity;
use crate::luffing::led::path::LedRope;
use crate::luffing::led::pull::LedPull;
use crate::parts::plane::{self, Point};

/// Luffing moment of the load about the foot of the driving link, in N·m; positive lowers the bar.
#[derive(Clone, Copy, Debug)]
pub struct LoadMoment<C> {
    pub m_q: C,
}
results! { LoadMoment as m => { M_Q: m.m_q; } }

impl<C: Calc> LoadMoment<C> {
    /// Of the load Q (N), which rises with the head unless its rope is led. [Li2022, eq. 11, by virtual work]
    #[inline]
    pub fn new(v: &Velocity<C>, led: Option<&LedRope<C>>, q: &C) -> LoadMoment<C> {
        let rise = led.map_or(v.da.y, |led| led.rise);
        LoadMoment {
            m_q: (*q * rise).def(&s::M_Q),
        }
    }
}

/// The same through the instantaneous centre, with the powers of a led rope on each bar. [Li2022, eq. 11; Ports001, 5.9.2.4]
pub fn by_pole<C: Calc>(
    pole: &Pole<C>,
    g: &Geometry<C>,
    p: &Position<C>,
    v: &Velocity<C>,
    q: &C,
    pulled: Option<&LedPull<C>>,
) -> C {
    let load = pole.moment(g, p, v, *q);
    pulled
        .map_or(load, |pulled| load - pole.power(p, v, &pulled.on))
        .def(&s::M_Q_P)
}

/// Centres of gravity, in m from each bar's first joint: boom from O1, jib from
/// B, rocker from O3. [Balance004, Fig. 1]
#[derive(Clone, Copy, Debug)]
pub struct Centres<C> {
    pub boom: Point<C>,
    pub jib: Point<C>,
    pub rocker: Point<C>,
}

impl<C: Calc> Centres<C> {
    pub fn new(p: &Position<C>, l: &Lengths<C>, w: &Weights<C>) -> Centres<C> {
        let place = |bar: Point<C>, length: C, distance: C, angle: C, names| {
            let (sin, cos) = angle.sin_cos();
            plane::def(
                plane::turned(bar, distance * cos / length, distance * sin / length),
                names,
            )
        };
        Centres {
            boom: place(p.x_1, l.x_1, w.s_1, w.chi_1, [&s::R_1X, &s::R_1Y]),
            jib: place(p.x_2, l.x_2, w.s_2, w.chi_2, [&s::R_2X, &s::R_2Y]),
            rocker: place(p.x_3, l.x_3, w.s_3, w.chi_3, [&s::R_3X, &s::R_3Y]),
        }
    }
}

/// The own weights.
#[derive(Clone, Copy, Debug)]
pub struct Own<C> {
    pub centres: Centres<C>,
    /// Moment about the foot of the driving link, in N·m; positive lowers the bar.
    pub m_g: C,
}
results! { Own as w => { M_G: w.m_g; } }

impl<C: Calc> Own<C> {
    /// [Balance004, eq. 1, by virtual work]
    pub fn new(p: &Position<C>, v: &Velocity<C>, l: &Lengths<C>, w: &Weights<C>) -> Own<C> {
        let r = Centres::new(p, l, w);
        let m_g = match p.driven {
            Driven::Boom => w.g_1 * r.boom.x + w.g_2 * (p.x_1.x + v.i_2 * r.jib.x) + w.g_3 * v.i_follower * r.rocker.x,
            Driven::Rocker => {
                w.g_1 * v.i_follower * r.boom.x + w.g_2 * (p.x_3.x + v.i_2 * (r.jib.x - p.x_2.x)) + w.g_3 * r.rocker.x
            }
        };
        Own {
            centres: r,
            m_g: m_g.def(&s::M_G),
        }
    }
}

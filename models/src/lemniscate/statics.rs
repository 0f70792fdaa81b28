//! Moments by virtual work, and the forces in the pins by equilibrium of each body.

use crate::balance::Action;
use crate::calc::Calc;
use crate::lemniscate::geometry::{Driven, Weights};
use crate::lemniscate::position::Position;
use crate::lemniscate::symbols as s;
use crate::lemniscate::velocity::Velocity;
use crate::plane::{self, Point};

/// Luffing moment of the load Q (N) about the foot of the driven bar, in N·m;
/// positive lowers the bar. [Li2022, eq. 11, by virtual work]
#[inline]
pub fn load_moment<C: Calc>(v: &Velocity<C>, q: C) -> C {
    (q * v.da.y).def(&s::M_Q)
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
    pub fn new(p: &Position<C>, lengths: [C; 3], w: &Weights<C>) -> Centres<C> {
        let place = |bar: Point<C>, length: C, distance: C, angle: C, names| {
            let (sin, cos) = angle.sin_cos();
            plane::def(
                plane::turned(bar, distance * cos / length, distance * sin / length),
                names,
            )
        };
        Centres {
            boom: place(p.x_1, lengths[0], w.s_1, w.chi_1, [&s::R_1X, &s::R_1Y]),
            jib: place(p.x_2, lengths[1], w.s_2, w.chi_2, [&s::R_2X, &s::R_2Y]),
            rocker: place(p.x_3, lengths[2], w.s_3, w.chi_3, [&s::R_3X, &s::R_3Y]),
        }
    }
}

/// Moment of the own weights about the foot of the driven bar, in N·m; positive
/// lowers the bar. [Balance004, eq. 1, by virtual work]
pub fn weight_moment<C: Calc>(w: &Weights<C>, r: &Centres<C>, p: &Position<C>, v: &Velocity<C>) -> C {
    match p.driven {
        Driven::Boom => w.g_1 * r.boom.x + w.g_2 * (p.x_1.x + v.i_2 * r.jib.x) + w.g_3 * v.i_follower * r.rocker.x,
        Driven::Rocker => {
            w.g_1 * v.i_follower * r.boom.x + w.g_2 * (p.x_3.x + v.i_2 * (r.jib.x - p.x_2.x)) + w.g_3 * r.rocker.x
        }
    }
    .def(&s::M_G)
}

/// Moment that the drive must give to the driven bar (N·m) by virtual work of load and weights: with change points too,
/// where no finite forces in the pins carry them.
#[inline]
pub fn drive_moment<C: Calc>(m_q: C, m_g: C) -> C {
    (m_q + m_g).def(&s::M_D)
}

/// Forces in the pins, in N.
#[derive(Clone, Copy, Debug)]
pub struct PinForces<C> {
    /// Moment that the drive must give to the driven bar, in N·m.
    pub m_d: C,
    /// Of the boom on the jib.
    pub b: Point<C>,
    /// Of the rocker on the jib.
    pub c: Point<C>,
    /// Of the frame on the boom.
    pub o1: Point<C>,
    /// Of the frame on the rocker.
    pub o3: Point<C>,
    /// Axial force in the rocker at C, tension positive.
    pub n_3: C,
}

impl<C: Calc> PinForces<C> {
    /// Equilibrium of jib, driven-along bar and driven bar, in this order.
    /// `weights` come with their centres; without them the bars are weightless.
    /// `balance` acts on the boom.
    /// `drive` turns the driven bar's moment into a force (N) at its anchor, or
    /// into none where the drive is a moment.
    pub fn new(
        p: &Position<C>,
        x_3: C,
        q: C,
        weights: Option<(&Weights<C>, &Centres<C>)>,
        balance: Option<&Action<C>>,
        drive: impl FnOnce(C) -> Option<Point<C>>,
    ) -> PinForces<C> {
        let half = p.k / C::constant(2.0);
        // Load on the jib, its moment about B, and the moments of boom and
        // rocker weight about their feet: all clockwise positive.
        let (load, about_b, boom, rocker) = match weights {
            Some((w, r)) => (
                q + w.g_2,
                q * p.x_4.x + w.g_2 * r.jib.x,
                Some((w.g_1 * r.boom.x).def(&s::M_1)),
                Some((w.g_3 * r.rocker.x).def(&s::M_3)),
            ),
            None => (q, q * p.x_4.x, None, None),
        };
        // What the balance does not carry.
        let boom = match (boom, balance) {
            (Some(boom), Some(action)) => Some(boom - action.m_b),
            _ => boom,
        };
        let foot = |force: Point<C>| balance.map_or(force, |action| force - action.on_boom);
        let (g_1, g_3) = (weights.map(|(w, _)| w.g_1), weights.map(|(w, _)| w.g_3));
        let minus = |force: Point<C>| Point::new(-force.x, load - force.y);
        let up = |force: Point<C>, g: Option<C>| Point::new(force.x, g.map_or(force.y, |g| force.y + g));
        match p.driven {
            Driven::Boom => {
                let about_b = about_b.def(&s::M_B);
                // cross(x_2, F_C) = about_b, cross(x_3, F_C) = −rocker.
                let along = |x_2: C, x_3: C| match rocker {
                    Some(rocker) => -((about_b * x_3 + rocker * x_2) / half),
                    None => -(about_b * x_3 / half),
                };
                let c = plane::def(
                    Point::new(along(p.x_2.x, p.x_3.x), along(p.x_2.y, p.x_3.y)),
                    [&s::F_CX, &s::F_CY],
                );
                let b = plane::def(minus(c), [&s::F_BX, &s::F_BY]);
                let lift = plane::cross(p.x_1, b);
                let m_d = boom.map_or(lift, |boom| lift + boom).def(&s::M_D);
                let push = drive(m_d);
                let o1 = plane::def(
                    push.map_or(foot(up(b, g_1)), |push| foot(up(b, g_1)) - push),
                    [&s::F_O1X, &s::F_O1Y],
                );
                let o3 = plane::def(up(c, g_3), [&s::F_O3X, &s::F_O3Y]);
                let n_3 = (-(plane::dot(c, p.x_3) / x_3)).def(&s::N_3);
                PinForces { m_d, b, c, o1, o3, n_3 }
            }
            Driven::Rocker => {
                // cross(x_2, F_B) = load · x_2 − about_b, cross(x_1, F_B) = −boom.
                let about_c = (load * p.x_2.x - about_b).def(&s::M_C);
                let along = |x_1: C, x_2: C| match boom {
                    Some(boom) => (about_c * x_1 + boom * x_2) / half,
                    None => about_c * x_1 / half,
                };
                let b = plane::def(
                    Point::new(along(p.x_1.x, p.x_2.x), along(p.x_1.y, p.x_2.y)),
                    [&s::F_BX, &s::F_BY],
                );
                let c = plane::def(minus(b), [&s::F_CX, &s::F_CY]);
                let lift = plane::cross(p.x_3, c);
                let m_d = rocker.map_or(lift, |rocker| lift + rocker).def(&s::M_D);
                let push = drive(m_d);
                let o3 = plane::def(
                    push.map_or(up(c, g_3), |push| up(c, g_3) - push),
                    [&s::F_O3X, &s::F_O3Y],
                );
                let o1 = plane::def(foot(up(b, g_1)), [&s::F_O1X, &s::F_O1Y]);
                let n_3 = (-(plane::dot(c, p.x_3) / x_3)).def(&s::N_3);
                PinForces { m_d, b, c, o1, o3, n_3 }
            }
        }
    }
}

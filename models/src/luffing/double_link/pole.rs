//! The instantaneous centre of the jib.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::luffing::double_link::geometry::Geometry;
use crate::luffing::double_link::parameters::Driven;
use crate::luffing::double_link::position::Position;
use crate::luffing::double_link::symbols as s;
use crate::luffing::double_link::velocity::Velocity;
use crate::luffing::led::pull::Hauled;
use crate::parts::plane::{self, Point};

/// Instantaneous centre of the jib.
#[derive(Clone, Copy, Debug)]
pub enum Pole<C> {
    Finite {
        /// From O1 along the boom, in m. [Li2022, eq. 1]
        o1p: C,
        /// From O3 along the rocker, in m.
        o3p: C,
        at: Point<C>,
    },
    /// Boom and rocker, this vector, are parallel within rounding.
    AtInfinity(Point<C>),
}

results! { Pole as c => {
    O1P: c.seen().0;
    P_X: c.seen().1.x;
    P_Y: c.seen().1.y;
    P_AT_INFINITY: C::constant(f64::from(c.finite().is_none()));
} }

impl<C: Calc> Pole<C> {
    /// The lines of boom and rocker intersected. With change points these may be one line: there the centre is the
    /// driving link's point about which the jib turns by its ratio. [Li2022, eq. 1]
    pub fn new(g: &Geometry<C>, p: &Position<C>, v: &Velocity<C>) -> Pole<C> {
        if p.passing.is_some() {
            let (head, bar) = match p.driven {
                Driven::Boom => (p.b, p.x_1),
                Driven::Rocker => (p.c, p.x_3),
            };
            let i_2 = v.i_2;
            if i_2.value().abs() <= 4.0 * f64::EPSILON {
                return Pole::AtInfinity(p.x_1);
            }
            let at = plane::def(head - bar / i_2, [&s::P_X, &s::P_Y]);
            return Pole::Finite {
                o1p: (plane::dot(at, p.x_1) / g.lengths.x_1).def(&s::O1P),
                o3p: plane::dot(at - g.lengths.o3(), p.x_3) / g.lengths.x_3,
                at,
            };
        }
        let sine = plane::cross(p.x_1, p.x_3);
        let scale = (g.lengths.x_1 * g.lengths.x_3).value();
        if sine.value().abs() <= 4.0 * f64::EPSILON * scale {
            return Pole::AtInfinity(p.x_1);
        }
        let along_boom = plane::cross(g.lengths.o3(), p.x_3) / sine;
        let along_rocker = plane::cross(g.lengths.o3(), p.x_1) / sine;
        let o1p = (along_boom * g.lengths.x_1).def(&s::O1P);
        let at = plane::def(
            Point::new(along_boom * p.x_1.x, along_boom * p.x_1.y),
            [&s::P_X, &s::P_Y],
        );
        Pole::Finite {
            o1p,
            o3p: along_rocker * g.lengths.x_3,
            at,
        }
    }

    /// Distance from O1 along the boom and place, unless at infinity.
    pub fn finite(&self) -> Option<(C, Point<C>)> {
        match *self {
            Pole::Finite { o1p, at, .. } => Some((o1p, at)),
            Pole::AtInfinity(_) => None,
        }
    }

    /// The same at infinity too, on the line of the boom.
    fn seen(&self) -> (C, Point<C>) {
        let far = |direction: C| match direction.value() {
            0.0 => C::constant(0.0),
            value => C::constant(f64::INFINITY.copysign(value)),
        };
        match *self {
            Pole::Finite { o1p, at, .. } => (o1p, at),
            Pole::AtInfinity(boom) => (C::constant(f64::INFINITY), boom.map(far)),
        }
    }

    /// Luffing moment of the load Q (N) about the foot of the driving link through
    /// the instantaneous centre, in N·m; positive lowers the bar. With the
    /// centre at infinity the jib moves along with the driving link's head. [Li2022, eq. 11]
    ///
    /// Signed distances: DA from the centre forward to A, PB from B to the
    /// centre along the driving link; eq. (11) with them has the opposite sign.
    pub fn moment(&self, g: &Geometry<C>, p: &Position<C>, v: &Velocity<C>, q: C) -> C {
        match *self {
            Pole::AtInfinity(_) => q * v.head.y,
            Pole::Finite { o1p, o3p, at } => {
                let (bar, beyond) = match p.driven {
                    Driven::Boom => (g.lengths.x_1, o1p - g.lengths.x_1),
                    Driven::Rocker => (g.lengths.x_3, o3p - g.lengths.x_3),
                };
                -(q * bar * (p.a.x - at.x) / beyond)
            }
        }
    }

    /// Power (N·m) of forces on boom, jib and rocker, with their moments about the bars' first joints, for one radian of the
    /// driving link: each bar turns about its foot, the jib about this centre, or moves along with the driving link's head.
    /// [Ports001, 5.9.2.4]
    pub fn power(&self, p: &Position<C>, v: &Velocity<C>, on: &[Hauled<C>; 3]) -> C {
        let [boom, jib, rocker] = on;
        let of_jib = match *self {
            Pole::AtInfinity(_) => plane::dot(jib.force, v.head),
            Pole::Finite { at, .. } => v.i_2 * (jib.moment + plane::cross(p.b - at, jib.force)),
        };
        let (i_1, i_3) = v.of_feet(p);
        boom.moment * i_1 + of_jib + rocker.moment * i_3
    }
}

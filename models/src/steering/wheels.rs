//! Angles and speeds of the groups for a turning centre. [Zhang2016, eq. 1-9, for any layout]
//!
//! No group is ever faster than the travel speed, and the speed of straight travel is the machine's own. A group on
//! the turning centre stands still and straight ahead.

use std::f64::consts::PI;

use crate::component::stages::results;
use crate::kernel::calc::{Among, Calc};
use crate::parts::plane::{self, Point};
use crate::steering::centre::Centre;
use crate::steering::limits::Limits;
use crate::steering::machine::Axis;
use crate::steering::symbols as s;

/// Where a group rolls when the machine travels forward: what a turn about the centre gives it, and how much that is.
#[derive(Clone, Copy, Debug)]
pub struct Rolling<C> {
    pub along: Point<C>,
    pub length: C,
}

impl<C: Calc> Rolling<C> {
    #[inline]
    pub fn new(centre: &Centre<C>, axis: &Axis<C>) -> Rolling<C> {
        Rolling::about(centre, axis.point())
    }

    /// Of a group that stands at a point.
    #[inline]
    pub fn about(centre: &Centre<C>, p: Point<C>) -> Rolling<C> {
        let along = centre.rolling(p);
        if centre.is_far() {
            // A direction alone has no length to be named.
            let length = plane::length(along);
            return Rolling { along, length };
        }
        let along = plane::def(along, [&s::U_X, &s::U_Y]);
        let length = plane::length(along).def(&s::U);
        Rolling { along, length }
    }
}

/// Travel speed over the greatest length of all groups' rolling directions. `v_t` is the speed of the fastest group, in
/// m/s; positive travels forward.
#[inline]
pub fn scale<C: Calc>(centre: &Centre<C>, rollings: &[Rolling<C>], v_t: &C) -> C {
    let lengths = rollings.iter().map(|rolling| rolling.length);
    let fastest = lengths.reduce(C::greater).expect("at least one group");
    *v_t / if centre.is_far() {
        fastest
    } else {
        let one = C::known(&s::U, fastest.value());
        fastest.among(Among::Greatest, one).def(&s::U_MAX)
    }
}

/// How one group stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wheel<C> {
    /// Heading from straight ahead, counter-clockwise, in rad.
    pub theta: C,
    /// Cosine and sine of the heading.
    pub turn: Point<C>,
    /// Whether forward travel rolls it against its heading.
    pub backwards: bool,
    /// Whether its range allows this; else it keeps the angle that it would need.
    pub placed: bool,
}
results! { each Wheel as w => { THETA: w.theta; } }

impl<C: Calc> Wheel<C> {
    /// With its axle line through the turning centre: in (−π/2, π/2], turned over by half a turn where only that brings
    /// the group into its range.
    #[inline]
    pub fn new(rolling: &Rolling<C>, limits: &Limits) -> Wheel<C> {
        let Rolling { along, length } = *rolling;
        if length.value() == 0.0 {
            return Wheel {
                theta: C::constant(0.0),
                turn: Point::new(C::constant(1.0), C::constant(0.0)),
                backwards: false,
                placed: true,
            };
        }
        let backwards = along.x.value() < 0.0 || (along.x.value() == 0.0 && along.y.value() < 0.0);
        let along = if backwards { -along } else { along };
        let theta = C::direction(along.x, along.y);
        let needed = theta.value();
        let allowed = limits.allows(needed);
        let other = if allowed {
            None
        } else {
            limits.equivalents(needed).next()
        };
        let (theta, along) = match other {
            Some(other) => (theta + C::constant(PI.copysign(other - needed)), -along),
            None => (theta, along),
        };
        Wheel {
            theta: theta.def(&s::THETA),
            turn: plane::def(Point::new(along.x / length, along.y / length), [&s::C_I, &s::S_I]),
            backwards: backwards != other.is_some(),
            placed: allowed || other.is_some(),
        }
    }
}

/// Rolling speed of a group along its heading, in m/s; negative rolls backwards.
#[inline]
pub fn speed<C: Calc>(rolling: &Rolling<C>, wheel: &Wheel<C>, scale: &C) -> C {
    let length = if wheel.backwards {
        -rolling.length
    } else {
        rolling.length
    };
    (length * *scale).def(&s::V)
}

//! The path of the machine's points, and the lane that its outline sweeps.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::parts::plane::{self, Point};
use crate::steering::centre::Centre;
use crate::steering::machine::Machine;
use crate::steering::symbols as s;

/// Where the point `p` of the machine comes to when the machine travels with its
/// centre fixed and its fastest group rolls `distance` (m). `fastest` is the
/// greatest length of [`Centre::rolling`] over the groups. A chord, turned by half
/// the angle: exact for a centre at infinity too.
pub fn moved<C: Calc>(centre: &Centre<C>, fastest: C, p: Point<C>, distance: C) -> Point<C> {
    let along = centre.rolling(p);
    let scale = distance / fastest;
    let Some(w) = centre.turning() else {
        return p + Point::new(along.x * scale, along.y * scale);
    };
    let half = w * scale / C::constant(2.0);
    let (sin, cos) = half.sin_cos();
    let chord = if half.value() == 0.0 {
        scale
    } else {
        scale * (sin / half)
    };
    p + plane::turned(Point::new(along.x * chord, along.y * chord), cos, sin)
}

/// The lane that the outline sweeps while the centre stays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Swept<C> {
    /// Distance from the centre to the nearest and the farthest point of the
    /// outline, in m; infinite for a centre at infinity.
    pub inner: C,
    pub outer: C,
    /// Width of the lane, in m: what `outer` − `inner` is, without cancellation.
    pub width: C,
}
results! { Swept as lane => {
    R_IN: lane.inner;
    R_OUT: lane.outer;
    B_S: lane.width;
} }

impl<C: Calc> Swept<C> {
    /// Of the machine's outline.
    #[must_use]
    pub fn new(machine: &Machine<C>, centre: &Centre<C>) -> Swept<C> {
        let corners = &machine.corners;
        let w = centre.turning().unwrap_or(C::constant(0.0));
        let sign = C::constant(w.value().signum());
        let reach = |p: Point<C>| plane::length(centre.rolling(p));
        let edges = || corners.iter().zip(corners.iter().cycle().skip(1));
        let (mut far, mut near) = (corners[0], corners[0]);
        let (mut most, mut least) = (reach(far), reach(near));
        let mut turns = [false; 2];
        for (&p, &q) in edges() {
            let nearest = nearest(centre, w, p, q);
            let (of_corner, of_edge) = (reach(p), reach(nearest));
            if of_corner.value() > most.value() {
                far = p;
            }
            if of_edge.value() < least.value() {
                near = nearest;
            }
            (most, least) = (most.greater(of_corner), least.smaller(of_edge));
            // The centre lies on one side of every edge where it lies inside.
            let side = (plane::dot(q - p, centre.rolling(p)) * w).value();
            turns[0] |= side >= 0.0;
            turns[1] |= side <= 0.0;
        }
        if w.value() == 0.0 {
            let along = centre.rolling(corners[0]);
            let across = |p: &Point<C>| plane::cross(along, *p) / plane::length(along);
            let sides = corners.map(|p| across(&p));
            let outermost = |of_two: fn(C, C) -> C| sides.into_iter().reduce(of_two).expect("four corners");
            return Swept {
                inner: C::constant(f64::INFINITY),
                outer: C::constant(f64::INFINITY),
                width: outermost(C::greater) - outermost(C::smaller),
            };
        }
        let outer = most / w.abs();
        if turns[0] != turns[1] {
            return Swept {
                inner: C::constant(0.0),
                outer,
                width: outer,
            };
        }
        // |f|² − |n|² = (f − n)·(f + n) over the rolling vectors, whose difference is w times the distance.
        let apart = far - near;
        let sum = centre.rolling(far) + centre.rolling(near);
        let width = plane::cross(apart, sum) * sign / (most + least);
        Swept {
            inner: least / w.abs(),
            outer,
            width,
        }
    }
}

/// Point of the edge from `p` to `q` that is nearest to the centre.
fn nearest<C: Calc>(centre: &Centre<C>, w: C, p: Point<C>, q: Point<C>) -> Point<C> {
    let edge = q - p;
    // Rolling vectors are those to the centre, turned by a right angle and stretched by w.
    let along = -plane::cross(edge, centre.rolling(p)) * C::constant(w.value().signum());
    let whole = plane::dot(edge, edge) * w.abs();
    if along.value() <= 0.0 {
        p
    } else if along.value() >= whole.value() {
        q
    } else {
        p + edge * (along / whole)
    }
}

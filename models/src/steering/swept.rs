//! The path of the machine's points, and the lane that its outline sweeps.

use crate::calc::Calc;
use crate::plane::{self, Point};
use crate::steering::mode::Centre;

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
pub struct Swept {
    /// Distance from the centre to the nearest and the farthest point of the
    /// outline, in m; infinite for a centre at infinity.
    pub inner: f64,
    pub outer: f64,
    /// Width of the lane, in m: what `outer` − `inner` is, without cancellation.
    pub width: f64,
}

impl Swept {
    /// For the convex outline with these corners, in order around it; `None` for fewer than three.
    #[must_use]
    pub fn new(corners: &[Point<f64>], centre: &Centre<f64>) -> Option<Swept> {
        if corners.len() < 3 {
            return None;
        }
        let w = centre.turning().unwrap_or(0.0);
        let reach = |p: Point<f64>| plane::length(centre.rolling(p));
        let edges = || corners.iter().zip(corners.iter().cycle().skip(1));
        let (mut far, mut near) = (corners[0], corners[0]);
        let mut turns = [false; 2];
        for (&p, &q) in edges() {
            if reach(p) > reach(far) {
                far = p;
            }
            let nearest = nearest(centre, w, p, q);
            if reach(nearest) < reach(near) {
                near = nearest;
            }
            // The centre lies on one side of every edge where it lies inside.
            let side = plane::dot(q - p, centre.rolling(p)) * w;
            turns[0] |= side >= 0.0;
            turns[1] |= side <= 0.0;
        }
        if w == 0.0 {
            let along = centre.rolling(corners[0]);
            let across = |p: &Point<f64>| plane::cross(along, *p) / plane::length(along);
            let (low, high) = corners
                .iter()
                .map(across)
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
                    (low.min(x), high.max(x))
                });
            return Some(Swept {
                inner: f64::INFINITY,
                outer: f64::INFINITY,
                width: high - low,
            });
        }
        let outer = reach(far) / w.abs();
        if turns[0] != turns[1] {
            return Some(Swept {
                inner: 0.0,
                outer,
                width: outer,
            });
        }
        // |f|² − |n|² = (f − n)·(f + n) over the rolling vectors, whose difference is w times the distance.
        let apart = far - near;
        let sum = centre.rolling(far) + centre.rolling(near);
        let width = plane::cross(apart, sum) * w.signum() / (reach(far) + reach(near));
        Some(Swept {
            inner: reach(near) / w.abs(),
            outer,
            width,
        })
    }
}

/// Point of the edge from `p` to `q` that is nearest to the centre.
fn nearest(centre: &Centre<f64>, w: f64, p: Point<f64>, q: Point<f64>) -> Point<f64> {
    let edge = q - p;
    // Rolling vectors are those to the centre, turned by a right angle and stretched by w.
    let along = -plane::cross(edge, centre.rolling(p)) * w.signum();
    let whole = plane::dot(edge, edge) * w.abs();
    if along <= 0.0 {
        p
    } else if along >= whole {
        q
    } else {
        p + edge * (along / whole)
    }
}

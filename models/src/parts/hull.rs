//! The polygon around points of a plane.

use crate::parts::plane::{Point, cross};

/// Part of the points' spread by which a corner may stand out and still be one of a straight side.
const STRAIGHT: f64 = 1e-9;

/// The corners of the convex polygon around points, by their places, counter-clockwise from the one farthest to the left
/// (least x); points within it and on its sides are none. `None` where all of them stand on one line.
#[must_use]
pub fn hull(points: &[Point<f64>]) -> Option<Vec<usize>> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    let key = |at: &usize| (points[*at].x, points[*at].y);
    order.sort_by(|a, b| key(a).partial_cmp(&key(b)).expect("points are finite"));
    let spread = points.iter().flat_map(|a| points.iter().map(move |b| (a - b).norm()));
    let least = STRAIGHT * spread.fold(0.0, f64::max).powi(2);
    let half = |order: &mut dyn Iterator<Item = usize>| {
        let mut chain: Vec<usize> = Vec::new();
        for at in order {
            while let [.., before, last] = chain.as_slice()
                && cross(points[*last] - points[*before], points[at] - points[*last]) <= least
            {
                chain.pop();
            }
            chain.push(at);
        }
        chain.pop();
        chain
    };
    let mut corners = half(&mut order.iter().copied());
    corners.extend(half(&mut order.iter().rev().copied()));
    (corners.len() >= 3).then_some(corners)
}

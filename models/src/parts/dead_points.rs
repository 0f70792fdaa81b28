//! Dead points of a four-bar: where coupler and follower lie in one line. Their angles to twice the working precision.

use nalgebra::Scalar;
use twofloat::TwoFloat;

use crate::parts::plane::Point;

/// How one kind of dead point (stretched or folded) limits the crank.
#[derive(Clone, Copy, Debug)]
pub(super) enum Limit<C> {
    /// The crank stays between two dead angles; each comes with the tail that
    /// completes it to twice the working precision.
    Between([(C, f64); 2]),
    /// The crank stays out of the angles between two dead angles.
    Outside([(C, f64); 2]),
    /// The crank passes: at the worst position this margin (m²) is left.
    Free(C),
}

impl<C: Copy + Scalar> Limit<C> {
    pub(super) fn map<D>(&self, f: fn(C) -> D) -> Limit<D> {
        let both = |ends: [(C, f64); 2]| ends.map(|(end, tail)| (f(end), tail));
        match *self {
            Limit::Between(ends) => Limit::Between(both(ends)),
            Limit::Outside(ends) => Limit::Outside(both(ends)),
            Limit::Free(margin) => Limit::Free(f(margin)),
        }
    }
}

/// 2π less its double.
pub(super) const TAU_TAIL: f64 = 2.449_293_598_294_706_4e-16;

/// What must be added to `angle`, a dead angle in working precision, to make it
/// exact: Newton's method in double-double arithmetic on
/// a² + f² − d² − 2 a (f_x cos θ + f_y sin θ) = 0.
pub(super) fn dead_angle_tail(angle: f64, crank: f64, frame: Point<f64>, diagonal: TwoFloat) -> f64 {
    let square = |x: f64| TwoFloat::new_mul(x, x);
    let constant = square(crank) + square(frame.x) + square(frame.y) - diagonal * diagonal;
    let both = sin_cos(TwoFloat::from(angle));
    let mut tail = TwoFloat::from(0.0);
    // Quadratic convergence from 1e-16 (1e-8 where the linkage nearly passes), where twice is enough.
    for _ in 0..3 {
        let (sin, cos) = turned(both, tail);
        let residual = constant - 2.0 * crank * (frame.x * cos + frame.y * sin);
        let slope = 2.0 * crank * (frame.x * sin - frame.y * cos);
        let change = residual / slope;
        tail -= change;
        if f64::from(change).abs() < 1e-20 {
            break;
        }
    }
    f64::from(tail)
}

/// Sine and cosine of an angle that is larger by up to 1e-8, by their series.
fn turned([sin, cos]: [TwoFloat; 2], by: TwoFloat) -> (TwoFloat, TwoFloat) {
    let (along, across) = (1.0 - by * by / 2.0, by - by * by * by / 6.0);
    (sin * along + cos * across, cos * along - sin * across)
}

/// Sine and cosine in double-double arithmetic: by their series at a small part of the angle, doubled again. Error below
/// 1e-29 for |x| ≤ 3π. (The crate's own functions stop at 1e-22.)
fn sin_cos(x: TwoFloat) -> [TwoFloat; 2] {
    const DOUBLINGS: i32 = 5;
    let x = x * f64::powi(0.5, DOUBLINGS);
    let mut sums = [TwoFloat::from(0.0), TwoFloat::from(1.0)]; // sine, cosine
    let mut term = TwoFloat::from(1.0);
    for n in 1..60 {
        term = term * x / f64::from(n);
        if f64::from(term).abs() < 1e-36 {
            break;
        }
        let sign = if n % 4 < 2 { 1.0 } else { -1.0 };
        sums[usize::from(n % 2 == 0)] += sign * term;
    }
    (0..DOUBLINGS).fold(sums, |[sin, cos], _| [2.0 * sin * cos, 1.0 - 2.0 * sin * sin])
}

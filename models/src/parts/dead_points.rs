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
    let both = sin_cos(angle);
    let mut tail = 0.0;
    // Quadratic convergence from 1e-16 (1e-8 where the linkage nearly passes), where twice is enough.
    for _ in 0..3 {
        let (sin, cos) = turned(both, tail);
        let residual = constant - 2.0 * crank * (frame.x * cos + frame.y * sin);
        let slope = 2.0 * crank * (frame.x * f64::from(sin) - frame.y * f64::from(cos));
        let change = f64::from(residual) / slope;
        tail -= change;
        if change.abs() < 1e-20 {
            break;
        }
    }
    tail
}

/// Sine and cosine of an angle that is larger by up to 1e-8, by their series.
fn turned([sin, cos]: [TwoFloat; 2], by: f64) -> (TwoFloat, TwoFloat) {
    let (less, across) = (by * by / 2.0, TwoFloat::new_sub(by, by * by * by / 6.0));
    (sin - sin * less + cos * across, cos - cos * less - sin * across)
}

/// Sine and cosine in double-double arithmetic: by their series at a small part of the angle, doubled again. Error below
/// 1e-29 for |x| ≤ 3π. (The crate's own functions stop at 1e-22.)
fn sin_cos(x: f64) -> [TwoFloat; 2] {
    const DOUBLINGS: i32 = 5;
    // Of the series, and of those the first ones that need more than the working precision.
    const TERMS: u32 = 11;
    const FIRST: u32 = 6;
    let x = x * f64::powi(0.5, DOUBLINGS);
    let square = TwoFloat::new_mul(x, x);
    // 1 − x²/(n(n+1)) (1 − x²/((n+2)(n+3)) (1 − …)).
    let series = |n: u32| {
        let factor = |term: u32| f64::from((n + 2 * term) * (n + 2 * term + 1));
        let last = (FIRST..TERMS).rev();
        let last = last.fold(1.0, |rest, term| 1.0 - f64::from(square) * rest / factor(term));
        let first = (0..FIRST).rev();
        first.fold(TwoFloat::from(last), |rest, term| 1.0 - square * rest / factor(term))
    };
    (0..DOUBLINGS).fold([x * series(2), series(1)], |[sin, cos], _| {
        [2.0 * sin * cos, 1.0 - 2.0 * sin * sin]
    })
}

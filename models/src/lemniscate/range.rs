//! Results of the whole working range: extremes, level error, work.

use std::num::NonZeroUsize;

use gauss_quad::GaussLegendre;

use crate::lemniscate::geometry::Geometry;
use crate::lemniscate::position::Position;
use crate::lemniscate::scene::Motion;
use crate::lemniscate::velocity::Velocity;

/// A value and the angle of the driven bar (rad) where it occurs.
#[derive(Clone, Copy, Debug)]
pub struct Extreme {
    pub value: f64,
    pub at: f64,
}

/// Results of the working range.
#[derive(Clone, Copy, Debug)]
pub struct Range {
    pub r_max: Extreme,
    pub r_min: Extreme,
    /// Heights of A, in m.
    pub y_max: Extreme,
    pub y_min: Extreme,
    pub mu_min: Extreme,
    /// Greatest rise of A per radian by amount, in m: where the luffing moment is greatest.
    pub dy_max: Extreme,
    /// Rise of A from the start to the end of the range, in m.
    pub rise: f64,
}

/// Points at which a quantity is looked at before its extreme is refined.
const GRID: u32 = 96;

impl Range {
    /// `None` where the linkage does not close over the whole range.
    #[must_use]
    pub fn new(g: &Geometry<f64>, motion: &Motion) -> Option<Range> {
        let at = |theta: f64| Position::new(g, theta);
        let all = |pick: fn(&Position<f64>) -> f64| greatest(motion, |theta| at(theta).map(|p| pick(&p)));
        let minus = |e: Extreme| Extreme { value: -e.value, ..e };
        let slope = |theta: f64| at(theta).map(|p| Velocity::new(&p).da.y);
        let dy_max = greatest(motion, |theta| slope(theta).map(f64::abs))?;
        Some(Range {
            r_max: all(|p| p.r)?,
            r_min: minus(all(|p| -p.r)?),
            y_max: all(|p| p.a.y)?,
            y_min: minus(all(|p| -p.a.y)?),
            mu_min: minus(all(|p| -p.mu())?),
            dy_max: Extreme {
                value: slope(dy_max.at)?,
                ..dy_max
            },
            rise: at(motion.to)?.a.y - at(motion.from)?.a.y,
        })
    }

    /// Level error, in m. [Li2022, 6]
    #[must_use]
    pub fn delta_y(&self) -> f64 {
        self.y_max.value - self.y_min.value
    }

    /// Level error over the reach covered. [Li2022, 6]
    #[must_use]
    pub fn epsilon_y(&self) -> f64 {
        self.delta_y() / (self.r_max.value - self.r_min.value)
    }
}

/// The greatest value: on a grid, then by golden section around the best point.
fn greatest(motion: &Motion, f: impl Fn(f64) -> Option<f64>) -> Option<Extreme> {
    let width = (motion.to - motion.from) / f64::from(GRID);
    let mut best = Extreme {
        value: f(motion.from)?,
        at: motion.from,
    };
    for i in 1..=GRID {
        let at = if i == GRID {
            motion.to
        } else {
            motion.from + f64::from(i) * width
        };
        let value = f(at)?;
        if value > best.value {
            best = Extreme { value, at };
        }
    }
    let (mut low, mut high) = ((best.at - width).max(motion.from), (best.at + width).min(motion.to));
    // Each step keeps 0.618 of the interval: 40 steps reach the square root of
    // the working precision, where a maximum is flat.
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    for _ in 0..40 {
        let (left, right) = (high - GOLDEN * (high - low), low + GOLDEN * (high - low));
        let (at_left, at_right) = (f(left)?, f(right)?);
        let (at, value) = if at_left > at_right {
            (left, at_left)
        } else {
            (right, at_right)
        };
        if value > best.value {
            best = Extreme { value, at };
        }
        if at_left > at_right { high = right } else { low = left }
    }
    Some(best)
}

/// Rise of A over the range as the integral of its slope, in m: the work of the
/// luffing moment for a load of 1 N. By Gauss and Legendre's rule.
#[must_use]
pub fn rise_by_integration(g: &Geometry<f64>, motion: &Motion) -> f64 {
    const POINTS: NonZeroUsize = NonZeroUsize::new(64).expect("not zero");
    GaussLegendre::new(POINTS).integrate(motion.from, motion.to, |theta| {
        Position::new(g, theta).map_or(f64::NAN, |p| Velocity::new(&p).da.y)
    })
}

//! Results of the whole working range: extremes, level error, work.

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
    /// Rise of A over the range by integration of dY/dθ, and by difference, in m.
    pub rise: [f64; 2],
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
        let rise = |theta: f64| at(theta).map(|p| Velocity::new(&p).da.y);
        let dy_max = greatest(motion, |theta| rise(theta).map(f64::abs))?;
        Some(Range {
            r_max: all(|p| p.r)?,
            r_min: minus(all(|p| -p.r)?),
            y_max: all(|p| p.a.y)?,
            y_min: minus(all(|p| -p.a.y)?),
            mu_min: minus(all(|p| -p.mu())?),
            dy_max: Extreme { value: rise(dy_max.at)?, ..dy_max },
            rise: [simpson(motion, rise)?, at(motion.to)?.a.y - at(motion.from)?.a.y],
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
    let mut best = Extreme { value: f(motion.from)?, at: motion.from };
    for i in 1..=GRID {
        let at = if i == GRID { motion.to } else { motion.from + f64::from(i) * width };
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
        let (at, value) = if at_left > at_right { (left, at_left) } else { (right, at_right) };
        if value > best.value {
            best = Extreme { value, at };
        }
        if at_left > at_right { high = right } else { low = left }
    }
    Some(best)
}

/// Integral over the range by Simpson's rule.
fn simpson(motion: &Motion, f: impl Fn(f64) -> Option<f64>) -> Option<f64> {
    const PANELS: u32 = 512;
    let width = (motion.to - motion.from) / f64::from(PANELS);
    let mut sum = f(motion.from)? + f(motion.to)?;
    for i in 1..PANELS {
        sum += if i % 2 == 1 { 4.0 } else { 2.0 } * f(motion.from + f64::from(i) * width)?;
    }
    Some(sum * width / 3.0)
}

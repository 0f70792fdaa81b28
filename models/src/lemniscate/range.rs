//! Results of the whole working range: extremes, level error, work.

use std::f64::consts::TAU;
use std::num::NonZeroUsize;

use gauss_quad::GaussLegendre;
use num_dual::Dual64;

use crate::calc::Calc;
use crate::lemniscate::geometry::{Geometry, Parameters};
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

/// Points at which a quantity is looked at before its extremes are refined.
const GRID: u32 = 96;

impl Range {
    /// `None` where the linkage does not close over the whole range.
    #[must_use]
    pub fn new(parameters: &Parameters<f64>, motion: &Motion) -> Option<Range> {
        let g = Geometry::new(&parameters.map(&mut |_, value| Dual64::from_re(value))).ok()?;
        let at = |theta: Dual64| Position::new(&g, theta);
        let all = |pick: fn(&Position<Dual64>) -> Dual64| greatest(motion, |theta| at(theta).map(|p| pick(&p)));
        let slope = |theta: Dual64| at(theta).map(|p| Velocity::new(&p).da.y);
        let height = |theta: f64| at(Dual64::from_re(theta)).map(|p| p.a.y.re);
        Some(Range {
            r_max: all(|p| p.r)?,
            r_min: all(|p| -p.r)?.turned(),
            y_max: all(|p| p.a.y)?,
            y_min: all(|p| -p.a.y)?.turned(),
            mu_min: all(|p| -p.mu())?.turned(),
            dy_max: greatest_amount(motion, slope)?,
            rise: height(motion.to)? - height(motion.from)?,
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

impl Extreme {
    /// The least value, found as the greatest of its negative.
    fn turned(self) -> Extreme {
        Extreme {
            value: -self.value,
            ..self
        }
    }
}

/// The greatest value of `f` in the working range, of which all turns are like the
/// first. Every peak of a grid is refined to where the derivative, exact from dual
/// numbers, changes its sign: to the last bit, which values alone do not give where
/// a peak is flat. A peak narrower than a hundredth of the range can be missed.
pub fn greatest(motion: &Motion, f: impl Fn(Dual64) -> Option<Dual64>) -> Option<Extreme> {
    let end = motion.to.min(motion.from + TAU);
    let angle = |i: u32| match i {
        GRID => end,
        _ => motion.from + f64::from(i) * ((end - motion.from) / f64::from(GRID)),
    };
    let at = |theta: f64| f(Dual64::new(theta, 1.0));
    // Beside the range's other angles; a zero has no last bit to be found to.
    let nothing = |theta: f64| theta.abs() < f64::EPSILON * (end - motion.from);
    let mut values = [0.0; GRID as usize + 1];
    for (i, value) in (0..=GRID).zip(&mut values) {
        *value = at(angle(i))?.re;
    }
    let value = |i: u32| values[i as usize];
    let mut best = Extreme {
        value: value(0),
        at: motion.from,
    };
    for i in 0..=GRID {
        let (before, after) = (i.saturating_sub(1), (i + 1).min(GRID));
        if value(i) < value(before) || value(i) < value(after) {
            continue;
        }
        let (from, to) = (angle(before), angle(after));
        let (mut low, mut high) = (from, to);
        loop {
            let middle = f64::midpoint(low, high);
            if middle <= low || middle >= high || nothing(low) && nothing(high) {
                break;
            }
            let rises = at(middle)?.eps > 0.0;
            if rises { low = middle } else { high = middle }
        }
        // Without a change of sign the end itself is greatest.
        let refined = if high == to { high } else { low };
        let refined = if low == from { from } else { refined };
        let refined = if nothing(refined) { 0.0 } else { refined };
        for at_this in [angle(i), refined] {
            let value = at(at_this)?.re;
            if value > best.value {
                best = Extreme { value, at: at_this };
            }
        }
    }
    Some(best)
}

/// The value of `f` that is greatest by amount, with its sign.
pub fn greatest_amount(motion: &Motion, f: impl Fn(Dual64) -> Option<Dual64>) -> Option<Extreme> {
    let extreme = greatest(motion, |theta| f(theta).map(Calc::abs))?;
    Some(Extreme {
        value: f(Dual64::from_re(extreme.at))?.re,
        ..extreme
    })
}

/// Rise of A over the range as the integral of its slope, in m: the work of the
/// luffing moment for a load of 1 N. By Gauss and Legendre's rule, on halves where
/// they do not agree with the whole; every whole turn is like the first.
#[must_use]
pub fn rise_by_integration(g: &Geometry<f64>, motion: &Motion) -> f64 {
    let Motion { from, to, .. } = *motion;
    let over = |from: f64, to: f64| {
        let size = g.lengths.x_1 + g.lengths.x_3 + g.lengths.x_4;
        integral(g, [from, to], CONVERGED * size * (to - from), &mut { HALVINGS })
    };
    let turns = ((to - from) / TAU).floor();
    if turns == 0.0 {
        return over(from, to);
    }
    turns * over(from, from + TAU) + over((from + turns * TAU).min(to), to)
}

/// How often intervals are halved at most, and what two halves may differ from the whole by, as a part of the way
/// of the longest bars.
const HALVINGS: u32 = 1000;
const CONVERGED: f64 = 1e-13;

fn integral(g: &Geometry<f64>, [from, to]: [f64; 2], tolerance: f64, halvings: &mut u32) -> f64 {
    const POINTS: NonZeroUsize = NonZeroUsize::new(64).expect("not zero");
    let over = |from: f64, to: f64| {
        GaussLegendre::new(POINTS).integrate(from, to, |theta| {
            Position::new(g, theta).map_or(f64::NAN, |p| Velocity::new(&p).da.y)
        })
    };
    let middle = f64::midpoint(from, to);
    let whole = over(from, to);
    let apart = (over(from, middle) + over(middle, to) - whole).abs();
    // Where the linkage does not close there is nothing to converge.
    if apart <= tolerance || apart.is_nan() || *halvings == 0 {
        return whole;
    }
    *halvings -= 1;
    let [low, high] = [[from, middle], [middle, to]].map(|half| integral(g, half, tolerance, halvings));
    low + high
}

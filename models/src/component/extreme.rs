//! Extremes over the working range.

use std::f64::consts::TAU;

use num_dual::Dual64;

use crate::kernel::calc::Calc;
use crate::parts::motion::Motion;

/// A value and the value of the coordinate where it occurs.
#[derive(Clone, Copy, Debug)]
pub struct Extreme {
    pub value: f64,
    pub at: f64,
}

impl Extreme {
    /// The least value, found as the greatest of its negative.
    #[must_use]
    pub fn turned(self) -> Extreme {
        Extreme {
            value: -self.value,
            ..self
        }
    }
}

/// Points of a drawn curve.
const CURVE: u32 = 240;

/// Places of a curve over the working range.
pub fn fine(motion: &Motion) -> impl Iterator<Item = f64> + use<> {
    between(motion.from, motion.to)
}

/// Places of a curve over any range.
pub fn between(from: f64, to: f64) -> impl Iterator<Item = f64> {
    (0..=CURVE).map(move |i| match i {
        CURVE => to,
        _ => from + (to - from) * f64::from(i) / f64::from(CURVE),
    })
}

/// Points at which a quantity is looked at before its extremes are refined.
const GRID: u32 = 96;

/// The greatest value of `f` in the working range, of which all turns are like the
/// first. Every peak of a grid is refined to where the derivative, exact from dual
/// numbers, changes its sign: to the last bit, which values alone do not give where
/// a peak is flat. A peak narrower than a hundredth of the range can be missed.
pub fn greatest(motion: &Motion, f: &mut dyn FnMut(Dual64) -> Option<Dual64>) -> Option<Extreme> {
    let end = motion.to.min(motion.from + TAU);
    let angle = |i: u32| match i {
        GRID => end,
        _ => motion.from + f64::from(i) * ((end - motion.from) / f64::from(GRID)),
    };
    let mut at = |theta: f64| f(Dual64::new(theta, 1.0));
    // Beside the range's other places; a zero has no last bit to be found to.
    let nothing = |place: f64| place.abs() < f64::EPSILON * (end - motion.from);
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

/// The greatest and the least value of `f`.
pub fn ends(motion: &Motion, f: &mut dyn FnMut(Dual64) -> Option<Dual64>) -> Option<[Extreme; 2]> {
    let least = greatest(motion, &mut |at| f(at).map(|value| -value))?;
    Some([greatest(motion, f)?, least.turned()])
}

/// The value of `f` that is greatest by amount, with its sign.
pub fn greatest_amount(motion: &Motion, f: &mut dyn FnMut(Dual64) -> Option<Dual64>) -> Option<Extreme> {
    let extreme = greatest(motion, &mut |theta| f(theta).map(Calc::abs))?;
    Some(Extreme {
        value: f(Dual64::from_re(extreme.at))?.re,
        ..extreme
    })
}

/// As [`greatest`] of what has no derivative: on the places of a curve, then by golden section beside the best of them.
pub fn greatest_value(motion: &Motion, f: &mut dyn FnMut(f64) -> Option<f64>) -> Option<Extreme> {
    const STEPS: u32 = 60;
    let places: Vec<f64> = fine(motion).collect();
    let values: Vec<f64> = places.iter().map(|&place| f(place)).collect::<Option<_>>()?;
    let best = (0..places.len()).max_by(|&a, &b| values[a].total_cmp(&values[b]))?;
    let (mut low, mut high) = (places[best.saturating_sub(1)], places[(best + 1).min(places.len() - 1)]);
    let golden = (5.0_f64.sqrt() - 1.0) / 2.0;
    for _ in 0..STEPS {
        let (a, b) = (high - golden * (high - low), low + golden * (high - low));
        if f(a)? > f(b)? {
            high = b;
        } else {
            low = a;
        }
    }
    // At a corner straight ahead the search stops one rounding beside it, and so may a place of the grid.
    let straight = |at: f64| if at.abs() < 1e-9 { 0.0 } else { at };
    let at = straight(f64::midpoint(low, high));
    let value = f(at)?;
    let on_grid = Extreme {
        value: values[best],
        at: straight(places[best]),
    };
    Some(if value > on_grid.value {
        Extreme { value, at }
    } else {
        on_grid
    })
}

//! Extremes over the working range.

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
pub(super) const GRID: usize = 96;

/// A quantity with its derivative at these points.
pub type Looked = [Dual64; GRID + 1];

/// The points; of a range of several turns those of the first, as all turns are like it.
pub fn grid(motion: &Motion) -> [f64; GRID + 1] {
    let end = motion.to.min(motion.from + motion.period);
    let step = (end - motion.from) / GRID as f64;
    std::array::from_fn(|i| match i {
        GRID => end,
        _ => motion.from + i as f64 * step,
    })
}

/// The greatest value of `f` in the working range: see [`peak`].
pub fn greatest(motion: &Motion, f: &mut dyn FnMut(Dual64) -> Option<Dual64>) -> Option<Extreme> {
    let mut looked = [Dual64::from_re(0.0); GRID + 1];
    for (value, at) in looked.iter_mut().zip(grid(motion)) {
        *value = f(Dual64::new(at, 1.0))?;
    }
    peak(motion, &looked, f)
}

/// The greatest value of `f`, which has been looked at. Every peak of the grid is refined to where the derivative, exact
/// from dual numbers, changes its sign: to the last bit, which values alone do not give where a peak is flat. A peak
/// narrower than a hundredth of the range can be missed.
pub fn peak(motion: &Motion, looked: &Looked, f: &mut dyn FnMut(Dual64) -> Option<Dual64>) -> Option<Extreme> {
    let places = grid(motion);
    let range = places[GRID] - places[0];
    let step = range / GRID as f64;
    // Beside the range's other places; a zero has no last bit to be found to.
    let nothing = |place: f64| place.abs() < f64::EPSILON * range;
    let mut best = Extreme {
        value: looked[0].re,
        at: motion.from,
    };
    for (i, here) in looked.iter().enumerate() {
        let (before, after) = (i.saturating_sub(1), (i + 1).min(GRID));
        if here.re < looked[before].re || here.re < looked[after].re {
            continue;
        }
        let side = if here.eps > 0.0 { [i, after] } else { [before, i] };
        let slopes = side.map(|end| looked[end].eps);
        if here.re > best.value {
            best = Extreme {
                value: here.re,
                at: places[i],
            };
        }
        // Less is to be gained than the value is known to: it is constant.
        let constant = (slopes.iter()).all(|slope| slope.abs() * step <= f64::EPSILON * here.re.abs());
        let [low, high] = match side {
            // Without a change of sign the end itself is greatest.
            [only, end] if only == end || constant => continue,
            _ if slopes[0] > 0.0 && slopes[1] <= 0.0 => turn(side.map(|end| places[end]), slopes, nothing, f)?,
            // A jump or a corner, of which slopes beside it tell nothing.
            _ => turn([places[before], places[after]], [f64::NAN; 2], nothing, f)?,
        };
        let refined = if high == places[after] { high } else { low };
        let refined = if low == places[before] { low } else { refined };
        let refined = if nothing(refined) { 0.0 } else { refined };
        let value = f(Dual64::new(refined, 1.0))?.re;
        if value > best.value {
            best = Extreme { value, at: refined };
        }
    }
    Some(best)
}

/// Two neighbouring numbers between which `f` rises no more, from two places with their slopes: by the method of Oliveira
/// and Takahashi (ITP, 2020), a secant's step kept so near to the middle that it never takes more than one step beyond
/// bisection; by bisection where slopes are not known.
pub(super) fn turn(
    [mut low, mut high]: [f64; 2],
    [mut rising, mut falling]: [f64; 2],
    nothing: impl Fn(f64) -> bool,
    f: &mut dyn FnMut(Dual64) -> Option<Dual64>,
) -> Option<[f64; 2]> {
    let mut allowed = 2.0 * (high - low);
    let part = 0.2 / (high - low);
    loop {
        let (middle, width) = (f64::midpoint(low, high), high - low);
        if middle <= low || middle >= high || nothing(low) && nothing(high) {
            return Some([low, high]);
        }
        let secant = low + width * (rising / (rising - falling));
        let inwards = (middle - secant).signum();
        let (moved, off) = (part * width * width, 0.5 * (allowed - width).max(0.0));
        let guess = match (middle - secant).abs() {
            far if far.is_nan() || far <= moved => middle,
            far if far - moved <= off => secant + inwards * moved,
            _ => middle - inwards * off,
        };
        let place = guess.clamp(low.next_up(), high.next_down());
        allowed *= 0.5;
        let slope = f(Dual64::new(place, 1.0))?.eps;
        if slope > 0.0 {
            (low, rising) = (place, slope);
        } else {
            (high, falling) = (place, slope);
        }
    }
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

/// Where a value is greatest between two places, by golden section.
fn golden([mut low, mut high]: [f64; 2], f: &mut dyn FnMut(f64) -> Option<f64>) -> Option<f64> {
    const STEPS: u32 = 60;
    let golden = (5.0_f64.sqrt() - 1.0) / 2.0;
    for _ in 0..STEPS {
        let (a, b) = (high - golden * (high - low), low + golden * (high - low));
        if f(a)? > f(b)? {
            high = b;
        } else {
            low = a;
        }
    }
    Some(f64::midpoint(low, high))
}

/// As [`greatest`] of what has no derivative: on the places of a curve, then by golden section beside the best of them.
pub fn greatest_value(motion: &Motion, f: &mut dyn FnMut(f64) -> Option<f64>) -> Option<Extreme> {
    let places: Vec<f64> = fine(motion).collect();
    let values: Vec<f64> = places.iter().map(|&place| f(place)).collect::<Option<_>>()?;
    let best = (0..places.len()).max_by(|&a, &b| values[a].total_cmp(&values[b]))?;
    let ends = [places[best.saturating_sub(1)], places[(best + 1).min(places.len() - 1)]];
    let found = golden(ends, f)?;
    // At a corner straight ahead the search stops one rounding beside it, and so may a place of the grid.
    let straight = |at: f64| if at.abs() < 1e-9 { 0.0 } else { at };
    let at = straight(found);
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

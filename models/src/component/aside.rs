//! A second coordinate, besides that of tables and curves: an input over whose range a scene's results are judged too.

use num_dual::Dual64;

use crate::component::extreme::{Extreme, GRID, Looked, golden, peak, turn};
use crate::component::stages::{Slot, Source};
use crate::component::standing::Standing;
use crate::kernel::symbol::Symbol;
use crate::parts::motion::Motion;

/// The input and its range, in SI.
#[derive(Clone, Copy, Debug)]
pub struct Aside {
    pub symbol: &'static Symbol,
    pub range: Motion,
}

/// An extreme over the coordinate, and over the second one, of which its own value is named where the result follows from it.
#[derive(Clone, Copy, Debug)]
pub struct Peak {
    pub extreme: Extreme,
    pub aside: Option<f64>,
}

/// The input in a model, with the places at which results are looked at: first where it stands.
pub(super) struct Beside {
    pub source: Source,
    pub places: Vec<f64>,
    ends: [f64; 2],
}

/// What a value changes by in one step at least where it has a corner, over the value.
const RIDGE: f64 = 1e-6;

/// Where it is looked at which way a ridge rises, as a part of the step to both sides.
const NEAR: f64 = 1e-3;

/// Parts of the range of the second coordinate between two places.
const PARTS: u32 = 24;

impl Beside {
    /// `None` of a model without the input.
    pub fn new(model: &Standing, aside: &Aside) -> Option<Beside> {
        let known = model.part().sources();
        let (source, _) = known.into_iter().find(|(_, (symbol, _))| *symbol == aside.symbol)?;
        let all = (0..=PARTS).map(|i| aside.range.at(f64::from(i) / f64::from(PARTS)));
        Some(Beside {
            source,
            places: std::iter::once(model.part().take(source)).chain(all).collect(),
            ends: [aside.range.from, aside.range.to],
        })
    }

    pub fn moves(&self, slot: &Slot) -> bool {
        slot.sources & (1 << self.source.group) != 0
    }

    /// The greatest value of `f` over the coordinate's range and this one's, from the best of the places looked at: along one
    /// of the two after the other, each step to where the exact derivative changes its sign, until nothing is gained, and along a
    /// ridge to its top. A result that is the same all over the range is that of the first place.
    pub fn greatest(&self, motion: &Motion, looked: &[Looked], f: &mut Over<'_>) -> Option<Peak> {
        let best = |looked: &Looked| looked.iter().fold(f64::NEG_INFINITY, |most, value| most.max(value.re));
        let each: Vec<f64> = looked.iter().map(best).collect();
        let first = (1..each.len()).fold(0, |most, i| if above(each[i], each[most]) { i } else { most });
        let start = peak(motion, &looked[first], &mut |at| {
            f(at, Dual64::from_re(self.places[first]))
        })?;
        let (mut own, mut aside, mut value) = (start.at, self.places[first], start.value);
        let step = [
            (motion.to.min(motion.from + motion.period) - motion.from) / GRID as f64,
            (self.ends[1] - self.ends[0]) / f64::from(PARTS),
        ];
        while value.is_finite() {
            let before = value;
            if let Some((at, found)) = climbed(aside, self.ends, step[1], &mut |at| f(Dual64::from_re(own), at))
                && above(found, value)
            {
                (aside, value) = (at, found);
            }
            if let Some((at, found)) = climbed(own, [motion.from, motion.to], step[0], &mut |at| {
                f(at, Dual64::from_re(aside))
            }) && above(found, value)
            {
                (own, value) = (at, found);
            }
            if !above(value, before) {
                break;
            }
        }
        // A ridge, of which slopes along either coordinate alone say nothing: to its top.
        let inside = own > motion.from && own < motion.to && value.is_finite();
        let steep = f(Dual64::new(own, 1.0), Dual64::from_re(aside))?.eps.abs();
        if inside && steep * step[0] > RIDGE * value.abs() {
            let start = own;
            let mut over = |at: f64| {
                settled(start, [motion.from, motion.to], step[0], &mut |own| {
                    f(own, Dual64::from_re(at))
                })
            };
            let sides = [(aside - step[1]).max(self.ends[0]), (aside + step[1]).min(self.ends[1])];
            let mut upward = None;
            for side in sides.into_iter().filter(|side| *side != aside) {
                if above(over(aside + NEAR * (side - aside))?.1, value) {
                    upward = Some(side);
                }
            }
            if let Some(side) = upward {
                let between = [aside.min(side), aside.max(side)];
                let top = golden(between, &mut |at| over(at).map(|(_, value)| value))?;
                for at in [top, side] {
                    let (place, found) = over(at)?;
                    if above(found, value) {
                        (own, aside, value) = (place, at, found);
                    }
                }
            }
        }
        Some(Peak {
            extreme: Extreme { value, at: own },
            aside: Some(aside),
        })
    }
}

/// A result by the coordinate and by the second one.
pub(super) type Over<'a> = dyn FnMut(Dual64, Dual64) -> Option<Dual64> + 'a;

/// Whether a value is more than another by what rounding does not make of one.
fn above(value: f64, other: f64) -> bool {
    value > other && (!other.is_finite() || value - other > 8.0 * f64::EPSILON * other.abs())
}

/// From a place upward, step by step, until nothing is gained: where that is, and the value there.
fn settled(from: f64, ends: [f64; 2], step: f64, f: &mut dyn FnMut(Dual64) -> Option<Dual64>) -> Option<(f64, f64)> {
    let (mut at, mut value) = (from, f(Dual64::from_re(from))?.re);
    while let Some((place, found)) = climbed(at, ends, step, f)
        && above(found, value)
    {
        (at, value) = (place, found);
    }
    Some((at, value))
}

/// Where `f` rises no more within a step to both sides of a place, and its value there.
fn climbed(from: f64, ends: [f64; 2], step: f64, f: &mut dyn FnMut(Dual64) -> Option<Dual64>) -> Option<(f64, f64)> {
    let sides = [(from - step).max(ends[0]), (from + step).min(ends[1])];
    let mut slope = |at: f64| Some(f(Dual64::new(at, 1.0))?.eps);
    let slopes = [slope(sides[0])?, slope(sides[1])?];
    let at = match slopes.map(|slope| slope > 0.0) {
        [true, false] => turn(sides, slopes, |_| false, f)?[0],
        [true, true] => sides[1],
        [false, false] => sides[0],
        [false, true] => return None,
    };
    Some((at, f(Dual64::from_re(at))?.re))
}

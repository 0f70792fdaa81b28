//! A second coordinate, besides that of tables and curves: an input over whose range a scene's results are judged too.

use num_dual::Dual64;

use crate::component::extreme::{Extreme, GRID, Looked, peak};
use crate::component::ridge::{Field, Over, above, climbed};
use crate::component::stages::{Slot, Source};
use crate::component::standing::Standing;
use crate::kernel::symbol::Symbol;
use crate::parts::motion::Motion;

/// The input and its range, in SI.
#[derive(Clone, Copy, Debug)]
pub struct Aside {
    pub symbol: &'static Symbol,
    pub range: [f64; 2],
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

/// Parts of the range of the second coordinate between two places.
const PARTS: u32 = 16;

impl Beside {
    /// `None` of a model without the input.
    pub fn new(model: &Standing, aside: &Aside) -> Option<Beside> {
        let known = model.part().sources();
        let (source, _) = known.into_iter().find(|(_, (symbol, _))| *symbol == aside.symbol)?;
        let here = model.part().take(source);
        let [from, to] = aside.range;
        let part = |i: u32| f64::from(i) / f64::from(PARTS);
        let all = (0..=PARTS).map(|i| from * (1.0 - part(i)) + to * part(i));
        let others = all.filter(|place| *place != here);
        Some(Beside {
            source,
            places: std::iter::once(here).chain(others).collect(),
            ends: aside.range,
        })
    }

    pub fn moves(&self, slot: &Slot) -> bool {
        slot.sources & (1 << self.source.group) != 0
    }

    /// Which of the places has the best of a row of values.
    pub fn best<'a>(rows: impl Iterator<Item = &'a Looked>, of: impl Fn(f64) -> f64) -> usize {
        let best = |row: &Looked| row.iter().fold(f64::NEG_INFINITY, |most, value| most.max(of(value.re)));
        let each: Vec<f64> = rows.map(best).collect();
        (1..each.len()).fold(0, |most, i| if above(each[i], each[most]) { i } else { most })
    }

    /// The greatest value of `f` over the coordinate's range and this one's, from the best row of the places looked at: along one
    /// of the two after the other, each step to where the exact derivative changes its sign, until nothing is gained, and along a
    /// ridge to its top. A result that is the same all over the range is that of the first place.
    pub fn greatest(&self, motion: &Motion, (first, looked): (usize, &Looked), f: &mut Over<'_>) -> Option<Peak> {
        let start = peak(motion, looked, &mut |at| f(at, Dual64::from_re(self.places[first])))?;
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
            let field = Field {
                ends: [[motion.from, motion.to], self.ends],
                steps: step,
            };
            let top = field.crest(own, aside, f).and_then(|crest| field.top(crest, f));
            if let Some(top) = top.filter(|top| above(top.value, value)) {
                (own, aside, value) = (top.own, top.aside, top.value);
            }
        }
        Some(Peak {
            extreme: Extreme { value, at: own },
            aside: Some(aside),
        })
    }
}

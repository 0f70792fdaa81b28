//! Ridges of a result over two coordinates: places where it has a corner along the first one, of which slopes along either
//! coordinate alone say nothing.

use num_dual::Dual64;

use crate::component::extreme::turn;

/// Where it is looked at whether a ridge rises, as a part of the step.
const NEAR: f64 = 1e-3;

/// A result by the coordinate and by the second one.
pub(super) type Over<'a> = dyn FnMut(Dual64, Dual64) -> Option<Dual64> + 'a;

/// Whether a value is more than another by what rounding does not make of one.
pub(super) fn above(value: f64, other: f64) -> bool {
    value > other && (!other.is_finite() || value - other > 8.0 * f64::EPSILON * other.abs())
}

/// Two neighbouring numbers between which `f` rises no more within a step to both sides of a place, or that side to which it
/// rises, twice.
fn summit(from: f64, ends: [f64; 2], step: f64, f: &mut dyn FnMut(Dual64) -> Option<Dual64>) -> Option<[f64; 2]> {
    let sides = [(from - step).max(ends[0]), (from + step).min(ends[1])];
    let found = [f(Dual64::new(sides[0], 1.0))?, f(Dual64::new(sides[1], 1.0))?];
    match found.map(|found| found.eps > 0.0) {
        [true, false] => peaked(sides, found, f),
        [true, true] => Some([sides[1]; 2]),
        [false, false] => Some([sides[0]; 2]),
        [false, true] => None,
    }
}

/// Two neighbouring numbers between which `f` rises no more, from two places with what it is there.
fn peaked(sides: [f64; 2], found: [Dual64; 2], f: &mut dyn FnMut(Dual64) -> Option<Dual64>) -> Option<[f64; 2]> {
    let [low, high] = cornered(sides, found, f)?;
    turn([low.0, high.0], [low.1.eps, high.1.eps], |_| false, f)
}

/// Places nearer to a corner on its two sides, each with the value there: both are brought to where the tangents of the two
/// meet, from which the corner is as far as their distance squared, as long as they do not pass it.
fn cornered(
    sides: [f64; 2],
    found: [Dual64; 2],
    f: &mut dyn FnMut(Dual64) -> Option<Dual64>,
) -> Option<[(f64, Dual64); 2]> {
    /// How far beside the corner, over the square of the distance.
    const BESIDE: f64 = 0.1;
    /// How far at least, over the place itself.
    const LEAST: f64 = 16.0 * f64::EPSILON;
    let whole = sides[1] - sides[0];
    let [mut low, mut high] = [(sides[0], found[0]), (sides[1], found[1])];
    loop {
        let wide = high.0 - low.0;
        let meet = low.0 + (high.1.re - low.1.re - high.1.eps * wide) / (low.1.eps - high.1.eps);
        let beside = (BESIDE * wide * (wide / whole)).max(LEAST * meet.abs());
        let ends = [meet - beside, meet + beside];
        // Not near a corner, or as near as can be.
        if !(ends[0] > low.0 && ends[1] < high.0 && ends[0] < meet && meet < ends[1]) {
            return Some([low, high]);
        }
        let mut passed = false;
        for at in ends {
            let here = (at, f(Dual64::new(at, 1.0))?);
            let rises = here.1.eps > 0.0;
            passed |= rises == (at == ends[1]);
            if rises && here.0 > low.0 {
                low = here;
            } else if !rises && here.0 < high.0 {
                high = here;
            }
        }
        if passed {
            return Some([low, high]);
        }
    }
}

/// Where `f` rises no more within a step to both sides of a place, and its value there.
pub(super) fn climbed(
    from: f64,
    ends: [f64; 2],
    step: f64,
    f: &mut dyn FnMut(Dual64) -> Option<Dual64>,
) -> Option<(f64, f64)> {
    let [at, _] = summit(from, ends, step, f)?;
    Some((at, f(Dual64::from_re(at))?.re))
}

/// A place of the ridge at one of the second coordinate, the value there, and how that changes along the ridge with the second
/// coordinate.
#[derive(Clone, Copy)]
pub(super) struct Crest {
    pub own: f64,
    pub aside: f64,
    pub value: f64,
    slope: f64,
}

/// Ranges of both coordinates, and steps in which they are gone through.
pub(super) struct Field {
    pub ends: [[f64; 2]; 2],
    pub steps: [f64; 2],
}

impl Field {
    /// The ridge at a place of the second coordinate, from a place of the first. Where it is between two branches with slopes
    /// `a` and `b`, that of their intersection is `(a_1 b_2 − a_2 b_1)/(a_1 − b_1)`, a mean of both.
    pub fn crest(&self, from: f64, aside: f64, f: &mut Over<'_>) -> Option<Crest> {
        let (ends, step) = (self.ends[0], self.steps[0]);
        let mut at = from;
        let [low, high] = loop {
            let found = summit(at, ends, step, &mut |own| f(own, Dual64::from_re(aside)))?;
            if found[0] != found[1] || ends.contains(&found[0]) {
                break found;
            }
            at = found[0];
        };
        let mut side = |own: f64| {
            let along = f(Dual64::new(own, 1.0), Dual64::from_re(aside))?;
            Some((along, f(Dual64::from_re(own), Dual64::new(aside, 1.0))?.eps))
        };
        let [(left, a), (right, b)] = [side(low)?, side(high)?];
        let falls = left.eps - right.eps;
        let between = low != high && falls > 0.0;
        let slope = if between {
            (left.eps * b - right.eps * a) / falls
        } else {
            a
        };
        let (own, value) = if right.re > left.re {
            (high, right.re)
        } else {
            (low, left.re)
        };
        Some(Crest {
            own,
            aside,
            value,
            slope,
        })
    }

    /// From a place of the ridge to its top: step by step where it rises, then to where its slope changes its sign. From the tip of
    /// a cone, whose slopes tell nothing, it rises to neither side.
    pub fn top(&self, from: Crest, f: &mut Over<'_>) -> Option<Crest> {
        let (mut best, mut here) = (from, from);
        loop {
            let step = self.steps[1].copysign(here.slope);
            let next = (here.aside + step).max(self.ends[1][0]).min(self.ends[1][1]);
            if here.slope == 0.0 || next == here.aside {
                return Some(best);
            }
            let near = self.crest(here.own, here.aside + NEAR * (next - here.aside), f)?;
            if !above(near.value, best.value) {
                return Some(best);
            }
            let there = self.crest(near.own, next, f)?;
            let passed = there.slope * here.slope <= 0.0;
            let found = if passed { self.between(here, there, f)? } else { there };
            if !above(found.value, best.value) {
                return Some(best);
            }
            best = found;
            if passed {
                return Some(best);
            }
            here = there;
        }
    }

    /// Where the ridge is highest between two of its places, of which it rises from the first and to the second.
    fn between(&self, here: Crest, there: Crest, f: &mut Over<'_>) -> Option<Crest> {
        let [low, high] = if here.aside < there.aside {
            [here, there]
        } else {
            [there, here]
        };
        let mut own = here.own;
        let mut slope = |at: Dual64| {
            let found = self.crest(own, at.re, f)?;
            own = found.own;
            Some(Dual64::new(found.value, found.slope))
        };
        let found = [low, high].map(|crest| Dual64::new(crest.value, crest.slope));
        let [top, _] = peaked([low.aside, high.aside], found, &mut slope)?;
        let from = own;
        self.crest(from, top, f)
    }
}

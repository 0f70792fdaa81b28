//! Results of the whole working range in a scene.
//!
//! Where it occurs is found with dual numbers by the coordinate. Its derivative by anything else is taken there: at an
//! extreme inside the range the place's own change has no effect, and an end of the range stays.

use std::num::NonZeroUsize;

use gauss_quad::GaussLegendre;
use num_dual::Dual64;

use crate::component::extreme::greatest;
use crate::component::part::{Face, Part};
use crate::component::stages::{Found, Slot, Source, absent};
use crate::component::whole::{How, Whole};
use crate::kernel::calc::Calc;
use crate::kernel::variable::Quantity;
use crate::parts::motion::Motion;

/// A result of the range in a scene.
#[derive(Clone, Copy, Debug)]
pub struct Spread {
    of: Slot,
    per: Option<Slot>,
    how: How,
    with: Option<Source>,
    coordinate: Source,
    /// Groups from which it follows.
    pub sources: u64,
}

/// Where it occurs, and what it comes to.
#[derive(Clone, Copy, Debug)]
pub struct Spot {
    /// Of an extreme its place, of a zero its place and the slope there.
    at: [f64; 4],
    pub value: f64,
}

impl Spread {
    /// Of a component by its sources and results, and by which of the first are its coordinate and that one's rate; `None`
    /// where the scene does not model what it is about.
    #[must_use]
    pub fn new(
        whole: &Whole,
        sources: &[(Source, Quantity)],
        results: &[(Slot, Quantity)],
        [coordinate, rate]: [Source; 2],
    ) -> Option<Spread> {
        let slot = |wanted| {
            let found = results.iter().find(|(_, (symbol, _))| *symbol == wanted);
            found.map(|(slot, _)| *slot)
        };
        let of = slot(whole.of)?;
        let per = match whole.how {
            How::Ratio(per) | How::Share(per) | How::Mean(per) | How::RootMean(per) => Some(slot(per)?),
            _ => None,
        };
        let with = match whole.how {
            How::Vanishes(Some((wanted, _))) => {
                let found = sources.iter().find(|(_, (symbol, _))| *symbol == wanted);
                found.map(|(source, _)| *source)
            }
            _ => None,
        };
        let without = [Some(coordinate), Some(rate), with].into_iter().flatten();
        let own = without.fold(0, |mask, source| mask | 1 << source.group);
        Some(Spread {
            of,
            per,
            how: whole.how,
            with,
            coordinate,
            sources: (of.sources | per.map_or(0, |per| per.sources)) & !own,
        })
    }

    /// What it is, of which result, and over which other one's swing.
    #[must_use]
    pub fn terms(&self) -> (How, Slot, Option<Slot>) {
        (self.how, self.of, self.per)
    }

    /// Whether results of the same kind are found from a result's slot.
    #[must_use]
    pub fn is_of(&self, slot: &Slot) -> bool {
        self.of == *slot || self.per == Some(*slot)
    }

    /// Whether it is an integral over the range, or follows from some.
    #[must_use]
    pub fn is_integral(&self) -> bool {
        matches!(self.how, How::Integral | How::Mean(_) | How::RootMean(_))
    }

    /// Whether both are integrals of results of the same stage.
    #[must_use]
    pub fn is_beside(&self, other: &Spread) -> bool {
        self.is_integral() && other.is_integral() && self.of.stage == other.of.stage
    }

    /// What is summed up at the place where the component stands: with its weight, and the weight.
    fn integrands<C: Calc>(&self, face: &mut (impl Face<C> + ?Sized)) -> Found<[C; 2]> {
        let mut row = |slot: &Slot| {
            let mut value = C::constant(0.0);
            face.result(slot, &mut value).map(|()| value)
        };
        let Some(per) = &self.per else {
            return Ok([row(&self.of)?, C::constant(0.0)]);
        };
        let (per, of) = (row(per)?, row(&self.of)?);
        let root = matches!(self.how, How::RootMean(_));
        Ok([if root { of.square() } else { of } * per, per])
    }

    /// What follows from the sums.
    fn of_sums<C: Calc>(&self, [whole, per]: [C; 2]) -> C {
        match self.how {
            How::RootMean(_) => (whole / per).sqrt(),
            How::Mean(_) => whole / per,
            _ => whole,
        }
    }

    /// Where integrals are taken, and what they come to; all together.
    ///
    /// # Errors
    /// A configuration that does not exist.
    pub fn find_integrals(all: &[&Spread], part: &dyn Part, motion: &Motion) -> Found<Vec<Spot>> {
        let whole = Spot {
            at: [motion.from, motion.to, 0.0, 0.0],
            value: 0.0,
        };
        let each: Vec<(&Spread, &Spot)> = all.iter().map(|spread| (*spread, &whole)).collect();
        let values = integrated(&each, &mut *part.duplicate())?;
        Ok(values.into_iter().map(|value| Spot { value, ..whole }).collect())
    }

    /// # Errors
    /// A configuration that does not exist.
    pub fn find(&self, part: &dyn Part, motion: &Motion) -> Found<Spot> {
        let mut dual = part.dual(false, &mut |_, _| 0.0).0;
        if let (Some(source), How::Vanishes(Some((_, value)))) = (self.with, self.how) {
            dual.put(source, Dual64::from_re(value));
        }
        let mut fault = None;
        let mut row = |slot: &Slot, at: Dual64| {
            dual.put(self.coordinate, at);
            let mut value = Dual64::from_re(0.0);
            let found = dual.result(slot, &mut value);
            found.map_err(|found| fault = Some(found)).ok().map(|()| value)
        };
        let mut at = [0.0; 4];
        let found = (|| {
            let mut extreme = |slot: &Slot, sign: f64| {
                let found = greatest(motion, &mut |at| row(slot, at).map(|value| value * sign))?;
                Some(found.at)
            };
            match self.how {
                How::Greatest => at[0] = extreme(&self.of, 1.0)?,
                How::Least => at[0] = extreme(&self.of, -1.0)?,
                How::Swing => at[..2].copy_from_slice(&[extreme(&self.of, 1.0)?, extreme(&self.of, -1.0)?]),
                How::Ratio(_) => {
                    let per = self.per.as_ref()?;
                    at = [
                        extreme(&self.of, 1.0)?,
                        extreme(&self.of, -1.0)?,
                        extreme(per, 1.0)?,
                        extreme(per, -1.0)?,
                    ];
                }
                How::Share(_) => {
                    let mut farthest = |slot: &Slot| {
                        let found = greatest(motion, &mut |at| row(slot, at).map(|value| value.abs()))?;
                        Some(found.at)
                    };
                    at[..2].copy_from_slice(&[farthest(&self.of)?, farthest(self.per.as_ref()?)?]);
                }
                How::Integral | How::Mean(_) | How::RootMean(_) => at[..2].copy_from_slice(&[motion.from, motion.to]),
                How::Vanishes(_) => at[..2].copy_from_slice(&vanishes(motion.from, |at| row(&self.of, at))),
            }
            Some(())
        })();
        match found {
            Some(()) => {
                let mut plain = part.duplicate();
                let mut spot = Spot { at, value: 0.0 };
                spot.value = self.value(&mut *plain, &spot)?;
                Ok(spot)
            }
            None => Err(fault.unwrap_or_else(absent)),
        }
    }

    /// What it comes to over any scalar, with the places as they were found.
    ///
    /// # Errors
    /// A configuration that does not exist.
    pub fn value<C: Calc>(&self, face: &mut (impl Face<C> + ?Sized), spot: &Spot) -> Found<C> {
        if self.is_integral() {
            return Ok(integrated(&[(self, spot)], face)?.remove(0));
        }
        let before = face.take(self.coordinate);
        let kept = self.with.map(|source| (source, face.take(source)));
        if let (Some(source), How::Vanishes(Some((_, value)))) = (self.with, self.how) {
            face.put(source, C::constant(value));
        }
        let mut row = |slot: &Slot, at: f64| {
            let mut value = C::constant(0.0);
            face.put(self.coordinate, C::constant(at));
            face.result(slot, &mut value).map(|()| value)
        };
        let found = (|| {
            let [a, b, c, d] = spot.at;
            Ok(match (self.how, &self.per) {
                (How::Swing, _) => row(&self.of, a)? - row(&self.of, b)?,
                (How::Ratio(_), Some(per)) => (row(&self.of, a)? - row(&self.of, b)?) / (row(per, c)? - row(per, d)?),
                (How::Share(_), Some(per)) => match [row(&self.of, a)?.abs(), row(per, b)?.abs()] {
                    // Nothing of nothing.
                    [part, whole] if part.value() == 0.0 && whole.value() == 0.0 => part,
                    [part, whole] => part / whole,
                },
                // A step of Newton's method carries the derivatives.
                (How::Vanishes(_), _) if a.is_finite() => C::constant(a) - row(&self.of, a)? / C::constant(b),
                (How::Vanishes(_), _) => C::constant(a),
                _ => row(&self.of, a)?,
            })
        })();
        face.put(self.coordinate, before);
        if let Some((source, value)) = kept {
            face.put(source, value);
        }
        found
    }
}

/// What integrals over the range come to over any scalar; all are found together, and what they follow from once for each
/// place.
///
/// # Errors
/// A configuration that does not exist.
pub fn integrated<C: Calc>(all: &[(&Spread, &Spot)], face: &mut (impl Face<C> + ?Sized)) -> Found<Vec<C>> {
    let Some((Spread { coordinate, .. }, Spot { at: [from, to, ..], .. })) = all.first() else {
        return Ok(Vec::new());
    };
    let before = face.take(*coordinate);
    let mut sums = vec![[C::constant(0.0); 2]; all.len()];
    let found = nodes(*from, *to).try_for_each(|(at, weight)| {
        face.put(*coordinate, C::constant(at));
        for (sums, (spread, _)) in sums.iter_mut().zip(all) {
            for (sum, value) in sums.iter_mut().zip(spread.integrands(face)?) {
                *sum += value * C::constant(weight);
            }
        }
        Ok(())
    });
    face.put(*coordinate, before);
    found.map(|()| {
        all.iter()
            .zip(sums)
            .map(|((spread, _), sums)| spread.of_sums(sums))
            .collect()
    })
}

/// Places between two of them, and their weights, of Gauss's rule in pieces.
fn nodes(from: f64, to: f64) -> impl Iterator<Item = (f64, f64)> {
    const POINTS: NonZeroUsize = NonZeroUsize::new(8).expect("not zero");
    const PIECES: u32 = 24;
    let rule = GaussLegendre::new(POINTS);
    let half = 0.5 * (to - from) / f64::from(PIECES);
    (0..PIECES).flat_map(move |piece| {
        let middle = from + half * f64::from(2 * piece + 1);
        let of = |&(node, weight): &(f64, f64)| (middle + half * node, weight * half);
        rule.iter().map(of).collect::<Vec<_>>()
    })
}

/// Where `f` falls to zero in half a turn from `from` on, and its slope there; the start itself, which no derivative
/// moves, where it is not above zero there; infinite where it does not fall.
fn vanishes(from: f64, mut f: impl FnMut(Dual64) -> Option<Dual64>) -> [f64; 2] {
    const GRID: u32 = 360;
    const STEP: f64 = std::f64::consts::PI / GRID as f64;
    let mut at = |place: f64| f(Dual64::new(place, 1.0));
    let mut low = from;
    for i in 0..=GRID {
        let place = from + f64::from(i) * STEP;
        match at(place) {
            None => break,
            Some(value) if value.re > 0.0 => low = place,
            Some(_) if i == 0 => return [from, f64::INFINITY],
            Some(_) => {
                let mut high = place;
                loop {
                    let middle = f64::midpoint(low, high);
                    let Some(there) = at(middle) else { break };
                    if middle <= low || middle >= high {
                        return [middle, there.eps];
                    }
                    if there.re > 0.0 { low = middle } else { high = middle }
                }
            }
        }
    }
    [f64::INFINITY; 2]
}

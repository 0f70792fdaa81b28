//! The equations of a scene with the quantities that a search changes: results of the whole range, quick on plain
//! numbers, and with every peak and its exact derivatives on dual numbers.

use std::f64::consts::TAU;

use lemnis_models::component::mechanism::Mechanism;
use lemnis_models::component::outline::Most;
use lemnis_models::component::part::{Face, Part};
use lemnis_models::component::probe::{slot, slots};
use lemnis_models::component::spread::Spread;
use lemnis_models::component::stages::{Slot, Source};
use lemnis_models::component::standing::Standing;
use lemnis_models::component::whole::How;
use lemnis_models::parts::motion::Motion;
use lemnis_models::request::{RangeFound, RangeResult, Request};
use num_dual::Dual64;

use crate::peaks::{Peak, Peaked, Peaks, Shape, place, tops};

/// Parts of the working range between the positions that are looked at before peaks are refined.
const GRID: usize = 96;
/// In the place of a coordinate that is infinite because something never happens.
pub const NEVER: f64 = 1e6;

/// The greatest of some results over the working range, each with its sign.
#[derive(Clone, Debug)]
enum Term {
    Peaks(Vec<(Slot, f64)>),
    Steady(Slot),
    Vanishes(Spread),
}

/// A result of the range.
#[derive(Clone, Debug)]
pub struct Measured {
    pub shape: Shape,
    parts: Vec<Term>,
    /// Where this changes its sign the result is infinite.
    pole: Option<Slot>,
}

/// A model on plain numbers and on dual ones.
pub struct Equations {
    motion: Motion,
    coordinate: Source,
    sources: Vec<Source>,
    plain: Box<dyn Part>,
    /// By the coordinate, then by each quantity that varies.
    duals: Vec<Box<dyn Face<Dual64>>>,
    pub measured: Vec<Measured>,
}

impl Equations {
    /// Of a mechanism whose quantities `asked` may change, with some of its results.
    #[must_use]
    pub fn new(mechanism: &dyn Mechanism, asked: &Request, results: &[RangeResult]) -> Equations {
        let mut model = mechanism.standing();
        for &(source, value) in &asked.chosen {
            model.part_mut().put(source, value);
        }
        let sources: Vec<Source> = asked.varied.iter().map(|varied| varied.source).collect();
        let seeded = |own: Option<Source>| model.part().dual(false, &mut |of, _| f64::from(Some(of) == own)).0;
        let duals = std::iter::once(None).chain(sources.iter().copied().map(Some));
        Equations {
            motion: *model.motion(),
            coordinate: model.coordinate(),
            duals: duals.map(seeded).collect(),
            plain: model.part().duplicate(),
            measured: results.iter().map(|result| measured(&model, result)).collect(),
            sources,
        }
    }

    /// Takes values of the quantities that vary.
    pub fn set(&mut self, values: &[f64]) {
        for (i, (&source, &value)) in self.sources.iter().zip(values).enumerate() {
            self.plain.put(source, value);
            for (of, dual) in self.duals.iter_mut().enumerate() {
                dual.put(source, Dual64::new(value, f64::from(of == i + 1)));
            }
        }
    }

    fn positions(&self) -> [f64; GRID + 1] {
        let Motion { from, to, .. } = self.motion;
        let to = to.min(from + TAU);
        std::array::from_fn(|i| match i {
            GRID => to,
            _ => from + (to - from) * (i as f64 / GRID as f64),
        })
    }

    /// All results at some values, at the positions of the grid alone.
    ///
    /// # Errors
    /// Where some do not exist: in which part of the positions.
    pub fn rough(&mut self, values: &[f64]) -> Result<Vec<f64>, f64> {
        for (&source, &value) in self.sources.iter().zip(values) {
            self.plain.put(source, value);
        }
        let mut found: Vec<Vec<f64>> = self
            .measured
            .iter()
            .map(|one| vec![f64::NEG_INFINITY; one.parts.len()])
            .collect();
        let mut poles = vec![None; self.measured.len()];
        let mut missing = 0;
        let mut number = 0.0;
        for at in self.positions() {
            self.plain.put(self.coordinate, at);
            let mut here = true;
            for ((one, greatest), pole) in self.measured.iter().zip(&mut found).zip(&mut poles) {
                for (part, greatest) in one.parts.iter().zip(greatest) {
                    let (slots, steady) = match part {
                        Term::Peaks(slots) => (slots.as_slice(), None),
                        Term::Steady(slot) => (&[][..], Some((*slot, 1.0))),
                        Term::Vanishes(_) => continue,
                    };
                    for (slot, sign) in slots.iter().chain(&steady) {
                        here &= self.plain.result(slot, &mut number).is_ok() && number.is_finite();
                        *greatest = greatest.max(sign * number);
                    }
                }
                if let Some(slot) = &one.pole {
                    here &= self.plain.result(slot, &mut number).is_ok();
                    let above = number > 0.0;
                    here &= pole.replace(above).is_none_or(|before| before == above);
                }
            }
            missing += usize::from(!here);
        }
        if missing > 0 {
            return Err(missing as f64 / (GRID + 1) as f64);
        }
        let all = self.measured.iter().zip(found);
        let value = |(one, mut parts): (&Measured, Vec<f64>)| {
            if let [Term::Vanishes(spread)] = one.parts.as_slice() {
                parts[0] = spread.find(&*self.plain, &self.motion).ok()?.value.min(NEVER);
            }
            Some(one.shape.of(&parts).0).filter(|value| value.is_finite())
        };
        all.map(value).collect::<Option<_>>().ok_or(1.0)
    }

    /// A result with its derivative by the coordinate.
    fn at(&mut self, (slot, sign): (Slot, f64), place: Dual64) -> Option<Dual64> {
        let mut value = Dual64::from_re(0.0);
        self.duals[0].put(self.coordinate, place);
        self.duals[0].result(&slot, &mut value).ok()?;
        Some(value * sign)
    }

    /// The peak between two places of one of `slots`, by its place among them.
    fn peak(&mut self, slots: &[(Slot, f64)], of: usize, between: [f64; 2]) -> Option<Peak> {
        let at = place(between, &mut |at| Some(self.at(slots[of], Dual64::new(at, 1.0))?.eps))?;
        let (value, slope) = self.slopes(slots[of], at)?;
        Some(Peak {
            of,
            between,
            value,
            slope,
        })
    }

    /// A result with its sign at a place, with its derivatives by the quantities that vary; `None` where it does not exist.
    pub fn slopes(&mut self, (slot, sign): (Slot, f64), at: f64) -> Option<(f64, Vec<f64>)> {
        let mut value = Dual64::from_re(0.0);
        let mut slopes = Vec::new();
        for dual in &mut self.duals {
            dual.put(self.coordinate, Dual64::from_re(at));
            dual.result(&slot, &mut value).ok()?;
            slopes.push(sign * value.eps);
        }
        slopes.remove(0);
        Some((sign * value.re, slopes))
    }

    fn vanishes(&mut self, spread: &Spread) -> Option<Peak> {
        let spot = spread.find(&*self.plain, &self.motion).ok()?;
        let each = self.duals[1..]
            .iter_mut()
            .map(|dual| spread.value(&mut **dual, &spot).ok());
        let slope = each.map(|value| Some(value?.eps)).collect::<Option<_>>()?;
        Some(Peak {
            of: 0,
            between: [self.motion.from; 2],
            value: spot.value.min(NEVER),
            slope,
        })
    }
}

impl Peaked for Equations {
    fn shape(&self, of: usize) -> Shape {
        self.measured[of].shape
    }

    fn peaks(&mut self, values: &[f64]) -> Option<Peaks> {
        self.set(values);
        self.rough(values).ok()?;
        let positions = self.positions();
        let measured = self.measured.clone();
        let part = |this: &mut Equations, part: &Term| match part {
            Term::Steady(slot) => Some(vec![this.peak(&[(*slot, 1.0)], 0, [positions[0]; 2])?]),
            Term::Vanishes(spread) => Some(vec![this.vanishes(spread)?]),
            Term::Peaks(slots) => {
                let mut all = Vec::new();
                for (i, &of) in slots.iter().enumerate() {
                    let grid = positions
                        .iter()
                        .map(|&at| this.at(of, Dual64::from_re(at)).map(|value| value.re));
                    let grid: Vec<f64> = grid.collect::<Option<_>>()?;
                    for ends in tops(&grid) {
                        all.push(this.peak(slots, i, ends.map(|at| positions[at]))?);
                    }
                }
                Some(all)
            }
        };
        let of = |this: &mut Equations, one: &Measured| one.parts.iter().map(|one| part(this, one)).collect();
        measured.iter().map(|one| of(self, one)).collect()
    }

    fn moved(&mut self, values: &[f64], before: &Peaks) -> Option<Peaks> {
        self.set(values);
        let measured = self.measured.clone();
        let part = |this: &mut Equations, part: &Term, peaks: &Vec<Peak>| match part {
            Term::Vanishes(spread) => Some(vec![this.vanishes(spread)?]),
            Term::Steady(slot) => Some(vec![this.peak(&[(*slot, 1.0)], 0, peaks[0].between)?]),
            Term::Peaks(slots) => peaks
                .iter()
                .map(|peak| this.peak(slots, peak.of, peak.between))
                .collect(),
        };
        let of = |this: &mut Equations, (one, before): (&Measured, &Vec<Vec<Peak>>)| {
            one.parts
                .iter()
                .zip(before)
                .map(|(one, peaks)| part(this, one, peaks))
                .collect()
        };
        measured.iter().zip(before).map(|all| of(self, all)).collect()
    }
}

/// What a result of the range is made of.
fn measured(model: &Standing, result: &RangeResult) -> Measured {
    let one = |shape, parts: Vec<Term>| Measured {
        shape,
        parts,
        pole: None,
    };
    let peaks = |slot: Slot, sign: f64| Term::Peaks(vec![(slot, sign)]);
    let (whole, of, per) = match result.found {
        RangeFound::Steady(slot) => return one(Shape::Direct, vec![Term::Steady(slot)]),
        RangeFound::Extreme(extreme) => {
            let (shape, signs): (_, &[f64]) = match extreme.most {
                Most::Greatest => (Shape::Greatest, &[1.0]),
                Most::Least => (Shape::Least, &[-1.0]),
                Most::Amount => (Shape::Greatest, &[1.0, -1.0]),
            };
            let all = slots(model, extreme.of).flat_map(|slot| signs.iter().map(move |&sign| (slot, sign)));
            return Measured {
                pole: extreme.pole.and_then(|pole| slot(model, pole)),
                ..one(shape, vec![Term::Peaks(all.collect())])
            };
        }
        RangeFound::Whole(whole) => {
            let (how, of, per) = model.wholes()[whole].terms();
            ((model.wholes()[whole], how), of, per)
        }
    };
    match (whole, per) {
        ((_, How::Greatest), _) => one(Shape::Greatest, vec![peaks(of, 1.0)]),
        ((_, How::Least), _) => one(Shape::Least, vec![peaks(of, -1.0)]),
        ((_, How::Ratio(_)), Some(per)) => {
            let ends = [(of, 1.0), (of, -1.0), (per, 1.0), (per, -1.0)];
            one(Shape::Ratio, ends.map(|(slot, sign)| peaks(slot, sign)).to_vec())
        }
        ((spread, How::Vanishes(_)), _) => one(Shape::Direct, vec![Term::Vanishes(spread)]),
        _ => one(Shape::Swing, vec![peaks(of, 1.0), peaks(of, -1.0)]),
    }
}

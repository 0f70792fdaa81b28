//! Governing positions: where in the working range each result is greatest, and how these results change with every
//! given quantity.
//!
//! A given quantity that changes moves the governing position too. At an extreme inside the range the derivative by
//! the position is zero, and at an end of the range the position stays: in both cases the change of the result is the
//! derivative at the governing position held fast, exact from dual numbers.

use num_dual::Dual64;

use crate::component::extreme::{Extreme, greatest, greatest_amount, greatest_value};
use crate::component::outline::{Greatest, Most, Outline};
use crate::component::part::Face;
use crate::component::running::Running;
use crate::component::sheet::{Sensitivity, Slope, Summary};
use crate::component::stages::{Slot, Source, Use};
use crate::component::standing::{Standing, VariablePlace};
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::Quantity;
use crate::parts::motion::Motion;

/// A component on dual numbers, at any value of its coordinate.
struct Probe {
    face: Box<dyn Face<Dual64>>,
    coordinate: Source,
}

impl Probe {
    fn new(model: &Standing, seed: &mut dyn FnMut(Source, Quantity) -> f64) -> Probe {
        Probe {
            face: model.part().dual(false, seed).0,
            coordinate: model.coordinate(),
        }
    }

    fn at(&mut self, slot: &Slot, place: Dual64) -> Option<Dual64> {
        let mut value = Dual64::from_re(0.0);
        self.face.put(self.coordinate, place);
        self.face.result(slot, &mut value).ok().map(|()| value)
    }
}

/// Where a result of the scene stands: one slot, or as many as it is numbered to.
fn slots(model: &Standing, symbol: &'static Symbol) -> impl Iterator<Item = Slot> {
    let all = model.variables().iter().zip(model.places());
    all.filter_map(move |(variable, place)| match place {
        VariablePlace::Result(slot) if variable.symbol == symbol => Some(*slot),
        _ => None,
    })
}

fn slot(model: &Standing, symbol: &'static Symbol) -> Option<Slot> {
    slots(model, symbol).next()
}

/// The extremes that exist in a scene.
pub fn extremes<'a>(
    model: &'a Standing,
    outline: &'static Outline,
) -> impl Iterator<Item = (&'static Greatest, Slot)> + 'a {
    let all = outline.extremes.iter();
    all.filter_map(move |extreme| Some((extreme, slot(model, extreme.of)?)))
}

/// The governing results of a scene with their positions.
#[must_use]
pub fn governing(model: &Standing, outline: &'static Outline) -> Vec<Summary> {
    let coordinate = model.variables()[0].symbol;
    let summary = |extreme: &'static Greatest| Some(Summary::placed(extreme.symbol, coordinate, most(model, extreme)?));
    outline.extremes.iter().filter_map(summary).collect()
}

/// An extreme over the working range, of a numbered result over all of them; `None` where the scene does not have it.
#[must_use]
pub fn most(model: &Standing, extreme: &Greatest) -> Option<Extreme> {
    let mut probe = Probe::new(model, &mut |_, _| 0.0);
    let pole = extreme.pole.and_then(|pole| slot(model, pole));
    let each = slots(model, extreme.of).map(|slot| {
        if model.part().stages()[usize::from(slot.stage)].searched {
            return searched(model, &slot, extreme.most);
        }
        let infinite = pole.and_then(|pole| infinite(&mut probe, &pole, &slot, model.motion()));
        infinite.or_else(|| search(&mut probe, &slot, extreme.most, model.motion()))
    });
    let all: Vec<Extreme> = each.collect::<Option<_>>()?;
    let more = |a: Extreme, b: Extreme| if extreme.most.is_before(a.value, b.value) { b } else { a };
    all.into_iter().reduce(more)
}

/// The extreme of what has no derivative.
fn searched(model: &Standing, slot: &Slot, most: Most) -> Option<Extreme> {
    let mut part = model.part().duplicate();
    let mut at = |place: f64, sign: f64| {
        let mut value = 0.0;
        part.put(model.coordinate(), place);
        part.result(slot, &mut value).ok().map(|()| sign * value)
    };
    let sign = if most == Most::Least { -1.0 } else { 1.0 };
    let found = greatest_value(model.motion(), &mut |place| match most {
        Most::Amount => at(place, 1.0).map(f64::abs),
        _ => at(place, sign),
    })?;
    Some(Extreme {
        value: at(found.at, 1.0)?,
        ..found
    })
}

fn search(probe: &mut Probe, slot: &Slot, most: Most, motion: &Motion) -> Option<Extreme> {
    match most {
        Most::Greatest => greatest(motion, &mut |at| probe.at(slot, at)),
        Most::Least => Some(greatest(motion, &mut |at| probe.at(slot, at).map(|value| -value))?.turned()),
        Most::Amount => greatest_amount(motion, &mut |at| probe.at(slot, at)),
    }
}

/// Where an arm changes its sign no force at it gives a moment: the force grows beyond all bounds there, between the
/// points of any grid, if one is asked for.
fn infinite(probe: &mut Probe, arm: &Slot, force: &Slot, motion: &Motion) -> Option<Extreme> {
    const POINTS: u32 = 96;
    let angle = |i: u32| motion.from + (motion.to - motion.from) * (f64::from(i) / f64::from(POINTS));
    let mut positive = |at: f64| Some(probe.at(arm, Dual64::from_re(at))?.re > 0.0);
    let crossed = (0..POINTS).find(|&i| {
        positive(angle(i))
            .zip(positive(angle(i + 1)))
            .is_some_and(|(a, b)| a != b)
    })?;
    let (mut low, mut high) = (angle(crossed), angle(crossed + 1));
    let before = positive(low)?;
    for _ in 0..64 {
        let middle = f64::midpoint(low, high);
        if positive(middle)? == before {
            low = middle;
        } else {
            high = middle;
        }
    }
    let asked = probe.at(force, Dual64::from_re(low))?.re != 0.0;
    asked.then_some(Extreme {
        value: f64::INFINITY,
        at: low,
    })
}

/// Reads a result and its derivative where it is held.
type Reading = Box<dyn Fn(&mut Probe) -> Option<Dual64>>;

/// How results change with each given quantity: derivatives in SI, exact. Those of the outline that the scene has, as
/// results of the range or among the governing ones.
#[must_use]
pub fn sensitivity(model: &mut Standing, outline: &'static Outline, governing: &[Summary]) -> Sensitivity {
    let mut results = Vec::new();
    let mut found: Vec<Reading> = Vec::new();
    for &symbol in outline.sensitivity {
        let extreme = outline.extremes.iter().find(|extreme| extreme.symbol == symbol);
        let held = extreme.and_then(|extreme| slot(model, extreme.of));
        let summary = governing.iter().find(|summary| summary.symbol == symbol);
        let index = model.variables().iter().position(|variable| variable.symbol == symbol);
        let of: Reading;
        let value;
        match (index.map(|index| (index, model.places()[index])), held.zip(summary)) {
            (Some((index, VariablePlace::Whole(whole))), _) => {
                let (spread, spot) = (model.wholes()[whole], model.spot(whole).ok());
                value = model.get(index).ok();
                of = Box::new(move |probe| spread.value(&mut *probe.face, &spot?).ok());
            }
            // A result of the whole range is the same everywhere.
            (Some((index, VariablePlace::Result(slot))), _) => {
                let from = Dual64::from_re(model.motion().from);
                value = model.get(index).ok();
                of = Box::new(move |probe| probe.at(&slot, from));
            }
            // An extreme is held where it was found.
            (_, Some((slot, summary))) => {
                let at = Dual64::from_re(summary.at.map_or(model.motion().from, |(_, at)| at));
                value = Some(summary.value);
                of = Box::new(move |probe| probe.at(&slot, at));
            }
            _ => continue,
        }
        if let Some(value) = value.filter(|value| value.is_finite() && *value != 0.0) {
            results.push((symbol, value));
            found.push(of);
        }
    }
    let groups = model.part().groups();
    let used = |source: Source| groups[usize::from(source.group)].1;
    let mut given = model.part().sources();
    let smooth = |(_, (symbol, _)): &(Source, Quantity)| !model.part().undoes(symbol);
    given.retain(|given| matches!(used(given.0), Use::Parameter | Use::Load) && smooth(given));
    // What is built, then what hangs on it.
    given.sort_by_key(|(source, _)| used(*source) == Use::Load);
    let row = |(source, (symbol, _)): (Source, Quantity)| {
        let mut probe = Probe::new(model, &mut |of, _| f64::from(of == source));
        let by = found.iter().map(|of| Some(of(&mut probe)?.eps));
        Some(Slope {
            symbol,
            value: model.part().take(source),
            by: by.collect::<Option<_>>()?,
        })
    };
    if results.is_empty() {
        return Sensitivity::default();
    }
    Sensitivity {
        rows: given.into_iter().filter_map(row).collect(),
        results,
    }
}

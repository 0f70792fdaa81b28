//! Peaks of results over the working range: those of several are looked for together.

use num_dual::Dual64;

use crate::component::extreme::{Extreme, Looked, fine, greatest_value, grid, peak};
use crate::component::outline::{Greatest, Most, Outline};
use crate::component::probe::{Probe, slot, slots};
use crate::component::running::Running;
use crate::component::sheet::Summary;
use crate::component::stages::Slot;
use crate::component::standing::{Standing, VariablePlace};
use crate::kernel::calc::Calc;
use crate::kernel::symbol::Symbol;
use crate::parts::motion::Motion;

/// Peaks of several results of a model over the working range, each found once.
pub struct Peaks {
    probe: Probe,
    looked: Vec<(Slot, Option<Box<Looked>>)>,
    found: Vec<(Slot, Most, Option<Extreme>)>,
}

impl Peaks {
    #[must_use]
    pub fn new(model: &Standing) -> Peaks {
        Peaks {
            probe: Probe::new(model, &mut |_, _| 0.0),
            looked: Vec::new(),
            found: Vec::new(),
        }
    }

    /// Looks at results, at all of them together: what they follow from is found once for each place.
    pub fn look(&mut self, model: &Standing, symbols: impl Iterator<Item = &'static Symbol>) {
        let stages = model.part().stages();
        let slots = symbols.flat_map(|symbol| slots(model, symbol));
        let smooth = slots.filter(|slot| !stages[usize::from(slot.stage)].searched);
        let known = self.looked.len();
        for slot in smooth {
            if self.looked.iter().all(|(known, _)| *known != slot) {
                self.looked.push((slot, Some(Box::new([Dual64::from_re(0.0); _]))));
            }
        }
        for (i, at) in grid(model.motion()).into_iter().enumerate() {
            for (slot, values) in &mut self.looked[known..] {
                match self.probe.at(slot, Dual64::new(at, 1.0)) {
                    Some(value) => values.iter_mut().for_each(|values| values[i] = value),
                    None => *values = None,
                }
            }
        }
    }

    /// As [`governing`](crate::component::governing::governing).
    pub fn governing(
        &mut self,
        model: &Standing,
        outline: &'static Outline,
        wanted: &dyn Fn(&'static Symbol) -> bool,
    ) -> Vec<Summary> {
        let coordinate = model.variables()[0].symbol;
        let extremes = outline.extremes.iter().filter(|extreme| wanted(extreme.symbol));
        self.look(model, extremes.clone().map(|extreme| extreme.of));
        let summary = |extreme: &'static Greatest| {
            let found = self.most(model, extreme)?;
            Some(Summary::at(extreme.symbol, found, coordinate).of(extreme.of))
        };
        extremes.filter_map(summary).collect()
    }

    /// An extreme, of a numbered result over all of them; `None` where the scene does not have it, and of what has not been
    /// looked at.
    pub fn most(&mut self, model: &Standing, extreme: &Greatest) -> Option<Extreme> {
        let pole = extreme.pole.and_then(|pole| slot(model, pole));
        let each = slots(model, extreme.of).map(|slot| {
            let infinite = pole.and_then(|pole| infinite(&mut self.probe, &pole, &slot, model.motion()));
            infinite.or_else(|| self.of(model, &slot, extreme.most))
        });
        let all: Vec<Extreme> = each.collect::<Option<_>>()?;
        let more = |a: Extreme, b: Extreme| if extreme.most.is_before(a.value, b.value) { b } else { a };
        all.into_iter().reduce(more)
    }

    /// The extreme of one of the results; `None` where it does not exist all over the range.
    pub fn of(&mut self, model: &Standing, slot: &Slot, most: Most) -> Option<Extreme> {
        let known = self.found.iter().find(|(of, which, _)| of == slot && *which == most);
        if let Some((.., found)) = known {
            return *found;
        }
        let found = self.refined(model, slot, most);
        self.found.push((*slot, most, found));
        found
    }

    fn refined(&mut self, model: &Standing, slot: &Slot, most: Most) -> Option<Extreme> {
        if model.part().stages()[usize::from(slot.stage)].searched {
            return searched(model, slot, most);
        }
        let (_, looked) = self.looked.iter().find(|(known, _)| known == slot)?;
        let turned = |value: Dual64| match most {
            Most::Greatest => value,
            Most::Least => -value,
            Most::Amount => Calc::abs(value),
        };
        let probe = &mut self.probe;
        let looked = looked.as_ref()?.map(turned);
        let found = peak(model.motion(), &looked, &mut |at| probe.at(slot, at).map(turned))?;
        match most {
            Most::Greatest => Some(found),
            Most::Least => Some(found.turned()),
            Most::Amount => Some(Extreme {
                value: probe.at(slot, Dual64::from_re(found.at))?.re,
                ..found
            }),
        }
    }

    /// Places at which a variable is drawn over the working range: those of a curve, and where it is greatest and least.
    pub fn drawn(&mut self, model: &Standing, index: usize) -> Vec<f64> {
        let mut places: Vec<f64> = fine(model.motion()).collect();
        if let VariablePlace::Result(slot) = model.places()[index] {
            let found = [Most::Greatest, Most::Least].map(|most| self.of(model, &slot, most));
            let finite = found.into_iter().flatten().filter(|found| found.value.is_finite());
            places.extend(finite.map(|found| found.at));
            places.sort_by(f64::total_cmp);
            places.dedup();
        }
        places
    }
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

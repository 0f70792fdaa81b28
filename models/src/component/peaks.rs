//! Peaks of results over the working range: those of several are looked for together.

use num_dual::Dual64;

use crate::component::aside::{Aside, Beside, Peak};
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

/// Every so many places of the coordinate are looked at besides where the second one stands, until all are asked for.
const COARSE: usize = 2;

/// Peaks of several results of a model over the working range, each found once.
pub struct Peaks {
    probe: Probe,
    /// Of each place of the second coordinate, or once.
    looked: Vec<(Slot, Option<Vec<Looked>>)>,
    found: Vec<(Slot, Most, Option<Peak>)>,
    aside: Option<(&'static Symbol, Beside)>,
}

impl Peaks {
    #[must_use]
    pub fn new(model: &Standing) -> Peaks {
        Peaks {
            probe: Probe::new(model, &mut |_, _| 0.0),
            looked: Vec::new(),
            found: Vec::new(),
            aside: None,
        }
    }

    /// Over the range of a second coordinate too, if there is one.
    #[must_use]
    pub fn over(model: &Standing, aside: Option<Aside>) -> Peaks {
        let beside = aside.and_then(|aside| Some((aside.symbol, Beside::new(model, &aside)?)));
        Peaks {
            aside: beside,
            ..Peaks::new(model)
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
                let moved = self.aside.iter().filter(|(_, beside)| beside.moves(&slot));
                let places = moved.map(|(_, beside)| beside.places.len()).next().unwrap_or(1);
                self.looked
                    .push((slot, Some(vec![[Dual64::from_re(f64::NAN); _]; places])));
            }
        }
        let places = self
            .aside
            .iter()
            .flat_map(|(_, beside)| beside.places.iter().map(|at| Some((beside.source, *at))));
        let places: Vec<_> = places.collect();
        let once = [None];
        let places = if places.is_empty() { &once[..] } else { &places };
        for (j, aside) in places.iter().enumerate() {
            if let Some((source, at)) = *aside {
                self.probe.stand(source, Dual64::from_re(at));
            }
            for (i, at) in grid(model.motion()).into_iter().enumerate() {
                // First where it stands, then every so many places: the others of a row that is the best one for some result.
                if j == 0 || i % COARSE == 0 {
                    place(&mut self.probe, &mut self.looked[known..], [j, i], at);
                }
            }
        }
        self.back();
    }

    /// Looks at all places at one of the second coordinate, at which some were left out.
    fn complete(&mut self, model: &Standing, row: usize) {
        let Some((_, beside)) = self.aside.as_ref().filter(|_| row > 0) else {
            return;
        };
        self.probe.stand(beside.source, Dual64::from_re(beside.places[row]));
        let all = grid(model.motion()).into_iter().enumerate();
        for (i, at) in all.filter(|(i, _)| i % COARSE != 0) {
            place(&mut self.probe, &mut self.looked, [row, i], at);
        }
        self.back();
    }

    /// Puts the second coordinate where it stood.
    fn back(&mut self) {
        if let Some((_, beside)) = &self.aside {
            self.probe.stand(beside.source, Dual64::from_re(beside.places[0]));
        }
    }

    /// A peak as a result of the range, with its place.
    #[must_use]
    pub fn summary(&self, model: &Standing, symbol: &'static Symbol, found: Peak) -> Summary {
        let own = Summary::at(symbol, found.extreme, model.variables()[0].symbol);
        let aside = self.aside.as_ref().map(|(symbol, _)| *symbol).zip(found.aside);
        Summary { aside, ..own }
    }

    /// As [`governing`](crate::component::governing::governing).
    pub fn governing(
        &mut self,
        model: &Standing,
        outline: &'static Outline,
        wanted: &dyn Fn(&'static Symbol) -> bool,
    ) -> Vec<Summary> {
        let extremes = outline.extremes.iter().filter(|extreme| wanted(extreme.symbol));
        self.look(model, extremes.clone().map(|extreme| extreme.of));
        let summary = |extreme: &'static Greatest| {
            let found = self.most(model, extreme)?;
            Some(self.summary(model, extreme.symbol, found).of(extreme.of))
        };
        extremes.filter_map(summary).collect()
    }

    /// An extreme, of a numbered result over all of them; `None` where the scene does not have it, and of what has not been
    /// looked at.
    pub fn most(&mut self, model: &Standing, extreme: &Greatest) -> Option<Peak> {
        let pole = extreme.pole.and_then(|pole| slot(model, pole));
        let all: Vec<Slot> = slots(model, extreme.of).collect();
        let hopes: Vec<f64> = all.iter().map(|slot| self.hope(slot, extreme.most)).collect();
        let mut order: Vec<usize> = (0..all.len()).collect();
        order.sort_by(|&one, &other| hopes[other].total_cmp(&hopes[one]));
        let mut found: Vec<Option<Peak>> = vec![None; all.len()];
        let mut best = f64::NEG_INFINITY;
        for i in order {
            let slot = &all[i];
            let infinite = pole.and_then(|pole| infinite(&mut self.probe, &pole, slot, model.motion()));
            let infinite = infinite.map(|extreme| Peak { extreme, aside: None });
            // What cannot become the most of them is not looked for.
            if infinite.is_none() && hopes[i] < best {
                continue;
            }
            let own = infinite.or_else(|| self.of(model, slot, extreme.most))?;
            best = best.max(extreme.most.turned(own.extreme.value));
            found[i] = Some(own);
        }
        let before = |a: &Peak, b: &Peak| extreme.most.is_before(a.extreme.value, b.extreme.value);
        let more = |a: Peak, b: Peak| if before(&a, &b) { b } else { a };
        found.into_iter().flatten().reduce(more)
    }

    /// What the extreme of a result may come to at most, turned as its kind of extreme is: the most of the places looked at, and
    /// once more the most by which neighbours differ. Beyond all bounds where it is not known.
    fn hope(&self, slot: &Slot, most: Most) -> f64 {
        let known = self.looked.iter().find(|(known, _)| known == slot);
        let Some(looked) = known.and_then(|(_, looked)| looked.as_ref()) else {
            return f64::INFINITY;
        };
        let apart = |one: &Dual64, other: &Dual64| (one.re - other.re).abs();
        let along = looked.iter().flat_map(|row| row.iter().zip(&row[COARSE..]));
        // First where the scene begins, then in their order.
        let aside = looked.iter().zip(looked.iter().skip(1)).skip(1);
        let aside = aside.flat_map(|(row, next)| row.iter().zip(next));
        let rise = along
            .chain(aside)
            .map(|(one, other)| apart(one, other))
            .fold(0.0, f64::max);
        let values = looked.iter().flatten().map(|value| most.turned(value.re));
        values.fold(f64::NEG_INFINITY, f64::max) + rise
    }

    /// The extreme of one of the results; `None` where it does not exist all over the range.
    pub fn of(&mut self, model: &Standing, slot: &Slot, most: Most) -> Option<Peak> {
        let known = self.found.iter().find(|(of, which, _)| of == slot && *which == most);
        if let Some((.., found)) = known {
            return *found;
        }
        let found = self.refined(model, slot, most);
        self.found.push((*slot, most, found));
        found
    }

    fn refined(&mut self, model: &Standing, slot: &Slot, most: Most) -> Option<Peak> {
        if model.part().stages()[usize::from(slot.stage)].searched {
            return searched(model, slot, most).map(|extreme| Peak { extreme, aside: None });
        }
        let at = self.looked.iter().position(|(known, _)| known == slot)?;
        let turned = |value: Dual64| match most {
            Most::Greatest => value,
            Most::Least => -value,
            Most::Amount => Calc::abs(value),
        };
        let row = Beside::best(self.looked[at].1.as_ref()?.iter(), |value| most.turned(value));
        if self.looked[at].1.as_ref()?[row].iter().any(|value| value.re.is_nan()) {
            self.complete(model, row);
        }
        let rows = self.looked[at].1.as_ref()?;
        let (several, looked) = (rows.len() > 1, rows[row].map(turned));
        let (probe, motion) = (&mut self.probe, model.motion());
        let found = match &self.aside {
            Some((_, beside)) if several => {
                let mut of = |at, aside| {
                    probe.stand(beside.source, aside);
                    probe.at(slot, at).map(turned)
                };
                beside.greatest(motion, (row, &looked), &mut of)?
            }
            _ => Peak {
                extreme: peak(motion, &looked, &mut |at| probe.at(slot, at).map(turned))?,
                aside: None,
            },
        };
        let extreme = match most {
            Most::Greatest => found.extreme,
            Most::Least => found.extreme.turned(),
            Most::Amount => {
                let (source, aside) = (self.aside.as_ref().map(|(_, beside)| beside.source), found.aside);
                if let Some((source, aside)) = source.zip(aside) {
                    probe.stand(source, Dual64::from_re(aside));
                }
                Extreme {
                    value: probe.at(slot, Dual64::from_re(found.extreme.at))?.re,
                    ..found.extreme
                }
            }
        };
        self.back();
        Some(Peak { extreme, ..found })
    }

    /// Places at which a variable is drawn over the working range: those of a curve, and where it is greatest and least.
    pub fn drawn(&mut self, model: &Standing, index: usize) -> Vec<f64> {
        let mut places: Vec<f64> = fine(model.motion()).collect();
        if let VariablePlace::Result(slot) = model.places()[index] {
            let found = [Most::Greatest, Most::Least].map(|most| self.of(model, &slot, most));
            let found = found.into_iter().flatten().map(|found| found.extreme);
            places.extend(found.filter(|found| found.value.is_finite()).map(|found| found.at));
            places.sort_by(f64::total_cmp);
            places.dedup();
        }
        places
    }
}

/// Looks at those results at one place that have not been looked at there, by the numbers of both coordinates' places.
fn place(probe: &mut Probe, all: &mut [(Slot, Option<Vec<Looked>>)], [row, at]: [usize; 2], value: f64) {
    for (slot, looked) in all {
        let here = looked.as_mut().and_then(|looked| looked.get_mut(row));
        let Some(here) = here.map(|row| &mut row[at]).filter(|here| here.re.is_nan()) else {
            continue;
        };
        match probe.at(slot, Dual64::new(value, 1.0)) {
            Some(found) => *here = found,
            None => *looked = None,
        }
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

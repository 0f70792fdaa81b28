//! What each variable follows from, as the recorder finds it: never by hand.

use std::any::Any;
use std::collections::BTreeSet;

use crate::component::part::{Component, Face, Part, Runner};
use crate::component::running::Running;
use crate::component::stages::{Slot, Source, Use};
use crate::component::standing::{Standing, VariablePlace};
use crate::kernel::calc::Calc;
use crate::kernel::record::{Rec, record};
use crate::kernel::variable::{Name, PART_OF_RANGE, Quantity, Role, TIME, Type, Variable};

/// Makes a number of the recorder of each source.
pub type Sources<'a> = &'a mut dyn FnMut(Source, Quantity, f64) -> Rec;

/// A component on the recorder, made from one that runs. The FMU's library has none.
pub type Recorder = fn(&dyn Part, Sources<'_>) -> Box<dyn Face<Rec>>;

/// The [`Recorder`] of a component.
///
/// # Panics
/// For another component's part.
#[must_use]
pub fn recorded<T: Component>(part: &dyn Part, of: Sources<'_>) -> Box<dyn Face<Rec>> {
    let part: &dyn Any = part;
    let part: &Runner<T, f64> = part.downcast_ref().expect("the component's own part");
    Box::new(Runner::<T, Rec>::new(T::map(part.given(), of)))
}

/// What each variable's expression contains: inputs, parameters and [`TIME`], all over the working range, in both
/// directions of motion, in every combination of discrete inputs, with the coordinate set or following from the time.
/// What only decides leaves no trace in a formula: a stage that is searched follows from all of its sources, and a truth
/// value from what the other results of its stage follow from.
#[must_use]
pub fn dependencies(model: &Standing, recorder: Recorder) -> Vec<BTreeSet<Name>> {
    let part = model.part();
    let groups = part.groups();
    let sources = part.sources();
    let used = |source: Source| groups[usize::from(source.group)].1;
    let (traced, told) = traced(model, recorder);
    let mut found = traced.clone();
    let slot = |index: usize| match model.places()[index] {
        VariablePlace::Result(slot) => Some(slot),
        VariablePlace::Source(_) | VariablePlace::Whole(_) | VariablePlace::Part => None,
    };
    let is =
        |index: usize, state: Source| matches!(model.places()[index], VariablePlace::Source(source) if source == state);
    let group = |name: &Name| {
        let of = |(_, (symbol, number)): &&(Source, Quantity)| (symbol.id, *number) == *name;
        sources.iter().find(of).map_or(63, |(source, _)| source.group)
    };
    for (index, found) in found.iter_mut().enumerate() {
        if let VariablePlace::Whole(whole) = model.places()[index] {
            // What the result at one position follows from, but for the position.
            let spread = &model.wholes()[whole];
            let own = |other: &usize| slot(*other).is_some_and(|slot| spread.is_of(&slot));
            let of = (0..traced.len()).filter(own).flat_map(|other| traced[other].iter());
            found.extend(of.filter(|name| spread.sources >> group(name) & 1 == 1).copied());
            continue;
        }
        let Some(slot) = slot(index) else {
            let of = sources
                .iter()
                .find(|(source, _)| used(*source) == Use::State && is(index, *source));
            found.extend(of.map(|(_, (symbol, number))| (symbol.id, *number)));
            continue;
        };
        if model.variables()[index].kind == Type::Boolean {
            let same = |other: &usize| same(&slot, model, *other);
            found.extend(
                (0..traced.len())
                    .filter(same)
                    .flat_map(|other| traced[other].iter().copied()),
            );
        }
        // What goes on with what is searched has no formula either.
        let searched = !told[index] || part.stages()[usize::from(slot.stage)].searched;
        for &(source, (symbol, number)) in &sources {
            let decides = symbol.kind != Type::Real;
            if slot.sources >> source.group & 1 == 0 || !(searched || decides) {
                continue;
            }
            match used(source) {
                Use::Time => found.extend([(TIME.id, None)]),
                Use::Memory | Use::Latch => {}
                // Of several bodies each follows from itself.
                Use::State if number != model.variables()[index].number => {}
                Use::Coordinate => {
                    let rate = sources.iter().find(|(source, _)| used(*source) == Use::Rate);
                    let rate = rate.map(|(_, (symbol, number))| (symbol.id, *number));
                    found.extend([(symbol.id, number), (TIME.id, None)].into_iter().chain(rate));
                }
                _ => found.extend([(symbol.id, number)]),
            }
        }
    }
    if model.has_part_of_range() {
        with_part_of_range(model, &mut found);
    }
    decided(model, &mut found);
    found
}

/// What leaves no trace because values decide: all parameters, and of what is not searched for the states and inputs from
/// which the last rate follows, of several bodies those of their own.
fn decided(model: &Standing, found: &mut [BTreeSet<Name>]) {
    let all = || model.variables().iter().zip(model.places());
    let rate = all().rfind(|(variable, _)| variable.role == Role::Rate);
    let Some((_, VariablePlace::Result(Slot { sources: acting, .. }))) = rate else {
        return;
    };
    let stages = model.part().stages();
    for ((variable, place), found) in all().zip(found) {
        let VariablePlace::Result(slot) = place else { continue };
        let stage = &stages[usize::from(slot.stage)];
        if !stage.decided {
            continue;
        }
        let follows = |(known, place): &(&Variable, &VariablePlace)| match (known.role, place) {
            (Role::Parameter | Role::Tunable, _) => known.number.is_none(),
            (Role::Input | Role::State, VariablePlace::Source(source)) => {
                let own = known.number.is_none() || variable.number.is_none() || known.number == variable.number;
                !stage.searched && own && acting >> source.group & 1 == 1
            }
            _ => false,
        };
        found.extend(all().filter(follows).map(|(known, _)| (known.symbol.id, known.number)));
    }
}

/// What follows from the coordinate follows from the part of the range, too, or in its place.
fn with_part_of_range(model: &Standing, found: &mut [BTreeSet<Name>]) {
    let at = model.coordinate_index();
    let name = |index: usize| -> Name {
        let (symbol, number) = model.variables()[index].quantity();
        (symbol.id, number)
    };
    let coordinate = name(at);
    for names in found.iter_mut().filter(|names| names.contains(&coordinate)) {
        names.insert((PART_OF_RANGE.id, None));
        if model.motion().by_part {
            names.remove(&coordinate);
        }
    }
    if model.motion().by_part {
        found[at].extend([(PART_OF_RANGE.id, None), (TIME.id, None)]);
        found[at].extend(model.index_of(model.rate()).map(name));
    }
}

/// What each variable's formula contains, as the recorder finds it, and whether it has one.
fn traced(model: &Standing, recorder: Recorder) -> (Vec<BTreeSet<Name>>, Vec<bool>) {
    let part = model.part();
    let groups = part.groups();
    let sources = part.sources();
    let used = |source: Source| groups[usize::from(source.group)].1;
    let find = |wanted| sources.iter().position(|(source, _)| used(*source) == wanted);
    let motion = model.motion();
    let middle = f64::midpoint(motion.from, motion.to);
    let mut names: Vec<Name> = sources
        .iter()
        .map(|(_, (symbol, number))| (symbol.id, *number))
        .collect();
    names.push((TIME.id, None));
    // Of each variable: which of the names its formula contains.
    let mut traced = vec![vec![false; names.len()]; model.places().len()];
    let mut told = vec![false; traced.len()];
    for choice in choices(&sources) {
        for (at, way) in [(motion.from, 1.0), (middle, 1.0), (middle, -1.0), (motion.to, 1.0)] {
            let mut part = part.duplicate();
            for &(source, value) in &choice {
                part.put(source, value);
            }
            let rate = way * motion.speed;
            let time = (at - motion.from) / motion.speed;
            let (trace, (recs, results)) = record(|| {
                let mut recs: Vec<(Rec, usize)> = Vec::new();
                let mut named = |index: usize, symbol, value| {
                    let rec = Rec::given(symbol, value);
                    recs.push((rec, index));
                    rec
                };
                let mut of = |source, (symbol, number): Quantity, value| {
                    let index = sources.iter().position(|(other, _)| *other == source);
                    // What another source stands for in this scene.
                    let Some(index) = index else {
                        return Rec::constant(value);
                    };
                    debug_assert_eq!(names[index], (symbol.id, number));
                    match used(source) {
                        Use::Coordinate => named(index, symbol, at),
                        Use::Rate => named(index, symbol, rate),
                        Use::Time => named(sources.len(), &TIME, time),
                        Use::Memory | Use::Latch | Use::Fixed => Rec::constant(value),
                        _ => named(index, symbol, value),
                    }
                };
                let mut face = recorder(&*part, &mut of);
                let mut result = |place: &VariablePlace| match place {
                    VariablePlace::Source(_) | VariablePlace::Whole(_) | VariablePlace::Part => None,
                    VariablePlace::Result(slot) => {
                        let mut value = Rec::constant(0.0);
                        face.result(slot, &mut value).ok().map(|()| value)
                    }
                };
                let results: Vec<Option<Rec>> = model.places().iter().map(&mut result).collect();
                (recs, results)
            });
            let givens = trace.givens();
            let known = |leaf| recs.iter().find(|(rec, _)| *rec == leaf).map(|(_, index)| *index);
            let known: Vec<Option<usize>> = givens.all().map(known).collect();
            for ((traced, told), result) in traced.iter_mut().zip(&mut told).zip(results) {
                *told |= result.is_some();
                let leaves = result.into_iter().flat_map(|result| givens.of(result));
                for index in leaves.filter_map(|leaf| known[leaf]) {
                    traced[index] = true;
                }
            }
        }
    }
    // Until the coordinate is set, it follows from its rate and the time.
    if let (Some(coordinate), Some(rate), false) =
        (find(Use::Coordinate), find(Use::Rate), model.has_moving_coordinate())
    {
        for traced in traced.iter_mut().filter(|traced| traced[coordinate]) {
            traced[rate] = true;
            traced[sources.len()] = true;
        }
    }
    let named = traced.iter().map(|traced| {
        let those = names.iter().zip(traced).filter(|(_, found)| **found);
        those.map(|(name, _)| *name).collect()
    });
    (named.collect(), told)
}

/// Whether a variable is a result of the same stage.
fn same(slot: &Slot, model: &Standing, other: usize) -> bool {
    matches!(&model.places()[other], VariablePlace::Result(known) if known.stage == slot.stage && known.of == slot.of)
}

/// Every combination of the discrete inputs' values.
fn choices(sources: &[(Source, Quantity)]) -> Vec<Vec<(Source, f64)>> {
    let mut all = vec![Vec::new()];
    for &(source, (symbol, _)) in sources {
        if let Type::Enumeration(of) = symbol.kind {
            let each = |known: &Vec<(Source, f64)>| {
                let with = |number: usize| known.iter().copied().chain([(source, number as f64)]).collect();
                (1..=of.items.len()).map(with).collect::<Vec<Vec<_>>>()
            };
            all = all.iter().flat_map(each).collect();
        }
    }
    all
}

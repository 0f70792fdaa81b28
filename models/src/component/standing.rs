//! A component that stands where its coordinate wants it, as a running model: inputs and parameters in, results out,
//! only what is asked for computed.

mod stepped;

use std::any::Any;
use std::sync::Arc;

use num_dual::Dual64;

use crate::component::part::{Component, Face, Part, Runner, listed};
use crate::component::running::{Running, Tangent};
use crate::component::spread::{Spot, Spread};
use crate::component::stages::{Slot, Source, Use, searched};
use crate::component::table::{Axes, Interpolation};
use crate::kernel::number::short;
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::{Fault, PART_OF_RANGE, Quantity, Role, TIME, Type, Variable};
use crate::parts::motion::Motion;

/// Where a variable stands.
#[derive(Clone, Copy, Debug)]
pub enum VariablePlace {
    Source(Source),
    Result(Slot),
    /// A result of the whole range, in their order.
    Whole(usize),
    /// The coordinate, as a part of the working range.
    Part,
}

/// A scene's component with its inputs, stepped by the FMU and by tables.
#[derive(Clone)]
pub struct Standing {
    variables: Vec<Variable>,
    places: Vec<VariablePlace>,
    sources: Vec<(Source, Quantity)>,
    indicators: Vec<usize>,
    motion: Motion,
    axes: Axes,
    wholes: Vec<Spread>,
    /// Groups from which any of them follows.
    follow: u64,
    /// The time, where results follow from it, and what happened before.
    clock: Option<Source>,
    memory: Vec<Source>,
    table: Option<Arc<Interpolation>>,
    now: Now,
}

/// All that changes while it runs.
#[derive(Clone)]
struct Now {
    /// In s.
    time: f64,
    /// Whether the coordinate has been set. Until then it runs through its working range by itself.
    given: bool,
    /// The part of the range, where that was set last.
    at_part: Option<f64>,
    part: Box<dyn Part>,
    /// Results of the whole range, as far as they were asked for.
    spots: Vec<Option<Spot>>,
}

/// The results with their derivatives in one direction.
struct Direction {
    face: Box<dyn Face<Dual64>>,
    /// Groups that change in this direction.
    moved: u64,
    /// A source that changes in it, of which the least change makes another component.
    undoes: Option<&'static Symbol>,
}

impl Direction {
    /// # Errors
    /// A direction by which there is no derivative.
    fn smooth(&self) -> Result<(), Fault> {
        let refuse = |symbol: &Symbol| {
            Err(Fault::outside(format!(
                "there is no derivative by {}: with the least change of it the linkage loses its change points, and the \
                 branch on which it passes them",
                symbol.id
            )))
        };
        self.undoes.map_or(Ok(()), refuse)
    }
}

impl Now {
    fn follow(&mut self, other: &Now) {
        (self.time, self.given, self.at_part) = (other.time, other.given, other.at_part);
        self.part.follow(&*other.part);
        self.spots.clone_from(&other.spots);
    }

    /// Forgets the results of the range that follow from a source.
    fn forget(&mut self, source: Source, wholes: &[Spread]) {
        for (spot, whole) in self.spots.iter_mut().zip(wholes) {
            if whole.sources >> source.group & 1 == 1 {
                *spot = None;
            }
        }
    }
}

/// How fast each source changes in a direction.
struct Seeds<'a> {
    seed: &'a dyn Fn(Quantity) -> f64,
    /// The coordinate, and how fast that changes.
    moved: (Source, f64),
    clock: Option<Source>,
    part: &'a dyn Part,
    /// A source that changes and makes another component of this one.
    undoes: Option<&'static Symbol>,
}

impl Seeds<'_> {
    fn of(&mut self, source: Source, quantity: Quantity) -> f64 {
        let own = match self.moved {
            (coordinate, rate) if source == coordinate => rate,
            _ if Some(source) == self.clock => (self.seed)((&TIME, None)),
            _ => (self.seed)(quantity),
        };
        if own != 0.0 && self.part.undoes(quantity.0) {
            self.undoes = Some(quantity.0);
        }
        own
    }
}

impl Standing {
    /// With a `tolerance`, interpolated over the working range to that part of each result's range.
    ///
    /// # Errors
    /// A component that does not exist at the start of its working range.
    pub fn new(mut part: Box<dyn Part>, motion: Motion, tolerance: Option<f64>) -> Result<Standing, Fault> {
        let (groups, sources, results) = (part.groups(), part.sources(), part.results());
        let used = |source: Source| groups[usize::from(source.group)].1;
        let of = |wanted| {
            let all = sources.iter().map(|(source, _)| *source);
            all.filter(move |source| used(*source) == wanted)
        };
        let (mut variables, mut places) = (Vec::new(), Vec::new());
        for &(source, quantity) in &sources {
            let role = match used(source) {
                Use::Fixed | Use::Time | Use::Memory | Use::Latch => continue,
                Use::Parameter if part.is_input(quantity.0) => Role::Input,
                Use::Parameter if quantity.0.tunable => Role::Tunable,
                Use::Parameter => Role::Parameter,
                Use::Input | Use::Load | Use::Coordinate | Use::Rate => Role::Input,
                Use::State => Role::State,
            };
            let mut variable = Variable::new(quantity, role);
            if used(source) == Use::Coordinate {
                variable.bounds = part.reach().unwrap_or(variable.bounds);
            }
            variables.push(variable);
            places.push(VariablePlace::Source(source));
        }
        let inputs = sources.iter().filter(|(_, (symbol, _))| part.is_input(symbol));
        let inputs = inputs.fold(0, |mask, (source, _)| mask | 1_u64 << source.group);
        let there = sources.iter().fold(0, |mask, (source, _)| mask | 1_u64 << source.group);
        let role = |sources: u64| {
            let varies = |(group, (_, of)): (u64, &(_, Use))| (sources & there) >> group & 1 == 1 && of.varies();
            match sources & inputs != 0 || (0..).zip(groups).any(varies) {
                true => Role::Output,
                false => Role::Calculated,
            }
        };
        for &(slot, quantity) in &results {
            let indicator = part.indicators().contains(&quantity.0);
            let role = if indicator { Role::Indicator } else { role(slot.sources) };
            variables.push(Variable::new(quantity, role));
            places.push(VariablePlace::Result(slot));
        }
        let only = |wanted| of(wanted).next().expect("every component has it");
        let axes = Axes {
            coordinate: only(Use::Coordinate),
            rate: only(Use::Rate),
            load: of(Use::Load).next(),
        };
        let mut wholes = Vec::new();
        for whole in part.whole() {
            let found = Spread::new(whole, &sources, &results, [axes.coordinate, axes.rate]);
            let Some(spread) = found else { continue };
            variables.push(Variable::new((whole.symbol, None), role(spread.sources)));
            places.push(VariablePlace::Whole(wholes.len()));
            wholes.push(spread);
        }
        let (variables, places) = listed(&*part, variables, places);
        let indicator = |&index: &usize| variables[index].role == Role::Indicator;
        let mut model = Standing {
            indicators: (0..variables.len()).filter(indicator).collect(),
            axes,
            clock: of(Use::Time).next(),
            memory: of(Use::Memory).chain(of(Use::Latch)).collect(),
            sources,
            variables,
            places,
            motion,
            table: None,
            now: Now {
                time: 0.0,
                given: false,
                at_part: None,
                part,
                spots: vec![None; wholes.len()],
            },
            follow: wholes.iter().fold(0, |mask, whole| mask | whole.sources),
            wholes,
        };
        if let Some(tolerance) = tolerance {
            model.tabulate(tolerance);
        }
        model.update()?;
        Ok(model)
    }

    /// Which variable the coordinate is.
    #[must_use]
    pub fn coordinate_index(&self) -> usize {
        let found = self.index_of(self.axes.coordinate);
        found.expect("every component has a coordinate")
    }

    /// Which variable a source is, if it is one.
    #[must_use]
    pub fn index_of(&self, source: Source) -> Option<usize> {
        let own = |place: &VariablePlace| matches!(place, VariablePlace::Source(other) if *other == source);
        self.places.iter().position(own)
    }

    /// Puts a table in the place of the closed form: parameters cannot be set any more.
    fn tabulate(&mut self, tolerance: f64) {
        let wanted = |(variable, place): (&Variable, &VariablePlace)| match place {
            VariablePlace::Result(slot) if variable.role == Role::Output && variable.kind == Type::Real => Some(*slot),
            _ => None,
        };
        let slots: Vec<Option<Slot>> = self.variables.iter().zip(&self.places).map(wanted).collect();
        let table = Interpolation::new(&*self.now.part, self.axes, &self.motion, &slots, tolerance);
        self.table = Some(Arc::new(table));
        for variable in &mut self.variables {
            if matches!(variable.role, Role::Parameter | Role::Tunable) {
                variable.role = Role::Calculated;
            }
        }
    }

    /// What a result may be off its closed form by, in SI, with the present inputs; zero where it is the closed form.
    #[must_use]
    pub fn bound(&self, index: usize) -> f64 {
        let table = self.table.as_ref();
        let bound = table.and_then(|table| table.bound(index, &*self.now.part));
        bound.unwrap_or(0.0)
    }

    /// The table, at its level.
    #[must_use]
    pub fn table(&self) -> Option<&Interpolation> {
        self.table.as_deref()
    }

    /// The component with its present sources.
    #[must_use]
    pub fn part(&self) -> &dyn Part {
        &*self.now.part
    }

    /// Whether there are derivatives in a direction.
    ///
    /// # Errors
    /// A change of a source that makes another component.
    pub fn smooth(&self, tangent: &Tangent) -> Result<(), Fault> {
        tangent.own::<Direction>().smooth()
    }

    /// Results of the whole range.
    #[must_use]
    pub fn wholes(&self) -> &[Spread] {
        &self.wholes
    }

    /// The same, to be changed.
    pub fn part_mut(&mut self) -> &mut dyn Part {
        &mut *self.now.part
    }

    /// What happened before, where results follow from it.
    pub(crate) fn memory(&self) -> &[Source] {
        &self.memory
    }

    /// The component that runs.
    ///
    /// # Panics
    /// For another one.
    #[must_use]
    pub fn of<T: Component>(&self) -> &Runner<T, f64> {
        let part: &dyn Any = self.part();
        part.downcast_ref().expect("the component of this mechanism")
    }

    /// The same, to be changed.
    pub(crate) fn of_mut<T: Component>(&mut self) -> &mut Runner<T, f64> {
        let part: &mut dyn Any = self.part_mut();
        part.downcast_mut().expect("the component of this mechanism")
    }

    /// The present time, in s.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.now.time
    }

    /// Where each variable stands.
    #[must_use]
    pub fn places(&self) -> &[VariablePlace] {
        &self.places
    }

    #[must_use]
    pub fn motion(&self) -> &Motion {
        &self.motion
    }

    #[must_use]
    pub fn coordinate(&self) -> Source {
        self.axes.coordinate
    }

    #[must_use]
    pub fn rate(&self) -> Source {
        self.axes.rate
    }

    #[inline]
    fn find(&self, index: usize) -> Result<VariablePlace, Fault> {
        let found = self.places.get(index).copied();
        found.ok_or_else(|| Fault::no_variable(index, self.places.len()))
    }

    /// Where a result of the whole range occurs.
    ///
    /// # Errors
    /// A configuration that does not exist in the range.
    pub fn spot(&self, place: usize) -> Result<Spot, Fault> {
        match self.now.spots[place] {
            Some(spot) => Ok(spot),
            None => self.wholes[place]
                .find(&*self.now.part, &self.motion)
                .map_err(|fault| *fault),
        }
    }

    /// A result by the table, where that has it. Out of the way of the closed form.
    #[inline(never)]
    fn interpolated(&self, index: usize) -> Result<Option<f64>, Fault> {
        let table = self.table.as_ref();
        let found = table.and_then(|table| Some((table, table.value(index, &*self.now.part)?)));
        found
            .map(|(table, value)| self.tabulated(table).map(|()| value))
            .transpose()
    }

    /// A result with its derivative along the direction of a tangent, in SI. Where it is searched for, and does not
    /// follow from what changes, its value is left out.
    ///
    /// # Errors
    /// Not a result, or a configuration that does not exist.
    pub fn with_derivative(&self, tangent: &mut Tangent, index: usize) -> Result<Dual64, Fault> {
        let direction: &mut Direction = tangent.own_mut();
        let variable = &self.variables[index];
        let none = || Err(Fault::new(format!("{variable} is no result: it has no derivative")));
        direction.smooth()?;
        let mut value = Dual64::from_re(0.0);
        let slot = match self.find(index)? {
            VariablePlace::Result(slot) => slot,
            // That which follows from the part of the range, and states.
            VariablePlace::Source(source) if matches!(variable.role, Role::Output | Role::State) => {
                return Ok(direction.face.take(source));
            }
            VariablePlace::Source(_) | VariablePlace::Part => return none(),
            VariablePlace::Whole(place) if self.wholes[place].sources & direction.moved == 0 => return Ok(value),
            VariablePlace::Whole(place) => {
                let spot = self.spot(place)?;
                let value = self.wholes[place].value(&mut *direction.face, &spot);
                return value.map_err(|fault| *fault);
            }
        };
        if self.is_searched(index) && slot.sources & direction.moved != 0 {
            return Err(self.searched(direction, variable, &slot));
        }
        // What it does not follow from does not change it.
        if self.is_searched(index) || direction.face.result(&slot, &mut value).is_ok() {
            return Ok(value);
        }
        // It goes on with what a search has not found yet.
        let mut part = self.now.part.duplicate();
        part.result(&slot, &mut value.re).map_err(|fault| *fault)?;
        direction.face = part.dual(true, &mut |source, _| direction.face.take(source).eps).0;
        match direction.face.result(&slot, &mut value) {
            Err(fault) if *fault == searched() => Err(self.searched(direction, variable, &slot)),
            found => found.map(|()| value).map_err(|fault| *fault),
        }
    }

    /// A result that a search finds changes with what moves in this direction.
    #[cold]
    fn searched(&self, direction: &Direction, variable: &Variable, slot: &Slot) -> Fault {
        let moves = |place: &VariablePlace| match place {
            VariablePlace::Source(source) => {
                slot.sources >> source.group & 1 == 1 && direction.face.take(*source).eps != 0.0
            }
            _ => false,
        };
        let by = self.places.iter().position(moves);
        let by = by.map_or(TIME.id.to_owned(), |index| self.variables[index].name());
        Fault::new(format!("{variable} is searched for: it has no derivative by {by}"))
    }

    /// Whether a variable is searched for, and so has no derivative by what it follows from.
    fn is_searched(&self, index: usize) -> bool {
        let stages = self.now.part.stages();
        matches!(self.places[index], VariablePlace::Result(slot) if stages[usize::from(slot.stage)].searched)
    }

    /// Whether the coordinate lies in the table.
    #[inline]
    fn tabulated(&self, table: &Interpolation) -> Result<(), Fault> {
        let at = self.now.part.take(self.axes.coordinate);
        let [from, to] = table.range();
        // A rounding of degrees is not an angle outside.
        if (from - 1e-12..=to + 1e-12).contains(&at) {
            return Ok(());
        }
        let symbol = self.variables[0].symbol;
        let shown = |value: f64| short(symbol.shown(value));
        Err(Fault::outside(format!(
            "{} = {} {unit} lies outside the table from {} to {} {unit}: widen the working range, or set fidelity = \"static\"",
            symbol.id,
            shown(at),
            shown(from),
            shown(to),
            unit = symbol.display.name
        )))
    }

    /// Follows the time, unless the coordinate has been set.
    #[inline]
    fn sweep(&mut self) {
        if !self.now.given {
            let rate = self.now.part.take(self.axes.rate);
            let at = self.motion.swept(rate, self.now.time);
            self.now.part.put(self.axes.coordinate, at);
        }
    }

    /// What is saved of the sources: what happened before, then all that can be set.
    fn saved(&self) -> impl Iterator<Item = Source> {
        let settable = self.variables.iter().zip(&self.places);
        let settable = settable.filter_map(|(variable, place)| match place {
            VariablePlace::Source(source) if variable.role != Role::Calculated => Some(*source),
            _ => None,
        });
        self.memory.iter().copied().chain(settable)
    }

    /// How fast each source changes in a direction.
    fn seeds<'a>(&'a self, seed: &'a dyn Fn(Quantity) -> f64) -> Seeds<'a> {
        let (coordinate, rate) = (self.axes.coordinate, self.axes.rate);
        // A coordinate that was not set follows from its rate and the time as well; one that was set changes with either
        // input.
        let of = |source: Source| {
            let found = self.index_of(source);
            found.map_or(0.0, |index| seed(self.variables[index].quantity()))
        };
        let moved = if self.now.given {
            let [start, end] = [0.0, 1.0].map(|part| self.motion.at(part));
            of(coordinate) + (end - start) * seed((&PART_OF_RANGE, None))
        } else {
            let speed = Dual64::new(self.now.part.take(rate), of(rate));
            let time = Dual64::new(self.now.time, seed((&TIME, None)));
            self.motion.swept(speed, time).eps + of(coordinate)
        };
        Seeds {
            seed,
            moved: (coordinate, moved),
            clock: self.clock,
            part: &*self.now.part,
            undoes: None,
        }
    }
}

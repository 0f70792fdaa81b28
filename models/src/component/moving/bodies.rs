//! Bodies that move each by itself between samples, by an implicit solver with steps of its own for each of them.

use std::any::Any;

use crate::component::moving::clock::Clock;
use crate::component::moving::{Carrier, Ramp};
use crate::component::part::Component;
use crate::component::running::Running;
use crate::component::stages::{Found, Source, Use};
use crate::component::standing::Standing;
use crate::kernel::variable::{Fault, Role};
use crate::parts::solver::rodas::{Run, Tolerance};
use crate::parts::solver::{Count, Halt, MOST_IMPLICIT, System};

/// First step of the solver after a change from outside, in s, and the greatest part that it is of a cycle.
const FIRST: f64 = 1e-3;
const FIRST_PART: f64 = 0.1;

/// A component of bodies with N states each, under samples.
pub trait BodiesInMotion<const N: usize>: Component + Clone {
    /// The equations of a body under present sources.
    type Body: System<N> + Copy + PartialEq + Send + Sync;

    /// # Errors
    /// Sources with which there are no bodies.
    fn bodies(known: &mut Self::Known<f64>) -> Found<&[Self::Body]>;

    fn schedule(given: &Self::Given<f64>) -> Schedule<N>;

    /// Whether states are such as a body can have.
    fn is_possible(body: &Self::Body, y: &[f64; N]) -> bool;

    /// The states of a body at rest where the inputs want it.
    ///
    /// # Errors
    /// Inputs with which there is no such place.
    fn resting(known: &mut Self::Known<f64>, body: usize) -> Found<[f64; N]>;

    /// A sample: commands follow from states and inputs.
    ///
    /// # Errors
    /// As [`resting`](BodiesInMotion::resting).
    fn sample(known: &mut Self::Known<f64>) -> Found<()>;

    /// Why a step of a size (s) from the present states could not be made.
    fn refusal(given: &Self::Given<f64>, halt: Halt, body: usize, size: f64) -> Fault;

    /// As [`Running::warning`], by the [least](System::least) of all bodies.
    fn warning(least: f64) -> Option<&'static str>;
}

/// How bodies are solved and sampled.
#[derive(Clone, Copy, Debug)]
pub struct Schedule<const N: usize> {
    /// From sample to sample, in s.
    pub period: f64,
    /// Longest step of the solver, in s.
    pub longest: f64,
    pub tolerance: Tolerance<N>,
}

/// All bodies with the solver's state beside them. The component has the states themselves.
#[derive(Clone)]
pub struct SampledBodies<T: BodiesInMotion<N>, const N: usize> {
    clock: Clock,
    runs: Vec<Run<N>>,
    /// Under which they were solved so far.
    bodies: Vec<T::Body>,
    /// How all was before a step that may fail; what the component remembers, with that before the step and at the start.
    before: Vec<Run<N>>,
    memory: Vec<(Source, [f64; 2])>,
}

impl<T: BodiesInMotion<N>, const N: usize> SampledBodies<T, N> {
    /// At rest where the inputs want them.
    ///
    /// # Errors
    /// As [`BodiesInMotion::resting`].
    pub fn new(model: &mut Standing) -> Result<SampledBodies<T, N>, Fault> {
        let memory = model.memory().iter();
        let mut own = SampledBodies {
            clock: Clock::STOPPED,
            runs: Vec::new(),
            bodies: Vec::new(),
            before: Vec::new(),
            memory: memory
                .map(|source| (*source, [model.part().take(*source); 2]))
                .collect(),
        };
        own.stand(model)?;
        Ok(own)
    }

    fn known(model: &mut Standing) -> &mut T::Known<f64> {
        &mut model.of_mut::<T>().0
    }

    fn schedule(model: &Standing) -> Schedule<N> {
        T::schedule(model.of::<T>().given())
    }

    fn stand(&mut self, model: &mut Standing) -> Result<(), Fault> {
        let first = first(Self::schedule(model).period);
        for (source, [_, start]) in &self.memory {
            model.part_mut().put(*source, *start);
        }
        let known = Self::known(model);
        self.bodies = T::bodies(known).map_err(|fault| *fault)?.to_vec();
        self.runs.clear();
        for i in 0..self.bodies.len() {
            let y = T::resting(known, i).map_err(|fault| *fault)?;
            put_states::<T, N>(known, i, &y);
            self.runs.push(Run::new(y, first));
        }
        (self.clock, self.before) = (Clock::STOPPED, self.runs.clone());
        Ok(())
    }

    fn sample(&mut self, model: &mut Standing, time: f64) -> Result<(), Fault> {
        model.update()?;
        T::sample(Self::known(model)).map_err(|fault| *fault)?;
        self.clock = self.clock.sampled(Self::schedule(model).period, time);
        self.changed_bodies(model, false);
        Ok(())
    }

    /// What was solved ahead of a body is dropped where its states or its equations are others: an importer that repeats
    /// itself changes nothing.
    fn changed_bodies(&mut self, model: &mut Standing, is_state: bool) {
        let first = first(Self::schedule(model).period);
        let known = Self::known(model);
        if is_state {
            for (i, run) in self.runs.iter_mut().enumerate() {
                let y = std::array::from_fn(|k| T::take(known, state::<T, N>(i, k)));
                if y != run.states() {
                    *run = Run::new(y, first);
                }
            }
        }
        // Where there are no bodies, the next call that needs one says why.
        let Ok(bodies) = T::bodies(known) else { return };
        for ((run, old), new) in self.runs.iter_mut().zip(&mut self.bodies).zip(bodies) {
            if old != new {
                *old = *new;
                run.interrupt(first);
            }
        }
    }

    fn solve(&mut self, model: &mut Standing, from: f64, to: f64) -> Result<(), Fault> {
        let period = Self::schedule(model).period;
        let refusal = |model: &Standing, halt, body| T::refusal(model.of::<T>().given(), halt, body, to - from);
        if (to - from) / period * self.runs.len() as f64 > f64::from(MOST_IMPLICIT) {
            return Err(refusal(model, Halt::TooMany, 0));
        }
        model.update()?;
        let mut time = from;
        while time < to {
            if self.clock.is_due(period, time) {
                model.set_time(time);
                self.sample(model, time)?;
            }
            let end = self.clock.next_before(period, to).unwrap_or(to);
            let Schedule { longest, tolerance, .. } = Self::schedule(model);
            for (i, (run, body)) in self.runs.iter_mut().zip(&self.bodies).enumerate() {
                let solved = run.advance(body, &tolerance, end - time, longest);
                let y = run.states();
                put_states::<T, N>(Self::known(model), i, &y);
                let possible = T::is_possible(body, &y).then_some(()).ok_or(Halt::Outside);
                solved.and(possible).map_err(|halt| refusal(model, halt, i))?;
            }
            time = end;
        }
        model.set_time(to);
        model.update()
    }
}

/// A state of a body.
fn state<T: BodiesInMotion<N>, const N: usize>(body: usize, state: usize) -> Source {
    let group = const {
        let mut group = 0;
        while !matches!(T::GROUPS[group].1, Use::State) {
            group += 1;
        }
        group as u8
    };
    Source {
        group,
        place: (body * N + state) as u16,
    }
}

fn put_states<T: BodiesInMotion<N>, const N: usize>(known: &mut T::Known<f64>, body: usize, y: &[f64; N]) {
    for (k, y) in y.iter().enumerate() {
        T::put(known, state::<T, N>(body, k), *y);
    }
}

/// First step of the solver after a change from outside, in s, at a cycle (s).
fn first(period: f64) -> f64 {
    FIRST.min(period * FIRST_PART)
}

impl<T: BodiesInMotion<N>, const N: usize> Carrier for SampledBodies<T, N> {
    fn advance(&mut self, model: &mut Standing, [from, to]: [f64; 2], _: &[Ramp]) -> Result<(), Fault> {
        let clock = self.clock;
        self.before.copy_from_slice(&self.runs);
        for (source, [before, _]) in &mut self.memory {
            *before = model.part().take(*source);
        }
        let solved = self.solve(model, from, to);
        if solved.is_err() {
            self.clock = clock;
            self.runs.copy_from_slice(&self.before);
            for (source, [before, _]) in &self.memory {
                model.part_mut().put(*source, *before);
            }
            for (i, run) in self.runs.iter().enumerate() {
                put_states::<T, N>(Self::known(model), i, &run.states());
            }
            model.set_time(from);
            self.resume(model);
        }
        solved
    }

    fn longest(&self, model: &Standing) -> f64 {
        Self::schedule(model).period
    }

    fn place(&mut self, model: &mut Standing, value: f64) -> Result<(), Fault> {
        model.set(model.coordinate_index(), value)?;
        self.stand(model)
    }

    fn event(&mut self, model: &mut Standing) -> Result<bool, Fault> {
        let time = model.time();
        if self.clock.is_due(Self::schedule(model).period, time) {
            self.sample(model, time)?;
        }
        Ok(false)
    }

    fn next_event(&self, model: &Standing) -> Option<f64> {
        self.clock.next(Self::schedule(model).period)
    }

    fn warning(&self) -> Option<&'static str> {
        let each = self.runs.iter().zip(&self.bodies);
        let least = each.map(|(run, body)| run.least.min(body.least(&run.states())));
        T::warning(least.fold(f64::INFINITY, f64::min))
    }

    fn changed(&mut self, model: &mut Standing, which: Option<usize>) {
        let is_state = which.is_none_or(|index| model.variables()[index].role == Role::State);
        self.changed_bodies(model, is_state);
    }

    fn resume(&mut self, model: &mut Standing) {
        if let Ok(bodies) = T::bodies(Self::known(model)) {
            self.bodies.copy_from_slice(bodies);
        }
    }

    fn step_size(&self, model: &Standing) -> f64 {
        Self::schedule(model).period
    }

    fn count(&self) -> Count {
        self.runs.iter().fold(Count::default(), |sum, run| sum.and(run.count))
    }

    fn numbers(&self) -> Vec<f64> {
        let runs = self.runs.iter().flat_map(Run::numbers);
        std::iter::once(self.clock.number()).chain(runs).collect()
    }

    fn take(&mut self, numbers: &[f64]) -> Option<()> {
        let (&clock, runs) = numbers.split_first()?;
        self.clock = Clock::of(clock)?;
        let each = runs.chunks_exact(runs.len() / self.runs.len());
        for (run, numbers) in self.runs.iter_mut().zip(each) {
            *run = Run::of(numbers).filter(|_| numbers.iter().all(|x| x.is_finite()))?;
        }
        Some(())
    }

    fn follow(&mut self, other: &dyn Carrier) {
        let other: &dyn Any = other;
        let other: &SampledBodies<T, N> = other.downcast_ref().expect("the same component");
        self.clock = other.clock;
        self.runs.copy_from_slice(&other.runs);
    }

    fn duplicate(&self) -> Box<dyn Carrier> {
        Box::new(self.clone())
    }
}

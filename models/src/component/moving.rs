//! A component that moves by itself: states are sources of its equations, their rates and what ends a smooth piece of
//! the motion are results of them, and what follows at an event the component decides.

use std::cell::RefCell;

use crate::component::part::Part;
use crate::component::running::{Running, State, Tangent};
use crate::component::stages::{Slot, Source};
use crate::component::standing::{Standing, VariablePlace};
use crate::kernel::number::short;
use crate::kernel::variable::{Fault, Quantity, Role, Terminal, Variable};
use crate::parts::solver::pieces::{self, Pieces};
use crate::parts::solver::{Count, Halt, MOST_STEPS};

/// Most states of a component, and most numbers that it remembers.
const MOST: usize = 8;

/// A scene's component in motion.
#[derive(Clone)]
pub struct MovingComponent {
    standing: Standing,
    /// Each with the variable that it is, and with its rate.
    states: Vec<(Source, usize, Slot)>,
    indicators: Vec<Slot>,
    /// What happened before, and what that is at the start.
    memory: Vec<(Source, f64)>,
    /// Longest step of the solver, in s.
    longest: f64,
    count: Count,
}

/// States, and what happened before.
#[derive(Clone, Copy)]
struct Instant {
    y: [f64; MOST],
    past: [f64; MOST],
}

/// The component under present inputs, for the solver.
struct Equations<'a> {
    part: RefCell<&'a mut dyn Part>,
    states: &'a [(Source, usize, Slot)],
    indicators: &'a [Slot],
    memory: &'a [(Source, f64)],
}

impl Equations<'_> {
    /// The component at an instant.
    fn with<R>(&self, state: &Instant, y: &[f64; MOST], of: impl FnOnce(&mut dyn Part) -> Option<R>) -> Option<R> {
        let mut part = self.part.borrow_mut();
        for ((source, _), past) in self.memory.iter().zip(state.past) {
            part.put(*source, past);
        }
        for ((source, ..), y) in self.states.iter().zip(y) {
            part.put(*source, *y);
        }
        part.update().ok()?;
        of(&mut **part)
    }
}

impl Pieces<MOST, Instant> for Equations<'_> {
    fn states(state: &mut Instant) -> &mut [f64; MOST] {
        &mut state.y
    }

    fn rates(&self, state: &Instant, y: &[f64; MOST]) -> Option<[f64; MOST]> {
        self.with(state, y, |part| {
            let mut rates = [0.0; MOST];
            for ((_, _, slot), rate) in self.states.iter().zip(&mut rates) {
                part.result(slot, rate).ok()?;
            }
            Some(rates)
        })
    }

    fn crossed(&self, state: &Instant, y: &[f64; MOST]) -> bool {
        let fallen = self.with(state, y, |part| {
            let mut fallen = false;
            for slot in self.indicators {
                let mut z = 0.0;
                part.result(slot, &mut z).ok()?;
                fallen |= z.is_nan() || z < 0.0;
            }
            Some(fallen)
        });
        fallen.unwrap_or(true)
    }

    fn event(&self, state: &mut Instant) -> Result<(), Halt> {
        let decided = self.with(state, &state.y, |part| {
            part.decide().ok()?;
            let mut after = *state;
            for ((source, ..), y) in self.states.iter().zip(&mut after.y) {
                *y = part.take(*source);
            }
            for ((source, _), past) in self.memory.iter().zip(&mut after.past) {
                *past = part.take(*source);
            }
            Some(after)
        });
        *state = decided.ok_or(Halt::Outside)?;
        Ok(())
    }
}

impl MovingComponent {
    /// From the start of its states, with the longest step of the solver (s).
    ///
    /// # Errors
    /// A motion that cannot begin there.
    ///
    /// # Panics
    /// For a component with more states or memory than there is room for, or without the rate of a state.
    pub fn new(standing: Standing, start: &[f64], longest: f64) -> Result<MovingComponent, Fault> {
        let standing = standing.with_states();
        let slot = |index: usize| match standing.places()[index] {
            VariablePlace::Result(slot) => slot,
            _ => unreachable!("rates and indicators are results"),
        };
        let of = |role: Role| {
            let variables = standing.variables().iter();
            let found = variables.enumerate().filter(move |(_, variable)| variable.role == role);
            found.map(|(index, _)| index)
        };
        let source = |index: usize| match standing.places()[index] {
            VariablePlace::Source(source) => source,
            _ => unreachable!("states are sources"),
        };
        let pairs = of(Role::State).zip(of(Role::Rate));
        let states: Vec<_> = pairs.map(|(state, rate)| (source(state), state, slot(rate))).collect();
        assert!(states.len().max(standing.memory().len()) <= MOST, "no room");
        let mut model = MovingComponent {
            states,
            indicators: of(Role::Indicator).map(slot).collect(),
            memory: standing
                .memory()
                .iter()
                .map(|source| (*source, standing.part().take(*source)))
                .collect(),
            standing,
            longest,
            count: Count::default(),
        };
        model.set_states(start)?;
        model.start()?;
        Ok(model)
    }

    /// As it stands.
    #[must_use]
    pub fn standing(&self) -> &Standing {
        &self.standing
    }

    fn instant(&self) -> Instant {
        let part = self.standing.part();
        let mut instant = Instant {
            y: [0.0; MOST],
            past: [0.0; MOST],
        };
        for ((source, ..), y) in self.states.iter().zip(&mut instant.y) {
            *y = part.take(*source);
        }
        for ((source, _), past) in self.memory.iter().zip(&mut instant.past) {
            *past = part.take(*source);
        }
        instant
    }

    fn refusal(&self, halt: Halt, size: f64) -> Fault {
        let coordinate = self.standing.coordinate_index();
        let at = self.standing.part().take(self.standing.coordinate());
        let symbol = self.standing.variables()[coordinate].symbol;
        let (from, size, step) = (
            format!("{} = {}", symbol.id, symbol.written(at)),
            short(size),
            short(self.longest),
        );
        Fault::outside(match halt {
            Halt::Outside => format!(
                "the motion from {from} ends within {size} s beyond all reasonable numbers: command less, or limit it"
            ),
            Halt::TooFast => format!(
                "inner steps of {step} s are too long for the motion from {from}, which changes by more than itself \
                 within one: set step below {} s, or make the friction less",
                short(self.longest / 2.0)
            ),
            Halt::TooSmall | Halt::TooMany => format!(
                "the step of {size} s from {from} needs more than the {MOST_STEPS} inner steps that are allowed, at \
                 step = {step} s: take smaller communication steps, or a longer step"
            ),
        })
    }
}

impl Running for MovingComponent {
    fn variables(&self) -> &[Variable] {
        self.standing.variables()
    }

    fn terminals(&self) -> Vec<Terminal> {
        self.standing.terminals()
    }

    fn positions(&self) -> Vec<f64> {
        self.standing.positions()
    }

    fn stop_time(&self) -> f64 {
        self.standing.stop_time()
    }

    fn step_size(&self) -> f64 {
        self.standing.step_size()
    }

    fn get(&mut self, index: usize) -> Result<f64, Fault> {
        self.standing.get(index)
    }

    fn check(&self, index: usize, value: f64) -> Result<(), Fault> {
        self.standing.check(index, value)
    }

    fn set(&mut self, index: usize, value: f64) -> Result<(), Fault> {
        self.standing.set(index, value)
    }

    fn set_time(&mut self, time: f64) {
        self.standing.set_time(time);
    }

    fn advance(&mut self, from: f64, to: f64) -> Result<(), Fault> {
        self.standing.update()?;
        let before = self.instant();
        let mut state = before;
        let equations = Equations {
            memory: &self.memory,
            part: RefCell::new(self.standing.part_mut()),
            states: &self.states,
            indicators: &self.indicators,
        };
        let solved = pieces::advance(&equations, &mut state, to - from, self.longest);
        let end = if solved.is_ok() { &state } else { &before };
        // Where it was, it can be again.
        let _ = equations.with(end, &end.y, |_| Some(()));
        let count = solved.map_err(|halt| self.refusal(halt, to - from))?;
        self.count = self.count.and(count);
        self.set_time(to);
        Ok(())
    }

    /// Passed at the speed of the working range, all other states as they are, and nothing has happened before.
    fn place(&mut self, value: f64) -> Result<(), Fault> {
        for (source, start) in &self.memory {
            self.standing.part_mut().put(*source, *start);
        }
        let mut states = self.instant().y;
        (states[0], states[1]) = (value, self.standing.motion().speed);
        self.set_states(&states[..self.states.len()])?;
        self.event().map(|_| ())
    }

    fn start(&mut self) -> Result<(), Fault> {
        self.standing.start()?;
        self.event().map(|_| ())
    }

    fn update(&mut self) -> Result<(), Fault> {
        self.standing.update()
    }

    fn event(&mut self) -> Result<bool, Fault> {
        self.standing.part_mut().decide().map_err(|fault| *fault)
    }

    fn states(&self) -> usize {
        self.states.len()
    }

    fn count(&self) -> Count {
        self.count
    }

    fn get_states(&self, states: &mut [f64]) {
        states.copy_from_slice(&self.instant().y[..self.states.len()]);
    }

    fn set_states(&mut self, states: &[f64]) -> Result<(), Fault> {
        for ((_, index, _), value) in self.states.iter().zip(states) {
            self.standing.check(*index, *value)?;
        }
        for ((source, ..), value) in self.states.iter().zip(states) {
            self.standing.part_mut().put(*source, *value);
        }
        Ok(())
    }

    fn nominals(&self, nominals: &mut [f64]) {
        nominals.fill(1.0);
    }

    fn rates(&mut self, rates: &mut [f64]) -> Result<(), Fault> {
        for ((_, _, slot), rate) in self.states.iter().zip(rates) {
            let found = self.standing.part_mut().result(slot, rate);
            found.map_err(|fault| *fault)?;
        }
        Ok(())
    }

    fn indicators(&self) -> usize {
        self.standing.indicators()
    }

    fn event_indicators(&mut self, indicators: &mut [f64]) -> Result<(), Fault> {
        self.standing.event_indicators(indicators)
    }

    fn state(&self) -> State {
        self.standing.state()
    }

    fn state_into(&self, state: &mut State) {
        self.standing.state_into(state);
    }

    fn set_state(&mut self, state: &State) {
        self.standing.set_state(state);
    }

    fn numbers(&self, state: &State) -> Vec<f64> {
        self.standing.numbers(state)
    }

    fn state_of(&self, numbers: &[f64]) -> Result<State, Fault> {
        self.standing.state_of(numbers)
    }

    fn has_derivatives(&self) -> bool {
        self.standing.has_derivatives()
    }

    fn tangent(&self, seed: &dyn Fn(Quantity) -> f64) -> Tangent {
        self.standing.tangent(seed)
    }

    fn tangent_into(&self, seed: &dyn Fn(Quantity) -> f64, tangent: &mut Tangent) {
        self.standing.tangent_into(seed, tangent);
    }

    fn derivative(&self, tangent: &mut Tangent, index: usize) -> Result<f64, Fault> {
        self.standing.derivative(tangent, index)
    }

    fn duplicate(&self) -> Box<dyn Running> {
        Box::new(self.clone())
    }
}

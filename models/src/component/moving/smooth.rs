//! A motion in smooth pieces, each ended by an event at which the component decides what follows.

use std::cell::{Cell, RefCell};

use crate::component::moving::{Carrier, Ramp, results, states};
use crate::component::part::Part;
use crate::component::running::Running;
use crate::component::stages::{Slot, Source};
use crate::component::standing::Standing;
use crate::kernel::number::short;
use crate::kernel::variable::{Fault, Role};
use crate::parts::solver::pieces::{self, Pieces};
use crate::parts::solver::{Count, Halt, MOST_STEPS};

/// Most states of a component, and most numbers that it remembers.
const MOST: usize = 16;

/// How a component is carried on from event to event.
#[derive(Clone)]
pub struct SmoothPieces {
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
    own: &'a SmoothPieces,
    ramps: &'a [Ramp],
    /// What the component said last of a configuration that does not exist.
    said: Cell<Option<Box<Fault>>>,
}

impl Equations<'_> {
    /// The component at an instant, a time (s) after the start.
    fn with<R>(
        &self,
        time: f64,
        state: &Instant,
        y: &[f64; MOST],
        of: impl FnOnce(&mut dyn Part) -> Option<R>,
    ) -> Option<R> {
        let mut part = self.part.borrow_mut();
        for ((source, _), past) in self.own.memory.iter().zip(state.past) {
            part.put(*source, past);
        }
        for ((source, ..), y) in self.own.states.iter().zip(y) {
            part.put(*source, *y);
        }
        for ramp in self.ramps {
            part.put(ramp.source, ramp.value + ramp.slope * time);
        }
        match part.update() {
            Ok(()) => of(&mut **part),
            Err(fault) => {
                self.said.set(Some(fault));
                None
            }
        }
    }
}

impl Pieces<MOST, Instant> for Equations<'_> {
    fn states(state: &mut Instant) -> &mut [f64; MOST] {
        &mut state.y
    }

    fn rates(&self, time: f64, state: &Instant, y: &[f64; MOST]) -> Option<[f64; MOST]> {
        self.with(time, state, y, |part| {
            let mut rates = [0.0; MOST];
            for ((_, _, slot), rate) in self.own.states.iter().zip(&mut rates) {
                part.result(slot, rate).ok()?;
            }
            Some(rates)
        })
    }

    fn is_forced(&self) -> bool {
        !self.ramps.is_empty()
    }

    fn crossed(&self, time: f64, state: &Instant, y: &[f64; MOST]) -> bool {
        let fallen = self.with(time, state, y, |part| {
            let mut fallen = false;
            for slot in &self.own.indicators {
                let mut z = 0.0;
                part.result(slot, &mut z).ok()?;
                fallen |= z.is_nan() || z < 0.0;
            }
            Some(fallen)
        });
        fallen.unwrap_or(true)
    }

    fn event(&self, time: f64, state: &mut Instant) -> Result<(), Halt> {
        let decided = self.with(time, state, &state.y, |part| {
            if let Err(fault) = part.decide() {
                self.said.set(Some(fault));
                return None;
            }
            Some(self.own.instant(part))
        });
        *state = decided.ok_or(Halt::Outside)?;
        Ok(())
    }
}

impl SmoothPieces {
    /// From the start of a component's states, with the longest step of the solver (s).
    ///
    /// # Errors
    /// A motion that cannot begin there.
    ///
    /// # Panics
    /// For a component with more states or memory than there is room for.
    pub fn new(model: &mut Standing, start: &[f64], longest: f64) -> Result<SmoothPieces, Fault> {
        let memory = model.memory().iter();
        let own = SmoothPieces {
            states: states(model),
            indicators: results(model, Role::Indicator).collect(),
            memory: memory.map(|source| (*source, model.part().take(*source))).collect(),
            longest,
            count: Count::default(),
        };
        assert!(own.states.len().max(own.memory.len()) <= MOST, "no room");
        own.put(model, start)?;
        model.start()?;
        decide(model)?;
        Ok(own)
    }

    fn put(&self, model: &mut Standing, states: &[f64]) -> Result<(), Fault> {
        for ((_, index, _), value) in self.states.iter().zip(states) {
            model.check(*index, *value)?;
        }
        for ((source, ..), value) in self.states.iter().zip(states) {
            model.part_mut().put(*source, *value);
        }
        Ok(())
    }

    fn instant(&self, part: &dyn Part) -> Instant {
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

    fn refusal(&self, model: &Standing, halt: Halt, size: f64, said: Option<Box<Fault>>) -> Fault {
        let coordinate = model.coordinate_index();
        let at = model.part().take(model.coordinate());
        let symbol = model.variables()[coordinate].symbol;
        let (from, size, step) = (
            format!("{} = {}", symbol.id, symbol.written(at)),
            short(size),
            short(self.longest),
        );
        Fault::outside(match (halt, said) {
            (Halt::Outside, Some(fault)) => format!("the motion from {from} ends within {size} s: {}", fault.message),
            (Halt::Outside, None) => format!(
                "the motion from {from} ends within {size} s beyond all reasonable numbers: command less, or limit it"
            ),
            (Halt::TooFast, _) => format!(
                "inner steps of {step} s are too long for the motion from {from}, which changes by more than itself \
                 within one: set step below {} s, or make the friction less",
                short(self.longest / 2.0)
            ),
            (Halt::TooSmall | Halt::TooMany, _) => format!(
                "the step of {size} s from {from} needs more than the {MOST_STEPS} inner steps that are allowed, at \
                 step = {step} s: take smaller communication steps, or a longer step"
            ),
        })
    }
}

fn decide(model: &mut Standing) -> Result<bool, Fault> {
    model.part_mut().decide().map_err(|fault| *fault)
}

impl SmoothPieces {
    /// Nothing has happened before.
    fn begin(&mut self, model: &mut Standing) {
        for (source, start) in &self.memory {
            model.part_mut().put(*source, *start);
        }
    }
}

impl Carrier for SmoothPieces {
    fn advance(&mut self, model: &mut Standing, [from, to]: [f64; 2], ramps: &[Ramp]) -> Result<(), Fault> {
        model.update()?;
        let before = self.instant(model.part());
        let mut state = before;
        let equations = Equations {
            part: RefCell::new(model.part_mut()),
            own: self,
            ramps,
            said: Cell::default(),
        };
        let solved = pieces::advance(&equations, &mut state, to - from, self.longest);
        let (end, time) = if solved.is_ok() {
            (&state, to - from)
        } else {
            (&before, 0.0)
        };
        // Where it was, it can be again.
        let _ = equations.with(time, end, &end.y, |_| Some(()));
        let said = equations.said.take();
        let count = solved.map_err(|halt| self.refusal(model, halt, to - from, said))?;
        self.count = self.count.and(count);
        model.set_time(to);
        Ok(())
    }

    /// Passed at the speed of the working range where that is a state, all other states as they are.
    fn place(&mut self, model: &mut Standing, value: f64) -> Result<(), Fault> {
        self.begin(model);
        let mut states = self.instant(model.part()).y;
        states[0] = value;
        if self.states.get(1).is_some_and(|(source, ..)| *source == model.rate()) {
            states[1] = model.motion().speed;
        }
        self.put(model, &states)?;
        decide(model).map(|_| ())
    }

    fn start(&mut self, model: &mut Standing) -> Result<(), Fault> {
        decide(model).map(|_| ())
    }

    fn event(&mut self, model: &mut Standing) -> Result<bool, Fault> {
        decide(model)
    }

    fn count(&self) -> Count {
        self.count
    }

    fn longest(&self, _: &Standing) -> f64 {
        self.longest
    }

    fn duplicate(&self) -> Box<dyn Carrier> {
        Box::new(self.clone())
    }
}

//! A component that moves by itself: states are sources of its equations, their rates and what ends a smooth piece of
//! the motion are results of them, and what follows at an event the component decides.

pub mod bodies;
pub mod clock;
mod commands;
mod following;
pub mod sampled;
pub mod smooth;

use std::any::Any;

pub use crate::component::moving::commands::Ramp;
use crate::component::moving::commands::{Commands, Followed};
use crate::component::running::{Running, State, Tangent};
use crate::component::stages::{Slot, Source};
use crate::component::standing::{Standing, VariablePlace};
use crate::kernel::number::short;
use crate::kernel::unit;
use crate::kernel::variable::{Fault, Quantity, Role, Terminal, Variable};
use crate::parts::solver::Count;

/// How the states of a component are carried on in time, with all that its solver keeps.
pub trait Carrier: Any + Send {
    /// Moves from one time to another, both in s, while some inputs change steadily; what fails changes nothing.
    ///
    /// # Errors
    /// As [`Running::advance`].
    fn advance(&mut self, model: &mut Standing, times: [f64; 2], ramps: &[Ramp]) -> Result<(), Fault>;

    /// Longest step of its solver, in s.
    fn longest(&self, model: &Standing) -> f64;

    /// Brings the component to a value of its coordinate; nothing has happened before.
    ///
    /// # Errors
    /// As [`Running::place`].
    fn place(&mut self, model: &mut Standing, value: f64) -> Result<(), Fault>;

    /// Begins the motion.
    ///
    /// # Errors
    /// As [`Running::start`].
    fn start(&mut self, _: &mut Standing) -> Result<(), Fault> {
        Ok(())
    }

    /// As [`Running::update`].
    ///
    /// # Errors
    /// As there.
    fn update(&mut self, model: &mut Standing) -> Result<(), Fault> {
        model.update()
    }

    /// As [`Running::event`].
    ///
    /// # Errors
    /// A configuration that does not exist.
    fn event(&mut self, model: &mut Standing) -> Result<bool, Fault>;

    /// As [`Running::next_event`].
    fn next_event(&self, _: &Standing) -> Option<f64> {
        None
    }

    /// As [`Running::warning`].
    fn warning(&self) -> Option<&'static str> {
        None
    }

    /// A source has become another, or a state has been set: the variable, or `None` for all states.
    fn changed(&mut self, _: &mut Standing, _: Option<usize>) {}

    /// A sample holds something else.
    fn latched(&mut self, _: &mut Standing) {}

    /// The component was brought to where it was when this was kept.
    fn resume(&mut self, _: &mut Standing) {}

    /// As [`Running::step_size`].
    fn step_size(&self, model: &Standing) -> f64 {
        model.step_size()
    }

    fn count(&self) -> Count;

    /// As [`Running::inertia`].
    ///
    /// # Errors
    /// As there.
    fn inertia(&self, _: &mut Standing) -> Result<f64, Fault> {
        Ok(0.0)
    }

    /// What is saved besides the component's own state.
    fn numbers(&self) -> Vec<f64> {
        Vec::new()
    }

    /// Takes back as many numbers; `None` where they cannot be.
    fn take(&mut self, _: &[f64]) -> Option<()> {
        Some(())
    }

    /// Becomes what another one of the same component is, as far as it belongs to the state.
    fn follow(&mut self, _: &dyn Carrier) {}

    fn duplicate(&self) -> Box<dyn Carrier>;
}

impl Clone for Box<dyn Carrier> {
    fn clone(&self) -> Box<dyn Carrier> {
        self.duplicate()
    }
}

/// A scene's component in motion.
#[derive(Clone)]
pub struct MovingComponent {
    standing: Standing,
    /// Each with the variable that it is, and with its rate.
    states: Vec<(Source, usize, Slot)>,
    carrier: Box<dyn Carrier>,
    commands: Option<Commands>,
}

/// Most of a cycle that a step of its experiment takes.
const STEP_PART: f64 = 0.01;

/// All that changes while it runs, but how far commands have been followed.
struct OwnState {
    standing: State,
    carrier: Box<dyn Carrier>,
}

/// The same with that.
struct Saved {
    own: OwnState,
    followed: Option<Followed>,
}

/// The results of a role, as variables and in the component.
fn results(standing: &Standing, role: Role) -> impl Iterator<Item = Slot> {
    let all = standing.variables().iter().zip(standing.places());
    all.filter(move |(variable, _)| variable.role == role)
        .map(|(_, place)| match place {
            VariablePlace::Result(slot) => *slot,
            _ => unreachable!("rates and indicators are results"),
        })
}

/// The states, as variables and in the component.
fn sources(standing: &Standing) -> impl Iterator<Item = (Source, usize)> {
    let all = standing.variables().iter().zip(standing.places()).enumerate();
    all.filter_map(|(index, (variable, place))| match place {
        VariablePlace::Source(source) if variable.role == Role::State => Some((*source, index)),
        _ => None,
    })
}

/// The states, each with the variable that it is and with its rate.
fn states(standing: &Standing) -> Vec<(Source, usize, Slot)> {
    let rates = results(standing, Role::Rate);
    sources(standing)
        .zip(rates)
        .map(|((source, index), slot)| (source, index, slot))
        .collect()
}

impl MovingComponent {
    /// With what carries it on, made where it begins.
    ///
    /// # Errors
    /// A motion that cannot begin there.
    pub fn new(
        standing: Standing,
        carrier: impl FnOnce(&mut Standing) -> Result<Box<dyn Carrier>, Fault>,
    ) -> Result<MovingComponent, Fault> {
        let mut standing = standing.with_states();
        Ok(MovingComponent {
            carrier: carrier(&mut standing)?,
            states: states(&standing),
            standing,
            commands: None,
        })
    }

    /// As it stands.
    #[must_use]
    pub fn standing(&self) -> &Standing {
        &self.standing
    }

    /// The same, to be changed, with what carries it on.
    pub(crate) fn parts(&mut self) -> (&mut Standing, &mut dyn Carrier) {
        (&mut self.standing, &mut *self.carrier)
    }

    fn own_state(&self) -> OwnState {
        OwnState {
            standing: self.standing.state(),
            carrier: self.carrier.duplicate(),
        }
    }

    fn set_own_state(&mut self, OwnState { standing, carrier }: &OwnState) {
        self.standing.set_state(standing);
        self.carrier.follow(&**carrier);
        self.carrier.resume(&mut self.standing);
    }

    fn numbers_of(&self, OwnState { standing, carrier }: &OwnState) -> Vec<f64> {
        let mut numbers = self.standing.numbers(standing);
        numbers.extend(carrier.numbers());
        numbers
    }

    fn own_numbers(&self) -> Vec<f64> {
        self.numbers_of(&self.own_state())
    }

    fn own_state_of(&self, numbers: &[f64]) -> Result<OwnState, Fault> {
        let mut carrier = self.carrier.duplicate();
        let standing = numbers.len().checked_sub(carrier.numbers().len()).ok_or_else(foreign)?;
        let (standing, own) = numbers.split_at(standing);
        carrier.take(own).ok_or_else(foreign)?;
        Ok(OwnState {
            standing: self.standing.state_of(standing)?,
            carrier,
        })
    }
}

fn foreign() -> Fault {
    Fault::new("a saved state does not belong to this model")
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

    /// Commands over time end their cycle.
    fn stop_time(&self) -> f64 {
        (self.commands.as_ref()).map_or_else(|| self.standing.stop_time(), Commands::end)
    }

    /// Of a cycle no more than a part.
    fn step_size(&self) -> f64 {
        let own = self.carrier.step_size(&self.standing);
        (self.commands.as_ref()).map_or(own, |commands| own.min(STEP_PART * commands.end()))
    }

    fn get(&mut self, index: usize) -> Result<f64, Fault> {
        self.standing.get(index)
    }

    fn check(&self, index: usize, value: f64) -> Result<(), Fault> {
        self.not_told(index)?;
        self.standing.check(index, value)
    }

    fn set(&mut self, index: usize, value: f64) -> Result<(), Fault> {
        self.check(index, value)?;
        let before = self.standing.get(index);
        self.standing.set(index, value)?;
        if self.standing.variables()[index].role == Role::State || before != Ok(value) {
            self.interrupt();
            self.carrier.changed(&mut self.standing, Some(index));
        }
        Ok(())
    }

    fn set_time(&mut self, time: f64) {
        self.standing.set_time(time);
        self.command(time);
    }

    fn advance(&mut self, from: f64, to: f64) -> Result<(), Fault> {
        let Some(commands) = &self.commands else {
            return self.carrier.advance(&mut self.standing, [from, to], &[]);
        };
        let (now, before) = (commands.now.clone(), self.own_state());
        self.follow(now.clone(), [from, to]).inspect_err(|_| {
            self.set_own_state(&before);
            if let Some(commands) = &mut self.commands {
                commands.now = now;
            }
        })
    }

    fn place(&mut self, value: f64) -> Result<(), Fault> {
        self.interrupt();
        self.carrier.place(&mut self.standing, value)
    }

    fn start(&mut self) -> Result<(), Fault> {
        if self.commands.is_some() {
            self.pass(self.standing.time())?;
        }
        self.standing.start()?;
        self.carrier.start(&mut self.standing)
    }

    fn update(&mut self) -> Result<(), Fault> {
        self.carrier.update(&mut self.standing)
    }

    fn event(&mut self) -> Result<bool, Fault> {
        let time = self.standing.time();
        let jumped = self.pass(time)?;
        // What is shown goes on as it would without being shown.
        let shown = self
            .commands
            .as_ref()
            .is_some_and(|commands| commands.now.shown == time);
        if jumped && !shown {
            self.interrupt();
        }
        Ok(jumped)
    }

    fn next_event(&self) -> Option<f64> {
        let own = self.carrier.next_event(&self.standing);
        own.into_iter().chain(self.next_break()).reduce(f64::min)
    }

    fn next_break(&self) -> Option<f64> {
        self.commands.as_ref().and_then(Commands::next)
    }

    fn warning(&self) -> Option<&'static str> {
        self.carrier.warning()
    }

    fn states(&self) -> usize {
        self.states.len()
    }

    fn count(&self) -> Count {
        self.carrier.count()
    }

    fn get_states(&self, states: &mut [f64]) {
        for ((source, ..), y) in self.states.iter().zip(states) {
            *y = self.standing.part().take(*source);
        }
    }

    fn set_states(&mut self, states: &[f64]) -> Result<(), Fault> {
        for ((_, index, _), value) in self.states.iter().zip(states) {
            if !value.is_finite() {
                let variable = &self.standing.variables()[*index];
                return Err(Fault::outside(format!("{variable} = {} is not finite", short(*value))));
            }
        }
        for ((source, ..), value) in self.states.iter().zip(states) {
            self.standing.part_mut().put(*source, *value);
        }
        self.interrupt();
        self.carrier.changed(&mut self.standing, None);
        Ok(())
    }

    fn nominals(&self, nominals: &mut [f64]) {
        for ((_, index, _), nominal) in self.states.iter().zip(nominals) {
            let unit = self.standing.variables()[*index].symbol.unit;
            *nominal = match unit.name {
                name if name == unit::PA.name => 1e5,
                name if name == unit::PER_S.name => 1e2,
                name if name == unit::KG.name => 1e3,
                _ => 1.0,
            };
        }
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

    fn inertia(&mut self) -> Result<f64, Fault> {
        self.carrier.inertia(&mut self.standing)
    }

    fn state(&self) -> State {
        State::new(Saved {
            own: self.own_state(),
            followed: self.commands.as_ref().map(|commands| commands.now.clone()),
        })
    }

    fn state_into(&self, state: &mut State) {
        let Saved { own, followed } = state.own_mut();
        self.standing.state_into(&mut own.standing);
        own.carrier.follow(&*self.carrier);
        *followed = self.commands.as_ref().map(|commands| commands.now.clone());
    }

    fn set_state(&mut self, state: &State) {
        let Saved { own, followed } = state.own();
        self.set_own_state(own);
        if let Some((commands, followed)) = self.commands.as_mut().zip(followed.as_ref()) {
            commands.now = followed.clone();
        }
    }

    fn numbers(&self, state: &State) -> Vec<f64> {
        let Saved { own, followed } = state.own();
        let mut numbers = self.numbers_of(own);
        let followed = followed.as_ref().map(|followed| followed.numbers(&numbers));
        numbers.extend(followed.into_iter().flatten());
        numbers
    }

    fn state_of(&self, numbers: &[f64]) -> Result<State, Fault> {
        let Some(commands) = &self.commands else {
            let own = self.own_state_of(numbers)?;
            return Ok(State::new(Saved { own, followed: None }));
        };
        let own = self.own_numbers().len();
        if numbers.len() != own + Followed::count(own) {
            return Err(foreign());
        }
        let (own, followed) = numbers.split_at(own);
        let followed = commands.take(followed).ok_or_else(foreign)?;
        if !followed.kept.is_empty() {
            self.own_state_of(&followed.kept)?;
        }
        Ok(State::new(Saved {
            own: self.own_state_of(own)?,
            followed: Some(followed),
        }))
    }

    fn tangent(&self, seed: &dyn Fn(Quantity) -> f64) -> Tangent {
        self.standing.tangent(&|quantity| self.seed(quantity, seed))
    }

    fn tangent_into(&self, seed: &dyn Fn(Quantity) -> f64, tangent: &mut Tangent) {
        self.standing
            .tangent_into(&|quantity| self.seed(quantity, seed), tangent);
    }

    fn derivative(&self, tangent: &mut Tangent, index: usize) -> Result<f64, Fault> {
        self.standing.derivative(tangent, index)
    }

    fn duplicate(&self) -> Box<dyn Running> {
        Box::new(self.clone())
    }
}

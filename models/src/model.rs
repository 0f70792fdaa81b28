//! A scene as a running model: inputs and parameters in, outputs out. What the
//! FMU, the tables and the tests step is this and nothing else.

use std::collections::BTreeSet;
use std::fmt;

use crate::number::short;
use crate::scene::{Mechanism, Scene};
use crate::solver::Count;
use crate::steering;
use crate::symbol::Symbol;
use crate::unit;
use crate::{balance, lemniscate};

/// The independent variable.
pub static TIME: Symbol = Symbol {
    id: "time",
    print: "t",
    unit: &unit::S,
    display: &unit::S,
    text: "Simulation time.",
    source: "given",
    infinite: None,
};

/// What a variable is to a simulator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Set at any time.
    Input,
    /// Set before the simulation starts.
    Parameter,
    /// A parameter that may also change while the simulation runs.
    Tunable,
    /// Follows from the inputs.
    Output,
    /// Follows from the parameters.
    Calculated,
    /// A continuous state; its start is set before the simulation.
    State,
    /// Rate of a state: as many as states, in their order.
    Rate,
    /// An event is where it falls below zero.
    Indicator,
}

/// What values a variable has; every one is kept as a number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Type {
    Real,
    /// Truth value, kept as 0 and 1.
    Boolean,
    /// One of several, kept as its number from 1.
    Enumeration(&'static Enumeration),
}

/// What an enumeration counts, in the order of the numbers.
#[derive(Debug, PartialEq)]
pub struct Enumeration {
    /// Name of the type: `Mode`.
    pub name: &'static str,
    /// Each with what it means.
    pub items: &'static [(&'static str, &'static str)],
}

/// A quantity, and which one where there are several of it, numbered from 1.
pub type Quantity = (&'static Symbol, Option<u16>);

/// A [`Quantity`] by the id of its symbol.
pub type Name = (&'static str, Option<u16>);

/// A variable that exists in a scene.
#[derive(Clone, Copy, Debug)]
pub struct Variable {
    pub symbol: &'static Symbol,
    /// Number from 1 where there are several of the quantity, as of wheel groups.
    /// These stand together, in their order.
    pub number: Option<u16>,
    pub role: Role,
    pub kind: Type,
    /// Smallest and greatest value, in SI; infinite where there is none.
    pub bounds: [f64; 2],
}

impl Variable {
    #[must_use]
    pub fn quantity(&self) -> Quantity {
        (self.symbol, self.number)
    }

    /// Name in FMUs, tables and messages: `R`, `theta[3]`.
    #[must_use]
    pub fn name(&self) -> String {
        self.to_string()
    }
}

impl fmt::Display for Variable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.number {
            None => f.write_str(self.symbol.id),
            // The rate of one of several is the rate of that one: `der(theta[3])`.
            Some(number) => match self.symbol.id.strip_suffix(')') {
                Some(open) => write!(f, "{open}[{number}])"),
                None => write!(f, "{}[{number}]", self.symbol.id),
            },
        }
    }
}

/// Variables that belong together where a mechanism meets another one.
#[derive(Clone, Debug)]
pub struct Terminal {
    pub name: String,
    pub text: &'static str,
    /// Each variable's name with its name in this terminal.
    pub members: Vec<(String, &'static str)>,
}

/// What the model refuses, in words that name the quantity, its value, what is
/// allowed and what to do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    pub message: String,
    /// Whether another value or a smaller step may do: a value or a configuration
    /// that physics does not allow, where a wrong call is wrong for ever.
    pub outside: bool,
}

impl Fault {
    /// Something that cannot be done.
    #[cold]
    pub fn new(message: impl Into<String>) -> Fault {
        Fault {
            message: message.into(),
            outside: false,
        }
    }

    /// An index beyond those of a model's variables.
    #[cold]
    pub(crate) fn no_variable(index: usize, count: usize) -> Fault {
        Fault::new(format!("there is no variable {index}; this model has {count}"))
    }

    /// A value or a configuration that does not exist.
    #[cold]
    pub fn outside(message: impl Into<String>) -> Fault {
        Fault {
            message: message.into(),
            outside: true,
        }
    }
}

impl From<balance::Fault> for Fault {
    fn from(fault: balance::Fault) -> Fault {
        Fault::outside(fault.to_string())
    }
}

/// The running model of a scene, stepped by the FMU and by tables: that of its mechanism.
#[derive(Clone, Debug)]
#[expect(
    clippy::large_enum_variant,
    reason = "an instance has one of it; a box would be an allocation where nothing may allocate"
)]
pub enum Model {
    Luffing(lemniscate::model::Model),
    Moving(lemniscate::moving::model::Model),
    Steering(steering::model::Model),
    Turning(steering::moving::model::Model),
}

/// All that changes in a model while it runs.
#[derive(Clone, Debug)]
#[expect(
    clippy::large_enum_variant,
    reason = "an instance has one of it; a box would be an allocation where nothing may allocate"
)]
pub enum State {
    Luffing(lemniscate::model::State),
    Moving(lemniscate::moving::model::State),
    Steering(steering::model::State),
    Turning(steering::moving::model::State),
}

/// A model's outputs with their derivatives in one direction.
#[derive(Clone, Debug)]
#[expect(
    clippy::large_enum_variant,
    reason = "an instance has one of it; a box would be an allocation where nothing may allocate"
)]
pub enum Tangent {
    Luffing(lemniscate::model::Tangent),
    Moving(lemniscate::moving::model::Tangent),
    Steering(steering::model::Tangent),
    Turning(steering::moving::model::Tangent),
}

/// A mistake of the program: states and tangents stay with their model.
const OF_ANOTHER: &str = "a state or a tangent of another mechanism";

/// Calls whichever mechanism's model this is.
macro_rules! of_each {
    ($model:expr, $one:ident => $call:expr) => {
        match $model {
            Model::Luffing($one) => $call,
            Model::Moving($one) => $call,
            Model::Steering($one) => $call,
            Model::Turning($one) => $call,
        }
    };
}

impl Model {
    /// # Errors
    /// Never for a scene that was read by [`Scene::parse`], which checks that
    /// the mechanism exists.
    pub fn new(scene: &Scene) -> Result<Model, Fault> {
        match &scene.mechanism {
            Mechanism::Luffing(luffing) => match &luffing.moving {
                None => lemniscate::model::Model::new(luffing).map(Model::Luffing),
                Some(moving) => lemniscate::moving::model::Model::new(luffing, moving).map(Model::Moving),
            },
            Mechanism::Steering(steering) => match &steering.moving {
                None => steering::model::Model::new(steering).map(Model::Steering),
                Some(moving) => steering::moving::model::Model::new(steering, moving).map(Model::Turning),
            },
        }
    }

    /// What exists in this scene; an index into it names a variable. The first one
    /// is the coordinate, over which tables and the default experiment run.
    #[must_use]
    #[inline]
    pub fn variables(&self) -> &[Variable] {
        of_each!(self, model => model.variables())
    }

    /// What belongs together where another mechanism is connected: only what exists in this scene.
    #[must_use]
    pub fn terminals(&self) -> Vec<Terminal> {
        of_each!(self, model => model.terminals())
    }

    /// Values of the first variable in tables, in SI.
    #[must_use]
    pub fn positions(&self) -> Vec<f64> {
        of_each!(self, model => model.positions())
    }

    /// Duration of the default experiment, in s.
    #[must_use]
    pub fn stop_time(&self) -> f64 {
        of_each!(self, model => model.stop_time())
    }

    /// Time for one step of the scene's tables, in s.
    #[must_use]
    pub fn step_size(&self) -> f64 {
        of_each!(self, model => model.step_size())
    }

    /// Value of a variable in SI; truth values are 0 and 1, enumerations count from 1.
    ///
    /// # Errors
    /// Where the value depends on a configuration that does not exist.
    #[inline]
    pub fn get(&mut self, index: usize) -> Result<f64, Fault> {
        of_each!(self, model => model.get(index))
    }

    /// Whether an input or a parameter may take a value, in SI.
    ///
    /// # Errors
    /// A value that is not finite or outside what the symbol allows, an output, an unknown index.
    #[inline]
    pub fn check(&self, index: usize, value: f64) -> Result<(), Fault> {
        of_each!(self, model => model.check(index, value))
    }

    /// Sets an input or a parameter, in SI.
    ///
    /// # Errors
    /// As [`check`](Model::check); a refused value changes nothing.
    #[inline]
    pub fn set(&mut self, index: usize, value: f64) -> Result<(), Fault> {
        of_each!(self, model => model.set(index, value))
    }

    /// Moves to a time in s. Left alone, the model runs its default experiment.
    #[inline]
    pub fn set_time(&mut self, time: f64) {
        of_each!(self, model => model.set_time(time));
    }

    /// Moves from one time to another, both in s: solves the equations of motion, or brings the
    /// mechanism to where it is then. A step that fails changes nothing.
    ///
    /// # Errors
    /// As [`update`](Model::update); a motion that ends on the way, or needs too many steps.
    #[inline]
    pub fn advance(&mut self, from: f64, to: f64) -> Result<(), Fault> {
        match self {
            Model::Moving(model) => model.advance(from, to),
            Model::Turning(model) => model.advance(from, to),
            Model::Luffing(_) | Model::Steering(_) => {
                self.set_time(to);
                self.update().inspect_err(|_| self.set_time(from))
            }
        }
    }

    /// Number of continuous states.
    #[must_use]
    pub fn states(&self) -> usize {
        match self {
            Model::Luffing(_) | Model::Steering(_) => 0,
            Model::Moving(model) => model.states(),
            Model::Turning(model) => model.states(),
        }
    }

    /// Work of the solver since the model was made; nothing where nothing is solved.
    #[must_use]
    pub fn count(&self) -> Count {
        match self {
            Model::Luffing(_) | Model::Steering(_) => Count::default(),
            Model::Moving(model) => model.count(),
            Model::Turning(model) => model.count(),
        }
    }

    /// Number of event indicators.
    #[must_use]
    pub fn indicators(&self) -> usize {
        match self {
            // The instantaneous centre is at infinity at one angle, which no search for events hits.
            Model::Luffing(_) => 0,
            Model::Moving(model) => model.indicators(),
            Model::Steering(model) => model.indicators(),
            Model::Turning(model) => model.indicators(),
        }
    }

    /// The continuous states, as many as there are.
    pub fn get_states(&self, states: &mut [f64]) {
        match self {
            Model::Luffing(_) | Model::Steering(_) => {}
            Model::Moving(model) => model.get_states(states),
            Model::Turning(model) => model.get_states(states),
        }
    }

    /// Sets the continuous states, as many as there are.
    ///
    /// # Errors
    /// A state is not finite; none changes.
    pub fn set_states(&mut self, states: &[f64]) -> Result<(), Fault> {
        match self {
            Model::Luffing(_) | Model::Steering(_) => Ok(()),
            Model::Moving(model) => model.set_states(states),
            Model::Turning(model) => model.set_states(states),
        }
    }

    /// Rates of the continuous states, as many as there are.
    ///
    /// # Errors
    /// A configuration that does not exist, or states so great or small that a rate is no number.
    pub fn rates(&mut self, rates: &mut [f64]) -> Result<(), Fault> {
        match self {
            Model::Luffing(_) | Model::Steering(_) => {}
            Model::Moving(model) => model.rates(rates)?,
            Model::Turning(model) => model.rates(rates)?,
        }
        self.finite(Role::Rate, rates)
    }

    /// Numbers of a role, in the order of the variables, as an importer may have them.
    fn finite(&self, role: Role, numbers: &[f64]) -> Result<(), Fault> {
        let Some(at) = numbers.iter().position(|number| !number.is_finite()) else {
            return Ok(());
        };
        let mut of_role = self.variables().iter().filter(|variable| variable.role == role);
        let name = of_role.nth(at).map(Variable::name).unwrap_or_default();
        Err(Fault::outside(format!(
            "{name} = {} is no finite number: the states that were set are too great or too small for this mechanism",
            short(numbers[at])
        )))
    }

    /// Event indicators, as many as there are.
    ///
    /// # Errors
    /// As [`rates`](Model::rates).
    pub fn event_indicators(&mut self, indicators: &mut [f64]) -> Result<(), Fault> {
        match self {
            Model::Luffing(_) => {}
            Model::Moving(model) => model.event_indicators(indicators)?,
            Model::Steering(model) => model.event_indicators(indicators)?,
            Model::Turning(model) => model.event_indicators(indicators)?,
        }
        self.finite(Role::Indicator, indicators)
    }

    /// Orders of magnitude of the continuous states, as many as there are.
    pub fn nominals(&self, nominals: &mut [f64]) {
        match self {
            Model::Luffing(_) | Model::Steering(_) => {}
            Model::Moving(model) => model.nominals(nominals),
            Model::Turning(model) => model.nominals(nominals),
        }
    }

    /// Decides what follows at an event; returns whether a continuous state jumped.
    ///
    /// # Errors
    /// A configuration that does not exist.
    pub fn event(&mut self) -> Result<bool, Fault> {
        match self {
            Model::Luffing(_) | Model::Steering(_) => Ok(false),
            Model::Moving(model) => model.event(),
            Model::Turning(model) => model.event(),
        }
    }

    /// What the importer should know of the motion so far, besides its results, in words.
    #[must_use]
    pub fn warning(&self) -> Option<&'static str> {
        match self {
            Model::Luffing(_) | Model::Steering(_) => None,
            Model::Moving(model) => model.warning(),
            Model::Turning(model) => model.warning(),
        }
    }

    /// Time of the next event that is known beforehand, in s: a sample of the PLC.
    #[must_use]
    pub fn next_event(&self) -> Option<f64> {
        match self {
            Model::Luffing(_) | Model::Moving(_) | Model::Steering(_) => None,
            Model::Turning(model) => model.next_event(),
        }
    }

    /// Brings the mechanism to a value of its coordinate, in SI: a row of a table, at the speed of the working range and
    /// otherwise as at the start.
    ///
    /// # Errors
    /// As [`set`](Model::set).
    pub fn place(&mut self, value: f64) -> Result<(), Fault> {
        match self {
            Model::Luffing(_) | Model::Steering(_) => self.set(0, value),
            Model::Moving(model) => model.place(value),
            Model::Turning(model) => model.place(value),
        }
    }

    /// Ends initialization and brings the mechanism to the current inputs.
    ///
    /// # Errors
    /// As [`update`](Model::update).
    pub fn start(&mut self) -> Result<(), Fault> {
        match self {
            Model::Luffing(_) | Model::Moving(_) => self.update(),
            Model::Steering(model) => model.start(),
            Model::Turning(model) => model.start(),
        }
    }

    /// Brings the mechanism to the current inputs.
    ///
    /// # Errors
    /// Parameters or inputs with which there is no configuration, with the values and what is allowed.
    #[inline]
    pub fn update(&mut self) -> Result<(), Fault> {
        of_each!(self, model => model.update())
    }

    /// All that changes in the model.
    #[must_use]
    pub fn state(&self) -> State {
        match self {
            Model::Luffing(model) => State::Luffing(*model.state()),
            Model::Moving(model) => State::Moving(model.state()),
            Model::Steering(model) => State::Steering(model.state().clone()),
            Model::Turning(model) => State::Turning(model.state()),
        }
    }

    /// As [`state`](Model::state), into a state that exists.
    pub fn state_into(&self, state: &mut State) {
        match (self, state) {
            (Model::Luffing(model), State::Luffing(state)) => *state = *model.state(),
            (Model::Moving(model), State::Moving(state)) => *state = model.state(),
            (_, state) => *state = self.state(),
        }
    }

    /// Takes back what [`state`](Model::state) gave, of this model or of one of the same scene.
    ///
    /// # Panics
    /// With the state of another mechanism.
    pub fn set_state(&mut self, state: &State) {
        match (self, state) {
            (Model::Luffing(model), State::Luffing(state)) => model.set_state(state),
            (Model::Moving(model), State::Moving(state)) => model.set_state(state),
            (Model::Steering(model), State::Steering(state)) => model.set_state(state),
            (Model::Turning(model), State::Turning(state)) => model.set_state(state),
            _ => unreachable!("{OF_ANOTHER}"),
        }
    }

    /// A state as numbers.
    ///
    /// # Panics
    /// With the state of another mechanism.
    #[must_use]
    pub fn numbers(&self, state: &State) -> Vec<f64> {
        match (self, state) {
            (Model::Luffing(model), State::Luffing(state)) => model.numbers(state),
            (Model::Moving(model), State::Moving(state)) => model.numbers(state),
            (Model::Steering(model), State::Steering(state)) => model.numbers(state),
            (Model::Turning(model), State::Turning(state)) => model.numbers(state),
            _ => unreachable!("{OF_ANOTHER}"),
        }
    }

    /// The state that [`numbers`](Model::numbers) belong to.
    ///
    /// # Errors
    /// Numbers that are not those of a state of this model.
    pub fn state_of(&self, numbers: &[f64]) -> Result<State, Fault> {
        match self {
            Model::Luffing(model) => model.state_of(numbers).map(State::Luffing),
            Model::Moving(model) => model.state_of(numbers).map(State::Moving),
            Model::Steering(model) => model.state_of(numbers).map(State::Steering),
            Model::Turning(model) => model.state_of(numbers).map(State::Turning),
        }
    }

    /// The model with derivatives along a direction: `seed` is the rate of change
    /// of each input, parameter and continuous state, in SI, and of [`TIME`].
    #[must_use]
    pub fn tangent(&self, seed: &dyn Fn(Quantity) -> f64) -> Tangent {
        match self {
            Model::Luffing(model) => Tangent::Luffing(model.tangent(seed)),
            Model::Moving(model) => Tangent::Moving(model.tangent(seed)),
            Model::Steering(model) => Tangent::Steering(model.tangent(seed)),
            Model::Turning(model) => Tangent::Turning(model.tangent(seed)),
        }
    }

    /// Whether directional derivatives exist.
    #[must_use]
    pub fn has_derivatives(&self) -> bool {
        matches!(self, Model::Luffing(_) | Model::Moving(_) | Model::Turning(_))
    }

    /// Derivative of an output or a rate along the direction of a tangent, in SI.
    ///
    /// # Errors
    /// Not a result, or a place where there is no derivative.
    ///
    /// # Panics
    /// With the tangent of another mechanism.
    pub fn derivative(&self, tangent: &mut Tangent, index: usize) -> Result<f64, Fault> {
        let derivative = match (self, tangent) {
            (Model::Luffing(model), Tangent::Luffing(tangent)) => model.derivative(tangent, index),
            (Model::Moving(model), Tangent::Moving(tangent)) => model.derivative(tangent, index),
            (Model::Turning(model), Tangent::Turning(tangent)) => model.derivative(tangent, index),
            (Model::Steering(model), Tangent::Steering(tangent)) => model.derivative(tangent, index),
            _ => unreachable!("{OF_ANOTHER}"),
        }?;
        if derivative.is_finite() {
            return Ok(derivative);
        }
        let variable = self.variables()[index];
        Err(Fault::outside(format!(
            "{variable} has no derivative in this configuration"
        )))
    }

    /// What each variable's expression contains: inputs, parameters and [`TIME`].
    #[must_use]
    pub fn dependencies(&self) -> Vec<BTreeSet<Name>> {
        of_each!(self, model => model.dependencies())
    }
}

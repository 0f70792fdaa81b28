//! A scene as a running model: inputs and parameters in, results out. What the FMU, the tables and the tests step is
//! this and nothing else.

use std::any::Any;

use crate::kernel::variable::{Fault, Quantity, Terminal, Variable};
use crate::parts::solver::Count;

/// A mechanism that runs, whether it stands where it is commanded or moves by itself.
pub trait Running: Any + Send {
    /// What exists in this scene; an index into it names a variable. The first one is the coordinate, over which tables
    /// and the default experiment run.
    fn variables(&self) -> &[Variable];

    /// What belongs together where another mechanism is connected: only what exists in this scene.
    fn terminals(&self) -> Vec<Terminal>;

    /// Values of the first variable in tables, in SI.
    fn positions(&self) -> Vec<f64>;

    /// Duration of the default experiment, in s.
    fn stop_time(&self) -> f64;

    /// Time for one step of the scene's tables, in s.
    fn step_size(&self) -> f64;

    /// Value of a variable in SI; truth values are 0 and 1, enumerations count from 1.
    ///
    /// # Errors
    /// Where the value depends on a configuration that does not exist.
    fn get(&mut self, index: usize) -> Result<f64, Fault>;

    /// Whether an input or a parameter may take a value, in SI.
    ///
    /// # Errors
    /// A value that is not finite or outside what the symbol allows, an output, an unknown index.
    fn check(&self, index: usize, value: f64) -> Result<(), Fault>;

    /// Sets an input or a parameter, in SI.
    ///
    /// # Errors
    /// As [`check`](Running::check); a refused value changes nothing.
    fn set(&mut self, index: usize, value: f64) -> Result<(), Fault>;

    /// Moves to a time in s. Left alone, the model runs its default experiment.
    fn set_time(&mut self, time: f64);

    /// Moves from one time to another, both in s: solves the equations of motion, or brings the mechanism to where it
    /// is then. A step that fails changes nothing.
    ///
    /// # Errors
    /// As [`update`](Running::update); a motion that ends on the way, or needs too many steps.
    fn advance(&mut self, from: f64, to: f64) -> Result<(), Fault> {
        self.set_time(to);
        self.update().inspect_err(|_| self.set_time(from))
    }

    /// Brings the mechanism to a value of its coordinate, in SI: a row of a table, at rest.
    ///
    /// # Errors
    /// As [`set`](Running::set).
    fn place(&mut self, value: f64) -> Result<(), Fault> {
        self.set(0, value)
    }

    /// Ends initialization and brings the mechanism to the present inputs.
    ///
    /// # Errors
    /// As [`update`](Running::update).
    fn start(&mut self) -> Result<(), Fault> {
        self.update()
    }

    /// Brings the mechanism to the present inputs.
    ///
    /// # Errors
    /// Parameters or inputs with which there is no configuration, with the values and what is allowed.
    fn update(&mut self) -> Result<(), Fault>;

    /// Decides what follows at an event; returns whether a continuous state jumped.
    ///
    /// # Errors
    /// A configuration that does not exist.
    fn event(&mut self) -> Result<bool, Fault> {
        Ok(false)
    }

    /// Time of the next event that is known beforehand, in s: a sample of the PLC, or a break of a command.
    fn next_event(&self) -> Option<f64> {
        None
    }

    /// Time of the next break of a command that its scene tells over time, in s.
    fn next_break(&self) -> Option<f64> {
        None
    }

    /// What the importer should know of the motion so far, besides its results, in words.
    fn warning(&self) -> Option<&'static str> {
        None
    }

    /// Number of continuous states.
    fn states(&self) -> usize {
        0
    }

    /// Work of the solver since the model was made; nothing where nothing is solved.
    fn count(&self) -> Count {
        Count::default()
    }

    /// The continuous states, as many as there are.
    fn get_states(&self, _: &mut [f64]) {}

    /// Sets the continuous states, as many as there are.
    ///
    /// # Errors
    /// A state is not finite; none changes.
    fn set_states(&mut self, _: &[f64]) -> Result<(), Fault> {
        Ok(())
    }

    /// Orders of magnitude of the continuous states, as many as there are.
    fn nominals(&self, _: &mut [f64]) {}

    /// Rates of the continuous states, as many as there are.
    ///
    /// # Errors
    /// A configuration that does not exist.
    fn rates(&mut self, _: &mut [f64]) -> Result<(), Fault> {
        Ok(())
    }

    /// Number of event indicators.
    fn indicators(&self) -> usize;

    /// Event indicators, as many as there are.
    ///
    /// # Errors
    /// As [`rates`](Running::rates).
    fn event_indicators(&mut self, indicators: &mut [f64]) -> Result<(), Fault>;

    /// Inertia of all that moves with the coordinate as it is now, in the unit of a moment over an angular
    /// acceleration; zero where none is modelled.
    ///
    /// # Errors
    /// A configuration that does not exist.
    fn inertia(&mut self) -> Result<f64, Fault> {
        Ok(0.0)
    }

    /// All that changes in the model.
    fn state(&self) -> State;

    /// As [`state`](Running::state), into a state that exists.
    ///
    /// # Panics
    /// With the state of another mechanism, as all that take one.
    fn state_into(&self, state: &mut State);

    /// Takes back what [`state`](Running::state) gave, of this model or of one of the same scene.
    fn set_state(&mut self, state: &State);

    /// A state as numbers.
    fn numbers(&self, state: &State) -> Vec<f64>;

    /// The state that [`numbers`](Running::numbers) belong to.
    ///
    /// # Errors
    /// Numbers that are not those of a state of this model.
    fn state_of(&self, numbers: &[f64]) -> Result<State, Fault>;

    /// Whether directional derivatives exist.
    fn has_derivatives(&self) -> bool {
        true
    }

    /// The model with derivatives along a direction: `seed` is the rate of change of each input, parameter and
    /// continuous state, in SI, and of [`TIME`](crate::kernel::variable::TIME).
    fn tangent(&self, seed: &dyn Fn(Quantity) -> f64) -> Tangent;

    /// As [`tangent`](Running::tangent), into one that exists.
    ///
    /// # Panics
    /// With the tangent of another mechanism, as all that take one.
    fn tangent_into(&self, seed: &dyn Fn(Quantity) -> f64, tangent: &mut Tangent);

    /// Derivative of an output or a rate along the direction of a tangent, in SI; not finite where there is none.
    ///
    /// # Errors
    /// Not a result, or a place where there is no derivative.
    fn derivative(&self, tangent: &mut Tangent, index: usize) -> Result<f64, Fault>;

    fn duplicate(&self) -> Box<dyn Running>;
}

/// All that changes in a model while it runs.
pub struct State(Box<dyn Kept>);

/// A model's results with their derivatives in one direction.
pub struct Tangent(Box<dyn Kept>);

trait Kept: Any + Send {}

impl<T: Any + Send> Kept for T {}

/// What only the model that made it can read.
macro_rules! kept {
    ($name:ident) => {
        impl $name {
            pub fn new<T: Any + Send>(own: T) -> $name {
                $name(Box::new(own))
            }

            /// # Panics
            /// For that of another mechanism, a mistake of the program.
            #[must_use]
            pub fn own<T: Any>(&self) -> &T {
                let any: &dyn Any = &*self.0;
                any.downcast_ref().expect("that of this mechanism")
            }

            /// As [`own`](Self::own), to change it.
            ///
            /// # Panics
            /// For that of another mechanism, a mistake of the program.
            pub fn own_mut<T: Any>(&mut self) -> &mut T {
                let any: &mut dyn Any = &mut *self.0;
                any.downcast_mut().expect("that of this mechanism")
            }
        }
    };
}
kept!(State);
kept!(Tangent);

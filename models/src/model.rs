//! A scene as a running model: inputs and parameters in, outputs out. What the
//! FMU, the tables and the tests step is this and nothing else.

use crate::balance;
pub use crate::lemniscate::model::{Model, State, Tangent};
use crate::symbol::Symbol;
use crate::unit;

/// The independent variable.
pub static TIME: Symbol = Symbol {
    id: "time",
    print: "t",
    unit: &unit::S,
    display: &unit::S,
    text: "Simulation time.",
    source: "given",
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
}

/// A variable that exists in a scene.
#[derive(Clone, Copy, Debug)]
pub struct Variable {
    pub symbol: &'static Symbol,
    pub role: Role,
    /// Truth value, kept as 0 and 1.
    pub boolean: bool,
    /// Smallest and greatest value, in SI; infinite where there is none.
    pub bounds: [f64; 2],
}

/// Variables that belong together where a mechanism meets another one.
#[derive(Clone, Debug)]
pub struct Terminal {
    pub name: &'static str,
    pub text: &'static str,
    /// Each variable with its name in this terminal.
    pub members: Vec<(&'static Symbol, &'static str)>,
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
    pub fn new(message: impl Into<String>) -> Fault {
        Fault {
            message: message.into(),
            outside: false,
        }
    }

    /// A value or a configuration that does not exist.
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

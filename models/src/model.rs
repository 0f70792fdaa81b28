//! A scene as a running model: inputs and parameters in, outputs out. What the
//! FMU, the tables and the tests step is this and nothing else.

pub use crate::lemniscate::model::Model;
use crate::symbol::Symbol;

/// What a variable is to a simulator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Set at any time.
    Input,
    /// Set before the simulation starts.
    Parameter,
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
}

/// A configuration or a value that the model refuses, in words that name the
/// quantity, its value, what is allowed and what to do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault(pub String);

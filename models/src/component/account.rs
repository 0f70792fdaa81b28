//! Where the energy of a run came from and went, as a book tells it.

use crate::kernel::symbol::Symbol;

/// Where energy came from, what stores it and what took it, in J: what was given is what is stored and taken; empty where
/// nobody counts it.
#[derive(Default)]
pub struct Energy {
    pub given: Vec<(&'static Symbol, f64)>,
    pub stored: Vec<(&'static Symbol, f64)>,
    /// With what is left over, last.
    pub taken: Vec<(&'static Symbol, f64)>,
}

/// An amount of energy: the integral of powers over time.
pub struct Integral {
    pub symbol: &'static Symbol,
    pub of: Vec<Power>,
}

/// A product, over another quantity or not.
pub struct Power {
    pub negative: bool,
    pub factors: Vec<&'static Symbol>,
    pub over: Option<&'static Symbol>,
}

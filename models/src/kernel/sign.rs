//! Which numbers a scene may give of a quantity.

use crate::kernel::symbol::{COARSEST, Symbol};
use crate::kernel::unit::Unit;

/// Which numbers a quantity may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    Positive,
    NotNegative,
    Any,
    /// Positive, and up to [`COARSEST`].
    Tolerance,
    /// What a result may come to, or be off, at most: positive, however small.
    AtMost,
    /// What a result must come to at least: zero or greater.
    AtLeast,
    /// What a result is compared with: any number.
    Result,
}

impl Sign {
    /// Whether `value` is one of these numbers.
    #[must_use]
    pub fn allows(self, value: f64) -> bool {
        value.is_finite()
            && match self {
                Sign::Positive | Sign::AtMost => value > 0.0,
                Sign::NotNegative | Sign::AtLeast => value >= 0.0,
                Sign::Any | Sign::Result => true,
                Sign::Tolerance => value > 0.0 && value <= COARSEST,
            }
    }

    /// In words.
    #[must_use]
    pub fn words(self) -> &'static str {
        match self {
            Sign::Positive | Sign::AtMost => "a finite number greater than zero",
            Sign::NotNegative | Sign::AtLeast => "a finite number, zero or greater",
            Sign::Any | Sign::Result => "a finite number",
            Sign::Tolerance => "greater than zero and at most 0.1",
        }
    }

    /// What a scene may give of a quantity measured in units like `unit`, in SI: what its symbol allows, where it is a
    /// value of it, and no more than a machine has: beyond that a number is a slip of its unit.
    #[must_use]
    pub fn limits(self, symbol: &Symbol, unit: &Unit) -> [f64; 2] {
        let [least, most] = unit.limits();
        let [from, to] = match self {
            Sign::Positive => [least, most],
            Sign::NotNegative | Sign::AtMost | Sign::AtLeast => [0.0, most],
            Sign::Any | Sign::Result => [-most, most],
            Sign::Tolerance => [0.0, COARSEST],
        };
        match self {
            Sign::AtMost | Sign::AtLeast | Sign::Result => [from, to],
            // A weight may be given as a mass.
            _ if !unit.is_like(symbol.unit) => [from, to],
            _ => [from.max(symbol.range.least), to.min(symbol.range.most)],
        }
    }
}

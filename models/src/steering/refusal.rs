//! What is refused, in words.

use crate::kernel::calc::Calc;
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::Fault;

/// A value that is not accepted, in words.
#[derive(Clone, Debug, PartialEq)]
pub struct Refusal {
    /// The quantity to blame, as in the symbol table, with the group's number from 1: `theta[3]`.
    pub key: String,
    /// What is wrong, with the value.
    pub what: String,
    /// What is allowed, and what to do.
    pub help: String,
}

impl std::fmt::Display for Refusal {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}; {}", self.what, self.help)
    }
}

impl Refusal {
    #[cold]
    pub(crate) fn new(key: impl Into<String>, what: impl Into<String>, help: impl Into<String>) -> Refusal {
        Refusal {
            key: key.into(),
            what: what.into(),
            help: help.into(),
        }
    }
}

/// The value itself where its symbol allows it.
pub fn within<C: Calc>(symbol: &'static Symbol, value: C) -> Result<C, Refusal> {
    let (range, x) = (&symbol.range, value.value());
    if range.allows(x) {
        return Ok(value);
    }
    let least = if range.open { "above" } else { "at least" };
    let most = if range.most.is_finite() {
        format!(" and at most {}", symbol.written(range.most))
    } else {
        String::new()
    };
    Err(Refusal::new(
        symbol.id,
        format!("{} = {}", symbol.id, symbol.written(x)),
        format!("it must be {least} {}{most}", symbol.written(range.least)),
    ))
}

impl From<Refusal> for Box<Fault> {
    fn from(refusal: Refusal) -> Box<Fault> {
        Box::new(Fault::outside(refusal.to_string()))
    }
}

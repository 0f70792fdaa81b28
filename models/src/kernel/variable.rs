//! Variables of a running model, and what it refuses.

use std::fmt;

use crate::kernel::allowed::OutOfRange;
use crate::kernel::number::short;
use crate::kernel::symbol::Symbol;
pub use crate::kernel::symbol::{Enumeration, Type};
use crate::kernel::unit;

/// The independent variable.
pub static TIME: Symbol = Symbol::new("time", "t", [&unit::S, &unit::S], "Simulation time.", "given");

/// Where a coordinate is in its working range, as an input that may be zero.
pub static PART_OF_RANGE: Symbol = Symbol::new(
    "s",
    "s",
    [&unit::ONE, &unit::ONE],
    "Part of the working range, from 0 at its start to 1 at its end; of this input and the coordinate the one set last counts.",
    "given",
);

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
    /// An input that is a real number and yet acts at events only.
    pub at_events: bool,
    /// What its description says of it in this model besides, if anything.
    pub remark: Option<&'static str>,
}

impl Variable {
    /// With the kind and the range of its symbol.
    #[must_use]
    pub fn new((symbol, number): Quantity, role: Role) -> Variable {
        Variable {
            symbol,
            number,
            role,
            kind: symbol.kind,
            bounds: [symbol.range.least, symbol.range.most],
            at_events: false,
            remark: None,
        }
    }

    /// Its meaning in this model, in English.
    #[must_use]
    pub fn description(&self) -> String {
        let text = self.symbol.description();
        match self.remark {
            None => text,
            Some(remark) => format!("{text} {remark}"),
        }
    }

    #[must_use]
    pub fn quantity(&self) -> Quantity {
        (self.symbol, self.number)
    }

    /// Whether it changes at events only.
    #[must_use]
    pub fn is_discrete(&self) -> bool {
        self.at_events || self.kind != Type::Real
    }

    /// Whether a value is one of those that it may have, in SI.
    ///
    /// # Errors
    /// The value, and what is allowed.
    pub fn check(&self, value: f64) -> Result<(), Fault> {
        let symbol = self.symbol;
        let shown = |value: f64| symbol.written(value);
        if let Type::Enumeration(of) = self.kind {
            let known = value >= 1.0 && value <= of.items.len() as f64 && value.fract() == 0.0;
            let items = || {
                (1..)
                    .zip(of.items)
                    .map(|(number, (item, _))| format!("{number} {item}"))
            };
            return known.then_some(()).ok_or_else(|| {
                let items = items().collect::<Vec<_>>().join(", ");
                Fault::outside(format!(
                    "{self} = {} is unknown: it must be one of {items}",
                    short(value)
                ))
            });
        }
        let range = &symbol.range;
        if range.allows(value) {
            return Ok(());
        }
        let range = match (range.least.is_finite(), range.most.is_finite()) {
            (true, true) if range.open => format!(" above {} and at most {}", shown(range.least), shown(range.most)),
            (true, true) => format!(" from {} to {}", shown(range.least), shown(range.most)),
            (true, false) if range.open => " greater than zero".to_owned(),
            (true, false) => ", zero or greater".to_owned(),
            _ => String::new(),
        };
        Err(Fault::outside(format!(
            "{self} = {} is not allowed: it must be a finite number{range}",
            shown(value)
        )))
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
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    pub message: String,
    /// Whether another value or a smaller step may do: a value or a configuration
    /// that physics does not allow, where a wrong call is wrong for ever.
    pub outside: bool,
    /// What a scene would change.
    pub about: Option<&'static Symbol>,
}

impl Fault {
    /// The same of a quantity that a scene would change.
    #[must_use]
    pub fn about(mut self, symbol: &'static Symbol) -> Fault {
        self.about = Some(symbol);
        self
    }

    /// Something that cannot be done.
    #[cold]
    pub fn new(message: impl Into<String>) -> Fault {
        Fault {
            message: message.into(),
            outside: false,
            about: None,
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
            about: None,
        }
    }
}

impl From<OutOfRange> for Fault {
    fn from(fault: OutOfRange) -> Fault {
        Fault::outside(fault.to_string())
    }
}

impl From<OutOfRange> for Box<Fault> {
    fn from(fault: OutOfRange) -> Box<Fault> {
        Box::new(fault.into())
    }
}

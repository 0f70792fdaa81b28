//! What a quantity may be, and what is told where it is not.

use crate::kernel::number::short;
use crate::kernel::symbol::Symbol;

/// What cannot be: a quantity, its value and what is allowed.
#[derive(Clone, Debug, PartialEq)]
pub struct OutOfRange {
    /// The quantity to blame.
    pub quantity: &'static Symbol,
    /// Its value, in SI.
    pub value: f64,
    /// Smallest and greatest allowed value, in SI.
    pub allowed: [f64; 2],
    /// What is wrong, and what to do.
    pub what: String,
}

impl OutOfRange {
    #[cold]
    pub fn new(quantity: &'static Symbol, value: f64, allowed: [f64; 2], what: impl Into<String>) -> OutOfRange {
        OutOfRange {
            quantity,
            value,
            allowed,
            what: what.into(),
        }
    }
}

impl OutOfRange {
    /// The quantity with its value, and what is allowed.
    #[must_use]
    pub fn range(&self) -> String {
        let unit = self.quantity.display.name;
        let shown = |value: f64| short(self.quantity.shown(value));
        let value = format!("{} = {} {unit}", self.quantity.id, shown(self.value));
        match self.allowed {
            FINITE if self.value.is_finite() => value,
            FINITE => format!("{value}, it must be a finite number"),
            POSITIVE => format!("{value}, it must be greater than zero"),
            NOT_NEGATIVE => format!("{value}, it must be zero or greater"),
            [low, high] if high >= f64::MAX => format!("{value}, allowed from {} {unit}", shown(low)),
            [low, high] if low <= f64::MIN => format!("{value}, allowed up to {} {unit}", shown(high)),
            [low, high] => format!("{value}, allowed {} to {} {unit}", shown(low), shown(high)),
        }
    }
}

impl std::fmt::Display for OutOfRange {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}: {}", self.what, self.range())
    }
}

impl std::error::Error for OutOfRange {}

/// Refuses what is not a finite number within `allowed`, in SI.
///
/// # Errors
/// The quantity, its value and the range.
pub fn check(quantity: &'static Symbol, value: f64, allowed: [f64; 2]) -> Result<(), OutOfRange> {
    if value.is_finite() && (allowed[0]..=allowed[1]).contains(&value) {
        Ok(())
    } else {
        Err(OutOfRange::new(quantity, value, allowed, "a value out of its range"))
    }
}

/// Greater than zero.
pub const POSITIVE: [f64; 2] = [f64::MIN_POSITIVE, f64::MAX];
/// Zero or greater.
pub const NOT_NEGATIVE: [f64; 2] = [0.0, f64::MAX];
/// Any finite number.
pub const FINITE: [f64; 2] = [f64::MIN, f64::MAX];

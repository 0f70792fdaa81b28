//! A result of the whole range, and a check with its limit.

use crate::component::extreme::Extreme;
use crate::kernel::symbol::Symbol;

/// A result of the whole range, with the coordinate where it occurs if it has one.
#[derive(Clone, Copy)]
pub struct Summary {
    pub symbol: &'static Symbol,
    pub value: f64,
    pub at: Option<(&'static Symbol, f64)>,
    /// The second coordinate there, where it matters.
    pub aside: Option<(&'static Symbol, f64)>,
    /// The result whose extreme it is.
    pub of: Option<&'static Symbol>,
}

impl Summary {
    #[must_use]
    pub const fn new(symbol: &'static Symbol, value: f64) -> Summary {
        Summary {
            symbol,
            value,
            at: None,
            aside: None,
            of: None,
        }
    }

    /// An extreme over the coordinate.
    #[must_use]
    pub fn at(symbol: &'static Symbol, extreme: Extreme, coordinate: &'static Symbol) -> Summary {
        Summary {
            at: Some((coordinate, extreme.at)),
            ..Summary::new(symbol, extreme.value)
        }
    }

    /// Of the result whose extreme it is.
    #[must_use]
    pub const fn of(mut self, result: &'static Symbol) -> Summary {
        self.of = Some(result);
        self
    }
}

/// A check with its limit.
#[derive(Clone, Copy)]
pub struct Check {
    /// Id of the sentence that says what is checked.
    pub id: &'static str,
    pub symbol: &'static Symbol,
    pub value: f64,
    pub limit: f64,
    /// Whether the value must not be above (or not below) the limit.
    pub at_most: bool,
    /// Where or when the value is so, which governs.
    pub at: Option<(&'static Symbol, f64)>,
    /// The second coordinate there, where it matters.
    pub aside: Option<(&'static Symbol, f64)>,
    /// The result whose extreme the value is; its own symbol where it is none.
    pub of: &'static Symbol,
    /// By how much the value may be off, to both sides, as far as that is known.
    pub band: Option<f64>,
}

impl Check {
    #[must_use]
    pub fn at_most(id: &'static str, symbol: &'static Symbol, value: f64, limit: f64) -> Check {
        Check {
            id,
            symbol,
            value,
            limit,
            at_most: true,
            at: None,
            aside: None,
            of: symbol,
            band: None,
        }
    }

    /// Of a result with its place.
    #[must_use]
    pub const fn of(id: &'static str, result: &Summary, limit: f64, at_most: bool) -> Check {
        Check {
            id,
            symbol: result.symbol,
            value: result.value,
            limit,
            at_most,
            at: result.at,
            aside: result.aside,
            of: match result.of {
                Some(of) => of,
                None => result.symbol,
            },
            band: None,
        }
    }

    /// Whether it judges a value of a quantity (in SI), or the value's amount.
    #[must_use]
    pub fn judges(&self, symbol: &'static Symbol, value: f64) -> bool {
        let is = |value: f64| (value - self.value).abs() <= 1e-9 * self.value.abs().max(1e-3);
        [self.of, self.symbol].contains(&symbol) && (is(value) || self.at_most && is(value.abs()))
    }

    /// Part of what is allowed that is used: value over limit where the value
    /// must not be above it, limit over value where it must not be below.
    #[must_use]
    pub fn utilisation(&self) -> f64 {
        if self.at_most {
            self.value / self.limit
        } else {
            self.limit / self.value
        }
    }

    #[must_use]
    pub fn passed(&self) -> bool {
        self.keeps(self.value)
    }

    /// Whether the value keeps to the limit, and somewhere in its band does not.
    #[must_use]
    pub fn is_doubtful(&self) -> bool {
        let band = self.band.unwrap_or(0.0);
        self.passed() && !(self.keeps(self.value - band) && self.keeps(self.value + band))
    }

    fn keeps(&self, value: f64) -> bool {
        if self.at_most {
            value <= self.limit
        } else {
            value >= self.limit
        }
    }
}

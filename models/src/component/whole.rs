//! Declares results of the whole working range: what a result at one position comes to over all of them.

use crate::kernel::symbol::Symbol;

/// A result of the range.
#[derive(Debug)]
pub struct Whole {
    pub symbol: &'static Symbol,
    pub of: &'static Symbol,
    pub how: How,
}

#[derive(Clone, Copy, Debug)]
pub enum How {
    Greatest,
    Least,
    /// Greatest less least.
    Swing,
    /// That over the same of another one.
    Ratio(&'static Symbol),
    /// Where it falls to zero, as the coordinate grows from the start of the range through half a turn; with another
    /// source at this value.
    Vanishes(Option<(&'static Symbol, f64)>),
}

impl Whole {
    const fn new(symbol: &'static Symbol, of: &'static Symbol, how: How) -> Whole {
        Whole { symbol, of, how }
    }

    /// The greatest of a result.
    #[must_use]
    pub const fn greatest(symbol: &'static Symbol, of: &'static Symbol) -> Whole {
        Whole::new(symbol, of, How::Greatest)
    }

    /// The least of a result.
    #[must_use]
    pub const fn least(symbol: &'static Symbol, of: &'static Symbol) -> Whole {
        Whole::new(symbol, of, How::Least)
    }

    /// The greatest less the least of a result.
    #[must_use]
    pub const fn swing(symbol: &'static Symbol, of: &'static Symbol) -> Whole {
        Whole::new(symbol, of, How::Swing)
    }

    /// The swing of a result over that of another one.
    #[must_use]
    pub const fn ratio(symbol: &'static Symbol, of: &'static Symbol, per: &'static Symbol) -> Whole {
        Whole::new(symbol, of, How::Ratio(per))
    }

    /// The coordinate at which a result falls to zero, as it grows from the start of the range through half a turn, or
    /// as far as the result exists; infinite where it does not. With another source at a value, if one is given.
    #[must_use]
    pub const fn vanishes(symbol: &'static Symbol, of: &'static Symbol, with: Option<(&'static Symbol, f64)>) -> Whole {
        Whole::new(symbol, of, How::Vanishes(with))
    }
}

//! Declares results of the whole working range: what a result at one position comes to over all of them.

use crate::kernel::symbol::Symbol;

/// A result of the range.
#[derive(Clone, Copy, Debug)]
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
    /// That over the swing of another one.
    Ratio(&'static Symbol),
    /// Greatest by amount, over the greatest amount of another one.
    Share(&'static Symbol),
    /// Integral over the coordinate.
    Integral,
    /// Mean and root of the mean square, each place of the coordinate having the weight of another result there.
    Mean(&'static Symbol),
    RootMean(&'static Symbol),
    /// The coordinate where it falls to zero, as that grows from the start of the range through half a turn, or as far as
    /// the result exists; infinite where it does not. With another source at a value, if one is given.
    Vanishes(Option<(&'static Symbol, f64)>),
}

impl Whole {
    #[must_use]
    pub const fn new(symbol: &'static Symbol, how: How, of: &'static Symbol) -> Whole {
        Whole { symbol, of, how }
    }
}

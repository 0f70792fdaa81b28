//! Dimensions of what the recorder meets.

use crate::kernel::unit::Dimension;

/// A dimension squared: the flow through an edge goes with the root of a pressure, whose exponents are halves.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) struct Powers(pub Dimension);

impl Powers {
    pub const ONE: Powers = Powers(Dimension::ONE);

    pub fn of(dimension: Dimension) -> Powers {
        Powers(dimension.times(dimension))
    }

    pub fn times(self, other: Powers) -> Powers {
        Powers(self.0.times(other.0))
    }

    pub fn over(self, other: Powers) -> Powers {
        Powers(self.0.over(other.0))
    }
}

impl std::fmt::Display for Powers {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.0.root() {
            Some(dimension) => write!(f, "{dimension}"),
            None => write!(f, "the root of {}", self.0),
        }
    }
}

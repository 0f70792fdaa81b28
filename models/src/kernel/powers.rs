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

    /// To a power that is a fraction; `None` where exponents would be none of whole numbers.
    pub fn raised(self, [above, below]: [u8; 2]) -> Option<Powers> {
        let each = |exponent: i8| {
            let all = i32::from(exponent) * i32::from(above);
            let whole = (all % i32::from(below) == 0).then_some(all / i32::from(below))?;
            i8::try_from(whole).ok()
        };
        let Dimension { m, kg, s } = self.0;
        Some(Powers(Dimension {
            m: each(m)?,
            kg: each(kg)?,
            s: each(s)?,
        }))
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

//! What a book says of a component, as data: everything else is made from it.

use crate::kernel::schema::{Key, SOURCE};
use crate::kernel::sign::Sign;
use crate::kernel::symbol::Symbol;
use crate::kernel::text::Text;

/// Results and formulas of a component, in the order in which a book tells them. What a scene does not model is left out.
#[derive(Debug)]
pub struct Outline {
    /// Chapters of what is given: the id of each, and the scene's table or key within the mechanism's.
    pub inputs: &'static [(&'static str, &'static str)],
    /// Formulas that do not depend on the position.
    pub constants: &'static [SectionOutline],
    /// Formulas at a position.
    pub sections: &'static [SectionOutline],
    /// Columns of the table over the working range, after the coordinate.
    pub table: &'static [&'static Symbol],
    /// Curves over the working range: id of the caption, and what is drawn over what; over the coordinate where that
    /// is `None`.
    pub curves: &'static [Line],
    pub extremes: &'static [Greatest],
    /// Results of the whole range.
    pub summary: &'static [&'static Symbol],
    /// Results whose change with every given quantity is told.
    pub sensitivity: &'static [&'static Symbol],
    /// What results are checked by.
    pub limits: &'static [Limit],
    /// What given quantities are for besides formulas: ids of the words, and the quantities. The book says it of those that
    /// none of its formulas has; of the ends of the working range and of limits it is known.
    pub uses: &'static [Purpose],
    /// What other parts are designed for: least and greatest over the working range.
    pub forces: &'static [&'static Symbol],
    /// Where the formulas are worked out if the scene does not say it: id of the position, and the result that is
    /// greatest there, of the first one that the scene has.
    pub worst: &'static [(&'static str, &'static Symbol)],
}

/// Id of the words that say what quantities are for, and these.
pub type Purpose = (&'static str, &'static [&'static Symbol]);

/// Id of a heading, and what its formulas explain.
pub type SectionOutline = (&'static str, &'static [Explained]);

/// Id of a caption, x where that is not the coordinate, and y.
pub type Line = (&'static str, Option<&'static Symbol>, &'static Symbol);

/// What formulas lead to: all that is found on the way and was not told before.
#[derive(Debug)]
pub enum Explained {
    Stage(&'static str),
    Rows(&'static [&'static Symbol]),
}

/// Chapters of what is given: `chapters!(geometry "", tackle, load "Q")`, each with the scene's table or key where that
/// has another name.
macro_rules! chapters {
    ($($id:ident $($table:literal)?),*) => {
        &[$((stringify!($id), $crate::component::outline::chapters!(@table $id $($table)?))),*]
    };
    (@table $id:ident $table:literal) => { $table };
    (@table $id:ident) => { stringify!($id) };
}
pub(crate) use chapters;

/// What a mechanism tells of its own and then of a part that others have too.
///
/// # Panics
/// Where there are not as many in all.
#[must_use]
pub const fn joined<T: Copy, const A: usize, const B: usize, const N: usize>(own: [T; A], part: [T; B]) -> [T; N] {
    assert!(A > 0 && A + B == N, "as many as there are");
    let mut all = [own[0]; N];
    let mut i = 1;
    while i < N {
        all[i] = if i < A { own[i] } else { part[i - A] };
        i += 1;
    }
    all
}

/// A result with its place in the working range.
#[derive(Clone, Copy, Debug)]
pub struct Greatest {
    pub symbol: &'static Symbol,
    pub of: &'static Symbol,
    pub most: Most,
    /// Where this changes its sign the result is infinite.
    pub pole: Option<&'static Symbol>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Most {
    Greatest,
    Least,
    /// Greatest by amount, with its sign.
    Amount,
}

impl Most {
    /// A value so that more of it is greater.
    #[must_use]
    pub fn turned(self, value: f64) -> f64 {
        match self {
            Most::Greatest => value,
            Most::Least => -value,
            Most::Amount => value.abs(),
        }
    }

    /// Whether another value is more.
    #[must_use]
    pub fn is_before(self, value: f64, other: f64) -> bool {
        self.turned(other) > self.turned(value)
    }
}

impl Greatest {
    #[must_use]
    pub const fn new(symbol: &'static Symbol, most: Most, of: &'static Symbol) -> Greatest {
        Greatest {
            symbol,
            of,
            most,
            pole: None,
        }
    }

    #[must_use]
    pub const fn with_pole(mut self, pole: &'static Symbol) -> Greatest {
        self.pole = Some(pole);
        self
    }
}

/// What is asked of a result of the range.
#[derive(Clone, Copy, Debug)]
pub struct Limit {
    /// Id of the sentence that says what is checked.
    pub id: &'static str,
    pub symbol: &'static Symbol,
    /// Whether the result must not be above the limit, or not below.
    pub at_most: bool,
    pub bound: Bound,
}

/// Where a limit comes from.
#[derive(Clone, Copy, Debug)]
pub enum Bound {
    /// The scene may set it.
    Scene,
    /// The end of the working range.
    End,
    /// In SI.
    Fixed(f64),
}

impl Limit {
    const fn new(id: &'static str, symbol: &'static Symbol, at_most: bool, bound: Bound) -> Limit {
        Limit {
            id,
            symbol,
            at_most,
            bound,
        }
    }

    #[must_use]
    pub const fn at_most(id: &'static str, symbol: &'static Symbol) -> Limit {
        Limit::new(id, symbol, true, Bound::Scene)
    }

    #[must_use]
    pub const fn at_least(id: &'static str, symbol: &'static Symbol) -> Limit {
        Limit::new(id, symbol, false, Bound::Scene)
    }

    /// A place of the coordinate that must lie beyond the working range.
    #[must_use]
    pub const fn beyond(id: &'static str, symbol: &'static Symbol) -> Limit {
        Limit::new(id, symbol, false, Bound::End)
    }

    #[must_use]
    pub const fn within(id: &'static str, symbol: &'static Symbol, most: f64) -> Limit {
        Limit::new(id, symbol, true, Bound::Fixed(most))
    }

    #[must_use]
    pub const fn not_negative(id: &'static str, symbol: &'static Symbol) -> Limit {
        Limit::new(id, symbol, false, Bound::Fixed(0.0))
    }

    /// The keys of the table in which a scene sets them, and where they come from.
    ///
    /// # Panics
    /// With another number of limits of scenes than keys.
    #[must_use]
    pub const fn keys<const KEYS: usize>(limits: &[Limit]) -> [Key; KEYS] {
        let mut keys = [SOURCE; KEYS];
        let (mut i, mut at) = (0, 0);
        while i < limits.len() {
            if let Bound::Scene = limits[i].bound {
                let sign = if limits[i].at_most { Sign::AtMost } else { Sign::AtLeast };
                keys[at] = Key::quantity(limits[i].symbol, sign).optional();
                at += 1;
            }
            i += 1;
        }
        assert!(at + 1 == KEYS, "a key for each limit of scenes, and the source");
        keys
    }
}

/// Published values, as printed.
#[derive(Clone, Debug)]
pub struct Published {
    pub source: Text,
    pub columns: Vec<&'static Symbol>,
    pub rows: Vec<Vec<String>>,
}

//! What a book says of a component, as data: everything else is made from it.

use crate::component::dependencies::Recorder;
use crate::component::sheet::{Check, Drawing, Input, Sheet, Summary};
use crate::component::standing::Standing;
use crate::kernel::origin::Origins;
use crate::kernel::symbol::Symbol;

/// Results and formulas of a component, in the order in which a book tells them. What a scene does not model is left out.
#[derive(Debug)]
pub struct Outline {
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
    /// Limits that a scene may set.
    pub limits: &'static [Limit],
    /// Where the formulas are worked out if the scene does not say it: id of the position, and the result that is
    /// greatest there.
    pub worst: (&'static str, &'static Symbol),
}

/// Id of a heading, and what its formulas explain.
pub type SectionOutline = (&'static str, &'static [Explained]);

/// Id of a caption, x where that is not the coordinate, and y.
pub type Line = (&'static str, Option<&'static Symbol>, &'static Symbol);

/// What formulas lead to: all that is found on the way and was not told before.
#[derive(Debug)]
pub enum Explained {
    Stage(&'static str),
    Row(&'static Symbol),
}

/// A result with its place in the working range.
#[derive(Debug)]
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
    /// Whether another value is more.
    #[must_use]
    pub fn is_before(self, value: f64, other: f64) -> bool {
        match self {
            Most::Greatest => other > value,
            Most::Least => other < value,
            Most::Amount => other.abs() > value.abs(),
        }
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

/// What a scene may ask of a result of the range.
#[derive(Debug)]
pub struct Limit {
    /// Id of the sentence that says what is checked.
    pub id: &'static str,
    pub symbol: &'static Symbol,
    /// Whether the result must not be above the limit, or not below.
    pub at_most: bool,
}

impl Limit {
    #[must_use]
    pub const fn at_most(id: &'static str, symbol: &'static Symbol) -> Limit {
        Limit {
            id,
            symbol,
            at_most: true,
        }
    }

    #[must_use]
    pub const fn at_least(id: &'static str, symbol: &'static Symbol) -> Limit {
        Limit {
            id,
            symbol,
            at_most: false,
        }
    }
}

/// A component as a scene gives it, for its book.
pub trait Told {
    fn outline(&self) -> &'static Outline;

    /// In closed form, at the start of its working range.
    fn standing(&self) -> Standing;

    fn recorder(&self) -> Recorder;

    /// What the scene allows, in SI.
    fn limit(&self, symbol: &'static Symbol) -> Option<f64>;

    /// Results of the range that searches of its own have found, with their places.
    fn searched(&self) -> Vec<Summary> {
        Vec::new()
    }

    /// Independent ways to one result, that must agree.
    fn identities(&self, model: &mut Standing) -> Vec<Check>;

    /// Results of the whole range that are no variables.
    fn totals(&self) -> Vec<Summary> {
        Vec::new()
    }

    fn published(&self) -> Option<&Published>;

    /// Pieces of a curve, where it is not drawn as a whole.
    fn pieces(&self, _: &'static str, points: Vec<[f64; 2]>) -> Vec<Vec<[f64; 2]>> {
        vec![points]
    }

    /// Ids of its level and of what its model takes for granted, worded in the templates.
    fn assumptions(&self) -> Vec<&'static str>;

    fn drawing(&self) -> Drawing;

    /// Ids of remarks, worded in the templates.
    fn remarks(&self) -> Vec<&'static str>;

    fn inputs(&self, origins: &Origins) -> Vec<Input>;

    /// Chapters of its own.
    fn more(&self, _: &mut Standing, _: &mut Sheet) {}
}

/// Published values, as printed.
#[derive(Clone, Debug)]
pub struct Published {
    pub source: String,
    pub columns: Vec<&'static Symbol>,
    pub rows: Vec<Vec<String>>,
}

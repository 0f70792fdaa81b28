//! Symbols as data: one entry feeds the FMU's description, the book, CSV
//! headers, the scene's schema and the notation page.

use crate::kernel::number::{exponent, short};
use crate::kernel::unit::{self, Unit};

/// A quantity with its name in every place where it appears.
#[derive(Debug)]
pub struct Symbol {
    /// Name in scenes, FMUs, CSV headers and tests: `theta_1`, `A.x`.
    pub id: &'static str,
    /// Typeset form, in Typst's mathematics.
    pub print: &'static str,
    /// SI unit, inside and in the FMU.
    pub unit: &'static Unit,
    /// Unit in which people read and write it.
    pub display: &'static Unit,
    /// What it is, and which way is positive.
    pub text: &'static str,
    /// Where its definition or equation comes from, as `[key, place]`.
    pub source: &'static str,
    pub kind: Type,
    /// Values that it may have.
    pub range: Range,
    /// A parameter that may change while a simulation runs: ballast and ground do, steel does not.
    pub tunable: bool,
    /// Where it is infinite; `None` where it never is.
    pub infinite: Option<&'static str>,
    /// A coefficient whose usual value no source at hand confirms.
    pub unconfirmed: bool,
}

/// What values a quantity has; every one is kept as a number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Type {
    Real,
    /// Truth value, kept as 0 and 1.
    Boolean,
    /// One of several, kept as its number from 1.
    Enumeration(&'static Enumeration),
}

/// What an enumeration counts, in the order of the numbers.
#[derive(Debug, PartialEq)]
pub struct Enumeration {
    /// Name of the type: `Mode`.
    pub name: &'static str,
    /// Each with what it means.
    pub items: &'static [(&'static str, &'static str)],
}

/// Greatest relative tolerance of a solver or an interpolation.
pub const COARSEST: f64 = 0.1;

/// Least and greatest value, in SI; infinite where there is none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    pub least: f64,
    pub most: f64,
    /// Whether the least value itself is left out.
    pub open: bool,
}

impl Range {
    pub const ANY: Range = Range::new(f64::NEG_INFINITY, f64::INFINITY);
    pub const NOT_NEGATIVE: Range = Range::new(0.0, f64::INFINITY);
    pub const POSITIVE: Range = Range::new(0.0, f64::INFINITY).above();

    #[must_use]
    pub const fn new(least: f64, most: f64) -> Range {
        Range {
            least,
            most,
            open: false,
        }
    }

    /// The same without its least value.
    #[must_use]
    pub const fn above(mut self) -> Range {
        self.open = true;
        self
    }

    /// Least and greatest finite value; above zero where that is left out.
    #[must_use]
    pub const fn ends(&self) -> [f64; 2] {
        let least = if self.open { f64::MIN_POSITIVE } else { f64::MIN };
        [self.least.max(least), self.most.min(f64::MAX)]
    }

    /// Whether a finite value is one of these.
    #[must_use]
    #[inline]
    pub fn allows(&self, value: f64) -> bool {
        let enough = if self.open {
            value > self.least
        } else {
            value >= self.least
        };
        enough && value <= self.most && value.is_finite()
    }
}

impl PartialEq for Symbol {
    /// Two symbols are one when they stand for the same thing in the same table.
    fn eq(&self, other: &Symbol) -> bool {
        std::ptr::eq(self, other)
    }
}

impl Symbol {
    /// A real quantity that may have any value; with the unit inside, and the one in which people read it.
    #[must_use]
    pub const fn new(
        id: &'static str,
        print: &'static str,
        [unit, display]: [&'static Unit; 2],
        text: &'static str,
        source: &'static str,
    ) -> Symbol {
        Symbol {
            id,
            print,
            unit,
            display,
            text,
            source,
            kind: Type::Real,
            range: Range::ANY,
            tunable: false,
            infinite: None,
            unconfirmed: false,
        }
    }

    /// Typeset form for one of several: the index i gives way to its number.
    #[must_use]
    pub fn numbered(&self, number: u16) -> String {
        for end in ["i", "i)"] {
            if let Some(stem) = self.print.strip_suffix(end) {
                return format!("{stem}{number}{}", &end[1..]);
            }
        }
        self.print.to_owned()
    }

    /// What it is, which way is positive, and where it is infinite.
    #[must_use]
    pub fn description(&self) -> String {
        match self.infinite {
            None => self.text.to_owned(),
            Some(place) => format!("{} Infinite {place}.", self.text),
        }
    }

    /// A value in SI, converted to the display unit.
    #[must_use]
    pub fn shown(&self, value: f64) -> f64 {
        value / self.display.factor
    }

    /// A value in SI as people write it, for messages: `19.3 m`.
    #[must_use]
    pub fn written(&self, value: f64) -> String {
        let number = short(self.shown(value));
        if self.display == &unit::ONE || !value.is_finite() {
            return number.to_string();
        }
        format!("{number} {}", self.display.name)
    }

    /// A value in SI as a scene may write it, with all its digits: read again, it has the same bits.
    #[must_use]
    pub fn in_si(&self, value: f64) -> String {
        let number = match exponent(value) {
            -5..15 => format!("{value}"),
            _ => format!("{value:e}"),
        };
        match self.unit == &unit::ONE {
            true => number,
            false => format!("{number} {}", self.unit.name),
        }
    }
}

/// What follows a symbol's units in its table, in brackets: `M / M [positive, tunable]`.
impl Symbol {
    #[must_use]
    pub const fn positive(self) -> Symbol {
        self.within(Range::POSITIVE)
    }

    #[must_use]
    pub const fn not_negative(self) -> Symbol {
        self.within(Range::NOT_NEGATIVE)
    }

    /// In SI.
    #[must_use]
    pub const fn from_to(self, least: f64, most: f64) -> Symbol {
        self.within(Range::new(least, most))
    }

    /// In SI, the least value itself left out.
    #[must_use]
    pub const fn above_to(self, least: f64, most: f64) -> Symbol {
        self.within(Range::new(least, most).above())
    }

    #[must_use]
    pub const fn within(mut self, range: Range) -> Symbol {
        self.range = range;
        self
    }

    /// A relative tolerance: what is only a tenth right is bounded, and means little.
    #[must_use]
    pub const fn tolerance(self) -> Symbol {
        self.above_to(0.0, COARSEST)
    }

    #[must_use]
    pub const fn tunable(mut self) -> Symbol {
        self.tunable = true;
        self
    }

    /// In words.
    #[must_use]
    pub const fn infinite(mut self, place: &'static str) -> Symbol {
        self.infinite = Some(place);
        self
    }

    /// A coefficient whose usual value the book marks: to be confirmed.
    #[must_use]
    pub const fn unconfirmed(mut self) -> Symbol {
        self.unconfirmed = true;
        self
    }

    #[must_use]
    pub const fn boolean(mut self) -> Symbol {
        self.kind = Type::Boolean;
        self
    }

    #[must_use]
    pub const fn one_of(mut self, of: &'static Enumeration) -> Symbol {
        self.kind = Type::Enumeration(of);
        self
    }
}

/// Declares the symbol table of a mechanism.
macro_rules! symbols {
    ($($(#[$doc:meta])* $name:ident: $id:literal $print:literal $unit:ident / $display:ident
       $([$($mark:ident $(($($argument:expr),*))?),*])?, $text:literal, $source:literal;)*) => {
        $(
            #[doc = concat!("`", $id, "`: ", $text, " Source: ", $source, ".")]
            pub static $name: $crate::kernel::symbol::Symbol = $crate::kernel::symbol::Symbol::new(
                $id,
                $print,
                [&$crate::kernel::unit::$unit, &$crate::kernel::unit::$display],
                $text,
                $source,
            )$($(.$mark($($($argument),*)?))*)?;
        )*
        /// Every symbol of this table, in the order of the text.
        pub static ALL: &[&$crate::kernel::symbol::Symbol] = &[$(&$name),*];
    };
}
pub(crate) use symbols;

/// Symbols of a table by their names: `listed!(s: R, A_Y)`.
macro_rules! listed {
    ($table:ident: $($name:ident),*) => {
        &[$(&$table::$name),*]
    };
}
pub(crate) use listed;

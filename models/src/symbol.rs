//! Symbols as data: one entry feeds the FMU's description, the book, CSV
//! headers, the scene's schema and the notation page.

use crate::number::short;
use crate::unit::{self, Unit};

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
    /// Where it is infinite, in words; every other value that is not finite is none.
    pub infinite: Option<&'static str>,
}

impl PartialEq for Symbol {
    /// Two symbols are one when they stand for the same thing in the same table.
    fn eq(&self, other: &Symbol) -> bool {
        std::ptr::eq(self, other)
    }
}

impl Symbol {
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
}

/// Declares the symbol table of a mechanism.
macro_rules! symbols {
    ($($(#[$doc:meta])* $name:ident: $id:literal $print:literal $unit:ident / $display:ident, $text:literal, $source:literal
        $(, infinite $infinite:literal)?;)*) => {
        $(
            #[doc = concat!("`", $id, "`: ", $text, " Source: ", $source, ".")]
            pub static $name: $crate::symbol::Symbol = $crate::symbol::Symbol {
                id: $id,
                print: $print,
                unit: &$crate::unit::$unit,
                display: &$crate::unit::$display,
                text: $text,
                source: $source,
                infinite: {
                    let place: &[&str] = &[$($infinite)?];
                    place.first().copied()
                },
            };
        )*
        /// Every symbol of this table, in the order of the text.
        pub static ALL: &[&$crate::symbol::Symbol] = &[$(&$name),*];
    };
}
pub(crate) use symbols;

/// Declares a group of given quantities: a struct over any scalar that knows
/// the symbol of each field.
macro_rules! quantities {
    ($(#[$doc:meta])* $name:ident { $($field:ident: $symbol:ident),* }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        pub struct $name<C> {
            $(pub $field: C),*
        }

        impl<C: Copy> $name<C> {
            /// The symbols of the fields, in their order.
            pub const SYMBOLS: &'static [&'static $crate::symbol::Symbol] = &[$(&s::$symbol),*];

            /// Each quantity by its symbol; `None` where one is not given.
            pub fn of(given: impl Fn(&'static $crate::symbol::Symbol) -> Option<C>) -> Option<$name<C>> {
                Some($name { $($field: given(&s::$symbol)?),* })
            }

            /// The same quantities over another scalar.
            pub fn map<D>(&self, f: &mut dyn FnMut(&'static $crate::symbol::Symbol, C) -> D) -> $name<D> {
                $name { $($field: f(&s::$symbol, self.$field)),* }
            }
        }
    };
}
pub(crate) use quantities;

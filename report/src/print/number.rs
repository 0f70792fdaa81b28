//! Numbers with their units.

use lemnis_models::kernel::number::{Digits, Number, exponent, short};
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::kernel::unit::Unit;

use crate::language::Language;

/// A value (in SI) in the symbol's display unit.
#[must_use]
pub fn quantity(language: &Language, symbol: &Symbol, value: f64) -> String {
    measured(language, symbol.shown(value), symbol.display)
}

/// How far a value (in SI) may be off, with two significant digits.
#[must_use]
pub fn rough(language: &Language, symbol: &Symbol, value: f64) -> String {
    let shown = symbol.shown(value);
    let unit = 10_f64.powi(exponent(shown) - 1);
    measured(language, (shown / unit).round() * unit, symbol.display)
}

/// A symbol with its value (in SI).
#[must_use]
pub fn named(language: &Language, symbol: &Symbol, value: f64) -> String {
    format!("{} = {}", symbol.print, quantity(language, symbol, value))
}

/// A number of units.
#[must_use]
pub fn measured(language: &Language, number: f64, unit: &Unit) -> String {
    let unit = match unit.print {
        "" => String::new(),
        unit if unit.starts_with('°') => format!("\"{unit}\""),
        unit => format!(" thin\"{unit}\""),
    };
    language.math(&short(number)) + &unit
}

/// A small change with three significant digits; zero where it is nothing but rounding.
pub(crate) fn change(value: f64) -> Number {
    if value.abs() < 5e-8 {
        return Number::new(0.0, Digits::Few);
    }
    Number::new(
        value,
        Digits::Decimals(usize::try_from(2 - exponent(value)).unwrap_or(0)),
    )
}

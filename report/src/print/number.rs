//! Numbers with their units.

use std::collections::BTreeMap;

use lemnis_models::kernel::number::{Digits, EXACT, NOISE, Number, SIGNIFICANT, column, exponent, short};
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::kernel::unit::{self, Unit};

use crate::language::Language;

/// The most significant digits of a number in a formula.
const MOST: usize = 12;

/// Id of the word for what never comes.
const NEVER: &str = "never";

/// How a book writes its numbers. Every value is in SI, and is printed in its symbol's display unit.
pub struct Numbers {
    pub language: &'static Language,
    /// Significant digits of results.
    digits: usize,
    /// The greatest amount of everything that is measured alike: less than [`NOISE`] of it is nothing.
    scales: Vec<(&'static Unit, f64)>,
    /// Significant digits in formulas, by the ids of the quantities that need more than [`SIGNIFICANT`].
    finer: BTreeMap<&'static str, usize>,
}

impl Numbers {
    /// With so many significant digits in results, before any quantity is known.
    pub(super) fn new(language: &'static Language, digits: usize) -> Numbers {
        Numbers {
            language,
            digits,
            scales: vec![(&unit::ONE, 1.0), (&unit::RAD, 1.0)],
            finer: BTreeMap::new(),
        }
    }

    /// The scale of what is measured in a symbol's unit reaches a value.
    pub(super) fn reach(&mut self, symbol: &'static Symbol, value: f64) {
        let amount = if value.is_finite() { value.abs() } else { 0.0 };
        match self.scales.iter_mut().find(|(unit, _)| unit.is_like(symbol.unit)) {
            Some((_, scale)) => *scale = scale.max(amount),
            None => self.scales.push((symbol.unit, amount)),
        }
    }

    /// In the display unit; zero where it is nothing beside all that is measured alike.
    fn shown(&self, symbol: &Symbol, value: f64) -> f64 {
        let alike = self.scales.iter().find(|(unit, _)| unit.is_like(symbol.unit));
        match alike {
            Some((_, scale)) if value.abs() < NOISE * scale => 0.0,
            _ => symbol.shown(value),
        }
    }

    /// A given quantity, as it was given.
    #[must_use]
    pub fn given(&self, symbol: &Symbol, value: f64) -> String {
        measured(self.language, symbol.shown(value), symbol.display)
    }

    /// A result, with the digits that the book asks for.
    #[must_use]
    pub fn result(&self, symbol: &Symbol, value: f64) -> String {
        let number = Number::new(self.shown(symbol, value), Digits::Short(self.digits, self.digits));
        with_unit(self.language, &number, symbol.display)
    }

    /// A limit: given, or a result of its own.
    #[must_use]
    pub fn limit(&self, symbol: &Symbol, limit: f64) -> String {
        with_unit(self.language, &self.number_of_limit(symbol, limit), symbol.display)
    }

    fn number_of_limit(&self, symbol: &Symbol, limit: f64) -> Number {
        Number::new(symbol.shown(limit), Digits::Short(EXACT, self.digits))
    }

    /// A result that is judged: with more digits where it would look like its limit, or beyond it, and is not.
    #[must_use]
    pub fn judged(&self, symbol: &Symbol, value: f64, limit: f64) -> String {
        let (value, printed) = (self.shown(symbol, value), self.number_of_limit(symbol, limit).value());
        let limit = symbol.shown(limit);
        let number = |digits: usize| Number::new(value, Digits::Short(digits, digits));
        let tells = |digits: &usize| number(*digits).value().partial_cmp(&printed) == value.partial_cmp(&limit);
        let digits = (self.digits..MOST).find(tells).unwrap_or(self.digits);
        with_unit(self.language, &number(digits), symbol.display)
    }

    /// A symbol with its result.
    #[must_use]
    pub fn named(&self, symbol: &Symbol, value: f64) -> String {
        format!("{} = {}", symbol.print, self.result(symbol, value))
    }

    /// Where a result is so: the coordinate, and the second one where it matters; `None` where it is so everywhere.
    #[must_use]
    pub fn place(&self, at: Option<(&Symbol, f64)>, aside: Option<(&Symbol, f64)>) -> Option<String> {
        let both = at.into_iter().chain(aside);
        let named = both.map(|(symbol, value)| self.named(symbol, value));
        named.reduce(|one, other| format!("{one}, {other}"))
    }

    /// A quantity in a formula, with the digits that a reader needs who calculates it again.
    #[must_use]
    pub fn in_formula(&self, symbol: &Symbol, value: f64) -> String {
        with_unit(self.language, &self.number_in_formula(symbol, value), symbol.display)
    }

    /// The same without its unit.
    pub(super) fn number_in_formula(&self, symbol: &Symbol, value: f64) -> Number {
        let digits = self.finer.get(symbol.id).copied().unwrap_or(SIGNIFICANT);
        Number::new(self.shown(symbol, value), Digits::Short(EXACT, digits))
    }

    /// One digit more for a quantity in formulas, or one less; whether that is possible.
    pub(super) fn refine(&mut self, symbol: &'static Symbol, by: isize) -> bool {
        let digits = self.finer.entry(symbol.id).or_insert(SIGNIFICANT);
        match digits.checked_add_signed(by) {
            Some(changed) if changed <= MOST => {
                *digits = changed;
                true
            }
            _ => false,
        }
    }

    /// Given quantities or results that stand together, all with the same decimals, those that the finest of them needs,
    /// as far as that is no more than are exact.
    #[must_use]
    pub fn account(&self, quantities: &[(&'static Symbol, f64)]) -> Vec<String> {
        let shown = quantities.iter().map(|(symbol, value)| self.shown(symbol, *value));
        let amounts = shown.clone().map(f64::abs).filter(|amount| *amount > 0.0);
        let greatest = exponent(amounts.clone().fold(0.0, f64::max));
        let least = exponent(amounts.fold(f64::INFINITY, f64::min).min(f64::MAX));
        let most = EXACT as i32 - 1 - greatest;
        let enough = SIGNIFICANT as i32 - 1 - greatest;
        let fine = 1 - least;
        let decimals = if fine > most { enough } else { enough.max(fine) };
        let digits = Digits::Decimals(usize::try_from(decimals).unwrap_or(0));
        let text = |((symbol, _), shown): (&(&'static Symbol, f64), f64)| {
            with_unit(self.language, &Number::new(shown, digits), symbol.display)
        };
        quantities.iter().zip(shown).map(text).collect()
    }

    /// A column of results, as text.
    #[must_use]
    pub fn column(&self, symbol: &Symbol, values: impl Iterator<Item = f64>) -> Vec<String> {
        let values: Vec<f64> = values.map(|value| self.shown(symbol, value)).collect();
        let numbers = column(&values, self.digits);
        let text = |number| match is_never(number, symbol.display) {
            true => self.language.word(NEVER),
            false => self.language.text(number),
        };
        numbers.iter().map(text).collect()
    }

    /// How far a value may be off, with two significant digits.
    #[must_use]
    pub fn rough(&self, symbol: &Symbol, value: f64) -> String {
        let shown = symbol.shown(value);
        let unit = 10_f64.powi(exponent(shown) - 1);
        measured(self.language, (shown / unit).round() * unit, symbol.display)
    }
}

/// A number of units, as short as it is exact.
#[must_use]
pub fn measured(language: &Language, number: f64, unit: &Unit) -> String {
    with_unit(language, &short(number), unit)
}

fn with_unit(language: &Language, number: &Number, unit: &Unit) -> String {
    if is_never(number, unit) {
        return format!("\"{}\"", language.word(NEVER));
    }
    let unit = match unit.print {
        "" => String::new(),
        unit if unit.starts_with('°') => format!("\"{unit}\""),
        unit => format!(" thin\"{unit}\""),
    };
    language.math(number) + &unit
}

/// Whether it says that something never comes: nothing is at an infinite angle, and an infinite time does not end.
fn is_never(number: &Number, unit: &Unit) -> bool {
    matches!(number, Number::Infinite { .. }) && [&unit::RAD, &unit::S].into_iter().any(|known| unit.is_like(known))
}

/// A small change with three significant digits; zero where it is nothing but rounding.
pub(crate) fn change(value: f64) -> Number {
    if value.abs() < 5e-8 {
        return Number::new(0.0, Digits::Significant(1));
    }
    Number::new(
        value,
        Digits::Decimals(usize::try_from(2 - exponent(value)).unwrap_or(0)),
    )
}

//! The symbols that the book explains.

use std::collections::BTreeSet;

use lemnis_models::component::sheet::{self, Sheet};
use lemnis_models::kernel::symbol::Symbol;
use serde::Serialize;

use crate::book::blocks::{Quantity, Value};
use crate::language::symbols_of;
use crate::print::number::Numbers;

/// A line of the index of symbols.
#[derive(Serialize)]
pub(super) struct Entry {
    #[serde(flatten)]
    quantity: Quantity,
    words: &'static str,
    /// Whether a place of the book defines it.
    defined: bool,
}

/// The symbols that the book uses.
pub(super) struct Notation {
    /// Of which mechanism the book is.
    mechanism: &'static str,
    met: Vec<&'static Symbol>,
    /// Typeset forms of the symbols that some place of the book defines, and
    /// that others can link to.
    pub defined: BTreeSet<&'static str>,
    /// Those of formulas.
    found: BTreeSet<&'static str>,
    /// Those whose place has come.
    placed: BTreeSet<&'static str>,
}

impl Notation {
    pub(super) fn new(mechanism: &'static str, sheet: &Sheet, chapters: &[&str]) -> Notation {
        let steps = sections(sheet, chapters).flat_map(|section| &section.trace.steps);
        let found: BTreeSet<&'static str> = steps.map(|step| step.symbol.print).collect();
        let mut defined = found.clone();
        if chapters.contains(&"inputs") {
            defined.extend(sheet.inputs.iter().map(|input| input.symbol.print));
        }
        Notation {
            mechanism,
            met: Vec::new(),
            defined,
            found,
            placed: BTreeSet::new(),
        }
    }

    /// The group of words that say what a symbol is.
    pub(super) fn words(&self, symbol: &'static Symbol) -> &'static str {
        symbols_of(self.mechanism, symbol)
    }

    /// Values that stand in a table.
    pub(super) fn values(&mut self, numbers: &Numbers, values: &[(&'static Symbol, f64)]) -> Vec<Value> {
        let value = |&(symbol, value): &(&'static Symbol, f64)| {
            self.meet(symbol);
            Value {
                quantity: symbol.into(),
                words: self.words(symbol),
                value: numbers.in_formula(symbol, value),
            }
        };
        values.iter().map(value).collect()
    }

    /// Whether here is the place that defines the symbol: a table before it only shows it.
    pub(super) fn place(&mut self, symbol: &'static Symbol) -> bool {
        self.meet(symbol);
        self.placed.insert(symbol.print)
    }

    /// Whether the symbol is new; another way to one quantity has the same symbol.
    pub(super) fn meet(&mut self, symbol: &'static Symbol) -> bool {
        let new = self.met.iter().all(|known| known.print != symbol.print);
        if new {
            self.met.push(symbol);
        }
        new
    }

    /// The symbols of all printed formulas.
    pub(super) fn meet_formulas(&mut self, sheet: &Sheet, chapters: &[&str]) {
        for symbol in named(sheet, chapters) {
            self.meet(symbol);
        }
    }

    /// The symbols of results, tables, curves and the balance.
    pub(super) fn meet_results(&mut self, sheet: &Sheet, chapters: &[&str]) {
        let checks = sheet
            .requirements
            .iter()
            .chain(sheet.identities.iter().filter(|_| chapters.contains(&"identities")));
        let results = checks.flat_map(|check| {
            std::iter::once(check.symbol).chain(check.at.into_iter().chain(check.aside).map(|(symbol, _)| symbol))
        });
        let warnings = sheet.warnings.iter().map(|warning| warning.summary.symbol);
        let results = results.chain(warnings).chain(sheet.unjudged.iter().copied());
        let results = results.chain(sheet.governing.iter().chain(&sheet.summary).map(|s| s.symbol));
        let balance = sheet.balance.iter().filter(|_| chapters.contains(&"balance"));
        let balance = balance.flat_map(|b| {
            let criteria = b.criteria.iter().map(|c| c.summary.symbol);
            criteria.chain(b.range.columns.iter().copied())
        });
        let tables = sheet.views.iter().flat_map(|view| &view.table.columns);
        let charts = sheet.charts.iter().filter(|_| chapters.contains(&"charts"));
        let charted = charts.flat_map(|chart| chart.points.columns[..2].iter().chain([&chart.shown]));
        let tables = tables.chain(&sheet.range.columns).chain(charted).copied();
        let drawn = sheet.changes.iter().filter_map(|changes| changes.drawn.as_ref());
        let changing = drawn.flat_map(|(_, curves)| curves);
        let curves = sheet.curves.iter().chain(changing).flat_map(|curve| [curve.x, curve.y]);
        let nearest = sheet.views.iter().flat_map(|view| &view.nearest);
        let nearest = nearest.flat_map(|(_, command)| command.iter().map(|(symbol, _)| *symbol));
        let changes = sheet.changes.iter().flat_map(|changes| changes.columns);
        let demands = sheet.demands.iter().chain(&sheet.most_demanded);
        let demands = demands.map(|(_, demand)| demand.symbol);
        let results = results.chain(tables).chain(nearest).chain(changes).chain(demands);
        for symbol in results.chain(curves).chain(balance) {
            self.meet(symbol);
        }
    }

    /// As they are printed: Latin letters, then Greek ones.
    pub(super) fn entries(&self) -> Vec<Entry> {
        let mut met = self.met.clone();
        met.sort_by_cached_key(|symbol| (order(symbol.print), symbol.id));
        let entry = |symbol: &&'static Symbol| Entry {
            quantity: match self.found.contains(symbol.print) {
                true => Quantity::found(symbol),
                false => (*symbol).into(),
            },
            words: self.words(symbol),
            defined: self.defined.contains(symbol.print),
        };
        met.iter().map(entry).collect()
    }
}

/// What the formulas of some chapters name.
pub(super) fn named(sheet: &Sheet, chapters: &[&str]) -> Vec<&'static Symbol> {
    let mut names = Vec::new();
    for section in sections(sheet, chapters) {
        let trace = &section.trace;
        trace
            .steps
            .iter()
            .for_each(|step| trace.names(step.formula, &mut names));
    }
    names
}

/// The formulas of some chapters.
fn sections<'a>(sheet: &'a Sheet, chapters: &[&str]) -> impl Iterator<Item = &'a sheet::Section> + use<'a> {
    let [constants, sizing, positions, cases, motion] =
        ["constants", "sizing", "positions", "cases", "motion"].map(|chapter| chapters.contains(&chapter));
    let positions = sheet.positions.iter().filter(move |_| positions);
    let cases = sheet.cases.iter().filter(move |_| cases);
    let motion = sheet.motion.iter().filter(move |_| motion);
    let constants = sheet.constants.iter().filter(move |_| constants);
    constants
        .chain(sheet.sizing.iter().filter(move |_| sizing))
        .chain(positions.flat_map(|position| &position.sections))
        .chain(cases.flat_map(|cases| cases.worked.iter().flat_map(|worked| &worked.sections)))
        .chain(motion.flat_map(|motion| &motion.sections))
}

/// The Greek alphabet as Typst's mathematics names it.
const GREEK: [&str; 24] = [
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa", "lambda", "mu", "nu", "xi",
    "omicron", "pi", "rho", "sigma", "tau", "upsilon", "phi", "chi", "psi", "omega",
];

/// What stands around or before a letter and does not count.
const AROUND: [&str; 7] = ["abs", "overline", "dot", "dif", "integral", "hat", "upright"];

/// Where a symbol stands in the notation, from its typeset form: letter by letter, digits before Latin letters before
/// Greek ones, a capital before the small one.
fn order(print: &str) -> Vec<(u8, usize)> {
    let mut key = Vec::new();
    let mut rest = print;
    while let Some(first) = rest.chars().next() {
        let same = |c: char| match first {
            '0'..='9' => c.is_ascii_digit(),
            _ => first.is_alphabetic() && c.is_alphabetic(),
        };
        let end = rest.find(|c| !same(c)).unwrap_or(rest.len()).max(first.len_utf8());
        let (token, after) = rest.split_at(end);
        rest = after;
        let small = token.to_lowercase();
        if let Some(place) = GREEK.iter().position(|letter| **letter == small) {
            key.push((2, 2 * place + usize::from(token == small)));
        } else if let Ok(number) = token.parse() {
            key.push((0, number));
        } else if first.is_alphabetic() && !AROUND.contains(&token) {
            let letter = |c: char| (1, 2 * (c.to_ascii_lowercase() as usize) + usize::from(c.is_lowercase()));
            key.extend(token.chars().map(letter));
        } else if first == '\'' {
            key.push((3, 0));
        }
    }
    key
}

#[cfg(test)]
mod tests {
    use super::order;

    #[test]
    fn symbols_stand_as_they_are_printed() {
        let sorted = [
            "abs(N_1)_max",
            "A_d",
            "b_s",
            "b_(s,max)",
            "F_(O 1 x)",
            "F_(O 3 x)",
            "G",
            "G_1",
            "k_2",
            "M",
            "M_2",
            "M_11",
            "M_D",
            "overline(O C)",
            "x_B",
            "x'_B",
            "alpha",
            "beta_0",
            "gamma_min",
            "abs(Delta M)_max",
            "Delta y_5",
            "delta",
            "theta_1",
            "theta'_1",
            "dot(phi)",
            "psi",
        ];
        let mut anew = sorted.to_vec();
        anew.reverse();
        anew.sort_by_key(|print| order(print));
        // The force's amount is that of N.
        let mut expected = sorted.to_vec();
        let force = expected.remove(0);
        let place = expected
            .iter()
            .position(|print| *print == "overline(O C)")
            .expect("there");
        expected.insert(place, force);
        assert_eq!(anew, expected);
    }
}

//! The symbols that the book explains.

use std::collections::{BTreeMap, BTreeSet};

use lemnis_models::component::sheet::{self, Sheet};
use lemnis_models::kernel::symbol::Symbol;
use serde::Serialize;

use crate::book::blocks::Quantity;

/// A line of the index of symbols.
#[derive(Serialize)]
pub(super) struct Entry {
    #[serde(flatten)]
    quantity: Quantity,
    /// Whether a place of the book defines it.
    defined: bool,
}

/// The symbols that the book uses, in the order of their ids.
pub(super) struct Notation {
    met: BTreeMap<String, &'static Symbol>,
    /// Typeset forms of the symbols that some place of the book defines, and
    /// that others can link to.
    pub defined: BTreeSet<&'static str>,
}

impl Notation {
    pub(super) fn new(sheet: &Sheet, chapters: &[&str]) -> Notation {
        let steps = |section: &sheet::Section| {
            section
                .trace
                .steps
                .iter()
                .map(|step| step.symbol.print)
                .collect::<Vec<_>>()
        };
        let mut defined = BTreeSet::new();
        for chapter in chapters {
            match *chapter {
                "inputs" => defined.extend(sheet.inputs.iter().map(|input| input.symbol.print)),
                "constants" => defined.extend(sheet.constants.iter().flat_map(steps)),
                "sizing" => defined.extend(sheet.sizing.iter().flat_map(steps)),
                "positions" => {
                    let sections = sheet.positions.iter().flat_map(|position| &position.sections);
                    defined.extend(sections.flat_map(steps));
                }
                "motion" => {
                    let sections = sheet.motion.iter().flat_map(|motion| &motion.sections);
                    defined.extend(sections.flat_map(steps));
                }
                _ => {}
            }
        }
        Notation {
            met: BTreeMap::new(),
            defined,
        }
    }

    /// Whether the symbol is new; another way to one quantity has the same symbol.
    pub(super) fn meet(&mut self, symbol: &'static Symbol) -> bool {
        let new = self.met.values().all(|known| known.print != symbol.print);
        if new {
            // Capitals and small letters of one kind side by side, then by id.
            self.met
                .insert(format!("{} {}", symbol.id.to_lowercase(), symbol.id), symbol);
        }
        new
    }

    /// The symbols of results, tables, curves and the balance.
    pub(super) fn meet_results(&mut self, sheet: &Sheet, chapters: &[&str]) {
        let checks = sheet
            .requirements
            .iter()
            .chain(sheet.identities.iter().filter(|_| chapters.contains(&"identities")));
        let results = checks.flat_map(|check| std::iter::once(check.symbol).chain(check.at.map(|(symbol, _)| symbol)));
        let warnings = sheet.warnings.iter().map(|warning| warning.summary.symbol);
        let results = results.chain(warnings).chain(sheet.unjudged.iter().copied());
        let results = results.chain(sheet.governing.iter().chain(&sheet.summary).map(|s| s.symbol));
        let balance = sheet.balance.iter().filter(|_| chapters.contains(&"balance"));
        let balance = balance.flat_map(|b| {
            let criteria = b.criteria.iter().map(|c| c.summary.symbol);
            criteria.chain(b.range.columns.iter().copied())
        });
        let tables = sheet.views.iter().flat_map(|view| &view.table.columns);
        let tables = tables.chain(&sheet.range.columns).copied();
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

    pub(super) fn references(&self) -> Vec<String> {
        let key = |symbol: &&Symbol| Some(symbol.source.strip_prefix('[')?.split_once(',')?.0.to_owned());
        let mut keys: Vec<String> = self.met.values().filter_map(key).collect();
        keys.sort();
        keys.dedup();
        keys
    }

    pub(super) fn entries(&self) -> Vec<Entry> {
        let entry = |symbol: &&'static Symbol| Entry {
            quantity: (*symbol).into(),
            defined: self.defined.contains(symbol.print),
        };
        self.met.values().map(entry).collect()
    }
}

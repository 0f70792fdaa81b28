//! The symbols that the book explains.

use std::collections::{BTreeMap, BTreeSet};

use lemnis_models::sheet::{self, Sheet};
use lemnis_models::symbol::Symbol;
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

//! Formulas under their headings, and the symbols that the book explains.

use std::collections::{BTreeMap, BTreeSet};

use lemnis_models::record::Trace;
use lemnis_models::sheet::{self, Sheet};
use lemnis_models::symbol::Symbol;
use serde::Serialize;

use crate::book::tables::{self, Table};
use crate::book::{Quantity, json};
use crate::formula::{self, Layout, Printed};
use crate::language::Language;
use crate::plot;

#[derive(Serialize)]
pub(super) struct Section {
    id: &'static str,
    picture: Option<Drawn>,
    steps: Vec<Step>,
    table: Option<Table>,
}

/// A picture to scale.
#[derive(Serialize)]
pub(super) struct Drawn {
    picture: String,
    scale: u32,
}

impl From<plot::Picture> for Drawn {
    fn from(picture: plot::Picture) -> Drawn {
        Drawn {
            scale: picture.scale,
            picture: json(&picture),
        }
    }
}

#[derive(Serialize)]
struct Step {
    #[serde(flatten)]
    quantity: Quantity,
    /// Whether the book meets the symbol for the first time.
    first: bool,
    formula: String,
    numbers: Option<String>,
    result: String,
    layout: Layout,
    size: u32,
}

#[derive(Serialize)]
pub(super) struct Position {
    pub id: &'static str,
    pub symbol: &'static str,
    pub value: String,
    /// Number of the body that the formulas speak of.
    pub of: Option<usize>,
    pub sections: Vec<Section>,
}

/// A line of the index of symbols.
#[derive(Serialize)]
pub(super) struct Entry {
    #[serde(flatten)]
    quantity: Quantity,
    /// Whether a place of the book defines it.
    defined: bool,
}

/// Sections of formulas. With `outputs`, only these have their numbers put in;
/// other steps are intermediate, with formula and result alone.
pub(super) fn sections(
    language: &Language,
    sections: &[sheet::Section],
    outputs: Option<&[&'static Symbol]>,
    notation: &mut Notation,
) -> Vec<Section> {
    let section = |section: &sheet::Section| Section {
        id: section.id,
        picture: section
            .drawing
            .as_ref()
            .map(|drawing| plot::drawing(drawing, plot::SMALL).into()),
        steps: steps(language, &section.trace, outputs, notation),
        table: section.table.as_ref().map(|table| {
            for symbol in &table.columns {
                notation.meet(symbol);
            }
            tables::table(language, table)
        }),
    };
    sections.iter().map(section).collect()
}

fn steps(
    language: &Language,
    trace: &Trace,
    outputs: Option<&[&'static Symbol]>,
    notation: &mut Notation,
) -> Vec<Step> {
    let step = |step: &lemnis_models::record::Step| {
        let in_full = outputs.is_none_or(|outputs| outputs.contains(&step.symbol));
        let Printed {
            formula,
            numbers,
            result,
            layout,
            size,
        } = formula::step(language, &notation.defined, trace, step, in_full);
        Step {
            quantity: step.symbol.into(),
            first: notation.meet(step.symbol),
            formula,
            numbers,
            result,
            layout,
            size,
        }
    };
    trace.steps.iter().map(step).collect()
}

/// The symbols that the book uses, in the order of their ids.
pub(super) struct Notation {
    met: BTreeMap<String, &'static Symbol>,
    /// Typeset forms of the symbols that some place of the book defines, and
    /// that others can link to.
    defined: BTreeSet<&'static str>,
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

//! Formulas under their headings.

use lemnis_models::component::sheet;
use lemnis_models::kernel::record::Trace;
use lemnis_models::kernel::symbol::Symbol;
use serde::Serialize;

use crate::book::blocks::{self, Drawn, Figure, Quantity, Table, Value};
use crate::book::notation::Notation;
use crate::book::verdict::verdict;
use crate::print::drawing::{self, HALF};
use crate::print::formula::{self, Layout, Printed};
use crate::print::number::Numbers;

#[derive(Serialize)]
pub(super) struct Section {
    id: &'static str,
    picture: Option<Drawn>,
    steps: Vec<Step>,
    curve: Option<Figure>,
    table: Option<Table>,
}

#[derive(Serialize)]
struct Step {
    #[serde(flatten)]
    quantity: Quantity,
    /// Its symbol, where it is one of several.
    one: Option<String>,
    words: &'static str,
    /// Whether the book meets the symbol for the first time.
    first: bool,
    formula: Option<String>,
    numbers: Option<String>,
    result: String,
    /// What judges the result.
    checks: Vec<Judged>,
    layout: Layout,
    size: u32,
}

/// A requirement at the formula whose result it judges.
#[derive(Serialize)]
struct Judged {
    /// Whether it judges the result's amount.
    amount: bool,
    at_most: bool,
    limit: String,
    /// Id of the word.
    verdict: &'static str,
}

#[derive(Serialize)]
pub(super) struct Position {
    id: &'static str,
    symbol: &'static str,
    value: String,
    /// The second coordinate, where there is one.
    aside: Option<String>,
    /// Number of the body that the formulas speak of.
    of: Option<usize>,
    taken: Vec<Value>,
    sections: Vec<Section>,
}

impl Position {
    pub(super) fn new(
        numbers: &Numbers,
        position: &sheet::Worked,
        outputs: Option<&[&'static Symbol]>,
        requirements: &[sheet::Check],
        notation: &mut Notation,
    ) -> Position {
        Position {
            id: position.id,
            symbol: position.coordinate.print,
            value: numbers.in_formula(position.coordinate, position.value),
            aside: position
                .aside
                .map(|(symbol, at)| format!("{} = {}", symbol.print, numbers.in_formula(symbol, at))),
            of: position.of,
            taken: notation.values(numbers, &position.taken),
            sections: sections(numbers, &position.sections, outputs, requirements, notation),
        }
    }
}

/// Sections of formulas. With `outputs`, only these have their numbers put in;
/// other steps are intermediate, with formula and result alone.
pub(super) fn sections(
    numbers: &Numbers,
    sections: &[sheet::Section],
    outputs: Option<&[&'static Symbol]>,
    requirements: &[sheet::Check],
    notation: &mut Notation,
) -> Vec<Section> {
    let section = |section: &sheet::Section| Section {
        id: section.id,
        picture: section
            .drawing
            .as_ref()
            .map(|drawing| drawing::drawing(drawing, HALF).into()),
        steps: steps(numbers, &section.trace, outputs, requirements, notation),
        curve: section.curve.as_ref().map(|curve| Figure::new(numbers, curve)),
        table: section.table.as_ref().map(|table| {
            for symbol in &table.columns {
                notation.meet(symbol);
            }
            blocks::table(numbers, table)
        }),
    };
    sections.iter().map(section).collect()
}

fn steps(
    numbers: &Numbers,
    trace: &Trace,
    outputs: Option<&[&'static Symbol]>,
    requirements: &[sheet::Check],
    notation: &mut Notation,
) -> Vec<Step> {
    let step = |step: &lemnis_models::kernel::record::Step| {
        let judges = |check: &&sheet::Check| check.judges(step.symbol, step.value);
        let judged = |check: &sheet::Check| Judged {
            amount: (check.value < 0.0) != (step.value < 0.0),
            at_most: check.at_most,
            limit: numbers.limit(check.symbol, check.limit),
            verdict: verdict(check),
        };
        let checks: Vec<Judged> = requirements.iter().filter(judges).map(judged).collect();
        let in_full = outputs.is_none_or(|outputs| outputs.contains(&step.symbol));
        let Printed {
            formula,
            numbers,
            result,
            layout,
            size,
        } = formula::step(numbers, &notation.defined, trace, step, in_full, checks.len());
        Step {
            quantity: Quantity::found(step.symbol),
            one: step.number.map(|number| step.symbol.numbered(number)),
            words: notation.words(step.symbol),
            first: notation.place(step.symbol),
            formula,
            numbers,
            result,
            checks,
            layout,
            size,
        }
    };
    trace.steps.iter().map(step).collect()
}

//! The balance of the boom system: criteria, equilibria, curves, table, drawing.

use lemnis_models::balance::symbols::DM_5;
use lemnis_models::component::sheet;
use lemnis_models::kernel::number::{Digits, Number};
use serde::Serialize;

use crate::book::blocks::{Figure, Range, Summary, range, summary};
use crate::book::tables::printed;
use crate::print::drawing::{SKETCH, drawing};
use crate::print::number::Numbers;

#[derive(Serialize)]
pub(super) struct Balance {
    kind: &'static str,
    /// Whether there is a residual about the pivot of a lever.
    turns: bool,
    drawing: String,
    scale: u32,
    criteria: Vec<Criterion>,
    published_source: Option<String>,
    equilibria: Vec<Equilibrium>,
    curves: Vec<Figure>,
    range: Range,
    table: Vec<Row>,
}

/// A row of a published table.
#[derive(Serialize)]
struct Row {
    given: Vec<String>,
    moments: Vec<Cell>,
}

#[derive(Serialize)]
struct Cell {
    printed: String,
    computed: String,
    misprint: bool,
}

#[derive(Serialize)]
struct Criterion {
    #[serde(flatten)]
    summary: Summary,
    published: Option<String>,
}

#[derive(Serialize)]
struct Equilibrium {
    at: String,
    reach: String,
    stable: bool,
}

impl Balance {
    pub(super) fn new(numbers: &Numbers, balance: &sheet::BalanceSheet) -> Balance {
        let criterion = |criterion: &sheet::Measure| Criterion {
            summary: summary(numbers, &criterion.summary),
            published: criterion
                .published
                .map(|value| numbers.given(criterion.summary.symbol, value)),
        };
        let drawing = drawing(&balance.drawing, [SKETCH[0], 82.0]);
        Balance {
            kind: balance.kind,
            turns: balance.range.columns.contains(&&DM_5),
            scale: drawing.scale,
            drawing: drawing.json(),
            criteria: balance.criteria.iter().map(criterion).collect(),
            published_source: balance
                .published_source
                .as_ref()
                .map(|source| source.of(numbers.language.code).to_owned()),
            equilibria: balance
                .equilibria
                .iter()
                .map(|e| Equilibrium {
                    at: numbers.named(e.coordinate, e.at),
                    reach: numbers.named(e.reach.0, e.reach.1),
                    stable: e.stable,
                })
                .collect(),
            curves: balance.curves.iter().map(|curve| Figure::new(numbers, curve)).collect(),
            range: range(numbers, &balance.range, true),
            table: balance.table.iter().map(|row| Row::new(numbers, row)).collect(),
        }
    }
}

impl Row {
    fn new(numbers: &Numbers, row: &sheet::PublishedRow) -> Row {
        let text = |given: &str| numbers.language.text(&printed(given));
        let cell = |cell: &sheet::PublishedCell| Cell {
            printed: text(cell.printed),
            computed: numbers.language.text(&Number::new(cell.computed, Digits::Decimals(3))),
            misprint: cell.misprint,
        };
        Row {
            given: row.given.iter().map(|cell| text(cell)).collect(),
            moments: row.moments.iter().map(cell).collect(),
        }
    }
}

//! The cycle of a scene that tells commands over time: what is commanded, how the mechanism follows, and its ends.

use lemnis_models::component::sheet;
use lemnis_models::kernel::course::{Between, Course};
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::kernel::variable::{Quantity as VariableQuantity, TIME};
use serde::Serialize;

use crate::book::blocks::{Figure, Quantity};
use crate::book::notation::Notation;
use crate::print::number::Numbers;

#[derive(Serialize)]
pub(super) struct Cycle {
    end: String,
    /// When the model could not go on, if it could not.
    ended: Option<String>,
    commands: Vec<Command>,
    figures: Vec<Drawn>,
    rows: Vec<Row>,
}

#[derive(Serialize)]
struct Command {
    #[serde(flatten)]
    quantity: Quantity,
    between: &'static str,
    /// Times and values.
    rows: Vec<[String; 2]>,
}

#[derive(Serialize)]
struct Drawn {
    #[serde(flatten)]
    figure: Figure,
    shown: String,
    /// Ids of what it shows.
    of: Vec<&'static str>,
}

#[derive(Serialize)]
struct Row {
    #[serde(flatten)]
    quantity: Quantity,
    shown: String,
    /// Least and greatest value, each with its time.
    ends: [[String; 2]; 2],
    last: String,
}

impl Cycle {
    pub(super) fn new(numbers: &Numbers, cycle: &sheet::Cycle, notation: &mut Notation) -> Cycle {
        for row in &cycle.rows {
            notation.meet(row.symbol);
        }
        let time = |at: f64| numbers.given(&TIME, at);
        let command = |(symbol, course): &(&'static Symbol, Course)| Command {
            quantity: Quantity::from(*symbol),
            between: match course.between {
                Between::Linear => "linear",
                Between::Steps => "steps",
            },
            rows: (course.rows.iter())
                .map(|[at, value]| [time(*at), numbers.given(symbol, *value)])
                .collect(),
        };
        let row = |row: &sheet::CycleRow| Row {
            quantity: row.symbol.into(),
            shown: shown(row.symbol, row.number),
            ends: (row.ends).map(|end| [numbers.result(row.symbol, end.value), numbers.result(&TIME, end.time)]),
            last: numbers.result(row.symbol, row.last),
        };
        let drawn = |drawn: &sheet::CycleFigure| Drawn {
            figure: Figure::new(numbers, &drawn.curve),
            shown: together(&drawn.of),
            of: drawn.of.iter().map(|(symbol, _)| symbol.id).collect(),
        };
        Cycle {
            end: time(cycle.end),
            ended: cycle.ended.map(time),
            commands: cycle.commands.iter().map(command).collect(),
            figures: cycle.figures.iter().map(drawn).collect(),
            rows: cycle.rows.iter().map(row).collect(),
        }
    }
}

/// What one figure shows: a symbol, or several, each with the number of its line.
fn together(of: &[VariableQuantity]) -> String {
    match of {
        [(symbol, number)] => shown(symbol, *number),
        _ => {
            let line =
                |(i, (symbol, number)): (usize, &VariableQuantity)| format!("{} \" ({i})\"", shown(symbol, *number));
            (1..).zip(of).map(line).collect::<Vec<_>>().join(", ")
        }
    }
}

/// A symbol, with its number among several.
pub(super) fn shown(symbol: &Symbol, number: Option<u16>) -> String {
    number.map_or_else(|| symbol.print.to_owned(), |number| symbol.numbered(number))
}

//! Results over two quantities: a table of both with what decides each cell, and a curve for each of the first.

use lemnis_models::component::sheet;
use serde::Serialize;

use crate::book::blocks::{Figure, Quantity};
use crate::print::number::Numbers;

/// Most columns of one table.
const WIDE: usize = 8;

#[derive(Serialize)]
pub(super) struct Chart {
    id: &'static str,
    across: Quantity,
    down: Quantity,
    shown: Quantity,
    /// One beside the other, where there are many columns.
    tables: Vec<Part>,
    /// All that decides somewhere, in the order in which it is met.
    marks: Vec<&'static str>,
    figure: Option<Figure>,
}

#[derive(Serialize)]
struct Part {
    /// Number of the first column, from 1, by which the figure knows it.
    first: usize,
    head: Vec<String>,
    rows: Vec<Row>,
}

#[derive(Serialize)]
struct Row {
    head: String,
    /// Value and mark; none where there is nothing.
    cells: Vec<Option<(String, &'static str)>>,
}

/// Each value once, in order.
fn values(points: &sheet::Table, column: usize) -> Vec<f64> {
    let mut all: Vec<f64> = points.rows.iter().map(|row| row[column]).collect();
    all.sort_by(f64::total_cmp);
    all.dedup();
    all
}

impl Chart {
    pub(super) fn new(numbers: &Numbers, chart: &sheet::Chart) -> Chart {
        let points = &chart.points;
        let [across, down] = [0, 1].map(|column| points.columns[column]);
        let [heads, sides] = [0, 1].map(|column| values(points, column));
        let at = points.columns.iter().position(|symbol| *symbol == chart.shown);
        let at = at.expect("one of its columns");
        let shown = numbers.column(chart.shown, points.rows.iter().map(|row| row[at]));
        let names = numbers.column(down, sides.iter().copied());
        let cell = |head: f64, side: f64| {
            let row = points.rows.iter().position(|row| row[0] == head && row[1] == side)?;
            Some((shown[row].clone(), chart.marks[row]))
        };
        let all = numbers.column(across, heads.iter().copied());
        let part = |(number, part): (usize, &[f64])| {
            let row = |(name, &side): (&String, &f64)| Row {
                head: name.clone(),
                cells: part.iter().map(|&head| cell(head, side)).collect(),
            };
            let filled = |row: &Row| row.cells.iter().any(Option::is_some);
            Part {
                first: 1 + number * WIDE,
                head: all[number * WIDE..][..part.len()].to_vec(),
                rows: names.iter().zip(&sides).map(row).filter(filled).collect(),
            }
        };
        let mut marks = Vec::new();
        for mark in &chart.marks {
            if !marks.contains(mark) {
                marks.push(*mark);
            }
        }
        Chart {
            id: chart.id,
            across: across.into(),
            down: down.into(),
            shown: chart.shown.into(),
            tables: heads.chunks(WIDE).enumerate().map(part).collect(),
            marks,
            figure: chart.curve.as_ref().map(|curve| Figure::new(numbers, curve)),
        }
    }
}

//! Tables: given quantities, views, changes, sensitivities, published values.

use std::borrow::Cow;

use lemnis_models::component::sheet::{self, Comparison, Sheet};
use lemnis_models::kernel::gravity;
use lemnis_models::kernel::number::{Digits, Number, short};
use lemnis_models::kernel::origin::Origins;
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::kernel::unit::{self, Unit};
use serde::Serialize;

use crate::book::blocks::{Drawn, Figure, Quantity, Summary, Table, given, sparse, summary, table};
use crate::book::notation::{Notation, named};
use crate::print::drawing::{HALF, drawing};
use crate::print::number::{self, Numbers, measured};
use crate::print::plot;

#[derive(Serialize)]
pub(super) struct Chapter {
    id: &'static str,
    /// Whether only levels in motion use them, which the book does not calculate.
    uncalculated: bool,
    /// Where the scene says that these quantities come from, if it says one thing of all that it gives.
    note: Option<String>,
    /// Whether some come from elsewhere.
    mixed: bool,
    inputs: Vec<Input>,
    /// What the scene gives in a list of points.
    list: Option<Table>,
    /// Those that no formula has.
    uses: Vec<Use>,
}

/// What quantities are for that no formula has.
#[derive(Serialize)]
struct Use {
    id: &'static str,
    symbols: Vec<String>,
}

#[derive(Serialize)]
struct Input {
    #[serde(flatten)]
    quantity: Quantity,
    /// Whether the book meets the symbol for the first time.
    first: bool,
    /// The symbol, with the number of the one among several.
    shown: String,
    value: String,
    /// Whether it is told over time.
    over_time: bool,
    /// The body that it is on.
    on: Option<String>,
    /// Where the value comes from: what the scene says of that; else its line of the scene; else what is usual.
    note: Option<String>,
    line: Option<usize>,
    usual: bool,
    /// Whether no source at hand confirms what is usual.
    unconfirmed: bool,
}

/// A value of the scene, as it is written there.
#[derive(Serialize)]
pub(super) struct Written<'a> {
    key: &'a str,
    line: usize,
    text: Cow<'a, str>,
}

/// A way in which the mechanism works.
#[derive(Serialize)]
pub(super) struct View {
    id: &'static str,
    command: Option<String>,
    reachable: bool,
    nearest: Option<Nearest>,
    drawn: Drawn,
    table: Table,
}

/// The nearest way in which the mechanism can work, and the command there.
#[derive(Serialize)]
struct Nearest {
    id: &'static str,
    command: String,
}

/// What one way in which the mechanism works asks for at most.
#[derive(Serialize)]
pub(super) struct Demand {
    mode: &'static str,
    #[serde(flatten)]
    summary: Summary,
}

/// Changes between the ways in which the mechanism works.
#[derive(Serialize)]
pub(super) struct Changes {
    duration: Quantity,
    flow: Option<Quantity>,
    rows: Vec<ChangeRow>,
    drawn: Option<([&'static str; 2], Vec<Figure>)>,
}

#[derive(Serialize)]
struct ChangeRow {
    between: [&'static str; 2],
    /// Duration, whether the machine must stand, number of the group; none of a change that is not possible.
    plan: Option<(String, bool, usize)>,
    flow: Option<String>,
}

/// Change of the results with each given quantity.
#[derive(Serialize)]
pub(super) struct Sensitivity {
    columns: Vec<Quantity>,
    rows: Vec<Change>,
    /// Ranking of the given quantities, a picture for each result.
    charts: Vec<Chart>,
}

#[derive(Serialize)]
struct Change {
    symbol: String,
    /// A small change of the quantity, in its unit.
    step: String,
    /// For each result its change with that step, and with one percent.
    cells: Vec<[String; 2]>,
}

#[derive(Serialize)]
struct Chart {
    #[serde(flatten)]
    quantity: Quantity,
    #[serde(flatten)]
    figure: Figure,
}

/// Published and computed values side by side.
#[derive(Serialize)]
pub(super) struct Published {
    source: String,
    coordinate: Quantity,
    columns: Vec<Quantity>,
    rows: Vec<ComparedRow>,
    /// Most characters of a value in each column, printed and computed.
    widths: Vec<[usize; 2]>,
    one_in: Option<usize>,
    /// Of all values that are compared, printed or not.
    count: usize,
    /// Largest deviation of each column, in units of the last printed digit.
    deviations: Vec<String>,
}

#[derive(Serialize)]
struct ComparedRow {
    coordinate: String,
    /// Printed, and computed with one digit more.
    values: Vec<[String; 2]>,
}

pub(super) fn inputs(numbers: &Numbers, sheet: &Sheet, chapters: &[&str], notation: &mut Notation) -> Vec<Chapter> {
    let named = named(sheet, chapters);
    let chapter = |inputs: &[sheet::Input]| {
        let list = sheet.lists.iter().find(|(id, _)| *id == inputs[0].chapter);
        for symbol in list.iter().flat_map(|(_, list)| &list.columns) {
            notation.meet(symbol);
        }
        let mut chapter = Chapter {
            id: inputs[0].chapter,
            uncalculated: sheet.uncalculated.contains(&inputs[0].chapter),
            note: None,
            mixed: true,
            inputs: inputs.iter().map(|given| input(numbers, given, notation)).collect(),
            list: list.map(|(_, list)| given(numbers, list)),
            uses: uses(sheet, inputs, &named),
        };
        // What all have in common is said once.
        let mut given = chapter.inputs.iter().filter(|input| !input.usual);
        if let Some(first) = given.next().filter(|first| first.note.is_some())
            && given.all(|input| input.note == first.note)
        {
            chapter.note = first.note.clone();
            chapter.mixed = chapter.inputs.iter().any(|input| input.usual);
            for input in &mut chapter.inputs {
                (input.note, input.line) = (None, None);
            }
        }
        chapter
    };
    sheet
        .inputs
        .chunk_by(|a, b| a.chapter == b.chapter)
        .map(chapter)
        .collect()
}

/// What those of some given quantities are for that no formula has.
fn uses(sheet: &Sheet, inputs: &[sheet::Input], named: &[&Symbol]) -> Vec<Use> {
    let mut uses: Vec<Use> = Vec::new();
    let is_idle = |input: &&sheet::Input| named.iter().all(|symbol| symbol.print != input.symbol.print);
    for input in inputs.iter().filter(is_idle) {
        let told = |(_, symbols): &&(_, Vec<&Symbol>)| symbols.contains(&input.symbol);
        let id = match sheet.uses.iter().find(told) {
            // Told over time it only begins with zero.
            Some((id @ "cycle", _)) => id,
            _ if input.value == 0.0 && input.symbol.unit.dimension.kg != 0 => "nothing",
            Some((id, _)) => id,
            None if input.chapter == "motion" => "range_ends",
            None if input.symbol == &gravity::G => "masses",
            None => "none",
        };
        let symbol = shown(input);
        match uses.iter_mut().find(|known| known.id == id) {
            Some(known) if known.symbols.contains(&symbol) => {}
            Some(known) => known.symbols.push(symbol),
            None => uses.push(Use {
                id,
                symbols: vec![symbol],
            }),
        }
    }
    uses
}

/// As it is printed, with the number of the one among several.
fn shown(input: &sheet::Input) -> String {
    one_of(input.symbol, input.number)
}

fn one_of(symbol: &Symbol, number: Option<u16>) -> String {
    number.map_or_else(|| symbol.print.to_owned(), |number| symbol.numbered(number))
}

fn input(numbers: &Numbers, input: &sheet::Input, notation: &mut Notation) -> Input {
    let given = input.given.as_ref();
    Input {
        quantity: input.symbol.into(),
        first: notation.place(input.symbol),
        shown: shown(input),
        value: match given.and_then(|given| given.mass) {
            Some(mass) => {
                let mass = measured(numbers.language, mass / unit::T.factor, &unit::T);
                format!(
                    "{mass} dot {} = {}",
                    gravity::G.print,
                    numbers.given(input.symbol, input.value)
                )
            }
            None => numbers.given(input.symbol, input.value),
        },
        over_time: given.is_some_and(|given| given.over_time),
        usual: input.usual,
        unconfirmed: input.symbol.unconfirmed,
        on: input.on.clone(),
        line: given.map(|given| given.line),
        note: given.and_then(|given| Some(given.source.as_ref()?.of(numbers.language.code).to_owned())),
    }
}

/// Most characters of a value in the appendix: lists of a hundred points stand in tables of their own.
const LONGEST: usize = 160;

pub(super) fn written(origins: &Origins) -> Vec<Written<'_>> {
    let all = origins.written().iter().map(|written| Written {
        key: &written.key,
        line: written.line,
        text: match written.text.char_indices().nth(LONGEST) {
            Some((end, _)) => Cow::Owned(format!("{} …", &written.text[..end])),
            None => Cow::Borrowed(&written.text),
        },
    });
    all.collect()
}

/// A small change of a quantity: how many of which unit.
fn step(symbol: &'static Symbol) -> (f64, &'static Unit) {
    match symbol.unit {
        unit if unit == &unit::M => (1.0, &unit::MM),
        unit if unit == &unit::N_M => (1.0, &unit::KN_M),
        unit if unit == &unit::RAD => (0.1, &unit::DEG),
        unit if unit == &unit::N => (1.0, &unit::KN),
        _ if symbol.display == &unit::ONE => (0.01, &unit::ONE),
        _ => (1.0, symbol.display),
    }
}

pub(super) fn sensitivity(numbers: &Numbers, table: &sheet::Sensitivity) -> Sensitivity {
    // Nothing, where that is what rounding leaves.
    let shown = |i: usize, by: f64| {
        Some(number::change(table.results[i].0.shown(by))).filter(|change: &Number| change.value() != 0.0)
    };
    let by_percent = |i: usize, row: &sheet::Slope| shown(i, row.by[i] * 0.01 * row.value);
    let moves = |&i: &usize| table.rows.iter().any(|row| by_percent(i, row).is_some());
    // What no quantity changes has no column.
    let columns: Vec<usize> = (0..table.results.len()).filter(moves).collect();
    let change = |row: &sheet::Slope| {
        let (count, unit) = step(row.symbol);
        let text = |change: Option<Number>| change.map_or("–".to_owned(), |change| numbers.language.text(&change));
        let cell = |&i: &usize| [shown(i, row.by[i] * count * unit.factor), by_percent(i, row)].map(text);
        Change {
            symbol: one_of(row.symbol, row.number),
            step: measured(numbers.language, count, unit),
            cells: columns.iter().map(cell).collect(),
        }
    };
    let chart = |&i: &usize| {
        let (symbol, value) = table.results[i];
        // In percent of the result for one percent of the quantity.
        let bars = table
            .rows
            .iter()
            .map(|row| (one_of(row.symbol, row.number), row.by[i] * row.value / value));
        let picture = plot::bars(numbers.language, bars.collect())?;
        Some(Chart {
            quantity: symbol.into(),
            figure: Figure {
                id: symbol.id,
                picture: picture.json(),
            },
        })
    };
    Sensitivity {
        rows: table
            .rows
            .iter()
            .filter(|row| row.by.iter().any(|by| *by != 0.0))
            .map(change)
            .collect(),
        charts: columns.iter().filter_map(chart).collect(),
        columns: columns.iter().map(|&i| table.results[i].0.into()).collect(),
    }
}

pub(super) fn demand(numbers: &Numbers, (mode, demand): &(&'static str, sheet::Summary)) -> Demand {
    Demand {
        mode,
        summary: summary(numbers, demand),
    }
}

pub(super) fn changes(numbers: &Numbers, changes: &sheet::Changes) -> Changes {
    let [duration, flow] = changes.columns;
    let shown = |symbol: &Symbol, value: f64| numbers.language.text(&fixed(symbol.shown(value), 1));
    let row = |row: &sheet::Changeover| ChangeRow {
        between: row.between,
        plan: row
            .plan
            .map(|(time, standing, group)| (shown(duration, time), standing, group)),
        flow: row.flow.map(|value| shown(flow, value)),
    };
    let flows = changes.rows.iter().any(|row| row.flow.is_some());
    Changes {
        duration: duration.into(),
        flow: flows.then(|| flow.into()),
        rows: changes.rows.iter().map(row).collect(),
        drawn: changes.drawn.as_ref().map(|(between, curves)| {
            let figures = curves.iter().map(|curve| Figure::new(numbers, curve));
            (*between, figures.collect())
        }),
    }
}

pub(super) fn view(numbers: &Numbers, view: &sheet::View) -> View {
    let named = |(symbol, value)| numbers.named(symbol, value);
    View {
        id: view.id,
        command: view.command.map(named),
        reachable: view.reachable,
        nearest: view.nearest.as_ref().map(|(id, command)| Nearest {
            id,
            command: command.iter().copied().map(named).collect::<Vec<_>>().join(", "),
        }),
        drawn: drawing(&view.drawing, HALF).into(),
        table: table(numbers, &view.table),
    }
}

pub(super) fn fixed(value: f64, decimals: usize) -> Number {
    Number::new(value, Digits::Decimals(decimals))
}

/// Digits after the decimal point of a printed number.
fn after_point(printed: &str) -> usize {
    printed.split_once('.').map_or(0, |(_, digits)| digits.len())
}

/// A number with the digits that a publication has.
pub(super) fn printed(text: &str) -> Number {
    fixed(text.parse().unwrap_or(f64::NAN), after_point(text))
}

pub(super) fn published(numbers: &Numbers, sheet: &Sheet, full: bool) -> Option<Published> {
    let coordinate = sheet.positions.first()?.coordinate;
    let source = sheet.published_source.as_ref()?.of(numbers.language.code).to_owned();
    let rows: Vec<&[Comparison]> = sheet.published.chunk_by(|a, b| a.coordinate == b.coordinate).collect();
    let columns: Vec<&'static Symbol> = rows.first()?.iter().map(|value| value.symbol).collect();
    let compared = |value: &Comparison| {
        let computed = fixed(value.symbol.shown(value.value), after_point(&value.printed) + 1);
        [printed(&value.printed), computed].map(|number| numbers.language.text(&number))
    };
    // In units of the last printed digit.
    let deviation = |value: &Comparison| {
        let printed: f64 = value.printed.parse().expect("checked when the scene was read");
        let unit = (0..after_point(&value.printed)).fold(1.0, |unit, _| unit / 10.0);
        (value.symbol.shown(value.value) - printed).abs() / unit
    };
    let deviations = columns.iter().map(|&symbol| {
        let column = sheet.published.iter().filter(|value| value.symbol == symbol);
        numbers
            .language
            .text(&fixed(column.map(deviation).fold(0.0, f64::max), 2))
    });
    let row = |row: &&[Comparison]| ComparedRow {
        coordinate: numbers.language.text(&short(coordinate.shown(row[0].coordinate))),
        values: row.iter().map(compared).collect(),
    };
    let (rows, one_in) = sparse(rows, full);
    let rows: Vec<ComparedRow> = rows.iter().map(row).collect();
    let widest = |i: usize, j: usize| rows.iter().map(|row| row.values[i][j].chars().count()).max();
    let widths = (0..columns.len()).map(|i| [0, 1].map(|j| widest(i, j).unwrap_or(1)));
    Some(Published {
        source,
        coordinate: coordinate.into(),
        widths: widths.collect(),
        rows,
        one_in,
        count: sheet.published.len(),
        deviations: deviations.collect(),
        columns: columns.into_iter().map(Quantity::from).collect(),
    })
}

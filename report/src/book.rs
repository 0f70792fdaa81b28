//! The book as plain data: every string is ready to print, every word is an
//! id that the templates turn into the words of a language.

use std::collections::BTreeMap;
use std::fmt;

use lemnis_models::record::Trace;
use lemnis_models::scene::Scene;
use lemnis_models::sheet::{Comparison, Sheet};
use lemnis_models::symbol::Symbol;
use lemnis_typeset::Typeset;
use serde::Serialize;
use sha2::{Digest, Sha256};

use crate::formula::{self, Layout, Printed, quantity};
use crate::language::Language;
use crate::number::{decimals, fixed};
use crate::{plot, template};

/// Why there is no book: a template or its words are wrong.
#[derive(Debug)]
pub struct Error(pub String);

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Error {}

/// The Typst source of a scene's book, complete in itself.
///
/// # Errors
/// A template with a mistake, or an id without words.
pub fn source(scene: &Scene, sheet: &Sheet, language: &'static Language) -> Result<String, Error> {
    template::render(&Book::new(scene, sheet, language), language)
}

/// The book of a scene, with warnings about what could not be printed.
///
/// # Errors
/// As [`source`], and whatever Typst objects to.
pub fn pdf(scene: &Scene, sheet: &Sheet, language: &'static Language) -> Result<Typeset, Error> {
    lemnis_typeset::pdf(&source(scene, sheet, language)?, &[])
        .map_err(|error| Error(format!("the book's Typst source: {error}")))
}

/// Everything that is printed. Fields named `symbol`, `value`, `limit` and
/// those of [`Step`] are in Typst's mathematics, others are text or ids.
#[derive(Serialize)]
pub(crate) struct Book<'a> {
    pub title: &'a str,
    name: &'a str,
    project: &'a [(&'static str, String)],
    hash: String,
    version: &'static str,
    passed: bool,
    checks: Vec<Check>,
    summary: Vec<Summary>,
    inputs: Vec<Chapter>,
    drawing: String,
    scale: u32,
    constants: Vec<Section>,
    positions: Vec<Position>,
    range: Table,
    curves: Vec<Figure>,
    published: Option<Published>,
    remarks: &'a [&'static str],
    notation: Vec<Quantity>,
    /// Keys of the publications that are cited.
    references: Vec<String>,
}

#[derive(Serialize)]
struct Quantity {
    /// Names the words that say what it is.
    id: &'static str,
    symbol: &'static str,
    unit: &'static str,
    source: &'static str,
}

impl From<&'static Symbol> for Quantity {
    fn from(symbol: &'static Symbol) -> Quantity {
        Quantity {
            id: symbol.id,
            symbol: symbol.print,
            unit: symbol.display.print,
            source: symbol.source,
        }
    }
}

#[derive(Serialize)]
struct Check {
    id: &'static str,
    symbol: &'static str,
    value: String,
    limit: String,
    at_most: bool,
    passed: bool,
}

#[derive(Serialize)]
struct Summary {
    #[serde(flatten)]
    quantity: Quantity,
    value: String,
    at: Option<String>,
}

#[derive(Serialize)]
struct Chapter {
    id: &'static str,
    inputs: Vec<Input>,
}

#[derive(Serialize)]
struct Input {
    #[serde(flatten)]
    quantity: Quantity,
    value: String,
}

#[derive(Serialize)]
struct Section {
    id: &'static str,
    steps: Vec<Step>,
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
}

#[derive(Serialize)]
struct Position {
    id: &'static str,
    symbol: &'static str,
    value: String,
    sections: Vec<Section>,
}

#[derive(Serialize)]
struct Table {
    columns: Vec<Quantity>,
    rows: Vec<Vec<String>>,
}

#[derive(Serialize)]
struct Figure {
    id: &'static str,
    picture: String,
}

/// Published and computed values side by side.
#[derive(Serialize)]
struct Published {
    source: String,
    coordinate: Quantity,
    columns: Vec<Quantity>,
    rows: Vec<ComparedRow>,
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

impl<'a> Book<'a> {
    pub(crate) fn new(scene: &'a Scene, sheet: &'a Sheet, language: &'static Language) -> Book<'a> {
        let mut notation = Notation::default();
        let mut inputs: Vec<Chapter> = Vec::new();
        for input in &sheet.inputs {
            notation.meet(input.symbol);
            if inputs.last().is_none_or(|chapter| chapter.id != input.chapter) {
                inputs.push(Chapter {
                    id: input.chapter,
                    inputs: Vec::new(),
                });
            }
            let chapter = inputs.last_mut().expect("just pushed");
            chapter.inputs.push(Input {
                quantity: input.symbol.into(),
                value: quantity(language, input.symbol, input.value),
            });
        }
        let mut section = |section: &lemnis_models::sheet::Section| Section {
            id: section.id,
            steps: steps(language, &section.trace, &mut notation),
        };
        let constants = sheet.constants.iter().map(&mut section).collect();
        let positions = sheet.positions.iter().map(|position| Position {
            id: position.id,
            symbol: position.coordinate.print,
            value: quantity(language, position.coordinate, position.value),
            sections: position.sections.iter().map(&mut section).collect(),
        });
        let positions = positions.collect();
        let others = sheet
            .checks
            .iter()
            .map(|check| check.symbol)
            .chain(sheet.summary.iter().map(|s| s.symbol));
        for symbol in others.chain(sheet.range.columns.iter().copied()) {
            notation.meet(symbol);
        }
        let drawing = plot::drawing(&sheet.drawing);
        let references = notation.references();
        Book {
            title: scene.title(),
            name: scene.name(),
            project: scene.project(),
            hash: Sha256::digest(scene.text())
                .iter()
                .map(|byte| format!("{byte:02x}"))
                .collect(),
            version: env!("CARGO_PKG_VERSION"),
            passed: sheet.checks.iter().all(lemnis_models::sheet::Check::passed),
            checks: sheet.checks.iter().map(|c| check(language, c)).collect(),
            summary: sheet.summary.iter().map(|s| summary(language, s)).collect(),
            inputs,
            scale: drawing.scale,
            drawing: json(&drawing),
            constants,
            positions,
            range: table(language, &sheet.range),
            curves: sheet
                .curves
                .iter()
                .map(|c| Figure {
                    id: c.id,
                    picture: json(&plot::curve(language, c)),
                })
                .collect(),
            published: published(language, sheet),
            remarks: &sheet.remarks,
            notation: notation.symbols.into_values().map(Quantity::from).collect(),
            references,
        }
    }
}

/// The symbols that the book uses, in the order of their ids.
#[derive(Default)]
struct Notation {
    symbols: BTreeMap<String, &'static Symbol>,
}

impl Notation {
    /// Whether the symbol is new; another way to one quantity has the same symbol.
    fn meet(&mut self, symbol: &'static Symbol) -> bool {
        let new = self.symbols.values().all(|known| known.print != symbol.print);
        if new {
            // Capitals and small letters of one kind side by side, then by id.
            self.symbols
                .insert(format!("{} {}", symbol.id.to_lowercase(), symbol.id), symbol);
        }
        new
    }

    fn references(&self) -> Vec<String> {
        let key = |symbol: &&Symbol| Some(symbol.source.strip_prefix('[')?.split_once(',')?.0.to_owned());
        let mut keys: Vec<String> = self.symbols.values().filter_map(key).collect();
        keys.sort();
        keys.dedup();
        keys
    }
}

fn steps(language: &Language, trace: &Trace, notation: &mut Notation) -> Vec<Step> {
    let step = |step: &lemnis_models::record::Step| {
        let Printed {
            formula,
            numbers,
            result,
            layout,
        } = formula::step(language, trace, step);
        Step {
            quantity: step.symbol.into(),
            first: notation.meet(step.symbol),
            formula,
            numbers,
            result,
            layout,
        }
    };
    trace.steps.iter().map(step).collect()
}

fn check(language: &Language, check: &lemnis_models::sheet::Check) -> Check {
    Check {
        id: check.id,
        symbol: check.symbol.print,
        value: quantity(language, check.symbol, check.value),
        limit: quantity(language, check.symbol, check.limit),
        at_most: check.at_most,
        passed: check.passed(),
    }
}

fn summary(language: &Language, summary: &lemnis_models::sheet::Summary) -> Summary {
    Summary {
        quantity: summary.symbol.into(),
        value: quantity(language, summary.symbol, summary.value),
        at: summary
            .at
            .map(|(symbol, at)| format!("{} = {}", symbol.print, quantity(language, symbol, at))),
    }
}

fn table(language: &Language, table: &lemnis_models::sheet::Table) -> Table {
    let shown = |i: usize, row: &[f64]| table.columns[i].shown(row[i]);
    let column = |i| table.rows.iter().map(|row| shown(i, row)).collect::<Vec<f64>>();
    let decimals: Vec<usize> = (0..table.columns.len()).map(|i| decimals(&column(i))).collect();
    let row = |row: &Vec<f64>| {
        (0..row.len())
            .map(|i| language.text(&fixed(shown(i, row), decimals[i])))
            .collect()
    };
    Table {
        columns: table.columns.iter().map(|&symbol| symbol.into()).collect(),
        rows: table.rows.iter().map(row).collect(),
    }
}

fn published(language: &Language, sheet: &Sheet) -> Option<Published> {
    let coordinate = sheet.positions.first()?.coordinate;
    let source = sheet.published_source.clone()?;
    let rows: Vec<&[Comparison]> = sheet.published.chunk_by(|a, b| a.coordinate == b.coordinate).collect();
    let columns: Vec<&'static Symbol> = rows.first()?.iter().map(|value| value.symbol).collect();
    let after_point = |value: &Comparison| value.printed.split_once('.').map_or(0, |(_, digits)| digits.len());
    let compared = |value: &Comparison| {
        let computed = fixed(value.symbol.shown(value.value), after_point(value) + 1);
        [value.printed.replace('-', "−"), computed].map(|number| language.text(&number))
    };
    // In units of the last printed digit.
    let deviation = |value: &Comparison| {
        let printed: f64 = value.printed.parse().expect("checked when the scene was read");
        let unit = (0..after_point(value)).fold(1.0, |unit, _| unit / 10.0);
        (value.symbol.shown(value.value) - printed).abs() / unit
    };
    let deviations = columns.iter().map(|&symbol| {
        let column = sheet.published.iter().filter(|value| value.symbol == symbol);
        language.text(&fixed(column.map(deviation).fold(0.0, f64::max), 2))
    });
    let row = |row: &&[Comparison]| ComparedRow {
        coordinate: fixed(coordinate.shown(row[0].coordinate), 0),
        values: row.iter().map(compared).collect(),
    };
    Some(Published {
        source,
        coordinate: coordinate.into(),
        rows: rows.iter().map(row).collect(),
        count: sheet.published.len(),
        deviations: deviations.collect(),
        columns: columns.into_iter().map(Quantity::from).collect(),
    })
}

fn json(picture: &plot::Picture) -> String {
    serde_json::to_string(picture).expect("a picture is plain data")
}

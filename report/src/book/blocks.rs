//! What chapters are made of.

use lemnis_models::component::sheet;
use lemnis_models::kernel::number::short;
use lemnis_models::kernel::symbol::Symbol;
use serde::Serialize;

use crate::print::number::Numbers;
use crate::print::picture::Picture;
use crate::print::plot;

#[derive(Serialize)]
pub(super) struct Quantity {
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

impl Quantity {
    /// That of a formula, which finds what other scenes give.
    pub(super) fn found(symbol: &'static Symbol) -> Quantity {
        let quantity = Quantity::from(symbol);
        match symbol.source {
            "input" => Quantity {
                source: "derived",
                ..quantity
            },
            _ => quantity,
        }
    }
}

#[derive(Serialize)]
pub(super) struct Figure {
    pub id: &'static str,
    pub picture: String,
}

impl Figure {
    pub(super) fn new(numbers: &Numbers, curve: &sheet::Curve) -> Figure {
        Figure {
            id: curve.id,
            picture: plot::curve(numbers.language, curve).json(),
        }
    }
}

/// A picture to scale.
#[derive(Serialize)]
pub(super) struct Drawn {
    picture: String,
    scale: u32,
}

impl From<Picture> for Drawn {
    fn from(picture: Picture) -> Drawn {
        Drawn {
            scale: picture.scale,
            picture: picture.json(),
        }
    }
}

#[derive(Serialize)]
pub(super) struct Summary {
    #[serde(flatten)]
    quantity: Quantity,
    value: String,
    at: Option<String>,
}

pub(super) fn summary(numbers: &Numbers, summary: &sheet::Summary) -> Summary {
    Summary {
        quantity: summary.symbol.into(),
        value: numbers.result(summary.symbol, summary.value),
        at: numbers.place(summary.at, summary.aside),
    }
}

/// A row of a table of values.
#[derive(Serialize)]
pub(super) struct Value {
    #[serde(flatten)]
    pub quantity: Quantity,
    /// The group of words that say what it is.
    pub words: &'static str,
    pub value: String,
}

#[derive(Serialize)]
pub(super) struct Table {
    columns: Vec<Quantity>,
    rows: Vec<Vec<String>>,
}

pub(super) fn table(numbers: &Numbers, table: &sheet::Table) -> Table {
    let of = |(i, symbol): (usize, &&'static Symbol)| numbers.column(symbol, table.rows.iter().map(|row| row[i]));
    let columns: Vec<Vec<String>> = table.columns.iter().enumerate().map(of).collect();
    let row = |i: usize| columns.iter().map(|column| column[i].clone()).collect();
    Table {
        columns: table.columns.iter().map(|&symbol| symbol.into()).collect(),
        rows: (0..table.rows.len()).map(row).collect(),
    }
}

/// What is given, to the last digit.
pub(super) fn given(numbers: &Numbers, table: &sheet::Table) -> Table {
    let cell = |(symbol, value): (&&'static Symbol, &f64)| numbers.language.text(&short(symbol.shown(*value)));
    Table {
        columns: table.columns.iter().map(|&symbol| symbol.into()).collect(),
        rows: (table.rows.iter())
            .map(|row| table.columns.iter().zip(row).map(cell).collect())
            .collect(),
    }
}

/// The working range, with all rows or some.
#[derive(Serialize)]
pub(super) struct Range {
    #[serde(flatten)]
    table: Table,
    one_in: Option<usize>,
}

/// The longest table over the working range that is printed with all its rows where the book is not a full one.
const MANY: usize = 50;
/// Of a longer one, one row in so many.
const ONE_IN: usize = 5;
/// The most rows that are printed of any table: nobody reads more, and each takes a tenth of a megabyte of memory.
const MOST: usize = 1000;

/// The rows to print, with the first and the last, and one in how many they are where some are left out.
pub(super) fn sparse<T>(rows: Vec<T>, full: bool) -> (Vec<T>, Option<usize>) {
    let usual = if full || rows.len() <= MANY { 1 } else { ONE_IN };
    let one_in = usual.max(rows.len().div_ceil(MOST));
    if one_in == 1 {
        return (rows, None);
    }
    let last = rows.len() - 1;
    let printed = |i: usize| i.is_multiple_of(one_in) || i == last;
    let rows = rows.into_iter().enumerate().filter(|(i, _)| printed(*i));
    (rows.map(|(_, row)| row).collect(), Some(one_in))
}

pub(super) fn range(numbers: &Numbers, table: &sheet::Table, full: bool) -> Range {
    let mut table = self::table(numbers, table);
    let one_in;
    (table.rows, one_in) = sparse(table.rows, full);
    Range { table, one_in }
}

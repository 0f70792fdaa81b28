//! Cases: what is given of each, what is asked at most, over the range, and where most is asked in full.

use lemnis_models::component::sheet::{self, CasesSheet, Sheet};
use lemnis_models::kernel::symbol::Symbol;
use serde::Serialize;

use crate::book::blocks::{Figure, Quantity, Range, Table, range, table};
use crate::book::notation::Notation;
use crate::book::steps::{Section, sections};
use crate::book::verdict::{Check, check};
use crate::print::number::Numbers;

#[derive(Serialize)]
pub(super) struct Cases {
    /// Group of the words that speak of them.
    words: &'static str,
    names: Vec<String>,
    /// A row for each quantity, a cell for each case.
    given: Vec<Row>,
    unconfirmed: Vec<Coefficient>,
    worked: Vec<Worked>,
    /// A row for each result, a cell for each case; one for all where it is the same in all.
    greatest: Vec<Extremes>,
    beside: Vec<Extremes>,
    ranges: Vec<OfCase>,
    curves: Vec<Figure>,
    judged: Vec<Judged>,
}

/// What a case must keep, and the criterion that asks for it, as far as it is known.
#[derive(Serialize)]
struct Judged {
    case: String,
    check: Check,
    criterion: Option<String>,
}

#[derive(Serialize)]
struct Row {
    #[serde(flatten)]
    quantity: Quantity,
    values: Vec<String>,
}

#[derive(Serialize)]
struct Extremes {
    #[serde(flatten)]
    quantity: Quantity,
    /// Values with their places.
    cells: Vec<(String, Option<String>)>,
}

#[derive(Serialize)]
struct Coefficient {
    #[serde(flatten)]
    quantity: Quantity,
    value: String,
    case: Option<String>,
    standard: &'static str,
}

#[derive(Serialize)]
struct Terms {
    id: &'static str,
    names: Vec<&'static str>,
    table: Table,
}

/// Formulas where most is asked: name of the case, and the place.
#[derive(Serialize)]
struct Worked {
    id: &'static str,
    case: String,
    at: String,
    sections: Vec<Section>,
    terms: Vec<Terms>,
    taken: Vec<Row>,
}

#[derive(Serialize)]
struct OfCase {
    id: &'static str,
    case: String,
    range: Range,
}

impl Worked {
    fn of(
        numbers: &Numbers,
        sheet: &Sheet,
        worked: &sheet::WorkedCase,
        case: String,
        notation: &mut Notation,
    ) -> Worked {
        Worked {
            id: worked.id,
            case,
            at: numbers.named(worked.coordinate, worked.at),
            sections: sections(numbers, &worked.sections, None, &sheet.requirements, notation),
            terms: (worked.terms.iter())
                .map(|(id, names, terms)| Terms {
                    id,
                    names: names.clone(),
                    table: table(numbers, terms),
                })
                .collect(),
            taken: (worked.taken.iter())
                .map(|(symbol, value)| Row {
                    quantity: (*symbol).into(),
                    values: vec![numbers.result(symbol, *value)],
                })
                .collect(),
        }
    }
}

/// All symbols of the chapter's tables and curves.
fn meet(cases: &CasesSheet, notation: &mut Notation) {
    let drawn = cases.curves.iter().flat_map(|curve| [curve.x, curve.y]);
    let terms = cases.worked.iter().flat_map(|worked| &worked.terms);
    let terms = terms.flat_map(|(_, _, table)| table.columns.iter().copied());
    let taken = cases
        .worked
        .iter()
        .flat_map(|worked| &worked.taken)
        .map(|(symbol, _)| *symbol);
    let given = cases.given.columns.iter().copied();
    let greatest = cases
        .greatest
        .iter()
        .chain(&cases.beside)
        .filter_map(|row| Some(row.first()?.symbol));
    let coefficients = cases.unconfirmed.iter().map(|(symbol, ..)| *symbol);
    for symbol in drawn
        .chain(terms)
        .chain(taken)
        .chain(given)
        .chain(greatest)
        .chain(coefficients)
        .chain(cases.judged.iter().map(|one| one.check.symbol))
    {
        notation.meet(symbol);
    }
}

impl Cases {
    pub(super) fn of(numbers: &Numbers, sheet: &Sheet, full: bool, notation: &mut Notation) -> Option<Cases> {
        let cases = sheet.cases.as_ref()?;
        let name = |case: usize| cases.names[case].of(numbers.language.code).to_owned();
        // Formulas first: what they find is explained there.
        let mut worked = Vec::new();
        for one in &cases.worked {
            worked.push(Worked::of(numbers, sheet, one, name(one.case), notation));
        }
        meet(cases, notation);
        let row = |(i, symbol): (usize, &&'static Symbol)| Row {
            quantity: (*symbol).into(),
            values: cases
                .given
                .rows
                .iter()
                .map(|row| numbers.given(symbol, row[i]))
                .collect(),
        };
        let cell = |found: &sheet::Summary| {
            let place = found
                .at
                .filter(|_| found.value != 0.0)
                .map(|(symbol, at)| numbers.result(symbol, at));
            (numbers.result(found.symbol, found.value), place)
        };
        let extremes = |all: &[Vec<sheet::Summary>]| {
            let row = |row: &Vec<sheet::Summary>| {
                Some(Extremes {
                    quantity: row.first()?.symbol.into(),
                    cells: row.iter().map(cell).collect(),
                })
            };
            all.iter().filter_map(row).collect()
        };
        Some(Cases {
            words: cases.words,
            names: (0..cases.names.len()).map(name).collect(),
            given: cases.given.columns.iter().enumerate().map(row).collect(),
            unconfirmed: (cases.unconfirmed.iter())
                .map(|(symbol, number, value, standard)| Coefficient {
                    quantity: (*symbol).into(),
                    value: numbers.given(symbol, *value),
                    case: number.map(|number| name(usize::from(number) - 1)),
                    standard,
                })
                .collect(),
            worked,
            greatest: extremes(&cases.greatest),
            beside: extremes(&cases.beside),
            ranges: (cases.ranges.iter())
                .map(|(id, case, table)| OfCase {
                    id,
                    case: name(*case),
                    range: range(numbers, table, full),
                })
                .collect(),
            curves: cases.curves.iter().map(|curve| Figure::new(numbers, curve)).collect(),
            judged: (cases.judged.iter())
                .map(|one| Judged {
                    case: name(one.case),
                    check: check(numbers, &one.check, None),
                    criterion: (one.criterion.as_ref()).map(|text| text.of(numbers.language.code).to_owned()),
                })
                .collect(),
        })
    }
}

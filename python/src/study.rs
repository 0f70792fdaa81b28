//! The rows of a study: the same as those of `lemnis sweep`, to the bit.

use std::ops::Range;
use std::sync::Arc;

use lemnis_models::kernel::shared::Watch;
use lemnis_models::kernel::symbol::Symbol;
use lemnis_study::rows::{Plan, Row};
use lemnis_study::run::run;
use numpy::PyArray1;
use pyo3::prelude::*;
use toml_edit::{DocumentMut, Item, Table};

use crate::errors::ModelError;
use crate::scene::Scene;
use crate::work;

/// Name, SI unit, display unit and its factor, typeset symbol, meaning, source.
type Column<'a> = (&'a str, &'a str, &'a str, f64, &'a str, &'a str, &'a str);
/// How many designs there are; columns of what varies and of what is looked at; ids of the requirements.
type Asked<'a> = (usize, Vec<Column<'a>>, Vec<Column<'a>>, Vec<&'static str>);
/// Columns of numbers, whether each requirement fails, and what is refused.
type Rows<'py> = (
    Vec<Bound<'py, PyArray1<f64>>>,
    Vec<Bound<'py, PyArray1<bool>>>,
    Vec<(usize, String)>,
);

fn none() -> PyErr {
    ModelError::new_err("the scene asks for no study")
}

fn column<'a>(name: &'a str, symbol: &Symbol) -> Column<'a> {
    let Symbol {
        unit,
        display,
        print,
        text,
        source,
        ..
    } = *symbol;
    (name, unit.name, display.name, display.factor, print, text, source)
}

/// What a scene's study asks for.
///
/// # Errors
/// A scene without one.
#[pyfunction]
pub fn study(scene: &Scene) -> PyResult<Asked<'_>> {
    let scene = scene.checked();
    let study = scene.study.as_ref().ok_or_else(none)?;
    let plan = Plan::new(scene, study);
    Ok((
        plan.designs.count(),
        study
            .varied
            .iter()
            .map(|varied| column(&varied.key, varied.symbol))
            .collect(),
        study
            .outputs
            .iter()
            .map(|output| column(&output.name, output.of.0))
            .collect(),
        plan.requirements.iter().map(|(id, _)| *id).collect(),
    ))
}

/// The scene's text with another study: what is given here in the place of what it has; without an `end` it draws nothing.
///
/// # Errors
/// What is no study.
#[pyfunction]
pub fn studied(
    scene: &Scene,
    vary: Option<Vec<(String, String)>>,
    outputs: Option<Vec<String>>,
    draws: bool,
    n: Option<i64>,
    seed: Option<i64>,
) -> PyResult<String> {
    let wrong = |what: String| ModelError::new_err(what);
    let text = scene.checked().text();
    let mut document: DocumentMut = text.parse().map_err(|error| wrong(format!("not TOML: {error}")))?;
    let entry = document.entry("study").or_insert(Item::Table(Table::new()));
    let Some(table) = entry.as_table_like_mut() else {
        return Err(wrong("`study` is no table".to_owned()));
    };
    if let Some(vary) = vary {
        let mut named = Table::new();
        vary.into_iter().for_each(|(key, law)| {
            named.insert(&key, law.into());
        });
        table.insert("vary", Item::Table(named));
    }
    if let Some(outputs) = outputs {
        let list: toml_edit::Array = outputs.into_iter().collect();
        table.insert("outputs", list.into());
    }
    for (key, value) in [("n", n), ("seed", seed)] {
        if let Some(value) = value {
            table.insert(key, value.into());
        }
    }
    if !draws {
        table.remove("n");
    }
    Ok(document.to_string())
}

/// Some rows of a scene's study, on so many threads.
///
/// # Errors
/// Ctrl+C, and a scene without a study.
#[pyfunction]
pub fn study_rows<'py>(
    py: Python<'py>,
    scene: &Scene,
    start: usize,
    stop: usize,
    threads: usize,
) -> PyResult<Rows<'py>> {
    let scene = Arc::clone(scene.shared());
    let mut done = work::shared(py, 1, move |broken| {
        let study = scene.study.as_ref()?;
        let plan = Plan::new(&scene, study);
        let rows: Range<usize> = start..stop.min(plan.designs.count());
        let mut table = Columns::new(&plan, rows.len());
        let watch = Watch {
            stop: broken,
            run: &|| (),
        };
        let Ok(()) = run(&plan, rows, threads, watch, |row| {
            table.take(&plan, row);
            Ok::<(), std::convert::Infallible>(())
        });
        Some(table)
    })?;
    let table = done.pop().flatten();
    let table = table.ok_or_else(none)?;
    let numbers = table.numbers.into_iter().map(|column| PyArray1::from_vec(py, column));
    let fails = table.fails.into_iter().map(|column| PyArray1::from_vec(py, column));
    Ok((numbers.collect(), fails.collect(), table.faults))
}

/// Rows as columns.
struct Columns {
    /// Of what varies, then of what is looked at.
    numbers: Vec<Vec<f64>>,
    fails: Vec<Vec<bool>>,
    faults: Vec<(usize, String)>,
}

impl Columns {
    fn new(plan: &Plan<'_>, rows: usize) -> Columns {
        let width = plan.study.varied.len() + plan.study.outputs.len();
        Columns {
            numbers: (0..width).map(|_| Vec::with_capacity(rows)).collect(),
            fails: plan.requirements.iter().map(|_| Vec::with_capacity(rows)).collect(),
            faults: Vec::new(),
        }
    }

    fn take(&mut self, plan: &Plan<'_>, row: Row) {
        let (outputs, fails) = match row.found {
            Ok(found) => (found.outputs, found.fails),
            Err(reason) => {
                self.faults.push((row.design, reason));
                // What is refused fails nothing: it is not judged.
                let (outputs, fails) = (plan.study.outputs.len(), plan.requirements.len());
                (vec![f64::NAN; outputs], vec![false; fails])
            }
        };
        let numbers = plan.designs.values(row.design).into_iter().chain(outputs);
        self.numbers
            .iter_mut()
            .zip(numbers)
            .for_each(|(column, value)| column.push(value));
        self.fails
            .iter_mut()
            .zip(fails)
            .for_each(|(column, fails)| column.push(fails));
    }
}

//! Every result of a scene in SI, with units: what `lemnis check --json` prints. An infinite value is null.

use std::collections::BTreeMap;

use lemnis_models::component::sheet::{self, Summary};
use serde::Serialize;

use crate::results::Results;

#[derive(Serialize)]
pub struct Told {
    pub name: String,
    /// In English, where the scene gives it in several languages.
    pub title: String,
    pub level: &'static str,
    /// Results of the whole range, by their names.
    pub summary: BTreeMap<&'static str, Total>,
    /// What is asked of results, and the calculation against itself.
    pub checks: Vec<Check>,
    /// Results of which the scene could ask something and does not.
    pub unjudged: Vec<&'static str>,
    /// What varies over the working range, by the names that it has in FMUs.
    pub variables: BTreeMap<String, Column>,
}

#[derive(Serialize)]
pub struct Total {
    pub value: f64,
    pub unit: &'static str,
    /// The coordinate where it is so.
    pub at: Option<BTreeMap<&'static str, f64>>,
}

#[derive(Serialize)]
pub struct Check {
    pub check: &'static str,
    pub symbol: &'static str,
    pub value: f64,
    pub limit: f64,
    /// Whether the value must not be above the limit, or not below.
    pub at_most: bool,
    pub passed: bool,
    /// Part of what is allowed that is used.
    pub utilisation: f64,
    /// Whether the scene asks for it, or the calculation judges itself.
    pub asked: bool,
}

#[derive(Serialize)]
pub struct Column {
    pub unit: &'static str,
    pub text: &'static str,
    pub source: &'static str,
    /// One for each position of the working range.
    pub values: Vec<f64>,
}

/// Zero without a sign.
fn number(value: f64) -> f64 {
    value + 0.0
}

impl Told {
    #[must_use]
    pub fn new(results: &Results) -> Told {
        let Results { scene, sheet, .. } = results;
        let total = |result: &Summary| {
            let both = result.at.into_iter().chain(result.aside);
            let places = both.map(|(coordinate, at)| (coordinate.id, number(at)));
            let at = result.at.map(|_| places.collect());
            let (value, unit) = (number(result.value), result.symbol.unit.name);
            (result.symbol.id, Total { value, unit, at })
        };
        let asked = sheet.requirements.iter().map(|check| self::check(check, true));
        let own = sheet.identities.iter().map(|check| self::check(check, false));
        let column = |(i, variable): (usize, &lemnis_models::kernel::variable::Variable)| {
            let symbol = variable.symbol;
            let column = Column {
                unit: symbol.unit.name,
                text: symbol.text,
                source: symbol.source,
                values: results.rows.iter().map(|row| number(row[i])).collect(),
            };
            (variable.name(), column)
        };
        Told {
            name: scene.name().to_owned(),
            title: scene.title().to_owned(),
            level: scene.level(),
            summary: results.sheet.results().map(total).collect(),
            checks: asked.chain(own).collect(),
            unjudged: sheet.unjudged.iter().map(|symbol| symbol.id).collect(),
            variables: results.columns.iter().enumerate().map(column).collect(),
        }
    }
}

fn check(check: &sheet::Check, asked: bool) -> Check {
    Check {
        check: check.id,
        symbol: check.symbol.id,
        value: number(check.value),
        limit: number(check.limit),
        at_most: check.at_most,
        passed: check.passed(),
        utilisation: number(check.utilisation()),
        asked,
    }
}

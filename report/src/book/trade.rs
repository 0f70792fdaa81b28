//! Speed against accuracy: what every level, solver and step costs by counted work, and how far it is off.

use lemnis_models::kernel::number::{rough, short};
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::kernel::variable::Variable;
use lemnis_models::scene::Scene;
use lemnis_trade::compared::Asked;
use lemnis_trade::parts::Part;
use lemnis_trade::setting::{Method, Setting};
use lemnis_trade::trade::{Errors, Failure, SAMPLE, Trade as Traded};
use serde::Serialize;

use crate::book::blocks::Quantity;
use crate::book::notation::Notation;
use crate::print::diagram::diagram;
use crate::print::number::Numbers;
use crate::template::Error;

#[derive(Serialize)]
pub(super) struct Trade {
    /// The command of the scene's own that moves it; none for the cycle through the working range.
    command: Option<&'static str>,
    duration: String,
    sample: String,
    deepest: &'static str,
    references: Vec<Reference>,
    /// Whether errors are over what is allowed, and not over ranges.
    asks: bool,
    picture: String,
    results: Vec<Compared>,
    rows: Vec<Row>,
    /// Level, solver and step or tolerance at which the solver refuses the motion.
    refused: Vec<Refused>,
    /// Place of the cheapest that keeps to the accuracy among the rows.
    choice: Option<usize>,
    /// Place of the row at whose setting the parts are left out.
    whole: usize,
    parts: Vec<LeftOut>,
}

#[derive(Serialize)]
struct Refused {
    level: &'static str,
    solver: &'static str,
    setting: Option<String>,
}

/// The scene without one of its parts.
#[derive(Serialize)]
struct LeftOut {
    path: String,
    /// Where it runs at another one than all parts do.
    setting: Option<String>,
    /// By counted work, and as a part of what all parts cost; none where it does not run.
    cost: Option<[String; 2]>,
    /// Of each result, in its unit.
    errors: Vec<String>,
}

/// How far apart two codes are on a level, as a part of a result's range.
#[derive(Serialize)]
struct Reference {
    level: &'static str,
    apart: Option<[String; 2]>,
}

#[derive(Serialize)]
struct Compared {
    #[serde(flatten)]
    quantity: Quantity,
    /// The symbol, with the number of the one among several.
    shown: String,
    allowed: Option<String>,
    range: String,
    /// How far off the choice is.
    off: Option<String>,
}

#[derive(Serialize)]
struct Row {
    level: &'static str,
    solver: &'static str,
    /// Step or tolerance, in Typst's mathematics.
    setting: Option<String>,
    /// By counted work: microseconds, evaluations of the rates and steps for each simulated second.
    cost: String,
    rates: String,
    steps: String,
    bytes: usize,
    /// The worst of all results, as parts of their ranges or of what is allowed.
    numerical: String,
    modelling: String,
    total: String,
    front: bool,
    follows: bool,
    holds: Option<bool>,
    /// Of each result: numerical, modelling and total; none where the level has none.
    errors: Vec<Option<[String; 3]>>,
}

/// Communication steps that are tried until two codes agree, in s.
const SAMPLES: [f64; 4] = [SAMPLE, 0.05, 0.02, 0.01];

impl Trade {
    /// # Errors
    /// A scene of which there is no reference, or that the solvers refuse.
    pub(super) fn new(numbers: &Numbers, scene: &Scene, notation: &mut Notation) -> Result<Trade, Error> {
        let traded = traded(scene).map_err(|failure| Error(format!("the chapter of trade: {failure}")))?;
        let names = scene.mechanism.solver().map(|own| [own.step.1, own.tolerance.1]);
        let asked = traded.asked.iter().map(|asked| asked.variable.symbol);
        for symbol in asked.chain(names.into_iter().flatten()) {
            notation.meet(symbol);
        }
        let second = |value: f64| format!("{} thin \"s\"", numbers.language.math(&short(value)));
        // A dash for what is not modelled.
        let digits = |value: f64| match value.is_finite() {
            true => numbers.language.math(&rough(value)),
            false => "–".to_owned(),
        };
        let asks = traded.asked.iter().any(|asked| asked.allowed.is_some());
        let over = |asked: &Asked| asked.allowed.unwrap_or(asked.range);
        let results = traded.asked.iter().enumerate();
        let results = results.map(|(i, asked)| compared(numbers, &traded, i, asked, &digits));
        let references = traded.references.iter().map(|reference| Reference {
            level: reference.level,
            apart: reference.apart.as_ref().map(|apart| {
                let asked = traded.asked.iter().find(|asked| asked.name == apart.result);
                let shown = asked.map_or_else(|| apart.result.clone(), |asked| shown(&asked.variable));
                [digits(apart.part), shown]
            }),
        });
        let rows = traded.rows.iter().map(|row| {
            let worst = |of: fn(&Errors) -> f64| {
                let parts = traded.asked.iter().zip(&row.errors);
                let parts = parts.map(|(asked, errors)| match errors {
                    None => f64::INFINITY,
                    Some(errors) if of(errors) == 0.0 => 0.0,
                    Some(errors) => of(errors) / over(asked),
                });
                digits(parts.fold(0.0, f64::max))
            };
            Row {
                level: row.setting.level,
                solver: solver(&row.setting),
                setting: setting(numbers, names, &row.setting),
                cost: digits(1e6 * row.cost),
                rates: per_second(numbers, row.work.rates, traded.duration),
                steps: per_second(numbers, row.work.steps, traded.duration),
                bytes: row.bytes,
                numerical: worst(|e| e.numerical.max),
                modelling: worst(|e| e.modelling.max),
                total: worst(|e| e.total.max),
                front: row.front,
                follows: row.follows,
                holds: row.holds,
                errors: traded
                    .asked
                    .iter()
                    .zip(&row.errors)
                    .map(|(asked, errors)| {
                        let symbol = asked.variable.symbol;
                        let size = |value: f64| digits(symbol.shown(value));
                        errors.map(|e| [e.numerical.max, e.modelling.max, e.total.max].map(size))
                    })
                    .collect(),
            }
        });
        let axes = ["e", "c thin \"/\" thin \"µs/s\""];
        Ok(Trade {
            command: traded.command.and_then(|id| {
                let mut inputs = traded_inputs(scene).into_iter();
                inputs.find(|symbol| symbol.id == id).map(|symbol| symbol.print)
            }),
            duration: second(traded.duration),
            sample: second(traded.sample),
            deepest: traded.references.last().map_or("static", |reference| reference.level),
            references: references.collect(),
            asks,
            picture: diagram(numbers.language, axes, &traded, |row| row.cost).json(),
            results: results.collect(),
            choice: traded.rows.iter().position(|row| row.holds == Some(true)),
            rows: rows.collect(),
            refused: refused(numbers, names, &traded),
            whole: traded.whole,
            parts: left_out(numbers, names, &traded, &digits),
        })
    }
}

/// Settings that the solver refuses.
fn refused(numbers: &Numbers, names: Option<[&'static Symbol; 2]>, traded: &Traded) -> Vec<Refused> {
    let of = |refused: &Setting| Refused {
        level: refused.level,
        solver: solver(refused),
        setting: setting(numbers, names, refused),
    };
    traded.refused.iter().map(|(setting, _)| of(setting)).collect()
}

/// The scene without each of its parts.
fn left_out(
    numbers: &Numbers,
    names: Option<[&'static Symbol; 2]>,
    traded: &Traded,
    digits: &dyn Fn(f64) -> String,
) -> Vec<LeftOut> {
    let whole = &traded.rows[traded.whole];
    let of = |part: &Part| {
        let without = part.without.as_ref().ok();
        let finer = without.filter(|without| without.setting != whole.setting);
        let errors = without.map_or(&[][..], |without| &without.errors);
        let errors = traded.asked.iter().zip(errors);
        LeftOut {
            path: part.path.clone(),
            setting: finer.and_then(|without| setting(numbers, names, &without.setting)),
            cost: without.map(|without| [1e6 * without.cost, without.cost / whole.cost].map(digits)),
            errors: errors
                .map(|(asked, error)| digits(asked.variable.symbol.shown(error.max)))
                .collect(),
        }
    };
    traded.parts.iter().map(of).collect()
}

/// How many for each of so many seconds.
fn per_second(numbers: &Numbers, count: u32, duration: f64) -> String {
    numbers.language.text(&short((f64::from(count) / duration).round()))
}

/// One of the results that are compared, with how far off the choice is.
fn compared(numbers: &Numbers, traded: &Traded, i: usize, asked: &Asked, digits: &dyn Fn(f64) -> String) -> Compared {
    let symbol = asked.variable.symbol;
    let off = traded.choice().and_then(|row| row.errors[i]);
    Compared {
        quantity: symbol.into(),
        shown: shown(&asked.variable),
        allowed: asked.allowed.map(|allowed| numbers.given(symbol, allowed)),
        range: numbers.result(symbol, asked.range),
        off: off.map(|errors| {
            let off = digits(symbol.shown(errors.total.max));
            format!("{off} thin \"{}\"", symbol.display.print)
        }),
    }
}

/// Without a clock, at the longest communication step at which two codes agree.
fn traded(scene: &Scene) -> Result<Traded, Failure> {
    let mut found = None;
    for sample in SAMPLES {
        match Traded::new(scene, sample, 0, &|| ()) {
            Err(failure @ Failure::Apart(..)) => found = Some(Err(failure)),
            other => return other,
        }
    }
    found.expect("several steps were tried")
}

fn traded_inputs(scene: &Scene) -> Vec<&'static Symbol> {
    let model = scene.model();
    let variables = model.as_ref().map_or(&[][..], |model| model.variables());
    variables.iter().map(|variable| variable.symbol).collect()
}

fn shown(variable: &Variable) -> String {
    match variable.number {
        Some(number) => variable.symbol.numbered(number),
        None => variable.symbol.print.to_owned(),
    }
}

/// Id of the solver's words.
fn solver(setting: &Setting) -> &'static str {
    match setting.method {
        Method::Closed => "closed",
        Method::Explicit(_) => "explicit",
        Method::Implicit(_) => "implicit",
        Method::Interpolated(_) => "interpolated",
    }
}

fn setting(numbers: &Numbers, names: Option<[&'static Symbol; 2]>, setting: &Setting) -> Option<String> {
    let [step, tolerance] = names?;
    let (symbol, value) = match setting.method {
        Method::Closed => return None,
        Method::Explicit(value) => (step, value),
        Method::Implicit(value) | Method::Interpolated(value) => (tolerance, value),
    };
    Some(format!("{} = {}", symbol.print, numbers.given(symbol, value)))
}

//! What `lemnis synth` does with a scene's table `[synthesis]`: its own quantities, searched for.

use std::fmt::Write as _;

use lemnis::machine;
use lemnis_models::kernel::diagnostic::Diagnostic;
use lemnis_models::kernel::number::{Digits, Number, rough, short};
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::request::{Aim, Goal, Request, Varied};
use lemnis_models::scene::Scene;
use lemnis_synthesis::asked::{Answer, Limited, Nothing, alone, calls, limits, seek};
use lemnis_synthesis::fit::{Fitted, fit};
use lemnis_synthesis::front::{Compromise, Compromises, front, runs};

use crate::commands::watched::{SEARCHING, watched};
use crate::failure::Failure;
use crate::output::say;
use crate::scene_file;

/// Of an objective: searches agree in them, whatever their seed.
const DIGITS: Digits = Digits::Significant(10);

/// Most other optima that are told.
const OTHERS: usize = 5;

/// A limit of which less than this part is left is at its end.
const AT_END: f64 = 1e-6;

pub const BROKEN_OFF: &str = "broken off: this is the best so far";

/// What a search of a scene's own quantities gives.
pub struct Searched {
    /// The scene with what was found.
    pub scene: Scene,
    /// Of two aims, what can be had of one for the other.
    pub front: Option<Listed>,
}

/// The designs of a front.
pub struct Listed {
    /// As CSV: the end of a file's name, and its text.
    pub file: (&'static str, String),
    /// The values of each quantity, as a scene writes them.
    pub along: Vec<(String, String)>,
}

/// What was found, told; `name` is what the scene is called in messages.
pub fn found(scene: &Scene, asked: &Request, seed: u64, name: &str) -> Result<Searched, Failure> {
    let refused = |diagnostic: Diagnostic| scene_file::failure(name, scene.text(), &[diagnostic]);
    alone(scene, asked).map_err(refused)?;
    let unfound = |nothing: Nothing| refused(explained(asked, &nothing));
    let mut listed = None;
    let (values, complete) = match asked.goal {
        Goal::Published => {
            let Some(fitted) = fit(&*scene.mechanism, asked, seed) else {
                let message = "the scene computes nothing at what was published, or nothing of it";
                return Err(refused(Diagnostic::new(
                    asked.place.clone(),
                    message,
                    "nothing to compare",
                )));
            };
            say(fitting(asked, &fitted).trim_end())?;
            (fitted.values, true)
        }
        Goal::Best(aim) => {
            let answer = watched(SEARCHING, calls(asked), |threads, watch| {
                seek(&*scene.mechanism, (asked, aim), &[], seed, threads, watch)
            });
            let answer = answer.map_err(unfound)?;
            say(optimum((asked, aim), &answer).trim_end())?;
            (answer.written, answer.complete)
        }
        Goal::Front(aims) => {
            let found = watched(SEARCHING, runs(asked), |threads, watch| {
                front(&*scene.mechanism, (asked, aims), seed, threads, watch)
            });
            let mut found = found.map_err(unfound)?;
            say(between_ends((asked, aims), &found).trim_end())?;
            listed = Some(Listed {
                file: ("front.csv", points((asked, aims), &found.points)),
                along: along(asked, &found.points),
            });
            (found.points.swap_remove(found.chosen).written, found.complete)
        }
    };
    if !complete {
        say(BROKEN_OFF)?;
    }
    let end = if complete { "" } else { ", broken off" };
    let source = format!("lemnis synth {}, seed {seed}{end}", env!("CARGO_PKG_VERSION"));
    let written = asked.varied.iter().zip(values);
    let written = written.map(|(varied, value)| {
        let value = varied.written(value);
        format!("{{ value = \"{value}\", source = \"{source}\" }}")
    });
    let text = asked.replaced(scene.text(), &written.collect::<Vec<String>>());
    let scene = Scene::parse(&text).map_err(|mistakes| {
        let told: Vec<String> = mistakes.iter().map(ToString::to_string).collect();
        let message = format!("what was found is no scene: {}", told.join("; "));
        let diagnostic = Diagnostic::new(asked.place.clone(), message, "the best that was found");
        refused(diagnostic.help("narrow the bounds to where the scene can be, or limit what it names"))
    })?;
    Ok(Searched { scene, front: listed })
}

/// Why nothing was found.
fn explained(asked: &Request, nothing: &Nothing) -> Diagnostic {
    let at = |values: &[f64]| {
        let all = asked.varied.iter().zip(values);
        let all = all.map(|(varied, value)| format!("{} = {}", varied.key, varied.written(*value)));
        all.collect::<Vec<String>>().join(", ")
    };
    match nothing {
        Nothing::Impossible => {
            let message = "nowhere within the bounds all results that are asked for exist";
            let help = "narrow the bounds to where the mechanism can be, or the working range";
            Diagnostic::new(asked.place.clone(), message, "nothing to compare").help(help)
        }
        Nothing::Missed {
            values, limit, result, ..
        } => {
            let limited = limits(asked)[*limit];
            let Limited { demand, limit, at_most } = limited;
            let symbol = demand.result.symbol;
            let message = format!(
                "no values within the bounds keep every limit: {} = {} at the nearest ones, {}",
                symbol.id,
                symbol.written(*result),
                at(values)
            );
            let side = if at_most { "most" } else { "least" };
            let label = format!("at {side} {} is allowed", symbol.written(limit));
            Diagnostic::new(demand.place.clone(), message, label).help("ease this limit, or widen the bounds")
        }
    }
}

fn unit(symbol: &Symbol) -> String {
    match symbol.display.name {
        "" | "1" => String::new(),
        name => format!(" {name}"),
    }
}

/// Rows of cells, in columns.
pub fn columns(text: &mut String, rows: &[Vec<String>]) {
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..rows[0].len()).map(width).collect();
    for row in rows {
        let cells = row.iter().zip(&widths).map(|(cell, width)| format!("{cell:<width$}"));
        let _ = writeln!(text, "  {}", cells.collect::<Vec<_>>().join("  ").trim_end());
    }
}

/// What is left of the conditions of an optimum, as a line.
pub fn residual(left: f64) -> String {
    format!("  residual of the conditions of an optimum: {}", rough(left))
}

fn cells<const N: usize>(cells: [&str; N]) -> Vec<String> {
    cells.map(str::to_owned).to_vec()
}

/// Which bound of a quantity a value lies at.
fn bound(varied: &Varied, value: f64) -> &'static str {
    let [low, high] = varied.bounds;
    match AT_END * (high - low) {
        _ if !varied.choices.is_empty() => "",
        near if value - low < near => "at its least",
        near if high - value < near => "at its greatest",
        _ => "",
    }
}

fn between(varied: &Varied) -> String {
    if varied.choices.is_empty() {
        let [low, high] = varied.bounds.map(|value| varied.written(value));
        return format!("{low} to {high}");
    }
    let all: Vec<String> = varied.choices.iter().map(|value| varied.written(*value)).collect();
    all.join(", ")
}

/// A result to the digits in which searches agree.
fn agreed(symbol: &Symbol, value: f64) -> String {
    format!("{}{}", Number::new(symbol.shown(value), DIGITS), unit(symbol))
}

/// What was found, and what holds it.
fn optimum((asked, aim): (&Request, Aim), answer: &Answer) -> String {
    let mut text = String::new();
    let symbol = aim.result.symbol;
    let _ = writeln!(
        text,
        "  {} {} = {}",
        aim.side(),
        symbol.id,
        agreed(symbol, answer.value)
    );
    let mut rows = vec![cells(["", "before", "found", "bounds", ""])];
    for (varied, value) in asked.varied.iter().zip(&answer.written) {
        let [before, found] = [varied.value, *value].map(|value| varied.written(value));
        rows.push(vec![
            varied.key.clone(),
            before,
            found,
            between(varied),
            bound(varied, *value).to_owned(),
        ]);
    }
    let limits = limits(asked);
    for (limited, value) in limits.iter().zip(&answer.results) {
        let symbol = limited.demand.result.symbol;
        let part = if limited.at_most {
            value / limited.limit
        } else {
            limited.limit / value
        };
        let held = (value - limited.limit).abs() <= AT_END * limited.limit.abs().max(f64::MIN_POSITIVE);
        rows.push(vec![
            symbol.id.to_owned(),
            if part.is_finite() {
                format!("{} %", short(100.0 * part))
            } else {
                String::new()
            },
            format!("{}{}", short(symbol.shown(*value)), unit(symbol)),
            format!(
                "at {} {}",
                if limited.at_most { "most" } else { "least" },
                symbol.written(limited.limit)
            ),
            if held { "at its limit" } else { "" }.to_owned(),
        ]);
    }
    columns(&mut text, &rows);
    let _ = writeln!(text, "{}", residual(answer.residual));
    for (values, value) in answer.others.iter().take(OTHERS) {
        let at = asked
            .varied
            .iter()
            .zip(values)
            .map(|(varied, value)| varied.written(*value));
        let at: Vec<String> = at.collect();
        let _ = writeln!(
            text,
            "  another optimum: {} at {}",
            agreed(symbol, *value),
            at.join(", ")
        );
    }
    text
}

/// The points of a front, and which of them the scene gets.
fn between_ends((asked, aims): (&Request, [Aim; 2]), front: &Compromises) -> String {
    let [one, other] = aims.map(|aim| format!("{} {}", aim.side(), aim.result.symbol.id));
    let what = match front.points.len() {
        1 => "one design is best for both",
        _ => "what can be had of one for the other",
    };
    let mut text = format!("  {one} and {other}: {what}\n");
    let ids = aims.map(|aim| aim.result.symbol.id.to_owned());
    let keys = asked.varied.iter().map(|varied| varied.key.clone());
    let mut rows = vec![
        ids.into_iter()
            .chain(keys)
            .chain([String::new()])
            .collect::<Vec<String>>(),
    ];
    for (i, point) in front.points.iter().enumerate() {
        let results = aims.iter().zip(point.aims);
        let results = results.map(|(aim, value)| {
            let symbol = aim.result.symbol;
            format!("{}{}", short(symbol.shown(value)), unit(symbol))
        });
        let values = asked.varied.iter().zip(&point.written);
        let values = values.map(|(varied, value)| varied.written(*value));
        let mark = if i == front.chosen && front.points.len() > 1 {
            "nearest to the best of both"
        } else {
            ""
        };
        rows.push(results.chain(values).chain([mark.to_owned()]).collect());
    }
    columns(&mut text, &rows);
    let worst = front.points.iter().map(|point| point.residual).fold(0.0, f64::max);
    let _ = writeln!(text, "{}", residual(worst));
    text
}

/// The points of a front as CSV: both aims, the quantities, and the limited results.
fn points((asked, aims): (&Request, [Aim; 2]), points: &[Compromise]) -> String {
    let limits = limits(asked);
    let head = |id: &str, symbol: &Symbol| format!("{id} [{}]", symbol.display.name);
    let mut rows: Vec<Vec<String>> = Vec::new();
    let results = aims.iter().map(|aim| aim.result.symbol);
    let limited = limits.iter().map(|limited| limited.demand.result.symbol);
    let of_result = |symbol: &'static Symbol| head(symbol.id, symbol);
    let keys = asked.varied.iter().map(|varied| head(&varied.key, varied.symbol));
    rows.push(
        results
            .clone()
            .map(of_result)
            .chain(keys)
            .chain(limited.clone().map(of_result))
            .collect(),
    );
    for point in points {
        let shown = |(symbol, value): (&'static Symbol, &f64)| machine::csv(symbol.shown(*value));
        let varied = asked.varied.iter().map(|varied| varied.symbol);
        let all = results.clone().zip(&point.aims).map(shown);
        let all = all.chain(varied.zip(&point.written).map(shown));
        rows.push(all.chain(limited.clone().zip(&point.results).map(shown)).collect());
    }
    machine::records(rows)
}

/// The values of each quantity along a front.
fn along(asked: &Request, points: &[Compromise]) -> Vec<(String, String)> {
    let of = |(i, varied): (usize, &Varied)| {
        let values = points.iter().map(|point| varied.written(point.written[i]));
        (varied.key.clone(), values.collect::<Vec<String>>().join(", "))
    };
    asked.varied.iter().enumerate().map(of).collect()
}

/// What a fit found, how far it is known, and what it leaves.
fn fitting(asked: &Request, fitted: &Fitted) -> String {
    let mut text = String::new();
    let _ = writeln!(
        text,
        "  {} published values, off by {} times the rounding of their last digits",
        fitted.count,
        short(fitted.left)
    );
    let mut rows = vec![cells(["", "before", "found", "standard error", "bounds", ""])];
    for ((varied, value), error) in asked.varied.iter().zip(&fitted.values).zip(&fitted.errors) {
        let error = match (error.is_finite(), varied.weighs) {
            (false, _) => "not told".to_owned(),
            (true, Some(g)) => format!("{} t", rough(error / (1e3 * g))),
            (true, None) => format!("{}{}", rough(error / varied.symbol.display.factor), unit(varied.symbol)),
        };
        let [before, found] = [varied.value, *value].map(|value| varied.written(value));
        rows.push(vec![
            varied.key.clone(),
            before,
            found,
            error,
            between(varied),
            bound(varied, *value).to_owned(),
        ]);
    }
    columns(&mut text, &rows);
    let mut rows = vec![cells(["left", "rms", "most"])];
    for (symbol, root, most) in &fitted.columns {
        let shown = |value: &f64| format!("{}{}", rough(value / symbol.display.factor), unit(symbol));
        rows.push(vec![symbol.id.to_owned(), shown(root), shown(most)]);
    }
    columns(&mut text, &rows);
    for direction in &fitted.alike {
        let all = asked.varied.iter().zip(direction).filter(|(_, part)| part.abs() > 1e-6);
        let keys: Vec<&str> = all.map(|(varied, _)| varied.key.as_str()).collect();
        let _ = match keys.as_slice() {
            [key] => writeln!(text, "  no published value follows from {key}"),
            keys => writeln!(text, "  cannot be told apart: {}", keys.join(", ")),
        };
    }
    let _ = writeln!(text, "{}", residual(fitted.residual));
    text
}

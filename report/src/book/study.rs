//! A study: what varies, what comes of it, and what moves what.

use std::sync::atomic::AtomicBool;

use lemnis_models::component::running::Running;
use lemnis_models::kernel::number::{Number, rough};
use lemnis_models::kernel::shared::Watch;
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::scene::Scene;
use lemnis_models::study::{Law, Output, Varying};
use lemnis_study::rows::Plan;
use lemnis_study::run::run;
use lemnis_study::summary::{Effect, Gathered};
use serde::Serialize;

use crate::book::blocks::Quantity;
use crate::book::notation::Notation;
use crate::print::number::{Numbers, change};
use crate::print::spread::{histogram, tornado};

#[derive(Serialize)]
pub(super) struct Study {
    /// How many designs the book computes, and how many the study has.
    designs: usize,
    asked: usize,
    /// Of drawn designs.
    seed: Option<u64>,
    varied: Vec<Row>,
    outputs: Vec<Result>,
    /// Share of the designs that fail any requirement, in percent; none where the scene asks for nothing.
    failed: Option<String>,
    /// Id of each requirement and the share that fails it.
    requirements: Vec<(&'static str, String)>,
    /// Share of the designs that are refused, and why the first one of the most frequent kind is.
    refused: Option<(String, String)>,
}

/// A quantity that varies.
#[derive(Serialize)]
struct Row {
    #[serde(flatten)]
    quantity: Quantity,
    /// The symbol, with the number of the one among several.
    shown: String,
    key: String,
    value: String,
    /// Id of the words for how it varies, and its numbers.
    law: &'static str,
    numbers: Vec<String>,
}

/// A result that is looked at.
#[derive(Serialize)]
struct Result {
    #[serde(flatten)]
    quantity: Quantity,
    shown: String,
    /// Position, where it is at one.
    at: Option<String>,
    /// Least, P5, P50, P95, greatest; none where all designs are refused.
    spread: Option<Vec<String>>,
    histogram: Option<String>,
    tornado: Option<String>,
    /// Of each quantity that varies: by the exact derivative, and by the sampled line.
    effects: Vec<[String; 2]>,
}

/// Most designs that a book computes: the first ones are a study of their own.
const MOST: usize = 4096;

impl Study {
    /// `None` where the scene asks for none.
    pub(super) fn of(numbers: &Numbers, scene: &Scene, notation: &mut Notation) -> Option<Study> {
        let study = scene.study.as_ref()?;
        let plan = Plan::new(scene, study);
        let mut gathered = Gathered::new(&plan);
        let rows = 0..plan.designs.count().min(MOST);
        let threads = std::thread::available_parallelism().map_or(1, usize::from);
        let watch = Watch {
            stop: &AtomicBool::new(false),
            run: &|| (),
        };
        let Ok(()) = run(&plan, rows, threads, watch, |row| {
            gathered.take(&row);
            Ok::<(), std::convert::Infallible>(())
        });
        let symbols = study.varied.iter().map(|varied| varied.symbol);
        for symbol in symbols.chain(study.outputs.iter().map(|output| output.of.0)) {
            notation.meet(symbol);
        }
        let effects = gathered.effects(&plan);
        let share = |count: usize| {
            let percent = 100.0 * count as f64 / gathered.rows().max(1) as f64;
            numbers.language.text(&rough(percent))
        };
        let outputs = study.outputs.iter().enumerate();
        let outputs = outputs.map(|(place, output)| {
            let effects: Vec<Effect> = effects.iter().map(|effects| effects[place]).collect();
            result(numbers, &plan, &gathered, (place, output), &effects)
        });
        let requirements = plan.requirements.iter().zip(&gathered.fails);
        let reason = gathered.reason().map(|(_, reason)| reason.to_owned());
        Some(Study {
            designs: gathered.rows(),
            asked: plan.designs.count(),
            seed: study.drawn.map(|_| study.seed),
            varied: study.varied.iter().map(|varied| row(numbers, varied)).collect(),
            outputs: outputs.collect(),
            failed: (!plan.requirements.is_empty()).then(|| share(gathered.failed)),
            requirements: requirements.map(|((id, _), count)| (*id, share(*count))).collect(),
            refused: reason.map(|reason| (share(gathered.refused()), reason)),
        })
    }
}

fn row(numbers: &Numbers, varied: &Varying) -> Row {
    let given = |value: f64| numbers.given(varied.symbol, value);
    let (law, told) = match &varied.law {
        Law::Values(values) => ("values", values.iter().copied().map(given).collect()),
        Law::Even(ends) => ("even", ends.map(given).to_vec()),
        Law::Normal { deviation, .. } => ("normal", vec![given(*deviation)]),
        Law::Triangular([low, _, high]) => ("triangular", [*low, *high].map(given).to_vec()),
    };
    Row {
        quantity: varied.symbol.into(),
        shown: shown(varied),
        key: varied.key.clone(),
        value: given(varied.value),
        law,
        numbers: told,
    }
}

/// Its symbol, with its number among several.
fn shown(varied: &Varying) -> String {
    let number = varied
        .key
        .rsplit_once('[')
        .and_then(|(_, rest)| rest.split_once(']')?.0.parse().ok());
    number.map_or_else(
        || varied.symbol.print.to_owned(),
        |number| varied.symbol.numbered(number),
    )
}

fn result(
    numbers: &Numbers,
    plan: &Plan<'_>,
    gathered: &Gathered,
    (place, output): (usize, &Output),
    effects: &[Effect],
) -> Result {
    let symbol = output.of.0;
    let spread = gathered.spread(place);
    let all = spread.map(|spread| [spread.least, spread.p5, spread.p50, spread.p95, spread.greatest]);
    let picture = all
        .and_then(|[_, p5, p50, p95, _]| histogram(numbers.language, symbol, &gathered.sorted(place), &[p5, p50, p95]));
    let names = plan.study.varied.iter().map(shown);
    let bars = names
        .zip(effects)
        .map(|(name, effect)| (name, [effect.exact, effect.sampled]));
    let coordinate = plan.scene.mechanism.standing().variables()[0].symbol;
    Result {
        quantity: symbol.into(),
        shown: output
            .of
            .1
            .map_or_else(|| symbol.print.to_owned(), |number| symbol.numbered(number)),
        at: output.at.map(|at| numbers.named(coordinate, at)),
        spread: all.map(|all| numbers.column(symbol, all.into_iter())),
        histogram: picture.map(|picture| picture.json()),
        tornado: tornado(bars.collect()).map(|picture| picture.json()),
        effects: effects.iter().map(|effect| told(numbers, symbol, effect)).collect(),
    }
}

fn told(numbers: &Numbers, symbol: &Symbol, effect: &Effect) -> [String; 2] {
    [effect.exact, effect.sampled].map(|effect| {
        let number: Option<Number> = effect.map(|effect| change(symbol.shown(effect)));
        number.map_or_else(|| "–".to_owned(), |number| numbers.language.text(&number))
    })
}

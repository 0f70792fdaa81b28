//! What every setting of a scene costs, measured, and the verdict.

use lemnis_models::kernel::number::{rough, short};
use lemnis_models::kernel::variable::Fault;
use lemnis_models::scene::Scene;
use lemnis_trade::parts::Part;
use lemnis_trade::realtime::{Paces, STEPS};
use lemnis_trade::trade::{self, Trade};

use crate::progress::Steps;

/// All settings of a scene, with a bar that moves from the start: a reference takes longer than all that follows.
pub fn measured(scene: &Scene, step: f64, rounds: usize) -> Result<Trade, trade::Failure> {
    watched(Trade::steps(scene, step), &|done| Trade::new(scene, step, rounds, done))
}

/// All levels of a scene by the clock, one communication step after the other, with such a bar.
///
/// # Errors
/// As [`Paces::new`].
pub fn paced(scene: &Scene, step: f64) -> Result<Paces, Fault> {
    watched(scene.levels().len(), &|done| Paces::new(scene, step, STEPS, done))
}

fn watched<T>(steps: usize, work: &dyn Fn(&dyn Fn()) -> T) -> T {
    let bar = Steps::new("{spinner} measuring {wide_bar} {percent} %, {elapsed}", steps);
    let done = work(&|| bar.step());
    bar.finish();
    done
}

/// Which level keeps to the time.
pub fn keeping(paces: &Paces) -> String {
    let step = format!("{} ms", short(paces.sample * 1e3));
    match paces.largest() {
        Some(pace) => format!(
            "the largest model that keeps to a step of {step} on this machine: {}",
            pace.level
        ),
        None => format!("no model keeps to a step of {step} on this machine: take a longer --step"),
    }
}

/// What was chosen and why, or what is missed.
pub fn verdict(scene: &Scene, traded: &Trade) -> String {
    let of = |i: usize, off: f64| {
        let asked = &traded.asked[i];
        let (symbol, unit) = (asked.variable.symbol, asked.variable.symbol.display.name);
        let allowed = asked
            .allowed
            .map_or_else(String::new, |a| format!(", {} allowed", symbol.written(a)));
        format!("{} off by {} {unit}{allowed}", asked.name, digits(symbol.shown(off)))
    };
    if let Some(row) = traded.choice() {
        let errors = row.errors.iter().enumerate();
        let errors = errors.filter_map(|(i, e)| Some(of(i, e.as_ref()?.total.max)));
        return format!(
            "the cheapest that keeps to the accuracy: {}; {}",
            row.setting,
            errors.collect::<Vec<_>>().join("; ")
        );
    }
    let Some((row, missed)) = traded.missed() else {
        return "nothing was measured".to_owned();
    };
    if missed.is_empty() {
        return format!(
            "the scene asks for no accuracy: add {} and the cheapest that keeps to it is named here",
            scene.example_of_accuracy()
        );
    }
    let missed = missed.iter().map(|missed| of(missed.result, missed.off));
    format!(
        "nothing keeps to the accuracy; nearest is {}: {}; allow as much, or remove these results from `accuracy`",
        row.setting,
        missed.collect::<Vec<_>>().join("; ")
    )
}

/// Parts without which every result is still as accurate as the scene asks, and what the rest costs.
pub fn dispensable(traded: &Trade) -> Vec<String> {
    let whole = &traded.rows[traded.whole];
    let of = |part: &Part| {
        let without = part
            .without
            .as_ref()
            .ok()
            .filter(|without| without.holds == Some(true))?;
        let left = match without.seconds.zip(whole.seconds) {
            Some((own, all)) => format!("{} of the time", percent(own / all)),
            None => format!("{} of the counted work", percent(without.cost / whole.cost)),
        };
        let path = &part.path;
        Some(format!(
            "without {path} the results keep to the accuracy too, in {left} at {}",
            without.setting
        ))
    };
    traded.parts.iter().filter_map(of).collect()
}

/// A part of a whole.
pub fn percent(part: f64) -> String {
    format!("{} %", short((100.0 * part).round()))
}

/// How great something is; a dash for what is not modelled.
pub fn digits(value: f64) -> String {
    match value.is_finite() {
        true => rough(value).to_string(),
        false => "-".to_owned(),
    }
}

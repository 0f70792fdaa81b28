//! The mechanism in motion: what is modelled, the equations at one instant, and the run.

use lemnis_models::component::sheet::{self, InMotion};
use lemnis_models::kernel::symbol::Symbol;
use serde::Serialize;

use crate::book::blocks::{Figure, Quantity};
use crate::book::notation::Notation;
use crate::book::steps::{Section, sections};
use crate::print::number::Numbers;

#[derive(Serialize)]
pub(super) struct Motion {
    /// What makes the instant one, and when it is.
    instant: &'static str,
    at: String,
    /// Number of the body that the formulas speak of.
    of: Option<usize>,
    state: Vec<Value>,
    sections: Vec<Section>,
    duration: String,
    sample: String,
    curves: Vec<Figure>,
    extremes: Vec<Extreme>,
    events: Vec<Event>,
    more_events: usize,
    energy: Energy,
}

#[derive(Serialize)]
struct Value {
    #[serde(flatten)]
    quantity: Quantity,
    value: String,
}

/// A value and its time, the least and the greatest.
#[derive(Serialize)]
struct Extreme {
    #[serde(flatten)]
    quantity: Quantity,
    least: [String; 2],
    greatest: [String; 2],
}

#[derive(Serialize)]
struct Event {
    at: String,
    id: &'static str,
}

/// What was given is what is stored and taken: all with its value, and the account in symbols and numbers.
#[derive(Serialize)]
struct Energy {
    values: Vec<Value>,
    given: [String; 2],
    used: [String; 2],
}

impl Motion {
    pub(super) fn new(
        numbers: &Numbers,
        motion: &InMotion,
        requirements: &[sheet::Check],
        notation: &mut Notation,
    ) -> Motion {
        let value = |&(symbol, value): &(&'static Symbol, f64)| Value {
            quantity: symbol.into(),
            value: numbers.in_formula(symbol, value),
        };
        let time = |at: f64| numbers.result(motion.time, at);
        for (symbol, _) in &motion.state {
            notation.meet(symbol);
        }
        let sections = sections(numbers, &motion.sections, None, requirements, notation);
        let energy = Energy::new(numbers, &motion.energy);
        let sheet::Energy { given, stored, taken } = &motion.energy;
        let accounts = given.iter().chain(stored).chain(taken).map(|(symbol, _)| *symbol);
        let drawn = motion.extremes.iter().map(|(symbol, _)| *symbol);
        for symbol in drawn.chain(accounts).chain([motion.time]) {
            notation.meet(symbol);
        }
        Motion {
            instant: motion.instant.0,
            at: time(motion.instant.1),
            of: motion.of,
            state: motion.state.iter().map(value).collect(),
            sections,
            duration: numbers.given(motion.time, motion.run[0]),
            sample: numbers.given(motion.time, motion.run[1]),
            curves: motion.curves.iter().map(|curve| Figure::new(numbers, curve)).collect(),
            extremes: motion
                .extremes
                .iter()
                .map(|(symbol, extremes)| {
                    let [least, greatest] = extremes.map(|[value, at]| [numbers.result(symbol, value), time(at)]);
                    Extreme {
                        quantity: (*symbol).into(),
                        least,
                        greatest,
                    }
                })
                .collect(),
            events: motion
                .events
                .iter()
                .map(|&(at, id)| Event { at: time(at), id })
                .collect(),
            more_events: motion.more_events,
            energy,
        }
    }
}

impl Energy {
    fn new(numbers: &Numbers, energy: &sheet::Energy) -> Energy {
        let sheet::Energy { given, stored, taken } = energy;
        let all: Vec<_> = [given, stored, taken].into_iter().flatten().copied().collect();
        let texts = numbers.account(&all);
        let sum = |part: std::ops::Range<usize>| {
            let symbols: Vec<&str> = all[part.clone()].iter().map(|(symbol, _)| symbol.print).collect();
            let number = |text: &String| match text.starts_with('-') {
                true => format!("({text})"),
                false => text.clone(),
            };
            let numbers: Vec<String> = texts[part].iter().map(number).collect();
            [symbols.join(" + "), numbers.join(" + ")]
        };
        let value = |((symbol, _), text): (&(&'static Symbol, f64), &String)| Value {
            quantity: (*symbol).into(),
            value: text.clone(),
        };
        Energy {
            values: all.iter().zip(&texts).map(value).collect(),
            given: sum(0..given.len()),
            used: sum(given.len()..all.len()),
        }
    }
}

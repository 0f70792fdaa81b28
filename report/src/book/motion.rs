//! The mechanism in motion: what is modelled, the equations at one instant, and the run.

use lemnis_models::component::sheet::{self, InMotion};
use lemnis_models::kernel::symbol::Symbol;
use serde::Serialize;

use crate::book::blocks::{Figure, Quantity};
use crate::book::notation::Notation;
use crate::book::steps::{Section, sections};
use crate::language::Language;
use crate::print::number::quantity;

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
    pub(super) fn new(language: &Language, motion: &InMotion, notation: &mut Notation) -> Motion {
        let value = |&(symbol, value): &(&'static Symbol, f64)| Value {
            quantity: symbol.into(),
            value: quantity(language, symbol, value),
        };
        let time = |at: f64| quantity(language, motion.time, at);
        for (symbol, _) in &motion.state {
            notation.meet(symbol);
        }
        let sections = sections(language, &motion.sections, None, notation);
        let energy = Energy::new(language, &motion.energy, &value);
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
            duration: time(motion.run[0]),
            sample: time(motion.run[1]),
            curves: motion.curves.iter().map(|curve| Figure::new(language, curve)).collect(),
            extremes: motion
                .extremes
                .iter()
                .map(|(symbol, extremes)| {
                    let [least, greatest] = extremes.map(|[value, at]| [quantity(language, symbol, value), time(at)]);
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
    fn new(language: &Language, energy: &sheet::Energy, value: &impl Fn(&(&'static Symbol, f64)) -> Value) -> Energy {
        let sheet::Energy { given, stored, taken } = energy;
        let used: Vec<_> = stored.iter().chain(taken).copied().collect();
        let sum = |list: &[(&'static Symbol, f64)]| {
            let symbols: Vec<&str> = list.iter().map(|(symbol, _)| symbol.print).collect();
            let number = |(symbol, value): &(&'static Symbol, f64)| match *value < 0.0 {
                true => format!("({})", quantity(language, symbol, *value)),
                false => quantity(language, symbol, *value),
            };
            let numbers: Vec<String> = list.iter().map(number).collect();
            [symbols.join(" + "), numbers.join(" + ")]
        };
        Energy {
            values: given.iter().chain(&used).map(value).collect(),
            given: sum(given),
            used: sum(&used),
        }
    }
}

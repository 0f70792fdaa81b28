//! The mechanism in motion: what is modelled, its manoeuvres, and the equations at one instant.

use lemnis_models::component::sheet::{self, InMotion};
use lemnis_models::kernel::record::{Node, Op};
use lemnis_models::kernel::symbol::Symbol;
use serde::Serialize;

use crate::book::blocks::{Figure, Quantity, Value};
use crate::book::notation::Notation;
use crate::book::steps::{Section, sections};
use crate::print::number::Numbers;

#[derive(Serialize)]
pub(super) struct Motion {
    /// Ids of what makes the instant one and of its manoeuvre, and when it is.
    instant: &'static str,
    during: &'static str,
    at: String,
    /// Number of the body that the formulas speak of.
    of: Option<usize>,
    state: Vec<Value>,
    constants: Vec<Value>,
    sections: Vec<Section>,
    ramp: Option<String>,
    rules: Vec<&'static str>,
    manoeuvres: Vec<Manoeuvre>,
    envelope: Vec<Envelope>,
    /// Whether it is known of any of these what it is at rest.
    still: bool,
    /// Whether anything happened.
    eventful: bool,
    /// Whether derivatives by the coordinate come from dual numbers.
    duals: bool,
    energy: Account,
}

#[derive(Serialize)]
struct Manoeuvre {
    id: &'static str,
    start: String,
    duration: String,
    sample: String,
    curves: Vec<Figure>,
    events: Vec<Event>,
    stop: Vec<Stop>,
    more_events: usize,
}

/// What a stop came to: found in the run, and in closed form.
#[derive(Serialize)]
struct Stop {
    #[serde(flatten)]
    quantity: Quantity,
    values: [String; 2],
}

#[derive(Serialize)]
struct Event {
    at: String,
    id: &'static str,
}

/// Least and greatest values of a result.
#[derive(Serialize)]
struct Envelope {
    #[serde(flatten)]
    quantity: Quantity,
    ends: [End; 2],
}

#[derive(Serialize)]
struct End {
    /// At rest, with its place if it has one.
    still: Option<(String, Option<String>)>,
    moving: Vec<Cell>,
}

/// A value, when it is so, and where.
#[derive(Serialize)]
struct Cell {
    value: String,
    time: String,
    at: String,
    /// Whether no other manoeuvre goes farther.
    governs: bool,
}

/// What was given is what is stored and taken: a column for each manoeuvre, and the account in symbols.
#[derive(Serialize)]
struct Account {
    rows: Vec<AccountRow>,
    /// Amounts that are sums of powers: what, and of what.
    integrals: Vec<[String; 2]>,
    given: String,
    used: String,
}

#[derive(Serialize)]
struct AccountRow {
    #[serde(skip)]
    symbol: &'static Symbol,
    #[serde(flatten)]
    quantity: Quantity,
    values: Vec<String>,
}

impl Motion {
    pub(super) fn new(
        numbers: &Numbers,
        motion: &InMotion,
        requirements: &[sheet::Check],
        notation: &mut Notation,
    ) -> Motion {
        let time = |at: f64| numbers.result(motion.time, at);
        let state = notation.values(numbers, &motion.state);
        let constants = notation.values(numbers, &motion.constants);
        let sections = sections(numbers, &motion.sections, None, requirements, notation);
        let energies = motion.manoeuvres.iter().map(|manoeuvre| &manoeuvre.energy);
        let energy = Account::new(numbers, energies.collect(), &motion.integrals);
        let powers = motion.integrals.iter().flat_map(|integral| &integral.of);
        let powers = powers.flat_map(|power| power.factors.iter().copied().chain(power.over));
        for symbol in powers {
            notation.meet(symbol);
        }
        let drawn = motion.manoeuvres.iter().flat_map(|manoeuvre| &manoeuvre.curves);
        let drawn = drawn
            .map(|curve| curve.y)
            .chain(motion.envelope.iter().map(|row| row.symbol));
        let accounts = energy.rows.iter().map(|row| row.symbol);
        let stops = motion.manoeuvres.iter().flat_map(|manoeuvre| &manoeuvre.stop);
        let stops = stops.map(|(symbol, _)| *symbol);
        for symbol in drawn.chain(accounts).chain(stops).chain([motion.time]) {
            notation.meet(symbol);
        }
        let manoeuvre = |manoeuvre: &sheet::Manoeuvre| Manoeuvre {
            id: manoeuvre.id,
            start: numbers.named(motion.coordinate, manoeuvre.start),
            duration: numbers.given(motion.time, manoeuvre.run[0]),
            sample: numbers.given(motion.time, manoeuvre.run[1]),
            curves: manoeuvre
                .curves
                .iter()
                .map(|curve| Figure::new(numbers, curve))
                .collect(),
            events: (manoeuvre.events.iter())
                .map(|&(at, id)| Event { at: time(at), id })
                .collect(),
            stop: (manoeuvre.stop.iter())
                .map(|&(symbol, values)| Stop {
                    quantity: symbol.into(),
                    values: values.map(|value| numbers.result(symbol, value)),
                })
                .collect(),
            more_events: manoeuvre.more_events,
        };
        Motion {
            instant: motion.instant.0,
            during: motion.instant.1,
            at: numbers.named(motion.time, motion.instant.2),
            of: motion.of,
            state,
            constants,
            sections,
            rules: motion.rules.clone(),
            ramp: motion.ramp.map(|(symbol, time)| numbers.named(symbol, time)),
            manoeuvres: motion.manoeuvres.iter().map(manoeuvre).collect(),
            envelope: motion
                .envelope
                .iter()
                .map(|row| Envelope::new(numbers, motion, row))
                .collect(),
            still: motion.envelope.iter().any(|row| row.still.is_some()),
            eventful: motion.manoeuvres.iter().any(|run| !run.events.is_empty()),
            duals: motion.sections.iter().any(has_derivatives),
            energy,
        }
    }
}

/// Whether a formula is the derivative of another one.
fn has_derivatives(section: &sheet::Section) -> bool {
    let trace = &section.trace;
    let mut nodes = trace.steps.iter().map(|step| trace.node(step.formula));
    nodes.any(|node| matches!(node, Node::Binary(Op::Derivative, ..)))
}

/// A term of a sum of powers, with its sign.
fn power(power: &sheet::Power) -> String {
    let sign = if power.negative { "-" } else { "+" };
    let factors: Vec<&str> = power.factors.iter().map(|symbol| symbol.print).collect();
    let product = factors.join(" ");
    match power.over {
        Some(over) => format!("{sign} frac({product}, {})", over.print),
        None => format!("{sign} {product}"),
    }
}

impl Envelope {
    fn new(numbers: &Numbers, motion: &InMotion, row: &sheet::Envelope) -> Envelope {
        let end = |i: usize| {
            let sign = [-1.0, 1.0][i];
            let most = row
                .moving
                .iter()
                .map(|ends| sign * ends[i].value)
                .fold(f64::NEG_INFINITY, f64::max);
            let cell = |ends: &[sheet::Stand; 2]| Cell {
                value: numbers.result(row.symbol, ends[i].value),
                time: numbers.result(motion.time, ends[i].time),
                at: numbers.result(motion.coordinate, ends[i].at),
                governs: sign * ends[i].value == most,
            };
            let still = row.still.map(|ends| {
                let place = ends[i].at.map(|(symbol, at)| numbers.result(symbol, at));
                (numbers.result(row.symbol, ends[i].value), place)
            });
            End {
                still,
                moving: row.moving.iter().map(cell).collect(),
            }
        };
        Envelope {
            quantity: row.symbol.into(),
            ends: [end(0), end(1)],
        }
    }
}

impl Account {
    fn new(numbers: &Numbers, energies: Vec<&sheet::Energy>, integrals: &[sheet::Integral]) -> Account {
        let all = |energy: &sheet::Energy| {
            let parts = [&energy.given, &energy.stored, &energy.taken];
            parts.into_iter().flatten().copied().collect::<Vec<_>>()
        };
        let columns: Vec<Vec<String>> = energies.iter().map(|energy| numbers.account(&all(energy))).collect();
        let symbols: Vec<&'static Symbol> = energies.first().map_or(Vec::new(), |energy| {
            all(energy).into_iter().map(|(symbol, _)| symbol).collect()
        });
        let given = energies.first().map_or(0, |energy| energy.given.len());
        let sum = |part: &[&'static Symbol]| part.iter().map(|symbol| symbol.print).collect::<Vec<_>>().join(" + ");
        let row = |(i, symbol): (usize, &&'static Symbol)| AccountRow {
            symbol,
            quantity: (*symbol).into(),
            values: columns.iter().map(|column| column[i].clone()).collect(),
        };
        let of = |integral: &sheet::Integral| {
            let powers = integral.of.iter().map(power).collect::<Vec<_>>().join(" ");
            // The first one needs no plus.
            let powers = powers.strip_prefix("+ ").unwrap_or(&powers).to_owned();
            [integral.symbol.print.to_owned(), powers]
        };
        Account {
            integrals: integrals.iter().map(of).collect(),
            rows: symbols.iter().enumerate().map(row).collect(),
            given: sum(&symbols[..given]),
            used: sum(&symbols[given..]),
        }
    }
}

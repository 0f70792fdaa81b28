//! What a scene asks of a search for its own quantities: the table `[synthesis]`. The search itself is the crate
//! `lemnis_synthesis`.

use std::ops::Range;

use crate::component::governing::extremes;
use crate::component::mechanism::Mechanism;
use crate::component::outline::Greatest;
use crate::component::running::Running;
use crate::component::stages::{Slot, Source};
use crate::component::standing::{Standing, VariablePlace};
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::measure;
use crate::kernel::number::exponent;
use crate::kernel::origin::Origins;
use crate::kernel::schema::{COUNTLESS, Key, Kind, Values};
use crate::kernel::sign::Sign;
use crate::kernel::symbol::Symbol;
use crate::vary::{self, Named, bounds, choices, list, number, source};

/// Keys of `[synthesis]`.
pub static SYNTHESIS: &[Key] = &[
    Key::new(
        "objective",
        Kind::Name,
        "What is searched for: \"least epsilon_Y\", \"greatest R_max\", any result of the whole range; two of them, \
         \"least T_max and least l_l_max\", for what can be had of one for the other; or \"published\", the quantities whose \
         results are nearest to the published table.",
    ),
    Key::new(
        "vary",
        Kind::Named,
        "Quantities of the scene that the search may change, each with its bounds: { \"luffing.X_7\" = \"1 m to 2 m\" }, \
         or with what it may be: \"2, 3 or 4\".",
    ),
    Key::new(
        "constraints",
        Kind::Named,
        "What results of the whole range must keep: { T_max = \"at most 200 kN\", mu_min = \"at least 30 deg\" }, or \
         \"... to ...\".",
    )
    .optional(),
    Key::new(
        "before",
        Kind::Named,
        "What the quantities were before the search, for the book to compare; `lemnis synth` notes it.",
    )
    .optional(),
    Key::new(
        "front",
        Kind::Named,
        "What the quantities are along the front of two aims, from the best for the first one on, for the book to draw; \
         `lemnis synth` notes it: { \"luffing.X_7\" = \"1.1 m, 1.2 m\" }.",
    )
    .optional(),
    Key::new(
        "seed",
        Kind::Count([0, COUNTLESS]),
        "Seed of the search: the same seed gives the same result.",
    )
    .optional(),
];

/// Most combinations of choices.
const MOST: usize = 64;

/// Decimals of what is found.
const DECIMALS: i32 = 6;

/// A search that a scene asks for; SI.
#[derive(Clone, Debug)]
pub struct Request {
    pub goal: Goal,
    pub varied: Vec<Varied>,
    pub demands: Vec<RangeLimit>,
    /// Quantities that have been chosen, with their values.
    pub chosen: Vec<(Source, f64)>,
    pub seed: u64,
    /// Place of the table's objective.
    pub place: Range<usize>,
}

/// What is searched for.
#[derive(Clone, Copy, Debug)]
pub enum Goal {
    Best(Aim),
    /// What can be had of one for the other.
    Front([Aim; 2]),
    Published,
}

/// A result that is to be least or greatest.
#[derive(Clone, Copy, Debug)]
pub struct Aim {
    pub result: RangeResult,
    pub greatest: bool,
}

impl Aim {
    /// 1 where less is better, -1 where more is.
    #[must_use]
    pub fn sign(&self) -> f64 {
        if self.greatest { -1.0 } else { 1.0 }
    }

    /// As a scene has it.
    #[must_use]
    pub fn side(&self) -> &'static str {
        if self.greatest { "greatest" } else { "least" }
    }
}

/// A quantity that may change.
#[derive(Clone, Debug)]
pub struct Varied {
    /// As the scene has it.
    pub key: String,
    pub symbol: &'static Symbol,
    pub source: Source,
    pub bounds: [f64; 2],
    /// What it may be, where that is not everything between its bounds.
    pub choices: Vec<f64>,
    /// What the scene has now, and what it had before the search, where it notes that.
    pub value: f64,
    pub before: Option<f64>,
    /// What it is in each design of a front, where the scene notes that.
    pub front: Vec<f64>,
    /// What a unit of mass weighs, where it is a weight given as a mass, in m/s².
    pub weighs: Option<f64>,
    /// Where the scene gives it, and where it asks for another value.
    pub given: Range<usize>,
    pub place: Range<usize>,
}

/// What a result must keep.
#[derive(Clone, Debug)]
pub struct RangeLimit {
    pub result: RangeResult,
    pub least: Option<f64>,
    pub most: Option<f64>,
    pub place: Range<usize>,
}

/// A result of the whole working range.
#[derive(Clone, Copy, Debug)]
pub struct RangeResult {
    pub symbol: &'static Symbol,
    pub found: RangeFound,
}

/// How it is found.
#[derive(Clone, Copy, Debug)]
pub enum RangeFound {
    Extreme(&'static Greatest),
    /// By its place among the model's [`wholes`](Standing::wholes).
    Whole(usize),
    /// Of what does not change over the range.
    Steady(Slot),
}

impl Request {
    /// Of a checked table; mistakes go to `found`.
    pub fn read(
        v: &Values,
        mechanism: &dyn Mechanism,
        given: &Origins,
        gravity: f64,
        found: &mut Vec<Diagnostic>,
    ) -> Option<Request> {
        let before = found.len();
        let model = mechanism.standing();
        let mut varied: Vec<Varied> = Vec::new();
        for (key, text, place) in v.named("vary") {
            match vary(&model, given, gravity, (key, text, place)) {
                Ok(one) if varied.iter().any(|other| other.given == one.given) => {
                    let message = format!("`{key}` may change twice");
                    found.push(Diagnostic::new(place.clone(), message, "named before").help("remove one of them"));
                }
                Ok(one) => varied.push(one),
                Err(refused) => found.push(*refused),
            }
        }
        if v.has("vary") && v.named("vary").is_empty() {
            let help = "name a quantity of the scene with its bounds: { \"luffing.X_7\" = \"1 m to 2 m\" }";
            found.push(v.refuse("vary", "nothing may change", "nothing to search for", help));
        }
        noted(&mut varied, v, found);
        let all = results(&model, mechanism);
        let goal = goal(v, mechanism, &all).map_err(|refused| found.push(*refused)).ok();
        let mut demands = Vec::new();
        for (id, text, place) in v.named("constraints") {
            match demand(&all, (id, text, place)) {
                Ok(demand) => demands.push(demand),
                Err(refused) => found.push(*refused),
            }
        }
        if let (Some(Goal::Published), [first, ..]) = (goal, demands.as_slice()) {
            let message = "a fit to published values has no constraints";
            let help = "remove the table of constraints, or name a result as the objective";
            found.push(Diagnostic::new(first.place.clone(), message, "not used").help(help));
        }
        if let (Some(Goal::Published), Some(one)) = (goal, varied.iter().find(|one| !one.choices.is_empty())) {
            let message = format!("a fit to published values has no choices, and `{}` has", one.key);
            let help = "write bounds: \"... to ...\"";
            found.push(Diagnostic::new(one.place.clone(), message, "not between bounds").help(help));
        }
        let count: usize = varied.iter().map(|one| one.choices.len().max(1)).product();
        if count > MOST {
            let message = format!("{count} combinations of choices");
            let help = format!("at most {MOST} are searched, one after the other: leave some out");
            found.push(v.refuse("vary", message, "too many", help));
        }
        // In the order of the scene.
        varied.sort_by_key(|one| one.place.start);
        demands.sort_by_key(|one| one.place.start);
        let request = Request {
            goal: goal?,
            varied,
            demands,
            chosen: Vec::new(),
            seed: v.count("seed").unwrap_or(1),
            place: v.place("objective"),
        };
        (found.len() == before).then_some(request)
    }

    /// A request for each combination of choices, with what is chosen; this one where there are none.
    #[must_use]
    pub fn combinations(&self) -> Vec<Request> {
        let mut all = vec![self.clone()];
        all[0].varied.retain(|varied| varied.choices.is_empty());
        for varied in &self.varied {
            for request in std::mem::take(&mut all) {
                if varied.choices.is_empty() {
                    all.push(request);
                    continue;
                }
                for &choice in &varied.choices {
                    let mut one = request.clone();
                    one.chosen.push((varied.source, choice));
                    all.push(one);
                }
            }
        }
        all
    }

    /// The scene's text with other values, each as it is to stand there.
    #[must_use]
    pub fn replaced(&self, text: &str, values: &[String]) -> String {
        let mut places: Vec<(&Range<usize>, &String)> =
            self.varied.iter().map(|varied| &varied.given).zip(values).collect();
        places.sort_by_key(|(place, _)| place.start);
        let mut changed = text.to_owned();
        for (place, value) in places.into_iter().rev() {
            changed.replace_range(place.clone(), value);
        }
        changed
    }
}

impl Varied {
    /// Number and unit, as a scene writes them: millionths of the unit of display, or of the greater bound.
    #[must_use]
    pub fn written(&self, value: f64) -> String {
        let (shown, unit): (&dyn Fn(f64) -> f64, _) = match &self.weighs {
            Some(g) => (&move |value| value / (1e3 * g), "t"),
            None => (&|value| self.symbol.shown(value), self.symbol.display.name),
        };
        let [low, high] = self.bounds.map(|bound| shown(bound).abs());
        let decimals = usize::try_from(DECIMALS - exponent(low.max(high)).min(0)).unwrap_or_default();
        let shown = shown(value);
        let text = format!("{shown:.decimals$}");
        let text = text.trim_end_matches('0').trim_end_matches('.');
        let text = if text == "-0" { "0" } else { text };
        match unit {
            "1" | "" => text.to_owned(),
            unit => format!("{text} {unit}"),
        }
    }

    /// What [`written`](Varied::written) is read as.
    ///
    /// # Panics
    /// Never: what a scene writes it reads.
    #[must_use]
    pub fn rounded(&self, value: f64) -> f64 {
        let written = self.written(value);
        number(&written, self.symbol, self.weighs).unwrap_or_else(|_| panic!("{written} is written"))
    }
}

/// A quantity that the search may change, if the equations have it.
fn vary(model: &Standing, all: &Origins, gravity: f64, named: Named<'_>) -> Result<Varied, Box<Diagnostic>> {
    let (key, text, place) = named;
    let refuse = |message: String, label: &str, help: String| {
        Err(Box::new(Diagnostic::new(place.clone(), message, label).help(help)))
    };
    let (known, origin) = vary::given(all, named, |known| source(model, known).is_ok())?;
    let source = match source(model, known) {
        Ok(source) => source,
        Err(why) => {
            let message = format!("`{key}` cannot be searched for: {why}");
            return refuse(
                message,
                "not free",
                "name a quantity that formulas of the book have".to_owned(),
            );
        }
    };
    let weighs = origin.mass.map(|_| gravity);
    let values = choices(text, known.symbol, weighs).and_then(|choices| {
        let ends = |ends: [f64; 2], choice: &f64| [ends[0].min(*choice), ends[1].max(*choice)];
        let bounds = match choices.first() {
            Some(first) => choices.iter().fold([*first; 2], ends),
            None => bounds(text, known.symbol, |text| number(text, known.symbol, weighs))?,
        };
        Ok((bounds, choices))
    });
    let (bounds, choices) = values.map_err(|problem| vary::wrong(named, problem))?;
    vary::allowed(named, known.symbol, &bounds)?;
    if choices.is_empty() && !(bounds[0]..=bounds[1]).contains(&known.value) {
        let message = format!(
            "`{key}` = {} lies outside its bounds",
            known.symbol.written(known.value)
        );
        return refuse(
            message,
            "without it",
            "widen the bounds, or begin within them".to_owned(),
        );
    }
    Ok(Varied {
        key: origin.key.clone(),
        symbol: known.symbol,
        source,
        bounds,
        choices,
        value: known.value,
        before: None,
        front: Vec::new(),
        weighs,
        given: origin.place.clone(),
        place: place.clone(),
    })
}

/// A table of what quantities were, or are elsewhere, what it tells of each, and how it is taken down.
type Note = (
    &'static str,
    &'static str,
    fn(&mut Varied, &str) -> Result<(), measure::Problem>,
);

const NOTES: [Note; 2] = [
    ("before", "was something before the search", |one, text| {
        number(text, one.symbol, one.weighs).map(|before| one.before = Some(before))
    }),
    ("front", "is something along a front", |one, text| {
        list(text, one.symbol, one.weighs).map(|front| one.front = front)
    }),
];

/// Takes down what quantities were before the search, and are along a front.
fn noted(varied: &mut [Varied], v: &Values, found: &mut Vec<Diagnostic>) {
    let sound = found.len();
    for (table, tells, note) in NOTES {
        for (key, text, place) in v.named(table) {
            let Some(one) = varied.iter_mut().find(|one| one.key == *key) else {
                let message = format!("`{key}` {tells}, and does not vary");
                let help = "name it under `vary`, or remove this";
                found.push(Diagnostic::new(place.clone(), message, "not searched for").help(help));
                continue;
            };
            let wrong = note(one, text).map_err(|problem| *vary::wrong((key, text, place), problem));
            found.extend(wrong.err());
        }
    }
    let uneven = varied.iter().find(|one| one.front.len() != varied[0].front.len());
    if let Some(other) = uneven.filter(|_| found.len() == sound) {
        let [first, count] = [&varied[0], other].map(|one| one.front.len());
        let (known, key) = (&varied[0].key, &other.key);
        let message = format!("{first} designs of a front have `{known}`, {count} `{key}`");
        let help = "give as many values of each quantity, or remove `front`";
        found.push(v.refuse("front", message, "not as many", help));
    }
}

/// Results of the whole range that have derivatives.
fn results(model: &Standing, mechanism: &dyn Mechanism) -> Vec<RangeResult> {
    let smooth = |slot: &Slot| !model.part().stages()[usize::from(slot.stage)].searched;
    let of = extremes(model, mechanism.outline()).filter(|(_, slot)| smooth(slot));
    let mut all: Vec<RangeResult> = of
        .map(|(extreme, _)| RangeResult {
            symbol: extreme.symbol,
            found: RangeFound::Extreme(extreme),
        })
        .collect();
    let varies = [model.coordinate(), model.rate()].map(|source| 1_u64 << source.group);
    for (variable, place) in model.variables().iter().zip(model.places()) {
        let found = match place {
            VariablePlace::Whole(whole) => RangeFound::Whole(*whole),
            VariablePlace::Result(slot)
                if variable.number.is_none() && smooth(slot) && varies.iter().all(|bit| slot.sources & bit == 0) =>
            {
                RangeFound::Steady(*slot)
            }
            _ => continue,
        };
        if all.iter().any(|result| result.symbol == variable.symbol) {
            continue;
        }
        all.push(RangeResult {
            symbol: variable.symbol,
            found,
        });
    }
    all
}

/// The result with an id.
fn named(all: &[RangeResult], id: &str, place: &Range<usize>) -> Result<RangeResult, Box<Diagnostic>> {
    all.iter()
        .find(|result| result.symbol.id == id)
        .copied()
        .ok_or_else(|| {
            let known: Vec<&str> = all.iter().map(|result| result.symbol.id).collect();
            let message = format!("`{id}` is no result of the whole range of this scene");
            let help = format!("results here: {}", known.join(", "));
            Box::new(Diagnostic::new(place.clone(), message, "not known").help(help))
        })
}

fn goal(v: &Values, mechanism: &dyn Mechanism, all: &[RangeResult]) -> Result<Goal, Box<Diagnostic>> {
    let text = v.text("objective").unwrap_or_default();
    let place = v.place("objective");
    let refuse = |message: String, label: &str, help: &str| {
        Err(Box::new(Diagnostic::new(place.clone(), message, label).help(help)))
    };
    let aim = |text: &str| -> Result<Aim, Box<Diagnostic>> {
        let (side, id) = text.trim().split_once(' ').unwrap_or_default();
        if !matches!(side, "least" | "greatest") {
            let help = "write \"least ...\" or \"greatest ...\" with the id of a result, two of them with \"and\" between, or \
                        \"published\"";
            refuse(format!("\"{text}\" is no objective"), "cannot be read", help)?;
        }
        Ok(Aim {
            result: named(all, id.trim(), &place)?,
            greatest: side == "greatest",
        })
    };
    if text == "published" && mechanism.published().is_none() {
        let help = "add a table `published` with `values` to the mechanism, or name a result: \"least epsilon_Y\"";
        let message = "a fit to published values, and the scene has none".to_owned();
        return refuse(message, "of what table?", help);
    }
    match text.split_once(" and ") {
        None if text == "published" => Ok(Goal::Published),
        None => Ok(Goal::Best(aim(text)?)),
        Some((one, other)) => {
            let aims = [aim(one)?, aim(other)?];
            let [one, other] = aims.map(|aim| aim.result.symbol);
            if one == other {
                let message = format!("`{}` is the objective twice", one.id);
                return refuse(message, "the same", "name another result, or one objective");
            }
            Ok(Goal::Front(aims))
        }
    }
}

fn demand(all: &[RangeResult], (id, text, place): Named<'_>) -> Result<RangeLimit, Box<Diagnostic>> {
    let result = named(all, id, place)?;
    let symbol = result.symbol;
    let read = |text: &str| measure::quantity(text, symbol, Sign::Result);
    let ends = match (text.strip_prefix("at most "), text.strip_prefix("at least ")) {
        (Some(most), _) => read(most).map(|most| [None, Some(most)]),
        (_, Some(least)) => read(least).map(|least| [Some(least), None]),
        _ => match bounds(text, symbol, read) {
            Err((_, label, _)) if !text.contains(" to ") => Err((
                format!("\"{text}\" is no limit"),
                label,
                format!(
                    "write \"at most 1 {0}\", \"at least 1 {0}\" or \"1 {0} to 2 {0}\"",
                    symbol.display.name
                ),
            )),
            read => read.map(|ends| ends.map(Some)),
        },
    };
    let [least, most] = ends.map_err(|(message, label, help)| {
        Box::new(Diagnostic::new(place.clone(), format!("`constraints.{id}`: {message}"), label).help(help))
    })?;
    Ok(RangeLimit {
        result,
        least,
        most,
        place: place.clone(),
    })
}

//! What a scene asks of a search for its own quantities, and what came of it.

use lemnis_models::request::{Aim, Goal, RangeLimit, Request, Varied};
use lemnis_models::scene::Scene;
use lemnis_synthesis::asked::results;
use serde::Serialize;

use crate::book::blocks::Quantity;
use crate::book::notation::Notation;
use crate::print::number::Numbers;
use crate::print::plot::{self, Line};

#[derive(Serialize)]
pub(super) struct Search {
    /// None of a fit to published values.
    aims: Vec<Sought>,
    seed: u64,
    /// Whether the scene notes what was before the search.
    found: bool,
    /// Quantities, then aims, then what else is limited.
    rows: Vec<Row>,
    /// Of two aims, where the scene notes the designs of their front: a picture.
    front: Option<String>,
}

/// A result that is to be `least` or `greatest`.
#[derive(Serialize)]
struct Sought {
    #[serde(flatten)]
    quantity: Quantity,
    side: &'static str,
}

#[derive(Serialize)]
struct Row {
    #[serde(flatten)]
    quantity: Quantity,
    /// Of a quantity of the scene.
    key: Option<String>,
    low: Option<String>,
    before: Option<String>,
    value: Option<String>,
    high: Option<String>,
    /// It may be nothing else than a few values.
    choices: Vec<String>,
    binds: bool,
    missed: bool,
}

/// Label of the scene's own design among those of a front.
const OWN: &str = "1";

/// How near to its limit, as a part of it or of the way between the bounds, a value holds it.
const HOLDS: f64 = 1e-5;

/// `None` for a scene that asks for no search.
pub(super) fn search(numbers: &Numbers, scene: &Scene, notation: &mut Notation) -> Option<Search> {
    let asked = scene.request.as_ref()?;
    let aims: Vec<Aim> = match asked.goal {
        Goal::Best(aim) => vec![aim],
        Goal::Front(aims) => aims.to_vec(),
        Goal::Published => Vec::new(),
    };
    let wanted: Vec<_> = aims
        .iter()
        .map(|aim| aim.result)
        .chain(asked.demands.iter().map(|demand| demand.result))
        .collect();
    let before: Option<Vec<f64>> = asked.varied.iter().map(|varied| varied.before).collect();
    let at = |values: &[f64]| results(&*scene.mechanism, asked, values, &wanted);
    let now = at(&asked.varied.iter().map(|varied| varied.value).collect::<Vec<f64>>());
    let then = before
        .as_ref()
        .map_or_else(|| vec![None; wanted.len()], |values| at(values));
    let mut rows: Vec<Row> = asked.varied.iter().map(|varied| of_quantity(numbers, varied)).collect();
    let limits = aims.iter().map(|_| None).chain(asked.demands.iter().map(Some));
    for (((result, limit), now), then) in wanted.iter().zip(limits).zip(now).zip(then) {
        let symbol = result.symbol;
        notation.meet(symbol);
        let written = |value: f64| numbers.result(symbol, value);
        rows.push(Row {
            quantity: symbol.into(),
            key: None,
            low: limit
                .and_then(|limit| limit.least)
                .map(|least| numbers.given(symbol, least)),
            before: then.map(written),
            value: now.map(written),
            high: limit
                .and_then(|limit| limit.most)
                .map(|most| numbers.given(symbol, most)),
            choices: Vec::new(),
            binds: limit.zip(now).is_some_and(|(limit, now)| near(limit, now)),
            missed: limit.zip(now).is_some_and(|(limit, now)| beyond(limit, now)),
        });
    }
    for varied in &asked.varied {
        notation.meet(varied.symbol);
    }
    let sought = |aim: &Aim| Sought {
        quantity: aim.result.symbol.into(),
        side: aim.side(),
    };
    Some(Search {
        aims: aims.iter().map(sought).collect(),
        seed: asked.seed,
        found: before.is_some(),
        rows,
        front: front(numbers, scene, asked),
    })
}

/// One aim over the other: the designs of the front, and the scene's.
fn front(numbers: &Numbers, scene: &Scene, asked: &Request) -> Option<String> {
    let Goal::Front(aims) = asked.goal else {
        return None;
    };
    let wanted = aims.map(|aim| aim.result);
    let point = |values: Vec<f64>| match results(&*scene.mechanism, asked, &values, &wanted)[..] {
        [Some(one), Some(other)] => Some([one, other]),
        _ => None,
    };
    let count = asked.varied.first()?.front.len();
    let of = |i: usize| point(asked.varied.iter().map(|varied| varied.front[i]).collect());
    let points: Vec<[f64; 2]> = (0..count).filter_map(of).collect();
    if points.len() < 2 {
        return None;
    }
    let own = point(asked.varied.iter().map(|varied| varied.value).collect())?;
    let lines = [(String::new(), points), (OWN.to_owned(), vec![own])];
    let lines = lines.map(|(label, points)| Line {
        label,
        points,
        marked: true,
    });
    Some(plot::lines(numbers.language, wanted.map(|result| result.symbol), &lines).json())
}

fn of_quantity(numbers: &Numbers, varied: &Varied) -> Row {
    let written = |value: f64| numbers.given(varied.symbol, value);
    let [low, high] = varied.bounds;
    let free = varied.choices.is_empty();
    let end = |bound: f64| (varied.value - bound).abs() < HOLDS * (high - low);
    Row {
        quantity: varied.symbol.into(),
        key: Some(varied.key.clone()),
        low: free.then(|| written(low)),
        before: varied.before.map(written),
        value: Some(written(varied.value)),
        high: free.then(|| written(high)),
        choices: varied.choices.iter().copied().map(written).collect(),
        binds: free && (end(low) || end(high)),
        missed: false,
    }
}

fn near(limit: &RangeLimit, value: f64) -> bool {
    let mut ends = [limit.least, limit.most].into_iter().flatten();
    ends.any(|end| (value - end).abs() <= HOLDS * end.abs())
}

fn beyond(limit: &RangeLimit, value: f64) -> bool {
    let below = limit.least.is_some_and(|least| value < least);
    let above = limit.most.is_some_and(|most| value > most);
    (below || above) && !near(limit, value)
}

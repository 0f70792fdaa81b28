//! The chapter that compares levers: existing, published and found.

use lemnis_models::balance::symbols as s;
use lemnis_models::balance::task::{Criterion, Method, Task};
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::scene::Scene;
use lemnis_synthesis::comparison::{self, BUILDS, Bound, Compared, Comparison, Front, Worth};
use serde::Serialize;

use crate::book::blocks::{Drawn, Figure, Quantity};
use crate::book::notation::Notation;
use crate::print::drawing::{HALF, drawing};
use crate::print::number::Numbers;
use crate::print::plot::{self, Line};

#[derive(Serialize)]
pub(super) struct Synthesis {
    method: &'static str,
    /// What is minimised.
    objective: Quantity,
    seed: u64,
    /// `complete`, `broken` or `open`: whether the search came to its end.
    state: &'static str,
    levers: Vec<Lever>,
    rows: Vec<Row>,
    builds: usize,
    /// Of lengths, angles and weights.
    tolerances: [String; 3],
    /// Dimensions with their bounds, then the constraints.
    limits: Vec<Limit>,
    residual: String,
    drawings: Vec<Drawing>,
    fronts: Vec<Figure>,
    nodes: Option<Nodes>,
    /// The joint of the last lever lies behind the boom's foot.
    tail: bool,
}

#[derive(Serialize)]
struct Lever {
    number: usize,
    role: &'static str,
    source: Option<String>,
}

#[derive(Serialize)]
struct Row {
    #[serde(flatten)]
    quantity: Quantity,
    /// One for each lever; none where it does not close.
    cells: Vec<Option<String>>,
}

#[derive(Serialize)]
struct Limit {
    #[serde(flatten)]
    quantity: Quantity,
    low: Option<String>,
    value: Option<String>,
    high: Option<String>,
    binds: bool,
    missed: bool,
}

#[derive(Serialize)]
struct Drawing {
    number: usize,
    role: &'static str,
    #[serde(flatten)]
    drawn: Drawn,
}

#[derive(Serialize)]
struct Nodes {
    columns: Vec<Quantity>,
    rows: Vec<[String; 3]>,
    slope: Option<String>,
    contradicted: bool,
}

/// What the scene's own balance is with its tolerances.
#[derive(Serialize)]
pub(super) struct Spread {
    #[serde(skip)]
    pub dm_95: f64,
    builds: usize,
    /// Of all these builds, half and 95 % stay below.
    most: [String; 2],
}

/// Of the lever that is the scene's own: the last.
pub(super) fn spread(numbers: &Numbers, comparison: &Comparison) -> Option<Spread> {
    let found = comparison.levers.last()?.worth.as_ref()?.spread?;
    Some(Spread {
        dm_95: found.dm_95,
        builds: BUILDS,
        most: [(&s::DM_50, found.median), (&s::DM_95, found.dm_95)].map(|(symbol, value)| numbers.named(symbol, value)),
    })
}

/// `None` for a scene that asks for no synthesis.
pub(super) fn synthesis(
    numbers: &Numbers,
    scene: &Scene,
    comparison: &Comparison,
    notation: &mut Notation,
) -> Option<Synthesis> {
    let task = scene.search()?.task;
    let levers = &comparison.levers;
    let number = |i: usize| (i + 1).to_string();
    let columns: Vec<_> = levers.iter().map(Compared::criteria).collect();
    let row = |(i, symbol): (usize, &'static Symbol)| Row {
        quantity: symbol.into(),
        cells: columns
            .iter()
            .map(|column| column[i].1.map(|value| numbers.result(symbol, value)))
            .collect(),
    };
    let symbols: Vec<&'static Symbol> = columns
        .first()
        .into_iter()
        .flatten()
        .map(|(symbol, _)| *symbol)
        .collect();
    let limited = comparison.limits.iter().map(|bound| bound.symbol);
    let shown = symbols.iter().copied().chain(limited);
    for symbol in shown.chain([&s::PHI, &s::PSI, &s::DM]) {
        notation.meet(symbol);
    }
    let rows = symbols.into_iter().enumerate().map(row).collect();
    let worths: Vec<(usize, &Compared, &Worth)> = levers
        .iter()
        .enumerate()
        .filter_map(|(i, lever)| Some((i, lever, lever.worth.as_ref()?)))
        .collect();
    let residuals = worths.iter().map(|(i, _, worth)| Line {
        label: number(*i),
        points: worth.residual.clone(),
        marked: false,
    });
    let residuals: Vec<Line> = residuals.collect();
    let drawings = worths.iter().map(|(i, lever, worth)| Drawing {
        number: i + 1,
        role: lever.role,
        drawn: drawing(&worth.drawing, HALF).into(),
    });
    let fronts = comparison.fronts.iter().map(|front| figure(numbers, front, &worths));
    let limits = comparison.bounds.iter().filter(|bound| bound.low < bound.high);
    let limits = limits.chain(&comparison.limits).map(|bound| limit(numbers, bound));
    let of = |symbol, value| numbers.given(symbol, value);
    let t = task.tolerances;
    let last = levers.last().map(|last| last.dimensions.alpha_1.abs());
    Some(Synthesis {
        method: match task.method {
            Method::Optimum => "optimum",
            Method::Three { .. } => "three",
            Method::Four { .. } => "four",
        },
        objective: objective(task).into(),
        seed: task.seed,
        state: unsearched(task).unwrap_or("complete"),
        builds: BUILDS,
        tolerances: [of(&s::T_L, t.length), of(&s::T_A, t.angle), of(&s::T_W, t.weight)],
        limits: limits.collect(),
        residual: plot::lines(numbers.language, [&s::PHI, &s::DM], &residuals).json(),
        drawings: drawings.collect(),
        fronts: fronts.collect(),
        nodes: comparison.nodes.as_ref().map(|nodes| at_nodes(numbers, nodes)),
        tail: last.is_some_and(|angle| angle > std::f64::consts::FRAC_PI_2),
        levers: levers
            .iter()
            .enumerate()
            .map(|(i, lever)| Lever {
                number: i + 1,
                role: lever.role,
                source: lever
                    .source
                    .as_ref()
                    .map(|source| source.of(numbers.language.code).to_owned()),
            })
            .collect(),
        rows,
    })
}

/// `broken` or `open`, where the search has not come to its end.
pub(super) fn unsearched(task: &Task) -> Option<&'static str> {
    match task.found {
        Some(true) => None,
        Some(false) => Some("broken"),
        None => Some("open"),
    }
}

/// A front, with the levers on it.
fn figure(numbers: &Numbers, front: &Front, worths: &[(usize, &Compared, &Worth)]) -> Figure {
    let mut lines = vec![Line {
        label: String::new(),
        points: front.points.clone(),
        marked: true,
    }];
    lines.extend(worths.iter().filter_map(|(i, lever, worth)| {
        let x = if front.symbol == &s::M_5 {
            lever.dimensions.m_5
        } else {
            worth.analysis.n_max?.value
        };
        Some(Line {
            label: (i + 1).to_string(),
            points: vec![[x, worth.analysis.dm_max.value]],
            marked: true,
        })
    }));
    Figure {
        id: front.symbol.id,
        picture: plot::lines(numbers.language, [front.symbol, &s::DM_MAX], &lines).json(),
    }
}

fn at_nodes(numbers: &Numbers, nodes: &comparison::Nodes) -> Nodes {
    let columns = [&s::PHI, &s::PSI, &s::DM];
    let of = |symbol, value| numbers.in_formula(symbol, value);
    // Dimensions are rounded so that a residual is known to the newton metre.
    let row = |row: &[f64; 3]| {
        let [phi, psi, dm] = *row;
        [of(columns[0], phi), of(columns[1], psi), of(columns[2], dm.round())]
    };
    Nodes {
        columns: columns.map(Quantity::from).into(),
        rows: nodes.rows.iter().map(row).collect(),
        slope: nodes.slope.map(|slope| of(&s::I_5, slope)),
        contradicted: nodes.contradicted,
    }
}

fn objective(task: &Task) -> &'static Symbol {
    match task.criterion {
        _ if task.robust => &s::DM_95,
        Criterion::Residual => &s::DM_MAX,
        Criterion::Energy => &s::E,
        Criterion::RodForce => &s::N_MAX,
    }
}

fn limit(numbers: &Numbers, bound: &Bound) -> Limit {
    let given = |value: f64| value.is_finite().then(|| numbers.given(bound.symbol, value));
    let found = |value: f64| value.is_finite().then(|| numbers.result(bound.symbol, value));
    Limit {
        quantity: bound.symbol.into(),
        low: given(bound.low),
        value: bound.value.and_then(found),
        high: given(bound.high),
        binds: bound.binds,
        missed: bound.missed(),
    }
}

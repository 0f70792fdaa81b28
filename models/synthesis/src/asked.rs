//! A search that a scene asks for over its own quantities, from nowhere: runs of an evolution strategy (CMA-ES), each
//! with its own seed, the best of them finished by exact derivatives.

use std::cell::RefCell;

use cmaes::{CMAESOptions, DVector};
use lemnis_models::alone::{Consequence, moved};
use lemnis_models::component::governing::governing;
use lemnis_models::component::mechanism::Mechanism;
use lemnis_models::component::running::Running as _;
use lemnis_models::kernel::calc::Calc;
use lemnis_models::kernel::diagnostic::Diagnostic;
use lemnis_models::kernel::shared::{Watch, shared};
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::request::{Aim, RangeFound, RangeLimit, RangeResult, Request, Varied};
use lemnis_models::scene::Scene;

use crate::equations::{Equations, NEVER};
use crate::finish::{Finished, Function, HEAVY, LIGHT, Program};
use crate::optimum::SPREAD;
use crate::peaks::{Peaked as _, Shape};

/// Runs from nowhere, and how many of the best are finished.
const RUNS: usize = 16;
const FINISHED: usize = 8;
/// Random values of which a run starts from the best, and evaluations of a run.
const DRAWS: usize = 150;
const EVALUATIONS: usize = 1_500;
const POPULATION: usize = 12;
/// Weight of such a limit during the search, and how far it may be missed by rounding.
const PENALTY: f64 = 10.0;
const KEPT: f64 = 1e-10;

/// What came of a search.
#[derive(Clone, Debug)]
pub struct Answer {
    /// Of each quantity that varies, in SI.
    pub values: Vec<f64>,
    /// The same, rounded to what a scene writes, so that every limit is kept.
    pub written: Vec<f64>,
    /// The objective, in SI, and each limited result, in the order of [`limits`].
    pub value: f64,
    pub results: Vec<f64>,
    /// Of the conditions of an optimum, with the objective over its amount, by parts of the bounds.
    pub residual: f64,
    /// Whether the search came to its end.
    pub complete: bool,
    /// Other optima, worse by this part of the objective, in its order.
    pub others: Vec<(Vec<f64>, f64)>,
}

impl Answer {
    /// With the optima of a worse answer among the others, the best first.
    fn beside(mut self, worse: Answer, sign: f64) -> Answer {
        self.others.push((worse.values, worse.value));
        self.others.extend(worse.others);
        self.others.sort_by(|a, b| (sign * a.1).total_cmp(&(sign * b.1)));
        self.complete &= worse.complete;
        self
    }
}

/// A limit of a result.
#[derive(Clone, Copy, Debug)]
pub struct Limited<'a> {
    pub demand: &'a RangeLimit,
    pub limit: f64,
    pub at_most: bool,
}

/// Every limit of a request.
#[must_use]
pub fn limits(asked: &Request) -> Vec<Limited<'_>> {
    let mut all = Vec::new();
    for demand in &asked.demands {
        for (limit, at_most) in [(demand.least, false), (demand.most, true)] {
            all.extend(limit.map(|limit| Limited { demand, limit, at_most }));
        }
    }
    all
}

/// No values keep every limit.
#[derive(Clone, Debug)]
pub enum Nothing {
    /// Nowhere within the bounds do all results exist.
    Impossible,
    /// The nearest values, and the worst limit with the result, by its place among [`limits`].
    Missed {
        values: Vec<f64>,
        limit: usize,
        result: f64,
        /// By which part of the limit it is missed.
        by: f64,
    },
}

impl Nothing {
    /// By how much the worst limit is missed.
    fn by(&self) -> f64 {
        match self {
            Nothing::Impossible => f64::INFINITY,
            Nothing::Missed { by, .. } => *by,
        }
    }

    /// With other values.
    fn at(mut self, other: impl Fn(&[f64]) -> Vec<f64>) -> Nothing {
        if let Nothing::Missed { values, .. } = &mut self {
            *values = other(values);
        }
        self
    }
}

/// Whether each quantity is by itself what the equations have, so that nothing else of the scene changes with it.
///
/// # Errors
/// The first that is not, with what changes.
pub fn alone(scene: &Scene, asked: &Request) -> Result<(), Diagnostic> {
    for varied in &asked.varied {
        let [low, high] = varied.bounds;
        let step = 1e-3 * (high - low);
        let value = if varied.value + step > high {
            varied.value - step
        } else {
            varied.value + step
        };
        let text = format!("\"{}\"", varied.written(value));
        // What cannot stand here the search finds out.
        let Consequence::With(with) = moved(scene, &varied.given, varied.source, &text) else {
            continue;
        };
        let message = format!("`{}` cannot be searched for: {with} would change with it", varied.key);
        let help = "name a quantity that nothing else hangs on";
        return Err(Diagnostic::new(varied.place.clone(), message, "not by itself").help(help));
    }
    Ok(())
}

/// Results of the whole range with these values of what varies, in the order of the request; `None` where one does not exist.
#[must_use]
pub fn results(mechanism: &dyn Mechanism, asked: &Request, values: &[f64], wanted: &[RangeResult]) -> Vec<Option<f64>> {
    let mut model = mechanism.standing();
    let set = |(varied, value): (&Varied, &f64)| {
        let index = model.index_of(varied.source)?;
        model.set(index, *value).ok()
    };
    if asked.varied.iter().zip(values).map(set).any(|done| done.is_none()) {
        return vec![None; wanted.len()];
    }
    let asks = |symbol: &'static Symbol| wanted.iter().any(|result| result.symbol == symbol);
    let extremes = governing(&model, mechanism.outline(), &asks);
    let mut value = |result: &RangeResult| match result.found {
        RangeFound::Extreme(_) => {
            let found = extremes.iter().find(|found| found.symbol == result.symbol);
            found.map(|found| found.value)
        }
        RangeFound::Whole(_) | RangeFound::Steady(_) => {
            let mut variables = model.variables().iter();
            let index = variables.position(|variable| variable.symbol == result.symbol)?;
            model.get(index).ok()
        }
    };
    wanted.iter().map(&mut value).collect()
}

struct Search<'a> {
    mechanism: &'a dyn Mechanism,
    asked: &'a Request,
    results: Vec<RangeResult>,
    bounds: Vec<[f64; 2]>,
    functions: Vec<Function>,
}

/// How often [`seek`] calls [`Watch::run`] at most.
#[must_use]
pub fn calls(asked: &Request) -> usize {
    let runs = |one: &Request| if one.varied.is_empty() { 0 } else { RUNS + FINISHED };
    asked.combinations().iter().map(runs).sum()
}

/// The best values for one aim, or the best so far where it was broken off: of each combination of choices by itself, and
/// the best of these. Values that are `near` the best are finished too.
///
/// # Errors
/// Limits that no values within the bounds keep.
pub fn seek(
    mechanism: &dyn Mechanism,
    (asked, aim): (&Request, Aim),
    near: &[Vec<f64>],
    seed: u64,
    threads: usize,
    watch: Watch<'_>,
) -> Result<Answer, Nothing> {
    let sign = aim.sign();
    let mut best: Result<Answer, Nothing> = Err(Nothing::Impossible);
    for one in asked.combinations() {
        let whole = |values: &[f64]| {
            let mut free = values.iter();
            let value = |varied: &Varied| {
                let chosen = one.chosen.iter().find(|(source, _)| *source == varied.source);
                chosen.map_or_else(|| *free.next().expect("as many as vary"), |(_, value)| *value)
            };
            asked.varied.iter().map(value).collect::<Vec<f64>>()
        };
        let free = |values: &Vec<f64>| {
            let mut free = Vec::new();
            for (varied, value) in asked.varied.iter().zip(values) {
                match one.chosen.iter().find(|(source, _)| *source == varied.source) {
                    Some((_, chosen)) if chosen != value => return None,
                    Some(_) => {}
                    None => free.push(*value),
                }
            }
            Some(free)
        };
        let near: Vec<Vec<f64>> = near.iter().filter_map(free).collect();
        let found = match among(mechanism, (&one, aim), &near, seed, threads, watch) {
            Ok(mut answer) => {
                answer.values = whole(&answer.values);
                answer.written = whole(&answer.written);
                answer.others.iter_mut().for_each(|(values, _)| *values = whole(values));
                Ok(answer)
            }
            Err(nothing) => Err(nothing.at(whole)),
        };
        best = match (best, found) {
            (Ok(a), Ok(b)) if sign * b.value < sign * a.value => Ok(b.beside(a, sign)),
            (Ok(a), Ok(b)) => Ok(a.beside(b, sign)),
            (Ok(one), Err(_)) | (Err(_), Ok(one)) => Ok(one),
            (Err(a), Err(b)) => Err(if b.by() < a.by() { b } else { a }),
        };
        if !watch.goes_on() {
            break;
        }
    }
    best
}

/// The best values of one combination of choices.
fn among(
    mechanism: &dyn Mechanism,
    (asked, aim): (&Request, Aim),
    near: &[Vec<f64>],
    seed: u64,
    threads: usize,
    watch: Watch<'_>,
) -> Result<Answer, Nothing> {
    let limits = limits(asked);
    let mut search = Search {
        mechanism,
        asked,
        results: std::iter::once(aim.result)
            .chain(limits.iter().map(|one| one.demand.result))
            .collect(),
        bounds: asked.varied.iter().map(|varied| varied.bounds).collect(),
        functions: Vec::new(),
    };
    let mut equations = search.equations();
    let sizes = search.sizes(&mut equations, seed);
    search.functions.push(Function {
        of: 0,
        sign: aim.sign(),
        limit: 0.0,
        unit: sizes[0],
    });
    for (of, Limited { limit, at_most, .. }) in (1..).zip(limits) {
        let sign = if at_most { 1.0 } else { -1.0 };
        search.functions.push(Function {
            of,
            sign,
            limit: sign * limit,
            unit: if limit == 0.0 { sizes[of] } else { limit.abs() },
        });
    }
    search.run(near, seed, threads, watch)
}

impl Search<'_> {
    fn equations(&self) -> Equations {
        Equations::new(self.mechanism, self.asked, &self.results)
    }

    fn values(&self, parts: &[f64]) -> Vec<f64> {
        let all = parts.iter().zip(&self.bounds);
        all.map(|(part, [low, high])| low + (high - low) * part).collect()
    }

    /// Of which amount each result is: somewhere within the bounds, whatever the scene begins with.
    fn sizes(&self, equations: &mut Equations, seed: u64) -> Vec<f64> {
        let mut random = fastrand::Rng::with_seed(seed);
        let mut sizes = vec![0.0_f64; self.results.len()];
        for _ in 0..DRAWS {
            let parts: Vec<f64> = self.bounds.iter().map(|_| random.f64()).collect();
            let found = equations.rough(&self.values(&parts)).unwrap_or_default();
            for (size, result) in sizes.iter_mut().zip(found).filter(|(size, _)| **size == 0.0) {
                *size = result.abs();
            }
        }
        sizes
            .into_iter()
            .map(|size| if size > 0.0 { size } else { 1.0 })
            .collect()
    }

    fn cost(&self, equations: &mut Equations, parts: &[f64]) -> f64 {
        match equations.rough(&self.values(parts)) {
            Err(missing) => 1e3 * (1.0 + missing),
            Ok(results) => {
                let mut all = self.functions.iter().map(|function| function.of(results[function.of]));
                let objective = all.next().expect("the objective is the first");
                (objective + PENALTY * all.map(|over| over.max(0.0)).sum::<f64>()).min(1e3)
            }
        }
    }

    /// A run from nowhere.
    fn explore(&self, random: &mut fastrand::Rng) -> (Vec<f64>, f64) {
        let equations = RefCell::new(self.equations());
        let cost = |parts: &[f64]| self.cost(&mut equations.borrow_mut(), parts);
        let mut draw = || {
            let parts: Vec<f64> = self.bounds.iter().map(|_| random.f64()).collect();
            let cost = cost(&parts);
            (parts, cost)
        };
        let first = draw();
        let start = (1..DRAWS)
            .map(|_| draw())
            .fold(first, |best, other| if other.1 < best.1 { other } else { best });
        let record = RefCell::new(start.clone());
        // A square of a sine keeps each part within its bounds.
        let squared = |x: &DVector<f64>| {
            let sines = x.iter().map(|&x| Calc::sin(x));
            sines.map(|sine| sine * sine).collect::<Vec<f64>>()
        };
        let angles: Vec<f64> = start.0.iter().map(|part| Calc::asin(part.sqrt())).collect();
        let run = CMAESOptions::new(angles, 0.1)
            .seed(random.u64(..))
            .population_size(POPULATION)
            .max_function_evals(EVALUATIONS)
            .tol_fun(1e-10)
            .tol_fun_hist(1e-10)
            .tol_x(1e-8)
            .build(|x: &DVector<f64>| {
                let parts = squared(x);
                let cost = cost(&parts);
                let mut best = record.borrow_mut();
                if cost < best.1 {
                    *best = (parts, cost);
                }
                cost
            });
        run.expect("sound options").run();
        record.into_inner()
    }

    fn program<'a>(&'a self, equations: &'a mut Equations, functions: &'a [Function]) -> Program<'a> {
        Program {
            equations,
            functions,
            bounds: &self.bounds,
            penalty: LIGHT,
        }
    }

    /// To the nearest optimum; where limits are not kept there, once more with all weight on these.
    fn finish(&self, parts: &[f64]) -> Option<Finished> {
        let mut equations = self.equations();
        let mut program = self.program(&mut equations, &self.functions);
        let finished = program.finish(parts.to_vec())?;
        if finished.functions[1..].iter().all(|over| *over <= KEPT) {
            return Some(finished);
        }
        program.penalty = HEAVY;
        program.finish(finished.parts)
    }

    /// Runs from nowhere, the best of them finished, and what is near the best.
    fn finished(&self, near: &[Vec<f64>], seed: u64, threads: usize, watch: Watch<'_>) -> Vec<Finished> {
        if self.bounds.is_empty() {
            return self.finish(&[]).into_iter().collect();
        }
        let random = |run: usize| fastrand::Rng::with_seed(seed.wrapping_mul(SPREAD).wrapping_add(run as u64));
        let mut found = shared(RUNS, threads, watch, |run| self.explore(&mut random(run)));
        found.sort_by(|a, b| a.1.total_cmp(&b.1));
        found.truncate(FINISHED.saturating_sub(near.len()));
        let part = |(value, [low, high]): (&f64, &[f64; 2])| (value - low) / (high - low);
        let near = near
            .iter()
            .map(|values| values.iter().zip(&self.bounds).map(part).collect());
        let starts: Vec<Vec<f64>> = near.chain(found.into_iter().map(|(parts, _)| parts)).collect();
        let finished = shared(starts.len(), threads, watch, |run| self.finish(&starts[run]));
        finished.into_iter().flatten().collect()
    }

    fn run(&self, near: &[Vec<f64>], seed: u64, threads: usize, watch: Watch<'_>) -> Result<Answer, Nothing> {
        let mut finished = self.finished(near, seed, threads, watch);
        let missed = |one: &Finished| one.functions[1..].iter().fold(0.0_f64, |worst, over| worst.max(*over));
        let keeps = |one: &Finished| missed(one) <= KEPT;
        finished.sort_by(|a, b| {
            let value = |one: &Finished| if keeps(one) { one.functions[0] } else { missed(one) };
            keeps(b).cmp(&keeps(a)).then(value(a).total_cmp(&value(b)))
        });
        let Some(best) = finished.first() else {
            return Err(Nothing::Impossible);
        };
        let equations = self.equations();
        let of_place = |at: usize| equations.shape(self.functions[at].of) == Shape::Direct;
        let result = |one: &Finished, at: usize| {
            let Function { sign, limit, unit, .. } = self.functions[at];
            match sign * (one.functions[at] * unit + limit) {
                never if of_place(at) && never >= NEVER * (1.0 - KEPT) => f64::INFINITY,
                value => value,
            }
        };
        if !keeps(best) {
            let worst = (1..self.functions.len()).max_by(|&a, &b| best.functions[a].total_cmp(&best.functions[b]));
            let at = worst.expect("a limit is missed");
            return Err(Nothing::Missed {
                values: self.values(&best.parts),
                by: best.functions[at],
                limit: at - 1,
                result: result(best, at),
            });
        }
        Ok(Answer {
            values: self.values(&best.parts),
            written: self.written(best),
            value: result(best, 0),
            results: (1..self.functions.len()).map(|at| result(best, at)).collect(),
            residual: best.residual,
            complete: watch.goes_on(),
            others: self
                .others(&finished, keeps)
                .into_iter()
                .map(|one| (self.values(&one.parts), result(one, 0)))
                .collect(),
        })
    }

    /// Rounded to what a scene writes, so that every limit is kept.
    fn written(&self, best: &Finished) -> Vec<f64> {
        let rounded = |values: &[f64]| {
            let all = self.asked.varied.iter().zip(values);
            all.map(|(varied, value)| varied.rounded(*value)).collect::<Vec<f64>>()
        };
        let mut equations = self.equations();
        let mut program = self.program(&mut equations, &self.functions);
        program.settled(best.parts.clone(), 0.0, &rounded)
    }

    /// Optima elsewhere than the best.
    fn others<'a>(&self, finished: &'a [Finished], keeps: impl Fn(&Finished) -> bool) -> Vec<&'a Finished> {
        let near = |a: &Finished, b: &Finished| {
            let apart = a
                .parts
                .iter()
                .zip(&b.parts)
                .map(|(a, b)| (a - b).abs())
                .fold(0.0, f64::max);
            apart < 1e-3
        };
        let mut kept = vec![&finished[0]];
        for one in finished[1..].iter().filter(|one| keeps(one) && one.residual < 1e-6) {
            if !kept.iter().any(|other| near(one, other)) {
                kept.push(one);
            }
        }
        kept.split_off(1)
    }
}

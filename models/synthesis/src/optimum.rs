//! The best lever counterweight under constraints, found from nowhere: runs of
//! an evolution strategy (CMA-ES), each with its own seed, the best of them taken.

use std::cell::RefCell;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::sync::Arc;

use cmaes::{CMAESOptions, DVector};

use crate::candidate::{Criteria, Positions};
use crate::levers::{Best, Wanted};
use crate::tolerance::Builds;
use lemnis_models::balance::boom::Boom;
use lemnis_models::balance::lever::Dimensions;
use lemnis_models::balance::symbols as s;
use lemnis_models::balance::task::{Bounds, Constraints, Criterion, Task};
use lemnis_models::kernel::allowed::{OutOfRange, POSITIVE, check};
use lemnis_models::kernel::calc::Calc;
use lemnis_models::kernel::shared::{Watch, shared};
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::parts::four_bar::Branch;

/// A search.
#[derive(Clone)]
pub struct Problem {
    pub boom: Arc<dyn Boom<f64> + Send + Sync>,
    pub positions: Positions,
    pub branch: Branch,
    pub criterion: Criterion,
    pub constraints: Constraints,
    pub bounds: Bounds,
    /// Minimises the residual that 95 % of all builds stay below, instead of the criterion.
    pub robust: Option<Builds>,
}

/// Enough short runs for the levers of the portal crane of Balance004, whatever the seed.
pub const RUNS: usize = 96;

/// How much is searched.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    pub seed: u64,
    /// Independent runs; the result does not depend on how many threads share them.
    pub runs: usize,
    pub threads: usize,
}

/// What a search found.
#[derive(Clone, Copy, Debug)]
pub struct Found {
    pub dimensions: Dimensions<f64>,
    pub criteria: Criteria,
    /// Value of the criterion over the whole range, in SI; of 95 % of all builds in the robust mode.
    pub value: f64,
    /// Of the conditions of an optimum, with the criterion over its amount, by parts of the bounds; of builds there are none.
    pub residual: Option<f64>,
    /// Whether the search came to its end.
    pub complete: bool,
}

/// Weight of a violated constraint; the criterion is relative to the boom's
/// moment, and a constraint is never worth that much of it.
const PENALTY: f64 = 10.0;
/// Random linkages of which a run starts from the best.
const DRAWS: usize = 400;
/// Evaluations of a run from nowhere, and of one from a good lever.
const SHORT: usize = 6_000;
const LONG: usize = 20_000;
const POPULATION: usize = 14;
/// How many of the short runs are finished by exact derivatives, and of those for a point of a front.
const FINISHED: usize = 8;
pub(crate) const FEW_FINISHED: usize = 3;
/// How often a run from a good lever is continued at most.
const ROUNDS: usize = 40;
/// Rounds without gain after which nothing more is expected.
const IDLE: usize = 4;
/// Keeps the seeds of two searches apart (2⁶⁴ over the golden ratio).
pub(crate) const SPREAD: u64 = 0x9E37_79B9_7F4A_7C15;

/// Positions at which a candidate is looked at.
const POSITIONS: usize = 101;

impl Problem {
    /// What a scene asks for, in one branch of assembly; without its robust mode.
    ///
    /// # Errors
    /// As [`Positions::new`].
    pub fn new(
        boom: &Arc<dyn Boom<f64> + Send + Sync>,
        range: [f64; 2],
        task: &Task,
        branch: Branch,
    ) -> Result<Problem, OutOfRange> {
        Ok(Problem {
            boom: Arc::clone(boom),
            positions: Positions::new(&**boom, range, POSITIONS)?,
            branch,
            criterion: task.criterion,
            constraints: task.constraints,
            bounds: task.bounds,
            robust: None,
        })
    }

    /// # Errors
    /// Bounds or constraints that contradict each other or are no numbers.
    pub fn check(&self) -> Result<(), OutOfRange> {
        let mut sound = Ok(());
        self.bounds.map(&mut |symbol, [low, high]| {
            let least = match symbol.id {
                "delta_1" | "alpha_K" | "chi_5" => f64::MIN,
                "M_5" => 0.0,
                _ => f64::MIN_POSITIVE,
            };
            if sound.is_ok() {
                sound = check(symbol, low, [least, f64::MAX]).and(check(symbol, high, [low, f64::MAX]));
            }
        });
        sound?;
        let k = &self.constraints;
        check(&s::GAMMA_MIN, k.gamma_min, [0.0, FRAC_PI_2])?;
        let optional =
            |symbol, value: Option<f64>, allowed| value.map_or(Ok(()), |value| check(symbol, value, allowed));
        optional(&s::M_PLUS, k.m_plus, [0.0, k.dm_max.unwrap_or(f64::MAX)])?;
        optional(&s::N_MAX, k.n_max, POSITIVE)?;
        optional(&s::DM_MAX, k.dm_max, POSITIVE)
    }

    /// The constraints that `found` does not keep: the quantity, its value and what is allowed.
    #[must_use]
    pub fn violated(&self, c: &Criteria) -> Vec<OutOfRange> {
        let k = &self.constraints;
        let inf = f64::INFINITY;
        let mut faults = Vec::new();
        let mut demand = |symbol, value: f64, allowed: [f64; 2], what| {
            if !(allowed[0]..=allowed[1]).contains(&value) {
                faults.push(OutOfRange::new(symbol, value, allowed, what));
            }
        };
        demand(
            &s::GAMMA_MIN,
            Calc::asin(c.sin_gamma.min(1.0)),
            [k.gamma_min, inf],
            "transmission angle",
        );
        if let Some(m) = k.m_plus {
            demand(&s::M_PLUS, c.ends[0], [m, inf], "stable lower end");
            demand(&s::M_PLUS, -c.ends[1], [m, inf], "stable upper end");
        }
        if let Some(n) = k.n_max {
            demand(&s::N_MAX, c.n_max, [-inf, n], "force in the rod");
        }
        if let Some(m) = k.dm_max {
            demand(&s::DM_MAX, c.dm_max, [-inf, m], "residual");
        }
        if k.rearward {
            demand(
                &s::PSI,
                Calc::acos(c.cos_psi.clamp(-1.0, 1.0)),
                [FRAC_PI_2, PI],
                "counterweight in front of the lever's pivot",
            );
        }
        faults
    }

    /// Value of the criterion, in SI.
    fn worth(&self, d: &Dimensions<f64>, c: &Criteria) -> f64 {
        match (&self.robust, self.criterion) {
            (Some(builds), _) => builds.dm_95(&self.positions, d, self.branch),
            (None, Criterion::Residual) => c.dm_max,
            (None, Criterion::Energy) => c.e_abs,
            (None, Criterion::RodForce) => c.n_max,
        }
    }

    /// What is minimised without bounds and constraints, and how far the constraints are from kept.
    fn cost(&self, d: &Dimensions<f64>) -> (f64, f64) {
        let c = match self.positions.evaluate(d, self.branch) {
            Err(miss) => return (1e3 * (1.0 + miss), f64::INFINITY),
            Ok(c) => c,
        };
        let scale = self.positions.scale;
        let k = &self.constraints;
        let over = |limit: Option<f64>, excess: &dyn Fn(f64) -> f64| limit.map_or(0.0, |limit| excess(limit).max(0.0));
        let violation = (Calc::sin(k.gamma_min) - c.sin_gamma).max(0.0)
            + over(k.m_plus, &|m| (m - c.ends[0]) / scale)
            + over(k.m_plus, &|m| (m + c.ends[1]) / scale)
            + over(k.n_max, &|n| c.n_max / n - 1.0)
            + over(k.dm_max, &|m| (c.dm_max - m) / scale)
            + if k.rearward { c.cos_psi.max(0.0) } else { 0.0 };
        // So that each criterion is of the order of a hundredth.
        let unit = match (&self.robust, self.criterion) {
            (None, Criterion::RodForce) => 100.0 * scale / d.d_1,
            _ => scale,
        };
        let cost = self.worth(d, &c) / unit + PENALTY * violation;
        if cost.is_finite() {
            (cost, violation)
        } else {
            (1e3, f64::INFINITY)
        }
    }

    /// Coordinates without bounds: a square of a sine keeps each dimension
    /// within its own, and is flat there.
    fn dimensions(&self, x: &[f64]) -> Dimensions<f64> {
        let mut free = x.iter();
        self.bounds.map(&mut |_, [low, high]| {
            if low == high {
                return low;
            }
            let sine = Calc::sin(*free.next().expect("one per free dimension"));
            low + (high - low) * sine * sine
        })
    }

    fn coordinates(&self, d: &Dimensions<f64>) -> Vec<f64> {
        let mut x = Vec::new();
        self.each(d, |_, value, [low, high]| {
            if low != high {
                x.push(Calc::asin(((value - low) / (high - low)).clamp(0.0, 1.0).sqrt()));
            }
        });
        x
    }

    /// Each dimension with its bounds.
    fn each(&self, d: &Dimensions<f64>, mut f: impl FnMut(&'static Symbol, f64, [f64; 2])) {
        let mut values = Vec::new();
        d.map(&mut |_, value| values.push(value));
        let mut values = values.into_iter();
        self.bounds
            .map(&mut |symbol, bounds| f(symbol, values.next().expect("as many bounds as dimensions"), bounds));
    }

    /// A random linkage that closes where possible, with the counterweight that suits it best.
    fn draw(&self, random: &mut fastrand::Rng) -> Dimensions<f64> {
        let mut d = self.bounds.map(&mut |_, [low, high]| low + (high - low) * random.f64());
        let within = |value: f64, [low, high]: [f64; 2]| value.clamp(low, high);
        // Small levers are worth as many draws as long ones.
        let [low, high] = self.bounds.lever;
        d.lever = low + (high - low) * random.f64().powi(3);
        let [near, far] = self.positions.diagonals(&d);
        let (shortest, longest) = ((far - d.lever).max(d.lever - near), near + d.lever);
        if shortest < longest {
            d.l_1 = within(shortest + (longest - shortest) * random.f64(), self.bounds.l_1);
        }
        if let Some([m_5, chi_5]) = self.positions.counterweight(&d, self.branch) {
            let [low, high] = self.bounds.chi_5;
            let turns = ((f64::midpoint(low, high) - chi_5) / TAU).round();
            d.m_5 = within(m_5, self.bounds.m_5);
            d.chi_5 = within(chi_5 + turns * TAU, self.bounds.chi_5);
        }
        d
    }

    /// Evaluations of one evolution from `start`; the best that keeps all
    /// constraints goes into `best`.
    fn descend(&self, best: &mut Attempt, sigma: f64, evaluations: usize, random: &mut fastrand::Rng) {
        let start = self.coordinates(&best.dimensions);
        if start.is_empty() {
            // Everything is fixed.
            return;
        }
        let record = RefCell::new(*best);
        let cost = |x: &DVector<f64>| {
            let dimensions = self.dimensions(x.as_slice());
            let attempt = self.attempt(dimensions);
            let mut record = record.borrow_mut();
            if attempt.better(&record) {
                *record = attempt;
            }
            attempt.cost
        };
        let run = CMAESOptions::new(start, sigma)
            .seed(random.u64(..))
            .population_size(POPULATION)
            .max_function_evals(evaluations)
            .tol_fun(1e-9)
            .tol_fun_hist(1e-9)
            .tol_x(1e-9)
            .build(cost);
        // Options that can only be wrong by the constants above.
        run.expect("sound options").run();
        *best = record.into_inner();
    }

    fn attempt(&self, dimensions: Dimensions<f64>) -> Attempt {
        let (cost, violation) = self.cost(&dimensions);
        Attempt {
            dimensions,
            cost,
            keeps: violation == 0.0,
        }
    }

    /// A short run from the best of many random linkages.
    fn explore(&self, random: &mut fastrand::Rng) -> Attempt {
        let mut best = self.attempt(self.draw(random));
        for _ in 1..DRAWS {
            let other = self.attempt(self.draw(random));
            if other.cost < best.cost {
                best = other;
            }
        }
        self.descend(&mut best, 0.1, SHORT, random);
        best
    }

    /// Runs from the best so far, until nothing is gained any more.
    fn refine(&self, mut best: Attempt, random: &mut fastrand::Rng, watch: Watch<'_>) -> Attempt {
        // Of many builds each evaluation takes as many times longer.
        let evaluations = if self.robust.is_some() { LONG / 10 } else { LONG };
        let mut idle = 0;
        for round in 0..ROUNDS {
            let before = best;
            // Along a sharp valley now a long step helps, now a short one.
            let step = if round % 2 == 0 { 0.02 } else { 0.1 };
            self.descend(&mut best, step, evaluations, random);
            let gained = best.keeps && (!before.keeps || before.cost - best.cost > 1e-4 * before.cost);
            idle = if gained { 0 } else { idle + 1 };
            if idle == IDLE || !watch.goes_on() {
                break;
            }
        }
        self.snapped(best)
    }

    fn wanted(&self) -> Wanted<'_> {
        Wanted {
            boom: &*self.boom,
            range: self.positions.range,
            branch: self.branch,
            criterion: self.criterion,
            constraints: &self.constraints,
            bounds: &self.bounds,
        }
    }

    /// Amounts of residual, energy and rod force of a lever.
    fn amounts(&self, d: &Dimensions<f64>) -> Option<[f64; 3]> {
        let c = self.positions.evaluate(d, self.branch).ok()?;
        let amounts = [c.dm_max, c.e_abs, c.n_max];
        amounts.iter().all(|amount| *amount > 0.0).then_some(amounts)
    }

    /// The nearest lever that no step makes better, which keeps all constraints over the whole range or misses them least.
    fn finish(&self, start: &Dimensions<f64>) -> Option<Best> {
        let amounts = self.amounts(start)?;
        self.wanted().finish(start, amounts)
    }

    /// A lever rounded to what a scene writes, so that it keeps all constraints over the whole range.
    #[must_use]
    pub fn written(
        &self,
        d: &Dimensions<f64>,
        rounded: &dyn Fn(&Dimensions<f64>) -> Dimensions<f64>,
    ) -> Dimensions<f64> {
        let amounts = self.amounts(d).filter(|_| self.robust.is_none());
        let found = amounts.and_then(|amounts| self.wanted().rounded(d, amounts, rounded));
        found.unwrap_or_else(|| rounded(d))
    }

    /// With each dimension that lies close to a bound at that bound, where that is no worse.
    fn snapped(&self, mut best: Attempt) -> Attempt {
        for (symbol, bound) in self.at_bounds(&best.dimensions) {
            let snap = &mut |other: &'static Symbol, value| if other == symbol { bound } else { value };
            let other = self.attempt(best.dimensions.map(snap));
            if other.better(&best) {
                best = other;
            }
        }
        best
    }

    /// Whether every dimension lies within its bounds.
    fn within(&self, d: &Dimensions<f64>) -> Result<(), OutOfRange> {
        let mut sound = Ok(());
        self.each(d, |symbol, value, bounds| {
            if sound.is_ok() {
                sound = check(symbol, value, bounds);
            }
        });
        sound
    }

    /// The dimensions that lie at one of their bounds, with that bound in SI.
    #[must_use]
    pub fn at_bounds(&self, d: &Dimensions<f64>) -> Vec<(&'static Symbol, f64)> {
        let mut found = Vec::new();
        self.each(d, |symbol, value, [low, high]| {
            if low < high && (value - low).min(high - value) <= 1e-3 * (high - low) {
                found.push((symbol, if value - low < high - value { low } else { high }));
            }
        });
        found
    }

    /// Where the nearest miss lies, and what may help.
    fn advice(&self, d: &Dimensions<f64>) -> String {
        let at = self
            .at_bounds(d)
            .into_iter()
            .map(|(symbol, value)| format!("{} = {}", symbol.id, symbol.written(value)));
        match at.collect::<Vec<String>>() {
            none if none.is_empty() => "lies at no bound: ease the constraint".to_owned(),
            at => format!(
                "lies at the bounds {}: widen these or ease the constraint",
                at.join(", ")
            ),
        }
    }

    /// Why a linkage does not close over the whole range.
    fn open(&self, d: &Dimensions<f64>) -> OutOfRange {
        let [near, far] = self.positions.diagonals(d);
        let what = format!(
            "no linkage within the bounds closes over the whole working range; the nearest one {}",
            self.advice(d)
        );
        // Rod and rod arm must span every distance from lever's pivot to joint.
        let [shortest, longest] = [(far - d.lever).max(d.lever - near), near + d.lever];
        if shortest < longest {
            OutOfRange::new(&s::L_1, d.l_1, [shortest, longest], what)
        } else {
            OutOfRange::new(&s::R_L, d.lever, [0.5 * (far - near), f64::INFINITY], what)
        }
    }

    fn found(&self, best: &Attempt, complete: bool) -> Result<Found, OutOfRange> {
        let dimensions = best.dimensions;
        let criteria = self.positions.evaluate(&dimensions, self.branch);
        let criteria = criteria.map_err(|_| self.open(&dimensions))?;
        if let Some(worst) = self.violated(&criteria).first() {
            let what = if complete {
                let advice = self.advice(&dimensions);
                format!(
                    "no lever within the bounds keeps every constraint; the nearest one misses the {} and {advice}",
                    worst.what
                )
            } else {
                format!(
                    "broken off before a lever was found that keeps every constraint; the best so far misses the {}",
                    worst.what
                )
            };
            return Err(OutOfRange { what, ..worst.clone() });
        }
        Ok(Found {
            dimensions,
            criteria,
            value: self.worth(&dimensions, &criteria),
            residual: None,
            complete,
        })
    }

    /// What was found: the best of the finished that keep all constraints, or else the best of all attempts.
    fn best(&self, ended: &[Best], attempts: &[Attempt], complete: bool) -> Result<Found, OutOfRange> {
        let keeping = ended.iter().filter(|best| best.keeps);
        if let Some(best) = keeping.min_by(|a, b| a.value.total_cmp(&b.value)) {
            let criteria = self.positions.evaluate(&best.dimensions, self.branch);
            return Ok(Found {
                dimensions: best.dimensions,
                criteria: criteria.map_err(|_| self.open(&best.dimensions))?,
                value: best.value,
                residual: Some(best.residual),
                complete,
            });
        }
        let ended = ended.iter().map(|best| self.attempt(best.dimensions));
        let all = attempts.iter().copied().chain(ended);
        let chosen = all.reduce(|a, b| if b.better(&a) { b } else { a });
        let chosen = self.snapped(chosen.expect("the first run always ends"));
        self.found(&chosen, complete)
    }
}

/// A candidate with its cost.
#[derive(Clone, Copy, Debug)]
struct Attempt {
    dimensions: Dimensions<f64>,
    cost: f64,
    /// All constraints.
    keeps: bool,
}

impl Attempt {
    fn better(&self, other: &Attempt) -> bool {
        (self.keeps && !other.keeps) || (self.keeps == other.keeps && self.cost < other.cost)
    }
}

/// How often [`search`] calls [`Watch::run`].
#[must_use]
pub fn runs(effort: Effort) -> usize {
    effort.runs + FINISHED.min(effort.runs)
}

/// The best lever, or the best so far where it was broken off.
///
/// # Errors
/// Bounds or constraints that contradict each other; constraints that no
/// lever within the bounds keeps, with the bounds that the nearest one touches.
pub fn search(problem: &Problem, effort: Effort, watch: Watch<'_>) -> Result<Found, OutOfRange> {
    seek(problem, effort, None, FINISHED, watch)
}

/// Runs from nowhere, and `known` where there is one; some of the best are finished.
fn seek(
    problem: &Problem,
    effort: Effort,
    known: Option<Dimensions<f64>>,
    finished: usize,
    watch: Watch<'_>,
) -> Result<Found, OutOfRange> {
    problem.check()?;
    let count = effort.runs.max(1);
    let seed = |run: usize| fastrand::Rng::with_seed(effort.seed.wrapping_mul(SPREAD).wrapping_add(run as u64));
    let mut best = shared(count, effort.threads, watch, |run| problem.explore(&mut seed(run)));
    best.extend(known.map(|known| problem.attempt(known)));
    best.sort_by(|a, b| b.keeps.cmp(&a.keeps).then(a.cost.total_cmp(&b.cost)));
    best.truncate(finished);
    let ended = shared(best.len(), effort.threads, watch, |run| {
        problem.finish(&best[run].dimensions)
    });
    problem.best(
        &ended.into_iter().flatten().collect::<Vec<Best>>(),
        &best,
        watch.goes_on(),
    )
}

/// The best near a given lever: a search that knows where to begin.
///
/// # Errors
/// As [`search`]; a start outside the bounds.
pub fn improve(problem: &Problem, start: Dimensions<f64>, seed: u64, watch: Watch<'_>) -> Result<Found, OutOfRange> {
    problem.check()?;
    problem.within(&start)?;
    let best = problem.refine(problem.attempt(start), &mut fastrand::Rng::with_seed(seed), watch);
    let plain = problem.robust.is_none();
    let ended: Vec<Best> = plain
        .then(|| problem.finish(&best.dimensions))
        .into_iter()
        .flatten()
        .collect();
    problem.best(&ended, &[best], watch.goes_on())
}

/// What a front is drawn against.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limit {
    /// Greatest force in the rod, in N.
    RodForce,
    /// Greatest moment of the counterweight, in N·m.
    Counterweight,
}

/// The best lever for each value of a limit, from the tightest, which the next
/// begins with: what each step of it costs. A value that no lever keeps has its fault in its place.
///
/// # Errors
/// Values that do not rise.
pub fn front(
    problem: &Problem,
    limit: Limit,
    values: &[f64],
    effort: Effort,
    watch: Watch<'_>,
) -> Result<Vec<Result<Found, OutOfRange>>, OutOfRange> {
    let symbol = match limit {
        Limit::RodForce => &s::N_MAX,
        Limit::Counterweight => &s::M_5,
    };
    for pair in values.windows(2) {
        check(symbol, pair[1], [pair[0], f64::MAX])?;
    }
    let mut front: Vec<Result<Found, OutOfRange>> = Vec::new();
    for &value in values {
        let mut problem = problem.clone();
        match limit {
            Limit::RodForce => problem.constraints.n_max = Some(value),
            Limit::Counterweight => problem.bounds.m_5[1] = value,
        }
        // What a tighter limit allows, this one allows too.
        let tighter = front.last().and_then(|last| last.as_ref().ok());
        front.push(seek(
            &problem,
            effort,
            tighter.map(|last| last.dimensions),
            FEW_FINISHED,
            watch,
        ));
    }
    Ok(front)
}

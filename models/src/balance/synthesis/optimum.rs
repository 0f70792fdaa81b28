//! The best lever counterweight under constraints, found from nowhere: runs of
//! an evolution strategy (CMA-ES), each with its own seed, the best of them taken.

use std::cell::RefCell;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::ops::ControlFlow;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use cmaes::{CMAESOptions, DVector};

use crate::balance::lever::Dimensions;
use crate::balance::synthesis::candidate::{Criteria, Positions};
use crate::balance::synthesis::tolerance::Builds;
use crate::balance::{Fault, POSITIVE, check, symbols as s};
use crate::calc::Calc;
use crate::four_bar::Branch;
use crate::symbol::Symbol;

/// What is minimised.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Criterion {
    /// Greatest amount of the residual.
    Residual,
    /// Integral of the residual's amount.
    Energy,
    /// Greatest force in the rod.
    RodForce,
}

/// What a solution must keep.
#[derive(Clone, Copy, Debug)]
pub struct Constraints {
    /// Smallest transmission angle, in rad.
    pub gamma_min: f64,
    /// Stable ends: at least this moment turns the boom inwards, in N·m. [Balance004, eq. 6-7]
    pub m_plus: Option<f64>,
    /// Greatest force in the rod, in N.
    pub n_max: Option<f64>,
    /// Greatest amount of the residual, in N·m, when something else is minimised.
    pub dm_max: Option<f64>,
    /// The counterweight stays behind the lever's pivot.
    pub rearward: bool,
}

/// Smallest and greatest value of each dimension; equal where it is fixed.
pub type Bounds = Dimensions<[f64; 2]>;

/// A search.
#[derive(Clone, Debug)]
pub struct Problem {
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
    /// Value of the criterion, in SI; of 95 % of all builds in the robust mode.
    pub value: f64,
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
/// How many of the short runs are continued, and how often at most.
const REFINED: usize = 3;
const ROUNDS: usize = 40;
/// Rounds without gain after which nothing more is expected.
const IDLE: usize = 4;
/// Keeps the seeds of two searches apart (2⁶⁴ over the golden ratio).
const SPREAD: u64 = 0x9E37_79B9_7F4A_7C15;

impl Problem {
    /// # Errors
    /// Bounds or constraints that contradict each other or are no numbers.
    pub fn check(&self) -> Result<(), Fault> {
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
    pub fn violated(&self, c: &Criteria) -> Vec<Fault> {
        let k = &self.constraints;
        let inf = f64::INFINITY;
        let mut faults = Vec::new();
        let mut demand = |symbol, value: f64, allowed: [f64; 2], what| {
            if !(allowed[0]..=allowed[1]).contains(&value) {
                faults.push(Fault::new(symbol, value, allowed, what));
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
    fn refine(&self, mut best: Attempt, random: &mut fastrand::Rng) -> Attempt {
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
            if idle == IDLE {
                break;
            }
        }
        best
    }

    /// Whether every dimension lies within its bounds.
    fn within(&self, d: &Dimensions<f64>) -> Result<(), Fault> {
        let mut sound = Ok(());
        self.each(d, |symbol, value, bounds| {
            if sound.is_ok() {
                sound = check(symbol, value, bounds);
            }
        });
        sound
    }

    /// The dimensions that lie at one of their bounds.
    #[must_use]
    pub fn at_bounds(&self, d: &Dimensions<f64>) -> Vec<&'static Symbol> {
        let mut found = Vec::new();
        self.each(d, |symbol, value, [low, high]| {
            if low < high && (value - low).min(high - value) <= 1e-3 * (high - low) {
                found.push(symbol);
            }
        });
        found
    }

    fn found(&self, best: &Attempt, complete: bool) -> Result<Found, Fault> {
        let dimensions = best.dimensions;
        let criteria = self.positions.evaluate(&dimensions, self.branch).map_err(|_| {
            let what = "no linkage within the bounds closes over the whole working range";
            Fault::new(&s::L_K, dimensions.l_1, self.bounds.l_1, what)
        })?;
        if let Some(worst) = self.violated(&criteria).first() {
            let names: Vec<&str> = self.at_bounds(&dimensions).iter().map(|symbol| symbol.id).collect();
            let bounds = if names.is_empty() {
                "none".to_owned()
            } else {
                names.join(", ")
            };
            return Err(Fault {
                what: format!(
                    "no lever within the bounds keeps every constraint; the nearest one misses the {} \
                     and lies at the bounds of {bounds}: widen these or ease the constraint",
                    worst.what
                ),
                ..worst.clone()
            });
        }
        Ok(Found {
            dimensions,
            criteria,
            value: self.worth(&dimensions, &criteria),
            complete,
        })
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

/// How far a search has come.
#[derive(Clone, Copy, Debug)]
pub struct Progress {
    /// Runs done, and how many there are.
    pub done: usize,
    pub of: usize,
}

/// The best lever. `progress` is told after every run, and can break off: then
/// the best so far is returned, marked as not complete.
///
/// # Errors
/// Bounds or constraints that contradict each other; constraints that no
/// lever within the bounds keeps, with the bounds that the nearest one touches.
pub fn search(
    problem: &Problem,
    effort: Effort,
    progress: &(dyn Fn(Progress) -> ControlFlow<()> + Sync),
) -> Result<Found, Fault> {
    problem.check()?;
    let runs = effort.runs.max(1);
    let of = runs + REFINED.min(runs);
    let stop = AtomicBool::new(false);
    let done = AtomicUsize::new(0);
    let seed = |run: usize| fastrand::Rng::with_seed(effort.seed.wrapping_mul(SPREAD).wrapping_add(run as u64));
    let finished = || {
        let done = done.fetch_add(1, Ordering::Relaxed) + 1;
        if progress(Progress { done, of }).is_break() {
            stop.store(true, Ordering::Relaxed);
        }
    };
    let explored = shared(runs, effort.threads, &stop, |run| {
        let best = problem.explore(&mut seed(run));
        finished();
        best
    });
    let mut best = explored;
    best.sort_by(|a, b| b.keeps.cmp(&a.keeps).then(a.cost.total_cmp(&b.cost)));
    best.truncate(REFINED);
    let refined = shared(best.len(), effort.threads, &stop, |run| {
        let best = problem.refine(best[run], &mut seed(runs + run));
        finished();
        best
    });
    // What was broken off has not been refined.
    let chosen = refined
        .iter()
        .chain(&best)
        .reduce(|a, b| if b.better(a) { b } else { a });
    problem.found(chosen.expect("the first run always ends"), !stop.into_inner())
}

/// The best near a given lever: a search that knows where to begin.
///
/// # Errors
/// As [`search`]; a start outside the bounds.
pub fn improve(problem: &Problem, start: Dimensions<f64>, seed: u64) -> Result<Found, Fault> {
    problem.check()?;
    problem.within(&start)?;
    let best = problem.refine(problem.attempt(start), &mut fastrand::Rng::with_seed(seed));
    problem.found(&best, true)
}

/// What a front is drawn against.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limit {
    /// Greatest force in the rod, in N.
    RodForce,
    /// Greatest moment of the counterweight, in N·m.
    Counterweight,
}

/// The best lever for each value of a limit, from the tightest: what each step
/// of it costs. A value that no lever keeps has its fault in its place.
///
/// # Errors
/// Values that do not rise.
pub fn front(
    problem: &Problem,
    limit: Limit,
    values: &[f64],
    effort: Effort,
    progress: &(dyn Fn(Progress) -> ControlFlow<()> + Sync),
) -> Result<Vec<Result<Found, Fault>>, Fault> {
    let symbol = match limit {
        Limit::RodForce => &s::N_MAX,
        Limit::Counterweight => &s::M_5,
    };
    for pair in values.windows(2) {
        check(symbol, pair[1], [pair[0], f64::MAX])?;
    }
    let mut front: Vec<Result<Found, Fault>> = Vec::new();
    for &value in values {
        let mut problem = problem.clone();
        match limit {
            Limit::RodForce => problem.constraints.n_max = Some(value),
            Limit::Counterweight => problem.bounds.m_5[1] = value,
        }
        let cold = search(&problem, effort, progress);
        // What a tighter limit allows, this one allows too.
        let tighter = front.last().and_then(|last| last.as_ref().ok());
        let warm = tighter.map(|last| improve(&problem, last.dimensions, effort.seed));
        front.push(match (cold, warm) {
            (Ok(cold), Some(Ok(warm))) if warm.value < cold.value => Ok(warm),
            (Err(_), Some(Ok(warm))) => Ok(warm),
            (cold, _) => cold,
        });
    }
    Ok(front)
}

/// Results of `count` jobs in their order, whichever thread did them. The
/// first job is always done; later ones are left out after a stop.
fn shared<T: Send>(count: usize, threads: usize, stop: &AtomicBool, job: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let next = AtomicUsize::new(0);
    let results = Mutex::new(Vec::new());
    std::thread::scope(|scope| {
        for _ in 0..threads.clamp(1, count.max(1)) {
            scope.spawn(|| {
                loop {
                    let index = next.fetch_add(1, Ordering::Relaxed);
                    if index >= count || (index > 0 && stop.load(Ordering::Relaxed)) {
                        return;
                    }
                    let result = job(index);
                    results.lock().expect("no job panics").push((index, result));
                }
            });
        }
    });
    let mut results = results.into_inner().expect("no job panics");
    results.sort_by_key(|&(index, _)| index);
    results.into_iter().map(|(_, result)| result).collect()
}

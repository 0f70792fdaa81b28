//! From a scene's task to its lever.

use std::sync::Arc;

use lemnis_models::balance::analysis::Analysis;
use lemnis_models::balance::boom::Boom;
use lemnis_models::balance::lever::{Dimensions, Lever};
use lemnis_models::balance::task::{CandidateRole, Criterion, Method, Task};
use lemnis_models::balance::{Balance, symbols as s};
use lemnis_models::kernel::allowed::OutOfRange;
use lemnis_models::kernel::shared::Watch;
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::parts::four_bar::Branch;

use crate::four::Nodes;
use crate::optimum::{self, Effort, FEW_FINISHED, Found, Limit, Problem, RUNS, improve, search};
use crate::three;
use crate::tolerance::Builds;

/// What came of a task.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// Rounded to what a scene writes.
    pub dimensions: Dimensions<f64>,
    pub branch: Branch,
    /// Of the conditions of an optimum, before rounding; of constructions and of many builds there is none.
    pub residual: Option<f64>,
    /// Whether the search came to its end.
    pub complete: bool,
    /// Levers of least residual under other limits of rod force and of counterweight.
    pub fronts: Vec<(CandidateRole, Dimensions<f64>)>,
}

/// Builds of which the robust mode keeps 95 %: a hundred foretell what thousands keep.
const BUILDS: usize = 100;
/// Limits of the fronts over what the found lever has; of the counterweight over its bound.
const ROD_FORCES: [f64; 7] = [0.4, 0.6, 0.8, 1.25, 1.6, 2.2, 3.0];
const COUNTERWEIGHTS: [f64; 6] = [0.75, 0.85, 0.95, 1.1, 1.2, 1.3];
/// Runs for a point of a front, which also starts from its neighbour.
const FEW: usize = 12;

/// How often [`run`] calls [`Watch::run`].
#[must_use]
pub fn steps(task: &Task) -> usize {
    match task.method {
        Method::Optimum => {
            let branches = if task.branch.is_none() { 2 } else { 1 };
            let points = ROD_FORCES.len() + COUNTERWEIGHTS.len();
            branches * optimum::runs(effort(task, RUNS, 1)) + points * (FEW + FEW_FINISHED)
        }
        Method::Three { .. } | Method::Four { .. } => 0,
    }
}

fn effort(task: &Task, runs: usize, threads: usize) -> Effort {
    Effort {
        seed: task.seed,
        runs,
        threads,
    }
}

/// The lever that a task asks for, over the boom angles `range` (rad).
///
/// # Errors
/// Constructions that have no lever, searches that find none.
pub fn run(
    boom: &Arc<dyn Boom<f64> + Send + Sync>,
    range: [f64; 2],
    task: &Task,
    threads: usize,
    watch: Watch<'_>,
) -> Result<Outcome, OutOfRange> {
    let whole = boom;
    let boom = &**boom;
    let (d_1, delta_1) = (task.bounds.d_1[0], task.bounds.delta_1[0]);
    let lever = match task.method {
        Method::Optimum => return best(whole, range, task, threads, watch),
        Method::Three {
            positions: p,
            r_1,
            alpha_1,
        } => {
            let given = three::Given {
                phi: p.phi,
                d_1,
                delta_1,
                r_1,
                alpha_1,
                psi_1: p.psi_1,
                m_5: p.m_5,
            };
            three::lever(boom, &given)?
        }
        Method::Four { positions: p, lever } => {
            let nodes = Nodes::new(boom, p.phi, p.psi_1, p.m_5)?;
            let levers = nodes.levers(d_1, delta_1, lever)?.into_iter();
            let levers = levers.filter(|lever| task.branch.is_none_or(|branch| lever.branch == branch));
            let residual = |lever: &Lever<f64>| {
                let whole = Analysis::new(boom, &Balance::Lever(*lever), range);
                whole.map_or(f64::INFINITY, |whole| whole.dm_max.value)
            };
            let best = levers.min_by(|a, b| residual(a).total_cmp(&residual(b)));
            best.ok_or_else(|| {
                let what = "every lever with this rod arm that passes the nodes is of the other branch";
                OutOfRange::new(&s::R_L, lever, lemnis_models::kernel::allowed::POSITIVE, what)
            })?
        }
    };
    Analysis::new(boom, &Balance::Lever(lever), range)?;
    Ok(Outcome {
        dimensions: rounded(&lever.dimensions),
        branch: lever.branch,
        residual: None,
        complete: true,
        fronts: Vec::new(),
    })
}

fn best(
    boom: &Arc<dyn Boom<f64> + Send + Sync>,
    range: [f64; 2],
    task: &Task,
    threads: usize,
    watch: Watch<'_>,
) -> Result<Outcome, OutOfRange> {
    let branches = match task.branch {
        Some(branch) => vec![branch],
        None => vec![Branch::Left, Branch::Right],
    };
    let mut chosen: Result<(Problem, Found), OutOfRange> = Err(OutOfRange::new(&s::L_1, 0.0, [0.0, 0.0], ""));
    for branch in branches {
        let found = in_branch(boom, range, task, branch, threads, watch);
        let value = chosen.as_ref().map_or(f64::INFINITY, |(_, best)| best.value);
        match found {
            Ok(found) if found.1.value < value => chosen = Ok(found),
            Err(fault) if value.is_infinite() => chosen = Err(fault),
            _ => {}
        }
    }
    let (problem, found) = chosen?;
    // Both fronts are those of the residual, each along its own limit.
    let branch = problem.branch;
    let mut of_residual = Problem {
        criterion: Criterion::Residual,
        constraints: task.constraints,
        robust: None,
        ..problem.clone()
    };
    of_residual.constraints.dm_max = None;
    let heaviest = problem.bounds.m_5[1];
    let front = |limit, values: &[f64]| optimum::front(&of_residual, limit, values, effort(task, FEW, 1), watch);
    // As many threads as fronts, each by itself.
    let (rod, counterweight) = std::thread::scope(|scope| {
        let rod = scope.spawn(|| front(Limit::RodForce, &ROD_FORCES.map(|part| part * found.criteria.n_max)));
        let counterweight = front(Limit::Counterweight, &COUNTERWEIGHTS.map(|part| part * heaviest));
        (rod.join().expect("a search does not panic"), counterweight)
    });
    let mut fronts = Vec::new();
    for (role, front) in [
        (CandidateRole::RodForce, rod?),
        (CandidateRole::Counterweight, counterweight?),
    ] {
        fronts.extend(
            front
                .into_iter()
                .flatten()
                .map(|found| (role, rounded(&found.dimensions))),
        );
    }
    Ok(Outcome {
        dimensions: problem.written(&found.dimensions, &rounded),
        branch,
        residual: found.residual,
        complete: found.complete,
        fronts,
    })
}

/// The best lever of one branch, with the problem that it solves.
fn in_branch(
    boom: &Arc<dyn Boom<f64> + Send + Sync>,
    range: [f64; 2],
    task: &Task,
    branch: Branch,
    threads: usize,
    watch: Watch<'_>,
) -> Result<(Problem, Found), OutOfRange> {
    let mut problem = Problem::new(boom, range, task, branch)?;
    let start = task
        .candidates
        .iter()
        .find(|candidate| candidate.role == CandidateRole::Start);
    let mut found = match start {
        Some(start) if start.branch == branch => improve(&problem, start.dimensions, task.seed, watch)?,
        _ => search(&problem, effort(task, RUNS, threads), watch)?,
    };
    if task.robust {
        problem.robust = Some(Builds::new(&problem.positions, task.tolerances, BUILDS, task.seed)?);
        found = improve(&problem, found.dimensions, task.seed, watch)?;
    }
    // Of many builds none is finished: between the positions of the search a constraint may be missed by a hair. Then as
    // much more is asked for.
    for _ in 0..SETTLING {
        let settled = found.residual.is_some() || !watch.goes_on();
        if settled || !tighten(&**boom, range, task, &mut problem, &found) {
            break;
        }
        found = improve(&problem, found.dimensions, task.seed, watch)?;
    }
    Ok((problem, found))
}

/// How often a lever is brought back to where it keeps its constraints between the positions too.
const SETTLING: usize = 3;
/// More than is lost by rounding what a scene writes.
const ROUNDING: f64 = 1e-6;

/// Asks for as much more as the lever misses over the whole range; false where it misses nothing.
fn tighten(boom: &(dyn Boom<f64> + Sync), range: [f64; 2], task: &Task, problem: &mut Problem, found: &Found) -> bool {
    let balance = Lever::new(rounded(&found.dimensions), None, problem.branch).map(Balance::Lever);
    let Ok(whole) = balance.and_then(|balance| Analysis::new(boom, &balance, range)) else {
        return false;
    };
    let (asked, now) = (&task.constraints, &mut problem.constraints);
    let mut missed = false;
    let mut demand = |limit: &mut f64, short: f64, size: f64, up: bool| {
        if short > 0.0 {
            missed = true;
            let more = short + ROUNDING * size;
            *limit += if up { more } else { -more };
        }
    };
    if let Some(gamma) = whole.gamma_min {
        demand(&mut now.gamma_min, asked.gamma_min - gamma.value, 1.0, true);
    }
    if let (Some(limit), Some(most), Some(force)) = (&mut now.n_max, asked.n_max, whole.n_max) {
        demand(limit, force.value - most, most, false);
    }
    if let (Some(limit), Some(most)) = (&mut now.dm_max, asked.dm_max) {
        demand(limit, whole.dm_max.value - most, most, false);
    }
    if let (Some(limit), Some(least)) = (&mut now.m_plus, asked.m_plus) {
        let ends = whole.ends[0].min(-whole.ends[1]);
        demand(limit, least - ends, whole.dm_max.value, true);
    }
    missed
}

/// Decimals in the display unit that a scene writes: micrometres, millionths of a degree, newton metres.
#[must_use]
pub fn decimals(symbol: &Symbol) -> usize {
    if symbol == &s::M_5 { 3 } else { 6 }
}

fn rounded(d: &Dimensions<f64>) -> Dimensions<f64> {
    d.map(&mut |symbol, value| {
        let text = format!("{:.*}", decimals(symbol), symbol.shown(value));
        text.parse::<f64>().expect("digits") * symbol.display.factor
    })
}

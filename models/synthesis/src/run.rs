//! From a scene's task to its lever.

use lemnis_models::balance::analysis::Analysis;
use lemnis_models::balance::boom::Boom;
use lemnis_models::balance::lever::{Dimensions, Lever};
use lemnis_models::balance::task::{Criterion, Method, Role, Task};
use lemnis_models::balance::{Balance, Fault, symbols as s};
use lemnis_models::four_bar::Branch;
use lemnis_models::symbol::Symbol;

use crate::four::Nodes;
use crate::optimum::{self, Effort, Found, Limit, Problem, RUNS, Watch, improve, search};
use crate::three;
use crate::tolerance::Builds;

/// What came of a task.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// Rounded to what a scene writes.
    pub dimensions: Dimensions<f64>,
    pub branch: Branch,
    /// Whether the search came to its end.
    pub complete: bool,
    /// Levers of least residual under other limits of rod force and of counterweight.
    pub fronts: Vec<(Role, Dimensions<f64>)>,
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
pub fn steps(task: &Task, threads: usize) -> usize {
    let runs = |runs| optimum::runs(effort(task, runs, threads));
    match task.method {
        Method::Optimum => {
            let branches = if task.branch.is_none() { 2 } else { 1 };
            branches * runs(RUNS) + (ROD_FORCES.len() + COUNTERWEIGHTS.len()) * runs(FEW)
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
pub fn run(boom: &Boom<f64>, range: [f64; 2], task: &Task, threads: usize, watch: Watch<'_>) -> Result<Outcome, Fault> {
    let (d_1, delta_1) = (task.bounds.d_1[0], task.bounds.delta_1[0]);
    let lever = match task.method {
        Method::Optimum => return best(boom, range, task, threads, watch),
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
                Fault::new(&s::R_L, lever, lemnis_models::balance::POSITIVE, what)
            })?
        }
    };
    Analysis::new(boom, &Balance::Lever(lever), range)?;
    Ok(Outcome {
        dimensions: rounded(&lever.dimensions),
        branch: lever.branch,
        complete: true,
        fronts: Vec::new(),
    })
}

fn best(boom: &Boom<f64>, range: [f64; 2], task: &Task, threads: usize, watch: Watch<'_>) -> Result<Outcome, Fault> {
    let branches = match task.branch {
        Some(branch) => vec![branch],
        None => vec![Branch::Left, Branch::Right],
    };
    let mut chosen: Result<(Problem, Found), Fault> = Err(Fault::new(&s::L_K, 0.0, [0.0, 0.0], ""));
    for branch in branches {
        let found = in_branch(&Problem::new(boom, range, task, branch)?, task, threads, watch);
        let value = chosen.as_ref().map_or(f64::INFINITY, |(_, best)| best.value);
        match found {
            Ok(found) if found.1.value < value => chosen = Ok(found),
            Err(fault) if value.is_infinite() => chosen = Err(fault),
            _ => {}
        }
    }
    let (problem, found) = chosen?;
    // Both fronts are those of the residual, each along its own limit.
    let mut of_residual = Problem {
        criterion: Criterion::Residual,
        robust: None,
        ..problem
    };
    of_residual.constraints.dm_max = None;
    let few = effort(task, FEW, threads);
    let heaviest = problem.bounds.m_5[1];
    let sides = [
        (
            Role::RodForce,
            Limit::RodForce,
            ROD_FORCES.map(|part| part * found.criteria.n_max).to_vec(),
        ),
        (
            Role::Counterweight,
            Limit::Counterweight,
            COUNTERWEIGHTS.map(|part| part * heaviest).to_vec(),
        ),
    ];
    let mut fronts = Vec::new();
    for (role, limit, values) in sides {
        for found in optimum::front(&of_residual, limit, &values, few, watch)?
            .into_iter()
            .flatten()
        {
            fronts.push((role, rounded(&found.dimensions)));
        }
    }
    Ok(Outcome {
        dimensions: rounded(&found.dimensions),
        branch: of_residual.branch,
        complete: found.complete,
        fronts,
    })
}

/// The best lever of one branch, with the problem that it solves.
fn in_branch(problem: &Problem, task: &Task, threads: usize, watch: Watch<'_>) -> Result<(Problem, Found), Fault> {
    let start = task.candidates.iter().find(|candidate| candidate.role == Role::Start);
    let found = match start {
        Some(start) if start.branch == problem.branch => improve(problem, start.dimensions, task.seed, watch)?,
        _ => search(problem, effort(task, RUNS, threads), watch)?,
    };
    if !task.robust {
        return Ok((problem.clone(), found));
    }
    let builds = Builds::new(&problem.positions, task.tolerances, BUILDS, task.seed)?;
    let robust = Problem {
        robust: Some(builds),
        ..problem.clone()
    };
    let found = improve(&robust, found.dimensions, task.seed, watch)?;
    Ok((robust, found))
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

//! Changes from each travel mode to each other one, for the book.

use crate::sheet::{Change, Changes, Curve};
use crate::steering::mode::{Centre, Mode};
use crate::steering::outputs::{Built, Inputs, Output};
use crate::steering::reach::stand;
use crate::steering::scene::Steering;
use crate::steering::sheet::{evaluation, example};
use crate::steering::symbols as s;
use crate::steering::transition::{Crew, Plan};

/// Points of a drawn curve.
const CURVE: u32 = 240;

/// A mode with the command of the chapter of travel modes.
struct Stance {
    mode: Mode,
    centre: Centre<f64>,
    angles: Vec<f64>,
}

/// The changes between all modes that all groups can follow; `None` where the scene gives no speed of the cylinders.
pub(super) fn changes(steering: &Steering, built: &Built<f64>) -> Option<Changes> {
    let crew = Crew {
        machine: &built.machine,
        limits: &built.limits,
        linkages: &built.linkages,
        speed: steering.parameters.pace?.speed,
    };
    let stances: Vec<Stance> = Mode::ALL
        .into_iter()
        .filter_map(|mode| stance(steering, built, example(steering, built, mode)?))
        .collect();
    let plan = |a: &Stance, b: &Stance| crew.transition(&a.centre, &a.angles, &b.centre).ok();
    let row = |a: &Stance, b: &Stance, plan: Option<&Plan>| Change {
        between: [a.mode.id(), b.mode.id()],
        plan: plan.map(|plan| (plan.time, plan.standing, plan.governing + 1)),
        flow: plan
            .zip(steering.parameters.piston)
            .map(|(plan, piston)| plan.greatest_flow(&crew, &piston)),
    };
    let mut rows = Vec::new();
    for (i, a) in stances.iter().enumerate() {
        for b in &stances[i + 1..] {
            let (there, back) = (plan(a, b), plan(b, a));
            let same = match (&there, &back) {
                (Some(there), Some(back)) => there.standing == back.standing && (there.time - back.time).abs() < 1e-6,
                (there, back) => there.is_none() && back.is_none(),
            };
            rows.push(row(a, b, there.as_ref()));
            if !same {
                rows.push(row(b, a, back.as_ref()));
            }
        }
    }
    let of = |mode: Mode| stances.iter().find(|stance| stance.mode == mode);
    let [from, to] = steering.drawn;
    let drawn = of(from.unwrap_or(steering.inputs.mode)).and_then(|from| {
        let others = stances.iter().filter(|to| to.mode != from.mode);
        let timed = others.filter_map(|to| Some((to, plan(from, to)?)));
        let (to, plan) = match to {
            Some(to) => (of(to)?, plan(from, of(to)?)?),
            None => timed.max_by(|a, b| a.1.time.total_cmp(&b.1.time))?,
        };
        Some(([from.mode.id(), to.mode.id()], curves(&crew, &plan)))
    });
    Some(Changes {
        columns: [&s::T_X, &s::Q_X_MAX],
        rows,
        drawn,
    })
}

fn stance(steering: &Steering, built: &Built<f64>, inputs: Inputs<f64>) -> Option<Stance> {
    let (mode, command) = (inputs.mode, inputs.command());
    let reachable = evaluation(steering, inputs).output(Output::Reachable).ok()? != 0.0;
    let centre = mode.centre(&built.machine, command).ok()?;
    let mut angles = vec![0.0; built.limits.len()];
    stand(&built.machine, &built.limits, &centre, &mut angles);
    reachable.then_some(Stance { mode, centre, angles })
}

/// Angles of the groups and speeds of their cylinders over the time of a change.
fn curves(crew: &Crew<'_>, plan: &Plan) -> Vec<Curve> {
    let n = crew.limits.len();
    let at = |part: f64| {
        let mut angles = vec![0.0; n];
        plan.angles(crew, plan.time * part, &mut angles);
        angles
    };
    let mut pieces = [vec![Vec::new(); n], vec![Vec::new(); n]];
    for step in 0..=CURVE {
        let part = f64::from(step) / f64::from(CURVE);
        // The speed by differences, to the inside of the change at its ends.
        let beside = [(part - 1e-4).max(0.0), (part + 1e-4).min(1.0)];
        let (angles, [before, after]) = (at(part), beside.map(at));
        for i in 0..n {
            let length = |angle: f64| crew.linkages[i].at_angle(angle).l;
            let speed = (length(after[i]) - length(before[i])) / (plan.time * (beside[1] - beside[0]));
            pieces[0][i].push([plan.time * part, angles[i]]);
            pieces[1][i].push([plan.time * part, if plan.time > 0.0 { speed } else { 0.0 }]);
        }
    }
    let [angles, speeds] = pieces;
    let curve = |id, y, pieces| Curve {
        id,
        x: &s::T_C,
        y,
        pieces,
        numbers: (1..=n).collect(),
    };
    vec![
        curve("change_angles", &s::THETA_S, angles),
        curve("change_speeds", &s::V_C, speeds),
    ]
}

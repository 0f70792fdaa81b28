//! Changes from each travel mode to each other one, for the book.

use crate::component::sheet::{Changeover, Changes, Curve};
use crate::component::telling::between;
use crate::steering::built::Built;
use crate::steering::drawing::Stance;
use crate::steering::flow::{Piston, flow};
use crate::steering::mode::Mode;
use crate::steering::plan::{Crew, Plan};
use crate::steering::scene::Steering;
use crate::steering::symbols as s;
use crate::steering::views::example;

/// The changes between all modes that all groups can follow; `None` where the scene gives no speed of the cylinders.
pub fn changes(steering: &Steering, built: &Built) -> Option<Changes> {
    let crew = Crew {
        machine: &built.machine,
        limits: &built.limits,
        linkages: &built.linkages,
        speed: steering.given.pace?.speed,
    };
    let stances: Vec<Stance> = Mode::ALL
        .into_iter()
        .filter_map(|mode| Stance::new(example(steering, built, mode)?).ok())
        .filter(|stance| stance.reachable)
        .collect();
    let plan = |a: &Stance, b: &Stance| crew.transition(&a.centre, &a.angles, &b.centre).ok();
    let row = |a: &Stance, b: &Stance, plan: Option<&Plan>| Changeover {
        between: [a.mode.id(), b.mode.id()],
        plan: plan.map(|plan| (plan.time, plan.standing, plan.governing + 1)),
        flow: plan
            .zip(steering.given.piston)
            .map(|(plan, piston)| greatest_flow(plan, &crew, &piston)),
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
    let drawn = of(from.unwrap_or(steering.given.mode)).and_then(|from| {
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

/// Lengths of all cylinders at a time (s) of a change, in m.
fn lengths(plan: &Plan, crew: &Crew<'_>, time: f64) -> Vec<f64> {
    let angles = angles(plan, crew, time);
    let each = crew.linkages.iter().zip(angles);
    each.map(|(linkage, theta)| linkage.at_angle(theta).l).collect()
}

fn angles(plan: &Plan, crew: &Crew<'_>, time: f64) -> Vec<f64> {
    let moment = plan.at(crew.machine, time);
    let each = crew.linkages.iter().enumerate();
    each.map(|(i, linkage)| plan.angle(&moment, i, crew.machine, linkage))
        .collect()
}

/// Greatest oil flow of all cylinders together in a change, in m³/s.
#[must_use]
pub fn greatest_flow(plan: &Plan, crew: &Crew<'_>, piston: &Piston<f64>) -> f64 {
    let ends = plan.pieces();
    let (mut before, mut greatest) = (lengths(plan, crew, 0.0), 0.0_f64);
    for pair in ends.windows(2) {
        let after = lengths(plan, crew, pair[1]);
        let slice = pair[1] - pair[0];
        if slice > 0.0 {
            let flows = before
                .iter()
                .zip(&after)
                .map(|(from, to)| flow(piston, &((to - from) / slice)).abs());
            greatest = flows.sum::<f64>().max(greatest);
        }
        before = after;
    }
    greatest
}

/// Angles of the groups and speeds of their cylinders over the time of a change.
fn curves(crew: &Crew<'_>, plan: &Plan) -> Vec<Curve> {
    let n = crew.limits.len();
    let mut pieces = [vec![Vec::new(); n], vec![Vec::new(); n]];
    for part in between(0.0, 1.0) {
        // The speed by differences, to the inside of the change at its ends.
        let beside = [(part - 1e-4).max(0.0), (part + 1e-4).min(1.0)];
        let angles = angles(plan, crew, plan.time * part);
        let [before, after] = beside.map(|part| lengths(plan, crew, plan.time * part));
        for i in 0..n {
            let speed = (after[i] - before[i]) / (plan.time * (beside[1] - beside[0]));
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

//! The step of an explicit solver: what a scene gives, or what suits the quickest of all that happens in it.

use std::f64::consts::TAU;

use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::schema::Values;
use crate::kernel::symbol::Symbol;
use crate::luffing::moving::given::Inputs;
use crate::luffing::moving::symbols as s;
use crate::luffing::moving::weather_scene::{blown, leaning};
use crate::parts::motion::short_step;

/// Longest step of the solver where a scene gives none, in s, and of a crane so large that nothing about it is as quick,
/// as a part of the least of its times.
const STEP: f64 = 0.01;
const STEP_PART: f64 = 0.002;

/// The shortest step that may be given, as a part of the one that is taken where none is, or of the least of its times if that
/// is less: below it a solver of fourth order adds up rounding.
const SHORTEST_STEP: [f64; 2] = [0.05, 1.25e-3];

/// Longest step, in s, by the tables of `[luffing]`, of its dynamics and its hoist; `bar` as in
/// [`Inert`](crate::luffing::moving::scene::Inert). One that is too short goes to the mistakes.
pub(super) fn step(
    v: &Values,
    [dynamics, hoisting]: [&Values; 2],
    (bar, strongest): ([&Symbol; 2], &Inputs),
    gravity: f64,
    found: &mut Vec<Diagnostic>,
) -> f64 {
    let quickest = quickest(v, [dynamics, hoisting], (bar, strongest), gravity);
    let longest = (quickest * STEP_PART).max(STEP);
    let least = (longest * SHORTEST_STEP[0]).min(quickest * SHORTEST_STEP[1]);
    found.extend(short_step(dynamics, &s::STEP, [least, longest]));
    dynamics.number(s::STEP.id).unwrap_or(longest)
}

/// The least time (s) in which something happens: what swings as bar and rope are long, what friction, drives and a rope
/// that gives way do with the inertia of the driven bar alone, of what slews, of the load and of the hoist's drum.
fn quickest(
    v: &Values,
    [dynamics, hoisting]: [&Values; 2],
    ([bar, inertia], strongest): ([&Symbol; 2], &Inputs),
    gravity: f64,
) -> f64 {
    let of = |table: &Values, symbol: &Symbol| table.greatest(symbol.id).unwrap_or(0.0);
    let (bar, inertia) = (of(v, bar), of(dynamics, inertia));
    let rope = hoisting.number(s::L_R.id).unwrap_or(f64::INFINITY);
    let mut times = vec![
        (bar.min(rope) / gravity).sqrt(),
        inertia / of(dynamics, &s::C_V),
        (inertia / strongest.drives[0].moment.abs()).sqrt(),
        1.0 / (TAU * strongest.weather.slewing.abs()),
    ];
    let drum = of(hoisting, &s::J_H) / of(hoisting, &s::R_H).powi(2);
    for mass in [v.number("Q").unwrap_or(0.0) / gravity, drum] {
        times.push((mass / of(hoisting, &s::C_R)).sqrt());
        times.push(mass / of(hoisting, &s::D_R));
    }
    if let Some(table) = v.table("slewing") {
        let inertia = of(table, &s::J_SL);
        times.push(inertia / of(table, &s::C_SL));
        times.push((inertia / strongest.drives[1].moment.abs()).sqrt());
        times.push((inertia / blown(v, table)).sqrt());
        times.push((inertia / leaning(table)).sqrt());
    }
    // What does not act, on what has no inertia, has no time.
    times.into_iter().fold(f64::INFINITY, f64::min)
}

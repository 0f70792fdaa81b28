//! The travel modes in the book, each with a command that shows it.

use crate::component::sheet::{Table, View};
use crate::component::standing::Standing;
use crate::component::telling::numbered;
use crate::steering::built::Built;
use crate::steering::drawing::{Stance, plan};
use crate::steering::mode::{By, Command, Mode};
use crate::steering::reach::{Reach, reach};
use crate::steering::scene::Steering;
use crate::steering::stages::Given;
use crate::steering::symbols as s;

/// What a mode is shown with: the scene's own command in its own mode, elsewhere
/// one that all groups can follow, as far as there is one.
pub fn example(steering: &Steering, built: &Built, mode: Mode) -> Option<Given<f64>> {
    let (machine, limits) = (&built.machine, &built.limits);
    let motion = &steering.motion;
    let greatest = if motion.to.abs() >= motion.from.abs() {
        motion.to
    } else {
        motion.from
    };
    let of = |theta_b: f64| {
        let mut given = steering.given.clone();
        if mode != given.mode {
            (given.mode, given.by) = (mode, By::Angle);
        }
        given.theta_b.1 = theta_b;
        given
    };
    let follows = |given: &Given<f64>| matches!(reach(machine, limits, mode, given.command()), Ok(Reach::Reachable));
    let exists = |given: &Given<f64>| mode.centre(machine, given.command()).is_ok();
    let whole = of(0.7 * greatest);
    if !matches!(whole.command(), Command::Angle(_)) {
        return Some(whole).filter(exists);
    }
    // Half of that, and so on, until all groups can follow; the other way round if none do.
    let tries = [1.0, -1.0].map(|sign| (0..6).map(move |n| of(sign * 0.7 * greatest / f64::from(1 << n))));
    tries.into_iter().flatten().find(follows).or(Some(whole)).filter(exists)
}

/// A mode with the headings of all groups, and those of the nearest command where it is out of reach.
pub fn view(steering: &Steering, built: &Built, mode: Mode) -> Option<View> {
    let given = example(steering, built, mode)?;
    let command = match given.command() {
        Command::Angle(theta) => Some((&s::THETA_B, theta)),
        Command::Radius(radius) => Some((&s::R_T, radius)),
        _ => None,
    };
    let stance = Stance::new(given).ok()?;
    let nearest = stance.nearest.found.filter(|_| !stance.reachable);
    let mut columns = vec![&s::NUMBER, &s::THETA, &s::V];
    columns.extend(nearest.map(|_| &s::THETA_N));
    let row = |i: usize| {
        let cells = [
            (1 + i) as f64,
            stance.angles[i],
            stance.speeds[i],
            stance.nearest_angles[i],
        ];
        cells[..columns.len()].to_vec()
    };
    let rows = (0..stance.angles.len()).map(row).collect();
    let told = |(mode, command): (Mode, Command<f64>)| {
        let command = match command {
            Command::Angle(theta) => vec![(&s::THETA_BN, theta)],
            Command::Radius(radius) => vec![(&s::R_TN, radius)],
            Command::Centre(at) => vec![(&s::X_C_N, at.x), (&s::Y_C_N, at.y)],
            Command::None | Command::Corner(_) => Vec::new(),
        };
        (mode.id(), command)
    };
    Some(View {
        id: mode.id(),
        command,
        reachable: stance.reachable,
        nearest: nearest.map(told),
        table: Table { columns, rows },
        drawing: plan(&built.machine, &stance),
    })
}

/// Lever arm, error and slip of all groups at a commanded angle, in rad.
pub fn slip_table(model: &mut Standing, theta_b: f64) -> Table {
    let [arms, errors, slips] = [&s::OD, &s::DELTA, &s::SLIP].map(|symbol| numbered(model, symbol, theta_b));
    let row = |i: usize| vec![(1 + i) as f64, arms[i], errors[i], slips[i]];
    Table {
        columns: vec![&s::NUMBER, &s::OD, &s::DELTA, &s::SLIP],
        rows: (0..slips.len()).map(row).collect(),
    }
}

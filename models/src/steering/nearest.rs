//! The nearest command that all groups can follow. No allocation.

use crate::kernel::calc::Calc;
use crate::parts::plane::{self, Point};
use crate::steering::centre::Centre;
use crate::steering::limits::{Limits, SAME};
use crate::steering::machine::Machine;
use crate::steering::margin::Margin;
use crate::steering::mode::{Command, Mode};
use crate::steering::stand::{obstacle, principal};

/// The command itself where all groups can follow it, else the nearest one.
#[derive(Clone, Copy, Debug)]
pub struct Nearest {
    /// `None` where there is none.
    pub found: Option<(Mode, Command<f64>)>,
    /// Its turning centre.
    pub centre: Option<Centre<f64>>,
}

impl Nearest {
    pub fn new(
        machine: &Machine<f64>,
        limits: &[Limits],
        mode: &Mode,
        command: &Command<f64>,
        centre: &Centre<f64>,
        margin: &Margin<f64>,
    ) -> Nearest {
        // The centre of the command itself is exact.
        if margin.reachable {
            return Nearest {
                found: Some((*mode, *command)),
                centre: Some(*centre),
            };
        }
        let found = nearest(machine, limits, *mode, *command);
        Nearest {
            found,
            centre: found.and_then(|(mode, command)| mode.centre(machine, command).ok()),
        }
    }
}

/// A command that says the same with a choice: straight and crosswise are directions of crab travel, the machine's
/// middle and its corners are turning centres; others stay as they are.
#[must_use]
pub fn choice(machine: &Machine<f64>, mode: Mode, command: Command<f64>) -> (Mode, Command<f64>) {
    match (mode, command) {
        (Mode::Straight, _) => (Mode::Crab, Command::Angle(0.0)),
        (Mode::Crosswise, _) => (Mode::Crab, Command::Angle(std::f64::consts::FRAC_PI_2)),
        (Mode::Pivot, _) => (Mode::Free, Command::Centre(machine.middle)),
        (Mode::Corner, Command::Corner(index)) if index < machine.corners.len() => {
            (Mode::Free, Command::Centre(machine.corners[index]))
        }
        _ => (mode, command),
    }
}

/// The reachable command that is nearest to one by angle, radius or distance of the turning centre, of the same mode
/// or, where that leaves no choice, as [`choice`] has it. `None` where no group's range leaves any.
#[must_use]
pub fn nearest(
    machine: &Machine<f64>,
    limits: &[Limits],
    mode: Mode,
    command: Command<f64>,
) -> Option<(Mode, Command<f64>)> {
    let (mode, command) = choice(machine, mode, command);
    let mut best: Option<(f64, Command<f64>)> = None;
    let mut consider = |other: Command<f64>| {
        let distance = match (command, other) {
            (Command::Angle(a), Command::Angle(b)) => (a - b).abs(),
            (Command::Radius(a), Command::Radius(b)) if a.is_finite() => (a - b).abs(),
            (Command::Radius(a), Command::Radius(b)) => -(b * a.signum()),
            (Command::Centre(a), Command::Centre(b)) => plane::length(a - b),
            _ => f64::INFINITY,
        };
        let nearer = distance < f64::INFINITY && best.is_none_or(|(least, _)| distance < least - SAME);
        let stands = |centre: Centre<f64>| obstacle(machine, limits, &centre).is_none();
        if nearer && mode.centre(machine, other).is_ok_and(stands) {
            best = Some((distance, other));
        }
    };
    consider(command);
    // The reachable commands end where some group stands at an end of its range: the nearest one is among those.
    match (mode, command) {
        (Mode::Crab, _) => {
            // Of equals the first, which is not turned over.
            for over in 0..3 {
                let angles = ends(limits).filter_map(|(_, end)| turned_over(end).nth(over));
                angles.for_each(|theta| consider(Command::Angle(theta)));
            }
        }
        (Mode::Free, Command::Centre(wanted)) => points(machine, limits, wanted, |at| consider(Command::Centre(at))),
        (_, Command::Angle(_)) => {
            let (line, base) = machine.line(mode)?;
            let from = machine.groups[base];
            consider(Command::Angle(0.0));
            for (i, end) in ends(limits) {
                let p = machine.groups[i];
                let (sin, cos) = Calc::sin_cos(end);
                // The end's axle line meets the line of centres; the base's heading there.
                let along = Point::new(sin * (p.y - from.y) + (p.x - line) * cos, sin * (from.x - line));
                let theta = if i == base { end } else { principal(along) };
                turned_over(theta).for_each(|theta| consider(Command::Angle(theta)));
            }
        }
        (_, Command::Radius(_) | Command::Centre(_)) => {
            let (line, _) = machine.line(mode)?;
            for (i, end) in ends(limits) {
                let p = machine.groups[i];
                let (sin, cos) = Calc::sin_cos(end);
                let y = p.y + (p.x - line) * cos / sin;
                if y.is_finite() {
                    consider(match command {
                        Command::Radius(_) => Command::Radius(y - machine.middle.y),
                        _ => Command::Centre(Point::new(line, y)),
                    });
                }
            }
        }
        _ => {}
    }
    best.map(|(_, command)| (mode, command))
}

/// Every end of every group's range, forbidden ranges included.
fn ends(limits: &[Limits]) -> impl Iterator<Item = (usize, f64)> {
    limits.iter().enumerate().flat_map(|(i, limits)| {
        let outer = [limits.min, limits.max];
        outer
            .into_iter()
            .chain(limits.forbidden.iter().flatten().copied())
            .map(move |end| (i, end))
    })
}

/// The angles within half a turn that have the same axle line.
fn turned_over(theta: f64) -> impl Iterator<Item = f64> {
    let half = std::f64::consts::PI;
    [theta, theta - half, theta + half]
        .into_iter()
        .filter(move |angle| angle.abs() <= half)
}

/// Nearest points of, and crossings between, the axle lines at the ends of the ranges.
fn points(machine: &Machine<f64>, limits: &[Limits], wanted: Point<f64>, mut found: impl FnMut(Point<f64>)) {
    let lines = || {
        ends(limits).map(|(i, end)| {
            let (sin, cos) = Calc::sin_cos(end);
            (machine.groups[i], Point::new(-sin, cos))
        })
    };
    for (i, (p, along)) in lines().enumerate() {
        found(p + along * plane::dot(wanted - p, along));
        for (q, other) in lines().take(i) {
            let sine = plane::cross(along, other);
            if sine.abs() > SAME {
                found(p + along * (plane::cross(q - p, other) / sine));
            }
        }
    }
}

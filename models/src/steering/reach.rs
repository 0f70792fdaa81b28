//! Whether the groups can follow a command, and the nearest one that they can.

use crate::calc::Calc;
use crate::plane::{self, Point};
use crate::schema::short;
use crate::steering::machine::{Limits, Machine, Refusal, SAME};
use crate::steering::mode::{Centre, Command, Mode};

/// What became of a command.
#[derive(Clone, Debug, PartialEq)]
pub enum Reach {
    Reachable,
    Unreachable {
        /// The first group that cannot, numbered from 0.
        group: usize,
        /// The angle that it would need, in rad, in (−π/2, π/2].
        needs: f64,
        /// The nearest command of the same kind that all groups can follow:
        /// nearest in angle, radius or distance of the centre. `None` where the
        /// mode leaves no choice, or none is reachable.
        nearest: Option<Command<f64>>,
    },
}

impl Reach {
    /// The message for a command that is out of reach.
    #[must_use]
    pub fn refusal(&self, limits: &[Limits]) -> Option<Refusal> {
        let Reach::Unreachable { group, needs, nearest } = self else {
            return None;
        };
        let range = &limits[*group];
        let degrees = |x: f64| short(x.to_degrees());
        let help = match nearest {
            Some(Command::Angle(theta)) => format!("the nearest angle of the base group is {} deg", degrees(*theta)),
            Some(Command::Radius(radius)) => format!("the nearest radius is {} m", short(*radius)),
            Some(Command::Centre(at)) => {
                format!("the nearest turning centre is ({}, {}) m", short(at.x), short(at.y))
            }
            _ => "no command of this mode is reachable: choose another mode or widen the range".to_owned(),
        };
        let forbidden = if range.forbidden.is_empty() {
            ""
        } else {
            ", outside its forbidden ranges"
        };
        Some(Refusal::new(
            format!("theta[{}]", group + 1),
            format!("group {} would have to stand at {} deg", group + 1, degrees(*needs)),
            format!(
                "it turns from {} to {} deg{forbidden}; {help}",
                degrees(range.min),
                degrees(range.max)
            ),
        ))
    }
}

/// The first group that cannot put its axle line through the centre, and the angle it would need.
fn obstacle(machine: &Machine<f64>, limits: &[Limits], centre: &Centre<f64>) -> Option<(usize, f64)> {
    machine
        .groups
        .iter()
        .zip(limits)
        .enumerate()
        .find_map(|(i, (p, limits))| {
            let along = centre.rolling(*p);
            let theta = principal(along);
            // On the centre any angle will do.
            let free = along.x == 0.0 && along.y == 0.0;
            (!free && limits.equivalents(theta).next().is_none()).then_some((i, theta))
        })
}

/// Direction of an axle line's normal, in (−π/2, π/2].
fn principal(along: Point<f64>) -> f64 {
    let backwards = along.x < 0.0 || (along.x == 0.0 && along.y < 0.0);
    let along = if backwards { -along } else { along };
    f64::direction(along.x, along.y)
}

/// Whether every group can stand as the command asks. One range for each group.
pub fn reach(machine: &Machine<f64>, limits: &[Limits], mode: Mode, command: Command<f64>) -> Result<Reach, Refusal> {
    if limits.len() != machine.groups.len() {
        return Err(Refusal::new(
            "limits",
            format!("{} ranges for {} groups", limits.len(), machine.groups.len()),
            "give one range for each group",
        ));
    }
    let centre = mode.centre(machine, command)?;
    let Some((group, needs)) = obstacle(machine, limits, &centre) else {
        return Ok(Reach::Reachable);
    };
    // The reachable commands end where some group stands at an end of its range:
    // the nearest one is among those.
    let mut candidates: Vec<Command<f64>> = Vec::new();
    match (mode, command) {
        (Mode::Crab, _) => {
            let angles = ends(limits).flat_map(|(_, end)| turned_over(end));
            candidates.extend(angles.map(Command::Angle));
        }
        (Mode::Free, _) => candidates.extend(points(machine, limits, command).into_iter().map(Command::Centre)),
        (_, Command::Angle(_)) => {
            let (line, base) = machine.line(mode).expect("commanded by angle");
            let from = machine.groups[base];
            candidates.push(Command::Angle(0.0));
            for (i, end) in ends(limits) {
                let p = machine.groups[i];
                let (sin, cos) = Calc::sin_cos(end);
                // The end's axle line meets the line of centres; the base's heading there.
                let along = Point::new(sin * (p.y - from.y) + (p.x - line) * cos, sin * (from.x - line));
                let theta = if i == base { end } else { principal(along) };
                candidates.extend(turned_over(theta).map(Command::Angle));
            }
        }
        (_, Command::Radius(_) | Command::Centre(_)) => {
            let (line, _) = machine.line(mode).expect("commanded by radius");
            for (i, end) in ends(limits) {
                let p = machine.groups[i];
                let (sin, cos) = Calc::sin_cos(end);
                let y = p.y + (p.x - line) * cos / sin;
                if y.is_finite() {
                    candidates.push(match command {
                        Command::Radius(_) => Command::Radius(y - machine.middle.y),
                        _ => Command::Centre(Point::new(line, y)),
                    });
                }
            }
        }
        _ => {}
    }
    let distance = |other: &Command<f64>| match (command, other) {
        (Command::Angle(a), Command::Angle(b)) => (a - b).abs(),
        (Command::Radius(a), Command::Radius(b)) if a.is_finite() => (a - b).abs(),
        (Command::Radius(a), Command::Radius(b)) => -(b * a.signum()),
        (Command::Centre(a), Command::Centre(b)) => plane::length(a - b),
        _ => f64::INFINITY,
    };
    candidates.retain(|other| {
        mode.centre(machine, *other)
            .is_ok_and(|centre| obstacle(machine, limits, &centre).is_none())
    });
    let nearest = candidates
        .into_iter()
        .min_by(|a, b| distance(a).total_cmp(&distance(b)));
    Ok(Reach::Unreachable { group, needs, nearest })
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
        .filter(move |angle| angle.abs() <= half + SAME)
}

/// Nearest points of, and crossings between, the axle lines at the ends of the ranges.
fn points(machine: &Machine<f64>, limits: &[Limits], command: Command<f64>) -> Vec<Point<f64>> {
    let Command::Centre(wanted) = command else {
        return Vec::new();
    };
    let lines: Vec<(Point<f64>, Point<f64>)> = ends(limits)
        .map(|(i, end)| {
            let (sin, cos) = Calc::sin_cos(end);
            (machine.groups[i], Point::new(-sin, cos))
        })
        .collect();
    let mut found = Vec::new();
    for (i, &(p, along)) in lines.iter().enumerate() {
        found.push(p + along * plane::dot(wanted - p, along));
        for &(q, other) in &lines[..i] {
            let sine = plane::cross(along, other);
            if sine.abs() > SAME {
                found.push(p + along * (plane::cross(q - p, other) / sine));
            }
        }
    }
    found
}

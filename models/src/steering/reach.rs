//! Whether the groups can follow a command, and the nearest one that they can. No allocation.

use crate::calc::Calc;
use crate::number::short;
use crate::plane::{self, Point};
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
        /// As [`nearest`].
        nearest: Option<(Mode, Command<f64>)>,
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
            Some((Mode::Crab, Command::Angle(theta))) => {
                format!(
                    "the nearest direction of travel is the mode crab at {} deg",
                    degrees(*theta)
                )
            }
            Some((_, Command::Angle(theta))) => {
                format!("the nearest angle of the base group is {} deg", degrees(*theta))
            }
            Some((_, Command::Radius(radius))) => format!("the nearest radius is {} m", short(*radius)),
            Some((mode, Command::Centre(at))) => format!(
                "the nearest turning centre is ({}, {}) m in the mode {}",
                short(at.x),
                short(at.y),
                mode.id()
            ),
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

/// Angles of the groups about a centre, in rad, as [`place`](crate::steering::wheels::place) has them.
pub fn stand(machine: &Machine<f64>, limits: &[Limits], centre: &Centre<f64>, angles: &mut [f64]) {
    for ((p, limits), slot) in machine.groups.iter().zip(limits).zip(angles) {
        let along = centre.rolling(*p);
        *slot = match (along.x == 0.0 && along.y == 0.0, principal(along)) {
            (true, _) => 0.0,
            (_, theta) if limits.allows(theta) => theta,
            (_, theta) => limits.equivalents(theta).next().unwrap_or(theta),
        };
    }
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
    Ok(match obstacle(machine, limits, &centre) {
        None => Reach::Reachable,
        Some((group, needs)) => Reach::Unreachable {
            group,
            needs,
            nearest: nearest(machine, limits, mode, command),
        },
    })
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

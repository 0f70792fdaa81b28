//! How the groups stand about a turning centre, within their ranges. No allocation but that of [`stand`].

use crate::kernel::calc::Calc;
use crate::parts::plane::Point;
use crate::steering::centre::Centre;
use crate::steering::limits::Limits;
use crate::steering::machine::Machine;

/// The first group that cannot put its axle line through the centre, and the angle it would need.
pub fn obstacle(machine: &Machine<f64>, limits: &[Limits], centre: &Centre<f64>) -> Option<(usize, f64)> {
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
pub fn principal(along: Point<f64>) -> f64 {
    let backwards = along.x < 0.0 || (along.x == 0.0 && along.y < 0.0);
    let along = if backwards { -along } else { along };
    f64::direction(along.x, along.y)
}

/// Angle of a group about a centre, in rad, as [`Wheel`](crate::steering::wheels::Wheel) has it.
#[must_use]
pub fn stands(centre: &Centre<f64>, p: Point<f64>, limits: &Limits) -> f64 {
    let along = centre.rolling(p);
    match (along.x == 0.0 && along.y == 0.0, principal(along)) {
        (true, _) => 0.0,
        (_, theta) if limits.allows(theta) => theta,
        (_, theta) => limits.equivalents(theta).next().unwrap_or(theta),
    }
}

/// Angles of all groups about a centre, in rad.
#[must_use]
pub fn stand(machine: &Machine<f64>, limits: &[Limits], centre: &Centre<f64>) -> Vec<f64> {
    let groups = machine.groups.iter().zip(limits);
    groups.map(|(p, limits)| stands(centre, *p, limits)).collect()
}

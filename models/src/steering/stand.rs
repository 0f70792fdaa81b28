//! How the groups stand about a turning centre, within their ranges. No allocation but that of [`stand`].

use crate::kernel::calc::Calc;
use crate::parts::plane::Point;
use crate::steering::centre::Centre;
use crate::steering::limits::Limits;
use crate::steering::machine::Machine;
use crate::steering::wheels::{Rolling, Wheel};

/// The first group that cannot put its axle line through the centre, and the angle it would need.
pub fn obstacle(machine: &Machine<f64>, limits: &[Limits], centre: &Centre<f64>) -> Option<(usize, f64)> {
    let groups = machine.groups.iter().zip(limits);
    let mut wheels = groups.map(|(p, limits)| wheel(centre, *p, limits)).enumerate();
    wheels.find_map(|(i, wheel)| (!wheel.placed).then_some((i, wheel.theta)))
}

/// Direction of an axle line's normal, in (−π/2, π/2].
pub fn principal(along: Point<f64>) -> f64 {
    let backwards = along.x < 0.0 || (along.x == 0.0 && along.y < 0.0);
    let along = if backwards { -along } else { along };
    f64::direction(along.x, along.y)
}

fn wheel(centre: &Centre<f64>, p: Point<f64>, limits: &Limits) -> Wheel<f64> {
    Wheel::new(&Rolling::about(centre, p), limits)
}

/// Angle of a group about a centre, in rad.
#[must_use]
pub fn stands(centre: &Centre<f64>, p: Point<f64>, limits: &Limits) -> f64 {
    wheel(centre, p, limits).theta
}

/// Angles of all groups about a centre, in rad.
#[must_use]
pub fn stand(machine: &Machine<f64>, limits: &[Limits], centre: &Centre<f64>) -> Vec<f64> {
    let groups = machine.groups.iter().zip(limits);
    groups.map(|(p, limits)| stands(centre, *p, limits)).collect()
}

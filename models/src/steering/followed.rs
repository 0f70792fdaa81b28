//! The nearest command as its inputs' values and the groups' headings. No allocation.

use crate::component::stages::results;
use crate::steering::centre::Centre;
use crate::steering::limits::Limits;
use crate::steering::machine::Axis;
use crate::steering::mode::{Command, Wanted};
use crate::steering::nearest::Nearest;
use crate::steering::stand::stands;
use crate::steering::symbols as s;

/// The nearest command as values of the inputs; a kind of command that the mode does not take is the one given.
#[derive(Clone, Copy, Debug)]
pub struct Followed<C> {
    theta_b: C,
    r_t: C,
    wanted: Wanted<C>,
}
results! { Followed as f => {
    THETA_BN: f.theta_b;
    R_TN: f.r_t;
    X_C_N: f.wanted.x;
    Y_C_N: f.wanted.y;
} }

impl Followed<f64> {
    pub fn new(nearest: &Nearest, theta_b: &f64, r_t: &f64, wanted: &Wanted<f64>) -> Followed<f64> {
        let mut followed = Followed {
            theta_b: *theta_b,
            r_t: *r_t,
            wanted: *wanted,
        };
        match nearest.found {
            Some((_, Command::Angle(theta))) => followed.theta_b = theta,
            Some((_, Command::Radius(radius))) => followed.r_t = radius,
            Some((_, Command::Centre(at))) => followed.wanted = Wanted { x: at.x, y: at.y },
            _ => {}
        }
        followed
    }
}

/// Heading of a group with the nearest command, in rad; straight ahead where there is none.
#[must_use]
pub fn heading(nearest: &Nearest, axis: &Axis<f64>, limits: &Limits) -> f64 {
    let stands = |centre: &Centre<f64>| stands(centre, axis.point(), limits);
    nearest.centre.as_ref().map_or(0.0, stands)
}

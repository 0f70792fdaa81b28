//! Where the double link in motion begins.

use crate::component::moving::MovingComponent;
use crate::kernel::variable::Fault;
use crate::luffing::double_link::moving::scene::MovingLink;
use crate::luffing::double_link::stages::{DoubleLink, Given};
use crate::luffing::moving::start;
use crate::parts::motion::Motion;

/// As [`start::starting`].
///
/// # Errors
/// As there.
pub fn starting(given: Given<f64>, motion: Motion, moving: &MovingLink, theta: f64) -> Result<MovingComponent, Fault> {
    let given = Given {
        inertias: Some(moving.inertias),
        ..given
    };
    start::starting::<DoubleLink>(&given, motion, moving, theta)
}

//! The boom as the drive sees it, and the moment that it needs.

use crate::balance::symbols::PHI;
use crate::component::stages::Found;
use crate::drive::crank::{self, CrankRod};
use crate::drive::line::{Drive, Reaction};
use crate::drive::mount::{DriveMount, DrivenBar};
use crate::drive::way::{DriveWay, TurnedLink};
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::luffing::curved_trunk::pins::TrunkPins;
use crate::luffing::curved_trunk::position::TrunkPosition;
use crate::luffing::curved_trunk::tail::{Trunk, TrunkChoice};
use crate::parts::four_bar::FourBar;
use crate::parts::plane::Point;

pub fn bar<C: Calc>(position: &TrunkPosition<C>, trunk: &Trunk<C>, phi: &One<C>) -> DrivenBar<C> {
    DrivenBar {
        angle: *phi,
        along: position.b,
        length: trunk.b,
        foot: None,
    }
}

/// The same by the boom's length to B (m) and its angle (rad) alone.
pub fn boom<C: Calc>(b: C, phi: C) -> DrivenBar<C> {
    let (sin, cos) = phi.sin_cos();
    DrivenBar {
        angle: One(&PHI, phi),
        along: Point::new(b * cos, b * sin),
        length: b,
        foot: None,
    }
}

/// The drive's way by the boom's angle.
pub fn way<C: Calc>(
    mount: &DriveMount<C>,
    rod: &Option<CrankRod<C>>,
    crank: Option<&FourBar<C>>,
    trunk: &Trunk<C>,
) -> DriveWay<C> {
    let link = TurnedLink {
        length: trunk.b,
        foot: None,
        against: false,
    };
    DriveWay::new(link, mount, rod, crank)
}

/// # Errors
/// A rod that reaches the boom at no angle.
pub fn crank<C: Calc>(rod: &CrankRod<C>, mount: &DriveMount<C>, choice: &TrunkChoice) -> Found<FourBar<C>> {
    crank::crank(rod, mount, None, choice.crank)
}

/// The force that gives the moment.
pub fn push<C: Calc>(drive: &Drive<C>, pins: &TrunkPins<C>) -> Reaction<C> {
    Reaction::new(drive, pins.m_d)
}

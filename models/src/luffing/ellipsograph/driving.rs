//! The link as the drive sees it: it turns the other way than the boom.

use crate::component::stages::Found;
use crate::drive::crank::{self, CrankRod};
use crate::drive::line::{self, Drive, Reaction};
use crate::drive::mount::{DriveMount, DrivenBar};
use crate::drive::way::{DriveWay, TurnedLink};
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::luffing::ellipsograph::position::{Bars, GuidedChoice, GuidedPosition};
use crate::luffing::ellipsograph::symbols as s;
use crate::luffing::ellipsograph::velocity::GuidedSpeeds;
use crate::parts::four_bar::FourBar;
use crate::parts::plane::Point;

pub fn bar<C: Calc>(position: &GuidedPosition<C>, bars: &Bars<C>) -> DrivenBar<C> {
    DrivenBar {
        angle: One(&s::THETA_L, position.theta_l),
        along: position.c,
        length: bars.c,
        foot: None,
    }
}

/// The same by the link's length (m) and the boom's angle (rad) alone.
pub fn link<C: Calc>(c: C, phi: C) -> DrivenBar<C> {
    let (sin, cos) = phi.sin_cos();
    DrivenBar {
        angle: One(&s::THETA_L, -phi),
        along: Point::new(c * cos, -(c * sin)),
        length: c,
        foot: None,
    }
}

/// The drive's way by the boom's angle.
pub fn way<C: Calc>(
    mount: &DriveMount<C>,
    rod: &Option<CrankRod<C>>,
    crank: Option<&FourBar<C>>,
    bars: &Bars<C>,
) -> DriveWay<C> {
    let link = TurnedLink {
        length: bars.c,
        foot: None,
        against: true,
    };
    DriveWay::new(link, mount, rod, crank)
}

/// # Errors
/// A rod that reaches the link at no angle.
pub fn crank<C: Calc>(rod: &CrankRod<C>, mount: &DriveMount<C>, choice: &GuidedChoice) -> Found<FourBar<C>> {
    crank::crank(rod, mount, None, choice.crank)
}

/// Speed of the drive, in m/s, lengthening positive.
pub fn stroke<C: Calc>(drive: &Drive<C>, speeds: &GuidedSpeeds<C>) -> C {
    line::speed(drive, &speeds.link)
}

/// The force that gives the moment for the boom's angle.
pub fn push<C: Calc>(drive: &Drive<C>, needed: &C) -> Reaction<C> {
    Reaction::new(drive, -*needed)
}

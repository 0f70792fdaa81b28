//! Boom or rocker as the drive sees it, and the moment that it needs.

use crate::component::stages::Found;
use crate::drive::crank::{self, CrankRod};
use crate::drive::line::{Drive, Reaction};
use crate::drive::mount::{DriveMount, DrivenBar};
use crate::drive::way::{DriveWay, TurnedLink};
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::luffing::double_link::held::Held;
use crate::luffing::double_link::parameters::{Choice, Driven, Lengths};
use crate::luffing::double_link::position::Position;
use crate::parts::four_bar::FourBar;
use crate::parts::plane::Point;

/// Foot of the driving link, in m; `None` where that is the origin.
pub fn foot<C: Calc>(l: &Lengths<C>, driven: Driven) -> Option<Point<C>> {
    match driven {
        Driven::Boom => None,
        Driven::Rocker => Some(l.o3()),
    }
}

/// The driving link at an angle of it.
pub fn bar<C: Calc>(p: &Position<C>, l: &Lengths<C>, theta: &One<C>) -> DrivenBar<C> {
    let (along, length) = match p.driven {
        Driven::Boom => (p.x_1, l.x_1),
        Driven::Rocker => (p.x_3, l.x_3),
    };
    DrivenBar {
        angle: *theta,
        along,
        length,
        foot: foot(l, p.driven),
    }
}

/// The drive's way by the driving link's angle.
pub fn way<C: Calc>(
    mount: &DriveMount<C>,
    rod: &Option<CrankRod<C>>,
    crank: Option<&FourBar<C>>,
    l: &Lengths<C>,
    choice: &Choice,
) -> DriveWay<C> {
    let length = match choice.driven {
        Driven::Boom => l.x_1,
        Driven::Rocker => l.x_3,
    };
    let link = TurnedLink {
        length,
        foot: foot(l, choice.driven),
        against: false,
    };
    DriveWay::new(link, mount, rod, crank)
}

/// # Errors
/// A rod that reaches the driving link at no angle.
pub fn crank<C: Calc>(rod: &CrankRod<C>, mount: &DriveMount<C>, l: &Lengths<C>, choice: &Choice) -> Found<FourBar<C>> {
    crank::crank(rod, mount, foot(l, choice.driven), choice.crank)
}

/// The force that gives what the driving link needs.
pub fn push<C: Calc>(drive: &Drive<C>, held: &Held<C>) -> Reaction<C> {
    Reaction::new(drive, held.m_d)
}

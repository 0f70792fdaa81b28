//! The driving link, and where a drive takes hold of it and of the frame.

use crate::component::stages::{Found, absent};
use crate::drive::sector::Sector;
use crate::drive::symbols as s;
use crate::kernel::group::{One, either, quantities};
use crate::parts::plane::Point;

quantities! {
    /// Anchors of a drive that pushes along a line from the frame to the driving link.
    Anchors { e_x: E_X, e_y: E_Y, s_d: S_D, chi_d: CHI_D }
}

quantities! {
    /// Bore and rod of a luffing cylinder, in m.
    Bore { d_c: D_C, d_r: D_R }
}

/// Where a drive takes hold of the driving link: along a line, or by a toothed sector.
#[derive(Clone, Copy, Debug)]
pub enum DriveMount<C> {
    Anchors(Anchors<C>),
    Sector(Sector<C>),
}
either!(DriveMount { Anchors, Sector });

impl<C: Copy> DriveMount<C> {
    /// The anchors of a drive along a line.
    #[must_use]
    pub fn line(&self) -> Option<Anchors<C>> {
        self.anchors().ok().copied()
    }
}

impl<C> DriveMount<C> {
    /// Of all but a sector.
    pub(super) fn anchors(&self) -> Found<&Anchors<C>> {
        match self {
            DriveMount::Anchors(anchors) => Ok(anchors),
            DriveMount::Sector(_) => Err(absent()),
        }
    }
}

/// The driving link, which turns about a foot on the frame: what a mechanism tells its drive at one position.
#[derive(Clone, Copy, Debug)]
pub struct DrivenBar<C> {
    /// Its angle, in rad, by its name.
    pub angle: One<C>,
    /// From its foot to its head, and how long it is, in m.
    pub along: Point<C>,
    pub length: C,
    /// In m from the origin; `None` where its foot is that.
    pub foot: Option<Point<C>>,
}

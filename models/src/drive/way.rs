//! The way of a drive by the angle of its link alone, over any scalar, with the derivatives that what turns with it asks for.

use num_dual::{Dual2, DualNum};

use crate::drive::crank::CrankRod;
use crate::drive::line::Drive;
use crate::drive::mount::{DriveMount, DrivenBar};
use crate::drive::symbols as s;
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::parts::four_bar::FourBar;
use crate::parts::plane::Point;

/// A link on its foot, which turns as the coordinate of a mechanism does or against it.
#[derive(Clone, Copy, Debug)]
pub struct TurnedLink<C> {
    /// In m.
    pub length: C,
    /// In m from the origin; `None` where it is that.
    pub foot: Option<Point<C>>,
    pub against: bool,
}

/// A drive on its link.
#[derive(Clone, Copy, Debug)]
pub struct DriveWay<C> {
    link: TurnedLink<C>,
    mount: DriveMount<C>,
    crank: Option<(CrankRod<C>, FourBar<C>)>,
}

impl<C: Calc> DriveWay<C> {
    pub fn new(
        link: TurnedLink<C>,
        mount: &DriveMount<C>,
        rod: &Option<CrankRod<C>>,
        crank: Option<&FourBar<C>>,
    ) -> DriveWay<C> {
        DriveWay {
            link,
            mount: *mount,
            crank: rod.zip(crank.copied()),
        }
    }

    /// The same over another scalar.
    #[must_use]
    pub fn map<D: Calc>(&self, f: fn(C) -> D) -> DriveWay<D> {
        let TurnedLink { length, foot, against } = self.link;
        let crank = |(rod, linkage): (CrankRod<C>, FourBar<C>)| (rod.map(&mut |_, x| f(x)), linkage.map(f));
        DriveWay {
            link: TurnedLink {
                length: f(length),
                foot: foot.map(|foot| foot.map(f)),
                against,
            },
            mount: self.mount.map(&mut |_, x| f(x)),
            crank: self.crank.map(crank),
        }
    }

    /// Its way (m) at a coordinate (rad), whose rate a motor gives: its length, of a sector that of its teeth, of a crank that
    /// of its pin; `None` where a crank does not meet the link.
    pub fn at(&self, coordinate: C) -> Option<C> {
        let TurnedLink { length, foot, against } = self.link;
        let angle = if against { -coordinate } else { coordinate };
        Some(match (&self.mount, &self.crank) {
            (DriveMount::Anchors(a), Some((rod, linkage))) => rod.r_cr * rod.at(linkage, angle + a.chi_d)?.angle(),
            (DriveMount::Anchors(a), None) => {
                let (sin, cos) = angle.sin_cos();
                let bar = DrivenBar {
                    angle: One(&s::PHI_D, angle),
                    along: Point::new(length * cos, length * sin),
                    length,
                    foot,
                };
                Drive::new(&bar, a).l_d
            }
            (DriveMount::Sector(sector), _) => sector.r_s * angle,
        })
    }
}

impl<T: Calc + DualNum> DriveWay<Dual2<T>> {
    /// What it gains for one radian of the coordinate (rad), and how that changes, in m.
    pub fn travel(&self, coordinate: T) -> Option<[T; 2]> {
        let way = self.at(Dual2::new(coordinate, T::constant(1.0), T::constant(0.0)))?;
        Some([way.v1, way.v2])
    }
}

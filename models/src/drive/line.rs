//! The line along which a drive pushes: a cylinder, a rack or a screw from an anchor on the frame to an anchor on the driving
//! link, a pinion on the frame in a toothed sector of that link, or the rod of a crank on the frame.

use crate::component::stages::{Found, results};
use crate::drive::crank::{CrankRod, Cranked};
use crate::drive::gear::Gear;
use crate::drive::mount::{Anchors, Bore, DriveMount, DrivenBar};
use crate::drive::shaft::{Gearing, Shaft};
use crate::drive::symbols as s;
use crate::kernel::calc::{Calc, Over};
use crate::kernel::symbol::Symbol;
use crate::parts::hydraulics::cylinder;
use crate::parts::plane::{self, Point};

/// The drive at one position.
#[derive(Clone, Copy, Debug)]
pub struct Drive<C> {
    /// From the anchor on the frame, or from the crank, to the one on the driving link, in m; of a sector one metre along its
    /// teeth.
    line: Point<C>,
    /// Length of that, in m.
    pub l_d: C,
    /// Lever arm about the foot of the driving link, in m; positive where a push
    /// turns it counter-clockwise. The derivative of the length by the angle.
    pub h_d: C,
}
results! { Drive as d => { L_D: d.l_d; H_D: d.h_d; } }

/// Force of the drive on the driving link.
#[derive(Clone, Copy, Debug)]
pub struct Reaction<C> {
    /// Moment that the link needs, in N·m; positive turns it counter-clockwise.
    moment: C,
    /// Push positive, in N.
    pub f_d: C,
    /// `None` where no force gives the moment.
    pub force: Option<Point<C>>,
}
results! { Reaction as f => { F_D: f.f_d; } }

impl<C: Calc> Drive<C> {
    pub fn of(
        bar: &DrivenBar<C>,
        mount: &DriveMount<C>,
        rod: &Option<CrankRod<C>>,
        cranked: Option<&Cranked<C>>,
    ) -> Drive<C> {
        match (mount, rod.as_ref().zip(cranked)) {
            (DriveMount::Anchors(_), Some((rod, Cranked { arm, line, .. }))) => Drive {
                line: *line,
                l_d: rod.l_cr,
                h_d: (plane::cross(*arm, *line) / rod.l_cr).def(&s::H_D),
            },
            (DriveMount::Anchors(a), None) => Drive::new(bar, a),
            (DriveMount::Sector(sector), _) => Drive {
                line: sector.along(),
                l_d: C::constant(1.0),
                h_d: sector.r_s.def(&s::H_D),
            },
        }
    }

    /// Along a line.
    pub fn new(bar: &DrivenBar<C>, a: &Anchors<C>) -> Drive<C> {
        let (sin, cos) = a.chi_d.sin_cos();
        let arm = plane::turned(bar.along, a.s_d * cos / bar.length, a.s_d * sin / bar.length);
        let arm = plane::def(arm, [&s::R_DX, &s::R_DY]);
        let anchor = bar.foot.map_or(arm, |foot| foot + arm);
        let line = plane::def(anchor - Point::new(a.e_x, a.e_y), [&s::L_DX, &s::L_DY]);
        let l_d = plane::length(line).def(&s::L_D);
        let h_d = (plane::cross(arm, line) / l_d).def(&s::H_D);
        Drive { line, l_d, h_d }
    }

    /// The force, in N and named `symbol`, that gives a moment (N·m) about the foot. Where the drive points
    /// at the foot no force does: it is infinite there, but nothing where no moment is asked for.
    pub fn force(&self, moment: C, symbol: &'static Symbol) -> C {
        force(moment, [self.l_d, self.h_d], symbol)
    }

    /// A force (N) on the driving link; none that is not finite.
    pub fn along(&self, force: C) -> Option<Point<C>> {
        let along = |line: C| force * line / self.l_d;
        (force.value().is_finite()).then(|| Point::new(along(self.line.x), along(self.line.y)))
    }
}

/// Length (m) and lever arm (m) of a drive along a line on a driving link that is given over another scalar.
pub fn drawn<P: Calc, C: Over<P>>(bar: &DrivenBar<C>, anchors: &Anchors<P>) -> [C; 2] {
    let Drive { l_d, h_d, .. } = Drive::new(bar, &anchors.map(&mut |_, x| C::of(x)));
    [l_d, h_d]
}

/// [`Drive::force`] for a drive of a length (m) and a lever arm (m).
pub fn force<C: Calc>(moment: C, [l_d, h_d]: [C; 2], symbol: &'static Symbol) -> C {
    if h_d.value().abs() > 4.0 * f64::EPSILON * l_d.value() {
        return (moment / h_d).def(symbol);
    }
    C::constant(match moment.value() {
        0.0 => 0.0,
        moment => f64::INFINITY.copysign(moment),
    })
}

impl<C: Calc> Reaction<C> {
    /// The force that gives the moment (N·m) that the driving link needs.
    pub fn new(drive: &Drive<C>, moment: C) -> Reaction<C> {
        let f_d = drive.force(moment, &s::F_D);
        Reaction {
            moment,
            f_d,
            force: drive.along(f_d),
        }
    }
}

/// Its shaft under the force that it gives.
pub fn shaft<C: Calc>(gearing: &Gearing<C>, push: &Reaction<C>, speed: &C, cranked: Option<&Cranked<C>>) -> Shaft<C> {
    match cranked {
        Some(cranked) => Shaft::new(&gearing.times(cranked.h_cr), push.f_d, *speed),
        None => Shaft::new(gearing, push.f_d, *speed),
    }
}

/// Torque of a crank without friction, in N·m, by the textbook's form.
pub fn by_slider<C: Calc>(
    cranked: &Cranked<C>,
    rod: &CrankRod<C>,
    mount: &DriveMount<C>,
    needed: &Reaction<C>,
) -> Found<C> {
    let a = mount.anchors()?;
    let push = force(needed.moment / a.s_d, [C::constant(1.0), cranked.across()], &s::F_CR);
    Ok(match push.value().is_finite() {
        true => cranked.by_slider(rod, push),
        false => push,
    })
}

/// Speed of the drive, in m/s, lengthening positive, at the driving link's angular velocity (rad/s).
pub fn speed<C: Calc>(drive: &Drive<C>, omega: &C) -> C {
    (drive.h_d * *omega).def(&s::V_D)
}

/// Oil flow to the cylinder, in m³/s, at its speed (m/s); negative where it shortens.
pub fn flow<C: Calc>(c: &Bore<C>, speed: &C) -> C {
    cylinder::flow([c.d_c, c.d_r], *speed, [&s::A_D, &s::Q_D])
}

/// Whether a drive that takes hold there, with or without a crank, has a result.
#[must_use]
pub fn has(mount: Option<&DriveMount<f64>>, crank: bool, gear: Option<&Gear<f64>>, result: &'static Symbol) -> bool {
    let along_teeth = matches!(mount, Some(DriveMount::Sector(_)));
    (result != &s::F_D || mount.is_some())
        && (result != &s::L_D || !crank && !along_teeth)
        && gear.is_none_or(|gear| gear.has(result))
}

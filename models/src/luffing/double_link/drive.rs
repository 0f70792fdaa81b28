//! The drive: a cylinder, a rack or a screw that pushes along a line from an anchor on the frame to an anchor on the driving
//! link, or a pinion on the frame in a toothed sector of that link.

use crate::component::stages::results;
use crate::drive::shaft::{Gearing, Shaft};
use crate::kernel::calc::Calc;
use crate::kernel::symbol::Symbol;
use crate::luffing::double_link::held::Held;
use crate::luffing::double_link::parameters::{Anchors, Bore, DriveMount, Driven, Lengths};
use crate::luffing::double_link::position::Position;
use crate::luffing::double_link::symbols as s;
use crate::parts::hydraulics::cylinder;
use crate::parts::plane::{self, Point};

/// The drive at one position.
#[derive(Clone, Copy, Debug)]
pub struct Drive<C> {
    /// From the anchor on the frame to the one on the driving link, in m; of a sector one metre along its teeth.
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
    /// Push positive, in N.
    pub f_d: C,
    /// `None` where no force gives the moment.
    pub force: Option<Point<C>>,
}
results! { Reaction as f => { F_D: f.f_d; } }

impl<C: Calc> Drive<C> {
    pub fn of(p: &Position<C>, l: &Lengths<C>, mount: &DriveMount<C>) -> Drive<C> {
        match mount {
            DriveMount::Anchors(a) => Drive::new(p, l, a),
            DriveMount::Sector(sector) => Drive {
                line: sector.along(),
                l_d: C::constant(1.0),
                h_d: sector.r_s.def(&s::H_D),
            },
        }
    }

    /// Along a line.
    pub fn new(p: &Position<C>, l: &Lengths<C>, a: &Anchors<C>) -> Drive<C> {
        let (sin, cos) = a.chi_d.sin_cos();
        let (direction, bar) = match p.driven {
            Driven::Boom => (p.x_1, l.x_1),
            Driven::Rocker => (p.x_3, l.x_3),
        };
        let arm = plane::def(
            plane::turned(direction, a.s_d * cos / bar, a.s_d * sin / bar),
            [&s::R_DX, &s::R_DY],
        );
        let frame = Point::new(a.e_x, a.e_y);
        let line = match p.driven {
            Driven::Boom => arm - frame,
            Driven::Rocker => l.o3() + arm - frame,
        };
        let line = plane::def(line, [&s::L_DX, &s::L_DY]);
        let l_d = plane::length(line).def(&s::L_D);
        let h_d = (plane::cross(arm, line) / l_d).def(&s::H_D);
        Drive { line, l_d, h_d }
    }

    /// The force, in N and named `symbol`, that gives the moment `m_d` (N·m) about the foot. Where the drive points
    /// at the foot no force does: it is infinite there, but nothing where no moment is asked for.
    pub fn force(&self, m_d: C, symbol: &'static Symbol) -> C {
        force(m_d, [self.l_d, self.h_d], symbol)
    }
}

/// The same for a drive of a length (m) and a lever arm (m).
pub fn force<C: Calc>(m_d: C, [l_d, h_d]: [C; 2], symbol: &'static Symbol) -> C {
    if h_d.value().abs() > 4.0 * f64::EPSILON * l_d.value() {
        return (m_d / h_d).def(symbol);
    }
    C::constant(match m_d.value() {
        0.0 => 0.0,
        moment => f64::INFINITY.copysign(moment),
    })
}

impl<C: Calc> Reaction<C> {
    /// The force that gives the moment that the driving link needs.
    pub fn new(drive: &Drive<C>, held: &Held<C>) -> Reaction<C> {
        let f_d = drive.force(held.m_d, &s::F_D);
        let along = |line: C| f_d * line / drive.l_d;
        Reaction {
            f_d,
            force: (f_d.value().is_finite()).then(|| Point::new(along(drive.line.x), along(drive.line.y))),
        }
    }
}

/// Its shaft under the force that it gives.
pub fn shaft<C: Calc>(gearing: &Gearing<C>, push: &Reaction<C>, speed: &C) -> Shaft<C> {
    Shaft::new(gearing, push.f_d, *speed)
}

/// Speed of the drive, in m/s, lengthening positive, at the driving link's angular velocity (rad/s).
pub fn speed<C: Calc>(drive: &Drive<C>, omega: &C) -> C {
    (drive.h_d * *omega).def(&s::V_D)
}

/// Oil flow to the cylinder, in m³/s, at its speed (m/s); negative where it shortens.
pub fn flow<C: Calc>(c: &Bore<C>, speed: &C) -> C {
    cylinder::flow([c.d_c, c.d_r], *speed, [&s::A_D, &s::Q_D])
}

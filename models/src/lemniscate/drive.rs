//! The drive: a cylinder or a rack that pushes along a line from an anchor on
//! the frame to an anchor on the driven bar.

use crate::calc::Calc;
use crate::lemniscate::geometry::{Anchors, Cylinder, Driven};
use crate::lemniscate::position::Position;
use crate::lemniscate::symbols as s;
use crate::plane::{self, Point};
use crate::symbol::Symbol;

/// The drive at one position.
#[derive(Clone, Copy, Debug)]
pub struct Drive<C> {
    /// From the anchor on the frame to the one on the driven bar, in m.
    line: Point<C>,
    /// Length between the anchors, in m.
    pub l_d: C,
    /// Lever arm about the foot of the driven bar, in m; positive where a push
    /// turns it counter-clockwise. The derivative of the length by the angle.
    pub h_d: C,
}

/// Force of the drive on the driven bar.
#[derive(Clone, Copy, Debug)]
pub struct Reaction<C> {
    /// Push positive, in N.
    pub f_d: C,
    /// `None` where no force gives the moment.
    pub force: Option<Point<C>>,
}

impl<C: Calc> Drive<C> {
    /// `bar` is the length of the driven bar; `o3` the foot of the rocker.
    pub fn new(p: &Position<C>, bar: C, o3: Point<C>, a: &Anchors<C>) -> Drive<C> {
        let (sin, cos) = a.chi_d.sin_cos();
        let direction = match p.driven {
            Driven::Boom => p.x_1,
            Driven::Rocker => p.x_3,
        };
        let arm = plane::def(
            plane::turned(direction, a.s_d * cos / bar, a.s_d * sin / bar),
            [&s::R_DX, &s::R_DY],
        );
        let frame = Point::new(a.e_x, a.e_y);
        let line = match p.driven {
            Driven::Boom => arm - frame,
            Driven::Rocker => o3 + arm - frame,
        };
        let line = plane::def(line, [&s::L_DX, &s::L_DY]);
        let l_d = plane::length(line).def(&s::L_D);
        let h_d = (plane::cross(arm, line) / l_d).def(&s::H_D);
        Drive { line, l_d, h_d }
    }

    /// The force, in N and named `symbol`, that gives the moment `m_d` (N·m) about the foot. Where the drive points
    /// at the foot no force does: it is infinite there, but nothing where no moment is asked for.
    pub fn force(&self, m_d: C, symbol: &'static Symbol) -> C {
        if self.h_d.value().abs() > 4.0 * f64::EPSILON * self.l_d.value() {
            return (m_d / self.h_d).def(symbol);
        }
        C::constant(match m_d.value() {
            0.0 => 0.0,
            moment => f64::INFINITY.copysign(moment),
        })
    }

    /// The force that gives the moment `m_d` (N·m), as the driven bar feels it.
    pub fn reaction(&self, m_d: C) -> Reaction<C> {
        let f_d = self.force(m_d, &s::F_D);
        let along = |line: C| f_d * line / self.l_d;
        Reaction {
            f_d,
            force: (f_d.value().is_finite()).then(|| Point::new(along(self.line.x), along(self.line.y))),
        }
    }

    /// Speed, in m/s, lengthening positive, at the driven bar's angular velocity (rad/s).
    pub fn speed(&self, omega: C) -> C {
        (self.h_d * omega).def(&s::V_D)
    }
}

/// Oil flow to the cylinder, in m³/s, at its speed (m/s); negative where it shortens.
pub fn oil_flow<C: Calc>(c: &Cylinder<C>, speed: C) -> C {
    let quarter = C::constant(std::f64::consts::FRAC_PI_4);
    let area = if speed.value() < 0.0 {
        quarter * (c.d_c.square() - c.d_r.square())
    } else {
        quarter * c.d_c.square()
    };
    (area.def(&s::A_D) * speed).def(&s::Q_D)
}

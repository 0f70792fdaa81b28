//! The drive: a cylinder, a rack or a screw that pushes along a line from an anchor on the frame to an anchor on the driving
//! link, a pinion on the frame in a toothed sector of that link, or the rod of a crank on the frame.

use crate::component::stages::{Found, results};
use crate::drive::crank::{CrankRod, Cranked};
use crate::drive::shaft::{Gearing, Shaft};
use crate::drive::symbols as t;
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::Fault;
use crate::luffing::double_link::held::Held;
use crate::luffing::double_link::parameters::{Anchors, Bore, Choice, DriveMount, Driven, Lengths};
use crate::luffing::double_link::position::Position;
use crate::luffing::double_link::symbols as s;
use crate::parts::four_bar::{Branch, FourBar};
use crate::parts::hydraulics::cylinder;
use crate::parts::motion::degrees;
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
    /// Push positive, in N.
    pub f_d: C,
    /// `None` where no force gives the moment.
    pub force: Option<Point<C>>,
}
results! { Reaction as f => { F_D: f.f_d; } }

impl<C: Calc> Drive<C> {
    pub fn of(
        p: &Position<C>,
        l: &Lengths<C>,
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
            (DriveMount::Anchors(a), None) => Drive::new(p, l, a),
            (DriveMount::Sector(sector), _) => Drive {
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
pub fn shaft<C: Calc>(gearing: &Gearing<C>, push: &Reaction<C>, speed: &C, cranked: Option<&Cranked<C>>) -> Shaft<C> {
    match cranked {
        Some(cranked) => Shaft::new(&gearing.times(cranked.h_cr), push.f_d, *speed),
        None => Shaft::new(gearing, push.f_d, *speed),
    }
}

/// The four-bar of a crank on this side; `None` where it closes at no angle.
pub fn crank_linkage<C: Calc>(
    rod: &CrankRod<C>,
    a: &Anchors<C>,
    l: &Lengths<C>,
    (driven, branch): (Driven, Branch),
) -> Option<FourBar<C>> {
    let centre = Point::new(a.e_x, a.e_y);
    let from_foot = match driven {
        Driven::Boom => centre,
        Driven::Rocker => centre - l.o3(),
    };
    rod.linkage(a.s_d, from_foot, branch)
}

/// The same for the scene's choice.
///
/// # Errors
/// A rod that reaches the driving link at no angle.
pub fn crank<C: Calc>(rod: &CrankRod<C>, mount: &DriveMount<C>, l: &Lengths<C>, choice: &Choice) -> Found<FourBar<C>> {
    let linkage = crank_linkage(rod, mount.anchors()?, l, (choice.driven, choice.crank));
    linkage.ok_or_else(|| Box::new(Fault::outside("the crank's rod meets the driving link at no angle")))
}

/// Crank and rod at a position.
///
/// # Errors
/// An angle at which they do not meet.
pub fn cranked<C: Calc>(
    linkage: &FourBar<C>,
    rod: &CrankRod<C>,
    mount: &DriveMount<C>,
    theta: &One<C>,
) -> Found<Cranked<C>> {
    let a = mount.anchors()?;
    let phi_d = (theta.1 + a.chi_d).def(&t::PHI_D);
    rod.at(linkage, phi_d).ok_or_else(|| {
        let at = format!("{} = {}", theta.0.id, degrees(theta.1.value()));
        let closes = arcs(linkage, a.chi_d.value());
        Box::new(Fault::outside(format!(
            "{at}: crank and rod do not meet there; they do for {closes}"
        )))
    })
}

/// Torque of a crank without friction, in N·m, by the textbook's form.
pub fn by_slider<C: Calc>(cranked: &Cranked<C>, rod: &CrankRod<C>, mount: &DriveMount<C>, held: &Held<C>) -> Found<C> {
    let a = mount.anchors()?;
    let push = force(held.m_d / a.s_d, [C::constant(1.0), cranked.across()], &t::F_CR);
    Ok(match push.value().is_finite() {
        true => cranked.by_slider(rod, push),
        false => push,
    })
}

/// Angles of the driving link at which crank and rod meet, in words.
pub fn arcs<C: Calc>(linkage: &FourBar<C>, chi_d: f64) -> String {
    let arcs = linkage.arcs().into_iter();
    let words: Vec<String> = arcs
        .map(|arc| format!("{} to {}", degrees(arc.from - chi_d), degrees(arc.to - chi_d)))
        .collect();
    words.join(" and for ")
}

/// Speed of the drive, in m/s, lengthening positive, at the driving link's angular velocity (rad/s).
pub fn speed<C: Calc>(drive: &Drive<C>, omega: &C) -> C {
    (drive.h_d * *omega).def(&s::V_D)
}

/// Oil flow to the cylinder, in m³/s, at its speed (m/s); negative where it shortens.
pub fn flow<C: Calc>(c: &Bore<C>, speed: &C) -> C {
    cylinder::flow([c.d_c, c.d_r], *speed, [&s::A_D, &s::Q_D])
}

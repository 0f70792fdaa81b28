//! Where boom, link and foot are.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::{group, quantities};
use crate::luffing::ellipsograph::symbols as s;
use crate::parts::four_bar::Branch;
use crate::parts::motion::Motion;
use crate::parts::plane::{self, Point};

/// What the scene has chosen.
#[derive(Clone, Copy, Debug)]
pub struct GuidedChoice {
    /// Working range of the boom.
    pub range: Motion,
    /// Side of the line from the centre of the drive's crank to its anchor on the link on which crank and rod meet.
    pub crank: Branch,
}
group!(GuidedChoice);

quantities! {
    /// Link and boom.
    Bars { c: C, a: A, x_8: X_8 }
}

/// The mechanism at one angle of the boom.
#[derive(Clone, Copy, Debug)]
pub struct GuidedPosition<C> {
    /// Unit vector along the boom.
    pub along: Point<C>,
    /// Direction of the link, in rad.
    pub theta_l: C,
    /// Joints and head, in m from O1.
    pub c: Point<C>,
    pub b_y: C,
    pub a: Point<C>,
    /// Reach, in m.
    pub r: C,
}
results! { GuidedPosition as p => {
    THETA_L: p.theta_l;
    C_X: p.c.x;
    C_Y: p.c.y;
    B_Y: p.b_y;
    A_X: p.a.x;
    A_Y: p.a.y;
    R: p.r;
} }

/// Half axes of the head's ellipse, in m: c + a, a − c. [Ports001, 5.9.2.3]
pub fn axes<C: Calc>(bars: &Bars<C>) -> Point<C> {
    plane::def(Point::new(bars.c + bars.a, bars.a - bars.c), [&s::E_1, &s::E_2])
}

impl<C: Calc> GuidedPosition<C> {
    /// x_A = e_1 cos φ, y_A = e_2 sin φ. [Ports001, 5.9.2.3]
    pub fn new(bars: &Bars<C>, axes: &Point<C>, phi: &C) -> GuidedPosition<C> {
        let (sin, cos) = phi.sin_cos();
        let c = plane::def(Point::new(bars.c * cos, -(bars.c * sin)), [&s::C_X, &s::C_Y]);
        let a = plane::def(Point::new(axes.x * cos, axes.y * sin), [&s::A_X, &s::A_Y]);
        GuidedPosition {
            along: Point::new(cos, sin),
            theta_l: (-*phi).def(&s::THETA_L),
            c,
            b_y: (C::constant(2.0) * c.y).def(&s::B_Y),
            a,
            r: (a.x + bars.x_8).def(&s::R),
        }
    }
}

/// Instantaneous centre of the boom, in m from O1: on the link's line and on the foot's level. [Ports001, 5.9]
pub fn pole<C: Calc>(position: &GuidedPosition<C>) -> Point<C> {
    plane::def(
        Point::new(C::constant(2.0) * position.c.x, position.b_y),
        [&s::P_X, &s::P_Y],
    )
}

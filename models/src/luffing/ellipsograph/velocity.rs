//! Travel of head and foot, and speeds.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::luffing::ellipsograph::position::GuidedPosition;
use crate::luffing::ellipsograph::symbols as s;
use crate::parts::plane::{self, Point};

/// Travel for one radian of the boom, in m.
#[derive(Clone, Copy, Debug)]
pub struct GuidedTravel<C> {
    /// Of the head A.
    pub a: Point<C>,
    /// Rise of the foot B.
    b_y: C,
}

impl<C: Calc> GuidedTravel<C> {
    /// x′_A = −e_1 sin φ, y′_A = e_2 cos φ. [Ports001, 5.9.2.3]
    pub fn new(axes: &Point<C>, position: &GuidedPosition<C>) -> GuidedTravel<C> {
        let (cos, sin) = (position.along.x, position.along.y);
        let a = Point::new(-(axes.x * sin), axes.y * cos);
        GuidedTravel {
            a: plane::def(a, [&s::DA_X, &s::DA_Y]),
            b_y: (C::constant(-2.0) * position.c.x).def(&s::DB_Y),
        }
    }
}

/// Speeds, in m/s and rad/s.
#[derive(Clone, Copy, Debug)]
pub struct GuidedSpeeds<C> {
    a: Point<C>,
    b: C,
    pub link: C,
}
results! { GuidedSpeeds as v => { V_AX: v.a.x; V_AY: v.a.y; V_B: v.b; OMEGA_L: v.link; } }

impl<C: Calc> GuidedSpeeds<C> {
    /// At the boom's angular velocity, in rad/s.
    pub fn new(travel: &GuidedTravel<C>, omega: &C) -> GuidedSpeeds<C> {
        GuidedSpeeds {
            a: plane::def(travel.a * *omega, [&s::V_AX, &s::V_AY]),
            b: (travel.b_y * *omega).def(&s::V_B),
            link: (-*omega).def(&s::OMEGA_L),
        }
    }
}

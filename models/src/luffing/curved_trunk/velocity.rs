//! Travel of the trunk's head, the instantaneous centre, and speeds.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::luffing::curved_trunk::position::TrunkPosition;
use crate::luffing::curved_trunk::symbols as s;
use crate::parts::plane::{self, Point};

/// For one radian of the boom.
#[derive(Clone, Copy, Debug)]
pub struct TrunkTravel<C> {
    /// Turn of the trunk, in rad.
    pub i_2: C,
    /// Travel of the head A, in m.
    pub a: Point<C>,
}
results! { TrunkTravel as v => { I_2: v.i_2; } }

impl<C: Calc> TrunkTravel<C> {
    /// The tie takes no part of T's motion along it: h_O + i_2 h_t = 0. [Ports001, 5.2.3.3]
    pub fn new(position: &TrunkPosition<C>) -> TrunkTravel<C> {
        let (b, front) = (position.b, position.front);
        let h_o = plane::cross(b, position.tie).def(&s::H_O);
        let i_2 = (-(h_o / position.h_t)).def(&s::I_2);
        let a = Point::new(-(b.y + i_2 * front.y), b.x + i_2 * front.x);
        TrunkTravel {
            i_2,
            a: plane::def(a, [&s::DA_X, &s::DA_Y]),
        }
    }

    /// Whether the trunk does not turn, within rounding: its centre is at infinity.
    pub fn at_infinity(&self) -> bool {
        self.i_2.value().abs() <= 4.0 * f64::EPSILON
    }
}

/// Instantaneous centre of the trunk, in m from O1: where boom and free tie meet. [Ports001, 5.2.3.3]
pub fn pole<C: Calc>(position: &TrunkPosition<C>, travel: &TrunkTravel<C>) -> Point<C> {
    if travel.at_infinity() {
        return position.b.map(|direction| match direction.value() {
            0.0 => C::constant(0.0),
            value => C::constant(f64::INFINITY.copysign(value)),
        });
    }
    plane::def(position.b - position.b / travel.i_2, [&s::P_X, &s::P_Y])
}

/// Speeds, in m/s and rad/s.
#[derive(Clone, Copy, Debug)]
pub struct TrunkSpeeds<C> {
    a: Point<C>,
    trunk: C,
}
results! { TrunkSpeeds as v => { V_AX: v.a.x; V_AY: v.a.y; OMEGA_2: v.trunk; } }

impl<C: Calc> TrunkSpeeds<C> {
    /// At the boom's angular velocity, in rad/s.
    pub fn new(travel: &TrunkTravel<C>, omega: &C) -> TrunkSpeeds<C> {
        TrunkSpeeds {
            a: plane::def(travel.a * *omega, [&s::V_AX, &s::V_AY]),
            trunk: (travel.i_2 * *omega).def(&s::OMEGA_2),
        }
    }
}

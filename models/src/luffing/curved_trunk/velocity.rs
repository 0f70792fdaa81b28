//! Travel of the trunk's head and of its points, how that changes, the instantaneous centre, and speeds.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::luffing::curved_trunk::contact::Contact;
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
        TrunkTravel {
            i_2,
            a: plane::def(moved(b, i_2, front), [&s::DA_X, &s::DA_Y]),
        }
    }

    /// Of a point of the trunk, `from` being its place from B, in m.
    pub fn of_point(&self, position: &TrunkPosition<C>, from: Point<C>) -> Point<C> {
        moved(position.b, self.i_2, from)
    }

    /// Whether the trunk does not turn, within rounding: its centre is at infinity.
    pub fn at_infinity(&self) -> bool {
        self.i_2.value().abs() <= 4.0 * f64::EPSILON
    }
}

/// What a point of the trunk moves by, `from` being its place from B, in m.
fn moved<C: Calc>(b: Point<C>, i_2: C, from: Point<C>) -> Point<C> {
    Point::new(-(b.y + i_2 * from.y), b.x + i_2 * from.x)
}

/// How the trunk's turn changes, for one radian of the boom once more.
#[derive(Clone, Copy, Debug)]
pub struct TrunkBend<C> {
    pub i_2: C,
}

impl<C: Calc> TrunkBend<C> {
    /// The loop twice differentiated, along the free tie, which turns by ψ′_t: i′_2 h_t = b_e + i_2² t_e + f ψ′_t². (derived)
    pub fn new(contact: &Contact<C>, position: &TrunkPosition<C>, travel: &TrunkTravel<C>) -> TrunkBend<C> {
        let (i_2, e) = (travel.i_2, position.tie);
        let b_e = plane::dot(position.b, e).def(&s::B_E);
        let t_e = plane::dot(position.t - position.b, e).def(&s::T_E);
        let psi = (-((b_e + i_2 * t_e) / contact.f)).def(&s::DPSI_T);
        let i_2 = (b_e + i_2.square() * t_e + contact.f * psi.square()) / position.h_t;
        TrunkBend { i_2: i_2.def(&s::DI_2) }
    }

    /// How the travel of a point of the trunk changes, `from` being its place from B, in m.
    pub fn of_point(&self, position: &TrunkPosition<C>, travel: &TrunkTravel<C>, from: Point<C>) -> Point<C> {
        let (square, i_2) = (travel.i_2.square(), self.i_2);
        Point::new(-(i_2 * from.y), i_2 * from.x) - from * square - position.b
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

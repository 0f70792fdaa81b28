//! Travel of head and load, and the speeds of the ropes.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::luffing::moving::symbols::DY_Q;
use crate::luffing::rope::position::{BoomPosition, Falls, Rig, Stretch};
use crate::luffing::rope::symbols as s;
use crate::parts::plane::{self, Point};

/// Travel for one radian of the boom, in m.
#[derive(Clone, Copy, Debug)]
pub struct RopeTravel<C> {
    /// Of the head A.
    pub a: Point<C>,
    /// Rise of the load with the hoist drum at rest.
    pub y_q: C,
}

impl<C: Calc> RopeTravel<C> {
    /// y_Q' = x_A − h_S m_k / m_h. [Ports001, 5.2.3.1]
    pub fn new(rig: &Rig<C>, position: &BoomPosition<C>, stretch: &Stretch<C>) -> RopeTravel<C> {
        let a = plane::def(Point::new(-position.a.y, position.a.x), [&s::DA_X, &s::DA_Y]);
        RopeTravel {
            a,
            y_q: (a.y - stretch.all(stretch.line.arm) / rig.m_h).def(&DY_Q),
        }
    }
}

/// Speeds, in m/s.
#[derive(Clone, Copy, Debug)]
pub struct Speeds<C> {
    a: Point<C>,
    load: C,
    /// Of the luffing rope at its drum, taken in positive.
    pub v_l: C,
}
results! { Speeds as v => { V_AX: v.a.x; V_AY: v.a.y; V_Q: v.load; V_L: v.v_l; } }

impl<C: Calc> Speeds<C> {
    /// At the boom's angular velocity, in rad/s.
    pub fn new(rig: &Rig<C>, travel: &RopeTravel<C>, falls: &Falls<C>, omega: &C) -> Speeds<C> {
        Speeds {
            a: plane::def(travel.a * *omega, [&s::V_AX, &s::V_AY]),
            load: (travel.y_q * *omega).def(&s::V_Q),
            v_l: (rig.m_l * falls.line.arm * *omega).def(&s::V_L),
        }
    }
}

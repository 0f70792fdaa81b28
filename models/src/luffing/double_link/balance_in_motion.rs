//! What a balance does to the boom while the mechanism moves: its counterweight's weight and inertia, by rod or rope.
//! [Newton and Euler]

use crate::balance::symbols as b;
use crate::kernel::calc::Calc;
use crate::luffing::double_link::inertia_forces::weight_and_inertia;
use crate::luffing::double_link::moving::symbols as s;
use crate::luffing::double_link::pose::PosedCounterweight;
use crate::luffing::moving::shares::Instant;
use crate::parts::plane::{self, Point, dot};

/// What the balance does to the boom.
#[derive(Clone, Copy, Debug)]
pub struct BalanceInMotion<C> {
    /// About the boom's foot; positive raises the boom.
    pub moment: C,
    pub on_boom: Point<C>,
    /// Force in rod or rope, and of the frame on pivot, pulley or rail; where there are any.
    pub rod: Option<(C, Point<C>)>,
}

impl<C: Calc> BalanceInMotion<C> {
    /// With gravity in m/s².
    pub fn new(it: &PosedCounterweight<C>, at: &Instant<C>, gravity: C) -> BalanceInMotion<C> {
        let force = weight_and_inertia(it.mass, it.travel, it.reach, at, gravity);
        let force = plane::def(force, [&s::F_5X, &s::F_5Y]);
        // By power: the frame takes no part in it.
        let moment = (dot(force, it.travel[0]) / it.boom).def(&s::M_I5);
        let Some(line) = it.line else {
            return BalanceInMotion {
                moment,
                on_boom: plane::def(force, [&b::F_KX, &b::F_KY]),
                rod: None,
            };
        };
        let n_1 = dot(line.per_force, force).def(&b::N_1);
        let on_boom = plane::def(line.along * n_1, [&b::F_KX, &b::F_KY]);
        let on_pivot = match line.rail {
            Some(up) => on_boom + up * n_1,
            None => on_boom - force,
        };
        BalanceInMotion {
            moment,
            on_boom,
            rod: Some((n_1, plane::def(on_pivot, [&b::F_MX, &b::F_MY]))),
        }
    }
}

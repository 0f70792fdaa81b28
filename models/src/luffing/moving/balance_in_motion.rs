//! What a balance does to the boom while the mechanism moves: its counterweight's weight and inertia, by rod or rope.
//! [Newton and Euler]

use crate::balance::action::RodLine;
use crate::component::stages::{absent, results};
use crate::kernel::calc::Calc;
use crate::kernel::record::Rec;
use crate::kernel::symbol::Symbol;
use crate::luffing::moving::inertia_forces::weight_and_inertia;
use crate::luffing::moving::shares::Instant;
use crate::luffing::resistances::placed::BARS;
use crate::parts::plane::{self, Point, dot};

/// Quantities of balances, at rest and in motion.
mod s {
    pub use crate::balance::symbols::{F_KX, F_KY, F_MX, F_MY, N_1};
    pub use crate::luffing::moving::symbols::{E_1X, E_1Y, F_5X, F_5Y, M_I5, N_5X, N_5Y};
}

/// The counterweight of a balance.
#[derive(Clone, Copy, Debug)]
pub struct PosedCounterweight<C> {
    /// In kg.
    pub mass: C,
    /// Forward of the slewing axis, in m.
    pub reach: C,
    /// Travel (m) for one radian of the driving link, and how it changes.
    pub travel: [Point<C>; 2],
    /// Turning of the boom for one radian of the driving link.
    pub boom: C,
    /// None where it is fixed to the boom.
    pub line: Option<RodLine<C>>,
}

/// What the balance does to the boom.
#[derive(Clone, Copy, Debug)]
pub struct BalanceInMotion<C> {
    /// About the boom's foot; positive raises the boom.
    pub moment: C,
    /// What cancels to it, in N·m.
    pub lift: f64,
    pub on_boom: Point<C>,
    /// Force in rod or rope, and of the frame on pivot, pulley or rail; where there are any.
    pub rod: Option<(C, Point<C>)>,
}

results! { BalanceInMotion as b => {
    N_1: b.rod.ok_or_else(absent)?.0;
    F_KX: b.on_boom.x;
    F_KY: b.on_boom.y;
    F_MX: b.rod.ok_or_else(absent)?.1.x;
    F_MY: b.rod.ok_or_else(absent)?.1.y;
} }

impl<C: Calc> BalanceInMotion<C> {
    /// With gravity in m/s².
    pub fn new(it: &PosedCounterweight<C>, at: &Instant<C>, gravity: C) -> BalanceInMotion<C> {
        let mut force = weight_and_inertia(it.mass, it.travel, it.reach, at, gravity);
        if let Some([push, _]) = at.blown(BARS) {
            force.x += push;
        }
        let force = plane::def(force, [&s::F_5X, &s::F_5Y]);
        // By power: the frame takes no part in it.
        let moment = (dot(force, it.travel[0]) / it.boom).def(&s::M_I5);
        let [push, travel] = [force, it.travel[0]].map(|of| plane::length(of.map(C::value)));
        let lift = push * travel / it.boom.value().abs();
        let Some(line) = it.line else {
            return BalanceInMotion {
                moment,
                lift,
                on_boom: plane::def(force, [&s::F_KX, &s::F_KY]),
                rod: None,
            };
        };
        let n_1 = dot(line.per_force, force).def(&s::N_1);
        let on_boom = plane::def(line.along * n_1, [&s::F_KX, &s::F_KY]);
        let on_pivot = match line.rail {
            Some(up) => on_boom + up * n_1,
            None => on_boom - force,
        };
        BalanceInMotion {
            moment,
            lift,
            on_boom,
            rod: Some((n_1, plane::def(on_pivot, [&s::F_MX, &s::F_MY]))),
        }
    }
}

/// For the book: how a balance carries a force, with its values as the running model has them.
#[must_use]
pub fn named(line: &RodLine<Rec>, values: &RodLine<f64>) -> RodLine<Rec> {
    let named = |of: Point<Rec>, value: Point<f64>, names: [&'static Symbol; 2]| {
        plane::def(Point::new(of.x.rounded_as(value.x), of.y.rounded_as(value.y)), names)
    };
    RodLine {
        per_force: named(line.per_force, values.per_force, [&s::N_5X, &s::N_5Y]),
        along: named(line.along, values.along, [&s::E_1X, &s::E_1Y]),
        rail: line.rail,
    }
}

//! The forces in the pins by equilibrium of each body, and what the drive must give.

use crate::balance::residual::Residual;
use crate::kernel::calc::Calc;
use crate::kernel::symbol::Symbol;
use crate::luffing::double_link::parameters::{Driven, Weights};
use crate::luffing::double_link::position::Position;
use crate::luffing::double_link::statics::Own;
use crate::luffing::double_link::symbols as s;
use crate::luffing::led::pull::{Hauled, LedPull};
use crate::parts::plane::{self, Point};

/// Forces of the bars on the jib, in N, and what the drive must give.
#[derive(Clone, Copy, Debug)]
pub struct PinForces<C> {
    /// Moment that the drive must give to the driving link, in N·m.
    pub m_d: C,
    /// Of the boom on the jib.
    pub b: Point<C>,
    /// Of the rocker on the jib.
    pub c: Point<C>,
}

/// What loads the jib: a force (N), downwards and, where there is any, forward; and its moment about B (N·m), clockwise
/// positive.
#[derive(Clone, Copy, Debug)]
pub struct JibLoad<C> {
    pub down: C,
    pub forward: Option<C>,
    pub about_b: C,
}

/// MomentNames of the jib's moment about B and about C, and of the moment on the driving link.
#[derive(Clone, Copy, Debug)]
pub struct MomentNames {
    pub about: [&'static Symbol; 2],
    pub driven: &'static Symbol,
}

const AT_REST: MomentNames = MomentNames {
    about: [&s::M_B, &s::M_C],
    driven: &s::M_D,
};

impl<C: Calc> PinForces<C> {
    /// At rest, under the load `q`. Without weights, and their centres, the bars are weightless; a balance acts on the
    /// boom, a led rope on all bars.
    pub fn new(
        p: &Position<C>,
        q: &C,
        weights: &Option<Weights<C>>,
        own: Option<&Own<C>>,
        balance: Option<&Residual<C>>,
        pulled: Option<&LedPull<C>>,
    ) -> PinForces<C> {
        let q = *q;
        // Load on the jib, its moment about B, and the moments of boom and
        // rocker weight about their feet: all clockwise positive.
        let (down, about_b, boom, rocker) = match weights.as_ref().zip(own) {
            Some((w, own)) => (
                q + w.g_2,
                q * p.x_4.x + w.g_2 * own.centres.jib.x,
                Some((w.g_1 * own.centres.boom.x).def(&s::M_1)),
                Some((w.g_3 * own.centres.rocker.x).def(&s::M_3)),
            ),
            None => (q, q * p.x_4.x, None, None),
        };
        // What the balance does not carry.
        let boom = match (boom, balance) {
            (Some(boom), Some(balance)) => Some(boom - balance.action.m_b),
            _ => boom,
        };
        let jib = JibLoad {
            down,
            forward: None,
            about_b,
        };
        match pulled {
            None => PinForces::under(p, &jib, [boom, rocker], &AT_REST),
            Some(pulled) => PinForces::led(p, &jib, [boom, rocker], &pulled.on, &AT_REST),
        }
    }

    /// As [`under`](PinForces::under), with what a led rope does to boom, jib and rocker besides.
    pub fn led(
        p: &Position<C>,
        jib: &JibLoad<C>,
        [boom, rocker]: [Option<C>; 2],
        rope: &[Hauled<C>; 3],
        names: &MomentNames,
    ) -> PinForces<C> {
        let [on_boom, on_jib, on_rocker] = rope;
        let with = |own: Option<C>, rope: &Hauled<C>| Some(own.map_or(-rope.moment, |own| own - rope.moment));
        let jib = JibLoad {
            down: jib.down - on_jib.force.y,
            forward: Some(jib.forward.map_or(on_jib.force.x, |own| own + on_jib.force.x)),
            about_b: jib.about_b - on_jib.moment,
        };
        PinForces::under(p, &jib, [with(boom, on_boom), with(rocker, on_rocker)], names)
    }

    /// Equilibrium of jib, driven link and driving link, in this order, under loads on the jib and moments on boom
    /// and rocker about their feet (N·m, clockwise positive).
    pub fn under(
        p: &Position<C>,
        jib: &JibLoad<C>,
        [boom, rocker]: [Option<C>; 2],
        names: &MomentNames,
    ) -> PinForces<C> {
        let JibLoad { down, forward, about_b } = *jib;
        let half = p.k / C::constant(2.0);
        let other = |force: Point<C>| {
            let across = forward.map_or(-force.x, |forward| -force.x - forward);
            Point::new(across, down - force.y)
        };
        match p.driven {
            Driven::Boom => {
                let about_b = about_b.def(names.about[0]);
                // cross(x_2, F_C) = about_b, cross(x_3, F_C) = −rocker.
                let along = |x_2: C, x_3: C| match rocker {
                    Some(rocker) => -((about_b * x_3 + rocker * x_2) / half),
                    None => -(about_b * x_3 / half),
                };
                let c = plane::def(
                    Point::new(along(p.x_2.x, p.x_3.x), along(p.x_2.y, p.x_3.y)),
                    [&s::F_CX, &s::F_CY],
                );
                let b = plane::def(other(c), [&s::F_BX, &s::F_BY]);
                let lift = plane::cross(p.x_1, b);
                let m_d = boom.map_or(lift, |boom| lift + boom).def(names.driven);
                PinForces { m_d, b, c }
            }
            Driven::Rocker => {
                // cross(x_2, F_B) = down · x_2 − about_b, cross(x_1, F_B) = −boom.
                let about_c = down * p.x_2.x - about_b;
                let about_c = forward.map_or(about_c, |forward| about_c + forward * p.x_2.y);
                let about_c = about_c.def(names.about[1]);
                let along = |x_1: C, x_2: C| match boom {
                    Some(boom) => (about_c * x_1 + boom * x_2) / half,
                    None => about_c * x_1 / half,
                };
                let b = plane::def(
                    Point::new(along(p.x_1.x, p.x_2.x), along(p.x_1.y, p.x_2.y)),
                    [&s::F_BX, &s::F_BY],
                );
                let c = plane::def(other(b), [&s::F_CX, &s::F_CY]);
                let lift = plane::cross(p.x_3, c);
                let m_d = rocker.map_or(lift, |rocker| lift + rocker).def(names.driven);
                PinForces { m_d, b, c }
            }
        }
    }
}

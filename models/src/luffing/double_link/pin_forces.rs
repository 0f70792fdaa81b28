//! The forces in the pins by equilibrium of each body, and what the drive must give.

use crate::balance::residual::Residual;
use crate::component::stages::{Found, results};
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::Fault;
use crate::luffing::double_link::geometry::Geometry;
use crate::luffing::double_link::parameters::{Choice, Driven, Weights};
use crate::luffing::double_link::position::Position;
use crate::luffing::double_link::statics::{LoadMoment, Own};
use crate::luffing::double_link::symbols as s;
use crate::luffing::double_link::velocity::Velocity;
use crate::parts::motion::degrees;
use crate::parts::plane::{self, Point};

/// What the bars carry, by its power.
#[derive(Clone, Copy, Debug)]
pub struct Carried<C> {
    q: C,
    weights: Option<Weights<C>>,
    m_q: C,
    m_g: C,
}

impl<C: Calc> Carried<C> {
    /// Of load and weights, less what a balance carries of the boom.
    pub fn new(
        v: &Velocity<C>,
        load: &LoadMoment<C>,
        q: &C,
        weights: &Option<Weights<C>>,
        own: Option<&Own<C>>,
        balance: Option<&Residual<C>>,
    ) -> Carried<C> {
        let m_g = own.map_or(C::constant(0.0), |own| own.m_g);
        Carried {
            q: *q,
            weights: *weights,
            m_q: load.m_q,
            m_g: balance.map_or(m_g, |balance| m_g - balance.action.m_b * v.of_boom),
        }
    }
}

/// What the drive must give, and forces in the pins where any finite ones carry load and weights.
#[derive(Clone, Copy, Debug)]
pub struct Held<C> {
    /// Moment that the drive must give to the driven bar, in N·m.
    pub m_d: C,
    /// Or at which angle bars lie in one line.
    pub pins: Result<PinForces<C>, (&'static Symbol, f64)>,
}
results! { Held as h => {
    M_D: h.m_d;
    F_BX: h.pins()?.b.x;
    F_BY: h.pins()?.b.y;
    F_CX: h.pins()?.c.x;
    F_CY: h.pins()?.c.y;
} }

impl<C: Calc> Held<C> {
    /// By equilibrium; where bars lie in one line, and where they do so somewhere in the working range, by virtual work.
    pub fn new(
        p: &Position<C>,
        theta: &One<C>,
        carried: &Carried<C>,
        own: Option<&Own<C>>,
        balance: Option<&Residual<C>>,
        passes: &Passes,
    ) -> Held<C> {
        if passes.0 || p.is_in_line() {
            return Held {
                m_d: (carried.m_q + carried.m_g).def(&s::M_D),
                pins: Err((theta.0, theta.1.value())),
            };
        }
        let pins = PinForces::new(p, &carried.q, &carried.weights, own, balance);
        Held {
            m_d: pins.m_d,
            pins: Ok(pins),
        }
    }

    /// # Errors
    /// Where bars lie in one line.
    pub fn pins(&self) -> Found<&PinForces<C>> {
        self.pins.as_ref().map_err(|(symbol, theta)| {
            Box::new(Fault::outside(format!(
                "{} = {}: bars lie in one line there, and no finite forces in the pins carry load and weights",
                symbol.id,
                degrees(*theta)
            )))
        })
    }
}

/// Whether the linkage passes a change point in the working range.
#[derive(Clone, Copy, Debug)]
pub struct Passes(bool);

impl Passes {
    pub fn new<C: Calc>(g: &Geometry<C>, choice: &Choice) -> Passes {
        Passes(g.change_point(&choice.range).is_some())
    }
}

/// Forces of the bars on the jib, in N, and what the drive must give.
#[derive(Clone, Copy, Debug)]
pub struct PinForces<C> {
    /// Moment that the drive must give to the driven bar, in N·m.
    pub m_d: C,
    /// Of the boom on the jib.
    pub b: Point<C>,
    /// Of the rocker on the jib.
    pub c: Point<C>,
}

impl<C: Calc> PinForces<C> {
    /// Equilibrium of jib, driven-along bar and driven bar, in this order, under the load `q`. Without weights, and
    /// their centres, the bars are weightless; a balance acts on the boom.
    pub fn new(
        p: &Position<C>,
        q: &C,
        weights: &Option<Weights<C>>,
        own: Option<&Own<C>>,
        balance: Option<&Residual<C>>,
    ) -> PinForces<C> {
        let (half, q) = (p.k / C::constant(2.0), *q);
        // Load on the jib, its moment about B, and the moments of boom and
        // rocker weight about their feet: all clockwise positive.
        let (load, about_b, boom, rocker) = match weights.as_ref().zip(own) {
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
        let minus = |force: Point<C>| Point::new(-force.x, load - force.y);
        match p.driven {
            Driven::Boom => {
                let about_b = about_b.def(&s::M_B);
                // cross(x_2, F_C) = about_b, cross(x_3, F_C) = −rocker.
                let along = |x_2: C, x_3: C| match rocker {
                    Some(rocker) => -((about_b * x_3 + rocker * x_2) / half),
                    None => -(about_b * x_3 / half),
                };
                let c = plane::def(
                    Point::new(along(p.x_2.x, p.x_3.x), along(p.x_2.y, p.x_3.y)),
                    [&s::F_CX, &s::F_CY],
                );
                let b = plane::def(minus(c), [&s::F_BX, &s::F_BY]);
                let lift = plane::cross(p.x_1, b);
                let m_d = boom.map_or(lift, |boom| lift + boom).def(&s::M_D);
                PinForces { m_d, b, c }
            }
            Driven::Rocker => {
                // cross(x_2, F_B) = load · x_2 − about_b, cross(x_1, F_B) = −boom.
                let about_c = (load * p.x_2.x - about_b).def(&s::M_C);
                let along = |x_1: C, x_2: C| match boom {
                    Some(boom) => (about_c * x_1 + boom * x_2) / half,
                    None => about_c * x_1 / half,
                };
                let b = plane::def(
                    Point::new(along(p.x_1.x, p.x_2.x), along(p.x_1.y, p.x_2.y)),
                    [&s::F_BX, &s::F_BY],
                );
                let c = plane::def(minus(b), [&s::F_CX, &s::F_CY]);
                let lift = plane::cross(p.x_3, c);
                let m_d = rocker.map_or(lift, |rocker| lift + rocker).def(&s::M_D);
                PinForces { m_d, b, c }
            }
        }
    }
}

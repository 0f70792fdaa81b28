//! What the drive must give at rest, and whether finite forces in the pins carry load and weights.

use crate::balance::residual::Residual;
use crate::component::stages::{Found, results};
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::Fault;
use crate::luffing::double_link::geometry::Geometry;
use crate::luffing::double_link::parameters::{Choice, Weights};
use crate::luffing::double_link::pin_forces::PinForces;
use crate::luffing::double_link::position::Position;
use crate::luffing::double_link::statics::{LoadMoment, Own};
use crate::luffing::double_link::symbols as s;
use crate::luffing::double_link::velocity::Velocity;
use crate::luffing::led::pull::LedPull;
use crate::parts::motion::degrees;

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
    /// Moment that the drive must give to the driving link, in N·m.
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
        pulled: Option<&LedPull<C>>,
    ) -> Held<C> {
        if passes.0 || p.is_in_line() {
            return Held {
                m_d: (carried.m_q + carried.m_g).def(&s::M_D),
                pins: Err((theta.0, theta.1.value())),
            };
        }
        let pins = PinForces::new(p, &carried.q, &carried.weights, own, balance, pulled);
        Held {
            m_d: pins.m_d,
            pins: Ok(pins),
        }
    }

    /// # Errors
    /// Where bars lie in one line.
    pub fn pins(&self) -> Found<&PinForces<C>> {
        self.pins
            .as_ref()
            .map_err(|(symbol, theta)| Box::new(in_line(symbol, *theta)))
    }
}

/// Bars lie in one line where the driving one, named by `symbol`, is at `theta` (rad).
#[cold]
pub fn in_line(symbol: &Symbol, theta: f64) -> Fault {
    Fault::outside(format!(
        "{} = {}: bars lie in one line there, and no finite forces in the pins carry load and weights",
        symbol.id,
        degrees(theta)
    ))
}

/// Whether the linkage passes a change point in the working range.
#[derive(Clone, Copy, Debug)]
pub struct Passes(bool);

impl Passes {
    pub fn new<C: Calc>(g: &Geometry<C>, choice: &Choice) -> Passes {
        Passes(g.change_point(&choice.range).is_some())
    }
}

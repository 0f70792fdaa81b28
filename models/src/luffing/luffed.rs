//! A luffing mechanism that something carries, at its angle: by numbers and their derivatives, whatever kind it is.

use std::sync::Arc;

use num_dual::Dual64;

use crate::component::aside::Aside;
use crate::component::scalar::{EachScalar, Scalar};
use crate::component::stages::results;
use crate::kernel::calc::{Calc, sum};
use crate::kernel::group::{One, group};
use crate::kernel::record::Rec;
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::variable::Fault;
use crate::luffing::aboard::{self as s, Aboard, Posed};
use crate::parts::plane::Point;

/// The luffing mechanism.
#[derive(Clone, Debug)]
pub struct Luffer(pub Arc<dyn Aboard>);
group!(Luffer);

type Sums<C> = [C; 10];

const SUMS: [&Symbol; 10] = *listed!(s: R, H_A, W_1, M_R1, M_H1, J_LM, DR, DH_A, DM_R1, DM_H1);

type Poses<C> = fn(&dyn Aboard, C) -> Option<(Posed<C>, Sums<C>)>;

/// Each scalar has its own derivatives by the luffing angle.
struct AtAngle;

impl EachScalar for AtAngle {
    type For<C: Calc> = Poses<C>;
    fn plain() -> Poses<f64> {
        |of, at| {
            let value = |x: Dual64| x.re;
            let posed = of.posed(Dual64::constant(at))?.map(&value, &value);
            Some(summed(of, posed))
        }
    }
    fn dual() -> Poses<Dual64> {
        |of, at| Some(summed(of, of.posed(at)?))
    }
    fn recorded() -> Poses<Rec> {
        |of, at| {
            let (posed, sums) = Self::plain()(of, at.value())?;
            let far = |x: f64| Rec::known(&s::H_A, x).over(at);
            let heavy = |x: f64| Rec::known(&s::W_1, x).over(at);
            let named = |i: usize| Rec::known(SUMS[i], sums[i]).over(at);
            Some((posed.map(&far, &heavy), std::array::from_fn(named)))
        }
    }
}

/// With reach and height of the head, weight, moments and inertia, and how they change.
#[inline(never)]
fn summed<C: Calc>(of: &dyn Aboard, posed: Posed<C>) -> (Posed<C>, Sums<C>) {
    let [offset, gravity] = [of.offset(), of.gravity()].map(C::constant);
    let [head, travel, _] = posed.head;
    let of =
        |each: &dyn Fn(&[Point<C>; 3]) -> C| sum(posed.weights.iter().map(|(weight, places)| *weight * each(places)));
    let sums = [
        head.x + offset,
        head.y,
        of(&|_| C::constant(1.0)),
        of(&|[at, ..]| at.x + offset),
        of(&|[at, ..]| at.y),
        of(&|[at, ..]| (at.x + offset).square()) / gravity,
        travel.x,
        travel.y,
        of(&|[_, travel, _]| travel.x),
        of(&|[_, travel, _]| travel.y),
    ];
    (posed, sums)
}

/// The luffing mechanism at its angle: reach of its head and its height above the mechanism's foot (m), weight (N), moments
/// about the slewing axis and by heights above the foot (N·m).
#[derive(Clone, Debug)]
pub struct Luffed<C> {
    pub posed: Posed<C>,
    /// How far its foot is in front of the slewing axis, in m.
    pub offset: C,
    pub reach: C,
    pub height: C,
    pub weight: C,
    pub forward: C,
    pub up: C,
    inertia: C,
    rates: [C; 4],
}
results! { Luffed as l => {
    R: l.reach;
    H_A: l.height;
    W_1: l.weight;
    M_R1: l.forward;
    M_H1: l.up;
} }

impl<C: Scalar> Luffed<C> {
    /// At an angle (rad), or at the start of its working range.
    ///
    /// # Errors
    /// An angle beyond its working range, or one at which it does not close.
    pub fn at(of: &Luffer, theta: Option<C>) -> Result<Luffed<C>, Fault> {
        let (of, range) = (&*of.0, of.0.range());
        let theta = theta.unwrap_or(C::constant(range.from));
        let at = theta.value();
        let inside = at >= range.from - ROUNDING && at <= range.to + ROUNDING;
        let found = inside.then(|| C::own::<AtAngle>()(of, theta)).flatten();
        let (posed, sums) = found.ok_or_else(|| {
            Fault::outside(format!(
                "theta_1 = {} is beyond the working range of luffing, {} to {}: luff less, or widen [luffing.motion]",
                s::THETA_1.written(at),
                s::THETA_1.written(range.from),
                s::THETA_1.written(range.to),
            ))
        })?;
        let [reach, height, weight, forward, up, inertia, rates @ ..] = sums;
        Ok(Luffed {
            posed,
            offset: C::constant(of.offset()),
            reach: reach.def(&s::R),
            height: height.def(&s::H_A),
            weight: weight.def(&s::W_1),
            forward: forward.def(&s::M_R1),
            up: up.def(&s::M_H1),
            inertia,
            rates,
        })
    }

    /// At the angle that is given.
    ///
    /// # Errors
    /// As [`at`](Luffed::at).
    pub fn held(of: &Luffer, theta: &Option<One<C>>) -> Result<Luffed<C>, Fault> {
        Self::at(of, theta.map(|theta| theta.1))
    }
}

/// How reach, height and moments change with the angle, in m and N·m for one radian.
#[derive(Clone, Copy, Debug)]
pub struct LuffedRates<C> {
    pub reach: C,
    pub height: C,
    pub forward: C,
    pub up: C,
}
results! { LuffedRates as r => { DR: r.reach; DH_A: r.height; DM_R1: r.forward; DM_H1: r.up; } }

impl<C: Calc> LuffedRates<C> {
    /// Derivatives of the positions of its bars.
    pub fn new(luffed: &Luffed<C>) -> LuffedRates<C> {
        let [reach, height, forward, up] = luffed.rates;
        LuffedRates {
            reach: reach.def(&s::DR),
            height: height.def(&s::DH_A),
            forward: forward.def(&s::DM_R1),
            up: up.def(&s::DM_H1),
        }
    }
}

/// Inertia about the slewing axis, in kg·m².
#[derive(Clone, Copy, Debug)]
pub struct LuffedInertia<C>(pub C);
results! { LuffedInertia as i => { J_LM: i.0; } }

impl<C: Calc> LuffedInertia<C> {
    /// J_lm = Σ m r², each bar two masses of its weight and inertia.
    pub fn new(luffed: &Luffed<C>) -> LuffedInertia<C> {
        LuffedInertia(luffed.inertia.def(&s::J_LM))
    }
}

impl Luffer {
    /// Its angle as a second coordinate of what carries it.
    pub fn aside(&self) -> Aside {
        Aside {
            symbol: &s::THETA_1,
            range: [self.0.range().from, self.0.range().to],
        }
    }
}

/// Distance of the load from the slewing axis, in m: as given, or that of the head.
///
/// # Errors
/// Neither is there.
pub fn reach<C: Calc>(given: &Option<One<C>>, luffed: Option<&Luffed<C>>) -> Result<C, Fault> {
    let of_head = luffed.map(|luffed| luffed.reach);
    let found = of_head.or(given.map(|given| given.1));
    found.ok_or_else(|| Fault::new("a crane has a reach or a luffing mechanism"))
}

/// What rounding may add to an end of the range, in rad.
const ROUNDING: f64 = 1e-9;

//! The luffing mechanism on a hull at its angle: by numbers and their derivatives, whatever kind it is.

use std::sync::Arc;

use num_dual::Dual64;

use crate::afloat::symbols as s;
use crate::component::scalar::{EachScalar, Scalar};
use crate::component::stages::results;
use crate::kernel::calc::{Calc, sum};
use crate::kernel::group::{One, group, quantities};
use crate::kernel::record::Rec;
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::variable::Fault;
use crate::luffing::aboard::{Aboard, Posed};
use crate::parts::plane::Point;

quantities! {
    /// The luffing angle, and its rate.
    LuffingMotion { theta_1: THETA_1, omega_1: OMEGA_1 }
}

/// The luffing mechanism on the hull.
#[derive(Clone, Debug)]
pub struct Luffer(pub Arc<dyn Aboard>);
group!(Luffer);

type Sums<C> = [C; 9];

const SUMS: [&Symbol; 9] = *listed!(s: R, H_A, DR, DH_A, W_1, M_R1, M_H1, DM_R1, DM_H1);

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
            let named = |i: usize| Rec::known(SUMS[i], sums[i]).over(at).def(SUMS[i]);
            Some((posed.map(&far, &heavy), std::array::from_fn(named)))
        }
    }
}

/// With reach and height of the head, weight and moments, and how they change.
#[inline(never)]
fn summed<C: Calc>(of: &dyn Aboard, posed: Posed<C>) -> (Posed<C>, Sums<C>) {
    let offset = C::constant(of.offset());
    let [head, travel, _] = posed.head;
    let of =
        |each: &dyn Fn(&[Point<C>; 3]) -> C| sum(posed.weights.iter().map(|(weight, places)| *weight * each(places)));
    let sums = [
        head.x + offset,
        head.y,
        travel.x,
        travel.y,
        of(&|_| C::constant(1.0)),
        of(&|[at, ..]| at.x + offset),
        of(&|[at, ..]| at.y),
        of(&|[_, travel, _]| travel.x),
        of(&|[_, travel, _]| travel.y),
    ];
    (posed, sums)
}

/// The luffing mechanism at its angle.
#[derive(Clone, Debug)]
pub struct Luffed<C> {
    pub posed: Posed<C>,
    /// How far its foot is in front of the slewing axis, in m.
    pub offset: C,
    pub sums: Sums<C>,
}
results! { Luffed as l => {
    R: l.sums[0];
    H_A: l.sums[1];
    DR: l.sums[2];
    DH_A: l.sums[3];
    W_1: l.sums[4];
    M_R1: l.sums[5];
    M_H1: l.sums[6];
    DM_R1: l.sums[7];
    DM_H1: l.sums[8];
} }

impl<C: Scalar> Luffed<C> {
    /// # Errors
    /// An angle beyond its working range, or one at which it does not close.
    pub fn new(of: &Luffer, held: &Option<One<C>>, luffing: &Option<LuffingMotion<C>>) -> Result<Luffed<C>, Fault> {
        let (of, range) = (&*of.0, of.0.range());
        let moved = luffing.map(|luffing| luffing.theta_1);
        let theta = moved.or(held.map(|held| held.1)).unwrap_or(C::constant(range.from));
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
        Ok(Luffed {
            posed,
            offset: C::constant(of.offset()),
            sums,
        })
    }
}

/// What rounding may add to an end of the range, in rad.
const ROUNDING: f64 = 1e-9;

//! The heel at which an opening comes to the water: looked for step by step, then found by Newton's method.

use num_dual::Dual64;

use crate::afloat::hull::Floating;
use crate::afloat::levers::Heeled;
use crate::afloat::symbols as s;
use crate::afloat::weights::Weighed;
use crate::component::found::{Finding, found};
use crate::component::scalar::Scalar;
use crate::kernel::calc::Calc;
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::Fault;
use crate::parts::bracket::bracketed;

/// What floats, as it weighs; place of an opening (m), and two heels (rad) between which it comes to the water.
type Heeling<C> = (Floating<C>, Weighed<C>, [C; 5]);

/// The heel at which an opening comes to the water: under the load, or when that is `LOST`.
struct Flooding<const LOST: bool>;

impl<const LOST: bool> Finding<1> for Flooding<LOST> {
    type From<C: Calc> = Heeling<C>;
    const NAMES: [&'static Symbol; 1] = [if LOST { &s::PHI_O0 } else { &s::PHI_O }];

    fn map<C: Calc, D: Calc>((on, all, place): &Heeling<C>, f: &mut dyn FnMut(C) -> D) -> Heeling<D> {
        (on.map(f), all.map(f), place.map(f))
    }

    fn find<C: Calc>(from: &Heeling<C>) -> Result<[C; 1], Fault> {
        floods(from).map(|heel| [heel])
    }
}

/// Heels (rad) up to which it is looked for, and the steps in which.
const FARTHEST: f64 = 1.4;
const STEP: f64 = 0.1;
/// Of the heel (rad): one more step leaves the square of this.
const NEAR: f64 = 1e-8;

/// How an opening stands over the water along the hull's own vertical, in m.
pub fn height<C: Calc>([x, y, z]: [C; 3], [draft, along, across]: [C; 3]) -> C {
    z - draft - x * along - y * across
}

/// Heels to one side, step by step, and how the hull lies there, each found once for all openings: plain numbers.
pub struct HeelSteps {
    on: Floating<f64>,
    all: Weighed<f64>,
    side: f64,
    found: Vec<(f64, [f64; 3])>,
}

impl HeelSteps {
    /// From a heel (rad) to a side.
    ///
    /// # Errors
    /// It does not come to rest.
    pub fn new<C: Calc>(on: &Floating<C>, all: &Weighed<C>, from: f64, side: f64) -> Result<HeelSteps, Fault> {
        let (on, all) = (on.map(&mut |x| x.value()), all.map(&mut |x| x.value()));
        let found = vec![(from, Heeled::new(&on, &all, None).lies(from)?)];
        Ok(HeelSteps { on, all, side, found })
    }

    /// Two heels (rad) between which an opening comes to the water first; the last one twice where it stays dry.
    ///
    /// # Errors
    /// It is under water at the first of them.
    fn around(&mut self, place: [f64; 3]) -> Result<[f64; 2], Fault> {
        let above = height(place, self.found[0].1);
        if above < 0.0 {
            return Err(Fault::outside(format!(
                "the opening at z_o = {} is {} under water at phi = {} when the load is lost; put it higher or nearer to the middle, or \
                 give less load or reach",
                s::Z_O.written(place[2]),
                s::F_O.written(-above),
                s::PHI.written(self.found[0].0),
            )));
        }
        let mut step = 0;
        loop {
            let near = self.found[step].0;
            step += 1;
            if step == self.found.len() {
                if self.side * near >= FARTHEST {
                    return Ok([near; 2]);
                }
                let heel = self.side * (self.side * near + STEP).min(FARTHEST);
                let before = self.found[step - 1].1;
                let lies = Heeled::new(&self.on, &self.all, Some(before)).lies(heel)?;
                self.found.push((heel, lies));
            }
            let (far, lies) = self.found[step];
            if height(place, lies) < 0.0 {
                return Ok([near, far]);
            }
        }
    }

    /// Heel (rad, by amount) at which an opening comes to the water first, to the side of the heel under the load or from it;
    /// infinite where it stays dry.
    ///
    /// # Errors
    /// It is under water at the first of the heels.
    pub fn flooding<const LOST: bool, C: Scalar>(
        &mut self,
        on: &Floating<C>,
        all: &Weighed<C>,
        heel: C,
        place: [C; 3],
    ) -> Result<C, Fault> {
        let between = self.around(place.map(|x| x.value()))?;
        // The heel under the load decides to which side.
        let ([x, y, z], [near, far]) = (place, between.map(|end| C::constant(end).over(heel)));
        let [heel] = found::<Flooding<LOST>, C, 1>(&(on.clone(), *all, [x, y, z, near, far]))?;
        Ok(heel)
    }
}

/// Heel at which an opening comes to the water between two, by amount (rad): Newton's method between ends that close in;
/// infinite where these are one.
///
/// # Errors
/// It does not come to rest.
#[inline(never)]
fn floods<C: Calc>((on, all, [x, y, z, near, far]): &Heeling<C>) -> Result<C, Fault> {
    let plain = |x: C| Dual64::from_re(x.value());
    let (hull, weighed, place) = (on.map(&mut { plain }), all.map(&mut { plain }), [*x, *y, *z].map(plain));
    let mut heeled = Heeled::new(&hull, &weighed, None);
    let mut high = |heel: f64| {
        let over = height(place, heeled.lies(Dual64::new(heel, 1.0))?);
        Ok::<_, Fault>([over.re, over.eps])
    };
    let (near, far) = (near.value(), far.value());
    if near == far {
        return Ok(C::constant(f64::INFINITY));
    }
    let side = (far - near).signum();
    let heel = bracketed([near, far], f64::midpoint(near, far), NEAR, &mut high)?;
    // A last step brings the derivatives.
    let steep = C::constant(high(heel)?[1]);
    let heel = C::constant(heel);
    let left = height([*x, *y, *z], Heeled::new(on, all, None).lies(heel)?);
    Ok(C::constant(side) * (heel - left / steep))
}

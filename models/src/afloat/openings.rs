//! Openings through which water comes in: how high they stand over it, and the heels at which they come to it.

use num_dual::Dual64;

use crate::afloat::hull::Floating;
use crate::afloat::levers::at_heel;
use crate::afloat::loaded::Loaded;
use crate::afloat::posture::Posture;
use crate::afloat::symbols as s;
use crate::afloat::weights::Weighed;
use crate::component::found::{Finding, found};
use crate::component::scalar::Scalar;
use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::{One, quantities};
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::Fault;

quantities! {
    /// Where water comes in.
    Opening { x_o: X_O, y_o: Y_O, z_o: Z_O }
}

/// What floats, as it weighs; place of an opening (m), the heel from which the hull heels (rad) and one beyond it.
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
const STEP: f64 = 0.05;
/// Steps of Newton's method, at most, and the last one (rad).
const STEPS: usize = 60;
const NEAR: f64 = 1e-13;

/// Height of an opening over the water along the hull's own vertical, in m, at a heel (rad) that is held.
fn height<C: Calc>(on: &Floating<C>, all: &Weighed<C>, [x, y, z]: [C; 3], heel: C) -> Result<C, Fault> {
    let [draft, along, across] = at_heel(on, all, heel)?;
    Ok(z - draft - x * along - y * across)
}

/// Heel at which an opening comes to the water, by amount (rad): the first one; infinite where none does.
///
/// # Errors
/// It is under water at the heel from which the hull heels.
#[inline(never)]
fn floods<C: Calc>((on, all, [x, y, z, from, beyond]): &Heeling<C>) -> Result<C, Fault> {
    let plain = |x: C| Dual64::from_re(x.value());
    let (hull, weighed, place) = (on.map(&mut { plain }), all.map(&mut { plain }), [*x, *y, *z].map(plain));
    let high = |heel: f64| height(&hull, &weighed, place, Dual64::new(heel, 1.0));
    let side = (beyond.value() - from.value()).signum();
    let above = high(from.value())?.re;
    if above < 0.0 {
        return Err(Fault::outside(format!(
            "the opening at z_o = {} is {} under water at phi = {} when the load is lost; put it higher or nearer to the middle, or \
             give less load or reach",
            s::Z_O.written(z.value()),
            s::F_O.written(-above),
            s::PHI.written(from.value()),
        )));
    }
    let (mut near, mut far) = (from.value(), from.value());
    while high(far)?.re >= 0.0 {
        if side * far >= FARTHEST {
            return Ok(C::constant(f64::INFINITY));
        }
        (near, far) = (far, side * (side * far + STEP).min(FARTHEST));
    }
    let mut heel = f64::midpoint(near, far);
    for _ in 0..STEPS {
        let over = high(heel)?;
        if over.re >= 0.0 {
            near = heel
        } else {
            far = heel
        }
        let next = heel - over.re / over.eps;
        let inside = next >= near.min(far) && next <= near.max(far);
        let next = if inside { next } else { f64::midpoint(near, far) };
        let done = (next - heel).abs() < NEAR;
        heel = next;
        if done {
            break;
        }
    }
    // A last step brings the derivatives.
    let steep = C::constant(high(heel)?.eps);
    let heel = C::constant(heel);
    Ok(C::constant(side) * (heel - height(on, all, [*x, *y, *z], heel)? / steep))
}

/// Of an opening: height over the water at rest (m), and the heels (rad) at which it comes to the water, under the load and when
/// that is lost.
#[derive(Clone, Copy, Debug)]
pub struct FloodedOpening<C> {
    height: C,
    heels: [C; 2],
}
results! { each FloodedOpening as o => { F_O: o.height; PHI_O: o.heels[0]; PHI_O0: o.heels[1]; } }

/// f_o = (z_o − T − x_o tan θ − y_o tan φ) cos β, and the heels, the trim free.
///
/// # Errors
/// An opening under water.
pub fn flooding<C: Scalar>(
    on: &Floating<C>,
    loaded: &Loaded<C>,
    posture: &Posture<C>,
    openings: &[Opening<C>],
    room: &mut Vec<FloodedOpening<C>>,
) -> Result<(), Fault> {
    room.clear();
    let ([draft, along, across], (_, cos)) = (posture.lie(), posture.inclination().sin_cos());
    let heel = posture.heel();
    let side = if heel.value() >= 0.0 { 1.0 } else { -1.0 };
    for (at, opening) in openings.iter().enumerate() {
        let Opening { x_o, y_o, z_o } = *opening;
        let one = C::body(at, || {
            let height = ((z_o - draft - x_o * along - y_o * across) * cos).def(&s::F_O);
            if height.value() < 0.0 {
                return Err(Fault::outside(format!(
                    "opening {} is under water, f_o = {} at phi = {}; give less load or reach, other ballast, or put it higher",
                    at + 1,
                    s::F_O.written(height.value()),
                    s::PHI.written(heel.value()),
                )));
            }
            let to = |end: f64| [x_o, y_o, z_o, heel, C::constant(end * FARTHEST)];
            let [loaded_heel] = found::<Flooding<false>, C, 1>(&(on.clone(), loaded.all, to(side)))?;
            let [bare_heel] = found::<Flooding<true>, C, 1>(&(on.clone(), loaded.bare, to(-side)))?;
            Ok(FloodedOpening {
                height,
                heels: [loaded_heel, bare_heel],
            })
        })?;
        room.push(one);
    }
    Ok(())
}

/// Heels up to which areas count, in rad: under the load, and when that is lost.
#[derive(Clone, Copy, Debug)]
pub struct AreaEnds<C>(pub [C; 2]);

impl<C: Calc> AreaEnds<C> {
    /// φ_f, or less where an opening comes to the water before.
    pub fn new(limit: &One<C>, openings: &[FloodedOpening<C>]) -> AreaEnds<C> {
        AreaEnds([0, 1].map(|i| {
            openings
                .iter()
                .fold(limit.1, |least, opening| least.smaller(opening.heels[i]))
        }))
    }
}

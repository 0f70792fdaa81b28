//! Openings through which water comes in: how high they stand over it, and the heels at which they come to it.

use crate::afloat::heeling::{HeelSteps, height};
use crate::afloat::hull::Floating;
use crate::afloat::loaded::Loaded;
use crate::afloat::posture::Posture;
use crate::afloat::symbols as s;
use crate::component::scalar::Scalar;
use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::{One, quantities};
use crate::kernel::variable::Fault;

quantities! {
    /// Where water comes in.
    Opening { x_o: X_O, y_o: Y_O, z_o: Z_O }
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
    let mut steps = None;
    for (at, opening) in openings.iter().enumerate() {
        let Opening { x_o, y_o, z_o } = *opening;
        let one = C::body(at, || {
            let height = (height([x_o, y_o, z_o], [draft, along, across]) * cos).def(&s::F_O);
            if height.value() < 0.0 {
                return Err(Fault::outside(format!(
                    "opening {} is under water, f_o = {} at phi = {}; give less load or reach, other ballast, or put it higher",
                    at + 1,
                    s::F_O.written(height.value()),
                    s::PHI.written(heel.value()),
                )));
            }
            let [with, without] = match &mut steps {
                Some(steps) => steps,
                none => none.insert([
                    HeelSteps::new(on, &loaded.all, heel.value(), side)?,
                    HeelSteps::new(on, &loaded.bare, heel.value(), -side)?,
                ]),
            };
            let place = [x_o, y_o, z_o];
            Ok(FloodedOpening {
                height,
                heels: [
                    with.flooding::<false, C>(on, &loaded.all, heel, place)?,
                    without.flooding::<true, C>(on, &loaded.bare, heel, place)?,
                ],
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

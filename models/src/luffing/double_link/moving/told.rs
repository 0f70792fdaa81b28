//! What the book tells of a crane in motion besides its variables.

use std::any::Any;

use crate::component::moving::MovingComponent;
use crate::component::part::{Component, Runner};
use crate::component::stages::Stages;
use crate::kernel::calc::Calc;
use crate::kernel::record::{self, Rec};
use crate::kernel::variable::Fault;
use crate::luffing::double_link::stages::DoubleLink;
use crate::luffing::moving::carried::{self, CarriedCrane};
use crate::luffing::moving::level::{CraneAt, Powers};
use crate::luffing::moving::luffs::Luffs;
use crate::luffing::moving::stages::open;

/// Powers as it is now, and the energy (J) of all bodies with what blows have taken so far.
///
/// # Errors
/// The linkage does not close.
pub(crate) fn powers(model: &mut MovingComponent) -> Result<(Powers, f64), Fault> {
    let known = carried::known::<DoubleLink>(model.parts().0);
    let theta = DoubleLink::given(known).theta;
    let (level, at) = DoubleLink::in_motion(known).map_err(|fault| *fault)?;
    let (powers, energy) = level.powers(&at).ok_or_else(|| open(&theta))?;
    Ok((powers, energy + at.past.blown))
}

/// Energy of the bodies' motion as it is now, in J.
///
/// # Errors
/// The linkage does not close.
pub(crate) fn kinetic(model: &mut MovingComponent) -> Result<f64, Fault> {
    let known = carried::known::<DoubleLink>(model.parts().0);
    let theta = DoubleLink::given(known).theta;
    let (level, moving) = DoubleLink::in_motion(known).map_err(|fault| *fault)?;
    let mut still = moving;
    for &rate in level.rates_of() {
        still.y[rate] = 0.0;
    }
    let energies = [moving, still].map(|at| Some(level.powers(&at)?.1));
    match energies {
        [Some(moving), Some(still)] => Ok(moving - still),
        _ => Err(open(&theta)),
    }
}

/// How far the moment on the driven bar by equilibrium of the moving bodies is from that of drive, friction and end
/// stop, and the greatest of what they are made of, in N·m; `None` where there are no finite forces.
pub(crate) fn apart(model: &mut MovingComponent) -> Option<[f64; 2]> {
    carried::known::<DoubleLink>(model.parts().0).forces().ok()?.0.apart()
}

/// The crane as it is, with the least pressure of its oil so far, in Pa.
pub(crate) fn present(model: &mut MovingComponent) -> (CraneAt, f64) {
    let (standing, carrier) = model.parts();
    let carrier: &dyn Any = carrier;
    let own: &CarriedCrane<DoubleLink> = carrier.downcast_ref().expect("a crane's");
    let least = own.ahead.least_pressure();
    (carried::at::<DoubleLink>(standing), least)
}

/// Runs the equations of motion as they are now under the recorder. Returns how many steps were recorded while
/// they were assembled.
pub(crate) fn recorded(model: &MovingComponent) -> usize {
    let plain = model.standing().of::<DoubleLink>().given();
    let given = DoubleLink::map(plain, &mut |source, (symbol, _), value| {
        let past = DoubleLink::GROUPS[usize::from(source.group)].0 == "past";
        match past || !DoubleLink::gives(plain, symbol) {
            true => Rec::constant(value),
            false => Rec::given(symbol, value),
        }
    });
    let mut known = Runner::<DoubleLink, Rec>::new(given).0;
    let built = known.built().is_ok();
    let assembled = record::steps();
    if built {
        let _ = known.moves();
        if plain.fitted.rope.is_some() {
            let _ = known.pull();
        }
        let _ = known.forces();
    }
    assembled
}

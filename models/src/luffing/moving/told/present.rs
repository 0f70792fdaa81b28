//! What the book tells of a crane in motion besides its variables.

use std::any::Any;

use crate::component::moving::MovingComponent;
use crate::component::part::{Component, Runner};
use crate::component::stages::Stages;
use crate::kernel::calc::Calc;
use crate::kernel::record::{self, Rec};
use crate::kernel::variable::Fault;
use crate::luffing::moving::carried::{self, CarriedCrane};
use crate::luffing::moving::dynamics::Coordinate;
use crate::luffing::moving::level::{CraneAt, Level};
use crate::luffing::moving::luffs::Luffs;
use crate::luffing::moving::powers::Powers;
use crate::luffing::moving::stages::open;
use crate::luffing::moving::told::shown::Shown;

/// Which of the states are rates of the bodies: behind the angle and the oil come the states of slewing and of the load in
/// space, or of the load in the plane, then that of the load's rope and that of a drive's drum.
fn rates_of(level: &Level) -> &'static [usize] {
    match (level, level.dynamics().turntable().is_some()) {
        (Level::Free(_) | Level::Slewing(_), false) => &[1, 3, 6, 7],
        (Level::Free(_) | Level::Slewing(_), true) => &[1, 3, 7, 8, 9, 11],
        (Level::Hauled(_) | Level::HauledSlewing(_), false) => &[1, 3, 6, 7, 9],
        (Level::Hauled(_) | Level::HauledSlewing(_), true) => &[1, 3, 7, 8, 9, 11, 13],
        (Level::Fixed(_) | Level::Hanging(_), false) => &[1, 9, 12, 13],
        (Level::Fixed(_) | Level::Hanging(_), true) => &[1, 9, 13, 14, 15, 17],
    }
}

/// Powers as it is now, and the energy (J) of all bodies with what blows have taken so far.
///
/// # Errors
/// The linkage does not close.
pub(super) fn powers<T: Luffs>(model: &mut MovingComponent) -> Result<(Powers, f64), Fault> {
    let known = carried::known::<T>(model.parts().0);
    let theta = T::luffing(T::given(known)).theta;
    let (level, at) = T::in_motion(known).map_err(|fault| *fault)?;
    let (powers, energy) = level.powers(&at).ok_or_else(|| open(&theta))?;
    Ok((powers, energy + at.past.blown))
}

/// Energy of the bodies' motion as it is now, in J.
///
/// # Errors
/// The linkage does not close.
pub(super) fn kinetic<T: Luffs>(model: &mut MovingComponent) -> Result<f64, Fault> {
    let known = carried::known::<T>(model.parts().0);
    let theta = T::luffing(T::given(known)).theta;
    let (level, moving) = T::in_motion(known).map_err(|fault| *fault)?;
    let mut still = moving;
    for &rate in rates_of(level) {
        still.y[rate] = 0.0;
    }
    let energies = [moving, still].map(|at| Some(level.powers(&at)?.1));
    match energies {
        [Some(moving), Some(still)] => Ok(moving - still),
        _ => Err(open(&theta)),
    }
}

/// The crane as it is, with the least pressure of its oil so far, in Pa.
pub(super) fn present<T: Luffs>(model: &mut MovingComponent) -> (CraneAt, f64) {
    let (standing, carrier) = model.parts();
    let carrier: &dyn Any = carrier;
    let own: &CarriedCrane<T> = carrier.downcast_ref().expect("a crane's");
    let least = own.ahead.least_pressure();
    (carried::at::<T>(standing), least)
}

/// The crane at rest as it is, but for its load, which stands on the ground while the rope pulls with half its weight; `None`
/// where there is no ground.
pub(super) fn standing<T: Luffs>(model: &MovingComponent) -> Option<MovingComponent> {
    let mut model = model.clone();
    let moving = model.parts().0;
    let known = carried::known::<T>(moving);
    let given = T::luffing(T::given(known));
    let (ground, give) = given.sources.ground.zip(given.sources.give)?;
    let load = given.load.filter(|load| load.1 > 0.0)?;
    let (level, mut at) = T::in_motion(known).ok()?;
    for &rate in rates_of(level) {
        at.y[rate] = 0.0;
    }
    let below = f64::reduced(level.dynamics(), at.y[0])?.head[0].y - ground.y_g;
    let fitted = given.sources.fitted;
    let fittings = [fitted.oil, fitted.slewing.is_some()];
    if below <= 0.0 {
        return None;
    }
    at.stand(below, fittings);
    at.pull(0.5 * load.1 / give.c_r, fittings);
    carried::put::<T>(moving, &at);
    Some(model)
}

/// Runs stages as they are now under the recorder, after the equations of motion were assembled. Returns how many steps were
/// recorded until then.
pub(super) fn recorded<T: Shown>(model: &MovingComponent, wanted: &[&str]) -> usize {
    let runner = model.standing().of::<T::Component>();
    let plain = runner.given();
    let given = T::Component::map(plain, &mut |source, (symbol, _), value| {
        let past = ["past", "regime"].contains(&T::Component::GROUPS[usize::from(source.group)].0);
        match past || !T::Component::gives(plain, symbol) {
            true => Rec::constant(value),
            false => Rec::given(symbol, value),
        }
    });
    let mut known = Runner::<T::Component, Rec>::new(given).0;
    let stages = T::Component::STAGES;
    let mut make = |id: &str| {
        let found = stages
            .iter()
            .position(|stage| stage.id == id)
            .expect("one of its stages");
        let (rows, stage) = (stages[found].rows, found as u8);
        let there = rows.is_empty() || rows.iter().any(|row| T::Component::has(plain, row));
        let there = there && T::Component::count(&runner.0, stage).is_some();
        there && T::Component::make(&mut known, stage).is_ok()
    };
    let built = make("built");
    let assembled = record::steps();
    if built {
        for id in wanted {
            make(id);
        }
    }
    assembled
}

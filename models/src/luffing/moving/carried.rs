//! How a crane in motion is carried on: what its solver keeps, and what is decided at an event.

use std::any::Any;
use std::marker::PhantomData;

use crate::component::moving::{Carrier, Ramp};
use crate::component::running::Running;
use crate::component::standing::Standing;
use crate::kernel::group::Group;
use crate::kernel::number::short;
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::{Fault, Role};
use crate::luffing::moving::brakes::{Braking, Delays};
use crate::luffing::moving::control::ByAxis;
use crate::luffing::moving::control::continuous::Laws;
use crate::luffing::moving::control::holding::holding;
use crate::luffing::moving::crane::REELED_IN;
use crate::luffing::moving::given::{CraneStates, DELTA_L, Inputs, L_R, S_Q, STATES, V_R, V_TL, order};
use crate::luffing::moving::level::{Ahead, CraneAt, Onward};
use crate::luffing::moving::luffs::{LuffingGiven, Luffs, MotionSources};
use crate::luffing::moving::regulated::Regulators;
use crate::luffing::moving::stages::open;
use crate::luffing::moving::symbols as m;
use crate::parts::control::continuous::Regulating;
use crate::parts::hoist::Drum;
use crate::parts::hydraulics::oil::warning;
use crate::parts::joint::Bar;
use crate::parts::solver::{Count, Halt, MOST_IMPLICIT, MOST_STEPS};

/// What the solver keeps, and its work so far, which is no part of the state.
pub struct CarriedCrane<T> {
    pub(crate) ahead: Ahead,
    pub(super) count: Count,
    /// Whether brakes are on the shaft of its motor.
    pub(super) braked: bool,
    /// Where its controllers begin, if they are not sampled.
    pub(super) begun: Option<Laws>,
    pub(super) of: PhantomData<fn() -> T>,
}

impl<T> Clone for CarriedCrane<T> {
    fn clone(&self) -> CarriedCrane<T> {
        CarriedCrane {
            ahead: self.ahead,
            count: self.count,
            braked: self.braked,
            begun: self.begun,
            of: PhantomData,
        }
    }
}

pub(crate) fn known<T: Luffs>(model: &mut Standing) -> &mut T::Known<f64> {
    &mut model.of_mut::<T>().0
}

fn given<T: Luffs>(model: &Standing) -> LuffingGiven {
    T::luffing(model.of::<T>().given())
}

/// The crane as it is.
pub(crate) fn at<T: Luffs>(model: &mut Standing) -> CraneAt {
    T::now(known::<T>(model)).expect("all that it is made of is given")
}

/// Whether it holds together.
fn whole<T: Luffs>(model: &mut Standing) -> Result<(), Fault> {
    T::holds(known::<T>(model)).map_err(|fault| *fault)
}

/// Puts a crane where it is now.
pub(crate) fn put<T: Luffs>(model: &mut Standing, CraneAt { past, y, .. }: &CraneAt) {
    let fitted = given::<T>(model).sources.fitted;
    let mut states = CraneStates([0.0; STATES.len()]);
    for (y, place) in y[2..].iter().zip(order(&fitted)) {
        states.0[*place] = *y;
    }
    T::put_now(known::<T>(model), [y[0], y[1]], states, *past);
}

/// Puts a crane where it is now, and its continuous controllers where it has them.
fn put_all<T: Luffs>(model: &mut Standing, at: &CraneAt, regulators: &Option<Regulators>) {
    put::<T>(model, at);
    if let Some(regulators) = regulators {
        T::put_laws(known::<T>(model), regulators.laws);
    }
}

/// States of controllers.
fn stands(regulators: &Option<Regulators>) -> Option<ByAxis<Regulating>> {
    regulators.as_ref().map(|regulators| regulators.laws.states)
}

/// Longest step of the solver, in s.
fn longest(given: &LuffingGiven) -> f64 {
    given.sources.constants.map_or(0.0, |constants| constants.step)
}

fn refusal(given: &LuffingGiven, halt: Halt, duration: f64) -> Fault {
    let angle = format!("{} = {}", given.theta.0.id, given.theta.0.written(given.theta.1));
    let longest = longest(given);
    let (size, step) = (short(duration), short(longest));
    let most = if given.sources.fitted.oil {
        MOST_IMPLICIT
    } else {
        MOST_STEPS
    };
    Fault::outside(match halt {
        Halt::Outside => {
            let oil = if given.sources.fitted.oil {
                ", the oil is stretched beyond its bulk modulus"
            } else {
                ""
            };
            format!(
                "the motion from {angle} ends within {size} s where the linkage does not close, nothing is left of \
                 the rope{oil}, or beyond all reasonable numbers: keep the working range away from dead points, reel in \
                 less, or command less"
            )
        }
        Halt::TooFast | Halt::TooSmall | Halt::TooMany if winds_up(given, duration) => format!(
            "nothing is left of the rope of {} = {} within {size} s, as {} = {}: reel in less",
            m::L_R.id,
            m::L_R.written(state(&given.sources, L_R)),
            m::V_R.id,
            m::V_R.written(state(&given.sources, V_R))
        ),
        Halt::TooFast => format!(
            "inner steps of {step} s are too long for the motion from {angle}, which changes by more than itself \
             within one: set step below {} s, or make the rope longer or the friction less",
            short(longest / 2.0)
        ),
        Halt::TooSmall | Halt::TooMany => format!(
            "the step of {size} s from {angle} needs more than the {most} inner steps that are allowed, \
             at step = {step} s: take smaller communication steps, a longer step or a coarser tolerance"
        ),
    })
}

fn state(given: &MotionSources, place: usize) -> f64 {
    given.states.map_or(0.0, |states| states.0[place])
}

/// Whether a hoist's motor reels in all of the rope at the speed that its drum has.
fn winds_up(given: &LuffingGiven, size: f64) -> bool {
    let [length, rate] = [L_R, V_R].map(|place| state(&given.sources, place));
    given.sources.motor.is_some() && length + rate * size <= REELED_IN
}

/// Refuses a step in which all of the rope is reeled in: its end would be sought in ever smaller inner steps.
fn enough_rope(given: &LuffingGiven, size: f64) -> Result<(), Fault> {
    let sources = &given.sources;
    let length = state(sources, L_R);
    if sources.fitted.rope.is_none() || length + paying_out(sources, size) > REELED_IN {
        return Ok(());
    }
    Err(Fault::outside(format!(
        "at {} = {} nothing is left of the rope of {} = {} within {} s: reel in less",
        m::V_H.id,
        m::V_H.written(sources.inputs.map_or(0.0, |inputs| inputs.hoist.speed)),
        m::L_R.id,
        m::L_R.written(length),
        short(size)
    )))
}

/// How much rope the hoist pays out within a time (s), in m.
fn paying_out(given: &MotionSources, size: f64) -> f64 {
    let command = given.inputs.map_or(0.0, |inputs| inputs.hoist.speed);
    let Some(ramp) = given.ramp else {
        // Of a drum with a motor its load decides.
        return if given.motor.is_some() { 0.0 } else { command * size };
    };
    let rate = state(given, V_R);
    let change = command - rate;
    let time = size.min(change.abs() / ramp.a_h);
    rate * time + change.signum() * 0.5 * ramp.a_h * time * time + command * (size - time)
}

/// Whether setting a variable moves the ground, or what is beside the rope.
fn shifts((symbol, role): (&'static Symbol, Role)) -> bool {
    symbol == &m::Y_G || (role == Role::State && ![&m::L_R, &m::V_R].contains(&symbol))
}

/// Whether a load that stands on the ground does so is decided again.
fn lift<T: Luffs>(model: &mut Standing) {
    let mut at = at::<T>(model);
    if at.past.grounded {
        at.past.grounded = false;
        put::<T>(model, &at);
    }
}

/// Continuous controllers as they are.
pub(super) fn regulators<T: Luffs>(model: &Standing) -> Option<Regulators> {
    let now = given::<T>(model).sources;
    let (states, past) = now.regulating.zip(now.regime)?;
    let (control, commanded) = now.control.zip(now.commanded)?;
    Some(Regulators {
        control,
        commanded,
        laws: Laws { states, past },
    })
}

/// Command of the brakes on the motor's shaft, what they do, and their delays.
fn brakes(given: &LuffingGiven) -> Option<(f64, Braking, Delays)> {
    let (inputs, past) = given.sources.inputs.zip(given.sources.past)?;
    let delays = Delays::new(&given.brake, &given.second, longest(given));
    Some((inputs.braking, past.braking, delays))
}

impl<T: Luffs> CarriedCrane<T> {
    /// Which brakes act on the motor's shaft is decided at a time (s): as commanded now, or also before.
    fn brake(&self, model: &mut Standing, time: f64, before: bool) {
        let Some((command, braking, delays)) = self.braked.then(|| brakes(&given::<T>(model))).flatten() else {
            return;
        };
        let decided = match before {
            true => Braking::before(command, &delays, time),
            false => braking.decided(command, &delays, time),
        };
        if decided != braking {
            let mut at = at::<T>(model);
            at.past.braking = decided;
            put::<T>(model, &at);
        }
    }

    /// When the next brake falls on, in s, after a time.
    fn falls(&self, model: &Standing, time: f64) -> Option<f64> {
        let (_, braking, delays) = self.braked.then(|| brakes(&given::<T>(model)))??;
        braking.next(&delays, time)
    }

    /// Controllers hold their axes at rest where the crane is.
    pub(super) fn hold(&mut self, model: &mut Standing) -> Result<(), Fault> {
        let now = given::<T>(model);
        let Some(control) = now.sources.control else {
            return Ok(());
        };
        let (level, at) = T::in_motion(known::<T>(model)).map_err(|fault| *fault)?;
        let moments = holding(level, &at, &now.sources.fitted, &control, longest(&now))?;
        if let Some(mut held) = now.sources.latched {
            held.hold(moments);
            T::put_held(known::<T>(model), held);
        }
        if let Some((begun, mut now)) = self.begun.zip(regulators::<T>(model)) {
            now.laws.hold(&control, moments, &begun);
            T::put_laws(known::<T>(model), now.laws);
            self.begun = Some(now.laws);
        }
        Ok(())
    }

    /// Continuous controllers, where it has them.
    fn regulators(&self, model: &Standing) -> Option<Regulators> {
        self.begun.and_then(|_| regulators::<T>(model))
    }

    fn decide(&mut self, model: &mut Standing) -> Result<bool, Fault> {
        self.brake(model, model.time(), false);
        let mut laws = self.regulators(model);
        let (level, mut at) = T::in_motion(known::<T>(model)).map_err(|fault| *fault)?;
        let (before, mut ahead) = ((at.y, stands(&laws)), self.ahead);
        let decided = level.carry(&mut at, &mut ahead, laws.as_mut(), None);
        decided.map_err(|_| open(&given::<T>(model).theta))?;
        self.ahead = ahead;
        put_all::<T>(model, &at, &laws);
        Ok((at.y, stands(&laws)) != before)
    }

    /// Moves on between two times (s), while no brake falls on.
    fn piece(&mut self, model: &mut Standing, [from, to]: [f64; 2], ramps: &[Ramp]) -> Result<(), Fault> {
        let now = given::<T>(model);
        enough_rope(&now, to - from)?;
        // Commands of controllers are of no account from one sample to the next.
        let acts = |ramp: &&Ramp| T::GROUPS[usize::from(ramp.source.group)].0 == "inputs";
        let slopes = ramps.iter().any(|ramp| acts(&ramp)).then(|| {
            let mut slopes = Inputs::none();
            for ramp in ramps.iter().filter(acts) {
                slopes.put(usize::from(ramp.source.place), ramp.slope);
            }
            slopes
        });
        let on = Onward {
            duration: to - from,
            longest: longest(&now),
            tolerance: now.sources.oil.map_or(0.0, |oil| oil.tol),
            slopes,
        };
        let led = self.regulators(model);
        let (level, before) = T::in_motion(known::<T>(model)).map_err(|fault| *fault)?;
        let (mut at, mut ahead, mut laws) = (before, self.ahead, led);
        let solved = level.carry(&mut at, &mut ahead, laws.as_mut(), Some(on));
        let work = solved.map_err(|halt| refusal(&now, halt, to - from))?;
        self.count = self.count.and(work);
        put_all::<T>(model, &at, &laws);
        let whole = model.update().and_then(|()| whole::<T>(model));
        whole.inspect_err(|_| put_all::<T>(model, &before, &led))?;
        self.ahead = ahead;
        model.set_time(to);
        Ok(())
    }

    /// The same from one brake to the next that falls on; what fails leaves it anywhere.
    fn pieces(&mut self, model: &mut Standing, [from, to]: [f64; 2], ramps: &[Ramp]) -> Result<(), Fault> {
        let mut time = from;
        loop {
            self.brake(model, time, false);
            let end = self.falls(model, time).filter(|at| *at < to).unwrap_or(to);
            self.piece(model, [time, end], ramps)?;
            if end == to {
                return Ok(());
            }
            time = end;
            for ramp in ramps {
                model
                    .part_mut()
                    .put(ramp.source, ramp.value + ramp.slope * (time - from));
            }
        }
    }
}

impl<T: Luffs> Carrier for CarriedCrane<T> {
    fn advance(&mut self, model: &mut Standing, times: [f64; 2], ramps: &[Ramp]) -> Result<(), Fault> {
        if !self.braked {
            return self.piece(model, times, ramps);
        }
        let (before, ahead, laws) = (at::<T>(model), self.ahead, self.regulators(model));
        self.pieces(model, times, ramps).inspect_err(|_| {
            for ramp in ramps {
                model.part_mut().put(ramp.source, ramp.value);
            }
            put_all::<T>(model, &before, &laws);
            model.set_time(times[0]);
            self.ahead = ahead;
        })
    }

    fn next_event(&self, model: &Standing) -> Option<f64> {
        self.falls(model, model.time())
    }

    /// Passed forwards, at the speed of the working range.
    fn place(&mut self, model: &mut Standing, value: f64) -> Result<(), Fault> {
        model.check(0, value)?;
        let mut at = at::<T>(model);
        (at.y[0], at.y[1]) = (value, model.motion().speed);
        (at.past.joints[0], at.past.grounded, at.past.braking) = (Bar::Forward, false, Braking::LIFTED);
        at.wind_up(&given::<T>(model).sources.fitted);
        put::<T>(model, &at);
        if let Some(begun) = self.begun {
            T::put_laws(known::<T>(model), begun);
        }
        self.ahead.restart(&at.y);
        Ok(())
    }

    fn start(&mut self, model: &mut Standing) -> Result<(), Fault> {
        let now = given::<T>(model).sources;
        if let Some(inputs) = now.inputs.filter(|_| now.wound.is_some()) {
            // What is commanded at the start was so before.
            let (oil, slews, gives) = (now.fitted.oil, now.fitted.slewing.is_some(), now.give.is_some());
            let mut at = at::<T>(model);
            at.wind(inputs.hoist.speed, [oil, slews, gives]);
            put::<T>(model, &at);
            self.ahead.restart(&at.y);
        }
        self.brake(model, model.time(), true);
        self.hold(model)?;
        self.update(model)
    }

    fn update(&mut self, model: &mut Standing) -> Result<(), Fault> {
        self.decide(model)?;
        model.update()?;
        whole::<T>(model)
    }

    fn event(&mut self, model: &mut Standing) -> Result<bool, Fault> {
        let jumped = self.decide(model)?;
        whole::<T>(model)?;
        Ok(jumped)
    }

    fn warning(&self) -> Option<&'static str> {
        warning(self.ahead.least_pressure())
    }

    /// Which way a joint or a drum goes is decided again: it did not turn round, it was set. A taut rope is as long as the
    /// load is far.
    fn changed(&mut self, model: &mut Standing, which: Option<usize>) {
        let set = which.map(|index| (model.variables()[index].symbol, model.variables()[index].role));
        if set.is_some_and(shifts) {
            lift::<T>(model);
        }
        if set.is_some_and(|(_, role)| role != Role::State) {
            self.ahead.interrupt();
            return;
        }
        let given = given::<T>(model);
        let now = given.sources;
        if let (Some((symbol, _)), Some(mut states), Some(mut past)) = (set, now.states, now.past) {
            let gives = now.give.is_some() && given.load.is_some_and(|load| load.1 != 0.0);
            if symbol == &m::L_R && now.slewed.is_none() && !gives && past.taut {
                states.0[S_Q] = states.0[L_R];
            }
            if symbol == given.omega.0 {
                past.joints[0] = Bar::Held;
            } else if symbol == &m::OMEGA_SL {
                past.joints[1] = Bar::Held;
            } else if symbol == &m::V_R && now.motor.is_some() {
                past.drum = Drum::at(0.0);
            } else if [&m::DELTA_L, &m::V_TL].contains(&symbol) {
                let slack = [DELTA_L, V_TL].iter().any(|state| states.0[*state] != 0.0);
                past.unwound = slack.then_some(Bar::Held);
            }
            T::put_past(known::<T>(model), states, past);
        }
        self.ahead.restart(&at::<T>(model).y);
    }

    fn latched(&mut self, _: &mut Standing) {
        self.ahead.interrupt();
    }

    fn step_size(&self, model: &Standing) -> f64 {
        // A thousandth of what a communication step may take: an importer sees that it goes on.
        model
            .step_size()
            .min(1e-3 * f64::from(MOST_STEPS) * longest(&given::<T>(model)))
    }

    fn longest(&self, model: &Standing) -> f64 {
        longest(&given::<T>(model))
    }

    fn count(&self) -> Count {
        self.count
    }

    fn inertia(&self, model: &mut Standing) -> Result<f64, Fault> {
        let theta = given::<T>(model).theta;
        let (level, _) = T::in_motion(known::<T>(model)).map_err(|fault| *fault)?;
        level.dynamics().inertia(theta.1).ok_or_else(|| open(&theta))
    }

    fn numbers(&self) -> Vec<f64> {
        self.ahead.numbers()
    }

    fn take(&mut self, numbers: &[f64]) -> Option<()> {
        self.ahead.take(numbers)
    }

    fn follow(&mut self, other: &dyn Carrier) {
        let other: &dyn Any = other;
        let other: &CarriedCrane<T> = other.downcast_ref().expect("the same component");
        self.ahead = other.ahead;
    }

    fn duplicate(&self) -> Box<dyn Carrier> {
        Box::new(self.clone())
    }
}

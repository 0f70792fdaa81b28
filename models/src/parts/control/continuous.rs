//! A controller that is not sampled: the law of [`SpeedControl::sample`] as its cycle goes to zero. Set point and integral of the
//! error are states. The set point goes to what is asked for at its greatest acceleration and stays there: where a command holds,
//! which acts at events only, where it goes straight from value to value, and where a place asks for a speed by what is left to
//! it, no faster than that.
//!
//! At the limit the sampled rule, by which the integral waits while the error asks for more, has three limits: it waits; it
//! falls, since the error asks for less; or it would wait and go on by turns, and then it keeps the moment that is asked for at
//! the limit (sliding, Filippov).

use crate::kernel::calc::Calc;
use crate::kernel::group::by_map;
use crate::kernel::symbol::Symbol;
use crate::parts::control::{ContinuousAxis, SpeedControl, pushes};
use crate::parts::joint::{LOOSE, above_zero};

/// How far from its limit, as a part of it, a moment may be found where an importer has located that it meets it.
const NEAR: f64 = 1e-6;

/// How far from the speed that a place asks for, as a part of the greater one and of the greatest by as much less, a set point that
/// follows it may be found.
const CLOSE: f64 = 1e-6;

/// How far from its command, as a part of it or of what it was at the last event, a set point that has followed it may be found.
const THERE: f64 = 1e-12;

/// Its states.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Regulating<C = f64> {
    pub axis: &'static ContinuousAxis,
    /// In the unit of the speed.
    pub set: C,
    /// In the unit of the place.
    pub integral: C,
}

/// What happened before.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Regime<C = f64> {
    pub axis: &'static ContinuousAxis,
    /// Command to which the set point goes, a speed or a place, as it was at the last event.
    pub target: C,
    /// Its rate, where it goes straight from value to value.
    pub slope: C,
    /// 1, −1, or where it is there 0, and of a place another number of how it follows that.
    pub way: C,
    /// How the limit has the moment: 0 within it, else a number with the sign of the moment.
    pub hold: C,
}

impl<C: Copy> Regulating<C> {
    /// The same over another scalar.
    pub fn map<D>(&self, f: &mut dyn FnMut(&'static Symbol, C) -> D) -> Regulating<D> {
        let [set, integral] = self.axis.states;
        Regulating {
            axis: self.axis,
            set: f(set, self.set),
            integral: f(integral, self.integral),
        }
    }
}

impl<C: Copy> Regime<C> {
    /// The same over another scalar.
    pub fn map<D>(&self, f: &mut dyn FnMut(&'static Symbol, C) -> D) -> Regime<D> {
        let [target, slope, way, hold] = self.axis.past;
        Regime {
            axis: self.axis,
            target: f(target, self.target),
            slope: f(slope, self.slope),
            way: f(way, self.way),
            hold: f(hold, self.hold),
        }
    }
}

by_map!(Regulating: 2);
by_map!(Regime: 4);

/// How the limit has the moment, with the sign of the moment where it does.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Hold {
    /// It is within the limit.
    Free,
    /// The integral waits.
    Waits(f64),
    /// The error asks for less: the integral goes on.
    Falls(f64),
    /// The integral keeps what is asked for at the limit.
    Stays(f64),
}

impl Hold {
    fn of(number: f64) -> Hold {
        match (number.abs(), number.signum()) {
            (1.0, sign) => Hold::Waits(sign),
            (2.0, sign) => Hold::Falls(sign),
            (3.0, sign) => Hold::Stays(sign),
            _ => Hold::Free,
        }
    }

    fn number(self) -> f64 {
        match self {
            Hold::Free => 0.0,
            Hold::Waits(sign) => sign,
            Hold::Falls(sign) => 2.0 * sign,
            Hold::Stays(sign) => 3.0 * sign,
        }
    }
}

/// What the speed that a place asks for follows from, where the set point follows it.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Approach {
    /// The greatest one.
    Fastest,
    /// From which it can stop there.
    Stops,
    /// In proportion to what is left.
    Settles,
}

impl Approach {
    fn of(number: f64) -> Option<Approach> {
        match number {
            0.0 => Some(Approach::Fastest),
            2.0 => Some(Approach::Stops),
            3.0 => Some(Approach::Settles),
            _ => None,
        }
    }

    fn number(self) -> f64 {
        match self {
            Approach::Fastest => 0.0,
            Approach::Stops => 2.0,
            Approach::Settles => 3.0,
        }
    }
}

/// What it sees: command, place and speed of its axis, and the acceleration of that.
#[derive(Clone, Copy, Debug)]
pub struct Sensed<C> {
    pub commanded: C,
    pub place: C,
    pub speed: C,
    pub acceleration: C,
}

/// What it gives now.
#[derive(Clone, Copy, Debug)]
pub struct Ordered<C> {
    pub error: C,
    /// Before the limit, in N·m.
    pub asked: C,
    /// In N·m.
    pub moment: C,
}

impl Regulating {
    /// With a set point and no moment yet, and that nothing has happened.
    #[must_use]
    pub fn steady(control: &SpeedControl, set: f64) -> (Regulating, Regime) {
        let axis = control.axis.continuous[usize::from(control.approach.is_some())];
        let state = Regulating {
            axis,
            set,
            integral: 0.0,
        };
        let past = Regime {
            axis,
            target: set,
            slope: 0.0,
            way: 0.0,
            hold: 0.0,
        };
        (state, past)
    }
}

impl<C: Calc> SpeedControl<C> {
    /// e = v_s − v, M_a = K_p e + K_i ∫e dt, M within ±M_max.
    pub fn order(&self, state: &Regulating<C>, past: &Regime<C>, speed: C) -> Ordered<C> {
        let [e, m_a] = state.axis.law;
        let error = self.error(state.set, speed).def(e);
        let asked = self.asked(error, self.gains[1] * state.integral).def(m_a);
        let moment = match Hold::of(past.hold.value()) {
            Hold::Free => asked.over(self.limit),
            Hold::Waits(sign) | Hold::Falls(sign) | Hold::Stays(sign) => (C::constant(sign) * self.limit).over(asked),
        };
        Ordered { error, asked, moment }
    }

    /// Rate of the set point.
    fn moves(&self, past: &Regime<C>, seen: &Sensed<C>) -> C {
        match (past.way.value(), self.approach) {
            (way, Some(approach)) if Approach::of(way).is_some() => self.follows(approach, way, past.slope, seen),
            (0.0, _) if past.slope.value() == 0.0 => C::constant(0.0),
            (0.0, _) => past.slope,
            (way, _) => C::constant(way) * self.ramp,
        }
    }

    /// Rate of the speed that a place asks for, by what that follows from: 0, a ė_x/|v_w| or K_x ė_x, where ė_x = ẋ_c − v.
    fn follows(&self, approach @ [k, _]: [C; 2], way: f64, slope: C, seen: &Sensed<C>) -> C {
        let wanted = self.wanted(approach, seen.commanded, seen.place);
        let closes = if slope.value() == 0.0 {
            -seen.speed
        } else {
            slope - seen.speed
        };
        match Approach::of(way) {
            Some(Approach::Stops) => self.ramp * closes / wanted.abs(),
            Some(Approach::Settles) => k * closes,
            _ => C::constant(0.0),
        }
    }

    /// How far what a followed speed follows from is below what else limits it, and its rate below the ramp: the lesser part.
    fn follows_on(&self, approach @ [k, most]: [C; 2], way: f64, slope: C, seen: &Sensed<C>) -> C {
        let far = (seen.commanded - seen.place).abs();
        let (near, stops) = (k * far, (C::constant(2.0) * self.ramp * far).sqrt());
        let lesser = |a: C, b: C| if b.value() < a.value() { b } else { a };
        let room = match Approach::of(way) {
            Some(Approach::Settles) => lesser(stops, most) - near,
            Some(Approach::Stops) => lesser(near, most) - stops,
            _ => lesser(near, stops) - most,
        };
        let quick = self.ramp - self.follows(approach, way, slope, seen).abs();
        lesser(room / most, quick / self.ramp)
    }

    /// Rate of the error, where what it regulates has an acceleration.
    fn drifts(&self, past: &Regime<C>, seen: &Sensed<C>) -> C {
        self.error(self.moves(past, seen), seen.acceleration)
    }

    /// Rates of set point and integral: ±a, or that of what is asked for; e, or 0 where it waits, or −K_p ė/K_i where it keeps the
    /// moment at the limit.
    pub fn winding(&self, past: &Regime<C>, ordered: &Ordered<C>, seen: &Sensed<C>) -> [C; 2] {
        let [proportional, integral] = self.gains;
        let grows = match Hold::of(past.hold.value()) {
            Hold::Free | Hold::Falls(_) => ordered.error,
            Hold::Waits(_) => C::constant(0.0),
            Hold::Stays(_) => -(proportional / integral) * self.drifts(past, seen),
        };
        [self.moves(past, seen), grows]
    }

    /// Fall below zero where the set point is at what is asked for (or the command is another) or cannot follow that as it did, the
    /// moment meets or leaves its limit, and where what the integral does there ends otherwise.
    pub fn regulates_until(
        &self,
        state: &Regulating<C>,
        past: &Regime<C>,
        ordered: &Ordered<C>,
        seen: &Sensed<C>,
    ) -> [C; 3] {
        let one = C::constant(1.0);
        let ramp = match (past.way.value(), self.approach) {
            _ if past.slope.value() == 0.0 && seen.commanded.value() != past.target.value() => -one,
            (way, Some(approach)) if Approach::of(way).is_some() => self.follows_on(approach, way, past.slope, seen),
            (way, Some(approach)) => C::constant(way) * (self.wanted(approach, seen.commanded, seen.place) - state.set),
            (0.0, None) => one,
            (way, None) => C::constant(way) * (seen.commanded - state.set),
        };
        let [limit, wind] = match Hold::of(past.hold.value()) {
            Hold::Free => [self.limit - ordered.asked, self.limit + ordered.asked],
            Hold::Waits(sign) => {
                let sign = C::constant(sign);
                [sign * ordered.asked - self.limit, sign * ordered.error]
            }
            Hold::Falls(sign) => {
                let sign = C::constant(sign);
                [sign * ordered.asked - self.limit, -(sign * ordered.error)]
            }
            Hold::Stays(sign) => {
                let (sign, drift) = (C::constant(sign), self.drifts(past, seen));
                let freely = self.gains[0] * drift + self.gains[1] * ordered.error;
                [sign * freely, -(sign * drift)]
            }
        };
        [ramp, limit, wind].map(above_zero)
    }
}

impl SpeedControl {
    /// What follows at an event: where the set point goes, and how the limit has the moment. A state that is located where it
    /// meets something is put there.
    #[must_use]
    pub fn decided(&self, (state, past): (Regulating, Regime), seen: &Sensed<f64>) -> (Regulating, Regime) {
        let (mut state, mut past) = (state, past);
        match self.approach {
            Some(approach) => self.approaches(approach, &mut state, &mut past, seen),
            None => self.goes(&mut state, &mut past, seen.commanded),
        }
        let ordered = self.order(&state, &past, seen.speed);
        let (hold, to) = self.held(Hold::of(past.hold), &ordered, self.drifts(&past, seen));
        past.hold = hold.number();
        if let Some(moment) = to {
            state.integral = (moment - self.gains[0] * ordered.error) / self.gains[1];
        }
        (state, past)
    }

    /// Where the set point goes that a place asks for: there, at its greatest acceleration; then with it, as long as that changes
    /// no faster.
    fn approaches(
        &self,
        approach @ [k, most]: [f64; 2],
        state: &mut Regulating,
        past: &mut Regime,
        seen: &Sensed<f64>,
    ) {
        let wanted = self.wanted(approach, seen.commanded, seen.place);
        let left = wanted - state.set;
        past.target = seen.commanded;
        past.way = way(left);
        if left.abs() > CLOSE * wanted.abs().max(state.set.abs()).max(CLOSE * most) {
            return;
        }
        state.set = wanted;
        let far = (seen.commanded - seen.place).abs();
        let stops = (2.0 * self.ramp * far).sqrt();
        let follows = match (k * far, stops) {
            (near, stops) if near <= stops && near <= most => Approach::Settles,
            (_, stops) if stops <= most => Approach::Stops,
            _ => Approach::Fastest,
        };
        let rate = self.follows(approach, follows.number(), past.slope, seen);
        past.way = if rate.abs() > self.ramp {
            way(rate)
        } else {
            follows.number()
        };
    }

    /// Where the set point goes that a speed is commanded to.
    fn goes(&self, state: &mut Regulating, past: &mut Regime, commanded: f64) {
        let (left, steady) = (commanded - state.set, past.slope == 0.0);
        let other = steady && commanded != past.target;
        let size = commanded.abs().max(state.set.abs()).max(past.target.abs());
        let there = match past.way {
            0.0 => left.abs() <= THERE * size,
            way => way * left <= 0.0 && !other,
        };
        past.target = commanded;
        if there {
            state.set = commanded;
            past.way = if past.slope.abs() > self.ramp {
                way(past.slope)
            } else {
                0.0
            };
        } else if other || past.way == 0.0 {
            past.way = way(left);
        }
    }

    /// How the limit has the moment after it was had so, under a rate of the error; and the moment to put it at, if any.
    fn held(&self, before: Hold, ordered: &Ordered<f64>, drift: f64) -> (Hold, Option<f64>) {
        let Ordered { error, asked, .. } = *ordered;
        let sign = asked.signum();
        let (part, near) = (asked.abs() / self.limit, (asked.abs() / self.limit - 1.0).abs() <= NEAR);
        let outside = if pushes(asked, error) {
            Hold::Waits(sign)
        } else {
            Hold::Falls(sign)
        };
        // As it goes on where the integral waits, and where it does not.
        let rising = sign * drift > 0.0;
        let freely = sign * (self.gains[0] * drift + self.gains[1] * error) > 0.0;
        let end = sign * self.limit;
        match before {
            Hold::Stays(_) if near && freely && !rising => (before, None),
            Hold::Stays(_) if near && rising => (Hold::Waits(sign), Some(end * LOOSE)),
            Hold::Stays(_) if near => (Hold::Free, Some(end / LOOSE)),
            Hold::Waits(_) if near && part < 1.0 && rising => (before, Some(end * LOOSE)),
            Hold::Waits(_) if near && part < 1.0 && freely => (Hold::Stays(sign), Some(end)),
            Hold::Free if near && part >= 1.0 && freely && !rising && outside == Hold::Waits(sign) => {
                (Hold::Stays(sign), Some(end))
            }
            _ if part < 1.0 => (Hold::Free, None),
            _ => (outside, None),
        }
    }

    /// The shortest of J/K_p and √(J/K_i) of an inertia (kg·m²) and, to a place, 1/K_x, in s: how quick the speed is under it; `None`
    /// of one that is sampled.
    #[must_use]
    pub fn quickest(&self, inertia: f64) -> Option<f64> {
        let [proportional, integral] = self.gains;
        let settles = self.approach.map_or(f64::INFINITY, |[k, _]| 1.0 / k);
        let quickest = (inertia / proportional).min((inertia / integral).sqrt()).min(settles);
        self.cycle.is_none().then_some(quickest)
    }
}

/// Sign of a distance, 0 where there is none.
fn way(left: f64) -> f64 {
    if left == 0.0 { 0.0 } else { left.signum() }
}

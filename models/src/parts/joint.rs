//! What joints, drums and other shafts have in common that friction and brakes hold at rest.

use crate::kernel::calc::{Calc, Over};

/// A bar, a joint or a drum between events.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bar {
    Held,
    Forward,
    Backward,
    /// Moved by a cylinder: friction and stops are a part of its moment, and it never comes to rest for good.
    Loose,
}

impl Bar {
    /// After a blow that leaves it a rate: what moves may turn round.
    pub(crate) fn struck(self, rate: f64) -> Bar {
        match self {
            Bar::Forward | Bar::Backward if rate > 0.0 => Bar::Forward,
            Bar::Forward | Bar::Backward if rate < 0.0 => Bar::Backward,
            bar => bar,
        }
    }

    /// At an instant at which it has a rate, and its rate then: what has turned round is at rest, what was set in motion from
    /// outside moves, and of what is at rest it is decided again which way it goes.
    pub(crate) fn turned(self, rate: f64) -> (Bar, f64) {
        match self {
            Bar::Forward if rate < 0.0 => (Bar::Held, 0.0),
            Bar::Backward if rate > 0.0 => (Bar::Held, 0.0),
            _ if rate > 0.0 => (Bar::Forward, rate),
            _ if rate < 0.0 => (Bar::Backward, rate),
            _ => (Bar::Held, rate),
        }
    }

    /// Held by moments or forces from `least` to `most` where it needs `hold`: whether it breaks loose, and where to.
    pub(crate) fn loosened([hold, least, most]: [f64; 3]) -> Bar {
        if hold > most {
            Bar::Backward
        } else if hold < least {
            Bar::Forward
        } else {
            Bar::Held
        }
    }
}

/// What drives a joint or a drum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointDrive<P = f64> {
    /// In N·m, in the direction of the angle.
    pub moment: P,
    /// Moment that the brake adds to the dry friction, in N·m; not negative.
    pub brake: P,
}

impl JointDrive {
    /// Neither drive nor brake.
    pub const NONE: JointDrive = JointDrive {
        moment: 0.0,
        brake: 0.0,
    };

    pub(crate) fn is_sound(&self) -> bool {
        self.moment.is_finite() && self.brake >= 0.0
    }
}

/// Friction of a joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Friction<P = f64> {
    /// In N·m·s/rad.
    pub viscous: P,
    /// In N·m: it holds the joint at rest up to this moment.
    pub coulomb: P,
}

/// Luffing, slewing or another coordinate that is driven, at no particular angle.
#[derive(Clone, Copy, Debug)]
pub struct Joint<P = f64> {
    pub friction: Friction<P>,
    /// Least and greatest angle, in rad; infinite where there is no stop.
    pub stops: [f64; 2],
}

/// What follows for a joint from its angle and rate alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Arrival {
    /// It goes on as it did.
    None,
    /// At rest until now, it was set in motion from outside.
    SetOff(Bar),
    /// It has turned round, or met a stop, and is at rest.
    Rest { at_stop: bool },
}

impl<P: Copy> Joint<P> {
    /// The same over the scalar of the states.
    #[inline]
    pub(crate) fn over<C: Over<P>>(&self) -> Joint<C> {
        let Friction { viscous, coulomb } = self.friction;
        Joint {
            friction: Friction {
                viscous: C::of(viscous),
                coulomb: C::of(coulomb),
            },
            stops: self.stops,
        }
    }
}

impl<C: Calc> Joint<C> {
    /// Greatest moment of dry friction and brake, in N·m.
    fn dry(&self, drive: &JointDrive<C>) -> C {
        self.friction.coulomb + drive.brake
    }

    /// A moment (N·m) less what viscous friction at a rate (rad/s), dry friction and brake take of it.
    pub(crate) fn resisted(&self, moment: C, bar: Bar, rate: C, drive: &JointDrive<C>) -> C {
        let viscous = self.friction.viscous * rate;
        match bar {
            Bar::Held | Bar::Loose => moment,
            Bar::Forward => moment - viscous - self.dry(drive),
            Bar::Backward => moment - viscous + self.dry(drive),
        }
    }

    /// Moment of friction and brake on a joint that moves at a rate (rad/s), in N·m.
    pub(crate) fn resistance(&self, bar: Bar, rate: C, drive: &JointDrive<C>) -> C {
        let viscous = -self.friction.viscous * rate;
        match bar {
            Bar::Held | Bar::Loose => C::constant(0.0),
            Bar::Forward => viscous - self.dry(drive),
            Bar::Backward => viscous + self.dry(drive),
        }
    }

    /// Least and greatest moment that friction, brake and stops can give at rest at an angle (rad), in N·m.
    pub(crate) fn holds(&self, at: C, drive: &JointDrive<C>) -> [C; 2] {
        let (dry, without_end) = (self.dry(drive) * C::constant(LOOSE), C::constant(f64::INFINITY));
        let ([low, high], at) = (self.stops, at.value());
        [
            if at >= high { -without_end } else { -dry },
            if at <= low { without_end } else { dry },
        ]
    }

    /// Fall below zero where it comes to rest or (two) breaks loose, meets its lower or its upper stop. At rest `held` has
    /// the moment that it needs, with the least and greatest that there is.
    pub(crate) fn indicators(&self, bar: Bar, [at, rate]: [C; 2], held: impl FnOnce() -> [C; 3]) -> [C; 4] {
        let (none, [low, high]) = (C::constant(1.0), self.stops);
        let rest = match bar {
            Bar::Held => {
                let [hold, least, most] = held();
                // Where a stop gives any moment there is nothing to break.
                return [capped(most - hold), capped(hold - least), none, none];
            }
            Bar::Forward => rate,
            Bar::Backward => -rate,
            Bar::Loose => return [none; 4],
        };
        let room = |end: f64, room: C| if end.is_finite() { room } else { none };
        [
            rest,
            none,
            room(low, at - C::constant(low)),
            room(high, C::constant(high) - at),
        ]
    }

    pub(crate) fn arrival(&self, bar: Bar, [at, rate]: [f64; 2]) -> Arrival {
        let [low, high] = self.stops;
        let at_stop = (at >= high && rate > 0.0) || (at <= low && rate < 0.0);
        let turned = match bar {
            Bar::Held => rate != 0.0,
            // A joint that breaks loose is at rest: whether the rope lets go is decided as it moves.
            Bar::Forward => rate < 0.0,
            Bar::Backward => rate > 0.0,
            Bar::Loose => false,
        };
        match (bar, at_stop) {
            (Bar::Loose, _) => Arrival::None,
            (Bar::Held, false) if rate > 0.0 => Arrival::SetOff(Bar::Forward),
            (Bar::Held, false) if turned => Arrival::SetOff(Bar::Backward),
            _ if at_stop || turned => Arrival::Rest { at_stop },
            _ => Arrival::None,
        }
    }
}

/// How far beyond the greatest hold the moment must be before a bar breaks loose, and how far beyond the rope's
/// end a slack load before it is caught: rounding alone must do neither.
pub(crate) const LOOSE: f64 = 1.0 + 1e-12;

/// A greatest moment without end as the greatest number: an indicator must be finite.
pub(crate) fn capped<C: Calc>(x: C) -> C {
    if x.value() > f64::MAX { C::constant(f64::MAX) } else { x }
}

/// An indicator that an event leaves at zero, such as the rate of a bar that breaks loose, begins just above it: an
/// importer that looks at signs sees the next crossing, even where it follows within one of its steps. Every other
/// number keeps its bits.
pub(crate) fn above_zero<C: Calc>(z: C) -> C {
    z + C::constant(f64::MIN_POSITIVE)
}

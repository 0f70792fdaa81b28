//! What joints, drums and other shafts have in common that friction and brakes hold at rest.

use crate::kernel::calc::Calc;

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

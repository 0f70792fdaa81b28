//! When something is sampled.

/// Of a sample's time, as a part of the cycle: importers add up steps, and a
/// sample that is no further away than this belongs to the present time.
const SAME_TIME: f64 = 1e-6;

/// The clock of samples: they are at whole multiples of its cycle, the first one at once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clock {
    /// Number of the next sample; `None` before the first one.
    next: Option<f64>,
}

impl Clock {
    pub const STOPPED: Clock = Clock { next: None };

    /// Time of the next sample, in s; `None` where it is due at once.
    #[must_use]
    pub fn next(&self, period: f64) -> Option<f64> {
        self.next.map(|number| number * period)
    }

    /// Whether a sample is due at a time, in s.
    #[must_use]
    pub fn is_due(&self, period: f64, time: f64) -> bool {
        self.next(period).is_none_or(|next| time + SAME_TIME * period >= next)
    }

    /// Time of the next sample if it is due before a time, in s: not where it is due at that time.
    #[must_use]
    pub fn next_before(&self, period: f64, time: f64) -> Option<f64> {
        self.next(period).filter(|next| next + SAME_TIME * period < time)
    }

    /// After a sample at a time, in s.
    #[must_use]
    pub fn sampled(&self, period: f64, time: f64) -> Clock {
        let present = (time / period + SAME_TIME).floor();
        Clock {
            next: Some(self.next.map_or(present, |number| number.max(present)) + 1.0),
        }
    }

    /// As a number: infinite before the first sample.
    #[must_use]
    pub fn number(&self) -> f64 {
        self.next.unwrap_or(f64::NEG_INFINITY)
    }

    /// The clock of a number; `None` where it is that of no clock.
    #[must_use]
    pub fn of(number: f64) -> Option<Clock> {
        match number {
            f64::NEG_INFINITY => Some(Clock::STOPPED),
            _ if number.is_finite() => Some(Clock { next: Some(number) }),
            _ => None,
        }
    }
}

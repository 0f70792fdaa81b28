//! The working range of a mechanism's coordinate, and the run through it that is
//! the default experiment.

use crate::calc::Calc;

/// Working range of the coordinate, in rad and rad/s.
#[derive(Clone, Copy, Debug)]
pub struct Motion {
    pub from: f64,
    pub to: f64,
    pub step: f64,
    pub speed: f64,
}

impl Motion {
    /// The values of tables: every step from the start, and the end.
    #[must_use]
    pub fn angles(&self) -> Vec<f64> {
        let steps = ((self.to - self.from) / self.step).round().max(1.0);
        (0..=steps as u32)
            .map(|i| {
                if f64::from(i) == steps {
                    self.to
                } else {
                    self.from + f64::from(i) * self.step
                }
            })
            .collect()
    }

    /// The coordinate (rad) that runs through the working range by itself.
    #[inline]
    pub fn swept<C: Calc>(&self, omega: C, time: C) -> C {
        let theta = C::constant(self.from) + omega * time;
        // Not `clamp`: beyond an end the angle does not change any more.
        if theta.value() < self.from {
            C::constant(self.from)
        } else if theta.value() > self.to {
            C::constant(self.to)
        } else {
            theta
        }
    }

    /// Duration of one run through the working range, in s.
    #[must_use]
    pub fn stop_time(&self) -> f64 {
        nanosecond((self.to - self.from) / self.speed)
    }

    /// Time for one step of tables, in s.
    #[must_use]
    pub fn step_size(&self) -> f64 {
        nanosecond(self.step / self.speed)
    }
}

/// A time without the rounding of angles: 60 s, not 59.999999999999993 s.
fn nanosecond(time: f64) -> f64 {
    let rounded = (time * 1e9).round() / 1e9;
    if rounded > 0.0 { rounded } else { time }
}

//! The sway of a grab as it will be, calculated with its hoisting: by its equation of motion, up to where something happens.

use std::f64::consts::TAU;

use crate::kernel::calc::Calc;
use crate::kernel::course::Course;

/// Steps of a period of the sway, bisections within one, periods that a piece lasts at most.
const STEPS: f64 = 400.0;
const HALVES: u32 = 50;
const LONGEST: f64 = 4.0;

/// What is known before: ropes at the start (m), hoisting over time (m/s), gravity (m/s²); speed (m/s), acceleration (m/s²), way (m).
#[derive(Clone, Debug)]
pub struct Foreseen {
    pub length: f64,
    pub hoisting: Option<Course>,
    pub gravity: f64,
    pub told: [f64; 2],
    pub way: f64,
}

/// The load as it will be: time (s), length (m), lag (rad) and its rate (rad/s), place (m) and speed (m/s) of the trolley.
#[derive(Clone, Copy, Debug)]
pub(super) struct Instant {
    pub time: f64,
    pub y: [f64; 5],
}

pub(super) const LENGTH: usize = 0;
pub(super) const LAG: usize = 1;
pub(super) const RATE: usize = 2;
pub(super) const PLACE: usize = 3;
pub(super) const SPEED: usize = 4;

impl Foreseen {
    pub(super) fn period(&self, length: f64) -> f64 {
        TAU * (length / self.gravity).sqrt()
    }

    /// How the load is after a time (s) of an acceleration at which it hangs steadily.
    pub(super) fn held(&self, mut now: Instant, rate: f64, time: f64) -> Instant {
        let end = now.time + time;
        while now.time < end {
            now = self.step(now, rate, self.size(now).min(end - now.time));
            if end - now.time < 1e-12 * end {
                break;
            }
        }
        now
    }

    pub(super) fn coast(&self, now: Instant, time: f64) -> Instant {
        self.held(now, 0.0, time)
    }

    /// The next step, in s: none goes over a break of the hoisting.
    fn size(&self, now: Instant) -> f64 {
        let step = self.period(now.y[LENGTH]) / STEPS;
        let breaks = self.hoisting.iter().flat_map(|course| &course.rows);
        let next = breaks.map(|[time, _]| time - now.time).find(|time| *time > 1e-12);
        next.map_or(step, |next| next.min(step))
    }

    /// Goes on until something that is above zero is so no more.
    pub(super) fn until(&self, mut now: Instant, rate: f64, above: impl Fn(&Instant) -> f64) -> Option<Instant> {
        let end = now.time + LONGEST * self.period(now.y[LENGTH]);
        // At the start it may be zero.
        now = self.step(now, rate, 1e-3 * self.size(now));
        while now.time < end {
            let size = self.size(now);
            let next = self.step(now, rate, size);
            if above(&next) <= 0.0 {
                let mut within = [0.0, size];
                for _ in 0..HALVES {
                    let middle = f64::midpoint(within[0], within[1]);
                    within[usize::from(above(&self.step(now, rate, middle)) <= 0.0)] = middle;
                }
                return Some(self.step(now, rate, within[1]));
            }
            now = next;
        }
        None
    }

    /// A step of the classical Runge-Kutta method, in s. [Lagrange]
    fn step(&self, now: Instant, rate: f64, size: f64) -> Instant {
        let begun = now.time + 1e-12;
        let slopes = |time: f64, y: [f64; 5]| {
            let hoist = self.hoisting.as_ref().map_or(0.0, |course| course.at(begun, time)[0]);
            let (sin, cos) = Calc::sin_cos(y[LAG]);
            let turns = (2.0 * hoist * y[RATE] - self.gravity * sin + rate * cos) / y[LENGTH];
            [-hoist, y[RATE], turns, y[SPEED], rate]
        };
        let plus = |k: [f64; 5], part: f64| std::array::from_fn(|i| now.y[i] + part * size * k[i]);
        let k = slopes(now.time, now.y);
        let l = slopes(now.time + 0.5 * size, plus(k, 0.5));
        let m = slopes(now.time + 0.5 * size, plus(l, 0.5));
        let n = slopes(now.time + size, plus(m, 1.0));
        Instant {
            time: now.time + size,
            y: plus(std::array::from_fn(|i| (k[i] + 2.0 * (l[i] + m[i]) + n[i]) / 6.0), 1.0),
        }
    }
}

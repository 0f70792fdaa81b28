//! Commands of a way that are made by the sway that they will give, calculated before with the hoisting that goes on meanwhile.
//! [Ports001, 5.10.2, of which the contents name the angle that is calculated before; the form is derived]
//!
//! A start: accelerate until half of the steady lag is reached; coast until the lag comes to rest; go on with the acceleration
//! under which the load hangs there steadily, however long its rope gets. The end is the same backward: coast until half is left,
//! and accelerate so that lag and its rate come to zero at once. On one length these are sixths of the period.

use crate::kernel::calc::Calc;
use crate::kernel::course::{Between, Course};
use crate::sway::starts::Start;
use crate::unloader::foreseen::{Foreseen, Instant, LAG, LENGTH, PLACE, RATE, SPEED};

/// Rounds of what follows from itself.
const ROUNDS: u32 = 16;

impl Foreseen {
    /// Without programme: on, and off, at both ends of the way.
    #[must_use]
    pub fn plain(&self) -> Course {
        let [v, a] = self.told;
        both(vec![[0.0, a], [v / a, 0.0]], self.way / v)
    }

    /// By sixths of the period at the start.
    #[must_use]
    pub fn by_period(&self) -> Course {
        let start = Start::Sixths.course(self.told, self.period(self.length));
        both(start.rows, self.way / self.told[0])
    }

    /// By the angle that will be; `None` of a way that is too short for it.
    #[must_use]
    pub fn by_angle(&self) -> Option<Course> {
        let rest = Instant {
            time: 0.0,
            y: [self.length, 0.0, 0.0, 0.0, 0.0],
        };
        let (mut rows, begun) = self.start(rest)?;
        // Where the end must begin follows from the way that it takes, and that from where it begins.
        let mut goes = begun;
        let mut end = (Vec::new(), 0.0);
        for _ in 0..ROUNDS {
            let (brakes, stands) = self.start(Instant {
                y: [goes.y[LENGTH], 0.0, 0.0, 0.0, 0.0],
                ..goes
            })?;
            // Seen from a frame that goes with the speed, the end is a start backward.
            let takes = self.told[0] * (stands.time - goes.time) - stands.y[PLACE];
            end = (brakes, takes);
            let later = (self.way - begun.y[PLACE] - takes) / self.told[0];
            (later >= 0.0).then_some(())?;
            goes = self.coast(begun, later);
        }
        rows.extend(end.0.iter().map(|[time, rate]| [*time, -rate]));
        Some(steps(rows))
    }

    /// From rest to the speed: its rows, and how the load is then.
    fn start(&self, from: Instant) -> Option<(Vec<[f64; 2]>, Instant)> {
        let [v, most] = self.told;
        let mut rate = most.min(3.0 * v / self.period(from.y[LENGTH]));
        (0..ROUNDS * 4).find_map(|_| {
            let found = self.tried(from, rate);
            rate *= 0.98;
            found
        })
    }

    /// The same with its first acceleration (m/s²); `None` where that is too much for the speed.
    fn tried(&self, from: Instant, rate: f64) -> Option<(Vec<[f64; 2]>, Instant)> {
        let half = 0.5 * Calc::direction(self.gravity, rate);
        let on = self.until(from, rate, |now| half - now.y[LAG])?;
        let lags = self.until(on, 0.0, |now| now.y[RATE])?;
        let (sin, cos) = Calc::sin_cos(lags.y[LAG]);
        let steady = self.gravity * sin / cos;
        let ends = |off: Instant, last: f64| self.until(off, last, |now| -now.y[RATE]);
        let [mut held, mut last] = [0.0, rate];
        let mut found = None;
        for _ in 0..ROUNDS {
            let begins = self.held(lags, steady, held);
            let off = self.until(begins, 0.0, |now| now.y[LAG] - 0.5 * lags.y[LAG])?;
            // The last acceleration, by the rule of false position.
            let mut tries = [last, 1.02 * last];
            for _ in 0..ROUNDS {
                let [a, b] = [ends(off, tries[0])?.y[LAG], ends(off, tries[1])?.y[LAG]];
                if (a - b).abs() < 1e-15 {
                    break;
                }
                tries = [tries[1], tries[1] - b * (tries[1] - tries[0]) / (b - a)];
            }
            last = tries[1];
            let rests = ends(off, last)?;
            held += (self.told[0] - rests.y[SPEED]) / steady;
            let rows = [
                (from, rate),
                (on, 0.0),
                (lags, steady),
                (begins, 0.0),
                (off, last),
                (rests, 0.0),
            ];
            found = Some((rows.map(|(at, rate)| [at.time, rate]).to_vec(), rests));
            (held >= 0.0).then_some(())?;
        }
        found
    }
}

/// A start, and the same the other way round at a later time (s).
fn both(start: Vec<[f64; 2]>, later: f64) -> Course {
    let back = start.iter().map(|[time, rate]| [later + time, -rate]);
    steps(start.iter().copied().chain(back).collect())
}

fn steps(rows: Vec<[f64; 2]>) -> Course {
    Course {
        rows,
        between: Between::Steps,
        shaped: None,
    }
}

//! Brakes on the motor's shaft in motion: called at once, each falls on after its delay, and all are lifted at once.
//! [Ports001, 5.7]

use crate::kernel::calc::Calc;
use crate::luffing::resistances::given::{CaseBrake, SecondBrake};

/// Command from which brakes are called.
const CALLED: f64 = 0.5;

/// Times that are no further apart than this part of the solver's longest step are one: importers add up steps.
const SAME: f64 = 1e-9;

/// Delays of the brakes, in s, the first one first, and the time (s) that is one with another.
#[derive(Clone, Copy, Debug)]
pub struct Delays {
    of: [Option<f64>; 2],
    near: f64,
}

impl Delays {
    /// Of a solver whose longest step is known, in s.
    pub fn new(brake: &Option<CaseBrake<f64>>, second: &Option<SecondBrake<f64>>, longest: f64) -> Delays {
        Delays {
            of: [brake.map(|brake| brake.delay), second.map(|brake| brake.delay)],
            near: SAME * longest,
        }
    }

    /// How many of them have fallen on a time (s) after they were called.
    fn acting(&self, after: f64) -> u8 {
        let fallen = |delay: &&f64| **delay <= after + self.near;
        self.of.iter().flatten().filter(fallen).count() as u8
    }

    /// The longest, in s.
    fn longest(&self) -> f64 {
        self.of.iter().flatten().fold(0.0, |a, b| a.max(*b))
    }
}

/// When brakes were called, in s, and how many act.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Braking {
    called: Option<f64>,
    acting: u8,
}

impl Braking {
    pub const LIFTED: Braking = Braking {
        called: None,
        acting: 0,
    };

    /// All act, each of which was called long before.
    pub const ON: Braking = Braking {
        called: Some(0.0),
        acting: 2,
    };

    /// Under a command at a time (s): those that act do so until they are lifted.
    #[must_use]
    pub fn decided(self, command: f64, delays: &Delays, time: f64) -> Braking {
        if command < CALLED {
            return Braking::LIFTED;
        }
        let called = self.called.unwrap_or(time);
        Braking {
            called: Some(called),
            acting: self.acting.max(delays.acting(time - called)),
        }
    }

    /// As commanded at a time (s), which was so before.
    #[must_use]
    pub fn before(command: f64, delays: &Delays, time: f64) -> Braking {
        Braking::LIFTED
            .decided(command, delays, time - delays.longest())
            .decided(command, delays, time)
    }

    /// When the next one falls on, in s, after a time.
    #[must_use]
    pub fn next(&self, delays: &Delays, time: f64) -> Option<f64> {
        let called = self.called?;
        let waits = delays.of.iter().flatten().skip(usize::from(self.acting));
        waits
            .map(|delay| called + delay)
            .filter(|at| *at > time + delays.near)
            .reduce(f64::min)
    }

    /// Torque of those that act, in N·m.
    pub fn torque<C: Calc>(&self, brake: &Option<CaseBrake<C>>, second: &Option<SecondBrake<C>>) -> C {
        let all = [brake.map(|brake| brake.torque), second.map(|brake| brake.torque)];
        let acting = all.into_iter().take(usize::from(self.acting)).flatten();
        acting.fold(C::constant(0.0), |sum, torque| sum + torque)
    }

    /// As numbers.
    #[must_use]
    pub fn numbers(&self) -> [f64; 2] {
        let calls = if self.called.is_some() { 1.0 } else { 0.0 };
        [self.called.unwrap_or(0.0), calls + f64::from(self.acting)]
    }

    /// Of numbers.
    #[must_use]
    pub fn of([called, calls]: [f64; 2]) -> Braking {
        if calls < 1.0 {
            return Braking::LIFTED;
        }
        Braking {
            called: Some(called),
            acting: (calls - 1.0).min(2.0) as u8,
        }
    }
}

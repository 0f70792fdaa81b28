//! All groups in motion: the equations of each with the solver's and the PLC's
//! state beside them. Between samples no group acts on another one, so each is
//! solved by itself, at its own steps.

use crate::parts::solver::rodas::{Run, Tolerance};
use crate::parts::solver::{Halt, System};
use crate::steering::hydraulic::{Control, STATES, Sampled, WorkingGroup};

/// First step of the solver after a change from outside, in s.
const FIRST: f64 = 1e-3;

/// Of a sample's time, as a part of the PLC's cycle: importers add up steps, and a
/// sample that is no further away than this belongs to the present time.
const SAME_TIME: f64 = 1e-6;

/// The equations of all groups, and their PLC.
#[derive(Clone, Debug)]
pub struct Groups {
    pub groups: Vec<WorkingGroup>,
    pub control: Control,
}

/// Where one group is: its states with the solver's, and what the PLC holds of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PresentGroup {
    pub run: Run<STATES>,
    pub held: Sampled,
}

/// The PLC's clock: samples are at whole multiples of its cycle, the first one at once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clock {
    /// Number of the next sample; `None` before the first one.
    next: Option<f64>,
}

impl Clock {
    pub const STOPPED: Clock = Clock { next: None };

    /// Time of the next sample, in s; `None` where it is due at once.
    #[must_use]
    pub fn next(&self, control: &Control) -> Option<f64> {
        self.next.map(|number| number * control.period)
    }

    /// Whether a sample is due at a time, in s.
    #[must_use]
    pub fn is_due(&self, control: &Control, time: f64) -> bool {
        self.next(control)
            .is_none_or(|next| time + SAME_TIME * control.period >= next)
    }

    /// Time of the next sample if it is due before a time, in s: not where it is due at that time.
    #[must_use]
    pub fn next_before(&self, control: &Control, time: f64) -> Option<f64> {
        self.next(control)
            .filter(|next| next + SAME_TIME * control.period < time)
    }

    /// After a sample at a time, in s.
    #[must_use]
    pub fn sampled(&self, control: &Control, time: f64) -> Clock {
        let present = (time / control.period + SAME_TIME).floor();
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

fn tolerance(relative: f64) -> Tolerance<STATES> {
    // Angle and rate, pressures, spool and its speed.
    let absolute = [1e-3, 1e-3, 1e5, 1e5, 1e5, 1e5, 1e-2, 1.0];
    Tolerance {
        relative,
        absolute: absolute.map(|x| relative * x),
    }
}

/// Whether states are such as a group can have: bounded numbers, and oil in both chambers.
fn possible(group: &WorkingGroup, y: &[f64; STATES]) -> bool {
    let volumes = group.cylinder.volumes(group.pose(y[0]).l);
    y[2..6].iter().all(|p| p.abs() < 1e12)
        && y[0].abs() < 1e3
        && volumes.iter().all(|v| *v > 0.0)
        && y.iter().all(|x| x.is_finite())
}

impl PresentGroup {
    #[must_use]
    pub fn new(y: [f64; STATES]) -> PresentGroup {
        PresentGroup {
            run: Run::new(y, FIRST),
            held: Sampled::default(),
        }
    }

    /// Takes over states from outside; what the solver knew ahead is dropped.
    pub fn set_states(&mut self, y: [f64; STATES]) {
        self.run = Run::new(y, FIRST);
    }

    /// To be called when an input or a parameter changes.
    pub fn interrupt(&mut self) {
        self.run.interrupt(FIRST);
    }

    /// One sample of the PLC, for the angle wanted (rad).
    pub fn sample(&mut self, group: &mut WorkingGroup, control: &Control, wanted: f64) {
        let theta = self.run.states()[0];
        let held = control.sample(&self.held, wanted, theta, group.linkage.mirrored);
        if held.command != self.held.command {
            self.run.interrupt(FIRST.min(control.period / 10.0));
        }
        self.held = held;
        group.command = held.command;
    }

    /// Moves on by a duration, in s; `longest` is the longest step (s), `relative` the solver's tolerance.
    ///
    /// # Errors
    /// See [`Halt`].
    pub fn advance(&mut self, group: &WorkingGroup, duration: f64, longest: f64, relative: f64) -> Result<(), Halt> {
        self.run.advance(group, &tolerance(relative), duration, longest)?;
        possible(group, &self.run.states()).then_some(()).ok_or(Halt::Outside)
    }

    /// All of it as numbers.
    pub fn numbers(&self) -> impl Iterator<Item = f64> + '_ {
        let Sampled { integral, command } = self.held;
        [integral, command].into_iter().chain(self.run.numbers())
    }

    /// What [`numbers`](PresentGroup::numbers) gave, and the numbers that follow it.
    #[must_use]
    pub fn of<'a>(&self, numbers: &'a [f64]) -> Option<(PresentGroup, &'a [f64])> {
        let (own, rest) = numbers.split_at_checked(self.numbers().count())?;
        let (&[integral, command], run) = own.split_first_chunk::<2>()?;
        let present = PresentGroup {
            run: Run::of(run)?,
            held: Sampled { integral, command },
        };
        own.iter().all(|x| x.is_finite()).then_some((present, rest))
    }
}

impl Groups {
    /// Rates of one group's states.
    #[must_use]
    pub fn rates(&self, group: usize, present: &PresentGroup) -> [f64; STATES] {
        let y = present.run.states();
        self.groups[group].rates(&y).unwrap_or([f64::NAN; STATES])
    }
}

//! Inputs that a scene tells over time: what they are, when they go on in another way, and how far they have been followed.

use std::sync::Arc;

use crate::component::stages::Source;
use crate::kernel::course::Course;

/// An input that changes steadily: its value at the start, and how fast it changes.
#[derive(Clone, Copy, Debug)]
pub struct Ramp {
    pub source: Source,
    pub value: f64,
    pub slope: f64,
}

impl Ramp {
    /// The same after a time, in s.
    pub(super) fn after(self, time: f64) -> Ramp {
        let value = self.value + self.slope * time;
        Ramp { value, ..self }
    }
}

/// An input that a scene tells over time: which variable it is, and where its rate stands, if anything follows from that.
#[derive(Clone)]
pub(super) struct Told {
    pub(super) source: Source,
    pub(super) index: usize,
    pub(super) rate: Option<Source>,
    pub(super) course: Course,
}

/// What is commanded over time.
#[derive(Clone)]
pub(super) struct Commands {
    pub(super) told: Arc<[Told]>,
    /// When any of them goes on in another way, in s.
    pub(super) breaks: Arc<[f64]>,
    pub(super) now: Followed,
}

/// How far commands have been followed; times in s.
#[derive(Clone)]
pub(super) struct Followed {
    /// Breaks that have passed.
    pub(super) passed: usize,
    /// Where the grid begins, its steps from there, and the time that it has reached.
    pub(super) begun: f64,
    pub(super) steps: f64,
    pub(super) time: f64,
    /// The time that is shown.
    pub(super) shown: f64,
    /// The motion at the grid's time, where another one is shown.
    pub(super) kept: Vec<f64>,
}

impl Followed {
    pub(super) const START: Followed = Followed {
        passed: 0,
        begun: 0.0,
        steps: 0.0,
        time: 0.0,
        shown: f64::NEG_INFINITY,
        kept: Vec::new(),
    };

    /// As many numbers whatever is shown; `own` are those of the motion that is shown.
    pub(super) fn numbers(&self, own: &[f64]) -> Vec<f64> {
        let displaced = f64::from(!self.kept.is_empty());
        let head = [
            self.passed as f64,
            self.begun,
            self.steps,
            self.time,
            self.shown,
            displaced,
        ];
        let kept = if self.kept.is_empty() { own } else { &self.kept };
        head.into_iter().chain(kept.iter().copied()).collect()
    }

    /// Those of a motion without these.
    pub(super) const fn count(of: usize) -> usize {
        6 + of
    }
}

impl Commands {
    /// Value and slope of each now, at a time in s, and where its rate stands.
    pub(super) fn at(&self, time: f64) -> impl Iterator<Item = (Ramp, Option<Source>)> {
        let begun = self
            .now
            .passed
            .checked_sub(1)
            .map_or(f64::NEG_INFINITY, |last| self.breaks[last]);
        self.told.iter().map(move |told| {
            let [value, slope] = told.course.at(begun, time);
            let source = told.source;
            (Ramp { source, value, slope }, told.rate)
        })
    }

    /// Time of the next break, in s.
    pub(super) fn next(&self) -> Option<f64> {
        self.breaks.get(self.now.passed).copied()
    }

    /// Takes back what [`Followed::numbers`] gave; `None` of what it cannot have given.
    pub(super) fn take(&self, numbers: &[f64]) -> Option<Followed> {
        let [passed, begun, steps, time, shown, displaced, kept @ ..] = numbers else {
            return None;
        };
        let sound = [begun, steps, time].into_iter().all(|number| number.is_finite()) && !shown.is_nan();
        (sound && (0.0..=self.breaks.len() as f64).contains(passed)).then(|| Followed {
            passed: *passed as usize,
            begun: *begun,
            steps: *steps,
            time: *time,
            shown: *shown,
            kept: if *displaced == 0.0 { Vec::new() } else { kept.to_vec() },
        })
    }

    pub(super) fn is_told(&self, index: usize) -> bool {
        self.told.iter().any(|told| told.index == index)
    }

    /// The end of the last command, in s.
    pub(super) fn end(&self) -> f64 {
        self.breaks.last().copied().unwrap_or_default()
    }
}

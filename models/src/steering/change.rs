//! What is kept of the past: where the last change of mode started.

use crate::kernel::calc::Calc;
use crate::kernel::group::Group;
use crate::kernel::symbol::Symbol;
use crate::kernel::unit::ONE;
use crate::kernel::variable::Quantity;
use crate::steering::transition::Twist;

/// Whether the model runs, before which modes are start values; since when (s), infinite while there was no change;
/// whether the axle lines met, and the motion then; angles of the groups (rad).
#[derive(Clone, Debug)]
pub struct Change(Vec<f64>);

const RUNS: usize = 0;
const SINCE: usize = 1;
const MEETS: usize = 2;
const MOTION: std::ops::Range<usize> = 3..6;

static PAST: Symbol = Symbol::new(
    "past",
    "",
    [&ONE, &ONE],
    "A number of the last change of mode.",
    "derived",
);

impl Change {
    #[must_use]
    pub fn new(groups: usize) -> Change {
        let mut numbers = vec![0.0; MOTION.end + groups];
        numbers[SINCE] = f64::INFINITY;
        Change(numbers)
    }

    /// The model runs from now on.
    pub fn run(&mut self) {
        self.0[RUNS] = 1.0;
    }

    #[must_use]
    pub fn since(&self) -> f64 {
        self.0[SINCE]
    }

    #[must_use]
    pub fn motion(&self) -> Option<Twist> {
        (self.0[MEETS] != 0.0).then(|| std::array::from_fn(|i| self.0[MOTION.start + i]))
    }

    #[must_use]
    pub fn angles(&self) -> &[f64] {
        &self.0[MOTION.end..]
    }

    /// Whether another change starts at a time, in s: of several at once the first.
    #[must_use]
    pub fn starts(&self, time: f64) -> bool {
        self.0[RUNS] != 0.0 && self.since() != time
    }

    /// Starts at a time, in s.
    pub fn start(&mut self, time: f64) {
        self.0[SINCE] = time;
    }

    /// The next change starts from these angles, with this motion where the axle lines meet.
    pub fn from(&mut self, motion: Option<Twist>, angles: impl Iterator<Item = f64>) {
        self.0[MEETS] = f64::from(motion.is_some());
        self.0[MOTION].copy_from_slice(&motion.unwrap_or_default());
        self.0[MOTION.end..]
            .iter_mut()
            .zip(angles)
            .for_each(|(slot, angle)| *slot = angle);
    }
}

impl<C: Calc> Group<C> for Change {
    type Over<D: Calc> = Change;
    const SIZE: usize = 1;
    fn map<D: Calc>(&self, f: &mut dyn FnMut(Quantity, C) -> D) -> Change {
        let numbered = (1..).zip(&self.0);
        let mapped = numbered.map(|(i, number)| f((&PAST, Some(i)), C::constant(*number)).value());
        Change(mapped.collect())
    }
    fn take(&self, place: usize) -> C {
        C::constant(self.0[place])
    }
    fn put(&mut self, place: usize, value: C) {
        self.0[place] = value.value();
    }
}

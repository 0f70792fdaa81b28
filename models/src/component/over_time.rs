//! What a book shows of quantities over time, as plain data.

use crate::component::diagram::Curve;
use crate::kernel::course::Course;
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::Quantity;

/// What can be seen of a run, frame by frame.
#[derive(Default)]
pub struct Seen {
    /// From one frame to the next, in s.
    pub step: f64,
    /// Of the coordinate first, and of what else moves the picture.
    pub values: Vec<(&'static Symbol, Vec<f64>)>,
}

/// A run through commands over time; times in s.
pub struct Cycle {
    pub commands: Vec<(&'static Symbol, Course)>,
    pub end: f64,
    /// When the model could not go on, if it could not.
    pub ended: Option<f64>,
    pub figures: Vec<CycleFigure>,
    pub seen: Seen,
    pub rows: Vec<CycleRow>,
}

/// One quantity over the time of a cycle, or two that belong together.
pub struct CycleFigure {
    /// By the id of the first symbol; of two, a numbered piece for each.
    pub curve: Curve,
    /// Each with its number among several.
    pub of: Vec<Quantity>,
}

/// Between what values a quantity lies in a cycle, and its value at the end.
pub struct CycleRow {
    pub symbol: &'static Symbol,
    /// Which one, where there are several.
    pub number: Option<u16>,
    pub ends: [Stand; 2],
    pub last: f64,
}

/// A value with its time (s) and the coordinate then.
#[derive(Clone, Copy)]
pub struct Stand {
    pub value: f64,
    pub time: f64,
    pub at: f64,
}

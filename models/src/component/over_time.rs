//! What a book shows of quantities over time, as plain data.

use crate::component::diagram::Curve;
use crate::kernel::course::Course;
use crate::kernel::symbol::Symbol;

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
    /// Over time, each by the id of its symbol, with its number among several.
    pub curves: Vec<(Curve, Option<u16>)>,
    pub seen: Seen,
    pub rows: Vec<CycleRow>,
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

//! What a mechanism looks like, as plain data.

use crate::kernel::symbol::Symbol;

/// The mechanism to scale, in metres, y upwards.
#[derive(Debug, Default)]
pub struct Drawing {
    pub shapes: Vec<Shape>,
}

/// What a quantity measures to a point.
#[derive(Clone, Copy, Debug)]
pub enum Gauge {
    /// Its distance from another point.
    Distance { from: [f64; 2] },
    /// How far it lies in a direction from another point: the length of the direction counts.
    Along { from: [f64; 2], direction: [f64; 2] },
    /// Where it is seen from another point, counter-clockwise from a direction (rad).
    Direction { from: [f64; 2], zero: f64 },
}

/// What is drawn, and what a page that moves has besides: where one may drag, and forces.
#[derive(Debug)]
pub enum Shape {
    /// A bar or a polygon of one body. `faint` for the positions beside the main one.
    Body {
        points: Vec<[f64; 2]>,
        closed: bool,
        faint: bool,
    },
    /// A pin; `fixed` where it is held by the frame.
    Pin { at: [f64; 2], fixed: bool, faint: bool },
    /// A name beside a point, in Typst's mathematics.
    Label { at: [f64; 2], text: &'static str },
    /// The path of a point.
    Path { points: Vec<[f64; 2]> },
    /// A vertical centre line through `x`.
    CentreLine { x: f64, from: f64, to: f64 },
    /// A line through a point and its axis, dash-dotted.
    Axis { from: [f64; 2], to: [f64; 2] },
    /// A motion from one point towards another.
    Arrow { from: [f64; 2], to: [f64; 2] },
    /// The number of a body.
    Number { at: [f64; 2], number: usize },
    /// A weight hanging at a point.
    Load { at: [f64; 2], text: &'static str },
    /// A distance with arrows at both ends, `offset` metres beside the line it measures.
    Distance {
        from: [f64; 2],
        to: [f64; 2],
        offset: f64,
        text: &'static str,
    },
    /// An angle at a point, counter-clockwise from `from` to `to`, in rad.
    Angle {
        at: [f64; 2],
        radius: f64,
        from: f64,
        to: f64,
        text: &'static str,
    },
    /// What only a page shows, where it is asked for: the id of its word, and the shape.
    Aside { of: &'static str, shape: Box<Shape> },
    /// A point that one may drag: quantities of the scene that place it, with what each measures to it.
    Handle {
        at: [f64; 2],
        sets: Vec<(&'static Symbol, Gauge)>,
    },
    /// A force on a body at a point: results, each in a direction.
    Force {
        at: [f64; 2],
        sum: Vec<(&'static Symbol, [f64; 2])>,
    },
}

//! What a mechanism looks like at every position: the shapes of the book's drawing, in metres, y upwards.

use lemnis_models::component::sheet::Shape;
use lemnis_models::scene::Scene;
use serde::Serialize;

use crate::answer::dragged::{Draggable, Set, sets};
use crate::answer::point::{Point, rounded};
use crate::print::script::Script;

/// A drawing at one position after the other.
#[derive(Serialize)]
pub struct Drawn {
    /// Numbers of the scene's text that handles set.
    pub numbers: Vec<Draggable>,
    /// What stands still.
    pub still: Vec<Mark>,
    /// The marks of each position, the farthest behind first.
    pub positions: Vec<Vec<Placed>>,
}

/// A mark of a position.
#[derive(Serialize)]
#[serde(untagged)]
pub enum Placed {
    /// One of those that stand still.
    Still(usize),
    Own(Mark),
}

/// A shape of the book's drawing.
#[derive(Clone, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Mark {
    Body {
        points: Vec<Point>,
        closed: bool,
        faint: bool,
    },
    Pin {
        at: Point,
        fixed: bool,
        faint: bool,
    },
    Label {
        at: Point,
        text: Script,
    },
    Path {
        points: Vec<Point>,
    },
    Line {
        from: Point,
        to: Point,
    },
    Arrow {
        from: Point,
        to: Point,
    },
    Number {
        at: Point,
        number: usize,
    },
    Load {
        at: Point,
        text: Script,
    },
    Distance {
        from: Point,
        to: Point,
        offset: f64,
        text: Script,
    },
    Angle {
        at: Point,
        radius: f64,
        from: f64,
        to: f64,
        text: Script,
    },
    /// What is shown where it is asked for, by the id of its word.
    Aside {
        of: &'static str,
        mark: Box<Mark>,
    },
    /// A point that one may drag.
    Handle {
        at: Point,
        sets: Vec<Set>,
    },
    /// A force on a body: results by their names in FMUs, each in a direction.
    Force {
        at: Point,
        sum: Vec<(&'static str, Point)>,
    },
}

impl Mark {
    /// `None` of a handle of which the scene does not give what it would set; those are added to what is known.
    fn new(scene: &Scene, shape: &Shape, numbers: &mut Vec<Draggable>) -> Option<Mark> {
        let all = |points: &[Point]| points.iter().copied().map(rounded).collect();
        let text = |text: &str| Script::of_math(text);
        Some(match shape {
            Shape::Body { points, closed, faint } => Mark::Body {
                points: all(points),
                closed: *closed,
                faint: *faint,
            },
            Shape::Pin { at, fixed, faint } => Mark::Pin {
                at: rounded(*at),
                fixed: *fixed,
                faint: *faint,
            },
            Shape::Label { at, text: name } => Mark::Label {
                at: rounded(*at),
                text: text(name),
            },
            Shape::Path { points } => Mark::Path { points: all(points) },
            Shape::CentreLine { x, from, to } => Mark::Line {
                from: rounded([*x, *from]),
                to: rounded([*x, *to]),
            },
            Shape::Axis { from, to } => Mark::Line {
                from: rounded(*from),
                to: rounded(*to),
            },
            Shape::Arrow { from, to } => Mark::Arrow {
                from: rounded(*from),
                to: rounded(*to),
            },
            Shape::Number { at, number } => Mark::Number {
                at: rounded(*at),
                number: *number,
            },
            Shape::Load { at, text: name } => Mark::Load {
                at: rounded(*at),
                text: text(name),
            },
            Shape::Distance {
                from,
                to,
                offset,
                text: name,
            } => Mark::Distance {
                from: rounded(*from),
                to: rounded(*to),
                offset: *offset,
                text: text(name),
            },
            Shape::Angle {
                at,
                radius,
                from,
                to,
                text: name,
            } => Mark::Angle {
                at: rounded(*at),
                radius: *radius,
                from: *from,
                to: *to,
                text: text(name),
            },
            Shape::Aside { of, shape } => Mark::Aside {
                of,
                mark: Box::new(Mark::new(scene, shape, numbers)?),
            },
            Shape::Handle { at, sets: wanted } => Mark::Handle {
                at: rounded(*at),
                sets: sets(scene, wanted, numbers)?,
            },
            Shape::Force { at, sum } => Mark::Force {
                at: rounded(*at),
                sum: sum.iter().map(|(symbol, direction)| (symbol.id, *direction)).collect(),
            },
        })
    }
}

impl Drawn {
    /// At values of the coordinate in its working range, in SI.
    #[must_use]
    pub fn new(scene: &Scene, positions: impl Iterator<Item = f64>) -> Drawn {
        let mut numbers = Vec::new();
        let marks = |at: f64| -> Vec<Mark> {
            let drawing = scene.drawing(at);
            let marks = drawing
                .shapes
                .iter()
                .filter_map(|shape| Mark::new(scene, shape, &mut numbers));
            marks.collect()
        };
        let all: Vec<Vec<Mark>> = positions.map(marks).collect();
        let mut still: Vec<Mark> = all.first().cloned().unwrap_or_default();
        for marks in &all {
            still.retain(|mark| marks.contains(mark));
        }
        let placed = |mark: Mark| match still.iter().position(|known| *known == mark) {
            Some(place) => Placed::Still(place),
            None => Placed::Own(mark),
        };
        let positions = all.into_iter().map(|marks| marks.into_iter().map(placed).collect());
        Drawn {
            positions: positions.collect(),
            still,
            numbers,
        }
    }
}

//! Drawings of mechanisms, to scale and in m.

use crate::component::sheet::{Drawing, Gauge, Shape};
use crate::kernel::calc::Calc;
use crate::kernel::symbol::Symbol;
use crate::parts::plane::{Point, cross};

/// A drawing that grows. What is `faint` stands behind what is told.
#[derive(Default)]
pub struct Draw {
    shapes: Vec<Shape>,
}

/// At a distance (m) in a direction (rad).
#[must_use]
pub fn polar(distance: f64, direction: f64) -> Point<f64> {
    let (sin, cos) = Calc::sin_cos(direction);
    Point::new(distance * cos, distance * sin)
}

fn array(point: Point<f64>) -> [f64; 2] {
    [point.x, point.y]
}

/// Its distance from a point sets what is dragged.
#[must_use]
pub fn distance(from: Point<f64>) -> Gauge {
    Gauge::Distance { from: array(from) }
}

/// How far it lies in a direction from a point does.
#[must_use]
pub fn along(from: Point<f64>, direction: [f64; 2]) -> Gauge {
    Gauge::Along {
        from: array(from),
        direction,
    }
}

/// Where it is seen from a point does, counter-clockwise from a direction (rad).
#[must_use]
pub fn direction(from: Point<f64>, zero: f64) -> Gauge {
    Gauge::Direction {
        from: array(from),
        zero,
    }
}

impl Draw {
    fn points(&mut self, points: &[Point<f64>], closed: bool, faint: bool) {
        let points = points.iter().copied().map(array).collect();
        self.shapes.push(Shape::Body { points, closed, faint });
    }

    pub fn bar(&mut self, points: &[Point<f64>], faint: bool) {
        self.points(points, false, faint);
    }

    pub fn body(&mut self, points: &[Point<f64>], faint: bool) {
        self.points(points, true, faint);
    }

    pub fn path(&mut self, points: impl Iterator<Item = Point<f64>>) {
        let points = points.map(array).collect();
        self.shapes.push(Shape::Path { points });
    }

    pub fn pin(&mut self, at: Point<f64>, fixed: bool, faint: bool) {
        let at = array(at);
        self.shapes.push(Shape::Pin { at, fixed, faint });
    }

    pub fn label(&mut self, at: Point<f64>, text: &'static str) {
        self.shapes.push(Shape::Label { at: array(at), text });
    }

    /// A joint with its name.
    pub fn joint(&mut self, at: Point<f64>, text: &'static str, fixed: bool, faint: bool) {
        self.pin(at, fixed, faint);
        if !faint {
            self.label(at, text);
        }
    }

    /// From a bar that goes from the origin to `head`, square to it, to a joint beside it.
    pub fn lug(&mut self, head: Point<f64>, joint: Point<f64>, faint: bool) {
        let foot = head * (joint.dot(&head) / head.norm_squared());
        self.bar(&[joint, foot], faint);
    }

    /// A square around a weight, with its name.
    pub fn weight(&mut self, at: Point<f64>, text: &'static str, faint: bool) {
        const HALF: f64 = 0.6;
        let corner = |x: f64, y: f64| at + Point::new(x * HALF, y * HALF);
        let corners = [
            corner(-1.0, -1.0),
            corner(1.0, -1.0),
            corner(1.0, 1.0),
            corner(-1.0, 1.0),
        ];
        self.body(&corners, faint);
        if !faint {
            self.label(corner(-1.0, -1.0), text);
        }
    }

    pub fn load(&mut self, at: Point<f64>, symbol: &'static Symbol) {
        let (at, text) = (array(at), symbol.print);
        self.shapes.push(Shape::Load { at, text });
    }

    /// An angle from the horizontal, in rad.
    pub fn angle(&mut self, at: Point<f64>, radius: f64, to: f64, symbol: &'static Symbol) {
        self.shapes.push(Shape::Angle {
            at: array(at),
            radius,
            from: 0.0,
            to,
            text: symbol.print,
        });
    }

    /// Measured `offset` metres beside the line from one point to the other.
    pub fn distance(&mut self, from: Point<f64>, to: Point<f64>, offset: f64, symbol: &'static Symbol) {
        self.shapes.push(Shape::Distance {
            from: array(from),
            to: array(to),
            offset,
            text: symbol.print,
        });
    }

    /// A motion.
    pub fn arrow(&mut self, from: Point<f64>, to: Point<f64>) {
        let [from, to] = [from, to].map(array);
        self.shapes.push(Shape::Arrow { from, to });
    }

    /// A line to an axis, or along it.
    pub fn line(&mut self, from: Point<f64>, to: Point<f64>) {
        let [from, to] = [from, to].map(array);
        self.shapes.push(Shape::Axis { from, to });
    }

    /// The number of a body.
    pub fn number(&mut self, at: Point<f64>, number: usize) {
        self.shapes.push(Shape::Number { at: array(at), number });
    }

    /// A vertical centre line.
    pub fn axis(&mut self, x: f64, from: f64, to: f64) {
        self.shapes.push(Shape::CentreLine { x, from, to });
    }

    /// What only a page shows, where it is asked for, by the id of its word.
    fn aside(&mut self, of: &'static str, draw: impl FnOnce(&mut Draw)) {
        let mut own = Draw::default();
        draw(&mut own);
        let shapes = own.shapes.into_iter().map(Box::new);
        self.shapes.extend(shapes.map(|shape| Shape::Aside { of, shape }));
    }

    /// The instantaneous centre of what hangs on two lines, each from a point to a joint on it; none where they are
    /// parallel, or it is farther away than the mechanism's size (m) and a half.
    pub fn centre(&mut self, lines: [[Point<f64>; 2]; 2], size: f64) {
        let [[o, b], [p, c]] = lines;
        let at = o + (b - o) * (cross(p - o, c - p) / cross(b - o, c - p));
        if (at - b).norm() < 1.5 * size {
            self.aside("centre", |draw| {
                draw.line(b, at);
                draw.line(c, at);
                draw.joint(at, "P", false, false);
            });
        }
    }

    /// The acute angle between two directions at a joint, which tells how well a link is moved.
    pub fn transmission(&mut self, at: Point<f64>, [a, b]: [Point<f64>; 2], radius: f64, symbol: &'static Symbol) {
        let [from, other] = [a, b].map(|line| Calc::direction(line.x, line.y));
        let half = std::f64::consts::PI;
        let to = other - half * ((other - from) / half).round();
        let (at, text) = (array(at), symbol.print);
        self.aside("transmission", |draw| {
            draw.shapes.push(Shape::Angle {
                at,
                radius,
                from,
                to,
                text,
            });
        });
    }

    /// A bar at its dead points: from its foot, of a length (m), in these directions (rad).
    pub fn dead_points(&mut self, foot: Point<f64>, length: f64, at: impl Iterator<Item = f64>) {
        self.aside("dead_points", |draw| {
            at.for_each(|at| draw.line(foot, foot + polar(length, at)));
        });
    }

    /// A point that one may drag, and what sets it.
    pub fn handle(&mut self, at: Point<f64>, sets: &[(&'static Symbol, Gauge)]) {
        let (at, sets) = (array(at), sets.to_vec());
        self.shapes.push(Shape::Handle { at, sets });
    }

    /// One that is placed forward and upward from the origin.
    pub fn placed(&mut self, at: Point<f64>, [x, y]: [&'static Symbol; 2]) {
        let axis = |symbol, direction| (symbol, along(Point::zeros(), direction));
        self.handle(at, &[axis(x, [1.0, 0.0]), axis(y, [0.0, 1.0])]);
    }

    /// A force by its components, forward and upward.
    pub fn force(&mut self, at: Point<f64>, [x, y]: [&'static Symbol; 2]) {
        let (at, sum) = (array(at), vec![(x, [1.0, 0.0]), (y, [0.0, 1.0])]);
        self.shapes.push(Shape::Force { at, sum });
    }

    /// A force towards another point, where it is positive.
    pub fn pull(&mut self, at: Point<f64>, towards: Point<f64>, symbol: &'static Symbol) {
        let (line, at) = (towards - at, array(at));
        if line.norm() > 0.0 {
            let sum = vec![(symbol, array(line / line.norm()))];
            self.shapes.push(Shape::Force { at, sum });
        }
    }

    /// Of a mechanism of about this size, in m: a distance that cannot be told from nothing is left out.
    #[must_use]
    pub fn done(mut self, size: f64) -> Drawing {
        self.shapes.retain(|shape| match shape {
            Shape::Distance { from, to, .. } => (to[0] - from[0]).abs() + (to[1] - from[1]).abs() > 0.02 * size,
            _ => true,
        });
        Drawing { shapes: self.shapes }
    }
}

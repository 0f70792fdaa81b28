//! Pictures as display lists: lines, circles and texts in millimetres of the
//! page, y downwards, for a template to draw.

use serde::Serialize;

pub(super) type Point = [f64; 2];

/// A picture in millimetres.
#[derive(Debug, Serialize)]
pub struct Picture {
    pub width: f64,
    pub height: f64,
    /// The picture is 1 : `scale`; 0 where it is not to scale.
    pub scale: u32,
    pub(super) items: Vec<Item>,
}

/// Styles and anchors are the template's words for stroke, fill and alignment.
#[derive(Debug, Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub(super) enum Item {
    /// Paths of the same style, all closed or all open.
    Line {
        paths: Vec<Vec<Point>>,
        closed: bool,
        style: &'static str,
    },
    Circle {
        at: Point,
        radius: f64,
        style: &'static str,
    },
    /// In Typst's mathematics.
    Text {
        at: Point,
        anchor: &'static str,
        text: String,
    },
    /// As it is: what needs no mathematics takes a third of the time.
    Number {
        at: Point,
        anchor: &'static str,
        text: String,
    },
}

impl Picture {
    pub(super) fn new([width, height]: Point, scale: u32) -> Picture {
        Picture {
            width,
            height,
            scale,
            items: Vec::new(),
        }
    }

    /// As the template reads it.
    pub(crate) fn json(&self) -> String {
        serde_json::to_string(self).expect("a picture is plain data")
    }

    pub(super) fn line(&mut self, style: &'static str, points: &[Point]) {
        self.shape(style, points, false);
    }

    pub(super) fn shape(&mut self, style: &'static str, points: &[Point], closed: bool) {
        let mut path = Vec::new();
        path.extend(points.first());
        bends(points, &mut path);
        let path = path.into_iter().map(|point| point.map(hundredths)).collect();
        match self.items.last_mut() {
            Some(Item::Line {
                paths,
                closed: before,
                style: last,
            }) if *before == closed && *last == style => paths.push(path),
            _ => self.items.push(Item::Line {
                paths: vec![path],
                closed,
                style,
            }),
        }
    }

    pub(super) fn circle(&mut self, style: &'static str, at: Point, radius: f64) {
        self.items.push(Item::Circle {
            at: at.map(hundredths),
            radius,
            style,
        });
    }

    pub(super) fn text(&mut self, at: Point, anchor: &'static str, text: impl Into<String>) {
        self.put(
            |at, anchor, text| Item::Text { at, anchor, text },
            at,
            anchor,
            text.into(),
        );
    }

    pub(super) fn number(&mut self, at: Point, anchor: &'static str, text: String) {
        self.put(|at, anchor, text| Item::Number { at, anchor, text }, at, anchor, text);
    }

    pub(super) fn put(
        &mut self,
        item: fn(Point, &'static str, String) -> Item,
        at: Point,
        anchor: &'static str,
        text: String,
    ) {
        self.items.push(item(at.map(hundredths), anchor, text));
    }

    /// A slender arrow head with its tip at `tip`, pointing away from `from`.
    pub(super) fn arrow(&mut self, from: Point, tip: Point) {
        let [x, y] = unit(from, tip);
        let corner = |side: f64| [tip[0] - 2.4 * x - 0.45 * side * y, tip[1] - 2.4 * y + 0.45 * side * x];
        self.shape("solid", &[tip, corner(1.0), corner(-1.0)], true);
    }
}

/// How far a line may run from the points that it is drawn through, in mm: a fifth of the thinnest stroke.
const FLAT: f64 = 0.02;

/// Those of the points behind the first one through which a line must be drawn to stay within [`FLAT`] of all: the last
/// one, and where it is too far from a straight line the one farthest from it, so on both sides of that
/// [Douglas and Peucker 1973].
fn bends(points: &[Point], kept: &mut Vec<Point>) {
    let (&[from, .., to], true) = (points, points.len() > 1) else {
        return;
    };
    let [x, y] = unit(from, to);
    let off = |[px, py]: Point| {
        let [dx, dy] = [px - from[0], py - from[1]];
        let along = (dx * x + dy * y).clamp(0.0, length([to[0] - from[0], to[1] - from[1]]));
        length([dx - along * x, dy - along * y])
    };
    let far = points.iter().map(|&point| off(point)).enumerate();
    match far.max_by(|a, b| a.1.total_cmp(&b.1)) {
        Some((i, far)) if far > FLAT => {
            bends(&points[..=i], kept);
            bends(&points[i..], kept);
        }
        _ => kept.push(to),
    }
}

pub(super) fn hundredths(x: f64) -> f64 {
    (x * 100.0).round() / 100.0
}

pub(super) fn length([x, y]: Point) -> f64 {
    (x * x + y * y).sqrt()
}

/// Direction from one point to another; straight up where they coincide.
pub(super) fn unit(from: Point, to: Point) -> Point {
    let d = [to[0] - from[0], to[1] - from[1]];
    match length(d) {
        l if l > 1e-9 => [d[0] / l, d[1] / l],
        _ => [0.0, -1.0],
    }
}

//! Labels of pictures, each where it meets nothing that is drawn.

use std::f64::consts::{FRAC_PI_2, PI};

use lemnis_models::kernel::calc::Calc;

use crate::print::picture::{Item, Picture, Point};
use crate::print::width;

/// A digit in a picture, in mm, and half the height of a number, of one with a comma below its line, and of a symbol with its
/// index.
const DIGIT: f64 = 1.5;
const LOW: f64 = 1.1;
const COMMA: f64 = 1.35;
const HIGH: f64 = 1.6;
/// The room that a label has around it where there is some.
const AIR: f64 = 0.5;
/// What it costs to touch something, where a hundred things nearby are as bad.
const TOUCHED: usize = 100;

/// What is written, and the half of its width and height.
pub(super) struct Label {
    item: fn(Point, &'static str, String) -> Item,
    text: String,
    pub half: Point,
}

impl Label {
    /// As it is.
    pub fn plain(text: impl Into<String>) -> Label {
        let text = text.into();
        let half = half(&text, false);
        let item = |at, anchor, text| Item::Number { at, anchor, text };
        Label { item, text, half }
    }

    /// In Typst's mathematics.
    pub fn symbol(text: &str) -> Label {
        let item = |at, anchor, text| Item::Text { at, anchor, text };
        let (text, half) = (text.to_owned(), half(text, true));
        Label { item, text, half }
    }

    /// In a direction from a point, so far from it.
    pub fn beside(&self, [x, y]: Point, [right, down]: Point, gap: f64) -> Point {
        let far = gap + self.half[0] * right.abs() + self.half[1] * down.abs();
        [x + far * right, y + far * down]
    }

    /// Around a point, the nearest places first, and above it (or below) before aside.
    pub fn around(&self, at: Point, below: bool) -> Vec<Point> {
        let gaps = [1.4, 2.2, 3.2, 4.4, 6.0, 8.0, 11.0];
        let sides = (0..16).map(|i| f64::from((i + 1) / 2 * if i % 2 == 0 { 1 } else { -1 }));
        let sides: Vec<Point> = sides
            .map(|i| {
                let (sin, cos) = Calc::sin_cos(FRAC_PI_2 + PI / 8.0 * i);
                [cos, if below { sin } else { -sin }]
            })
            .collect();
        let ring = |gap: f64| sides.iter().map(move |side| self.beside(at, *side, gap));
        gaps.into_iter().flat_map(ring).collect()
    }
}

/// Half of the width and height of a text, estimated, in mm.
fn half(text: &str, symbol: bool) -> Point {
    if !symbol {
        let digits = |c: char| match c {
            '.' | ',' | ' ' => 0.6,
            '\u{2212}' | 'm' => 1.7,
            _ => 1.05,
        };
        let high = if text.contains(',') { COMMA } else { LOW };
        return [DIGIT / 2.0 * text.chars().map(digits).sum::<f64>(), high];
    }
    let (name, unit) = text.split_once(" thin \"/\" thin ").unwrap_or((text, ""));
    let unit = unit.trim_matches('"').chars().count() as f64;
    let unit = if unit > 0.0 { 1.8 + 1.35 * unit } else { 0.0 };
    [DIGIT / 2.0 * (1.35 * width::name(name) + 0.6 + unit), HIGH]
}

/// What a label may meet.
enum Obstacle {
    Line(Point, Point),
    Box { centre: Point, half: Point },
}

impl Obstacle {
    fn meets(&self, at: Point, half: Point) -> bool {
        match *self {
            Obstacle::Box { centre, half: other } => {
                (0..2).all(|axis| (at[axis] - centre[axis]).abs() < half[axis] + other[axis])
            }
            Obstacle::Line(from, to) => {
                // The part of the line that lies within both widths.
                let mut part: Point = [0.0, 1.0];
                for axis in 0..2 {
                    let (start, way) = (from[axis] - at[axis], to[axis] - from[axis]);
                    if way == 0.0 {
                        if start.abs() >= half[axis] {
                            return false;
                        }
                        continue;
                    }
                    let ends = [-half[axis], half[axis]].map(|edge| (edge - start) / way);
                    part = [part[0].max(ends[0].min(ends[1])), part[1].min(ends[0].max(ends[1]))];
                }
                part[0] < part[1]
            }
        }
    }
}

/// What an item bars; a grid lies behind all labels.
fn obstacles(item: &Item) -> Vec<Obstacle> {
    match item {
        Item::Line { style: "grid", .. } => Vec::new(),
        Item::Line { paths, closed, .. } => {
            let last = |path: &Vec<Point>| closed.then(|| Obstacle::Line(path[path.len() - 1], path[0]));
            let lines = |path: &Vec<Point>| {
                let lines = path.windows(2).map(|ends| Obstacle::Line(ends[0], ends[1]));
                lines.chain(last(path)).collect::<Vec<_>>()
            };
            paths.iter().flat_map(lines).collect()
        }
        Item::Circle { at, radius, .. } => vec![Obstacle::Box {
            centre: *at,
            half: [*radius; 2],
        }],
        Item::Text { at, anchor, text } => vec![written(*at, anchor, half(text, true))],
        Item::Number { at, anchor, text } => vec![written(*at, anchor, half(text, false))],
    }
}

fn written([x, y]: Point, anchor: &str, half: Point) -> Obstacle {
    let centre = match anchor {
        "left" => [x + half[0], y],
        "right" => [x - half[0], y],
        "above" => [x, y + half[1]],
        _ => [x, y],
    };
    Obstacle::Box { centre, half }
}

impl Picture {
    /// Writes a text at the first of the places where it meets nothing, or where it meets least.
    pub(super) fn label(&mut self, label: Label, places: &[Point]) {
        let (_, at) = self.room(&label, places);
        self.put(label.item, at, "centre", label.text);
    }

    /// Writes a text that stands in a table too, where there is room for it.
    pub(super) fn label_if_room(&mut self, label: Label, places: &[Point]) {
        if let (true, at) = self.room(&label, places) {
            self.put(label.item, at, "centre", label.text);
        }
    }

    /// The first of the places where a label meets nothing, or where it meets least; and whether it touches nothing there.
    fn room(&self, label: &Label, places: &[Point]) -> (bool, Point) {
        let half = label.half;
        let airy = half.map(|half| half + AIR);
        let ends = |axis: usize| {
            let along = || places.iter().map(move |place| place[axis]);
            [
                along().fold(f64::INFINITY, f64::min),
                along().fold(f64::NEG_INFINITY, f64::max),
            ]
        };
        let reach = [ends(0), ends(1)];
        let middle = reach.map(|[low, high]| f64::midpoint(low, high));
        let within = [0, 1].map(|axis| (reach[axis][1] - reach[axis][0]) / 2.0 + airy[axis]);
        let near = self.items.iter().flat_map(obstacles);
        let near: Vec<Obstacle> = near.filter(|obstacle| obstacle.meets(middle, within)).collect();
        let size = [self.width, self.height];
        let cost = |place: Point| {
            let outside = (0..2).any(|axis| place[axis] < half[axis] || place[axis] > size[axis] - half[axis]);
            let met = near.iter().filter(|obstacle| obstacle.meets(place, airy));
            let met = met.map(|obstacle| if obstacle.meets(place, half) { TOUCHED } else { 1 });
            met.sum::<usize>() + if outside { 10 * TOUCHED } else { 0 }
        };
        let mut best = (usize::MAX, [0.0; 2]);
        for &place in places {
            let cost = cost(place);
            if cost < best.0 {
                best = (cost, place);
            }
            if cost == 0 {
                break;
            }
        }
        (best.0 < TOUCHED, best.1)
    }

    /// Writes a text to the right of a place.
    pub(super) fn label_at(&mut self, label: Label, at: Point) {
        self.put(label.item, at, "left", label.text);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_label_keeps_clear_of_lines_and_of_other_labels() {
        let mut picture = Picture::new([40.0, 40.0], 0);
        picture.line("thin", &[[0.0, 17.0], [40.0, 17.0]]);
        let label = || Label::plain("12");
        let places = label().around([20.0, 20.0], false);
        picture.label(label(), &places);
        picture.label(label(), &places);
        let [Item::Number { at: first, .. }, Item::Number { at: second, .. }] = picture.items[1..] else {
            panic!("two labels");
        };
        let line = Obstacle::Line([0.0, 17.0], [40.0, 17.0]);
        let half = label().half;
        assert!(!line.meets(first, half) && !line.meets(second, half));
        assert!(!Obstacle::Box { centre: first, half }.meets(second, half));
        // Above the point there is no room.
        assert!(first[1] > 18.0, "{first:?}");
    }

    #[test]
    fn a_line_meets_what_it_passes_through() {
        let meets = |from, to| Obstacle::Line(from, to).meets([0.0, 0.0], [2.0, 1.0]);
        assert!(meets([-5.0, 0.5], [5.0, 0.5]) && meets([0.0, 0.0], [0.0, 0.5]) && meets([-2.5, 0.0], [0.0, 2.0]));
        assert!(!meets([-5.0, 1.5], [5.0, 1.5]) && !meets([3.0, -5.0], [3.0, 5.0]) && !meets([-3.5, 0.0], [0.0, 3.0]));
    }
}

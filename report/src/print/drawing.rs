//! Mechanisms to scale.

use lemnis_models::component::sheet::{Drawing, Shape};
use lemnis_models::kernel::calc::Calc;

use crate::print::label::Label;
use crate::print::picture::{Picture, Point, hundredths, unit};

/// Usual scales of drawings, 1 : n.
const SCALES: [u32; 15] = [10, 15, 20, 25, 50, 75, 100, 150, 200, 250, 300, 400, 500, 750, 1000];

/// All scales, so that anything that a scene may describe fits on its page: a drawing that is larger makes Typst cut the
/// dashes of a line that is kilometres long.
fn scales() -> impl Iterator<Item = u32> {
    let next = (1..=6).flat_map(|power| SCALES[7..].iter().map(move |scale| scale * 10_u32.pow(power)));
    SCALES.into_iter().chain(next)
}

/// The smallest scale, 1 : n.
const SMALLEST: u32 = 1_000_000_000;
/// Largest size of a drawing between paragraphs.
pub const SKETCH: Point = [166.0, 110.0];
/// Room around a drawing for labels and supports.
const MARGIN: Point = [3.5, 7.0];
/// Largest size of one of two side by side, or beside a table.
pub const HALF: Point = [80.0, 66.0];

/// The mechanism to the largest usual scale that fits into `largest` mm.
#[must_use]
pub fn drawing(drawing: &Drawing, largest: Point) -> Picture {
    let points: Vec<Point> = drawing.shapes.iter().flat_map(extent).collect();
    let low = [0, 1].map(|axis| points.iter().map(|p| p[axis]).fold(f64::INFINITY, f64::min));
    let high = [0, 1].map(|axis| points.iter().map(|p| p[axis]).fold(f64::NEG_INFINITY, f64::max));
    let size =
        |scale: u32| [0, 1].map(|axis| (high[axis] - low[axis]) * 1000.0 / f64::from(scale) + 2.0 * MARGIN[axis]);
    let fits = |scale: &u32| size(*scale)[0] <= largest[0] && size(*scale)[1] <= largest[1];
    let scale = scales().find(fits).unwrap_or(SMALLEST);
    let millimetres = 1000.0 / f64::from(scale);
    let place = |p: Point| {
        [
            (p[0] - low[0]) * millimetres + MARGIN[0],
            (high[1] - p[1]) * millimetres + MARGIN[1],
        ]
    };
    let mut picture = Picture::new(size(scale).map(hundredths), scale);
    for shape in &drawing.shapes {
        draw(&mut picture, shape, &place, millimetres);
    }
    // When all lines are drawn, so that labels keep clear of them: first those that belong to a line.
    let own_line = |shape: &&Shape| matches!(shape, Shape::Distance { .. } | Shape::Angle { .. } | Shape::Load { .. });
    let (of_lines, of_points): (Vec<&Shape>, Vec<&Shape>) = drawing.shapes.iter().partition(own_line);
    for shape in of_lines.into_iter().chain(of_points) {
        name(&mut picture, shape, &place, millimetres);
    }
    picture
}

/// Points that must be on the paper.
fn extent(shape: &Shape) -> Vec<Point> {
    match shape {
        Shape::Body { points, .. } | Shape::Path { points } => points.clone(),
        Shape::Pin { at, .. }
        | Shape::Label { at, .. }
        | Shape::Number { at, .. }
        | Shape::Load { at, .. }
        | Shape::Angle { at, .. } => vec![*at],
        Shape::Axis { from, to } | Shape::Arrow { from, to } => vec![*from, *to],
        Shape::CentreLine { x, from, to } => vec![[*x, *from], [*x, *to]],
        // On paper nothing is dragged; forces, centres and dead points stand in tables.
        Shape::Aside { .. } | Shape::Handle { .. } | Shape::Force { .. } => Vec::new(),
        Shape::Distance { from, to, offset, .. } => {
            let [x, y] = unit(*from, *to);
            [from, to].map(|p| [p[0] - y * offset, p[1] + x * offset]).to_vec()
        }
    }
}

fn draw(picture: &mut Picture, shape: &Shape, place: &impl Fn(Point) -> Point, millimetres: f64) {
    match shape {
        Shape::Body { points, closed, faint } => {
            let points: Vec<Point> = points.iter().copied().map(place).collect();
            picture.shape(
                if *faint {
                    "faint"
                } else if *closed {
                    "body"
                } else {
                    "bar"
                },
                &points,
                *closed,
            );
        }
        Shape::Pin { at, fixed, faint } => {
            let at = place(*at);
            if *fixed {
                support(picture, at);
            }
            picture.circle(if *faint { "faint" } else { "pin" }, at, if *faint { 0.5 } else { 0.9 });
        }
        Shape::Path { points } => {
            let points: Vec<Point> = points.iter().copied().map(place).collect();
            picture.line("path", &points);
        }
        Shape::Axis { from, to } => picture.line("axis", &[place(*from), place(*to)]),
        Shape::Arrow { from, to } => {
            let (from, to) = (place(*from), place(*to));
            picture.line("thin", &[from, to]);
            picture.arrow(from, to);
        }
        Shape::CentreLine { x, from, to } => picture.line("axis", &[place([*x, *from]), place([*x, *to])]),
        Shape::Load { at, .. } => {
            let [x, y] = place(*at);
            let tip = [x, y + LOAD];
            picture.line("medium", &[[x, y + 0.9], tip]);
            picture.arrow([x, y], tip);
        }
        Shape::Distance { from, to, offset, .. } => {
            let (from, to) = (place(*from), place(*to));
            let (a, b) = measured(from, to, offset * millimetres);
            for (start, end) in [(from, a), (to, b)] {
                let out = unit(start, end);
                picture.line("thin", &[start, [end[0] + out[0] * 1.5, end[1] + out[1] * 1.5]]);
            }
            picture.line("thin", &[a, b]);
            picture.arrow(b, a);
            picture.arrow(a, b);
        }
        Shape::Angle {
            at, radius, from, to, ..
        } => {
            let (at, radius) = (place(*at), radius * millimetres);
            let arc: Vec<Point> = (0..=32)
                .map(|i| polar(at, radius, from + (to - from) * f64::from(i) / 32.0))
                .collect();
            picture.line("thin", &[polar(at, 1.0, *from), polar(at, radius + 4.0, *from)]);
            picture.line("thin", &arc);
            picture.arrow(arc[30], arc[32]);
        }
        Shape::Label { .. } | Shape::Number { .. } => {}
        Shape::Aside { .. } | Shape::Handle { .. } | Shape::Force { .. } => {}
    }
}

/// Length of the arrow of a weight, in mm.
const LOAD: f64 = 12.0;

/// Where on a line its name may stand, the best part first.
const PARTS: [f64; 9] = [0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8, 0.1, 0.9];

/// The names of what was drawn.
fn name(picture: &mut Picture, shape: &Shape, place: &impl Fn(Point) -> Point, millimetres: f64) {
    let (label, places) = match shape {
        Shape::Label { at, text } => {
            let label = Label::symbol(text);
            let places = label.around(place(*at), false);
            (label, places)
        }
        Shape::Number { at, number } => {
            let (label, at) = (Label::plain(number.to_string()), place(*at));
            let mut places = vec![at];
            places.extend(label.around(at, false));
            (label, places)
        }
        Shape::Load { at, text } => {
            let (label, [x, y]) = (Label::symbol(text), place(*at));
            let beside = |part: f64| {
                let middle = [x, y + LOAD * (0.2 + 0.9 * part)];
                [1.0, -1.0].map(|side| label.beside(middle, [side, 0.0], 1.0))
            };
            let mut places: Vec<Point> = PARTS.into_iter().flat_map(beside).collect();
            places.extend(label.around([x, y + LOAD], true));
            (label, places)
        }
        Shape::Distance { from, to, offset, text } => {
            let label = Label::symbol(text);
            let (a, b) = measured(place(*from), place(*to), offset * millimetres);
            let [x, y] = unit(a, b);
            let beside = |part: f64| {
                let middle = [0, 1].map(|i| a[i] + part * (b[i] - a[i]));
                [[y, -x], [-y, x]].map(|side| label.beside(middle, side, 0.9))
            };
            let mut places: Vec<Point> = PARTS.into_iter().flat_map(beside).collect();
            places.extend(label.around([0, 1].map(|i| f64::midpoint(a[i], b[i])), false));
            (label, places)
        }
        Shape::Angle {
            at,
            radius,
            from,
            to,
            text,
        } => {
            let label = Label::symbol(text);
            let (at, radius) = (place(*at), radius * millimetres);
            let on = |part: f64| polar(at, radius, from + (to - from) * part);
            let beside = |part: f64| {
                let out = unit(at, on(part));
                [out, out.map(|x| -x)].map(|side| label.beside(on(part), side, 0.9))
            };
            let mut places: Vec<Point> = PARTS.into_iter().flat_map(beside).collect();
            places.extend(label.around(on(0.5), false));
            (label, places)
        }
        _ => return,
    };
    picture.label(label, &places);
}

/// The ends of a distance that is drawn so far (in mm) to the left of its line as seen on paper, where y runs downwards.
fn measured(from: Point, to: Point, d: f64) -> (Point, Point) {
    let [x, y] = unit(from, to);
    let aside = |p: Point| [p[0] + y * d, p[1] - x * d];
    (aside(from), aside(to))
}

/// At a radius (in mm) and an angle about a place of the picture.
fn polar([x, y]: Point, radius: f64, angle: f64) -> Point {
    let (sin, cos) = Calc::sin_cos(angle);
    [x + radius * cos, y - radius * sin]
}

/// A joint held by the ground, which is hatched.
fn support(picture: &mut Picture, [x, y]: Point) {
    let ground = y + 4.0;
    picture.shape("support", &[[x, y], [x - 2.3, ground], [x + 2.3, ground]], true);
    picture.line("medium", &[[x - 3.6, ground], [x + 3.6, ground]]);
    for i in 0..6 {
        let start = x - 3.0 + 1.2 * f64::from(i);
        picture.line("thin", &[[start, ground], [start - 1.2, ground + 1.4]]);
    }
}

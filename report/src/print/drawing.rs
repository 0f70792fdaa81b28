//! Mechanisms to scale.

use std::f64::consts::{FRAC_PI_2, PI};

use lemnis_models::component::sheet::{Drawing, Shape};
use lemnis_models::kernel::calc::Calc;

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
/// Largest size of one of many.
pub const SMALL: Point = [80.0, 100.0];

/// Largest size of one of two drawings side by side.
pub const HALF: Point = [80.0, 80.0];

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
        draw(&mut picture, drawing, shape, &place, millimetres);
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
        Shape::Distance { from, to, offset, .. } => {
            let [x, y] = unit(*from, *to);
            [from, to].map(|p| [p[0] - y * offset, p[1] + x * offset]).to_vec()
        }
    }
}

fn draw(picture: &mut Picture, whole: &Drawing, shape: &Shape, place: &impl Fn(Point) -> Point, millimetres: f64) {
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
        Shape::Label { at, text } => {
            let [x, y] = free_side(whole, *at);
            let [left, top] = place(*at);
            picture.text([left + 3.8 * x, top - 3.8 * y], "centre", *text);
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
        Shape::Number { at, number } => picture.text(place(*at), "centre", number.to_string()),
        Shape::CentreLine { x, from, to } => picture.line("axis", &[place([*x, *from]), place([*x, *to])]),
        Shape::Load { at, text } => {
            let [x, y] = place(*at);
            let tip = [x, y + 12.0];
            picture.line("medium", &[[x, y + 0.9], tip]);
            picture.arrow([x, y], tip);
            picture.text([x + 1.5, y + 8.0], "left", *text);
        }
        Shape::Distance { from, to, offset, text } => {
            distance(picture, place(*from), place(*to), offset * millimetres, text);
        }
        Shape::Angle {
            at,
            radius,
            from,
            to,
            text,
        } => {
            angle(picture, place(*at), radius * millimetres, [*from, *to], text);
        }
    }
}

/// A distance between two places of the picture, drawn so far to the left of their line, in mm.
fn distance(picture: &mut Picture, from: Point, to: Point, d: f64, text: &'static str) {
    let [x, y] = unit(from, to);
    // To the left of the line as seen on paper, where y runs downwards.
    let aside = |p: Point, d: f64| [p[0] + y * d, p[1] - x * d];
    let (a, b) = (aside(from, d), aside(to, d));
    for (start, end) in [(from, a), (to, b)] {
        let out = unit(start, end);
        picture.line("thin", &[start, [end[0] + out[0] * 1.5, end[1] + out[1] * 1.5]]);
    }
    picture.line("thin", &[a, b]);
    picture.arrow(b, a);
    picture.arrow(a, b);
    picture.text(
        aside([f64::midpoint(a[0], b[0]), f64::midpoint(a[1], b[1])], 2.2),
        "centre",
        text,
    );
}

/// An angle about a place of the picture, at a radius in mm.
fn angle(picture: &mut Picture, centre: Point, radius: f64, [from, to]: [f64; 2], text: &'static str) {
    let on = |angle: f64, radius: f64| {
        let (sin, cos) = Calc::sin_cos(angle);
        [centre[0] + radius * cos, centre[1] - radius * sin]
    };
    let arc: Vec<Point> = (0..=32)
        .map(|i| on(from + (to - from) * f64::from(i) / 32.0, radius))
        .collect();
    picture.line("thin", &[on(from, 1.0), on(from, radius + 4.0)]);
    picture.line("thin", &arc);
    picture.arrow(arc[30], arc[32]);
    picture.text(on(from + (to - from) * 0.4, radius + 3.2), "centre", text);
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

/// The direction, y upwards, in which most room is left beside a point: away
/// from the bars and the angles that start there.
fn free_side(drawing: &Drawing, at: Point) -> Point {
    let mut taken: Vec<Point> = Vec::new();
    for shape in &drawing.shapes {
        match shape {
            Shape::Body {
                points,
                closed,
                faint: false,
            } if points.contains(&at) => {
                taken.extend(points.iter().filter(|&&p| p != at).map(|&p| unit(at, p)));
                if *closed {
                    // The body lies between its neighbours in the polygon.
                    let ends = points.iter().filter(|&&p| p != at).collect::<Vec<_>>();
                    taken.extend(ends.windows(2).flat_map(|pair| {
                        (1..16).map(|n| {
                            let part = f64::from(n) / 16.0;
                            unit(at, [0, 1].map(|i| pair[0][i] + part * (pair[1][i] - pair[0][i])))
                        })
                    }));
                }
            }
            Shape::Angle { at: centre, .. } if *centre == at => taken.push([1.0, 0.0]),
            Shape::Axis { from, to } if *to == at => taken.push(unit(at, *from)),
            Shape::Pin {
                at: pin, fixed: true, ..
            }
            | Shape::Load { at: pin, .. }
                if *pin == at =>
            {
                taken.push([0.0, -1.0])
            }
            _ => {}
        }
    }
    let room = |angle: f64| {
        let (sin, cos) = Calc::sin_cos(angle);
        let nearest = taken.iter().map(|p| p[0] * cos + p[1] * sin).fold(-1.0, f64::max);
        (nearest, [cos, sin])
    };
    let sides = (0..16).map(|i| room(FRAC_PI_2 + PI / 8.0 * f64::from(i)));
    sides.min_by(|a, b| a.0.total_cmp(&b.0)).expect("sixteen sides").1
}

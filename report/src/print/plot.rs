//! Curves, rankings and diagrams.

use lemnis_models::component::sheet::Curve;
use lemnis_models::kernel::number::{Digits, Number, exponent};
use lemnis_models::kernel::symbol::Symbol;

use crate::language::Language;
use crate::print::number::change;
use crate::print::picture::{Picture, Point, length};

/// Size of a curve's picture, and the room around its field for numbers and names.
const CHART: Point = [80.0, 62.0];
const LEFT: f64 = 13.0;
const RIGHT: f64 = 3.0;
const TOP: f64 = 7.0;
const BOTTOM: f64 = 10.0;

/// An axis: what is drawn, from where to where, with round numbers at its ticks.
struct Axis {
    from: f64,
    to: f64,
    step: f64,
}

impl Axis {
    /// Covers the values from tick to tick.
    fn new(values: impl Iterator<Item = f64>) -> Axis {
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| {
            (low.min(v), high.max(v))
        });
        // A quantity that stays the same, but for rounding, gets an axis around it.
        let size = if low == 0.0 && high == 0.0 {
            1.0
        } else {
            low.abs().max(high.abs())
        };
        let (low, high) = if high - low < 1e-9 * size {
            (low - 1e-3 * size, high + 1e-3 * size)
        } else {
            (low, high)
        };
        let span = high - low;
        let power = power_of_ten(span / 5.0);
        let step = [1.0, 2.0, 5.0, 10.0]
            .map(|n| n * power)
            .into_iter()
            .find(|step| span / step <= 6.5);
        let step = step.expect("ten times the power is more than a fifth of the span");
        let (low, high) = ((low / step + 1e-9).floor() * step, (high / step - 1e-9).ceil() * step);
        Axis {
            from: low,
            to: if high > low { high } else { low + step },
            step,
        }
    }

    fn ticks(&self) -> impl Iterator<Item = f64> {
        let first = (self.from / self.step - 1e-6).ceil() as i64;
        let last = (self.to / self.step + 1e-6).floor() as i64;
        let step = self.step;
        (first..=last).map(move |i| i as f64 * step)
    }

    fn decimals(&self) -> usize {
        usize::try_from(-exponent(self.step)).unwrap_or(0)
    }

    /// Part of the axis passed at a value.
    fn part(&self, value: f64) -> f64 {
        (value - self.from) / (self.to - self.from)
    }
}

/// The field of a diagram: its axes, in display units.
struct Field {
    x: Axis,
    y: Axis,
    /// The axes are of decimal logarithms.
    powers: bool,
}

/// Right and lower edge of the field, in mm.
const EDGE: Point = [CHART[0] - RIGHT, CHART[1] - BOTTOM];

impl Field {
    fn around(points: impl Iterator<Item = Point> + Clone) -> Field {
        Field {
            x: Axis::new(points.clone().map(|p| p[0])),
            y: Axis::new(points.map(|p| p[1])),
            powers: false,
        }
    }

    /// The number of a tick of an axis.
    fn label(
        &self,
        picture: &mut Picture,
        language: &Language,
        axis: &Axis,
        tick: f64,
        at: Point,
        anchor: &'static str,
    ) {
        let number = Number::new(tick, Digits::Decimals(axis.decimals()));
        match self.powers {
            false => picture.number(at, anchor, language.text(&number)),
            true => picture.text(at, anchor, format!("10^({number})")),
        }
    }

    /// On paper, in mm.
    fn place(&self, p: Point) -> Point {
        let [width, height] = [EDGE[0] - LEFT, EDGE[1] - TOP];
        [LEFT + width * self.x.part(p[0]), EDGE[1] - height * self.y.part(p[1])]
    }

    /// Grid, numbers and border.
    fn picture(&self, language: &Language) -> Picture {
        let [right, bottom] = EDGE;
        let mut picture = Picture::new(CHART, 0);
        let left = |tick: f64| self.place([tick, self.y.from])[0];
        let top = |tick: f64| self.place([self.x.from, tick])[1];
        for tick in self.x.ticks() {
            picture.line("grid", &[[left(tick), TOP], [left(tick), bottom]]);
        }
        for tick in self.y.ticks() {
            let zero = tick == 0.0 && !self.powers;
            picture.line(
                if zero { "thin" } else { "grid" },
                &[[LEFT, top(tick)], [right, top(tick)]],
            );
        }
        for tick in self.x.ticks() {
            self.label(
                &mut picture,
                language,
                &self.x,
                tick,
                [left(tick), bottom + 1.2],
                "above",
            );
        }
        for tick in self.y.ticks() {
            self.label(&mut picture, language, &self.y, tick, [LEFT - 1.2, top(tick)], "right");
        }
        picture.shape(
            "thin",
            &[[LEFT, TOP], [right, TOP], [right, bottom], [LEFT, bottom]],
            true,
        );
        picture
    }
}

/// The axes' names, last, so that no line crosses them.
fn name_axes(picture: &mut Picture, [x, y]: [&Symbol; 2]) {
    picture.text([LEFT - 8.0, TOP - 3.6], "left", axis_name(y));
    picture.text([EDGE[0], EDGE[1] + 7.2], "right", axis_name(x));
}

/// A line of a diagram with several, in SI.
pub struct Line {
    /// In Typst's mathematics; empty for none.
    pub label: String,
    pub points: Vec<Point>,
    /// Points are marked.
    pub marked: bool,
}

/// Strokes of lines that must be told apart, the last line's first.
const STROKES: [&str; 4] = ["curve", "path", "axis", "thin"];

/// Several lines in one diagram, each with its label; the last is the most prominent.
#[must_use]
pub fn lines(language: &Language, [x, y]: [&Symbol; 2], lines: &[Line]) -> Picture {
    let shown = |p: &Point| [x.shown(p[0]), y.shown(p[1])];
    let field = Field::around(lines.iter().flat_map(|line| line.points.iter().map(shown)));
    let mut picture = field.picture(language);
    let placed: Vec<Vec<Point>> = lines
        .iter()
        .map(|line| line.points.iter().map(|p| field.place(shown(p))).collect())
        .collect();
    for (i, (line, points)) in lines.iter().zip(&placed).enumerate() {
        let style = STROKES[(lines.len() - 1 - i).min(STROKES.len() - 1)];
        if points.len() > 1 {
            picture.line(if line.marked { "medium" } else { style }, points);
        }
        if line.marked {
            points.iter().for_each(|&at| picture.circle("solid", at, 0.7));
        }
    }
    for (i, (line, points)) in lines.iter().zip(&placed).enumerate() {
        if line.label.is_empty() {
            continue;
        }
        // Beside the point that is farthest from every other line, on its freer side.
        let others: Vec<Point> = placed
            .iter()
            .enumerate()
            .filter(|(j, _)| *j != i)
            .flat_map(|(_, points)| points.iter().copied())
            .collect();
        let room = |p: Point| {
            let gap = |q: &Point| length([p[0] - q[0], p[1] - q[1]]);
            others.iter().map(gap).fold(20.0, f64::min)
        };
        let sides = |p: Point| [[0.0, -3.0], [0.0, 3.0], [3.0, 0.0], [-3.0, 0.0]].map(|d| [p[0] + d[0], p[1] + d[1]]);
        let inside =
            |p: &Point| (LEFT + 2.0..EDGE[0] - 2.0).contains(&p[0]) && (TOP + 2.0..EDGE[1] - 2.0).contains(&p[1]);
        let free = |p: Point| {
            let own = |q: &Point| length([p[0] - q[0], p[1] - q[1]]);
            room(p) + 3.0 * points.iter().map(own).fold(3.0, f64::min)
        };
        let places = points.iter().flat_map(|&p| sides(p)).filter(inside);
        let best = places
            .map(|p| (free(p), p))
            .reduce(|a, b| if b.0 > a.0 { b } else { a });
        if let Some((_, at)) = best {
            picture.text(at, "centre", line.label.as_str());
        }
    }
    name_axes(&mut picture, [x, y]);
    picture
}

/// Settings of one level in a work-precision diagram: error and cost of each, and whether it lies on the front.
pub struct Series {
    /// In Typst's mathematics.
    pub label: String,
    pub points: Vec<(Point, bool)>,
}

/// Errors below this part are drawn at it: rounding.
const LEAST_ERROR: f64 = 1e-10;

/// Cost over error on logarithmic axes, one line for each level; what lies on the front is filled. The axes' names are
/// in Typst's mathematics; a vertical line stands at `allowed`.
#[must_use]
pub fn work_precision(language: &Language, names: [&str; 2], levels: &[Series], allowed: Option<f64>) -> Picture {
    let logarithm = |[error, cost]: Point| [error.clamp(LEAST_ERROR, 1e10).log10(), cost.log10()];
    let whole = |low: f64, high: f64| {
        let step = ((high - low) / 6.0).ceil().max(1.0);
        let (from, to) = (low.floor(), high.ceil().max(low.floor() + 1.0));
        Axis { from, to, step }
    };
    let points = levels
        .iter()
        .flat_map(|level| level.points.iter().map(|(p, _)| logarithm(*p)));
    let points: Vec<Point> = points.chain(allowed.map(|error| logarithm([error, 1e-6]))).collect();
    let extent = |axis: usize, points: &[Point]| {
        let values = points.iter().map(|p| p[axis]);
        let (low, high) = (
            values.clone().fold(f64::INFINITY, f64::min),
            values.fold(f64::NEG_INFINITY, f64::max),
        );
        whole(low - 0.1, high + 0.1)
    };
    let count = points.len() - usize::from(allowed.is_some());
    let field = Field {
        x: extent(0, &points),
        y: extent(1, &points[..count]),
        powers: true,
    };
    let mut picture = field.picture(language);
    if let Some(allowed) = allowed {
        let at = field.place([logarithm([allowed, 1.0])[0], field.y.from])[0];
        picture.line("path", &[[at, TOP], [at, EDGE[1]]]);
    }
    for level in levels {
        let placed: Vec<Point> = level.points.iter().map(|(p, _)| field.place(logarithm(*p))).collect();
        if placed.len() > 1 {
            picture.line("medium", &placed);
        }
        for (at, (_, front)) in placed.iter().zip(&level.points) {
            picture.circle(if *front { "solid" } else { "pin" }, *at, 0.8);
        }
    }
    let placed = levels
        .iter()
        .flat_map(|level| level.points.iter().map(|(p, _)| field.place(logarithm(*p))));
    let mut taken: Vec<Point> = placed.collect();
    for level in levels {
        let placed: Vec<Point> = level.points.iter().map(|(p, _)| field.place(logarithm(*p))).collect();
        let half = 0.9 * level.label.chars().count() as f64;
        // At one of the line's ends, where most room is.
        let ends = placed.last().into_iter().chain(placed.first());
        let sides = ends.flat_map(|[x, y]| {
            let sides = [[0.0, -3.4], [half + 2.0, 0.0], [-half - 2.0, 0.0], [0.0, 3.4]];
            sides.map(|[right, down]| [x + right, y + down])
        });
        let inside = |p: &Point| {
            (LEFT + half + 1.0..EDGE[0] - half - 1.0).contains(&p[0]) && (TOP + 2.0..EDGE[1] - 2.0).contains(&p[1])
        };
        let room = |p: &Point| {
            let gap = |q: &Point| {
                length([
                    ((p[0] - q[0]).abs() - half).max(0.0),
                    ((p[1] - q[1]).abs() - 1.6).max(0.0),
                ])
            };
            taken.iter().map(gap).fold(1.5, f64::min)
        };
        let best = sides.filter(inside).map(|p| (room(&p), p));
        if let Some((_, at)) = best.reduce(|a, b| if b.0 > a.0 { b } else { a }) {
            picture.text(at, "centre", level.label.as_str());
            // A label takes room from the next ones.
            taken.extend([-1.0, 0.0, 1.0].map(|part| [at[0] + part * half, at[1]]));
        }
    }
    picture.text([LEFT - 8.0, TOP - 3.6], "left", names[1]);
    picture.text([EDGE[0], EDGE[1] + 7.2], "right", names[0]);
    picture
}

/// A curve with axes, grid and extremes.
#[must_use]
pub fn curve(language: &Language, curve: &Curve) -> Picture {
    let shown = |p: &Point| [curve.x.shown(p[0]), curve.y.shown(p[1])];
    let pieces: Vec<Vec<Point>> = curve
        .pieces
        .iter()
        .map(|piece| piece.iter().map(shown).collect())
        .collect();
    let field = Field::around(pieces.iter().flatten().copied());
    let mut picture = field.picture(language);
    let place = |p: Point| field.place(p);
    for piece in &pieces {
        picture.line("curve", &piece.iter().copied().map(place).collect::<Vec<_>>());
    }
    // Where they end, every other one further in.
    for (piece, number) in pieces.iter().zip(&curve.numbers) {
        let at = piece.len() - 1 - if number % 2 == 0 { piece.len() / 12 } else { 0 };
        if let Some(point) = piece.get(at) {
            let [x, y] = place(*point);
            picture.text([x - 1.6, y], "centre", number.to_string());
        }
    }
    // A curve that is broken runs to infinity between its pieces: no extremes.
    if let ([piece], []) = (pieces.as_slice(), curve.numbers.as_slice()) {
        let extreme = |sign: f64| {
            piece
                .iter()
                .copied()
                .max_by(|a, b| (sign * a[1]).total_cmp(&(sign * b[1])))
        };
        let curve: Vec<Point> = piece.iter().copied().map(place).collect();
        for (point, outside) in [(extreme(1.0), -1.0), (extreme(-1.0), 1.0)] {
            let Some(point) = point else { continue };
            picture.circle("solid", place(point), 0.7);
            let text = language.text(&four_digits(point[1]));
            let at = beside(place(point), outside, &text, &curve);
            picture.number(at, "centre", text);
        }
    }
    name_axes(&mut picture, [curve.x, curve.y]);
    picture
}

/// Most bars of a ranking, and the height of each, in mm.
const BARS: usize = 7;
const BAR: f64 = 4.6;

/// A ranking of quantities by the size of their effect: bars from the longest,
/// dark where the effect is positive, light where it is negative.
#[must_use]
pub fn bars(language: &Language, mut effects: Vec<(&str, f64)>) -> Picture {
    effects.retain(|(_, effect)| effect.is_finite() && effect.abs() > 5e-8);
    effects.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()));
    effects.truncate(BARS);
    let mut picture = Picture::new([CHART[0], BAR * effects.len() as f64 + 2.0], 0);
    let longest = effects.first().map_or(1.0, |(_, effect)| effect.abs());
    let room = CHART[0] - LEFT - 16.0;
    for (i, (name, effect)) in effects.iter().enumerate() {
        let top = 1.0 + BAR * i as f64;
        let (middle, bottom) = (top + BAR / 2.0, top + BAR - 1.2);
        let end = LEFT + room * effect.abs() / longest;
        let style = if *effect > 0.0 { "more" } else { "less" };
        picture.shape(style, &[[LEFT, top], [end, top], [end, bottom], [LEFT, bottom]], true);
        picture.text([LEFT - 1.5, middle - 0.6], "right", *name);
        picture.text([end + 1.5, middle - 0.6], "left", language.math(&change(*effect)));
    }
    picture.line("thin", &[[LEFT, 0.0], [LEFT, picture.height]]);
    picture
}

/// Where a number beside a point of a curve is farthest from the curve, within
/// the field; `outside` (up or down) where there is a choice.
fn beside([x, y]: Point, outside: f64, text: &str, curve: &[Point]) -> Point {
    let [right, bottom] = EDGE;
    let half = [0.85 * text.chars().count() as f64, 1.5];
    let sides = [[0.0, outside], [1.0, outside], [-1.0, outside], [1.0, 0.0], [-1.0, 0.0]];
    let places = sides
        .into_iter()
        .chain([[1.0, -outside], [-1.0, -outside], [0.0, -outside]]);
    let places = places.map(|[i, j]| [x + i * (half[0] + 1.5), y + j * (half[1] + 1.5)]);
    let inside = |p: &Point| {
        (LEFT + half[0]..right - half[0]).contains(&p[0]) && (TOP + half[1]..bottom - half[1]).contains(&p[1])
    };
    let room = |p: &Point| {
        let gap = |q: &Point| length([0, 1].map(|i| ((p[i] - q[i]).abs() - half[i]).max(0.0)));
        // Beyond a millimetre all places are equally good, and the first is taken.
        curve.iter().map(gap).fold(1.0, f64::min)
    };
    let best = places
        .filter(inside)
        .map(|p| (room(&p), p))
        .reduce(|a, b| if b.0 > a.0 { b } else { a });
    best.map_or([x, y], |(_, p)| p)
}

fn power_of_ten(value: f64) -> f64 {
    format!("1e{}", exponent(value)).parse().expect("a number")
}

/// Symbol and unit, as ISO 80000 writes the heads of tables and axes.
fn axis_name(symbol: &Symbol) -> String {
    match symbol.display.print {
        "" => symbol.print.to_owned(),
        unit => format!("{} thin \"/\" thin \"{unit}\"", symbol.print),
    }
}

fn four_digits(value: f64) -> Number {
    let before = if value.abs() < 1.0 { 0 } else { exponent(value) + 1 };
    Number::new(value, Digits::Decimals(usize::try_from(4 - before).unwrap_or(0)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_inside() {
        let axis = Axis::new([60.0, 120.0].into_iter());
        assert_eq!(
            axis.ticks().collect::<Vec<_>>(),
            [60.0, 70.0, 80.0, 90.0, 100.0, 110.0, 120.0]
        );
        let axis = Axis::new([-243.99, 254.35].into_iter());
        assert_eq!(
            axis.ticks().collect::<Vec<_>>(),
            [-300.0, -200.0, -100.0, 0.0, 100.0, 200.0, 300.0]
        );
        assert_eq!(axis.decimals(), 0);
        assert_eq!(Axis::new([21.887, 22.298].into_iter()).decimals(), 1);
    }

    #[test]
    fn a_level_curve_has_an_axis_too() {
        let axis = Axis::new([5.0, 5.0].into_iter());
        assert!(axis.ticks().count() < 20 && axis.step > 0.0);
    }
}

//! Curves, rankings and diagrams.

use std::collections::BTreeMap;

use lemnis_models::component::sheet::Curve;
use lemnis_models::kernel::number::{Digits, Number, exponent};
use lemnis_models::kernel::symbol::Symbol;

use crate::language::Language;
use crate::print::label::Label;
use crate::print::number::change;
use crate::print::picture::{Picture, Point};

/// Size of a curve's picture, and the room around its field for numbers and names.
pub(super) const CHART: Point = [80.0, 54.0];
pub(super) const LEFT: f64 = 13.0;
const RIGHT: f64 = 3.0;
/// The same with names of curves at their ends.
const NAMES: f64 = 9.0;
const TOP: f64 = 7.0;
const BOTTOM: f64 = 10.0;

/// What of the greatest amount of a curve is rounding.
const ROUNDING: f64 = 1e-9;

/// What of the greatest amount of a curve is nothing beside it.
const NOTHING: f64 = 1e-4;

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
        // A quantity that stays the same gets an axis around it.
        let (low, high) = match low.abs().max(high.abs()) {
            0.0 => (-1.0, 1.0),
            size if Axis::is_level(low, high) => {
                // Of a small one as many digits as of a large one.
                let around = if size < 0.1 { 0.1 } else { 1e-3 } * size;
                (low - around, high + around)
            }
            _ => (low, high),
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

    /// Whether a quantity between these stays the same, but for rounding.
    fn is_level(low: f64, high: f64) -> bool {
        high - low <= ROUNDING * low.abs().max(high.abs())
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
pub(super) struct Field {
    x: Axis,
    y: Axis,
    /// The axes are of decimal logarithms.
    powers: bool,
    /// Its right edge, in mm.
    pub(super) right: f64,
}

/// Lower edge of the field, in mm.
const EDGE: f64 = CHART[1] - BOTTOM;

impl Field {
    /// Around the points; `named` with room for names at the ends of curves.
    pub(super) fn around(points: impl Iterator<Item = Point> + Clone, named: bool) -> Field {
        Field {
            x: Axis::new(points.clone().map(|p| p[0])),
            y: Axis::new(points.map(|p| p[1])),
            powers: false,
            right: CHART[0] - if named { NAMES } else { RIGHT },
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
    pub(super) fn place(&self, p: Point) -> Point {
        let [width, height] = [self.right - LEFT, EDGE - TOP];
        [LEFT + width * self.x.part(p[0]), EDGE - height * self.y.part(p[1])]
    }

    /// Those of the places at which a label is wholly within.
    fn inside(&self, label: &Label, mut places: Vec<Point>) -> Vec<Point> {
        let [half, low] = label.half;
        places.retain(|[x, y]| (LEFT + half..self.right - half).contains(x) && (TOP + low..EDGE - low).contains(y));
        places
    }

    /// Grid, numbers and border.
    pub(super) fn picture(&self, language: &Language) -> Picture {
        let (right, bottom) = (self.right, EDGE);
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
                [left(tick), bottom + 1.7],
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

/// The axes' names in Typst's mathematics.
pub(super) fn name_axes(picture: &mut Picture, [x, y]: [&str; 2]) {
    picture.text([LEFT - 8.0, TOP - 3.6], "left", y);
    picture.text([CHART[0] - RIGHT, EDGE + 7.2], "right", x);
}

/// A line of a diagram with several, in SI.
pub struct Line {
    /// Empty for none.
    pub label: String,
    pub points: Vec<Point>,
    /// Points are marked.
    pub marked: bool,
}

/// Strokes of curves that must be told apart, also in a copy without colours.
const STROKES: [&str; 8] = [
    "curve", "dashed", "dotted", "dotdash", "long", "double", "sparse", "longdot",
];

fn stroke(number: usize) -> &'static str {
    STROKES[number % STROKES.len()]
}

/// Least distance of names at the ends of curves, and how far they stand from the field, in mm.
const APART: f64 = 3.0;
const BEYOND: f64 = 3.5;

/// Names of curves to the right of the field, each with a line from its curve's end, one below the other in the order of
/// the ends.
fn name_ends(picture: &mut Picture, field: &Field, mut ends: Vec<(Point, String)>) {
    ends.sort_by(|a, b| a.0[1].total_cmp(&b.0[1]));
    // As near to their ends as the others leave room: from above, and where that goes too far, from below.
    let apart = APART.min((EDGE - TOP) / ends.len() as f64);
    let mut heights: Vec<f64> = ends.iter().map(|(end, _)| end[1]).collect();
    for i in 1..heights.len() {
        heights[i] = heights[i].max(heights[i - 1] + apart);
    }
    let mut lowest = EDGE + 1.0;
    for height in heights.iter_mut().rev() {
        *height = height.min(lowest);
        lowest = *height - apart;
    }
    for ((end, name), height) in ends.into_iter().zip(heights) {
        let label = Label::plain(name);
        let at = [field.right + BEYOND, height];
        picture.line("thin", &[end, [at[0] - 0.5, height]]);
        picture.label_at(label, at);
    }
}

/// Several lines in one diagram, each with its name.
#[must_use]
pub fn lines(language: &Language, [x, y]: [&Symbol; 2], lines: &[Line]) -> Picture {
    let shown = |p: &Point| [x.shown(p[0]), y.shown(p[1])];
    let of_curve = |line: &&Line| line.points.len() > 1 && !line.label.is_empty();
    let points = lines.iter().flat_map(|line| line.points.iter().map(shown));
    let field = Field::around(points, lines.iter().any(|line| of_curve(&line)));
    let mut picture = field.picture(language);
    let place = |p: &Point| field.place(shown(p));
    for (i, line) in lines.iter().enumerate() {
        let points: Vec<Point> = line.points.iter().map(place).collect();
        if points.len() > 1 {
            picture.line(if line.marked { "medium" } else { stroke(i) }, &points);
        }
        if line.marked {
            points.iter().for_each(|&at| picture.circle("solid", at, 0.7));
        }
    }
    let (curves, others): (Vec<&Line>, Vec<&Line>) = lines.iter().partition(of_curve);
    let end = |line: &Line| line.points.last().map(|end| (place(end), line.label.clone()));
    name_ends(&mut picture, &field, curves.into_iter().filter_map(end).collect());
    for line in others.into_iter().filter(|line| !line.label.is_empty()) {
        let label = Label::plain(line.label.as_str());
        let places = line.points.iter().flat_map(|p| label.around(place(p), false)).collect();
        let places = field.inside(&label, places);
        picture.label(label, &places);
    }
    name_axes(&mut picture, [&axis_name(x), &axis_name(y)]);
    picture
}

/// Settings of one level in a work-precision diagram: error and cost of each, and whether it lies on the front.
pub struct Series {
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
        right: CHART[0] - RIGHT,
    };
    let mut picture = field.picture(language);
    if let Some(allowed) = allowed {
        let at = field.place([logarithm([allowed, 1.0])[0], field.y.from])[0];
        picture.line("path", &[[at, TOP], [at, EDGE]]);
    }
    for (i, level) in levels.iter().enumerate() {
        let placed: Vec<Point> = level.points.iter().map(|(p, _)| field.place(logarithm(*p))).collect();
        if placed.len() > 1 {
            picture.line(stroke(i), &placed);
        }
        for (at, (_, front)) in placed.iter().zip(&level.points) {
            picture.circle(if *front { "solid" } else { "pin" }, *at, 0.8);
        }
    }
    for level in levels {
        let label = Label::plain(level.label.as_str());
        let places = level
            .points
            .iter()
            .flat_map(|(p, _)| label.around(field.place(logarithm(*p)), false));
        let places = field.inside(&label, places.collect());
        picture.label(label, &places);
    }
    name_axes(&mut picture, names);
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
    let field = Field::around(pieces.iter().flatten().copied(), !curve.numbers.is_empty());
    let mut picture = field.picture(language);
    let place = |p: Point| field.place(p);
    for (i, piece) in pieces.iter().enumerate() {
        let style = curve.numbers.get(i).map_or(STROKES[0], |number| stroke(number - 1));
        picture.line(style, &piece.iter().copied().map(place).collect::<Vec<_>>());
    }
    let ends: BTreeMap<usize, Point> = curve
        .numbers
        .iter()
        .zip(&pieces)
        .filter_map(|(&number, piece)| piece.last().map(|&end| (number, place(end))))
        .collect();
    let ends = ends.into_iter().map(|(number, end)| (end, number.to_string()));
    name_ends(&mut picture, &field, ends.collect());
    // A curve that is broken runs to infinity between its pieces: no extremes.
    if let ([piece], []) = (pieces.as_slice(), curve.numbers.as_slice()) {
        let extreme = |sign: f64| {
            piece
                .iter()
                .copied()
                .max_by(|a, b| (sign * a[1]).total_cmp(&(sign * b[1])))
        };
        let (Some(highest), Some(lowest)) = (extreme(1.0), extreme(-1.0)) else {
            return picture;
        };
        let mut extremes = vec![(highest, false), (lowest, true)];
        if Axis::is_level(lowest[1], highest[1]) {
            // Its extremes say the same.
            extremes.truncate(1);
        }
        for &(point, _) in &extremes {
            picture.circle("solid", place(point), 0.7);
        }
        let size = lowest[1].abs().max(highest[1].abs());
        for (point, below) in extremes {
            let label = Label::plain(language.text(&four_digits(point[1], size)));
            let places = field.inside(&label, label.around(place(point), below));
            picture.label_if_room(label, &places);
        }
    }
    name_axes(&mut picture, [&axis_name(curve.x), &axis_name(curve.y)]);
    picture
}

/// Most bars of a ranking, and the height of each, in mm.
const BARS: usize = 7;
pub(super) const BAR: f64 = 4.6;

/// A ranking of quantities by the size of their effect: bars from the longest,
/// dark where the effect is positive, light where it is negative. None where nothing has one.
#[must_use]
pub fn bars(language: &Language, mut effects: Vec<(String, f64)>) -> Option<Picture> {
    effects.retain(|(_, effect)| effect.is_finite() && effect.abs() > 5e-8);
    effects.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()));
    effects.truncate(BARS);
    let longest = effects.first()?.1.abs();
    let mut picture = Picture::new([CHART[0], BAR * effects.len() as f64 + 2.0], 0);
    let room = CHART[0] - LEFT - 16.0;
    for (i, (name, effect)) in effects.iter().enumerate() {
        let top = 1.0 + BAR * i as f64;
        let (middle, bottom) = (top + BAR / 2.0, top + BAR - 1.2);
        let end = LEFT + room * effect.abs() / longest;
        let style = if *effect > 0.0 { "more" } else { "less" };
        picture.shape(style, &[[LEFT, top], [end, top], [end, bottom], [LEFT, bottom]], true);
        picture.text([LEFT - 1.5, middle - 0.6], "right", name.clone());
        picture.text([end + 1.5, middle - 0.6], "left", language.math(&change(*effect)));
    }
    picture.line("thin", &[[LEFT, 0.0], [LEFT, picture.height]]);
    Some(picture)
}

fn power_of_ten(value: f64) -> f64 {
    format!("1e{}", exponent(value)).parse().expect("a number")
}

/// Symbol and unit, as ISO 80000 writes the heads of tables and axes.
pub(super) fn axis_name(symbol: &Symbol) -> String {
    match symbol.display.print {
        "" => symbol.print.to_owned(),
        unit => format!("{} thin \"/\" thin \"{unit}\"", symbol.print),
    }
}

/// Four significant digits, or zero where it is nothing beside the greatest amount of its curve.
fn four_digits(value: f64, size: f64) -> Number {
    if value.abs() <= NOTHING * size {
        return Number::new(0.0, Digits::Decimals(0));
    }
    Number::new(
        value,
        Digits::Decimals(usize::try_from(3 - exponent(value)).unwrap_or(0)),
    )
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
        assert_eq!(Axis::new([0.0, 0.0].into_iter()).decimals(), 1);
        assert!(Axis::is_level(0.0, 0.0) && Axis::is_level(5.0, 5.0 + 1e-14) && !Axis::is_level(0.0, 1e-14));
    }

    #[test]
    fn an_extreme_has_four_digits() {
        let written = |value, size| four_digits(value, size).to_string();
        let all = [
            (0.016_644, 0.02),
            (0.0, 0.0),
            (4e-16, 3.0),
            (3.545e-8, 0.3666),
            (-17.1823, 2062.0),
            (12345.6, 12345.6),
        ];
        assert_eq!(
            all.map(|(value, size)| written(value, size)),
            ["0.01664", "0", "0", "0", "-17.18", "12346"]
        );
    }
}

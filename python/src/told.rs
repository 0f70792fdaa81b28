//! What a scene's book would say, as plain values: results of the whole range, checks, the drawing.

use std::fmt::Write as _;

use lemnis_models::component::sheet::{Check, Drawing, Shape, Sheet, Summary};
use lemnis_models::scene::Scene;
use pyo3::IntoPyObject;

/// Id, value in SI, SI unit, where it occurs, meaning.
type Result = (
    &'static str,
    f64,
    &'static str,
    Option<(&'static str, f64)>,
    &'static str,
);
/// Id, symbol, value, limit, whether that is the most, whether it is kept, SI unit.
type Checked = (&'static str, &'static str, f64, f64, bool, bool, &'static str);

/// All of it.
#[derive(Clone, IntoPyObject)]
pub struct Told {
    summary: Vec<Result>,
    checks: Vec<Checked>,
    /// As SVG.
    drawing: String,
}

impl Told {
    pub fn new(scene: &Scene) -> Told {
        let sheet: Sheet = scene.sheet();
        let result = |summary: &Summary| {
            let Summary { symbol, value, at, .. } = *summary;
            let at = at.map(|(coordinate, at)| (coordinate.id, at));
            (symbol.id, value, symbol.unit.name, at, symbol.text)
        };
        let checked = |check: &Check| {
            let Check {
                id,
                symbol,
                value,
                limit,
                at_most,
                ..
            } = *check;
            (id, symbol.id, value, limit, at_most, check.passed(), symbol.unit.name)
        };
        Told {
            summary: sheet.results().map(result).collect(),
            checks: sheet.checks().map(checked).collect(),
            drawing: svg(&sheet.drawing),
        }
    }
}

/// Size of a drawing, in its points.
const SIZE: [f64; 2] = [480.0, 320.0];
const MARGIN: f64 = 16.0;

/// The mechanism to scale, without dimensions and labels.
fn svg(drawing: &Drawing) -> String {
    let lines: Vec<(&str, Vec<[f64; 2]>, bool)> = drawing.shapes.iter().filter_map(line).collect();
    let points = || lines.iter().flat_map(|(_, points, _)| points);
    if lines.is_empty() {
        return String::new();
    }
    let end = |axis: usize, way: fn(f64, f64) -> f64| points().map(|point| point[axis]).reduce(way).unwrap_or(0.0);
    let [low, high] = [f64::min, f64::max].map(|way| [end(0, way), end(1, way)]);
    let span = [0, 1].map(|axis| (high[axis] - low[axis]).max(1e-9));
    let scale = ((SIZE[0] - 2.0 * MARGIN) / span[0]).min((SIZE[1] - 2.0 * MARGIN) / span[1]);
    let place = |[x, y]: [f64; 2]| [(x - low[0]) * scale + MARGIN, (high[1] - y) * scale + MARGIN];
    let size = span.map(|span| span * scale + 2.0 * MARGIN);
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0}\" height=\"{1:.0}\" viewBox=\"0 0 {0:.0} {1:.0}\" fill=\"none\" \
         stroke=\"currentColor\" stroke-linejoin=\"round\">",
        size[0], size[1]
    );
    for (style, points, closed) in &lines {
        let path: Vec<String> = points
            .iter()
            .map(|point| place(*point))
            .map(|[x, y]| format!("{x:.1},{y:.1}"))
            .collect();
        let name = if *closed { "polygon" } else { "polyline" };
        let _ = write!(text, "<{name} {style} points=\"{}\"/>", path.join(" "));
    }
    for shape in &drawing.shapes {
        if let Shape::Pin {
            at,
            fixed,
            faint: false,
        } = shape
        {
            let ([x, y], fill) = (place(*at), if *fixed { "currentColor" } else { "white" });
            let _ = write!(text, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"3\" fill=\"{fill}\"/>");
        }
    }
    text.push_str("</svg>");
    text
}

/// What is drawn as a line: style, points, whether it is closed.
fn line(shape: &Shape) -> Option<(&'static str, Vec<[f64; 2]>, bool)> {
    match shape {
        Shape::Body {
            points,
            closed,
            faint: true,
        } => Some(("stroke-width=\"1\" opacity=\"0.3\"", points.clone(), *closed)),
        Shape::Body { points, closed, .. } => Some(("stroke-width=\"2.5\"", points.clone(), *closed)),
        Shape::Path { points } => Some(("stroke-width=\"1\" stroke-dasharray=\"6 3\"", points.clone(), false)),
        Shape::Axis { from, to } => Some((
            "stroke-width=\"0.7\" stroke-dasharray=\"8 3 2 3\"",
            vec![*from, *to],
            false,
        )),
        Shape::CentreLine { x, from, to } => {
            let ends = vec![[*x, *from], [*x, *to]];
            Some(("stroke-width=\"0.7\" stroke-dasharray=\"8 3 2 3\"", ends, false))
        }
        _ => None,
    }
}

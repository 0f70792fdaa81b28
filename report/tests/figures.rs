//! No label of a figure crosses a line, a frame or another label, by the extents that Typst gives them; curves of one
//! figure have strokes of their own and their names at their ends.

use std::collections::{BTreeMap, BTreeSet};

use lemnis::book::Edition;
use lemnis::language::LANGUAGES;
use lemnis::template::Templates;
use lemnis_models::parts::plane;
use lemnis_models::scene::Scene;
use lemnis_typeset::{Embedded, Format, Ink, ink};
use serde_json::Value;

type Point = [f64; 2];

/// A label where it is printed: its middle and the half of its extent, in mm.
struct Label<'a> {
    text: &'a str,
    middle: Point,
    half: Point,
}

fn point(value: &Value) -> Point {
    [0, 1].map(|axis| value[axis].as_f64().expect("a number"))
}

/// The ready scenes, and one that has its settings compared.
fn scenes() -> Vec<(String, Scene)> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../models/scenes");
    let mut texts: Vec<(String, String)> = std::fs::read_dir(folder)
        .expect("scenes")
        .map(|entry| entry.expect("a scene").path())
        .map(|path| {
            let text = std::fs::read_to_string(&path).expect("readable");
            (path.file_stem().expect("a name").to_string_lossy().into_owned(), text)
        })
        .collect();
    texts.sort();
    let motion = texts
        .iter()
        .find(|(name, _)| name == "portal_004_motion")
        .expect("there");
    let trade = motion
        .1
        .replacen("[luffing]\n", "[book]\nchapters = [\"trade\"]\n[luffing]\n", 1);
    texts.push(("trade".to_owned(), trade));
    let parsed = |(name, text): (String, String)| (name, Scene::parse(&text).expect("a ready scene"));
    texts.into_iter().map(parsed).collect()
}

/// The figures of a scene's book in a language, in their order.
fn figures(scene: &Scene, language: usize) -> Vec<Value> {
    let edition = Edition {
        language: &LANGUAGES[language],
        level: "full",
        templates: &Templates::embedded(),
        typesetter: &Embedded,
    };
    let source = edition
        .source(scene, &scene.sheet(), Format::Pdf)
        .expect("a source")
        .main;
    let figures = source.split("drawn(").skip(2).map(|rest| {
        let (_, text) = rest.split_once(", ").expect("a picture");
        let text = serde_json::Deserializer::from_str(text).into_iter::<String>().next();
        serde_json::from_str(&text.expect("text").expect("a string")).expect("a display list")
    });
    figures.collect()
}

/// Every different label as Typst sets it in a figure.
fn extents(figures: &[Value]) -> BTreeMap<(String, String), Ink> {
    let labels: BTreeSet<(String, String)> = figures.iter().flat_map(labels).collect();
    let set = |(kind, text): &(String, String)| match kind.as_str() {
        "number" => text.replace('"', "\\\""),
        _ => format!("${text}$"),
    };
    let pages: Vec<String> = labels.iter().map(|label| format!("#box[{}]", set(label))).collect();
    let page =
        "#set page(width: auto, height: auto, margin: 0pt)\n#set text(font: \"New Computer Modern\", size: 8.5pt)\n";
    let pages = ink(&(page.to_owned() + &pages.join("\n#pagebreak()\n")), &[]).expect("pages");
    assert_eq!(pages.len(), labels.len());
    labels.into_iter().zip(pages).collect()
}

fn labels(figure: &Value) -> impl Iterator<Item = (String, String)> {
    let items = figure["items"].as_array().expect("items").iter();
    items.filter_map(|item| {
        let text = item["text"].as_str()?;
        Some((item["kind"].as_str()?.to_owned(), text.to_owned()))
    })
}

fn placed<'a>(item: &'a Value, extents: &BTreeMap<(String, String), Ink>) -> Option<Label<'a>> {
    let text = item["text"].as_str()?;
    let kind = item["kind"].as_str()?;
    let ink = &extents[&(kind.to_owned(), text.to_owned())];
    let [x, y] = point(&item["at"]);
    // As `templates/picture.typ` aligns it.
    let corner = match item["anchor"].as_str()? {
        "left" => [x, y - ink.size[1] / 2.0],
        "right" => [x - ink.size[0], y - ink.size[1] / 2.0],
        "above" => [x - ink.size[0] / 2.0, y],
        _ => [x - ink.size[0] / 2.0, y - ink.size[1] / 2.0],
    };
    Some(Label {
        text,
        middle: [0, 1].map(|axis| corner[axis] + f64::midpoint(ink.from[axis], ink.to[axis])),
        half: [0, 1].map(|axis| (ink.to[axis] - ink.from[axis]) / 2.0),
    })
}

/// Whether a line passes through a rectangle.
fn crosses(from: Point, to: Point, middle: Point, half: Point) -> bool {
    // In small steps: the part that is inside of any label is longer than a tenth of a millimetre.
    let long = plane::length(plane::Point::new(to[0] - from[0], to[1] - from[1]));
    let steps = (long / 0.1).ceil().max(1.0) as usize;
    (0..=steps).any(|i| {
        let part = i as f64 / steps as f64;
        (0..2).all(|axis| (from[axis] + part * (to[axis] - from[axis]) - middle[axis]).abs() < half[axis])
    })
}

/// What the labels of a figure meet.
fn met(figure: &Value, extents: &BTreeMap<(String, String), Ink>) -> Vec<String> {
    let items = figure["items"].as_array().expect("items");
    let labels: Vec<Label> = items.iter().filter_map(|item| placed(item, extents)).collect();
    let size = ["width", "height"].map(|side| figure[side].as_f64().expect("a size"));
    let mut met = Vec::new();
    for (i, Label { text, middle, half }) in labels.iter().enumerate() {
        let mut meet = |what: String| met.push(format!("{text} at {middle:.1?} meets {what}"));
        if (0..2).any(|axis| middle[axis] < half[axis] || middle[axis] + half[axis] > size[axis]) {
            meet("the edge".to_owned());
        }
        for other in &labels[..i] {
            if (0..2).all(|axis| (middle[axis] - other.middle[axis]).abs() < half[axis] + other.half[axis]) {
                meet(format!("{} at {:.1?}", other.text, other.middle));
            }
        }
        for item in items {
            let style = item["style"].as_str().unwrap_or("");
            match item["kind"].as_str().expect("a kind") {
                // Behind everything, and covered by the labels' ground.
                "line" if style != "grid" => {
                    for path in item["paths"].as_array().expect("paths") {
                        let mut points: Vec<Point> = path.as_array().expect("points").iter().map(point).collect();
                        if item["closed"] == true {
                            points.push(points[0]);
                        }
                        if points.windows(2).any(|ends| crosses(ends[0], ends[1], *middle, *half)) {
                            meet(format!("a line of style {style}"));
                        }
                    }
                }
                "circle" => {
                    let (at, radius) = (point(&item["at"]), item["radius"].as_f64().expect("a radius"));
                    let away = [0, 1].map(|axis| ((at[axis] - middle[axis]).abs() - half[axis]).max(0.0));
                    if plane::length(plane::Point::new(away[0], away[1])) < radius {
                        meet("a circle".to_owned());
                    }
                }
                _ => {}
            }
        }
    }
    met
}

/// Strokes of curves in `report/src/print/plot.rs`.
const CURVES: [&str; 8] = [
    "curve", "dashed", "dotted", "dotdash", "long", "double", "sparse", "longdot",
];

#[test]
fn curves_of_one_figure_are_told_apart_without_colours() {
    let mut several = 0;
    for (name, scene) in scenes() {
        for (number, figure) in (1..).zip(figures(&scene, 0)) {
            let items = figure["items"].as_array().expect("items");
            let curves = |item: &&Value| item["style"].as_str().is_some_and(|style| CURVES.contains(&style));
            let curves: Vec<&Value> = items.iter().filter(curves).collect();
            if curves.len() < 2 {
                continue;
            }
            several += 1;
            let place = format!("{name} {number}");
            // A curve that is broken has its stroke in all its pieces, and its name once.
            let strokes: BTreeSet<&str> = curves.iter().filter_map(|curve| curve["style"].as_str()).collect();
            let right = |item: &&Value| item["text"].is_string() && item["at"][0].as_f64() > Some(73.0);
            let names: Vec<&Value> = items
                .iter()
                .filter(|item| item["anchor"] == "left")
                .filter(right)
                .collect();
            if name == "trade" {
                // Each level beside its points.
                let levels = items
                    .iter()
                    .filter(|item| item["kind"] == "number" && item["anchor"] == "centre");
                assert_eq!(levels.count(), strokes.len(), "{place}");
                continue;
            }
            assert_eq!(names.len(), strokes.len(), "{place}");
            assert!(curves.len() == strokes.len() || curves.len() > CURVES.len(), "{place}");
            // From every name a line to the end of a curve.
            let ends = |item: &&Value| item["kind"] == "line" && item["style"] == "thin" && item["closed"] == false;
            let paths = items
                .iter()
                .filter(ends)
                .flat_map(|item| item["paths"].as_array().expect("paths"));
            let ends: Vec<[Point; 2]> = paths.map(|path| [0, 1].map(|end| point(&path[end]))).collect();
            for name in names {
                let at = point(&name["at"]);
                let leader = ends
                    .iter()
                    .find(|[_, to]| (to[0] - at[0]).abs() < 1.0 && (to[1] - at[1]).abs() < 0.02);
                let from = leader.unwrap_or_else(|| panic!("{place}: {name} has no line"))[0];
                let reached = curves
                    .iter()
                    .flat_map(|curve| curve["paths"].as_array().expect("paths"))
                    .any(|path| {
                        let end = point(path.as_array().expect("points").last().expect("an end"));
                        plane::length(plane::Point::new(end[0] - from[0], end[1] - from[1])) < 0.02
                    });
                assert!(reached, "{place}: {name}");
            }
        }
    }
    assert!(several > 10, "{several}");
}

#[test]
fn no_label_crosses_anything() {
    let (mut bad, mut count) = (Vec::new(), 0);
    for (name, scene) in scenes() {
        for (language, _) in LANGUAGES.iter().enumerate() {
            let figures = figures(&scene, language);
            let extents = extents(&figures);
            for (number, figure) in (1..).zip(&figures) {
                let met = met(figure, &extents);
                bad.extend(
                    met.into_iter()
                        .map(|met| format!("{name} {} {number}: {met}", LANGUAGES[language].code)),
                );
                count += figure["items"].as_array().expect("items").len();
            }
        }
    }
    println!("{count} items");
    // The measure sees a label on a curve: one in the middle of every figure would meet something in most of them.
    let scenes = scenes();
    let (_, lemniscate) = scenes
        .iter()
        .find(|(name, _)| name.starts_with("lemniscate"))
        .expect("ready");
    let (mut figures, mut seen) = (figures(lemniscate, 0), 0);
    for figure in &mut figures {
        let label = serde_json::json!({ "kind": "number", "anchor": "centre", "text": "8888888888", "at": [45, 25] });
        figure["items"].as_array_mut().expect("items").push(label);
    }
    let extents = extents(&figures);
    for figure in &figures {
        seen += usize::from(!met(figure, &extents).is_empty());
    }
    assert!(2 * seen > figures.len(), "{seen} of {}", figures.len());
    assert!(bad.is_empty(), "{} of {count}:\n{}", bad.len(), bad.join("\n"));
}

//! Drawings that move: what a handle sets is what the scene gives, and a point that is dragged goes where it is dragged to.

use lemnis_models::component::sheet::{Gauge, Shape};
use lemnis_models::kernel::calc::Calc;
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::parts::plane;
use lemnis_models::scene::Scene;

type Point = [f64; 2];
type Handle = (Point, Vec<(&'static Symbol, Gauge)>);

fn far(a: Point, b: Point) -> f64 {
    plane::length(plane::Point::new(a[0] - b[0], a[1] - b[1]))
}

/// What a gauge says of a point, in SI.
fn measured(gauge: &Gauge, [x, y]: Point, known: f64) -> f64 {
    match *gauge {
        Gauge::Distance { from } => far([x, y], from),
        Gauge::Along { from, direction } => (x - from[0]) * direction[0] + (y - from[1]) * direction[1],
        Gauge::Direction { from, zero } => {
            let angle = Calc::direction(x - from[0], y - from[1]) - zero;
            let turn = std::f64::consts::TAU;
            angle + turn * ((known - angle) / turn).round()
        }
    }
}

fn handles(scene: &Scene, at: f64) -> Vec<Handle> {
    let shapes = scene.drawing(at).shapes.into_iter();
    let handle = |shape| match shape {
        Shape::Handle { at, sets } => Some((at, sets)),
        _ => None,
    };
    shapes.filter_map(handle).collect()
}

/// What the scene gives of a symbol, in SI; `None` where it gives it nowhere, or more than once.
fn given(scene: &Scene, symbol: &Symbol) -> Option<f64> {
    let mut all = scene
        .given
        .all()
        .filter(|known| known.symbol == symbol && known.given.is_some());
    let first = all.next()?.value;
    all.next().is_none().then_some(first)
}

/// The scene with other values, in SI.
fn with(scene: &Scene, values: &[(&'static Symbol, f64)]) -> Option<Scene> {
    let mut text = scene.text().to_owned();
    let place = |symbol: &Symbol| {
        let known = scene
            .given
            .all()
            .find(|known| known.symbol == symbol && known.given.is_some());
        known
            .and_then(|known| known.given.as_ref())
            .expect("given")
            .place
            .clone()
    };
    let mut changes: Vec<_> = values
        .iter()
        .map(|(symbol, value)| (place(symbol), format!("\"{value:?} {}\"", symbol.unit.name)))
        .collect();
    changes.sort_by_key(|(place, _)| std::cmp::Reverse(place.start));
    for (place, written) in changes {
        text.replace_range(place, &written);
    }
    Scene::parse(&text).ok()
}

fn scenes() -> impl Iterator<Item = (String, Scene)> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes");
    let files = std::fs::read_dir(folder).expect("the ready scenes");
    files.filter_map(|file| {
        let path = file.expect("a file").path();
        let text = std::fs::read_to_string(&path).ok()?;
        let scene = Scene::parse(&text).unwrap_or_else(|found| panic!("{}: {}", path.display(), found[0]));
        Some((path.file_stem()?.to_string_lossy().into_owned(), scene))
    })
}

fn places(scene: &Scene) -> Vec<f64> {
    let positions = scene.model().expect("a ready scene").positions();
    [0, positions.len() / 3, positions.len() - 1]
        .map(|i| positions[i])
        .to_vec()
}

#[test]
fn what_a_handle_sets_is_what_the_scene_gives() {
    let mut seen = 0;
    for (name, scene) in scenes() {
        for at in places(&scene) {
            for (point, sets) in handles(&scene, at) {
                assert!((1..=2).contains(&sets.len()), "{name}: one or two keys");
                for (symbol, gauge) in &sets {
                    let Some(value) = given(&scene, symbol) else { continue };
                    let found = measured(gauge, point, value);
                    assert!(
                        (found - value).abs() < 1e-9,
                        "{name}: {} = {value}, not {found}",
                        symbol.id
                    );
                    seen += 1;
                }
            }
        }
    }
    assert!(seen > 500, "{seen}");
}

#[test]
fn a_point_goes_where_it_is_dragged_to() {
    let mut moved = 0;
    for (name, scene) in scenes() {
        for at in places(&scene) {
            for (i, (point, sets)) in handles(&scene, at).iter().enumerate() {
                if sets.iter().any(|(symbol, _)| given(&scene, symbol).is_none()) {
                    continue;
                }
                let target = [point[0] + 1.1e-3, point[1] + 0.7e-3];
                let value = |(symbol, gauge): &(&'static Symbol, Gauge)| {
                    (*symbol, measured(gauge, target, given(&scene, symbol).expect("given")))
                };
                let values: Vec<_> = sets.iter().map(value).collect();
                // At the end of a range, or of what is allowed, it may have nowhere to go.
                let Some(changed) = with(&scene, &values) else { continue };
                let (found, _) = handles(&changed, at)[i];
                let off = far(found, target);
                if sets.len() == 2 {
                    assert!(
                        off < 1e-9,
                        "{name}: {} goes to {found:?}, not to {target:?}",
                        sets[0].0.id
                    );
                } else {
                    // Along its line, or about its centre, no farther from there than it was moved.
                    assert!(off < 1.4e-3, "{name}: {} goes to {found:?}", sets[0].0.id);
                }
                moved += 1;
            }
        }
    }
    assert!(moved > 300, "{moved}");
}

#[test]
fn forces_have_directions_of_length_one() {
    let mut mechanisms = std::collections::BTreeSet::new();
    for (_, scene) in scenes() {
        let at = scene.model().expect("a ready scene").positions()[0];
        for shape in scene.drawing(at).shapes {
            if let Shape::Force { sum, .. } = shape {
                mechanisms.insert(scene.mechanism.id());
                assert!(
                    sum.iter()
                        .all(|(_, [x, y])| (far([*x, *y], [0.0; 2]) - 1.0).abs() < 1e-12)
                );
            }
        }
    }
    assert!(mechanisms.len() >= 4, "{mechanisms:?}");
}

//! A model of a scene by the names of its variables.

use lemnis_models::component::model::Model;
use lemnis_models::scene::Scene;

pub fn model(text: &str) -> Model {
    let scene = Scene::parse(text).unwrap_or_else(|mistakes| panic!("{mistakes:?}"));
    scene.model().expect("built")
}

pub fn index(model: &Model, name: &str) -> usize {
    let found = model.variables().iter().position(|v| v.name() == name);
    found.unwrap_or_else(|| panic!("{name}"))
}

pub fn get(model: &mut Model, name: &str) -> f64 {
    let at = index(model, name);
    model.get(at).unwrap_or_else(|fault| panic!("{name}: {fault:?}"))
}

pub fn set(model: &mut Model, name: &str, value: f64) {
    let at = index(model, name);
    model.set(at, value).unwrap_or_else(|fault| panic!("{name}: {fault:?}"));
}

pub fn near(found: f64, wanted: f64, within: f64) {
    assert!((found - wanted).abs() <= within, "{found} is not {wanted}");
}

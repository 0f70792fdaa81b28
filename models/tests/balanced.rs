//! The balance on its mechanism: scene, model, book's formulas.

use std::f64::consts::PI;

use lemnis_models::lemniscate::sheet::sheet;
use lemnis_models::model::{Model, Role};
use lemnis_models::scene::Scene;

const EXISTING: &str = include_str!("../scenes/portal_004_existing.toml");
const NEW: &str = include_str!("../scenes/portal_004_new.toml");

fn scene(text: &str) -> Scene {
    Scene::parse(text).unwrap_or_else(|found| panic!("{found:#?}"))
}

#[test]
fn prints() {
    for text in [EXISTING, NEW] {
        let scene = scene(text);
        let mut model = Model::new(&scene).expect("a mechanism");
        model.set(0, (60.0_f64).to_radians()).expect("an angle");
        for i in 0..model.variables().len() {
            let v = model.variables()[i];
            println!(
                "{} {:?} {}",
                v.symbol.id,
                v.role,
                v.symbol.shown(model.get(i).expect("closes"))
            );
        }
        let _ = (sheet(&scene), PI, Role::Input);
    }
}

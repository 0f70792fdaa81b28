//! The default crane, and variations of it.

use lemnis_models::luffing::double_link::geometry::Geometry;
use lemnis_models::luffing::double_link::parameters::{Driven, Parameters};
use lemnis_models::luffing::double_link::scene::Luffing;
use lemnis_models::scene::{DEFAULT, Scene};

pub fn luffing() -> Luffing {
    let scene = Scene::parse(DEFAULT).expect("the default scene is valid");
    scene.mechanism.of::<Luffing>().expect("a luffing mechanism").clone()
}

pub fn parameters(driven: Driven) -> Parameters<f64> {
    Parameters {
        driven,
        ..luffing().parameters
    }
}

pub fn geometry(driven: Driven) -> Geometry<f64> {
    Geometry::new(&parameters(driven)).expect("the default crane exists")
}

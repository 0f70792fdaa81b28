//! A state that was written out goes on in another model.

use lemnis_models::component::model::Model;
use lemnis_models::scene::Scene;

/// The state after a time (s) goes on with the same bits in another model of the scene, over so many steps of 0.2 s. Gives the
/// model at their end.
pub fn goes_on(text: &str, begun: f64, steps: u32) -> Model {
    let scene = Scene::parse(text).expect("a scene");
    let [mut own, mut other] = [(); 2].map(|()| scene.model().expect("built"));
    own.advance(0.0, begun).expect("runs");
    let numbers = own.numbers(&own.state());
    let restored = other.state_of(&numbers).expect("its own");
    other.set_state(&restored);
    assert!(other.state_of(&numbers[1..]).is_err());
    for model in [&mut own, &mut other] {
        for step in 0..steps {
            let from = begun + f64::from(step) * 0.2;
            model.advance(from, from + 0.2).expect("runs");
        }
    }
    for i in 0..own.variables().len() {
        let [here, there] = [&mut own, &mut other].map(|model| model.get(i).expect("a value").to_bits());
        assert_eq!(here, there, "{}", own.variables()[i]);
    }
    own
}

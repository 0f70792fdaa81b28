//! Every mechanism under the recorder: consistent dimensions, and the values of `f64` bit for bit.

#[path = "common/balances.rs"]
mod balances;

use lemnis_models::model::Model;
use lemnis_models::scene::{DEFAULT, Scene};
use lemnis_models::sheet::Section;
use lemnis_models::sheet::sheet;

/// The default scene and its variations that reach every branch of the equations.
fn scenes() -> Vec<Scene> {
    let boom = DEFAULT.to_owned();
    let rocker = boom
        .replace("driven = \"boom\"", "driven = \"rocker\"")
        .replace("from  = \"60 deg\"", "from = \"50 deg\"")
        .replace("to    = \"120 deg\"", "to = \"130 deg\"")
        .replace("branch = \"left\"", "branch = \"right\"");
    let rocker = rocker[..rocker.find("[luffing.published]").expect("there")].to_owned();
    let angle = boom.replace("X_7 = \"1.354 m\"", "beta_0 = \"163.122 deg\"");
    let axis = boom.replace("X_7 = \"1.354 m\"", "AC = \"22.3 m\"");
    let bare = boom[..boom.find("[luffing.weights]").expect("there")].to_owned();
    let kinematic = bare.replace("Q = \"160 kN\"", "");
    let texts = [boom, rocker, angle, axis, bare, kinematic];
    let texts = texts.into_iter().chain(balances::every_kind());
    let texts: Vec<String> = texts.collect();
    texts
        .iter()
        .map(|text| Scene::parse(text).unwrap_or_else(|found| panic!("{found:?}")))
        .collect()
}

#[test]
fn every_formula_is_dimensionally_consistent() {
    let mut steps = 0;
    for scene in scenes() {
        let sheet = sheet(&scene);
        let worked = sheet.positions.iter().flat_map(|position| &position.sections);
        for Section { id, trace, .. } in sheet.constants.iter().chain(worked) {
            assert!(trace.faults.is_empty(), "{id}: {:?}", trace.faults);
            steps += trace.steps.len();
        }
    }
    assert!(steps > 300, "{steps} formulas");
    println!("{steps} formulas are consistent");
}

#[test]
fn the_recorder_has_the_bits_of_the_model() {
    for scene in scenes() {
        let mut model = Model::new(&scene).expect("a mechanism");
        let mut compared = 0;
        for position in sheet(&scene).positions {
            model.set(0, position.value).expect("an angle");
            for step in position.sections.iter().flat_map(|section| &section.trace.steps) {
                let index = model
                    .variables()
                    .iter()
                    .position(|variable| variable.symbol == step.symbol);
                if let Some(index) = index {
                    let value = model.get(index).expect("closes");
                    assert_eq!(
                        value.to_bits(),
                        step.value.to_bits(),
                        "{}: {value} {}",
                        step.symbol.id,
                        step.value
                    );
                    compared += 1;
                }
            }
        }
        assert!(compared >= 15, "{compared}");
    }
}

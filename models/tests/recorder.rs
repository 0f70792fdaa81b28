//! Every mechanism under the recorder: consistent dimensions, and the values of `f64` bit for bit.

#[path = "common/balances.rs"]
mod balances;
#[path = "common/levels.rs"]
mod levels;

use lemnis_models::component::sheet::{Energy, Section};
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::scene::{DEFAULT, Scene};

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
        let sheet = scene.sheet();
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
        let mut model = scene.model().expect("a mechanism");
        let mut compared = 0;
        for position in scene.sheet().positions {
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

/// The formulas of motion are those that run: consistent, and with the bits of the model at the same instant.
#[test]
fn equations_of_motion_are_consistent_and_have_the_bits_of_the_model() {
    for level in levels::all().filter(|level| *level != "static") {
        let scene = levels::scene(level);
        let motion = scene.sheet().motion.expect("a chapter of motion");
        let mut model = scene.model().expect("built");
        for &(symbol, value) in &motion.state {
            let index = model.variables().iter().position(|variable| variable.symbol == symbol);
            // The equations' own constants are no variables.
            let Some(index) = index else {
                assert_eq!(symbol.source, "assumption", "{}", symbol.id);
                continue;
            };
            model.set(index, value).expect("a state or a command");
        }
        // Which way a joint goes that was set from outside is decided upon.
        model.update().expect("closes");
        let mut compared = 0;
        for Section { id, trace, .. } in &motion.sections {
            assert!(trace.faults.is_empty(), "{level} {id}: {:?}", trace.faults);
            for step in &trace.steps {
                let mut variables = model.variables().iter();
                if let Some(index) = variables.position(|variable| variable.symbol == step.symbol) {
                    let value = model.get(index).expect("closes");
                    // The speed of the drive has a formula of its own beside the derivative of its length.
                    let same = match step.symbol.id {
                        "v_d" => (value - step.value).abs() <= 1e-12 * value.abs(),
                        _ => value.to_bits() == step.value.to_bits(),
                    };
                    assert!(same, "{level}, {}: {value} {}", step.symbol.id, step.value);
                    compared += 1;
                }
            }
        }
        assert!(compared >= 1, "{level}: {compared}");
        let steps: usize = motion.sections.iter().map(|section| section.trace.steps.len()).sum();
        println!("{level}: {steps} formulas, {compared} of them results of the model");
    }
}

/// The accounts close: what went in is stored or taken, and only what the sums over samples miss is left over.
#[test]
fn the_energy_of_a_run_is_accounted_for() {
    for level in levels::all().filter(|level| *level != "static") {
        let sheet = levels::scene(level).sheet();
        for manoeuvre in &sheet.motion.as_ref().expect("a chapter of motion").manoeuvres {
            accounted_for(&format!("{level}, {}", manoeuvre.id), &manoeuvre.energy);
        }
        let energy = sheet.identities.iter().find(|check| check.id == "motion_energy");
        assert!(energy.expect("checked").passed(), "{level}");
    }
}

fn accounted_for(run: &str, Energy { given, stored, taken }: &Energy) {
    let sum = |list: &[(&Symbol, f64)]| list.iter().map(|(_, value)| value).sum::<f64>();
    let of = |id: &str| {
        let found = taken.iter().find(|(symbol, _)| symbol.id == id);
        found.map_or(0.0, |(_, value)| *value)
    };
    let (given, stored, taken) = (sum(given), sum(stored), sum(taken));
    let scale = given.abs().max(stored.abs()).max(taken.abs());
    println!(
        "{run}: given {given:.0} J, stored {stored:.0} J, taken {taken:.0} J, over {:.1} J",
        of("W_e")
    );
    assert!((given - stored - taken).abs() <= 1e-12 * scale, "{run}");
    assert!(of("W_R") >= 0.0 && of("W_T") >= 0.0, "{run}");
    assert!(of("W_blow") > -1e-6 * scale, "{run}: a blow gives no energy");
}

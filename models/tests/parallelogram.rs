//! The parallelogram jib [Ports001, 5.9.2.2]: a double link whose jib keeps its direction.

use lemnis_models::component::model::Model;
use lemnis_models::kernel::calc::Calc;
use lemnis_models::scene::Scene;

const READY: &str = include_str!("../scenes/parallelogram.toml");

fn at(model: &mut Model, degrees: f64, name: &str) -> f64 {
    model.set(0, degrees.to_radians()).expect("an angle");
    let index = model.variables().iter().position(|variable| variable.name() == name);
    let index = index.unwrap_or_else(|| panic!("no {name}"));
    model.get(index).expect("exists")
}

/// M_Q = Q X_1 cos φ to 1e-13, by virtual work; the jib does not turn, its centre is at infinity at every angle, and the head
/// moves as that of the boom.
#[test]
fn the_jib_keeps_its_direction() {
    let mut model = Scene::parse(READY).expect("valid").model().expect("exists");
    let (q, boom) = (at(&mut model, 30.0, "Q"), 26.0);
    let direction = at(&mut model, 30.0, "alpha");
    for step in 0..=450 {
        let degrees = 30.0 + 0.1 * f64::from(step);
        let (sin, cos) = Calc::sin_cos(degrees.to_radians());
        let mut get = |name| at(&mut model, degrees, name);
        assert!((get("M_Q") - q * boom * cos).abs() <= 1e-13 * q * boom, "{degrees}");
        assert_eq!(get("P.at_infinity"), 1.0, "{degrees}");
        assert_eq!(get("O1P"), f64::INFINITY);
        assert!((get("alpha") - direction).abs() <= 1e-13, "{degrees}");
        assert!((get("theta_3") - degrees.to_radians()).abs() <= 1e-14, "{degrees}");
        // 1 deg of the boom in 1.25 s.
        let omega = 0.8_f64.to_radians();
        assert!((get("V_AX") + omega * boom * sin).abs() <= 1e-13);
        assert!((get("V_AY") - omega * boom * cos).abs() <= 1e-13);
    }
}

#[test]
fn every_check_of_the_ready_scene_passes() {
    let scene = Scene::parse(READY).unwrap_or_else(|found| panic!("{found:?}"));
    let sheet = scene.sheet();
    assert!(!sheet.requirements.is_empty() && sheet.identities.len() >= 2);
    for check in sheet.checks() {
        assert!(check.passed(), "{} {}", check.id, check.value);
    }
}

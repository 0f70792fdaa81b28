//! The boom four-bar of the portal crane is the same mechanism. [Balance004]

use lemnis_models::luffing::double_link::geometry::Geometry;
use lemnis_models::luffing::double_link::scene::Luffing;

use lemnis_models::scene::Scene;

const SCENE: &str = include_str!("../scenes/portal_004.toml");

/// Reach at the three nodes, printed to the centimetre; the angle of Q on the
/// jib is known to 0.01 deg, which is 2 mm.
#[test]
fn reach_at_the_printed_nodes() {
    let mut model = Scene::parse(SCENE).expect("valid").model().expect("a mechanism");
    let reach = model
        .variables()
        .iter()
        .position(|variable| variable.symbol.id == "R")
        .expect("R");
    for (phi, printed) in [(62.7_f64, 19.41), (45.8, 28.87), (79.2, 7.34)] {
        model.set(0, phi.to_radians()).expect("an angle");
        let computed = model.get(reach).expect("closes");
        assert!(
            (computed - printed).abs() <= 0.008,
            "x_Q at {phi}: {computed}, printed {printed}"
        );
    }
}

/// It closes for phi in about 36.1 to 84.5 deg, between two kinds of dead point
/// or not: the arc that holds the working range ends there.
#[test]
fn range_of_assembly() {
    let scene = Scene::parse(SCENE).expect("valid");
    let g = Geometry::new(&scene.mechanism.of::<Luffing>().expect("a luffing mechanism").parameters).expect("exists");
    let arc = g.linkage.arcs()[0];
    let (from, to) = (arc.from.to_degrees(), arc.to.to_degrees());
    assert!((from - 36.1).abs() < 0.05 && (to - 84.5).abs() < 0.05, "{from} {to}");
}

//! The portal crane of [Balance004]: its boom, its two published levers.

use lemnis_models::balance::lever::{Dimensions, Lever};
use lemnis_models::luffing::double_link::parameters::Parameters;
use lemnis_models::luffing::double_link::scene::Luffing;
use lemnis_models::luffing::double_link::system::BoomSystem;
use lemnis_models::parts::four_bar::Branch;
use lemnis_models::scene::Scene;

pub fn parameters() -> Parameters<f64> {
    let scene = Scene::parse(include_str!("../../scenes/portal_004.toml")).expect("valid");
    scene.mechanism.of::<Luffing>().expect("a luffing mechanism").parameters
}

pub fn boom() -> BoomSystem<f64> {
    BoomSystem::new(&parameters()).expect("a boom system")
}

pub fn rad(degrees: f64) -> f64 {
    degrees.to_radians()
}

pub fn range() -> [f64; 2] {
    [rad(44.0), rad(82.0)]
}

pub fn oracle() -> serde_json::Value {
    serde_json::from_str(include_str!("../../../tests/oracles/balancing_four_bar_004.json")).expect("JSON")
}

/// A lever of the oracle: `balance_existing` or `balance_synthesised`.
pub fn published(name: &str) -> Dimensions<f64> {
    let all = oracle();
    let of = |key: &str| all[name][key].as_f64().expect("a number");
    Dimensions {
        d_1: of("d1_m"),
        delta_1: rad(of("delta1_deg")),
        r_1: of("r1_m"),
        alpha_1: rad(of("alpha1_deg")),
        l_1: of("l1_m"),
        lever: of("R1_m"),
        chi_5: rad(of("chi5_deg")),
        m_5: of("M5_kNm") * 1e3,
    }
}

#[allow(dead_code, reason = "not every test needs it")]
pub fn lever(dimensions: Dimensions<f64>) -> Lever<f64> {
    Lever::new(dimensions, Some(3.0), Branch::Left).expect("a lever")
}

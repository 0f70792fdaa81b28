//! The default scene at each level.

#![allow(dead_code, reason = "not every test uses all of it")]

use lemnis_models::model::Model;
use lemnis_models::scene::{DEFAULT, Scene};

const DYNAMICS: &str = include_str!("../../../tests/levels/dynamics.toml");
const OIL: &str = include_str!("../../../tests/levels/hydraulics.toml");

#[allow(dead_code, reason = "not every test runs all")]
pub const LEVELS: [&str; 5] = ["static", "rigid", "swing", "hydraulic", "hydraulic with swing"];

pub fn scene(level: &str) -> Scene {
    let extra = match level {
        "rigid" => format!("{DYNAMICS}M_A = \"1800 kN.m\"\n"),
        "swing" => format!("{DYNAMICS}M_A = \"1800 kN.m\"\nl_R = \"10 m\"\n"),
        "hydraulic" => format!("{DYNAMICS}{OIL}"),
        "hydraulic with swing" => format!("{DYNAMICS}l_R = \"10 m\"\n{OIL}"),
        _ => String::new(),
    };
    let fidelity = level.split(' ').next().unwrap_or_default();
    let text = DEFAULT
        .replacen(
            "driven = \"boom\" ",
            &format!("fidelity = \"{fidelity}\"\ndriven = \"boom\" "),
            1,
        )
        .replacen("\n[luffing.limits]", &format!("\n{extra}\n[luffing.limits]"), 1);
    Scene::parse(&text).unwrap_or_else(|mistakes| panic!("{level}: {mistakes:?}"))
}

pub fn model(level: &str) -> Model {
    Model::new(&scene(level)).expect("built")
}

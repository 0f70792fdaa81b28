//! The default scene at each level.

#![allow(dead_code, reason = "not every test uses all of it")]

use lemnis_models::component::model::Model;
use lemnis_models::scene::{DEFAULT, Scene};

const DYNAMICS: &str = include_str!("../../../tests/levels/dynamics.toml");
const OIL: &str = include_str!("../../../tests/levels/hydraulics.toml");

const SLEWING: &str = include_str!("../../../tests/levels/slewing.toml");
const BALANCE: &str = include_str!("../../../tests/levels/balance.toml");

pub const LEVELS: [&str; 11] = [
    "static",
    "rigid",
    "rigid with balance",
    "rigid with slewing",
    "swing",
    "swing with slewing",
    "swing with slewing, balance",
    "hydraulic",
    "hydraulic with slewing",
    "hydraulic with swing",
    "hydraulic with swing, slewing",
];

/// Those with a motor on the hoist's drum, or a rope that gives way.
pub const HOISTS: [&str; 7] = [
    "swing with motor",
    "swing with motor, elastic",
    "swing with slewing, elastic",
    "swing with slewing, motor",
    "hydraulic with swing, elastic",
    "hydraulic with swing, slewing, motor",
    "hydraulic with swing, slewing, motor, elastic",
];

/// Every level, with every hoist.
pub fn all() -> impl Iterator<Item = &'static str> {
    LEVELS.into_iter().chain(HOISTS)
}

pub fn scene(level: &str) -> Scene {
    let text = text(level);
    Scene::parse(&text).unwrap_or_else(|mistakes| panic!("{level}: {mistakes:?}"))
}

pub fn text(level: &str) -> String {
    let fidelity = level.split(' ').next().unwrap_or_default();
    let has = |part: &str| level.contains(part);
    let mut extra = String::new();
    if !matches!(fidelity, "static" | "table") {
        extra.push_str(DYNAMICS);
    }
    if matches!(fidelity, "rigid" | "swing") {
        extra.push_str("M_A = \"1800 kN.m\"\n");
    }
    let hoisting = has("motor") || has("elastic");
    if has("swing") && !hoisting {
        extra.push_str("l_R = \"10 m\"\n");
    }
    if hoisting {
        extra.push_str("[luffing.hoisting]\nl_R = \"10 m\"\n");
    }
    if has("elastic") {
        extra.push_str("c_R = \"3000 kN/m\"\nd_R = \"40 kN.s/m\"\n");
    }
    if has("motor") {
        // The load needs 10 kN·m on this drum.
        extra
            .push_str("J_h = \"60 kg.m2\"\nr_h = \"250 mm\"\nm_h = \"4\"\nM_Fh = \"0.3 kN.m\"\nM_Mh = \"10.6 kN.m\"\n");
    }
    for (part, table) in [("hydraulic", OIL), ("slewing", SLEWING), ("balance", BALANCE)] {
        if has(part) {
            extra.push_str(table);
        }
    }
    DEFAULT
        .replacen(
            "driven = \"boom\" ",
            &format!("fidelity = \"{fidelity}\"\ndriven = \"boom\" "),
            1,
        )
        .replacen("\n[luffing.limits]", &format!("\n{extra}\n[luffing.limits]"), 1)
}

pub fn model(level: &str) -> Model {
    scene(level).model().expect("built")
}

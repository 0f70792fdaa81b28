//! A mechanism that the rope of its drive holds may move where that pulls all over the working range at rest. Elsewhere it
//! stands still.

use lemnis_models::scene::Scene;
use toml::{Table, Value};

/// What only a mechanism that moves has.
const MOVING: [&str; 6] = ["dynamics", "hoisting", "air", "ground", "slewing", "control"];

/// Places of the working range that are looked at.
const PLACES: u32 = 200;

/// Whether a rope drives it.
pub fn by_rope(made: &Table) -> bool {
    let drive = made.get("drive").and_then(Value::as_table);
    drive.and_then(|drive| drive.get("kind")?.as_str()) == Some("rope")
}

/// Of a mechanism's table under a gravity (m/s²).
pub fn hung(mechanism: &str, made: &mut Table, g: f64) {
    if !by_rope(made) || !made.contains_key("dynamics") {
        return;
    }
    let mut still = made.clone();
    still.insert("fidelity".to_owned(), "static".into());
    still.retain(|name, _| !MOVING.contains(&name));
    if let Some(limits) = still.get_mut("limits").and_then(Value::as_table_mut) {
        limits.remove("phi_max");
    }
    let scene = [
        ("name", Value::from("Hung")),
        ("g", format!("{g} m/s2").into()),
        (mechanism, still.clone().into()),
    ];
    let scene = Table::from_iter(scene.map(|(name, value)| (name.to_owned(), value)));
    if !pulls(&toml::to_string(&scene).expect("a table")) {
        *made = still;
    }
}

/// Whether its rope pulls everywhere.
fn pulls(text: &str) -> bool {
    let Ok(scene) = Scene::parse(text) else { return false };
    let Ok(mut model) = scene.model() else { return false };
    let pull = model.variables().iter().position(|variable| variable.name() == "S_l");
    let motion = scene.mechanism.motion();
    let (from, to) = (motion.from, motion.to);
    pull.is_some_and(|pull| {
        (0..=PLACES).all(|i| {
            let at = from + (to - from) * f64::from(i) / f64::from(PLACES);
            model.set(0, at).is_ok() && model.get(pull).is_ok_and(|pull| pull > 0.0 && pull.is_finite())
        })
    })
}

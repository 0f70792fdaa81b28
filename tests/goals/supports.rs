//! What a crane stands on.

use std::hint::black_box;
use std::time::{Duration, Instant};

use lemnis_models::scene::Scene;

use crate::row;

/// The best of so many rounds.
fn best(rounds: u32, mut call: impl FnMut()) -> Duration {
    let round = |_| {
        let start = Instant::now();
        call();
        start.elapsed()
    };
    (0..rounds).map(round).min().unwrap_or_default()
}

/// Tipping loads all around, and a load chart, that of the ready scene with more of both; with supports that are full.
pub fn rows() {
    let text = include_str!("../../models/scenes/mobile_crane.toml");
    let mut model = Scene::parse(text).expect("a ready scene").model().expect("it stands");
    let index = model
        .variables()
        .iter()
        .position(|v| v.symbol.id == "P")
        .expect("there");
    let around = best(200, || {
        for angle in 0..360 {
            model.set(0, f64::from(angle).to_radians()).expect("an angle");
            black_box(model.get(index).expect("it stands"));
        }
    });
    let micro = |time: Duration| time.as_nanos() as f64 / 1e3;
    row(
        "model: tipping load of a mobile crane, 360 angles",
        micro(around),
        "us",
        20.0,
    );
    let many = text
        .replace("\"32.3 m\"]", "\"32.3 m\", \"34 m\"]")
        .replace("R_to    = \"30 m\"", "R_to    = \"32 m\"");
    let full = many
        .replace("x = \"2.2 m\"\n", "x = \"2.2 m\"\nN_cap = \"190 kN\"\n")
        .replace("x = \"-2.9 m\"\n", "x = \"-2.9 m\"\nN_cap = \"190 kN\"\n");
    for (what, text) in [
        ("scene: load chart of 8 lengths x 30 reaches", &many),
        ("scene: the same, with what supports bear", &full),
    ] {
        let read = best(20, || {
            black_box(Scene::parse(text).expect("a chart"));
        });
        row(what, micro(read) / 1e3, "ms", 10.0);
    }
}

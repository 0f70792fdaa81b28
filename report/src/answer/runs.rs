//! How a scene moves in time: the runs of its book, frame by frame, for a page that plays them.

use lemnis_models::component::sheet::{Seen, Sheet};
use lemnis_models::kernel::calc::Calc;
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::kernel::variable::TIME;
use lemnis_models::parts::{hanging, turntable};
use lemnis_models::scene::Scene;
use serde::Serialize;

use crate::answer::drawn::Drawn;
use crate::answer::shown::{Axis, Teller};
use crate::language::Language;
use crate::print::precision;
use crate::print::script::Script;
use crate::results;

/// A run, of so many frames.
#[derive(Serialize)]
pub struct Run {
    pub name: Script,
    /// Between its frames, in s.
    pub step: f64,
    /// When each frame is, and where the coordinate is then.
    pub time: Framed,
    pub coordinate: Framed,
    pub drawing: Drawn,
    /// From the head to the load, in m: forward, upward, and to the left; empty where none swings.
    pub hangs: Vec<[f64; 3]>,
    /// How far it has slewed, in rad, counter-clockwise from above; empty where it does not.
    pub slewed: Vec<f64>,
}

/// A quantity of every frame, as a person reads it.
#[derive(Serialize)]
pub struct Framed {
    #[serde(flatten)]
    axis: Axis,
    texts: Vec<String>,
}

/// What is seen, under its name, with its time.
type Named<'a> = (Script, &'static Symbol, &'a Seen);

/// Every run of a text: each manoeuvre, or the cycle that it tells; none of what does not move, or is not right.
#[must_use]
pub fn runs(text: &str, language: &'static Language) -> Vec<Run> {
    let scene = Scene::parse(text).ok();
    let told = scene.and_then(|scene| {
        let sheet = results::sheet(&scene).ok()?;
        Some(told(&scene, &sheet, language))
    });
    told.unwrap_or_default()
}

fn told(scene: &Scene, sheet: &Sheet, language: &'static Language) -> Vec<Run> {
    let numbers = &precision::of_results(language, scene.book.digits, sheet);
    let teller = Teller::new(scene, sheet, language, numbers);
    let mut all: Vec<Named<'_>> = Vec::new();
    if let Some(motion) = &sheet.motion {
        let runs = motion.manoeuvres.iter();
        all.extend(runs.map(|run| (teller.word("manoeuvre", run.id), motion.time, &run.seen)));
    }
    if let Some(cycle) = &sheet.cycle {
        all.push((teller.word("chapter", "cycle"), &TIME, &cycle.seen));
    }
    let place = |symbol: &'static Symbol, values: &[f64]| Framed {
        axis: teller.axis(symbol, None),
        texts: numbers.column(symbol, values.iter().copied()),
    };
    let run = |(name, time, seen): Named<'_>| {
        let (coordinate, places) = seen.values.first()?;
        let times: Vec<f64> = (0..places.len()).map(|i| i as f64 * seen.step).collect();
        Some(Run {
            name,
            step: seen.step,
            time: place(time, &times),
            coordinate: place(coordinate, places),
            drawing: Drawn::new(scene, places.iter().copied()),
            hangs: hanging(seen),
            slewed: of(seen, &turntable::PSI_SL).to_vec(),
        })
    };
    all.into_iter().filter_map(run).collect()
}

fn of<'a>(seen: &'a Seen, symbol: &Symbol) -> &'a [f64] {
    let known = seen.values.iter().find(|(known, _)| *known == symbol);
    known.map_or(&[], |(_, values)| values)
}

/// The rope from the head, by its angles in the mechanism's plane and from it, and its length.
fn hanging(seen: &Seen) -> Vec<[f64; 3]> {
    let [forward, aside, length] = [&hanging::PHI_R, &turntable::CHI_R, &hanging::L_R].map(|symbol| of(seen, symbol));
    let rope = |(i, length): (usize, &f64)| {
        let angles = [forward, aside].map(|angles| angles.get(i).copied().unwrap_or(0.0));
        let [(sin, cos), (left, along)] = angles.map(Calc::sin_cos);
        [length * sin * along, -length * cos * along, length * left]
    };
    length.iter().enumerate().map(rope).collect()
}

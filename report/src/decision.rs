//! The scene that is built: what a scene leaves open is decided, and its default experiment runs.

use std::ops::Range;
use std::path::Path;

use lemnis::results::lasting;
use lemnis_models::kernel::diagnostic::Diagnostic;
use lemnis_models::kernel::gravity;
use lemnis_models::kernel::number::short;
use lemnis_models::kernel::variable::Fault;
use lemnis_models::scene::Scene;
use lemnis_trade::setting::Method;
use lemnis_trade::trade::SAMPLE;
use toml_edit::{Document, TableLike, value};

use crate::failure::Failure;
use crate::measuring::{dispensable, measured, verdict};
use crate::output::say;
use crate::progress::busy;
use crate::scene_file;

/// A scene of which nothing is open any more.
pub struct Decision {
    pub scene: Scene,
    /// What was decided, a line each.
    pub notes: Vec<String>,
}

impl Decision {
    /// The scene, after telling what was decided.
    pub fn announced(self) -> Result<Scene, Failure> {
        self.notes.iter().try_for_each(say)?;
        Ok(self.scene)
    }
}

/// The scene of a file, without a path the embedded one, with all decided that it leaves open.
pub fn to_build(path: Option<&Path>) -> Result<Decision, Failure> {
    decided(scene_file::read(path)?, &scene_file::name(path))
}

/// Decides what a scene from a file of this name leaves open. The same scene always gives the same FMU: nothing is
/// chosen by the clock.
pub fn decided(scene: Scene, name: &str) -> Result<Decision, Failure> {
    let mut notes = Vec::new();
    let scene = match scene.is_auto() {
        true => chosen(&scene, name, &mut notes)?,
        false => scene,
    };
    let scene = busy(format!("running the default experiment of {}", scene.name()), || {
        running(scene, name, &mut notes)
    })?;
    Ok(Decision { scene, notes })
}

/// The table at a path, with points between its names.
fn within<'a>(table: &'a mut dyn TableLike, path: &str) -> Option<&'a mut dyn TableLike> {
    path.split('.')
        .try_fold(table, |table, name| table.get_mut(name)?.as_table_like_mut())
}

/// The same scene with the cheapest level, step and tolerance that keep to its accuracy, by counted work.
fn chosen(scene: &Scene, name: &str, notes: &mut Vec<String>) -> Result<Scene, Failure> {
    let undecided = |message: String| {
        let given = Document::parse(scene.text()).ok();
        let place = given.and_then(|given| given.get(scene.table)?.get("fidelity")?.span());
        let help = format!("choose one of {}", scene.levels().join(", "));
        refused(scene, name, place, message, "not decided by measuring", Some(help))
    };
    let traded = measured(scene, SAMPLE, 0).map_err(|failure| undecided(failure.to_string()))?;
    let told = verdict(scene, &traded);
    let Some(row) = traded.choice() else {
        return Err(undecided(told));
    };
    notes.push(told);
    notes.extend(dispensable(&traded));
    let level = row.setting.level;
    let unused = scene.mechanism.unused(level);
    let solver = scene.mechanism.solver();
    let steps = solver.map_or("", |solver| solver.step.0);
    let own_gravity = format!("{}.{steps}.{}", scene.table, gravity::G.id);
    scene_file::changed(scene, &format!("the scene at level {level}"), |document| {
        if unused.contains(&(steps, &[])) && scene.given.of(&own_gravity).is_some() {
            // What weighs by it stays.
            document.insert(gravity::G.id, value(gravity::G.written(scene.gravity)));
        }
        for (table, keys) in unused.iter().copied() {
            // A part that stands beside its mechanism.
            if keys.is_empty() {
                document.remove(table);
            } else if let Some(table) = within(document.as_table_mut(), table) {
                keys.iter().for_each(|key| drop(table.remove(key)));
            }
        }
        let Some(mechanism) = document[scene.table].as_table_like_mut() else {
            return;
        };
        mechanism.insert("fidelity", value(level));
        for (table, keys) in unused {
            if keys.is_empty() {
                mechanism.remove(table);
            } else if let Some(table) = within(mechanism, table) {
                keys.iter().for_each(|key| drop(table.remove(key)));
            }
        }
        if matches!(row.setting.method, Method::Explicit(_)) && !mechanism.contains_key(steps) {
            mechanism.insert(steps, toml_edit::table());
        }
        if let Some(table) = mechanism.get_mut(steps).and_then(|item| item.as_table_like_mut()) {
            let step = match row.setting.method {
                Method::Explicit(step) => step,
                Method::Closed | Method::Implicit(_) | Method::Interpolated(_) => traded.sample,
            };
            table.insert("step", value(milliseconds(step)));
        }
        if let (Some((table, symbol)), Method::Implicit(tolerance)) =
            (solver.map(|solver| solver.tolerance), row.setting.method)
            && let Some(table) = mechanism.get_mut(table).and_then(|item| item.as_table_like_mut())
        {
            table.insert(symbol.id, value(format!("{tolerance:e}")));
        }
        if let Method::Interpolated(tolerance) = row.setting.method {
            let mut table = toml_edit::Table::new();
            table.insert("tol", value(format!("{tolerance:e}")));
            mechanism.insert("table", toml_edit::Item::Table(table));
        } else {
            mechanism.remove("table");
        }
    })
}

/// Inner steps (s) that are tried where that of a scene is too long.
const STEPS: [f64; 9] = [5e-2, 2e-2, 1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4];

/// The same scene with an inner step at which the default experiment of its FMU runs.
fn running(scene: Scene, name: &str, notes: &mut Vec<String>) -> Result<Scene, Failure> {
    let cannot = |found: &Stopped| {
        let at = short(found.time);
        format!(
            "the FMU cannot run its default experiment: at {at} s, {}",
            found.fault.message
        )
    };
    let given = |key: &str| scene.given.of(key).map(|given| given.place.clone());
    let lasts = lasting(&scene).map_err(|found| scene_file::failure(name, scene.text(), &[*found]))?;
    let Err(stopped) = run(&scene) else {
        return Ok(scene);
    };
    let own = scene.mechanism.solver().filter(|solver| solver.explicit);
    let (longest, table) = own.map_or((0.0, ""), |own| (own.longest, own.step.0));
    let inner = format!("{}.{table}.step", scene.table);
    for step in STEPS.into_iter().filter(|step| *step < longest) {
        let milliseconds = milliseconds(step);
        let called = format!("the scene at step = {milliseconds}");
        let shorter = scene_file::changed(&scene, &called, |document| {
            document[scene.table][table]["step"] = value(milliseconds.as_str());
        });
        // A step may also be too short for its scene.
        let Ok(shorter) = shorter else { continue };
        if lasting(&shorter).is_err() || run(&shorter).is_err() {
            continue;
        }
        if let Some(place) = given(&inner) {
            let help = format!("step = \"{milliseconds}\" runs; without the key one is chosen");
            return Err(refused(
                &scene,
                name,
                Some(place),
                cannot(&stopped),
                "too long",
                Some(help),
            ));
        }
        notes.push(format!(
            "the default experiment needs shorter inner steps than {}: {inner} = \"{milliseconds}\" is chosen",
            self::milliseconds(longest)
        ));
        return Ok(shorter);
    }
    let label = format!("it lasts {} s", short(lasts));
    let speed = given(&format!("{}.motion.speed", scene.table));
    Err(refused(&scene, name, speed, cannot(&stopped), label, None))
}

/// Refuses a scene at what it gives.
fn refused(
    scene: &Scene,
    name: &str,
    place: Option<Range<usize>>,
    message: String,
    label: impl Into<String>,
    help: Option<String>,
) -> Failure {
    let mut diagnostic = Diagnostic::new(place.unwrap_or(0..0), message, label);
    diagnostic.help = help;
    scene_file::failure(name, scene.text(), &[diagnostic])
}

/// Why a default experiment ended, and when, in s.
struct Stopped {
    time: f64,
    fault: Fault,
}

/// Runs the default experiment as an importer does, where something is solved; what is in closed form was checked over
/// the whole working range.
fn run(scene: &Scene) -> Result<(), Stopped> {
    let at = |time: f64| move |fault: Fault| Stopped { time, fault };
    let mut model = scene.model().map_err(at(0.0))?;
    if model.states() == 0 {
        return Ok(());
    }
    model.start().map_err(at(0.0))?;
    let (stop, step) = (model.stop_time(), model.step_size());
    let mut time = 0.0;
    for i in 1_u32.. {
        let next = stop.min(f64::from(i) * step);
        model.advance(time, next).map_err(at(time))?;
        time = next;
        if time >= stop {
            break;
        }
    }
    Ok(())
}

fn milliseconds(step: f64) -> String {
    format!("{} ms", short(step * 1e3))
}

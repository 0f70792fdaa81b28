//! What the parts of a scene give and cost: each in turn is left out, and the rest makes the same motion.
//!
//! A part is a table without which the scene is still one that reaches the same level and has the same results, and
//! less to say of its motion. What belongs to nothing without it, such as a limit of its results, goes with it.

use std::ops::Range;

use lemnis_models::kernel::variable::{Fault, Variable};
use lemnis_models::scene::Scene;
use toml_edit::{Document, Item, Table};

use crate::compared::{Asked, Size, all_keep, distance};
use crate::experiment::{Experiment, Seen};
use crate::setting::Setting;
use crate::timed::Timed;

/// A part, and what comes of leaving it out.
#[derive(Clone, Debug)]
pub struct Part {
    /// Its table, by its path in the scene.
    pub table: String,
    /// What the rest comes to, or why it does not run.
    pub without: Result<Without, Fault>,
}

/// A scene without one of its parts.
#[derive(Clone, Debug)]
pub struct Without {
    /// That of the whole scene, or a finer one where the rest does not run at that.
    pub setting: Setting,
    /// Seconds of the clock for each simulated second; `None` without a clock.
    pub seconds: Option<f64>,
    /// The same by counted work.
    pub cost: f64,
    /// How far each result asked for is off, against the solution with the part.
    pub errors: Vec<Size>,
    /// Whether every result asked for is still as accurate as it must be; `None` where nothing is asked.
    pub holds: Option<bool>,
}

/// A scene without each of its parts, with the part's table.
#[must_use]
pub fn left_out(scene: &Scene, deepest: &str, asked: &[Asked]) -> Vec<(String, Scene)> {
    let names = |scene: &Scene| -> Option<Vec<String>> {
        let model = scene.at(deepest).model().ok()?;
        Some(model.variables().iter().map(Variable::name).collect())
    };
    let (Ok(document), Some(all)) = (Document::parse(scene.text()), names(scene)) else {
        return Vec::new();
    };
    let tables = |table: &Table| -> Vec<String> {
        let tables = table.iter().filter(|(_, item)| matches!(item, Item::Table(_)));
        tables.map(|(name, _)| name.to_owned()).collect()
    };
    let own = document.get(scene.table).and_then(Item::as_table);
    let within = own.map(tables).unwrap_or_default().into_iter();
    let beside = tables(&document).into_iter().filter(|name| name != scene.table);
    let paths = within.map(|name| vec![scene.table.to_owned(), name]);
    let paths = paths.chain(beside.map(|name| vec![name]));
    let part = |path: Vec<String>| {
        let rest = rest(scene.text(), &path)?;
        let known = names(&rest).filter(|_| rest.table == scene.table && rest.levels().contains(&deepest))?;
        let tells = asked.iter().all(|asked| known.contains(&asked.name));
        (tells && known != all).then(|| (path.join("."), rest))
    };
    paths.filter_map(part).collect()
}

/// How often what is left over is looked for: mistakes of one kind can hide others.
const ROUNDS: usize = 4;

/// What a text says without something in it, and without what then belongs to nothing.
fn rest(text: &str, path: &[String]) -> Option<Scene> {
    let mut text = removed(text, path)?;
    for _ in 0..ROUNDS {
        let found = match Scene::parse(&text) {
            Ok(scene) => return Some(scene),
            Err(found) => found,
        };
        let document = Document::parse(text.as_str()).ok()?;
        let over = found.iter().map(|mistake| given_at(&document, &mistake.span));
        let over: Vec<_> = over.collect::<Option<_>>()?;
        for path in over {
            text = removed(&text, &path).unwrap_or(text);
        }
    }
    None
}

fn removed(text: &str, path: &[String]) -> Option<String> {
    let mut document = Document::parse(text).ok()?.into_mut();
    let (last, above) = path.split_last()?;
    let mut table = document.as_table_mut();
    for name in above {
        table = table.get_mut(name)?.as_table_mut()?;
    }
    table.remove(last)?;
    Some(document.to_string())
}

/// The key whose value stands at a place; `None` where none does.
fn given_at(table: &Table, place: &Range<usize>) -> Option<Vec<String>> {
    table.iter().find_map(|(name, item)| match item {
        Item::Table(inner) => {
            let path = given_at(inner, place)?;
            Some([vec![name.to_owned()], path].concat())
        }
        _ => {
            let value = item.span()?;
            (value.start <= place.start && place.end <= value.end).then(|| vec![name.to_owned()])
        }
    })
}

/// Each scene without a part at a setting, beside the solution with all of them.
pub fn parts(
    left_out: Vec<(String, Scene)>,
    experiment: &Experiment,
    setting: &Setting,
    asked: &[Asked],
    truth: &Seen,
    rounds: usize,
) -> Vec<Part> {
    let names: Vec<String> = asked.iter().map(|asked| asked.name.clone()).collect();
    let without = |rest: &Scene| -> Result<Without, Fault> {
        let fine = Setting::fine(rest, setting.level);
        let mut model = fine.model(rest, experiment.sample)?;
        let seen = experiment.run(rest, &mut model, &names, &mut |model, from, to| model.advance(from, to))?;
        let finer = Setting::all(rest, setting.level, experiment.sample);
        let mut finer = finer.into_iter().skip_while(|other| other != setting).skip(1);
        let mut own = *setting;
        let timed = loop {
            match Timed::new(rest, experiment, &own, &names, (names.len(), rounds)) {
                Ok(timed) => break timed,
                Err(fault) => own = finer.next().ok_or(fault)?,
            }
        };
        let errors: Vec<Size> = seen
            .series
            .iter()
            .zip(&truth.series)
            .map(|(a, b)| distance(a, b))
            .collect();
        Ok(Without {
            setting: own,
            seconds: timed.seconds,
            cost: timed.cost,
            holds: all_keep(asked, errors.iter().map(|error| error.max)),
            errors,
        })
    };
    let part = |(table, rest): (String, Scene)| Part {
        without: without(&rest),
        table,
    };
    left_out.into_iter().map(part).collect()
}

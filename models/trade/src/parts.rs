//! What the parts of a scene give and cost: each in turn is left out, and the rest makes the same motion.
//!
//! A part is a table without which the scene is still one that reaches the same level and has the same results, and
//! less to say of its motion; or a key of a table, or a table within one beside the mechanism's, without which its motion begins in
//! another way. What belongs to nothing without it, such as a limit of its results, goes with it.

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
    /// Its table, or its keys, by their path in the scene.
    pub path: String,
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

/// What a model has to say: the names of its variables, how many events its motion may have, and its states and their
/// rates at the start.
struct Tells {
    names: Vec<String>,
    events: usize,
    start: [Vec<f64>; 2],
}

impl Tells {
    fn new(scene: &Scene, level: &str) -> Option<Tells> {
        let mut model = scene.at(level).model().ok()?;
        let mut start = [0; 2].map(|_| vec![0.0; model.states()]);
        // What does not begin is told when it is to run.
        if model.start().is_ok() {
            model.get_states(&mut start[0]);
            model.rates(&mut start[1]).ok()?;
        }
        Some(Tells {
            names: model.variables().iter().map(Variable::name).collect(),
            events: model.indicators(),
            start,
        })
    }

    /// Whether it is the motion of another one, too, where that has less to say.
    fn moves_as(&self, other: &Tells) -> bool {
        self.events == other.events && self.start == other.start
    }
}

/// A scene without each of its parts, with the part's path.
#[must_use]
pub fn left_out(scene: &Scene, deepest: &str, asked: &[Asked]) -> Vec<(String, Scene)> {
    let (Ok(document), Some(all)) = (Document::parse(scene.text()), Tells::new(scene, deepest)) else {
        return Vec::new();
    };
    let own = document.get(scene.table).and_then(Item::as_table);
    let within = own.into_iter().flat_map(Table::iter);
    let within = within.map(|(name, item)| (vec![scene.table.to_owned(), name.to_owned()], item));
    let beside = document.iter().filter(|(name, _)| *name != scene.table);
    let beside = beside.flat_map(|(name, item)| {
        let inner = item.as_table().into_iter().flat_map(Table::iter);
        let inner = inner.map(|(own, item)| (vec![name.to_owned(), own.to_owned()], item));
        std::iter::once((vec![name.to_owned()], item)).chain(inner)
    });
    let tables = within
        .chain(beside)
        .filter_map(|(path, item)| Some((path, item.as_table()?)));
    let mut found: Vec<(String, Scene)> = Vec::new();
    for (path, table) in tables {
        let within_part = path.len() > 1 && path[0] != scene.table;
        let keys = table.iter().filter(|(_, item)| item.is_value());
        let keys = keys.map(|(name, _)| [path.clone(), vec![name.to_owned()]].concat());
        for (is_key, path) in std::iter::once((false, path.clone())).chain(keys.map(|path| (true, path))) {
            let Some((rest, gone)) = rest(scene.text(), path) else {
                continue;
            };
            let same = rest.table == scene.table && rest.levels().contains(&deepest);
            let Some(less) = Tells::new(&rest, deepest).filter(|_| same) else {
                continue;
            };
            let tells = asked.iter().all(|asked| less.names.contains(&asked.name));
            let is_part = less.names != all.names && !((is_key || within_part) && less.moves_as(&all));
            let known = found.iter().any(|(_, other)| other.text() == rest.text());
            if tells && is_part && !known {
                let names = if is_key { of_table(&gone) } else { gone[0].join(".") };
                found.push((names, rest));
            }
        }
    }
    found
}

/// The first key that is gone, and what is gone of the same table.
fn of_table(gone: &[Vec<String>]) -> String {
    let (name, table) = gone[0].split_last().expect("a path");
    let others = gone[1..].iter().filter_map(|path| path.split_last());
    let others = others
        .filter(|(_, other)| *other == table)
        .map(|(name, _)| name.as_str());
    let names: Vec<&str> = std::iter::once(name.as_str()).chain(others).collect();
    format!("{}.{}", table.join("."), names.join(", "))
}

/// How often what is left over is looked for: mistakes of one kind can hide others.
const ROUNDS: usize = 8;

/// What a text says without something in it, and without what then belongs to nothing; the paths of all that is gone.
fn rest(text: &str, path: Vec<String>) -> Option<(Scene, Vec<Vec<String>>)> {
    let mut text = removed(text, &path)?;
    let mut gone = vec![path];
    for _ in 0..ROUNDS {
        let found = match Scene::parse(&text) {
            Ok(scene) => return Some((scene, gone)),
            Err(found) => found,
        };
        let document = Document::parse(text.as_str()).ok()?;
        let over = found.iter().map(|mistake| given_at(&document, &mistake.span));
        let over: Vec<_> = over.collect::<Option<_>>()?;
        for path in over {
            text = removed(&text, &path).unwrap_or(text);
            gone.push(path);
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
    let part = |(path, rest): (String, Scene)| Part {
        without: without(&rest),
        path,
    };
    left_out.into_iter().map(part).collect()
}

//! A scene's text with other values: comments and all else stay.

use lemnis_models::kernel::origin::Known;
use lemnis_models::scene::Scene;
use pyo3::FromPyObject;
use toml_edit::{DocumentMut, Item, Table, TableLike, Value};

/// What is to stand behind a key.
#[derive(Clone, Debug, FromPyObject)]
pub enum Change {
    Text(String),
    Count(i64),
    /// In SI.
    Number(f64),
}

/// A step of a path: a key, and which table of a list, numbered from 1.
type Step = (String, Option<usize>);

/// The steps of a key such as `steering.groups[2].x` or `accuracy."A.x"`; `None` for what is no key.
fn steps(path: &str) -> Option<Vec<Step>> {
    let mut steps = Vec::new();
    let mut rest = path;
    loop {
        let (name, after) = match rest.strip_prefix('"') {
            Some(quoted) => quoted.split_once('"')?,
            None => rest.split_at(rest.find(['.', '[']).unwrap_or(rest.len())),
        };
        let (number, after) = match after.strip_prefix('[') {
            Some(list) => {
                let (number, after) = list.split_once(']')?;
                (Some(number.parse().ok().filter(|number| *number > 0)?), after)
            }
            None => (None, after),
        };
        if name.is_empty() {
            return None;
        }
        steps.push((name.to_owned(), number));
        match (after, after.strip_prefix('.')) {
            ("", _) => return Some(steps),
            (_, Some(next)) => rest = next,
            _ => return None,
        }
    }
}

/// A table of a table, made where it is missing.
fn within<'a>(table: &'a mut dyn TableLike, (name, number): &Step) -> Option<&'a mut dyn TableLike> {
    if table.get(name).is_none() && number.is_none() {
        table.insert(name, Item::Table(Table::new()));
    }
    let item = table.get_mut(name)?;
    match (number, item) {
        (None, item) => item.as_table_like_mut(),
        (Some(number), Item::ArrayOfTables(list)) => list.get_mut(number - 1).map(|table| table as _),
        (Some(number), item) => {
            let one = item.as_array_mut()?.get_mut(number - 1)?;
            one.as_inline_table_mut().map(|table| table as _)
        }
    }
}

/// Text or number as the scene is to have it.
fn written(key: &str, known: Option<&Known>, before: Option<&Item>, change: &Change) -> Result<Value, String> {
    let counted = before.is_some_and(Item::is_integer);
    let number = match change {
        Change::Text(text) => return Ok(text.as_str().into()),
        Change::Count(count) if counted => return Ok((*count).into()),
        // Whole numbers that are quantities.
        Change::Count(count) => *count as f64,
        Change::Number(number) => *number,
    };
    match known {
        Some(known) if number.is_finite() => Ok(known.symbol.in_si(number).into()),
        Some(known) => Err(format!(
            "`{key}` = {} is not allowed: it must be a finite number",
            known.symbol.written(number)
        )),
        None if counted => Err(format!("`{key}` is a whole number, {number:?} is none")),
        None => Err(format!(
            "`{key}` is no quantity that this scene gives: write its value as text, with its unit"
        )),
    }
}

/// The text with other values behind some keys, each as the scene has it or from the top of the scene.
///
/// # Errors
/// What is no key, or a number for what is no quantity.
pub fn replaced(scene: &Scene, changes: &[(String, Change)]) -> Result<String, String> {
    let mut document: DocumentMut = scene.text().parse().map_err(|error| format!("not TOML: {error}"))?;
    for (key, change) in changes {
        let known = scene.given.known(key);
        // A part may stand at the top of the scene.
        let given = known.and_then(|known| known.given.as_ref());
        let path = given.map_or(key.as_str(), |origin| origin.key.as_str());
        let nothing = || format!("`{key}` is no key of this scene");
        let steps = steps(path).ok_or_else(nothing)?;
        let Some(((name, None), path)) = steps.split_last() else {
            return Err(nothing());
        };
        let mut table: &mut dyn TableLike = document.as_table_mut();
        for step in path {
            table = within(table, step).ok_or_else(nothing)?;
        }
        let mut value = written(key, known, table.get(name), change)?;
        match table.get_mut(name) {
            // An input stays one, with another start, which comes from elsewhere.
            Some(item) if item.get("input").is_some() => {
                item["input"] = Item::Value(value);
                item.as_table_like_mut().map(|note| note.remove("source"));
            }
            Some(Item::Value(before)) => {
                *value.decor_mut() = before.decor().clone();
                *before = value;
            }
            _ => drop(table.insert(name, Item::Value(value))),
        }
    }
    Ok(document.to_string())
}

//! From a scene's checked tables to the mechanism that they describe.

use toml::de::DeTable;

use crate::component::mechanism::Mechanism;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::gravity;
use crate::kernel::origin::line;
use crate::kernel::schema::{KIND, Values};
use crate::registry;

/// Most characters of a scene's name.
pub const LONGEST_NAME: usize = 60;

/// Parts that stand beside the scene's mechanism are those of its own table.
pub(crate) fn gather(values: &mut Values, found: &mut Vec<Diagnostic>) {
    let given = registry::mechanisms(|name| values.has(name));
    if let [mechanism] = given.as_slice() {
        for part in registry::beside(mechanism) {
            found.extend(values.adopt(part, mechanism).err());
        }
    }
}

/// Acceleration of gravity: that of the top of the scene or of its mechanism's dynamics, which must agree.
pub(crate) fn gravity(text: &str, values: &Values, found: &mut Vec<Diagnostic>) -> f64 {
    let id = gravity::G.id;
    let dynamics = registry::tables().find_map(|name| values.table(name)?.table("dynamics"));
    let own = dynamics.and_then(|table| Some((table.number(id)?, table.place(id))));
    match (values.number(id), own) {
        (Some(top), Some((own, place))) if top != own => {
            let [top, own] = [top, own].map(|value| gravity::G.written(value));
            let line = line(text, &values.place(id));
            let message = format!("g = {own} here and g = {top} in line {line}");
            found.push(
                Diagnostic::new(place, message, "another value")
                    .help("there is one acceleration of gravity: remove one"),
            );
            gravity::STANDARD
        }
        (Some(g), _) | (None, Some((g, _))) => g,
        (None, None) => gravity::STANDARD,
    }
}

/// The scene's one mechanism, with the table that describes it.
pub(crate) fn mechanism(
    scene: &DeTable<'_>,
    values: &Values,
    gravity: f64,
    found: &mut Vec<Diagnostic>,
) -> Option<(&'static str, Box<dyn Mechanism>)> {
    let given: Vec<(&'static str, &Values)> = registry::mechanisms(|name| values.has(name))
        .into_iter()
        .filter_map(|name| Some((name, values.table(name)?)))
        .collect();
    match given.as_slice() {
        [(name, table)] => {
            let kinds = || registry::MECHANISMS.iter().filter(|entry| entry.table == *name);
            // Where a table describes one mechanism alone, the kind is that one's own choice.
            let kind = table.text(KIND).filter(|_| kinds().count() > 1);
            let entry = kinds().find(|entry| kind.is_none_or(|kind| entry.kind == kind))?;
            Some((*name, (entry.read)(table, gravity, found)?))
        }
        // What is wrong with one that cannot be read has been told.
        [] if registry::tables().any(|name| scene.keys().any(|key| key.get_ref() == name)) => None,
        [] => {
            let tables: Vec<String> = registry::tables().map(|name| format!("[{name}]")).collect();
            if let Some(part) = registry::PARTS
                .iter()
                .find_map(|part| values.table(part.name).map(|at| (part.name, at)))
            {
                let (name, table) = part;
                let message = format!("[{name}] is a part of a crane, and there is none");
                found.push(Diagnostic::new(table.span.clone(), message, "of nothing").help(format!(
                    "add the table that it belongs to, one of {}",
                    tables.join(", ")
                )));
                return None;
            }
            found.push(
                Diagnostic::new(values.span.clone(), "the scene has no mechanism", "needed here")
                    .help(format!("add a table {}", tables.join(" or "))),
            );
            None
        }
        [(first, _), (second, table), ..] => {
            let message = format!("the scene has two mechanisms, [{first}] and [{second}]");
            found.push(
                Diagnostic::new(table.span.clone(), message, "the second one").help("make a scene of its own for each"),
            );
            None
        }
    }
}

/// Whether it can name a model.
pub(crate) fn is_identifier(name: &str) -> bool {
    name.len() <= LONGEST_NAME
        && name.starts_with(|c: char| c.is_ascii_alphabetic())
        && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
}

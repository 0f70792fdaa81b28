//! The title block.

use std::collections::BTreeMap;

use lemnis_models::kernel::check;
use lemnis_models::scene::Scene;
use serde::Serialize;

/// Its fields.
const FIELDS: [&str; 8] = [
    "document", "crane", "client", "author", "checker", "approver", "date", "revision",
];

#[derive(Serialize)]
pub(super) struct Title<'a> {
    title: &'a str,
    name: &'a str,
    /// Fields by their keys; none where the scene gives nothing.
    project: BTreeMap<&'static str, Option<&'a str>>,
    revisions: &'a [Vec<String>],
    /// Year, month and day, where the date of the book is written so.
    date: Option<(u16, u8, u8)>,
}

impl<'a> Title<'a> {
    pub(super) fn new(scene: &'a Scene) -> Title<'a> {
        let given = |key: &str| {
            let found = scene.project().iter().find(|(known, _)| *known == key);
            found.map(|(_, text)| text.as_str())
        };
        Title {
            title: scene.title(),
            name: scene.name(),
            project: FIELDS.into_iter().map(|key| (key, given(key))).collect(),
            revisions: scene.revisions(),
            date: given("date").and_then(check::date),
        }
    }
}

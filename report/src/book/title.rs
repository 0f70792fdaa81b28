//! The title block.

use std::collections::BTreeMap;

use lemnis_models::kernel::check;
use lemnis_models::scene::Scene;
use serde::Serialize;

use crate::language::Language;

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
    revisions: Vec<Vec<&'a str>>,
    /// Year, month and day, where the date of the book is written so.
    date: Option<(u16, u8, u8)>,
}

impl<'a> Title<'a> {
    pub(super) fn new(scene: &'a Scene, language: &Language) -> Title<'a> {
        let given = |key: &str| {
            let found = scene.project().iter().find(|(known, _)| *known == key);
            found.map(|(_, text)| text.of(language.code))
        };
        Title {
            title: scene.titles().of(language.code),
            name: scene.name(),
            project: FIELDS.into_iter().map(|key| (key, given(key))).collect(),
            revisions: scene
                .revisions()
                .iter()
                .map(|row| row.iter().map(|text| text.of(language.code)).collect())
                .collect(),
            date: given("date").and_then(check::date),
        }
    }
}

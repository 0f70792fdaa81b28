//! The ready scenes, with what each mechanism looks like.

use lemnis_models::scene::Scene;
use serde::Serialize;

use crate::answer::drawn::Drawn;
use crate::language::Language;

/// Every ready scene: its name and its text.
static SCENES: &[(&str, &str)] = include!(concat!(env!("OUT_DIR"), "/scenes.rs"));

/// The one that is shown where none is asked for.
pub const FIRST: &str = "lemniscate";

#[derive(Serialize)]
pub struct Ready {
    pub id: &'static str,
    pub title: String,
    /// In the middle of its range.
    pub drawing: Drawn,
}

/// All of them, by their names.
pub fn ready(language: &Language) -> impl Iterator<Item = Ready> {
    SCENES.iter().filter_map(|(id, text)| {
        let scene = Scene::parse(text).ok()?;
        let positions = scene.model().ok()?.positions();
        let middle = positions.get(positions.len() / 2).copied();
        Some(Ready {
            id,
            title: scene.titles().of(language.code).to_owned(),
            drawing: Drawn::new(&scene, middle.into_iter()),
        })
    })
}

/// The text of one.
#[must_use]
pub fn text(id: &str) -> Option<&'static str> {
    SCENES.iter().find(|(known, _)| *known == id).map(|(_, text)| *text)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::LANGUAGES;

    #[test]
    fn every_ready_scene_is_shown() {
        assert!(SCENES.len() > 20);
        for language in &LANGUAGES {
            let shown: Vec<Ready> = ready(language).collect();
            assert_eq!(shown.len(), SCENES.len());
            assert!(
                shown
                    .iter()
                    .all(|one| !one.title.is_empty() && one.drawing.positions.len() == 1)
            );
        }
        assert_eq!(text(FIRST), Some(lemnis_models::scene::DEFAULT));
        assert_eq!(text("../Cargo"), None);
    }
}

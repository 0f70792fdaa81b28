//! `lemnis pages`: books for the live page, one after the other in one process, in which only what has changed is laid
//! out again. A line of the standard input is one that is wanted, a line of the standard output its pages.

use std::io::BufRead;

use lemnis::book::Edition;
use lemnis::language::Language;
use lemnis::results;
use lemnis::template::Templates;
use lemnis_models::scene::Scene;
use lemnis_serve::books::{Book, Printed, Wanted};
use lemnis_typeset::{Embedded, Format, Typesetter};

use crate::decision::decided;
use crate::failure::Failure;
use crate::output::say;
use crate::scene_file;

/// What the text is called in messages.
const NAME: &str = "scene";

/// Answers until there are no more lines.
pub fn run() -> Result<(), Failure> {
    std::thread::spawn(|| Embedded.prepare());
    let templates = Templates::embedded();
    for line in std::io::stdin().lock().lines() {
        let line = line.map_err(|error| Failure::File(format!("cannot read the standard input: {error}")))?;
        let wanted: Wanted = serde_json::from_str(&line).map_err(|error| Failure::Program(error.to_string()))?;
        let book: Book = made(&wanted, &templates).map_err(|failure| failure.to_string());
        say(serde_json::to_string(&book).expect("plain data"))?;
    }
    Ok(())
}

fn made(Wanted { text, language, level }: &Wanted, templates: &Templates) -> Result<Printed, Failure> {
    let scene = Scene::parse(text).map_err(|found| scene_file::failure(NAME, text, &found))?;
    let scene = decided(scene, NAME)?.scene;
    let sheet = results::sheet(&scene).map_err(Failure::of_scene)?;
    let unknown = || Failure::Program(format!("no language is called {language}"));
    let edition = Edition {
        language: Language::find(language).ok_or_else(unknown)?,
        level: if level.is_empty() { scene.book.level } else { level },
        templates,
        typesetter: &Embedded,
    };
    let made = edition.typeset(&scene, &sheet, Format::Svg);
    let made = made.map_err(|error| Failure::Program(error.to_string()))?;
    let svg = |bytes: Vec<u8>| String::from_utf8(bytes).expect("SVG is text");
    Ok(Printed {
        pages: made.files.into_iter().map(svg).collect(),
        places: made.places,
    })
}

//! Reading a scene file, and telling what is wrong with it.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};
use lemnis_models::diagnostic::Diagnostic;
use lemnis_models::scene::{DEFAULT, LONGEST, Scene};

use crate::failure::Failure;

/// Reads and checks a scene; without a path the embedded default scene.
pub fn read(path: Option<&Path>) -> Result<Scene, Failure> {
    let Some(path) = path else {
        return Scene::parse(DEFAULT).map_err(|found| Failure::Scene(render("default scene", DEFAULT, &found)));
    };
    let name = path.display().to_string();
    let unreadable = |error: std::io::Error| Failure::File(format!("cannot read the scene {name}: {error}"));
    let mut bytes = Vec::new();
    // One byte more than allowed tells a long file from a fitting one without reading it all.
    File::open(path)
        .map_err(unreadable)?
        .take(LONGEST as u64 + 1)
        .read_to_end(&mut bytes)
        .map_err(unreadable)?;
    if bytes.len() > LONGEST {
        let text =
            format!("{name} is longer than {LONGEST} bytes, the most that a scene may have: is it the right file?");
        return Err(Failure::Scene(text));
    }
    parse(&name, bytes)
}

/// The scene inside a book.
pub fn from_book(path: &Path) -> Result<Scene, Failure> {
    let name = path.display().to_string();
    let bytes = std::fs::read(path).map_err(|error| Failure::File(format!("cannot read the book {name}: {error}")))?;
    let scene = lemnis_typeset::attached(bytes, ".toml").ok_or_else(|| {
        Failure::File(format!(
            "{name} has no scene inside: only PDFs that `lemnis book` made have one"
        ))
    })?;
    parse(&format!("scene inside {name}"), scene)
}

fn parse(name: &str, bytes: Vec<u8>) -> Result<Scene, Failure> {
    let text = String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        Failure::Scene(format!(
            "{name} is not text in UTF-8: byte {at} is the first that is not; save it as UTF-8"
        ))
    })?;
    Scene::parse(&text).map_err(|found| failure(name, &text, &found))
}

/// All mistakes with their lines, as a compiler shows them.
pub fn failure(name: &str, text: &str, found: &[Diagnostic]) -> Failure {
    Failure::Scene(render(name, text, found))
}

fn render(name: &str, text: &str, found: &[Diagnostic]) -> String {
    let mut reports = Vec::new();
    for diagnostic in found {
        let marked = AnnotationKind::Primary
            .span(diagnostic.span.clone())
            .label(&diagnostic.label);
        let mut group = Level::ERROR
            .primary_title(&diagnostic.message)
            .element(Snippet::source(text).path(name).fold(true).annotation(marked));
        if let Some(help) = &diagnostic.help {
            group = group.element(Level::HELP.message(help));
        }
        reports.push(Renderer::plain().render(&[group]));
    }
    reports.join("\n\n")
}

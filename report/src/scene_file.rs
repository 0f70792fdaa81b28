//! Reading a scene file, and telling what is wrong with it.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};
use lemnis_models::kernel::diagnostic::Diagnostic;
use lemnis_models::scene::{DEFAULT, LONGEST, Scene};
use toml_edit::DocumentMut;

use crate::failure::Failure;

/// What a scene is called in messages.
pub fn name(path: Option<&Path>) -> String {
    match path {
        None => "default scene".to_owned(),
        Some(path) if path == Path::new(INPUT) => "standard input".to_owned(),
        Some(path) => path.display().to_string(),
    }
}

/// In the place of a path: the standard input.
pub const INPUT: &str = "-";

/// Reads and checks a scene; without a path the embedded default scene.
pub fn read(path: Option<&Path>) -> Result<Scene, Failure> {
    let name = name(path);
    let Some(path) = path else {
        return parse(&name, DEFAULT.into());
    };
    let unreadable = |error: std::io::Error| Failure::File(format!("cannot read the scene {name}: {error}"));
    let source: Box<dyn Read> = if path == Path::new(INPUT) {
        Box::new(std::io::stdin().lock())
    } else {
        Box::new(File::open(path).map_err(unreadable)?)
    };
    let mut bytes = Vec::new();
    // One byte more than allowed tells a long file from a fitting one without reading it all.
    source
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

/// The scene inside a book, and what it is called in messages.
pub fn from_book(path: &Path) -> Result<(Scene, String), Failure> {
    let name = path.display().to_string();
    let bytes = std::fs::read(path).map_err(|error| Failure::File(format!("cannot read the book {name}: {error}")))?;
    let scene = lemnis_typeset::attached(bytes, ".toml").ok_or_else(|| {
        Failure::File(format!(
            "{name} has no scene inside: only PDFs that `lemnis book` made have one"
        ))
    })?;
    let name = format!("scene inside {name}");
    Ok((parse(&name, scene)?, name))
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

/// A scene with its text changed: `what` it becomes.
///
/// # Errors
/// The text is no scene any more, which is a defect of the program.
pub fn changed(scene: &Scene, what: &str, change: impl FnOnce(&mut DocumentMut)) -> Result<Scene, Failure> {
    let mut document: DocumentMut = scene.text().parse().expect("a scene that was read is TOML");
    change(&mut document);
    Scene::parse(&document.to_string()).map_err(|found| {
        let whole: Vec<String> = found.iter().map(ToString::to_string).collect();
        Failure::Program(format!("{what} cannot be read: {}", whole.join("; ")))
    })
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

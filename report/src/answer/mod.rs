//! What a scene's text gives, as one value for all who ask: the command line, the page in a browser, and other programs.

pub mod dragged;
pub mod drawn;
pub mod editing;
pub mod gallery;
pub mod place;
mod point;
pub mod runs;
pub mod shown;
pub mod told;

use lemnis_models::kernel::diagnostic::{Diagnostic, Edit};
use lemnis_models::kernel::variable::Fault;
use lemnis_models::scene::Scene;
use serde::Serialize;

use crate::answer::place::{Place, Places};
use crate::answer::shown::Shown;
use crate::answer::told::Told;
use crate::language::Language;
use crate::results::Results;

/// What a scene's text gives.
#[derive(Serialize)]
pub struct Answer {
    /// What is wrong, in the order of the text; empty where nothing is.
    pub diagnostics: Vec<Mistake>,
    /// Every result in SI, as `lemnis check --json` prints them.
    #[serde(flatten)]
    pub told: Option<Told>,
    /// The same as a person reads it, and what the mechanism looks like.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shown: Option<Shown>,
}

/// Something wrong in a scene.
#[derive(Debug, Serialize)]
pub struct Mistake {
    pub message: String,
    /// What stands at the place.
    pub label: String,
    /// What to do.
    pub help: Option<String>,
    #[serde(flatten)]
    pub place: Place,
    /// The help, done.
    pub fix: Option<Change>,
}

/// A change of a scene's text.
#[derive(Debug, Serialize)]
pub struct Change {
    #[serde(flatten)]
    pub place: Place,
    /// What takes the place of what stands there.
    pub text: String,
    /// Where in `text` one goes on writing, in code units of UTF-16.
    pub caret: usize,
}

impl Mistake {
    fn new(places: &Places<'_>, found: &Diagnostic) -> Mistake {
        Mistake {
            message: found.message.clone(),
            label: found.label.clone(),
            help: found.help.clone(),
            place: places.of(&found.span),
            fix: found.fix.as_deref().map(|edit| Change::new(places, edit)),
        }
    }
}

impl Change {
    fn new(places: &Places<'_>, edit: &Edit) -> Change {
        Change {
            place: places.of(&edit.replaced),
            caret: edit.text[..edit.caret].encode_utf16().count(),
            text: edit.text.clone(),
        }
    }
}

impl Answer {
    /// Of a text, of which nothing need be right: every result in SI.
    #[must_use]
    pub fn new(text: &str) -> Answer {
        let results = found(text, Results::new);
        Answer {
            told: results.as_ref().ok().map(Told::new),
            shown: None,
            diagnostics: results.err().unwrap_or_default(),
        }
    }

    /// Of a text as [`new`](Answer::new): what a person reads of it in a language, without runs in time where it is asked
    /// of it at rest.
    #[must_use]
    pub fn in_language(text: &str, language: &'static Language, at_rest: bool) -> Answer {
        let of = if at_rest { Results::at_rest } else { Results::new };
        let shown = found(text, of).and_then(|results| {
            Shown::new(&results, language).map_err(|fault| vec![Mistake::new(&Places::new(text), &unplaced(&fault))])
        });
        let (shown, diagnostics) = match shown {
            Ok(shown) => (Some(shown), Vec::new()),
            Err(diagnostics) => (None, diagnostics),
        };
        Answer {
            diagnostics,
            told: None,
            shown,
        }
    }

    /// Of a scene that was read.
    #[must_use]
    pub fn of(results: &Results) -> Answer {
        Answer {
            diagnostics: Vec::new(),
            told: Some(Told::new(results)),
            shown: None,
        }
    }

    /// As JSON, for people too.
    ///
    /// # Panics
    /// Never: it is plain data.
    #[must_use]
    pub fn json(&self) -> String {
        serde_json::to_string_pretty(self).expect("plain data")
    }
}

fn found(text: &str, of: fn(&Scene) -> Result<Results, Fault>) -> Result<Results, Vec<Mistake>> {
    let places = Places::new(text);
    let scene = Scene::parse(text);
    let results = scene.and_then(|scene| of(&scene).map_err(|fault| vec![unplaced(&fault)]));
    results.map_err(|found| found.iter().map(|one| Mistake::new(&places, one)).collect())
}

/// What the model refuses has no place in the text.
fn unplaced(fault: &Fault) -> Diagnostic {
    Diagnostic::new(0..0, fault.message.clone(), "the scene as a whole")
}

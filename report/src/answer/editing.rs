//! Completion and hover for an editor, in the words of a language.

use lemnis_models::kernel::editing;
use lemnis_models::kernel::number::Number;
use lemnis_models::kernel::number::short;
use lemnis_models::kernel::schema::{Key, Kind};
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::scene::KEYS;
use serde::Serialize;

use crate::answer::Change;
use crate::answer::place::{Place, Places};
use crate::language::Language;
use crate::print::script::Script;

/// Something that may be written.
#[derive(Debug, Serialize)]
pub struct Offer {
    pub label: String,
    pub change: Change,
    #[serde(flatten)]
    pub about: About,
}

/// What stands at a place.
#[derive(Debug, Serialize)]
pub struct Hint {
    /// From the top of the scene: `luffing.X_1`.
    pub path: String,
    pub place: Place,
    #[serde(flatten)]
    pub about: About,
}

/// What a key is.
#[derive(Debug, Serialize)]
pub struct About {
    /// What it is, and which way is positive: in the language where a symbol stands behind it, otherwise in English.
    pub text: String,
    pub symbol: Option<Script>,
    /// In which it is printed.
    pub unit: Option<&'static str>,
    /// Least and greatest value that a scene may give, in that unit.
    pub range: Option<[String; 2]>,
    /// What it is where the scene does not give it.
    pub usual: Option<String>,
    pub required: bool,
    pub source: Option<&'static str>,
    pub choices: &'static [&'static str],
}

/// What may be written at a code unit of UTF-16 of a scene's text.
#[must_use]
pub fn complete(text: &str, utf16: usize, language: &Language) -> Vec<Offer> {
    let places = Places::new(text);
    let offer = |found: editing::Completion| Offer {
        change: Change::new(&places, &found.edit),
        about: About::new(&found.key, language),
        label: found.label,
    };
    let found = editing::complete(KEYS, text, places.byte(utf16));
    found.into_iter().map(offer).collect()
}

/// What stands at a code unit of UTF-16 of a scene's text.
#[must_use]
pub fn hover(text: &str, utf16: usize, language: &Language) -> Option<Hint> {
    let places = Places::new(text);
    let found = editing::hover(KEYS, text, places.byte(utf16))?;
    Some(Hint {
        place: places.of(&found.span),
        about: About::new(&found.key, language),
        path: found.path,
    })
}

impl About {
    fn new(key: &Key, language: &Language) -> About {
        let written = |number: Number| language.text(&number);
        let quantity = key.number();
        let symbol = match key.kind {
            Kind::Quantities(symbol, ..) => Some(symbol),
            _ => quantity.map(|(symbol, _)| symbol),
        };
        let own = symbol.filter(|symbol| symbol.text == key.text);
        About {
            text: own.map_or_else(|| key.text.to_owned(), |symbol| meaning(symbol, language)),
            symbol: symbol.map(|symbol| Script::of_math(symbol.print)),
            unit: symbol.map(|symbol| symbol.display.print),
            range: quantity.map(|(symbol, sign)| {
                let limits = sign.limits(symbol, symbol.unit);
                limits.map(|limit| written(short(symbol.shown(limit))))
            }),
            usual: key
                .usual
                .zip(symbol)
                .map(|(usual, symbol)| written(short(symbol.shown(usual)))),
            required: key.required,
            source: own.map(|symbol| symbol.source),
            choices: match key.kind {
                Kind::Choice(choices) | Kind::Choices(choices) => choices,
                _ => &[],
            },
        }
    }
}

/// What a symbol is, in English where nobody has words for it.
fn meaning(symbol: &Symbol, language: &Language) -> String {
    let words = language.dictionary().meaning(symbol);
    words.map_or_else(|| symbol.text.to_owned(), |words| Script::of_markup(words, &[]).plain())
}

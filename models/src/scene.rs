//! A scene: the text file that describes a crane.

use toml::de::DeTable;

use crate::diagnostic::Diagnostic;
use crate::lemniscate::scene::{KEYS as LUFFING, Luffing};
use crate::schema::{self, Key, Kind};

/// The lemniscate crane. [Li2022, Table 1]
pub const DEFAULT: &str = include_str!("../scenes/lemniscate.toml");

/// A longer scene is refused: the longest known has 10 kB.
pub const LONGEST: usize = 1 << 20;

/// The languages that a book can be in, by ISO 639-1; the first is the default.
pub const LANGUAGES: [&str; 3] = ["en", "zh", "bg"];

static KEYS: &[Key] = &[
    Key {
        name: "name",
        kind: Kind::Text,
        required: true,
        text: "Name of the model and of its files: letters, digits and _.",
    },
    Key {
        name: "title",
        kind: Kind::Text,
        required: true,
        text: "Title of the book, one line.",
    },
    Key::table("project", PROJECT, "Title block of the book.").optional(),
    Key::table("book", BOOK, "How the book is made.").optional(),
    Key::table("luffing", LUFFING, "The luffing mechanism."),
];

static PROJECT: &[Key] = &[
    Key {
        name: "crane",
        kind: Kind::Text,
        required: false,
        text: "The crane.",
    },
    Key {
        name: "client",
        kind: Kind::Text,
        required: false,
        text: "For whom the book is made.",
    },
    Key {
        name: "author",
        kind: Kind::Text,
        required: false,
        text: "Who made the calculation.",
    },
    Key {
        name: "checker",
        kind: Kind::Text,
        required: false,
        text: "Who checked it.",
    },
    Key {
        name: "date",
        kind: Kind::Text,
        required: false,
        text: "Date of the book.",
    },
    Key {
        name: "revision",
        kind: Kind::Text,
        required: false,
        text: "Revision of the book.",
    },
];

static BOOK: &[Key] = &[Key {
    name: "language",
    kind: Kind::Choice(&LANGUAGES),
    required: false,
    text: "Language of the book: English, Chinese or Bulgarian.",
}];

/// A checked scene.
#[derive(Clone, Debug)]
pub struct Scene {
    text: String,
    name: String,
    title: String,
    project: Vec<(&'static str, String)>,
    language: String,
    pub luffing: Luffing,
}

impl Scene {
    /// Reads a scene; the error lists every mistake found.
    ///
    /// # Errors
    /// One diagnostic for each mistake, in the order of the text.
    pub fn parse(text: &str) -> Result<Scene, Vec<Diagnostic>> {
        if text.len() > LONGEST {
            let message = format!("the scene has {} bytes, at most {LONGEST} are read", text.len());
            return Err(vec![
                Diagnostic::new(0..0, message, "here").help("is this the right file?"),
            ]);
        }
        let table = DeTable::parse(text).map_err(|error| {
            let span = error.span().unwrap_or(0..0);
            vec![Diagnostic::new(span, format!("not TOML: {}", error.message()), "here")]
        })?;
        let mut found = Vec::new();
        let values = schema::check(
            table.get_ref(),
            0..text.find('\n').unwrap_or(text.len()),
            "",
            KEYS,
            &mut found,
        );
        let name = values.text("name").unwrap_or_default().to_owned();
        if values.text("name").is_some() && !is_identifier(&name) {
            found.push(
                Diagnostic::new(
                    values.place("name"),
                    format!("the name \"{name}\" cannot name a model"),
                    "not an identifier",
                )
                .help("up to 60 letters, digits and _, beginning with a letter"),
            );
        }
        let luffing = values
            .table("luffing")
            .and_then(|table| Luffing::new(table, &mut found));
        match luffing {
            Some(luffing) if found.is_empty() => {
                let project = values.table("project");
                let book = values.table("book");
                Ok(Scene {
                    text: text.to_owned(),
                    name,
                    title: values.text("title").unwrap_or_default().to_owned(),
                    project: PROJECT
                        .iter()
                        .filter_map(|key| Some((key.name, project?.text(key.name)?.to_owned())))
                        .collect(),
                    language: book
                        .and_then(|book| book.text("language"))
                        .unwrap_or(LANGUAGES[0])
                        .to_owned(),
                    luffing,
                })
            }
            _ => {
                found.sort_by_key(|diagnostic| diagnostic.span.start);
                Err(found)
            }
        }
    }

    /// The file as it was read, to the byte.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// A C identifier.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    #[must_use]
    pub fn title(&self) -> &str {
        &self.title
    }

    /// Title block: what is given of crane, client, author, checker, date, revision.
    #[must_use]
    pub fn project(&self) -> &[(&'static str, String)] {
        &self.project
    }

    /// Language of the book, one of [`LANGUAGES`].
    #[must_use]
    pub fn language(&self) -> &str {
        &self.language
    }
}

fn is_identifier(name: &str) -> bool {
    name.len() <= 60
        && name.starts_with(|c: char| c.is_ascii_alphabetic())
        && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
}

/// The JSON Schema of scenes, for editors.
#[must_use]
pub fn json_schema() -> serde_json::Value {
    let mut schema = schema::json_schema(KEYS);
    schema["$schema"] = "https://json-schema.org/draft/2020-12/schema".into();
    schema["title"] = "Lemnis scene".into();
    schema
}

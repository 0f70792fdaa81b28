//! What a scene asks of its book.

use crate::component::mechanism::Mechanism;
use crate::kernel::check;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::schema::{Key, Kind, Values};
use crate::kernel::text::{LANGUAGES, Text};
use crate::parts::motion::Place;

/// Keys of `[book]`.
pub static BOOK: &[Key] = &[
    Key::new("language", Kind::Choice(&LANGUAGES), "Language of the book: English, Chinese or Bulgarian.").optional(),
    Key::choice("level", LEVELS, "Detail of the book: summary (a few pages), standard, or full (every step with its numbers)."),
    Key::new("chapters", Kind::Choices(CHAPTERS), "The chapters in their order; without it those of the level, and no trade, which needs many runs.").optional(),
    Key::new("positions", Kind::Texts(10), "Positions at which the formulas are worked out: angles of the driving link such as \"75 deg\", from, middle, to, \
               or governing results such as M_Q_max; without it the governing one.").optional(),
    Key::part("text", TEXT, "The engineer's own paragraphs at these places of the book; a blank line begins a new paragraph, and words such as X_4 are set as symbols."),
    Key::new("digits", Kind::Count(DIGITS), "Significant digits of results and of tables, 3 to 9; 4 without it. Given quantities stand as \
               they are given, formulas have six digits and more where their results need them.").optional(),
    Key::choice("pdf_standard", &["a-3b", "a-3u", "a-3a"], "PDF/A standard that the PDF keeps to; needs project.date."),
];

/// Places of the book that take the engineer's own paragraphs.
pub static TEXT: &[Key] = &[
    Key::text(
        "task",
        "What is calculated, and for what: before what the book says of its task.",
    ),
    Key::text(
        "scope",
        "What the calculation covers and what it does not: before what the book says of that.",
    ),
    Key::text(
        "load_cases",
        "Load cases and combinations, and the standard that they are of: at the end of the scope.",
    ),
    Key::text("method", "How it is calculated: before conventions and signs."),
    Key::text(
        "conclusion",
        "What follows from the results: on the first page, below the requirements.",
    ),
    Key::text("remarks", "Remarks: before those on the publications."),
];

/// Least and most significant digits of results.
const DIGITS: [u64; 2] = [3, 9];

/// Levels of detail, the least first.
pub const LEVELS: &[&str] = &["summary", "standard", "full"];

/// Chapters of a book in their usual order.
pub const CHAPTERS: &[&str] = &[
    "results",
    "task",
    "inputs",
    "conventions",
    "views",
    "constants",
    "positions",
    "range",
    "charts",
    "forces",
    "sizing",
    "balance",
    "cases",
    "motion",
    "cycle",
    "synthesis",
    "search",
    "trade",
    "study",
    "published",
    "sensitivity",
    "remarks",
    "notation",
    "references",
    "identities",
    "scene",
];

/// What the scene asks of its book.
#[derive(Clone, Debug)]
pub struct Book {
    /// One of [`LANGUAGES`].
    pub language: &'static str,
    /// One of [`LEVELS`]; `standard` where the scene says nothing.
    pub level: &'static str,
    /// Some of [`CHAPTERS`]; `None` for those of the level.
    pub chapters: Option<Vec<&'static str>>,
    /// Where the formulas are worked out; empty for the governing position.
    pub positions: Vec<Place>,
    /// The engineer's own paragraphs, by their places among [`TEXT`].
    pub text: Vec<(&'static str, Text)>,
    /// Significant digits of results and tables, 3 to 9.
    pub digits: usize,
    /// PDF/A standard, such as `a-3b`.
    pub pdf_standard: Option<String>,
}

impl Book {
    /// Of the checked tables of a scene; mistakes go to `found`.
    pub fn new(scene: &Values, mechanism: &dyn Mechanism, found: &mut Vec<Diagnostic>) -> Book {
        let Some(table) = scene.table("book") else {
            return Book::default();
        };
        let has = |chapter: &str| match chapter {
            "study" => scene.has(chapter),
            "search" => scene.has("synthesis"),
            _ => mechanism.has_chapter(chapter),
        };
        let known = |list: &'static [&'static str], text: &str| list.iter().copied().find(|known| *known == text);
        let mut positions = Vec::new();
        for (text, span) in table.texts("positions") {
            match mechanism.place(text) {
                Ok(place) => positions.push(place),
                Err((message, help)) => found.push(
                    Diagnostic::new(span.clone(), format!("`book.positions`: {message}"), "not a position").help(help),
                ),
            }
        }
        let own = table.table("text");
        let chapters = table.texts("chapters").iter();
        let chapters: Vec<&'static str> = chapters.filter_map(|(text, _)| known(CHAPTERS, text)).collect();
        if table.has("chapters")
            && !chapters
                .iter()
                .any(|chapter| has(chapter) || own.is_some_and(|own| own.has(chapter)))
        {
            let all = CHAPTERS.iter().copied().filter(|chapter| has(chapter));
            let help = format!("chapters of this scene: {}", all.collect::<Vec<_>>().join(", "));
            let message = match chapters.as_slice() {
                [] => "a book without chapters".to_owned(),
                _ => "none of these chapters has anything to say of this scene".to_owned(),
            };
            found.push(table.refuse("chapters", message, "an empty book", help));
        }
        let date = scene
            .table("project")
            .and_then(|project| project.text("date"))
            .and_then(check::date);
        if table.text("pdf_standard").is_some() && date.is_none() {
            let message = "`book.pdf_standard` needs the date of the book";
            found.push(table.refuse(
                "pdf_standard",
                message,
                "no date",
                "add date = \"YYYY-MM-DD\" to [project]",
            ));
        }
        Book {
            language: table
                .text("language")
                .and_then(|text| known(&LANGUAGES, text))
                .unwrap_or(LANGUAGES[0]),
            level: table
                .text("level")
                .and_then(|text| known(LEVELS, text))
                .unwrap_or("standard"),
            chapters: (!chapters.is_empty()).then_some(chapters),
            positions,
            text: TEXT
                .iter()
                .filter_map(|key| Some((key.name, own?.words(key.name)?.clone())))
                .collect(),
            digits: table
                .count("digits")
                .and_then(|digits| digits.try_into().ok())
                .unwrap_or(Book::default().digits),
            pdf_standard: table.text("pdf_standard").map(str::to_owned),
        }
    }
}

impl Default for Book {
    fn default() -> Book {
        Book {
            language: LANGUAGES[0],
            level: "standard",
            chapters: None,
            positions: Vec::new(),
            text: Vec::new(),
            digits: 4,
            pdf_standard: None,
        }
    }
}

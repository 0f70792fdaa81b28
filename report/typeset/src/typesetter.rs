//! What makes a document out of a source, and what can come of it.

use std::collections::BTreeMap;
use std::fmt;

/// What Typst objects to, with its place where it has one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error {
    pub message: String,
    /// Virtual path, line and column, counted from 1.
    pub place: Option<(String, usize, usize)>,
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some((file, line, column)) = &self.place {
            write!(f, "{file}:{line}:{column}: ")?;
        }
        f.write_str(&self.message)
    }
}

impl std::error::Error for Error {}

impl Error {
    pub(crate) fn new(message: impl Into<String>) -> Error {
        Error {
            message: message.into(),
            place: None,
        }
    }
}

/// What comes out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    Pdf,
    Svg,
    Png,
    Html,
}

impl Format {
    /// As a suffix of files, and as Typst names it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Format::Pdf => "pdf",
            Format::Svg => "svg",
            Format::Png => "png",
            Format::Html => "html",
        }
    }
}

/// Files that a source reads, by their virtual paths.
pub type Files = [(String, Vec<u8>)];

/// A document that is made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Typeset {
    /// One file; of SVG and PNG one for each page. A PDF is tagged, and valid PDF/UA-1.
    pub files: Vec<Vec<u8>>,
    /// The page, counted from 1, on which each label of the source stands; none where pages are not laid out here.
    pub places: BTreeMap<String, usize>,
    /// Characters that could not be printed, each with its place.
    pub warnings: Vec<String>,
}

/// What turns Typst's source into pages.
pub trait Typesetter: Sync {
    /// Reads what a first document needs; without this it is read when it is needed.
    fn prepare(&self) {}

    /// Typesets `main`, which can read `files`. A warning of Typst is an error.
    /// `standard` is the PDF/A standard to keep to beside PDF/UA-1, such as
    /// `a-3b`; other formats take no notice of it.
    ///
    /// # Errors
    /// The first objection of Typst, to the source or to what the standards ask for.
    fn typeset(&self, main: &str, files: &Files, format: Format, standard: Option<&str>) -> Result<Typeset, Error>;
}

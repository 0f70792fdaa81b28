//! Typst in memory: source and files in, PDF out. No disk, no packages, no
//! date, no system fonts: the same input gives the same bytes everywhere.

use std::collections::HashMap;
use std::fmt;
use std::sync::LazyLock;

use typst::diag::{FileError, FileResult, SourceDiagnostic};
use typst::foundations::{Bytes, Datetime, Duration};
use typst::layout::{Frame, FrameItem};
use typst::syntax::{FileId, RootedPath, Source, VirtualPath, VirtualRoot};
use typst::text::{Font, FontBook};
use typst::utils::LazyHash;
use typst::{Library, LibraryExt, World, WorldExt};
use typst_layout::PagedDocument;
use typst_pdf::PdfOptions;

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

/// Typesets `main`, which can read `files` by their virtual paths. A warning
/// is an error, and so is a character that no font has.
///
/// # Errors
/// The first objection of Typst, or the text with the missing character.
pub fn pdf(main: &str, files: &[(String, Vec<u8>)]) -> Result<Vec<u8>, Error> {
    let main = Source::new(file_id("main.typ")?, main.to_owned());
    let mut world = Memory {
        files: HashMap::from([(main.id(), Bytes::from_string(main.text().to_owned()))]),
        main,
    };
    for (path, bytes) in files {
        world.files.insert(file_id(path)?, Bytes::new(bytes.clone()));
    }
    let compiled = typst::compile::<PagedDocument>(&world);
    let typeset = compiled.output.and_then(|document| match compiled.warnings.first() {
        Some(warning) => Err(std::iter::once(warning.clone()).collect()),
        None => typst_pdf::pdf(&document, &PdfOptions::default()).map(|bytes| (document, bytes)),
    });
    comemo::evict(1);
    let (document, bytes) = typeset.map_err(|objections| world.error(&objections[0]))?;
    match document.pages().iter().find_map(|page| unprintable(&page.frame)) {
        Some(text) => Err(Error {
            message: format!("no font has every character of \"{text}\""),
            place: None,
        }),
        None => Ok(bytes),
    }
}

fn file_id(path: &str) -> Result<FileId, Error> {
    let path = VirtualPath::new(path).map_err(|error| Error {
        message: format!("{path}: {error:?}"),
        place: None,
    })?;
    Ok(RootedPath::new(VirtualRoot::Project, path).intern())
}

/// The text of the first glyph that stands for a missing character.
fn unprintable(frame: &Frame) -> Option<&str> {
    frame.items().find_map(|(_, item)| match item {
        FrameItem::Group(group) => unprintable(&group.frame),
        FrameItem::Text(text) => text
            .glyphs
            .iter()
            .any(|glyph| glyph.id == 0)
            .then_some(text.text.as_str()),
        _ => None,
    })
}

static LIBRARY: LazyLock<LazyHash<Library>> = LazyLock::new(|| LazyHash::new(Library::default()));
static FONTS: LazyLock<Vec<Font>> = LazyLock::new(|| {
    typst_assets::fonts()
        .flat_map(|data| Font::iter(Bytes::new(data)))
        .collect()
});
static BOOK: LazyLock<LazyHash<FontBook>> = LazyLock::new(|| LazyHash::new(FontBook::from_fonts(FONTS.iter())));

struct Memory {
    main: Source,
    files: HashMap<FileId, Bytes>,
}

impl Memory {
    fn error(&self, objection: &SourceDiagnostic) -> Error {
        let place = objection
            .span
            .id()
            .zip(self.range(objection.span))
            .and_then(|(id, range)| {
                let source = self.source(id).ok()?;
                let (line, column) = source.lines().byte_to_line_column(range.start)?;
                Some((id.get().vpath().get_without_slash().to_owned(), line + 1, column + 1))
            });
        let hints = objection.hints.iter().map(|hint| format!("; {}", hint.v));
        Error {
            message: std::iter::once(objection.message.to_string()).chain(hints).collect(),
            place,
        }
    }
}

impl World for Memory {
    fn library(&self) -> &LazyHash<Library> {
        &LIBRARY
    }
    fn book(&self) -> &LazyHash<FontBook> {
        &BOOK
    }
    fn main(&self) -> FileId {
        self.main.id()
    }
    fn source(&self, id: FileId) -> FileResult<Source> {
        if id == self.main.id() {
            return Ok(self.main.clone());
        }
        let text = String::from_utf8(self.file(id)?.to_vec()).map_err(|_| FileError::InvalidUtf8)?;
        Ok(Source::new(id, text))
    }
    fn file(&self, id: FileId) -> FileResult<Bytes> {
        let missing = || FileError::NotFound(id.get().vpath().get_without_slash().into());
        self.files.get(&id).cloned().ok_or_else(missing)
    }
    fn font(&self, index: usize) -> Option<Font> {
        FONTS.get(index).cloned()
    }
    fn today(&self, _: Option<Duration>) -> Option<Datetime> {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_source_gives_the_same_bytes() {
        let files = [("data.json".to_owned(), br#"{"title": "$ #panic() * @x"}"#.to_vec())];
        let source = "#let data = json(\"data.json\")\n= #data.title\n$ frac(1, 2) $";
        let first = pdf(source, &files).unwrap();
        assert!(first.starts_with(b"%PDF"));
        assert_eq!(first, pdf(source, &files).unwrap());
    }

    #[test]
    fn objections_name_their_place() {
        for (source, text) in [
            ("line one\n#unknown", "main.typ:2:2: unknown variable: unknown"),
            (
                "#set text(font: \"Nowhere\")",
                "main.typ:1:17: unknown font family: nowhere",
            ),
            ("#include \"gone.typ\"", "main.typ:1:10: file not found"),
            ("a \u{10ffff} b", "no font has every character of"),
        ] {
            let message = pdf(source, &[]).unwrap_err().to_string();
            assert!(message.starts_with(text), "{message}");
        }
    }
}

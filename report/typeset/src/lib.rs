//! Typst in memory: source and files in, PDF out. No disk, no packages, no
//! date: the same input gives the same bytes everywhere. Only for characters
//! that the embedded fonts lack are the system's fonts asked.

mod fonts;

use std::collections::HashMap;
use std::fmt;
use std::sync::LazyLock;

use typst::diag::{FileError, FileResult, SourceDiagnostic};
use typst::foundations::{Bytes, Datetime, Duration};
use typst::syntax::{FileId, RootedPath, Source, VirtualPath, VirtualRoot};
use typst::text::{Font, FontBook};
use typst::utils::LazyHash;
use typst::{Library, LibraryExt, World, WorldExt};
use typst_layout::PagedDocument;
use typst_pdf::{PdfOptions, PdfStandard, PdfStandards};

use crate::fonts::Fonts;

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

/// A document that is made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Typeset {
    /// Tagged, and valid PDF/UA-1.
    pub pdf: Vec<u8>,
    /// Characters that could not be printed, each with its place.
    pub warnings: Vec<String>,
}

/// Typesets `main`, which can read `files` by their virtual paths. A warning
/// of Typst is an error. A character that no font has, embedded or of the
/// system, gives a warning; its code stands in its place: `U+9F98`.
///
/// # Errors
/// The first objection of Typst, to the source or to what PDF/UA asks for.
pub fn pdf(main: &str, files: &[(String, Vec<u8>)]) -> Result<Typeset, Error> {
    let (world, document, warnings) = pages(main, files)?;
    let options = PdfOptions {
        standards: PdfStandards::new(&[PdfStandard::Ua_1]).expect("one standard fits with itself"),
        ..PdfOptions::default()
    };
    let pdf = typst_pdf::pdf(&document, &options);
    comemo::evict(1);
    let pdf = pdf.map_err(|objections| world.error(&objections[0]))?;
    Ok(Typeset { pdf, warnings })
}

/// The pages, what they are made from, and warnings about missing characters.
fn pages(main: &str, files: &[(String, Vec<u8>)]) -> Result<(Memory, PagedDocument, Vec<String>), Error> {
    let world = Memory::new(main, files, Fonts::embedded().clone())?;
    let document = world.typeset()?;
    let missing: Vec<char> = world.fonts.unprintable(&document).into_keys().collect();
    if missing.is_empty() {
        return Ok((world, document, Vec::new()));
    }
    let fonts = Fonts::embedded().with_system(&missing);
    let document = Memory::new(main, files, fonts.clone())?.typeset()?;
    let (mut source, mut warnings) = (main.to_owned(), Vec::new());
    for (character, place) in fonts.unprintable(&document) {
        let code = format!("U+{:04X}", u32::from(character));
        source = source.replace(character, &code);
        warnings.push(format!(
            "no font has the character \"{character}\" {place}: {code} is printed in its place; install a font that has it"
        ));
    }
    let world = Memory::new(&source, files, fonts)?;
    let document = world.typeset()?;
    Ok((world, document, warnings))
}

fn file_id(path: &str) -> Result<FileId, Error> {
    let path = VirtualPath::new(path).map_err(|error| Error {
        message: format!("{path}: {error:?}"),
        place: None,
    })?;
    Ok(RootedPath::new(VirtualRoot::Project, path).intern())
}

static LIBRARY: LazyLock<LazyHash<Library>> = LazyLock::new(|| LazyHash::new(Library::default()));

struct Memory {
    main: Source,
    files: HashMap<FileId, Bytes>,
    fonts: Fonts,
}

impl Memory {
    fn new(main: &str, files: &[(String, Vec<u8>)], fonts: Fonts) -> Result<Memory, Error> {
        let main = Source::new(file_id("main.typ")?, main.to_owned());
        let mut world = Memory {
            files: HashMap::from([(main.id(), Bytes::from_string(main.text().to_owned()))]),
            main,
            fonts,
        };
        for (path, bytes) in files {
            world.files.insert(file_id(path)?, Bytes::new(bytes.clone()));
        }
        Ok(world)
    }

    fn typeset(&self) -> Result<PagedDocument, Error> {
        let compiled = typst::compile::<PagedDocument>(self);
        match (compiled.output, compiled.warnings.first()) {
            (Err(objections), _) => Err(self.error(&objections[0])),
            (Ok(_), Some(warning)) => Err(self.error(warning)),
            (Ok(document), None) => Ok(document),
        }
    }

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
        &self.fonts.book
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
        self.fonts.get(index)
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
        let source = "#set document(title: \"T\")\n#let data = json(\"data.json\")\n= #data.title\n\
                      #math.equation(alt: \"one half\", $ frac(1, 2) $)";
        let first = pdf(source, &files).unwrap();
        assert!(first.pdf.starts_with(b"%PDF") && first.warnings.is_empty());
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
            ("x", "PDF/UA-1 error: missing document title"),
            (
                "#set document(title: \"T\")\n$ x $",
                "main.typ:2:1: PDF/UA-1 error: missing alt text",
            ),
        ] {
            let message = pdf(source, &[]).unwrap_err().to_string();
            assert!(message.starts_with(text), "{message}");
        }
    }

    #[test]
    fn a_character_that_no_font_has_is_named_and_its_code_printed() {
        let source = "#set document(title: \"T\")\none\n#pagebreak()\ntwo \u{10ffff} three";
        let typeset = pdf(source, &[]).unwrap();
        let [warning] = typeset.warnings.as_slice() else {
            panic!("{:?}", typeset.warnings)
        };
        assert!(
            warning.contains("U+10FFFF is printed") && warning.contains("on page 2, in \"two"),
            "{warning}"
        );
        let written = source.replace('\u{10ffff}', "U+10FFFF");
        assert_eq!(typeset.pdf, pdf(&written, &[]).unwrap().pdf);
    }
}

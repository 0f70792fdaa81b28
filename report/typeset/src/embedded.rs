//! Typst inside this program: the world that it sees, layout and export.

use std::collections::{BTreeMap, HashMap};
use std::num::NonZeroUsize;
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};
use std::thread::ScopedJoinHandle;

use typst::diag::{FileError, FileResult, SourceDiagnostic, SourceResult, Warned};
use typst::foundations::{Bytes, Content, Datetime, Duration};
use typst::introspection::Introspector;
use typst::syntax::{FileId, RootedPath, Source, VirtualPath, VirtualRoot};
use typst::text::{Font, FontBook};
use typst::utils::LazyHash;
use typst::{Feature, Library, LibraryExt, World, WorldExt};
use typst_html::{HtmlDocument, HtmlOptions};
use typst_layout::{Page, PagedDocument};
use typst_pdf::{PdfOptions, PdfStandard, PdfStandards};
use typst_render::RenderOptions;
use typst_svg::SvgOptions;

use crate::fonts::Fonts;
use crate::settled::{self, Places, beside};
use crate::typesetter::{Error, Files, Format, Typeset, Typesetter};

/// The Typst inside this program. A character that no font has, embedded or of
/// the system, gives a warning; its code stands in its place: `U+9F98`.
#[derive(Clone, Copy, Debug)]
pub struct Embedded;

impl Typesetter for Embedded {
    fn prepare(&self) {
        LazyLock::force(&LIBRARY);
        Fonts::embedded();
    }

    fn typeset(&self, main: &str, files: &Files, format: Format, standard: Option<&str>) -> Result<Typeset, Error> {
        make(main, files, format, standard)
    }
}

/// A document in layout. At its end, while it is exported, Typst forgets what as many documents as are in layout did
/// not use: each of them finds what its predecessor left.
pub(crate) struct InWork;

static IN_WORK: AtomicUsize = AtomicUsize::new(0);

impl InWork {
    pub(crate) fn begin() -> InWork {
        IN_WORK.fetch_add(1, Ordering::Relaxed);
        InWork
    }
}

impl Drop for InWork {
    fn drop(&mut self) {
        comemo::evict(IN_WORK.fetch_sub(1, Ordering::Relaxed));
    }
}

fn make(main: &str, files: &Files, format: Format, standard: Option<&str>) -> Result<Typeset, Error> {
    let in_work = InWork::begin();
    if format == Format::Html {
        let world = Memory::new(main, files, Fonts::embedded().clone())?;
        return Ok(Typeset {
            files: vec![html(&world)?],
            places: BTreeMap::new(),
            warnings: Vec::new(),
        });
    }
    let (world, document, warnings) = pages(main, files)?;
    let exported = || -> Result<_, Error> {
        match format {
            Format::Svg => Ok(drawn(document.pages())),
            Format::Png => document.pages().iter().map(png).collect(),
            Format::Pdf | Format::Html => Ok(vec![pdf(&world, &document, standard)?]),
        }
    };
    let files = beside(|| drop(in_work), exported)?;
    Ok(Typeset {
        files,
        places: places(&document),
        warnings,
    })
}

/// On which page each label stands.
fn places(document: &PagedDocument) -> BTreeMap<String, usize> {
    let known = document.introspector();
    let labelled = known.query_labelled().into_iter();
    let place = |content: Content| {
        let page = known.page(content.location()?)?;
        Some((content.label()?.resolve().to_string(), page.get()))
    };
    labelled.filter_map(place).collect()
}

/// The pages, with the world that they are from, and the warnings.
pub(crate) fn pages(main: &str, files: &Files) -> Result<(Memory, PagedDocument, Vec<String>), Error> {
    let mut world = Memory::new(main, files, Fonts::embedded().clone())?;
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
            "no font has the character \"{character}\" {place}: {code} is printed in its place; \
             install a font that has it"
        ));
    }
    let mut world = Memory::new(&source, files, fonts)?;
    let document = world.typeset()?;
    Ok((world, document, warnings))
}

fn pdf(world: &Memory, document: &PagedDocument, standard: Option<&str>) -> Result<Vec<u8>, Error> {
    let mut standards = vec![PdfStandard::Ua_1];
    match standard {
        None => {}
        Some("a-3b") => standards.push(PdfStandard::A_3b),
        Some("a-3u") => standards.push(PdfStandard::A_3u),
        Some("a-3a") => standards.push(PdfStandard::A_3a),
        Some(other) => return Err(Error::new(format!("the PDF standard {other} is not known"))),
    }
    let options = PdfOptions {
        standards: PdfStandards::new(&standards).expect("PDF/A-3 and PDF/UA-1 fit together"),
        ..PdfOptions::default()
    };
    world.check(typst_pdf::pdf(document, &options))
}

/// Each page on one of as many threads as there are cores: none needs another.
fn drawn(pages: &[Page]) -> Vec<Vec<u8>> {
    let threads = std::thread::available_parallelism().map_or(1, NonZeroUsize::get);
    let part = pages.len().div_ceil(threads).max(1);
    std::thread::scope(|scope| {
        let draw = |pages: &[Page]| pages.iter().map(svg).collect::<Vec<_>>();
        let parts: Vec<_> = pages
            .chunks(part)
            .map(|pages| scope.spawn(move || draw(pages)))
            .collect();
        let ended = parts.into_iter().map(ScopedJoinHandle::join);
        ended
            .flat_map(|part| part.unwrap_or_else(|panic| resume_unwind(panic)))
            .collect()
    })
}

fn svg(page: &Page) -> Vec<u8> {
    typst_svg::svg(page, &SvgOptions::default()).into_bytes()
}

fn png(page: &Page) -> Result<Vec<u8>, Error> {
    let pixels = typst_render::render(page, &RenderOptions::default());
    pixels.encode_png().map_err(|error| Error::new(error.to_string()))
}

/// HTML has no pages. What Typst leaves out of it comes as warnings, which the
/// program's help sums up.
fn html(world: &Memory) -> Result<Vec<u8>, Error> {
    let document = world.check(typst::compile::<HtmlDocument>(world).output)?;
    let text = world.check(typst_html::html(&document, &HtmlOptions::default()))?;
    Ok(text.into_bytes())
}

fn file_id(path: &str) -> Result<FileId, Error> {
    let path = VirtualPath::new(path).map_err(|error| Error {
        message: format!("{path}: {error:?}"),
        place: None,
    })?;
    Ok(RootedPath::new(VirtualRoot::Project, path).intern())
}

static LIBRARY: LazyLock<LazyHash<Library>> = LazyLock::new(|| {
    let features = std::iter::once(Feature::Html).collect();
    LazyHash::new(Library::builder().with_features(features).build())
});

/// Sources of earlier documents, and where their elements stand. Changed where the next one differs, a source keeps
/// the rest as Typst knows it, so that only what changed is typeset anew.
static EARLIER: Mutex<Vec<(Source, Option<Places>)>> = Mutex::new(Vec::new());

fn earlier() -> MutexGuard<'static, Vec<(Source, Option<Places>)>> {
    EARLIER.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Drop for Memory {
    fn drop(&mut self) {
        earlier().push((self.main.clone(), self.places.take()));
    }
}

pub(crate) struct Memory {
    main: Source,
    /// Of the document before, then of this one.
    places: Option<Places>,
    files: HashMap<FileId, Bytes>,
    fonts: Fonts,
}

impl Memory {
    fn new(main: &str, files: &[(String, Vec<u8>)], fonts: Fonts) -> Result<Memory, Error> {
        let (main, places) = match earlier().pop() {
            Some((mut source, places)) => {
                source.replace(main);
                (source, places)
            }
            None => (Source::new(file_id("main.typ")?, main.to_owned()), None),
        };
        let mut world = Memory {
            files: HashMap::from([(main.id(), Bytes::from_string(main.text().to_owned()))]),
            main,
            places,
            fonts,
        };
        for (path, bytes) in files {
            world.files.insert(file_id(path)?, Bytes::new(bytes.clone()));
        }
        Ok(world)
    }

    fn typeset(&mut self) -> Result<PagedDocument, Error> {
        let places = self.places.take();
        let Warned { output, warnings } = settled::typeset(self, places);
        let document = self.check(output)?;
        self.places = Some(document.introspector().clone());
        match warnings.first() {
            Some(warning) => Err(self.error(warning)),
            None => Ok(document),
        }
    }

    fn check<T>(&self, result: SourceResult<T>) -> Result<T, Error> {
        result.map_err(|objections| self.error(&objections[0]))
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
    use crate::attachment::attached;

    fn pdf(source: &str, files: &Files) -> Result<Typeset, Error> {
        Embedded.typeset(source, files, Format::Pdf, None)
    }

    #[test]
    fn the_same_source_gives_the_same_bytes() {
        let files = [("data.json".to_owned(), br#"{"title": "$ #panic() * @x"}"#.to_vec())];
        let source = "#set document(title: \"T\")\n#let data = json(\"data.json\")\n= #data.title\n\
                      #math.equation(alt: \"one half\", $ frac(1, 2) $)";
        let first = pdf(source, &files).unwrap();
        assert!(first.files[0].starts_with(b"%PDF") && first.warnings.is_empty());
        assert_eq!(first, pdf(source, &files).unwrap());
    }

    #[test]
    fn what_was_typeset_before_leaves_no_trace() {
        let outline = "#set document(title: \"T\")\n#set page(footer: context counter(page).display())\n#outline()\n";
        let link =
            "#pagebreak()\n= End <end>\nPage #context counter(page).final().first() #link(<end>)[is the last].\n";
        let long = format!("{outline}= One\n#lorem(900)\n= Two\n#lorem(900)\n{link}");
        let short = format!("{outline}= Two\n#lorem(90)\n{link}");
        let first = pdf(&long, &[]).unwrap();
        let second = pdf(&short, &[]).unwrap();
        assert_ne!(first, second);
        for _ in 0..2 {
            assert_eq!(first, pdf(&long, &[]).unwrap());
            assert_eq!(first, pdf(&long, &[]).unwrap());
            assert_eq!(second, pdf(&short, &[]).unwrap());
        }
    }

    #[test]
    fn pages_that_never_come_to_rest_are_an_error() {
        let source = "#set document(title: \"T\")\n#context { let n = counter(page).final().first(); for _ in range(n) { pagebreak() } }";
        let message = pdf(source, &[]).unwrap_err().to_string();
        assert!(message.starts_with("the pages do not come to rest"), "{message}");
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
    fn labels_are_told_with_their_pages() {
        let source =
            "#set document(title: \"T\")\n#metadata(none)<one>\n#pagebreak()\n#metadata(none)#label(\"M_(1 x)\")";
        let made = Embedded.typeset(source, &[], Format::Svg, None).unwrap();
        let places = [("M_(1 x)".to_owned(), 2), ("one".to_owned(), 1)];
        assert_eq!(made.places, BTreeMap::from(places));
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
        assert_eq!(typeset.files, pdf(&written, &[]).unwrap().files);
    }

    #[test]
    fn every_format_begins_as_it_should() {
        let source = "#set document(title: \"T\")\none #pagebreak() two";
        for (format, files, start) in [
            (Format::Pdf, 1, "%PDF"),
            (Format::Svg, 2, "<svg"),
            (Format::Png, 2, "PNG"),
            (Format::Html, 1, "<!DOCTYPE html>"),
        ] {
            let made = Embedded.typeset(source, &[], format, None).unwrap().files;
            assert_eq!(made.len(), files, "{format:?}");
            for file in made {
                let begins = String::from_utf8_lossy(&file[..file.len().min(20)]).into_owned();
                assert!(begins.trim_start_matches('\u{fffd}').starts_with(start), "{begins}");
            }
        }
    }

    #[test]
    fn an_attachment_comes_back_to_the_byte() {
        let text = "a = 1\r\n# крановe 起重机 \u{10ffff}\n";
        let files = [("crane.toml".to_owned(), text.as_bytes().to_vec())];
        let source = "#set document(title: \"T\")\n#pdf.attach(\"crane.toml\", mime-type: \"application/toml\", \
                      description: \"d\", relationship: \"source\")\ntext";
        let made = pdf(source, &files).unwrap().files.remove(0);
        assert_eq!(attached(made, ".toml").unwrap(), text.as_bytes());
        let bare = pdf("#set document(title: \"T\")\ntext", &[]).unwrap().files.remove(0);
        assert!(attached(bare, ".toml").is_none());
        assert!(attached(b"no PDF".to_vec(), ".toml").is_none());
    }
}

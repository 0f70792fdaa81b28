//! The book as plain data: every string is ready to print, every word is an
//! id that the templates turn into the words of a language.

mod balance;
mod blocks;
mod cases;
mod charts;
mod cycle;
mod motion;
mod notation;
mod search;
mod steps;
mod study;
mod synthesis;
mod tables;
mod title;
mod trade;
pub(crate) mod verdict;

use std::collections::BTreeMap;

use lemnis_fmu::instance::strings;
use lemnis_models::book::{CHAPTERS, TEXT};
use lemnis_models::component::sheet::{self, Sheet};
use lemnis_models::kernel::schema::Key;
use lemnis_models::scene::Scene;
use lemnis_synthesis::comparison::Comparison;
use lemnis_typeset::{Format, Typeset, Typesetter};
use serde::Serialize;

use crate::book::balance::Balance;
use crate::book::blocks::{Figure, Range, Summary};
use crate::book::cases::Cases;
use crate::book::charts::Chart;
use crate::book::cycle::Cycle;
use crate::book::motion::Motion;
use crate::book::notation::{Entry, Notation};
use crate::book::search::{Search, search};
use crate::book::steps::{Position, Section};
use crate::book::study::Study;
use crate::book::synthesis::{Spread, Synthesis, spread, synthesis};
use crate::book::tables::{Changes, Chapter, Demand, Published, Sensitivity, View, Written};
use crate::book::title::Title;
use crate::book::trade::Trade;
use crate::book::verdict::Verdict;
use crate::language::{Language, symbols};
use crate::print::drawing::{SKETCH, drawing};
use crate::print::number::Numbers;
use crate::print::precision;
use crate::template::{Error, Templates};

/// The file with the scene's hash. Headers read it while pages are laid out:
/// within the source it would make every page new whenever the scene changes.
const HASH: &str = "scene.sha256";

/// How a book is made.
#[derive(Clone, Copy)]
pub struct Edition<'a> {
    pub language: &'static Language,
    /// One of [`lemnis_models::book::LEVELS`].
    pub level: &'a str,
    pub templates: &'a Templates,
    pub typesetter: &'a dyn Typesetter,
}

/// The Typst source of a book, and the files that it reads.
pub struct Source {
    pub main: String,
    pub files: Vec<(String, Vec<u8>)>,
}

impl Edition<'_> {
    /// Does the work, and reads meanwhile what a first book is made with.
    pub fn meanwhile<T>(&self, work: impl FnOnce() -> T) -> T {
        std::thread::scope(|scope| {
            scope.spawn(|| {
                self.templates.prepare(self.language);
                self.typesetter.prepare();
            });
            work()
        })
    }

    /// The source of a scene's book.
    ///
    /// # Errors
    /// A template with a mistake, or an id without words.
    pub fn source(&self, scene: &Scene, sheet: &Sheet, format: Format) -> Result<Source, Error> {
        let book = Book::new(scene, sheet, self, format)?;
        let main = self.templates.render(&book, self.language)?;
        let mut files = self.templates.files().to_vec();
        files.push((HASH.to_owned(), book.hash.into_bytes()));
        files.push((book.attachment, scene.text().into()));
        Ok(Source { main, files })
    }

    /// The book of a scene.
    ///
    /// # Errors
    /// As [`Edition::source`], and whatever Typst objects to.
    pub fn typeset(&self, scene: &Scene, sheet: &Sheet, format: Format) -> Result<Typeset, Error> {
        let Source { main, files } = self.source(scene, sheet, format)?;
        let standard = scene.book.pdf_standard.as_deref();
        self.typesetter
            .typeset(&main, &files, format, standard)
            .map_err(|error| Error(format!("the book's Typst source: {error}")))
    }
}

/// Everything that is printed. Fields named `symbol`, `value`, `limit` and
/// those of a step are in Typst's mathematics, others are text or ids.
#[derive(Serialize)]
struct Book<'a> {
    #[serde(flatten)]
    title: Title<'a>,
    hash: String,
    /// Name of the scene inside the PDF.
    attachment: String,
    version: String,
    level: &'a str,
    /// Significant digits of results.
    digits: usize,
    html: bool,
    /// Names the words that speak of this mechanism alone, and those of its symbols.
    mechanism: &'static str,
    symbols: &'static str,
    /// Parts of the machine that have words of their own.
    parts: Vec<&'static str>,
    /// Ids of the chapters in their order.
    chapters: Vec<&'static str>,
    #[serde(flatten)]
    verdict: Verdict,
    summary: Vec<Summary>,
    governing: Vec<Summary>,
    /// The engineer's own paragraphs by their places.
    text: BTreeMap<&'static str, Vec<String>>,
    /// Least and greatest of each.
    forces: Vec<[Summary; 2]>,
    uncovered: &'a [&'static str],
    inputs: Vec<Chapter>,
    drawing: String,
    scale: u32,
    constants: Vec<Section>,
    positions: Vec<Position>,
    views: Vec<View>,
    demands: Vec<Demand>,
    /// The greatest of them.
    most_demanded: Option<Demand>,
    changes: Option<Changes>,
    sizing: Vec<Section>,
    range: Range,
    curves: Vec<Figure>,
    charts: Vec<Chart>,
    balance: Option<Balance>,
    cases: Option<Cases>,
    motion: Option<Motion>,
    cycle: Option<Cycle>,
    assumptions: &'a [&'static str],
    sensitivity: Sensitivity,
    synthesis: Option<Synthesis>,
    search: Option<Search>,
    trade: Option<Trade>,
    study: Option<Study>,
    published: Option<Published>,
    remarks: &'a [&'static str],
    notation: Vec<Entry>,
    /// What the scene says.
    written: Vec<Written<'a>>,
}

/// The chapters of a level; a chapter that has nothing to say is left out.
fn chapters(scene: &Scene, sheet: &Sheet, level: &str) -> Vec<&'static str> {
    let of_level = |chapter: &&'static str| match level {
        "summary" => ["results", "task", "forces", "references"].contains(chapter),
        // The PDF has it inside.
        "standard" => *chapter != "scene",
        _ => true,
    };
    let chosen = match &scene.book.chapters {
        Some(chosen) => chosen.clone(),
        None => CHAPTERS.iter().copied().filter(of_level).collect(),
    };
    let has = |chapter: &&str| match *chapter {
        "published" => !sheet.published.is_empty(),
        "sensitivity" => !sheet.sensitivity.results.is_empty(),
        "views" => !sheet.views.is_empty(),
        "sizing" => !sheet.sizing.is_empty(),
        "charts" => !sheet.charts.is_empty(),
        "forces" => !sheet.forces.is_empty(),
        "remarks" => !sheet.remarks.is_empty() || scene.book.text.iter().any(|(place, _)| *place == "remarks"),
        "identities" => !sheet.identities.is_empty(),
        "balance" => sheet.balance.is_some(),
        "cases" => sheet.cases.is_some(),
        "motion" => sheet.motion.is_some(),
        "cycle" => sheet.cycle.is_some(),
        // Many runs: only a scene that lists the chapter gets it.
        "trade" => scene.book.chapters.is_some(),
        "synthesis" => scene.search().is_some(),
        "search" => scene.request.is_some(),
        "study" => scene.study.is_some(),
        _ => true,
    };
    chosen.into_iter().filter(has).collect()
}

/// Parts of the machine that have words of their own.
pub(crate) fn parts(sheet: &Sheet) -> Vec<&'static str> {
    let balance = sheet.balance.iter().flat_map(|balance| balance.parts);
    balance.chain(&sheet.parts).copied().collect()
}

/// The engineer's own paragraphs, with blank lines between them, by their places.
fn paragraphs(language: &Language, scene: &Scene) -> BTreeMap<&'static str, Vec<String>> {
    let own = |place: &str| scene.book.text.iter().find(|(known, _)| *known == place);
    let of = |key: &Key| {
        let lines: Vec<&str> = own(key.name)
            .map_or("", |(_, text)| text.of(language.code))
            .lines()
            .map(str::trim)
            .collect();
        let paragraphs = lines.split(|line| line.is_empty()).filter(|lines| !lines.is_empty());
        (key.name, paragraphs.map(|lines| lines.join(" ")).collect())
    };
    TEXT.iter().map(of).collect()
}

/// What moves.
fn moving(numbers: &Numbers, sheet: &Sheet, notation: &mut Notation) -> Option<Motion> {
    let of = |motion| Motion::new(numbers, motion, &sheet.requirements, notation);
    sheet.motion.as_ref().map(of)
}

/// What commands over time come to.
fn cycled(numbers: &Numbers, sheet: &Sheet, chapters: &[&str], notation: &mut Notation) -> Option<Cycle> {
    let shown = sheet.cycle.as_ref().filter(|_| chapters.contains(&"cycle"));
    shown.map(|cycle| Cycle::new(numbers, cycle, notation))
}

/// What tolerances do to the scene's own balance, and the comparison with others, where that is shown.
fn compared(
    numbers: &Numbers,
    scene: &Scene,
    shown: bool,
    notation: &mut Notation,
) -> (Option<Spread>, Option<Synthesis>) {
    let comparison = Comparison::new(scene);
    let own = comparison.as_ref().and_then(|comparison| spread(numbers, comparison));
    let all = comparison.filter(|_| shown);
    (own, all.and_then(|all| synthesis(numbers, scene, &all, notation)))
}

impl<'a> Book<'a> {
    fn new(scene: &'a Scene, sheet: &'a Sheet, edition: &Edition<'a>, format: Format) -> Result<Book<'a>, Error> {
        let numbers = &precision::numbers(edition.language, scene.book.digits, sheet);
        let chapters = chapters(scene, sheet, edition.level);
        let mut notation = Notation::new(scene.mechanism.id(), sheet, &chapters);
        let full = edition.level == "full";
        let (mut inputs, mut constants, mut positions) = (Vec::new(), Vec::new(), Vec::new());
        let (mut sizing, mut motion, mut cases, mut study) = (Vec::new(), None, None, None);
        let judged = sheet.requirements.as_slice();
        // In the order of the chapters, so that a symbol is explained where it is met first.
        for chapter in &chapters {
            match *chapter {
                "inputs" => inputs = tables::inputs(numbers, sheet, &chapters, &mut notation),
                "constants" => constants = steps::sections(numbers, &sheet.constants, None, judged, &mut notation),
                "sizing" => sizing = steps::sections(numbers, &sheet.sizing, None, judged, &mut notation),
                "positions" => {
                    let outputs = (!full).then_some(sheet.outputs.as_slice());
                    let position = |position| Position::new(numbers, position, outputs, judged, &mut notation);
                    positions = sheet.positions.iter().map(position).collect();
                }
                "cases" => cases = Cases::of(numbers, sheet, full, &mut notation),
                "motion" => motion = moving(numbers, sheet, &mut notation),
                "study" => study = Study::of(numbers, scene, &mut notation),
                _ => {}
            }
        }
        notation.meet_results(sheet, &chapters);
        notation.meet_formulas(sheet, &chapters);
        let has = |chapter| chapters.contains(&chapter);
        let (spread, synthesis) = compared(numbers, scene, has("synthesis"), &mut notation);
        let search = has("search").then(|| search(numbers, scene, &mut notation)).flatten();
        let trade = (has("trade").then(|| Trade::new(numbers, scene, &mut notation))).transpose()?;
        let drawing = drawing(&sheet.drawing, SKETCH);
        let summary = |s: &sheet::Summary| blocks::summary(numbers, s);
        let demand = |d: &(&'static str, sheet::Summary)| tables::demand(numbers, d);
        // The FMU of the same scene tells the same.
        let [version, hash] = strings(scene);
        Ok(Book {
            title: Title::new(scene, numbers.language),
            hash,
            attachment: format!("{}.toml", scene.name()),
            version,
            level: edition.level,
            digits: scene.book.digits,
            mechanism: scene.mechanism.id(),
            symbols: symbols(scene.mechanism.id()),
            parts: parts(sheet),
            html: format == Format::Html,
            verdict: Verdict::new(numbers, scene, sheet, spread),
            summary: sheet.summary.iter().map(summary).collect(),
            governing: sheet.governing.iter().map(summary).collect(),
            text: paragraphs(numbers.language, scene),
            forces: sheet.forces.iter().map(|ends| ends.each_ref().map(summary)).collect(),
            uncovered: &sheet.uncovered,
            inputs,
            scale: drawing.scale,
            drawing: drawing.json(),
            constants,
            positions,
            views: sheet.views.iter().map(|view| tables::view(numbers, view)).collect(),
            demands: sheet.demands.iter().map(demand).collect(),
            most_demanded: sheet.most_demanded.as_ref().map(demand),
            changes: sheet.changes.as_ref().map(|changes| tables::changes(numbers, changes)),
            sizing,
            range: blocks::range(numbers, &sheet.range, full),
            curves: sheet.curves.iter().map(|curve| Figure::new(numbers, curve)).collect(),
            charts: sheet.charts.iter().map(|chart| Chart::new(numbers, chart)).collect(),
            balance: sheet.balance.as_ref().map(|b| Balance::new(numbers, b)),
            cases,
            motion,
            cycle: cycled(numbers, sheet, &chapters, &mut notation),
            assumptions: &sheet.assumptions,
            sensitivity: tables::sensitivity(numbers, &sheet.sensitivity),
            synthesis,
            search,
            trade,
            study,
            published: tables::published(numbers, sheet, full),
            remarks: &sheet.remarks,
            written: tables::written(&scene.given),
            notation: notation.entries(),
            chapters,
        })
    }
}

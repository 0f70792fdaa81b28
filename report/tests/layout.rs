//! The layout of every ready scene's book, in every language: no page is left half empty, no row of a table and no heading
//! stands alone, and no table is in small type.

use lemnis::book::Edition;
use lemnis::language::LANGUAGES;
use lemnis::template::Templates;
use lemnis_models::scene::Scene;
use lemnis_typeset::{Embedded, Format, Ink, Mark, ink};

/// As in the program: books are typeset mostly by allocating.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

/// The text block of `templates/style.typ`, in mm from the upper edge.
const TOP: f64 = 26.0;
const BOTTOM: f64 = 297.0 - 22.0;

/// Sizes of headings and of type in tables, in pt.
const HEADINGS: [f64; 2] = [14.0, 11.0];
const TABLE: f64 = 9.0;
/// That of tables with more than ten columns.
const WIDE_TABLE: f64 = 8.0;

/// A page of a book.
struct Page {
    name: String,
    /// What stands in its text block.
    body: Vec<Mark>,
    last: bool,
}

impl Page {
    fn new(name: String, ink: Ink, last: bool) -> Page {
        let within = |mark: &Mark| mark.from[1] > TOP - 1.0 && mark.to[1] < BOTTOM + 2.0;
        Page {
            name,
            body: ink.marks.into_iter().filter(within).collect(),
            last,
        }
    }

    /// Part of the text block below all that stands in it.
    fn empty(&self) -> f64 {
        let lowest = self.body.iter().map(|mark| mark.to[1]).fold(TOP, f64::max);
        (BOTTOM - lowest) / (BOTTOM - TOP)
    }

    fn texts(&self) -> impl Iterator<Item = (&Mark, &str, f64)> {
        self.body
            .iter()
            .filter_map(|mark| mark.text.as_ref().map(|(text, size)| (mark, text.as_str(), *size)))
    }

    /// Tables, or the parts of them on this page, from their upper to their lower line.
    fn tables(&self) -> Vec<Table<'_>> {
        let rule =
            |mark: &&Mark| mark.text.is_none() && mark.to[1] - mark.from[1] < 0.4 && mark.to[0] - mark.from[0] > 20.0;
        let mut rules: Vec<&Mark> = self.body.iter().filter(rule).collect();
        rules.sort_by(|a, b| a.from[1].total_cmp(&b.from[1]));
        let thick = |mark: &Mark| mark.to[1] - mark.from[1] > 0.2;
        let mut tables = Vec::new();
        while let Some(at) = rules.iter().position(|mark| thick(mark)) {
            let top = rules.remove(at);
            let same = |mark: &&&Mark| (mark.from[0] - top.from[0]).abs() < 1.0 && (mark.to[0] - top.to[0]).abs() < 1.0;
            let below: Vec<&Mark> = rules.iter().copied().filter(|mark| same(&mark)).collect();
            let Some(bottom) = below.iter().find(|mark| thick(mark)) else {
                continue;
            };
            let head = below.iter().find(|mark| mark.from[1] < bottom.from[1]);
            let head = head.map_or(top.to[1], |mark| mark.to[1]);
            let inside = |mark: &&Mark| mark.from[0] > top.from[0] - 1.0 && mark.to[0] < top.to[0] + 1.0;
            let texts = self.body.iter().filter(|mark| mark.text.is_some()).filter(inside);
            let (mut titles, mut cells) = (Vec::new(), Vec::new());
            for mark in texts.filter(|mark| mark.from[1] > top.from[1] - 0.5 && mark.to[1] < bottom.to[1] + 0.5) {
                if mark.to[1] < head + 0.5 {
                    titles.push(mark)
                } else {
                    cells.push(mark)
                }
            }
            let bottom = bottom.to[1];
            // Lines of a drawing.
            if titles.is_empty() {
                continue;
            }
            rules.retain(|mark| mark.to[1] > bottom + 0.1);
            tables.push(Table {
                top: top.from[1],
                bottom,
                titles,
                cells,
            });
        }
        tables
    }
}

struct Table<'a> {
    top: f64,
    bottom: f64,
    titles: Vec<&'a Mark>,
    cells: Vec<&'a Mark>,
}

impl Table<'_> {
    fn title(&self) -> String {
        self.titles
            .iter()
            .map(|mark| mark.text.as_ref().expect("text").0.as_str())
            .collect()
    }

    /// Rows, as the lines of the leftmost column.
    fn rows(&self) -> usize {
        let left = self.cells.iter().map(|mark| mark.from[0]).fold(f64::INFINITY, f64::min);
        let first = self.cells.iter().filter(|mark| mark.from[0] < left + 3.0);
        let mut lines: Vec<f64> = first.map(|mark| mark.from[1]).collect();
        lines.sort_by(f64::total_cmp);
        lines.dedup_by(|a, b| *a - *b < 2.6);
        lines.len()
    }
}

/// Looks at the pages of every ready scene's book, one book after the other.
fn books(mut look: impl FnMut(&[Page])) {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../models/scenes");
    let templates = Templates::embedded();
    for entry in std::fs::read_dir(folder).expect("scenes") {
        let path = entry.expect("a scene").path();
        let scene = Scene::parse(&std::fs::read_to_string(&path).expect("readable")).expect("a ready scene");
        let sheet = scene.sheet();
        for language in &LANGUAGES {
            let edition = Edition {
                language,
                level: "standard",
                templates: &templates,
                typesetter: &Embedded,
            };
            let source = edition.source(&scene, &sheet, Format::Pdf).expect("a source");
            let all = ink(&source.main, &source.files).expect("pages");
            let (count, file) = (all.len(), path.file_stem().expect("a name").display());
            let named = |(i, ink)| Page::new(format!("{file} {} {}", language.code, i + 1), ink, i + 1 == count);
            look(&all.into_iter().enumerate().map(named).collect::<Vec<Page>>());
        }
    }
}

/// What is wrong with a book's pages, and how many tables or parts of them they have.
fn looked(pages: &[Page]) -> (Vec<String>, usize) {
    let (mut wrong, mut tables) = (Vec::new(), 0);
    for (i, page) in pages.iter().enumerate() {
        if !page.last && page.empty() > 0.35 {
            wrong.push(format!("{}: {:.2} empty", page.name, page.empty()));
        }
        let parts = page.tables();
        tables += parts.len();
        for table in &parts {
            let sizes = table
                .cells
                .iter()
                .chain(&table.titles)
                .map(|mark| mark.text.as_ref().expect("text").1);
            let size = sizes.fold(0.0, f64::max);
            if size < WIDE_TABLE - 0.01 {
                wrong.push(format!("{}: type of {size} pt", page.name));
            }
            if size < TABLE - 0.01 && table.titles.len() < 11 {
                wrong.push(format!("{}: type of {size} pt in {}", page.name, table.title()));
            }
        }
        wrong.extend(row_alone(page, &parts, pages.get(i + 1)));
        wrong.extend(headings_alone(page));
    }
    (wrong, tables)
}

/// The last table of a page goes on where the first one of the next has the same head.
fn row_alone(page: &Page, parts: &[Table<'_>], next: Option<&Page>) -> Option<String> {
    let (one, next) = parts.last().zip(next)?;
    let others = next.tables();
    let two = others.first()?;
    let between =
        page.texts().any(|(mark, ..)| mark.from[1] > one.bottom) || next.texts().any(|(mark, ..)| mark.to[1] < two.top);
    let alone = !between && one.title() == two.title() && one.rows().min(two.rows()) < 2;
    alone.then(|| format!("{}: a row alone of {}", page.name, one.title()))
}

fn headings_alone(page: &Page) -> Vec<String> {
    let headings = page.texts().filter(|(.., size)| HEADINGS.contains(size));
    let alone = headings.filter(|(heading, ..)| {
        let below = page.body.iter().filter(|mark| mark.from[1] > heading.to[1]);
        let mut below: Vec<f64> = below.map(|mark| mark.to[1]).collect();
        below.sort_by(f64::total_cmp);
        below.dedup_by(|a, b| *a - *b < 2.6);
        below.len() < 2
    });
    alone
        .map(|(_, text, size)| format!("{}: {text} ({size} pt) alone", page.name))
        .collect()
}

#[test]
fn books_are_laid_out_as_books_are() {
    let (mut count, mut tables, mut wrong) = (0, 0, Vec::new());
    // Of the pages but the last ones: how many, the sum of what is empty, and the emptiest.
    let (mut inner, mut empty, mut worst) = (0, 0.0, (0.0, String::new()));
    books(|pages| {
        let (found, some) = looked(pages);
        wrong.extend(found);
        (count, tables) = (count + pages.len(), tables + some);
        for page in pages.iter().filter(|page| !page.last) {
            let part = page.empty();
            (inner, empty) = (inner + 1, empty + part);
            if part > worst.0 {
                worst = (part, page.name.clone());
            }
        }
    });
    let mean = empty / f64::from(inner);
    println!(
        "{count} pages, empty on average {mean:.3}, at most {:.3} ({}); {tables} tables or parts of them",
        worst.0, worst.1
    );
    assert!(
        mean <= 0.1 && wrong.is_empty(),
        "mean {mean:.3}, {} wrong:\n{}",
        wrong.len(),
        wrong.join("\n")
    );
    assert!(count > 900 && tables > 1000);
}

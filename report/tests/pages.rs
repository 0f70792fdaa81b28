//! No page of any book has anything in its margins or beyond, in any language and level, but numbers of formulas.

use lemnis::book::Edition;
use lemnis::language::LANGUAGES;
use lemnis::template::Templates;
use lemnis_models::book::LEVELS;
use lemnis_models::scene::{DEFAULT, Scene};
use lemnis_typeset::{Embedded, Format, ink};

/// As in the program: books are typeset mostly by allocating.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

/// Margins of `templates/style.typ` in mm: left, top, right, bottom. Header and
/// footer stand in the upper and the lower one.
const MARGINS: [f64; 4] = [24.0, 26.0, 20.0, 22.0];
/// Half a stroke, and hyphens and points that hang in the margin by half their width.
const HAIR: f64 = 1.0;
/// How far header and footer reach into their margins.
const HEADER: f64 = 11.0;

/// How far numbers of formulas reach into the right one, and what of `templates/style.typ` puts them there.
const NUMBERS: f64 = 12.0;
const IN_MARGIN: &str = "dx: 12mm, ";

/// What moves the crane by a cylinder with oil.
const DYNAMICS: &str = include_str!("../../tests/levels/dynamics.toml");
const OIL: &str = include_str!("../../tests/levels/hydraulics.toml");

#[test]
fn nothing_stands_over_the_margin() {
    let templates = Templates::embedded();
    // A kinematic crane beside the whole one, and the longest keys and names of the other mechanisms.
    let bare = DEFAULT[..DEFAULT.find("[luffing.weights]").expect("there")].replace("Q = \"160 kN\"", "");
    let others = [
        include_str!("../../models/scenes/portal_004.toml"),
        include_str!("../../models/scenes/portal_004_motion.toml"),
        include_str!("../../models/scenes/boat_hoist_003_hydraulic.toml"),
        include_str!("../../models/scenes/car_4x2.toml"),
    ];
    let oil = DEFAULT
        .replacen("driven = \"boom\" ", "fidelity = \"hydraulic\"\ndriven = \"boom\" ", 1)
        .replacen(
            "\n[luffing.limits]",
            &format!("\n{DYNAMICS}l_R = \"10 m\"\n{OIL}\n[luffing.limits]"),
            1,
        );
    let trade = others[1].replacen("[luffing]\n", "[book]\nchapters = [\"trade\"]\n[luffing]\n", 1);
    let mut pages = 0;
    for text in [DEFAULT, &bare, &oil, &trade].into_iter().chain(others) {
        let scene = Scene::parse(text).unwrap_or_else(|found| panic!("{found:?}"));
        let sheet = scene.sheet();
        for (language, level) in LANGUAGES
            .iter()
            .flat_map(|language| LEVELS.iter().map(move |level| (language, level)))
        {
            let edition = Edition {
                language,
                level,
                templates: &templates,
                typesetter: &Embedded,
            };
            let source = edition.source(&scene, &sheet, Format::Pdf).expect("a source");
            // With the numbers within the line all else is measured.
            let inside = source.main.replace(IN_MARGIN, "");
            assert_ne!(inside, source.main);
            for (page, number) in ink(&inside, &source.files).expect("pages").into_iter().zip(1..) {
                let [left, top, right, bottom] = MARGINS;
                let place = format!("{} {} {level} page {number}: {page:?}", scene.name(), language.code);
                assert!(
                    page.from[0] >= left - HAIR && page.to[0] <= page.size[0] - right + HAIR,
                    "{place}"
                );
                assert!(page.from[1] >= top - HEADER - HAIR, "{place}");
                assert!(page.to[1] <= page.size[1] - bottom + HEADER + HAIR, "{place}");
                pages += 1;
            }
        }
    }
    println!("{pages} pages");
    assert!(pages > 300, "{pages}");
}

#[test]
fn numbers_of_formulas_keep_to_their_part_of_the_margin() {
    let scene = Scene::parse(include_str!("../../models/scenes/portal_004_motion.toml")).expect("valid");
    let edition = Edition {
        language: &LANGUAGES[0],
        level: "full",
        templates: &Templates::embedded(),
        typesetter: &Embedded,
    };
    let source = edition.source(&scene, &scene.sheet(), Format::Pdf).expect("a source");
    let pages = ink(&source.main, &source.files).expect("pages");
    let right = MARGINS[2];
    let reaching = pages.iter().filter(|page| page.to[0] > page.size[0] - right + HAIR);
    assert!(reaching.count() > 10);
    for page in &pages {
        assert!(page.to[0] <= page.size[0] - right + NUMBERS + HAIR, "{page:?}");
    }
}

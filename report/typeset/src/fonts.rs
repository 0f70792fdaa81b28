//! The fonts: Typst's own for Latin, Greek, Cyrillic and mathematics, a subset
//! of Noto Serif SC, a Song face, for Chinese (`fonts/`), and the system's where asked for.

use std::collections::BTreeMap;
use std::sync::{Arc, LazyLock};

use fontdb::Database;
use typst::foundations::Bytes;
use typst::layout::{Frame, FrameItem};
use typst::text::{Font, FontBook, FontInfo, TextItem};
use typst::utils::LazyHash;
use typst_layout::PagedDocument;

/// Fonts to typeset with.
#[derive(Clone)]
pub struct Fonts {
    pub book: Arc<LazyHash<FontBook>>,
    fonts: Arc<Vec<Font>>,
}

/// Characters of Chinese: `fonts/subset.py` made them.
pub const CHINESE: [&[u8]; 2] = [
    include_bytes!("../fonts/NotoSerifSC-Regular.ttf"),
    include_bytes!("../fonts/NotoSerifSC-Bold.ttf"),
];

static EMBEDDED: LazyLock<Fonts> = LazyLock::new(|| {
    let data = typst_assets::fonts().chain(CHINESE);
    Fonts::new(data.flat_map(|data| Font::iter(Bytes::new(data))).collect())
});

impl Fonts {
    fn new(fonts: Vec<Font>) -> Fonts {
        Fonts {
            book: Arc::new(LazyHash::new(FontBook::from_fonts(fonts.iter()))),
            fonts: Arc::new(fonts),
        }
    }

    /// Those that travel with the program.
    pub fn embedded() -> &'static Fonts {
        &EMBEDDED
    }

    /// These, and every font of the system that has one of the characters.
    pub fn with_system(&self, characters: &[char]) -> Fonts {
        let mut database = Database::new();
        database.load_system_fonts();
        self.with(&database, characters)
    }

    fn with(&self, database: &Database, characters: &[char]) -> Fonts {
        let useful = |data: &[u8], index: u32| {
            let info = FontInfo::new(data, index)?;
            let useful = characters.iter().any(|&c| info.coverage.contains(u32::from(c)));
            useful.then(|| Font::new(Bytes::new(data.to_vec()), index)).flatten()
        };
        let found = database
            .faces()
            .filter_map(|face| database.with_face_data(face.id, useful).flatten());
        Fonts::new(self.fonts.iter().cloned().chain(found).collect())
    }

    pub fn get(&self, index: usize) -> Option<Font> {
        self.fonts.get(index).cloned()
    }

    /// Whether one of them has the character.
    fn have(&self, character: char) -> bool {
        let has = |font: &Font| font.info().coverage.contains(u32::from(character));
        self.fonts.iter().any(has)
    }

    /// The characters without a glyph, each with the page and the text where it is first.
    pub fn unprintable(&self, document: &PagedDocument) -> BTreeMap<char, String> {
        let mut found = BTreeMap::new();
        for (page, number) in document.pages().iter().zip(1..) {
            each_text(&page.frame, &mut |text| {
                for glyph in text.glyphs.iter().filter(|glyph| glyph.id == 0) {
                    // A letter with its accents is one glyph: some of them may be printable.
                    for character in text.text[glyph.range()].chars().filter(|&c| !self.have(c)) {
                        let place = || format!("on page {number}, in \"{}\"", text.text);
                        found.entry(character).or_insert_with(place);
                    }
                }
            });
        }
        found
    }
}

fn each_text(frame: &Frame, visit: &mut impl FnMut(&TextItem)) {
    for (_, item) in frame.items() {
        match item {
            FrameItem::Group(group) => each_text(&group.frame, visit),
            FrameItem::Text(text) => visit(text),
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use std::path::{Path, PathBuf};

    use super::*;

    /// Of every language, with the meanings of symbols and the publications.
    #[test]
    fn every_character_of_the_words_is_embedded() {
        let entries = |folder: &Path| -> Vec<PathBuf> {
            let entries = std::fs::read_dir(folder).expect("a folder of words");
            entries.map(|entry| entry.expect("an entry").path()).collect()
        };
        let languages = entries(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../templates/words")));
        assert_eq!(languages.len(), 3);
        for file in languages.iter().flat_map(|language| entries(language)) {
            let words = std::fs::read_to_string(&file).expect("words");
            for character in words.chars().filter(|c| !c.is_control()) {
                assert!(Fonts::embedded().have(character), "{}: {character}", file.display());
            }
        }
    }

    /// The character 龘 alone, as a font that a system may have.
    #[test]
    fn a_font_of_the_system_is_taken_where_it_has_what_is_missing() {
        let mut database = Database::new();
        database.load_font_data(include_bytes!("../fonts/one_character.ttf").to_vec());
        let embedded = Fonts::embedded();
        assert!(!embedded.have('龘'));
        assert!(embedded.with(&database, &['龘']).have('龘'));
        let other = embedded.with(&database, &['\u{10ffff}']);
        assert_eq!(other.fonts.len(), embedded.fonts.len());
    }
}

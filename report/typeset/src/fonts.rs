//! The fonts: Typst's own for Latin, Greek, Cyrillic and mathematics, a subset
//! of Noto Sans CJK for Chinese (`fonts/`), and the system's where asked for.

use std::sync::{Arc, LazyLock};

use fontdb::Database;
use typst::foundations::Bytes;
use typst::text::{Font, FontBook, FontInfo};
use typst::utils::LazyHash;

/// Fonts to typeset with.
#[derive(Clone)]
pub struct Fonts {
    pub book: Arc<LazyHash<FontBook>>,
    fonts: Arc<Vec<Font>>,
}

const CHINESE: [&[u8]; 2] = [
    include_bytes!("../fonts/NotoSansCJKsc-Regular.otf"),
    include_bytes!("../fonts/NotoSansCJKsc-Bold.otf"),
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
    pub fn have(&self, character: char) -> bool {
        let has = |font: &Font| font.info().coverage.contains(u32::from(character));
        self.fonts.iter().any(has)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chinese_cyrillic_and_mathematics_are_embedded() {
        for character in "双纽线型起重机变幅机构象鼻架刚性拉杆。，：（）стрелаобсегщѝθ∞√".chars()
        {
            assert!(Fonts::embedded().have(character), "{character}");
        }
    }

    /// The character 龘 alone, as a font that a system may have.
    #[test]
    fn a_font_of_the_system_is_taken_where_it_has_what_is_missing() {
        let mut database = Database::new();
        database.load_font_data(include_bytes!("../fonts/one_character.otf").to_vec());
        let embedded = Fonts::embedded();
        assert!(!embedded.have('龘'));
        assert!(embedded.with(&database, &['龘']).have('龘'));
        let other = embedded.with(&database, &['\u{10ffff}']);
        assert_eq!(other.fonts.len(), embedded.fonts.len());
    }
}

//! Texts that a scene may give in several languages.

/// The languages, by ISO 639-1; the first is the default.
pub const LANGUAGES: [&str; 3] = ["en", "zh", "bg"];

/// A text, in one language or in several.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Text {
    /// What stands for every language that has no text of its own: the English one, else the first.
    any: String,
    /// By language.
    own: Vec<(&'static str, String)>,
}

impl Text {
    /// In several languages, of which there is at least one.
    #[must_use]
    pub fn translated(own: Vec<(&'static str, String)>) -> Option<Text> {
        let (_, any) = own.iter().find(|(code, _)| *code == LANGUAGES[0]).or(own.first())?;
        Some(Text { any: any.clone(), own })
    }

    /// In English, or else as it is.
    #[must_use]
    pub fn english(&self) -> &str {
        &self.any
    }

    /// In one of [`LANGUAGES`], or else in English, or as it is.
    #[must_use]
    pub fn of(&self, language: &str) -> &str {
        let own = self.own.iter().find(|(code, _)| *code == language);
        own.map_or(&self.any, |(_, text)| text)
    }
}

/// The same in every language.
impl From<String> for Text {
    fn from(any: String) -> Text {
        Text { any, own: Vec::new() }
    }
}

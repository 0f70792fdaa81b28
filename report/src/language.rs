//! The languages of books: their words, and how they write numbers.
//!
//! One rule for all of them: integers and decimals are never grouped in
//! thousands, because a separator could be taken for the decimal sign; units
//! have their international symbols, as standards and publications in all
//! three languages write them.

use std::collections::BTreeMap;
use std::sync::{Arc, OnceLock};

use lemnis_models::component::description::Vocabulary;
use lemnis_models::kernel::number::Number;
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::registry::{LENT, vocabularies};

use crate::print::prose::prose;

pub(crate) const REFERENCES: &str = include_str!("../../templates/references.toml");

/// The files of words of every language, what every book says and what only one component does: paths among the
/// templates, and texts.
static WORDS: &[(&str, &str)] = include!(concat!(env!("OUT_DIR"), "/words.rs"));

/// A language that books can be written in.
#[derive(Debug)]
pub struct Language {
    /// ISO 639-1, as in scenes and on the command line.
    pub code: &'static str,
    decimal: char,
}

/// Every language, the default first.
pub static LANGUAGES: [Language; 3] = [
    Language {
        code: "en",
        decimal: '.',
    },
    Language {
        code: "zh",
        decimal: '.',
    },
    Language {
        code: "bg",
        decimal: ',',
    },
];

/// An exponent in raised digits.
fn superscript(power: i32) -> String {
    const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let raised = |c: char| c.to_digit(10).map_or('⁻', |digit| RAISED[digit as usize]);
    power.to_string().chars().map(raised).collect()
}

impl Language {
    /// By its code.
    #[must_use]
    pub fn find(code: &str) -> Option<&'static Language> {
        LANGUAGES.iter().find(|language| language.code == code)
    }

    /// Its files of words: paths among the templates, and texts.
    pub(crate) fn words(&self) -> impl Iterator<Item = (&'static str, &'static str)> {
        WORDS.iter().copied().filter(|(path, _)| self.owns(path))
    }

    /// Whether a path among the templates is that of words of this language.
    pub(crate) fn owns(&self, path: &str) -> bool {
        path.starts_with(&format!("words/{}/", self.code))
    }

    /// A number as text of this language: `−4,234 · 10⁻⁷`.
    #[must_use]
    pub fn text(&self, number: &Number) -> String {
        let sign = |negative: bool| if negative { "−" } else { "" };
        match number {
            Number::Finite {
                negative,
                digits,
                power,
            } => {
                let power = match power {
                    0 => String::new(),
                    power => format!(" · 10{}", superscript(*power)),
                };
                format!("{}{}{power}", sign(*negative), self.digits(digits))
            }
            Number::Infinite { negative } => format!("{}∞", sign(*negative)),
            Number::Undefined => self.word("undefined"),
        }
    }

    /// A number in Typst's mathematics, which takes a comma outside quotes for a separator.
    #[must_use]
    pub fn math(&self, number: &Number) -> String {
        let sign = |negative: bool| if negative { "-" } else { "" };
        match number {
            Number::Finite {
                negative,
                digits,
                power,
            } => {
                let local = self.digits(digits);
                let local = if local == *digits {
                    local
                } else {
                    format!("\"{local}\"")
                };
                let power = match power {
                    0 => String::new(),
                    power => format!(" times 10^({power})"),
                };
                format!("{}{local}{power}", sign(*negative))
            }
            Number::Infinite { negative } => format!("{}infinity", sign(*negative)),
            Number::Undefined => format!("\"{}\"", self.word("undefined")),
        }
    }

    /// Digits with this language's decimal sign.
    fn digits(&self, digits: &str) -> String {
        digits.replace('.', self.decimal.encode_utf8(&mut [0; 4]))
    }

    /// Its words, read once.
    pub(crate) fn dictionary(&self) -> &'static Words {
        static READ: [OnceLock<Words>; LANGUAGES.len()] = [const { OnceLock::new() }; LANGUAGES.len()];
        let place = LANGUAGES.iter().position(|known| known.code == self.code);
        let read = &READ[place.expect("a language of the table")];
        read.get_or_init(|| Words::new(self, [], None).expect("words that are tested"))
    }

    /// What the page says: its own words, and heads and titles of the book, by group and id.
    #[must_use]
    pub fn page(&self) -> BTreeMap<&'static str, &'static toml::Table> {
        let groups = ["page", "caption", "chapter", "head", "level"];
        let words = &self.dictionary().0.groups;
        groups
            .into_iter()
            .filter_map(|group| Some((group, words.get(group)?)))
            .collect()
    }

    /// A word that stands where there is no number.
    pub(crate) fn word(&self, id: &str) -> String {
        let word = self.dictionary().get("text", id);
        word.expect("every language has the words of English").to_owned()
    }
}

/// Group of the words of symbols that mechanisms share.
const SHARED: &str = "symbol";

fn known(mechanism: &str) -> &'static Vocabulary {
    let found = vocabularies().find(|(id, _)| *id == mechanism);
    found.expect("every mechanism has its symbols").1
}

/// The tables of symbols of a mechanism, by its id.
pub(crate) fn symbol_tables(mechanism: &str) -> impl Iterator<Item = &'static [&'static Symbol]> {
    let Vocabulary { own, shared, .. } = known(mechanism);
    own.iter().chain(*shared).copied()
}

/// A symbol of a mechanism as it is printed.
pub(crate) fn symbol(mechanism: &str, id: &str) -> Option<&'static str> {
    find(known(mechanism), id)
}

fn find(vocabulary: &'static Vocabulary, id: &str) -> Option<&'static str> {
    let mut symbols = vocabulary.own.iter().chain(vocabulary.shared).copied().flatten();
    symbols.find(|symbol| symbol.id == id).map(|symbol| symbol.print)
}

/// The group of words for a mechanism's symbols.
pub(crate) fn symbols(mechanism: &str) -> &'static str {
    known(mechanism).words
}

/// The group of words for a symbol in what is told of a mechanism: that of another one, where what moves beside it is told.
pub(crate) fn symbols_of(mechanism: &str, symbol: &Symbol) -> &'static str {
    let own = known(mechanism);
    let all = std::iter::once(own).chain(vocabularies().map(|(_, of)| of));
    let mut all = all.filter(|of| of.has(symbol));
    all.next().unwrap_or(own).words
}

/// The words of a language, in groups; Typst markup.
#[derive(Clone, Debug)]
pub(crate) struct Words(Arc<Known>);

#[derive(Debug)]
struct Known {
    groups: Groups,
    meanings: Vec<Meanings>,
}

type Groups = BTreeMap<String, toml::Table>;

/// What the symbols of a mechanism mean by the tables of the models, set when the first is asked for.
#[derive(Debug)]
struct Meanings {
    of: &'static Vocabulary,
    set: OnceLock<BTreeMap<&'static str, String>>,
}

impl Meanings {
    fn set(&self) -> &BTreeMap<&'static str, String> {
        self.set.get_or_init(|| {
            let symbols = self.of.own.iter().copied().flatten();
            symbols
                .filter(|symbol| !matches!(symbol.source, "event" | "state"))
                .map(|symbol| (symbol.id, prose(symbol.text, |id| find(self.of, id))))
                .collect()
        })
    }
}

impl Words {
    /// The words of a language. English has the meanings of symbols from the
    /// tables of the models, and the publications from their list; the other
    /// languages translate both in groups of their own.
    /// Single words of the user's own files take the place of these.
    pub(crate) fn new<'a>(
        language: &Language,
        own: impl IntoIterator<Item = (&'a str, &'a str)>,
        own_references: Option<&str>,
    ) -> Result<Words, String> {
        let mut words = merged(language.words())?;
        let mut meanings = Vec::new();
        if language.code == LANGUAGES[0].code {
            for of in vocabularies().map(|(_, of)| of).chain(LENT) {
                words.entry(of.words.to_owned()).or_default();
                meanings.push(Meanings {
                    of,
                    set: OnceLock::new(),
                });
            }
            words.insert("reference".to_owned(), parse("references.toml", REFERENCES)?);
        }
        let mut replace = |group: &str, own: toml::Table| {
            if let Some(group) = words.get_mut(group) {
                group.extend(own);
            }
        };
        if let Some(own) = own_references {
            replace("reference", parse("references.toml", own)?);
        }
        for (group, own) in merged(own)? {
            replace(&group, own);
        }
        Ok(Words::with(words, meanings))
    }

    fn with(groups: Groups, meanings: Vec<Meanings>) -> Words {
        Words(Arc::new(Known { groups, meanings }))
    }

    pub(crate) fn get(&self, group: &str, id: &str) -> Result<&str, String> {
        let mut of_group = vocabularies().map(|(_, of)| of).filter(|of| of.words == group);
        let shared = || {
            let of = of_group.next()?;
            let mut lent = LENT
                .iter()
                .filter(|lent| lent.own.iter().all(|table| of.shared.contains(table)));
            lent.find_map(|lent| self.find(lent.words, id))
                .or_else(|| self.find(SHARED, id))
        };
        let word = self.find(group, id).or_else(shared);
        word.ok_or_else(|| format!("no words for {group}.{id}"))
    }

    fn find(&self, group: &str, id: &str) -> Option<&str> {
        let Known { groups, meanings } = &*self.0;
        let meaning = || {
            let mut of_group = meanings.iter().filter(|meanings| meanings.of.words == group);
            of_group.find_map(|meanings| meanings.set().get(id))
        };
        let word = groups.get(group).and_then(|words| words.get(id)?.as_str());
        word.or_else(|| meaning().map(String::as_str))
    }

    /// The words for an id, those of a part that the machine has before all others.
    pub(crate) fn of_parts(&self, parts: &[&str], group: &str, id: &str) -> Result<&str, String> {
        let own = parts.iter().find_map(|part| self.of_part(group, part, id));
        own.map_or_else(|| self.get(group, id), Ok)
    }

    /// What a symbol is, in the words of the first mechanism that has it.
    pub(crate) fn meaning(&self, symbol: &Symbol) -> Option<&str> {
        let mut of = vocabularies().filter(|(_, known)| known.has(symbol));
        of.find_map(|(_, known)| self.get(known.words, symbol.id).ok())
    }

    /// Keys of the publications.
    pub(crate) fn references(&self) -> Vec<String> {
        let all = self.0.groups.get("reference");
        all.into_iter().flat_map(toml::Table::keys).cloned().collect()
    }

    /// The words for an id where the machine has a part, if there are any of that part alone.
    pub(crate) fn of_part(&self, group: &str, part: &str, id: &str) -> Option<&str> {
        let group = if vocabularies().any(|(_, symbols)| symbols.words == group) {
            SHARED
        } else {
            group
        };
        self.find(&format!("{group}_{part}"), id)
    }

    #[cfg(test)]
    pub(crate) fn of(text: &str) -> Words {
        Words::with(merged([("words.toml", text)]).expect("groups of words"), Vec::new())
    }

    /// Every word with its group and id.
    #[cfg(test)]
    fn all(&self) -> impl Iterator<Item = (&str, &str, &str)> {
        let meanings = self.0.meanings.iter().flat_map(|meanings| {
            let set = meanings.set().iter();
            set.map(|(&id, word)| (meanings.of.words, id, word.as_str()))
        });
        let groups = self.0.groups.iter().flat_map(|(group, words)| {
            words
                .iter()
                .map(move |(id, text)| (group.as_str(), id.as_str(), text.as_str().expect("a text")))
        });
        groups.chain(meanings)
    }
}

/// The groups of several files, each of which may add to any of them; no word stands twice.
fn merged<'a>(files: impl IntoIterator<Item = (&'a str, &'a str)>) -> Result<Groups, String> {
    let mut groups = Groups::new();
    for (name, text) in files {
        for (id, group) in parse(name, text)? {
            let toml::Value::Table(group) = group else {
                return Err(format!("templates/{name}: {id} is not a group of words"));
            };
            let words = groups.entry(id.clone()).or_default();
            if let Some(word) = group.keys().find(|&word| words.contains_key(word)) {
                return Err(format!("templates/{name}: {id}.{word} stands in another file already"));
            }
            words.extend(group);
        }
    }
    Ok(groups)
}

fn parse(name: &str, text: &str) -> Result<toml::Table, String> {
    text.parse().map_err(|error| format!("templates/{name}: {error}"))
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use lemnis_models::kernel::number::short;

    use super::*;

    #[test]
    fn every_language_has_the_words_of_english_and_no_others() {
        let keys = |language| -> BTreeSet<String> {
            let words = Words::new(language, [], None).expect("TOML");
            let key = |(group, id, word): (&str, &str, &str)| {
                assert!(!word.trim().is_empty(), "{group}.{id}");
                format!("{group}.{id}")
            };
            words.all().map(key).collect()
        };
        let english = keys(&LANGUAGES[0]);
        assert!(english.len() > 200);
        for language in &LANGUAGES[1..] {
            let words = keys(language);
            let missing: Vec<_> = english.difference(&words).collect();
            let superfluous: Vec<_> = words.difference(&english).collect();
            assert!(missing.is_empty(), "{}: no words for {missing:?}", language.code);
            assert!(
                superfluous.is_empty(),
                "{}: nobody needs {superfluous:?}",
                language.code
            );
        }
    }

    #[test]
    fn every_language_has_every_word_in_the_same_file() {
        let places = |language: &Language| {
            let mut places = BTreeSet::new();
            for (name, text) in language.words() {
                let file = name.rsplit('/').next().expect("a file");
                for (group, words) in merged([(name, text)]).expect("TOML") {
                    places.extend(words.keys().map(|id| (file, group.clone(), id.clone())));
                }
            }
            places
        };
        // English has the meanings of symbols and the publications elsewhere.
        let translated = |group: &str| group.ends_with("symbol") || group == "reference";
        for pair in LANGUAGES.windows(2) {
            let [one, other] = [places(&pair[0]), places(&pair[1])];
            let elsewhere = one.symmetric_difference(&other);
            let elsewhere = elsewhere.filter(|(_, group, _)| pair[0].code != "en" || !translated(group));
            let elsewhere: Vec<_> = elsewhere.collect();
            assert!(
                elsewhere.is_empty(),
                "{}, {}: {elsewhere:?}",
                pair[0].code,
                pair[1].code
            );
        }
    }

    #[test]
    fn every_file_of_words_is_read() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../templates/");
        for language in &LANGUAGES {
            let known: BTreeSet<_> = language.words().map(|(name, _)| name.to_owned()).collect();
            let path = format!("words/{}/", language.code);
            let files = std::fs::read_dir(format!("{folder}{path}")).expect("a folder for each language");
            let files = files.map(|file| format!("{path}{}", file.expect("a file").file_name().display()));
            assert_eq!(files.collect::<BTreeSet<_>>(), known);
        }
    }

    /// What stands right after a name is read as code: a semicolon would be lost.
    #[test]
    fn no_punctuation_of_a_word_is_eaten() {
        let eaten = |word: &str| {
            word.split('#').skip(1).any(|rest| {
                let after = rest.trim_start_matches(|c: char| c.is_ascii_alphanumeric() || "_-".contains(c));
                let mut next = after.chars();
                after.len() < rest.len()
                    && match next.next() {
                        Some(';' | '(' | '[') => true,
                        Some('.') => next.next().is_some_and(|c| c.is_ascii_alphabetic()),
                        _ => false,
                    }
            })
        };
        assert!(eaten("#deepest; numerical") && eaten("#at.x") && !eaten("#deepest\\; numerical, #at. Below"));
        for language in &LANGUAGES {
            for (group, id, word) in Words::new(language, [], None).expect("TOML").all() {
                assert!(!eaten(word), "{}: {group}.{id}", language.code);
            }
        }
    }

    #[test]
    fn a_word_stands_once() {
        let [first, second] = ["[head]\nat = \"At\"\n[text]\nlang = \"en\"", "[head]\nunit = \"Unit\""];
        let both = merged([("a.toml", first), ("b.toml", second)]).expect("two words of one group");
        assert_eq!(both["head"].len(), 2);
        assert_eq!(
            merged([("a.toml", first), ("b.toml", second), ("c.toml", first)]),
            Err("templates/c.toml: head.at stands in another file already".to_owned())
        );
        assert_eq!(
            merged([("a.toml", "head = 1")]),
            Err("templates/a.toml: head is not a group of words".to_owned())
        );
    }

    #[test]
    fn scenes_know_the_same_languages() {
        let codes: Vec<_> = LANGUAGES.iter().map(|language| language.code).collect();
        assert_eq!(codes, lemnis_models::kernel::text::LANGUAGES);
    }

    #[test]
    fn a_decimal_comma_is_quoted_in_mathematics() {
        let [english, _, bulgarian] = &LANGUAGES;
        for (value, point, comma, text) in [
            (160.0, "160", "160", "160"),
            (19.3, "19.3", "\"19,3\"", "19,3"),
            (-0.25, "-0.25", "-\"0,25\"", "−0,25"),
            (-1.5e-7, "-1.5 times 10^(-7)", "-\"1,5\" times 10^(-7)", "−1,5 · 10⁻⁷"),
            (f64::NEG_INFINITY, "-infinity", "-infinity", "−∞"),
            (f64::NAN, "\"undefined\"", "\"неопределено\"", "неопределено"),
        ] {
            let number = short(value);
            assert_eq!(english.math(&number), point);
            assert_eq!(bulgarian.math(&number), comma);
            assert_eq!(bulgarian.text(&number), text);
        }
    }
}

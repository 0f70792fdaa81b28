//! Templates: words and layout of the book. Text is escaped so that Typst
//! prints it and never runs it; what is Typst already is marked `safe`.
//!
//! A user's folder overrides any part: templates by their names, single words
//! by any file in `words/en/` and so on. A template that was overridden can still be
//! included or extended as `lemnis/NAME`. All other files of the folder, such as
//! a logo, can be read by the templates.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::path::{Path, PathBuf};
use std::sync::{Arc, LazyLock, OnceLock};

use minijinja::syntax::SyntaxConfig;
use minijinja::value::{Serde, Value};
use minijinja::{Environment, ErrorKind, State, UndefinedBehavior, context};
use serde::Serialize;

use crate::language::{LANGUAGES, Language, Words, symbol};
use crate::print::picture::Picture;
use crate::print::prose::prose;
use crate::print::speech;
use crate::print::text::{self, breakable, escape};

macro_rules! embedded {
    ($($name:literal),* $(,)?) => {
        &[$(($name, include_str!(concat!("../../templates/", $name)))),*]
    };
}

/// Every template by its name; the whole book first.
const TEMPLATES: &[(&str, &str)] = embedded![
    "book.typ",
    "style.typ",
    "picture.typ",
    "title.typ",
    "section.typ",
    "source.typ",
    "values.typ",
    "own.typ",
    "results.typ",
    "task.typ",
    "inputs.typ",
    "conventions.typ",
    "views.typ",
    "sensitivity.typ",
    "constants.typ",
    "positions.typ",
    "range.typ",
    "charts.typ",
    "forces.typ",
    "sizing.typ",
    "balance.typ",
    "cases.typ",
    "motion.typ",
    "cycle.typ",
    "synthesis.typ",
    "search.typ",
    "trade.typ",
    "study.typ",
    "published.typ",
    "remarks.typ",
    "notation.typ",
    "references.typ",
    "identities.typ",
    "scene.typ",
];

const REFERENCES: &str = "references.toml";

/// Before the name of a template: that of the program, though the user has another.
const ORIGINAL: &str = "lemnis/";

/// Everything that a user's folder can override, by its path in it.
#[must_use]
pub fn originals() -> Vec<(&'static str, &'static str)> {
    let words = LANGUAGES.iter().flat_map(Language::words);
    let references = (REFERENCES, crate::language::REFERENCES);
    TEMPLATES.iter().copied().chain(words).chain([references]).collect()
}

/// Why there is no book: a template or its words are wrong.
#[derive(Debug)]
pub struct Error(pub String);

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Error {}

/// The templates of books, ready to be filled in.
pub struct Templates {
    /// Where the user's own are.
    folder: Option<PathBuf>,
    own: BTreeMap<String, String>,
    /// What the templates can read beside the words.
    files: Vec<(String, Vec<u8>)>,
    ready: Arc<EachLanguage>,
}

type EachLanguage = [OnceLock<Result<Ready, String>>; LANGUAGES.len()];

/// Of the embedded templates, once for the program.
static EMBEDDED: LazyLock<Arc<EachLanguage>> = LazyLock::new(Arc::default);

/// The templates with the words of one language.
struct Ready {
    environment: Environment<'static>,
    words: Words,
}

impl Templates {
    /// Those that travel with the program.
    #[must_use]
    pub fn embedded() -> Templates {
        Templates {
            folder: None,
            own: BTreeMap::new(),
            files: Vec::new(),
            ready: Arc::clone(&EMBEDDED),
        }
    }

    /// Those of a user's folder over the embedded ones.
    ///
    /// # Errors
    /// A folder or a file that cannot be read, or words of no language.
    pub fn with_folder(folder: &Path) -> Result<Templates, String> {
        let mut templates = Templates {
            folder: Some(folder.to_owned()),
            ready: Arc::default(),
            ..Templates::embedded()
        };
        templates.read(folder, "")?;
        let nobodys = |name: &String| name.starts_with("words/") && !LANGUAGES.iter().any(|known| known.owns(name));
        if let Some(name) = templates.own.keys().find(|name| nobodys(name)) {
            let languages = LANGUAGES.each_ref().map(|language| format!("words/{}/", language.code));
            return Err(format!(
                "{} is read by no language: words stand in the folders {}",
                folder.join(name).display(),
                languages.join(", ")
            ));
        }
        Ok(templates)
    }

    fn read(&mut self, folder: &Path, path: &str) -> Result<(), String> {
        let unreadable = |error| format!("cannot read the templates in {}: {error}", folder.display());
        for entry in std::fs::read_dir(folder).map_err(unreadable)? {
            let entry = entry.map_err(unreadable)?;
            let name = format!("{path}{}", entry.file_name().to_string_lossy());
            if entry.file_type().map_err(unreadable)?.is_dir() {
                self.read(&entry.path(), &format!("{name}/"))?;
                continue;
            }
            let bytes = std::fs::read(entry.path()).map_err(unreadable)?;
            let text = name.ends_with(".typ") || name.ends_with(".toml");
            match String::from_utf8(bytes) {
                Ok(content) if text => {
                    self.own.insert(name, content);
                }
                Ok(content) => self.files.push((name, content.into_bytes())),
                Err(error) if !text => self.files.push((name, error.into_bytes())),
                Err(_) => return Err(format!("{} is not text in UTF-8", entry.path().display())),
            }
        }
        self.files.sort();
        Ok(())
    }

    /// Files beside the templates, for them to read.
    #[must_use]
    pub fn files(&self) -> &[(String, Vec<u8>)] {
        &self.files
    }

    /// The book's Typst source.
    pub(crate) fn render(&self, book: &impl Serialize, language: &Language) -> Result<String, Error> {
        let Ready { environment, words } = self.ready(language)?;
        let source =
            whole(environment, &Serde(book).into()).map_err(|error| Error(describe(self.folder.as_deref(), &error)))?;
        speech::accessible(&source, words).map_err(Error)
    }

    /// The Typst source of a page with a picture and nothing else; the title also says what it shows.
    ///
    /// # Errors
    /// A template with a mistake, or an id without words.
    pub fn picture(&self, picture: &Picture, title: &str, language: &Language) -> Result<String, Error> {
        let Ready { environment, .. } = self.ready(language)?;
        let page = environment
            .get_template("picture.typ")
            .and_then(|template| template.render(context! { book => context! { html => false } }));
        let page = page.map_err(|error| Error(describe(self.folder.as_deref(), &error)))?;
        let title = escape(title);
        Ok(format!(
            "#set document(title: \"{title}\")\n{page}\n#set page(width: auto, height: auto, margin: 3mm)\n\
             #figure(picture(\"{}\"), alt: \"{title}\")\n",
            escape(&picture.json())
        ))
    }

    /// Reads them with the words of a language, where no book in it was made yet.
    pub fn prepare(&self, language: &Language) {
        // A mistake is told by the book.
        let _ = self.ready(language);
    }

    fn ready(&self, language: &Language) -> Result<&Ready, Error> {
        let place = LANGUAGES.iter().position(|known| known.code == language.code);
        let ready = self.ready[place.expect("a language of the table")].get_or_init(|| self.read_in(language));
        ready.as_ref().map_err(|error| Error(error.clone()))
    }

    fn read_in(&self, language: &Language) -> Result<Ready, String> {
        let own = |name: &str| self.own.get(name).map(String::as_str);
        let own_words = self.own.iter().filter(|(name, _)| language.owns(name));
        let own_words = own_words.map(|(name, text)| (name.as_str(), text.as_str()));
        let words = Words::new(language, own_words, own(REFERENCES)).map_err(|error| self.place(&error))?;
        let mut environment = environment(words.clone());
        // What travels with the program is read when a book needs it.
        environment.set_loader(|name| {
            let name = name.strip_prefix(ORIGINAL).unwrap_or(name);
            let found = TEMPLATES.iter().find(|(known, _)| *known == name);
            Ok(found.map(|(_, source)| (*source).to_owned()))
        });
        for (name, source) in self.own.iter().filter(|(name, _)| name.ends_with(".typ")) {
            environment
                .add_template_owned(name.clone(), source.clone())
                .map_err(|error| describe(self.folder.as_deref(), &error))?;
        }
        Ok(Ready { environment, words })
    }

    /// With the user's folder, if there is one, before the name of a file.
    fn place(&self, error: &str) -> String {
        match &self.folder {
            Some(folder) => error.replacen("templates/", &format!("{}/", folder.display()), 1),
            None => error.to_owned(),
        }
    }
}

/// A book rendered; a list of references that stands before chapters which cite has what they cite, too.
fn whole(environment: &Environment<'static>, book: &Value) -> Result<String, minijinja::Error> {
    let template = environment.get_template(TEMPLATES[0].0)?;
    let render = |cited: &BTreeSet<String>| template.render_captured(context! { book, known => cited });
    let made = render(&BTreeSet::new())?;
    match made.state().get_extension() {
        Some(Cited { all, listed: Some(few) }) if *few < all.len() => Ok(render(all)?.into_output()),
        _ => Ok(made.into_output()),
    }
}

fn environment(words: Words) -> Environment<'static> {
    let syntax = SyntaxConfig::builder()
        .block_delimiters("<%", "%>")
        .comment_delimiters("<#", "#>")
        .line_statement_prefix("//%")
        .build()
        .expect("delimiters that differ");
    let mut environment = Environment::new();
    environment.set_syntax(syntax);
    environment.set_undefined_behavior(UndefinedBehavior::Strict);
    // Lets an error name the variable.
    environment.set_debug(true);
    environment.set_formatter(|out, state, value| {
        if value.is_undefined() {
            return Err(ErrorKind::UndefinedError.into());
        }
        match value.as_str().filter(|_| !value.is_safe()) {
            Some(text) => out.write_str(&escape(text)).map_err(Into::into),
            None => minijinja::escape_formatter(out, state, value),
        }
    });
    environment.add_filter("string", |text: &str| Value::from_safe_string(text::string(text)));
    environment.add_filter("breakable", |text: &str| breakable(text));
    environment.add_filter("brief", brief);
    let keys = words.references();
    environment.add_filter("prose", move |state: &mut State, text: &str| {
        cite(state, &keys, text);
        let book = state.lookup("book").unwrap_or_default();
        let mechanism = book.get_attr("mechanism")?;
        let print = |id: &str| symbol(mechanism.as_str().unwrap_or_default(), id);
        Ok::<_, minijinja::Error>(Value::from_safe_string(prose(text, print)))
    });
    counting(&mut environment);
    let undefined = |detail| minijinja::Error::new(ErrorKind::UndefinedError, detail);
    let dictionary = words.clone();
    // Of a part that the machine has, its own words: `symbol_rod` before `symbol`.
    let keys = words.references();
    environment.add_function("word", move |state: &mut State, group: &str, id: &str| {
        let book = state.lookup("book").unwrap_or_default();
        let parts = book.get_attr("parts")?;
        let parts: Vec<Value> = parts.try_iter().into_iter().flatten().collect();
        let parts: Vec<&str> = parts.iter().filter_map(Value::as_str).collect();
        let word = dictionary.of_parts(&parts, group, id).map_err(undefined)?;
        cite(state, &keys, word);
        Ok(Value::from_safe_string(word.to_owned()))
    });
    // "[Li2022, eq. 5]" with the language's own "eq.".
    let keys = words.references();
    environment.add_filter("citation", move |state: &mut State, source: &str| {
        cite(state, &keys, source);
        ["eq.", "Fig.", "Table"]
            .iter()
            .try_fold(source.to_owned(), |source, &place| {
                let word = words.get("citation", place).map_err(undefined)?;
                Ok::<_, minijinja::Error>(source.replace(place, word))
            })
    });
    environment.add_function("cited", |state: &mut State| {
        let known = state.lookup("known").unwrap_or_default();
        let known = known
            .try_iter()?
            .filter_map(|key| key.as_str().map(str::to_owned))
            .collect::<Vec<_>>();
        let cited = state.get_or_insert_extension(Cited::default());
        cited.all.extend(known);
        cited.listed = Some(cited.all.len());
        Ok::<_, minijinja::Error>(cited.all.iter().cloned().collect::<Value>())
    });
    environment
}

/// Numbers of headings, figures, tables and equations.
fn counting(environment: &mut Environment<'static>) {
    // "2.1" and so on. Typst's own numbers would come from counters, which cost a further pass over the document.
    environment.add_function("number", |state: &mut State, level: usize| {
        let counts = &mut state.get_or_insert_extension(Headings::default()).0;
        counts.resize(level, 0);
        if let Some(count) = counts.last_mut() {
            *count += 1;
        }
        let counts: Vec<String> = counts.iter().map(usize::to_string).collect();
        Value::from_safe_string(counts.join("."))
    });
    environment.add_function("figure", |state: &mut State| {
        let count = &mut state.get_or_insert_extension(Figures::default()).0;
        *count += 1;
        *count
    });
    environment.add_function("table", |state: &mut State| {
        let count = &mut state.get_or_insert_extension(Tables::default()).0;
        *count += 1;
        *count
    });
    // "6.12": by chapters.
    environment.add_function("equation", |state: &mut State| {
        let headings = &state.get_or_insert_extension(Headings::default()).0;
        let chapter = headings.first().copied().unwrap_or_default();
        let last = state.get_or_insert_extension(Equations::default());
        if last.chapter != chapter {
            *last = Equations { chapter, count: 0 };
        }
        last.count += 1;
        Value::from_safe_string(format!("{chapter}.{}", last.count))
    });
}

/// Keeps the publications that a text cites, as `[Li2022]` or `[Li2022, eq. 5]`, out of those with these keys.
fn cite(state: &mut State, keys: &[String], text: &str) {
    let cites = |key: &&String| {
        let mut after = text.split('[').filter_map(|rest| rest.strip_prefix(key.as_str()));
        after.any(|rest| rest.starts_with([',', ']', ';']))
    };
    let found = keys.iter().filter(cites).cloned();
    state.get_or_insert_extension(Cited::default()).all.extend(found);
}

/// Keys of the publications that a book has cited so far, and how many there were when they were listed.
#[derive(Default)]
struct Cited {
    all: BTreeSet<String>,
    listed: Option<usize>,
}

/// How many headings of each level a book has so far, since the last one of a level above.
#[derive(Default)]
struct Headings(Vec<usize>);

#[derive(Default)]
struct Figures(usize);

#[derive(Default)]
struct Tables(usize);

/// How many formulas the chapter has so far.
#[derive(Default)]
struct Equations {
    chapter: usize,
    count: usize,
}

/// Template, line, and what is wrong with which variable. Templates of the user
/// are named with their folder.
fn describe(folder: Option<&Path>, error: &minijinja::Error) -> String {
    // An included template's own error is the source of the including one's.
    let inner = std::error::Error::source(error).and_then(|source| source.downcast_ref::<minijinja::Error>());
    if let Some(inner) = inner {
        return describe(folder, inner);
    }
    let place = match (error.name(), error.line()) {
        (Some(name), Some(line)) => {
            let own = folder.map(|folder| folder.join(name)).filter(|path| path.exists());
            let name = own.map_or_else(|| format!("templates/{name}"), |path| path.display().to_string());
            format!("{name}:{line}: ")
        }
        _ => String::new(),
    };
    let detail = error.detail().map_or_else(|| error.kind().to_string(), str::to_owned);
    format!("{place}{detail}")
}

/// The beginning of a text that is too long to stand in every header.
fn brief(text: &str) -> String {
    const LONGEST: usize = 80;
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_words_that_no_line_holds_may_be_broken() {
        for plain in [
            "Portal crane of 100 kN",
            "四连杆门座起重机变幅机构计算书以及平衡系统的优化设计",
            "Donaukranschiff",
        ] {
            assert_eq!(breakable(plain), plain);
        }
        let broken = breakable(&"W".repeat(30));
        assert_eq!(
            broken.split('\u{200b}').map(str::len).collect::<Vec<_>>(),
            [4, 4, 4, 4, 4, 4, 4, 2]
        );
        assert_eq!(brief(&"W".repeat(81)).chars().count(), 81);
    }

    #[test]
    fn an_error_names_template_line_and_variable() {
        let cases = [
            ("one\n{{ book.gone }}", "templates/book.typ:2: `book.gone` is undefined"),
            (
                "{{ word(\"section\", \"gone\") }}",
                "templates/book.typ:1: no words for section.gone",
            ),
            ("\n<% for %>", "templates/book.typ:2: "),
        ];
        for (source, message) in cases {
            let mut environment = environment(Words::of("[section]\n"));
            let rendered = environment.add_template("book.typ", source).and_then(|()| {
                let template = environment.get_template("book.typ")?;
                template.render(context! { book => context! {} })
            });
            let rendered = rendered.map_err(|error| describe(None, &error));
            let error = rendered.unwrap_err();
            assert!(error.starts_with(message), "{error}");
        }
    }
}

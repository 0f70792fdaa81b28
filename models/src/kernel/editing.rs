//! What may stand at a place of a scene's text that is being written, and what stands there: for completion and hover in
//! an editor. The text need not be TOML yet; what counts is read from what stands before the place.

use std::ops::Range;

use toml::de::{DeTable, DeValue};

use crate::kernel::courses::{BETWEEN, OVER, SHAPED};
use crate::kernel::diagnostic::Edit;
use crate::kernel::example::{is_table, template};
use crate::kernel::keys::NOTE;
use crate::kernel::measure::units;
use crate::kernel::schema::{KIND, Key, Kind};
use crate::kernel::sign::Sign;
use crate::kernel::site::{Context, Site};
use crate::kernel::text::LANGUAGES;
use crate::kernel::unit;
use crate::kernel::variable::TIME;

/// Something that may be written.
#[derive(Clone, Debug)]
pub struct Completion {
    /// By which a list shows it.
    pub label: String,
    pub edit: Edit,
    /// The key that it is, or whose value it is.
    pub key: Key,
}

/// What stands at a place.
#[derive(Clone, Debug)]
pub struct Hover {
    /// From the top of the scene: `luffing.X_1`.
    pub path: String,
    pub key: Key,
    /// Bytes of the scene's text.
    pub span: Range<usize>,
}

/// What may be written at a byte of a scene's text, in the order of the keys, needed ones first; nothing in comments and
/// where no key of the scene leads.
#[must_use]
pub fn complete(keys: &'static [Key], text: &str, offset: usize) -> Vec<Completion> {
    let Some(before) = text.get(..offset) else {
        return Vec::new();
    };
    let (written, site) = (Written::new(keys, text, offset), Site::at(before));
    match site.context {
        Context::Header { list } => written.headers(list, &site.word),
        Context::Key => written.keys(site.within(), &site.word),
        Context::Value { list } => match written.find(&site.path) {
            Some(key) => values(&key, &text[site.word.clone()], &closed(text, site.word), list),
            None => Vec::new(),
        },
        Context::Nothing => Vec::new(),
    }
}

/// What is written of a value, to its closing quote in the same line.
fn closed(text: &str, word: Range<usize>) -> Range<usize> {
    let quote = text[word.clone()].chars().next().filter(|c| matches!(c, '"' | '\''));
    let line = text[word.end..].lines().next().unwrap_or_default();
    let rest = quote.and_then(|quote| line.find(quote)).map_or(0, |at| at + 1);
    word.start..word.end + rest
}

/// What stands at a byte of a scene's text: the key there, or the one whose value or table it is.
#[must_use]
pub fn hover(keys: &'static [Key], text: &str, offset: usize) -> Option<Hover> {
    let inside = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    let rest = text.get(offset..)?;
    let end = offset + rest.find(|c| !inside(c)).unwrap_or(rest.len());
    let site = Site::at(&text[..end]);
    let names = matches!(site.context, Context::Header { .. } | Context::Key) && !site.word.is_empty();
    if !names && !matches!(site.context, Context::Value { .. }) {
        return None;
    }
    let key = Written::new(keys, text, offset).find(&site.path)?;
    Some(Hover {
        path: site.path.join("."),
        key,
        span: site.name,
    })
}

/// A scene as far as it is written.
struct Written<'a> {
    keys: &'static [Key],
    table: DeTable<'a>,
    /// Of several tables of a list the one before this byte is meant.
    offset: usize,
}

impl<'a> Written<'a> {
    fn new(keys: &'static [Key], text: &'a str, offset: usize) -> Written<'a> {
        let (table, _) = DeTable::parse_recoverable(text);
        Written {
            keys,
            table: table.into_inner(),
            offset,
        }
    }

    /// The table at the end of a path, as far as there is one.
    fn given(&self, path: &[String]) -> Option<&DeTable<'a>> {
        let mut table = &self.table;
        for name in path {
            table = match table.get(name.as_str())?.get_ref() {
                DeValue::Table(table) => table,
                DeValue::Array(list) => {
                    let before = list.iter().rfind(|item| item.span().start <= self.offset);
                    before.or(list.last())?.get_ref().as_table()?
                }
                _ => return None,
            };
        }
        Some(table)
    }

    /// The keys of the table at the end of a path; of what has no keys of its own, none.
    fn within(&self, path: &[String]) -> Vec<Key> {
        let Some((last, before)) = path.split_last() else {
            return self.keys.to_vec();
        };
        let Some(key) = self.within(before).into_iter().find(|key| key.name == last) else {
            return Vec::new();
        };
        let own = |key: &Key, path: &[String]| {
            let kind = self.given(path).and_then(|table| table.get(KIND)?.get_ref().as_str());
            inside(key, kind)
        };
        // A part that stands beside its mechanism is one of it.
        let beside = |other: &&Key| before.is_empty() && other.name != key.name && self.table.contains_key(other.name);
        let mut parts = self.keys.iter().filter(beside);
        let part = parts.find_map(|other| {
            let parts = own(other, &[other.name.to_owned()]);
            parts.into_iter().find(|part| part.name == key.name && is_table(part))
        });
        own(&part.unwrap_or(key), path)
    }

    fn find(&self, path: &[String]) -> Option<Key> {
        let (last, before) = path.split_last()?;
        self.within(before).into_iter().find(|key| key.name == last)
    }

    /// Keys of a table that are not there yet.
    fn keys(&self, path: &[String], word: &Range<usize>) -> Vec<Completion> {
        let given = self.given(path);
        // What is being written is there already.
        let written = |key: &Key| {
            let mut names = given.into_iter().flat_map(DeTable::keys);
            names.any(|name| name.get_ref() == key.name && name.span().start != word.start)
        };
        let mut open = self.within(path);
        open.retain(|key| !is_table(key) && !written(key));
        open.sort_by_key(|key| !key.required);
        let completion = |key: Key| {
            let (text, caret) = template(&key);
            let (label, replaced) = (key.name.to_owned(), word.clone());
            let edit = Edit { replaced, text, caret };
            Completion { label, edit, key }
        };
        open.into_iter().map(completion).collect()
    }

    /// Tables that are not there yet, or lists of them.
    fn headers(&self, list: bool, word: &Range<usize>) -> Vec<Completion> {
        let mut found = Vec::new();
        self.tables(&mut Vec::new(), list, &mut found);
        let completion = |(path, key): (String, Key)| Completion {
            edit: Edit::new(word.clone(), path.as_str()),
            label: path,
            key,
        };
        found.into_iter().map(completion).collect()
    }

    /// Tables of what is there already, in the order of the keys.
    fn tables(&self, path: &mut Vec<String>, list: bool, found: &mut Vec<(String, Key)>) {
        for key in self.within(path).into_iter().filter(is_table) {
            path.push(key.name.to_owned());
            let (is_list, given) = (matches!(key.kind, Kind::Tables(..)), self.given(path).is_some());
            if is_list == list && (is_list || !given) {
                found.push((path.join("."), key));
            }
            if given {
                self.tables(path, list, found);
            }
            path.pop();
        }
    }
}

/// The keys of what stands behind a key, of a table of several kinds those of this one.
fn inside(key: &Key, kind: Option<&str>) -> Vec<Key> {
    match key.kind {
        Kind::Table(keys) | Kind::Tables(keys, _) => keys.to_vec(),
        Kind::Kinds(kinds) => {
            let named = kinds.iter().find(|(known, _)| Some(*known) == kind);
            named.unwrap_or(&kinds[0]).1.to_vec()
        }
        Kind::Quantity(..) | Kind::Weight(..) => {
            let input = key.input.then_some("input");
            let values = ["value"].into_iter().chain(input);
            let over = [
                Key {
                    name: OVER,
                    kind: Kind::Texts(usize::MAX),
                    ..*key
                },
                Key::choice(BETWEEN, key.between, "What it does from one time to the next."),
                Key::named(
                    SHAPED,
                    &TIME,
                    Sign::Positive,
                    "Period of a swing that it leaves without: half of it comes half of that later.",
                )
                .optional(),
            ];
            let over = over.into_iter().filter(|_| !key.between.is_empty());
            values
                .map(|name| Key { name, ..*key })
                .chain(over)
                .chain([NOTE])
                .collect()
        }
        Kind::Text | Kind::Line => LANGUAGES
            .map(|name| Key {
                name,
                kind: Kind::Name,
                ..*key
            })
            .to_vec(),
        _ => Vec::new(),
    }
}

/// What may stand behind a key, of which this is written; `list` where a list is open.
fn values(key: &Key, written: &str, word: &Range<usize>, list: bool) -> Vec<Completion> {
    let completion = |label: &str, text: String| Completion {
        label: label.to_owned(),
        edit: Edit::new(word.clone(), text),
        key: *key,
    };
    match key.kind {
        Kind::Choice(choices) | Kind::Choices(choices) => {
            let bare = list || matches!(key.kind, Kind::Choice(_));
            let quoted = |choice: &str| {
                if bare {
                    format!("\"{choice}\"")
                } else {
                    format!("[\"{choice}\"]")
                }
            };
            choices
                .iter()
                .map(|choice| completion(choice, quoted(choice)))
                .collect()
        }
        _ => {
            let text = written.trim_matches('"');
            let end = text.find(|c: char| !(c.is_ascii_digit() || "+-.eE_ ".contains(c)));
            let number = text[..end.unwrap_or(text.len())].trim_end_matches(['e', 'E']).trim();
            let unit = |name: &'static str| match number {
                "" => {
                    let mut completion = completion(name, format!("\" {name}\""));
                    completion.edit.caret = 1;
                    completion
                }
                _ => completion(&format!("{number} {name}"), format!("\"{number} {name}\"")),
            };
            // What has no dimension needs no unit.
            units(key)
                .into_iter()
                .filter(|name| *name != unit::ONE.name)
                .map(unit)
                .collect()
        }
    }
}

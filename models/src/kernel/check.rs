//! Checks a scene's tables against their keys.

use std::ops::Range;

use toml::Spanned;
use toml::de::{DeArray, DeTable, DeValue};
use toml::value::Datetime;

use crate::kernel::courses::{self, OVER};
use crate::kernel::diagnostic::{Diagnostic, Edit};
use crate::kernel::example::{example, is_table, template, wanted};
use crate::kernel::keys::NOTE;
use crate::kernel::measure::{number, quantity};
use crate::kernel::schema::{GivenNumber, KIND, Key, Kind, Value, Values};
use crate::kernel::sign::Sign;
use crate::kernel::symbol::Symbol;
use crate::kernel::text::{LANGUAGES, Text};

/// Checks a table of a scene with the text `source` against its keys. All mistakes are collected, not only the first.
pub fn check(
    source: &str,
    table: &DeTable<'_>,
    span: Range<usize>,
    path: &str,
    keys: &'static [Key],
    found: &mut Vec<Diagnostic>,
) -> Values {
    let place = if path.is_empty() {
        "at the top of the scene".to_owned()
    } else {
        format!("in [{path}]")
    };
    let mut values = Values::default();
    (values.keys, values.span) = (keys, span.clone());
    for (name, value) in table {
        let Some(key) = keys.iter().find(|key| key.name == name.get_ref().as_ref()) else {
            found.push(unknown(name, &place, keys));
            continue;
        };
        if let Some(checked) = check_value(source, value, &under(path, key), key, found) {
            let at = values.entries.partition_point(|(before, ..)| *before < key.name);
            values.entries.insert(at, (key.name, checked, value.span()));
        } else {
            values.unsound.push(key.name);
        }
    }
    for key in keys.iter().filter(|key| key.required) {
        if !table.keys().any(|name| name.get_ref() == key.name) {
            found.push(missing(span.clone(), &place, &under(path, key), key).fix(added(source, &span, path, key)));
        }
    }
    values
}

/// The path of a key in the table of a path.
fn under(path: &str, key: &Key) -> String {
    let dot = if path.is_empty() { "" } else { "." };
    format!("{path}{dot}{}", key.name)
}

/// A key that is needed in a table and not there; `place` as "in [luffing]", with the key's own path.
pub(crate) fn missing(span: Range<usize>, place: &str, path: &str, key: &Key) -> Diagnostic {
    Diagnostic::new(span, format!("`{}` is missing {place}", key.name), "needed here")
        .help(format!("add {}", example(path, key)))
}

/// A needed key under the header of its table, or in the first line of the scene.
fn added(source: &str, table: &Range<usize>, path: &str, key: &Key) -> Option<Edit> {
    let line = source[table.start..]
        .find('\n')
        .map_or(source.len(), |length| table.start + length);
    let (top, header) = (path.is_empty(), source[table.start..].starts_with('['));
    if is_table(key) {
        let end = source.len()..source.len();
        return (top || header).then(|| Edit::new(end, format!("\n[{}]\n", under(path, key))));
    }
    let (text, caret) = template(key);
    match (top, header) {
        (true, true) => Some(Edit {
            replaced: 0..0,
            text: format!("{text}\n"),
            caret,
        }),
        (true, false) | (false, true) => Some(Edit {
            replaced: line..line,
            text: format!("\n{text}"),
            caret: caret + 1,
        }),
        (false, false) => None,
    }
}

fn unknown(name: &Spanned<std::borrow::Cow<'_, str>>, place: &str, keys: &'static [Key]) -> Diagnostic {
    let nearest = keys
        .iter()
        .map(|key| (strsim::damerau_levenshtein(key.name, name.get_ref()), key.name))
        .min()
        .filter(|(distance, known)| *distance <= 2.max(known.len() / 3));
    let known: Vec<&str> = keys.iter().map(|key| key.name).collect();
    let help = match nearest {
        Some((_, known)) => format!("did you mean `{known}`?"),
        None => format!("known here: {}", known.join(", ")),
    };
    Diagnostic::new(
        name.span(),
        format!("unknown key `{}` {place}", name.get_ref()),
        "not known",
    )
    .help(help)
    .fix(nearest.map(|(_, known)| Edit::new(name.span(), known)))
}

fn check_value(
    source: &str,
    value: &Spanned<DeValue<'_>>,
    path: &str,
    key: &'static Key,
    found: &mut Vec<Diagnostic>,
) -> Option<Value> {
    let mut wrong = |label: String| {
        found.push(
            Diagnostic::new(value.span(), format!("`{path}` is not {}", wanted(key)), label).help(example(path, key)),
        );
        None
    };
    match (&key.kind, value.get_ref()) {
        (Kind::Lines, DeValue::String(text)) => {
            let text = printable(text, value.span(), path, key, found)?;
            Some(Value::Texts(lines(source, &text, value.span())))
        }
        (Kind::Text | Kind::Line | Kind::Name | Kind::Date, DeValue::String(text)) => {
            Some(Value::Text(printable(text, value.span(), path, key, found)?.into()))
        }
        (Kind::Text | Kind::Line, DeValue::Table(table)) => translated(table, value.span(), path, key, found),
        (Kind::Choice(choices), DeValue::String(text)) => {
            if choices.contains(&text.as_ref()) {
                Some(Value::Text(text.to_string().into()))
            } else {
                wrong(format!("`{text}` is none of them"))
            }
        }
        (Kind::Table(keys), DeValue::Table(table)) => {
            Some(Value::Table(check(source, table, value.span(), path, keys, found)))
        }
        (Kind::Kinds(kinds), DeValue::Table(table)) => of_kind(source, table, value.span(), path, kinds, found),
        (Kind::Quantity(..) | Kind::Weight(..), DeValue::String(text)) => match number(text, key) {
            Ok(number) => Some(Value::Number(number)),
            Err((message, label, help)) => {
                let wrong = Diagnostic::new(value.span(), format!("`{path}`: {message}"), label).help(help);
                found.push(wrong.fix(mended(text, key).map(|text| Edit::new(value.span(), text))));
                None
            }
        },
        (Kind::Quantity(..) | Kind::Weight(..), DeValue::Table(table)) => {
            let told = !key.between.is_empty() && table.contains_key(OVER);
            let read = if told { over_time } else { noted };
            read(source, table, value.span(), path, key, found)
        }
        (Kind::Texts(most) | Kind::Tables(_, most), DeValue::Array(items)) if items.len() > *most => {
            let message = format!("`{path}` has {} entries", items.len());
            // A list of tables has no place of its own.
            let place = items.get(*most).map_or_else(|| value.span(), Spanned::span);
            found.push(Diagnostic::new(place, message, "too many").help(format!("at most {most} are taken")));
            None
        }
        (Kind::Texts(_) | Kind::Choices(_), DeValue::Array(items)) => Some(texts(items, path, key, found)),
        (Kind::Tables(keys, _), DeValue::Array(items)) => Some(tables(source, items, path, (key, keys), found)),
        (Kind::Quantities(symbol, sign, [least, most]), DeValue::Array(_) | DeValue::String(_)) => {
            let items = match value.get_ref() {
                DeValue::Array(items) => items.iter().collect(),
                _ => vec![value],
            };
            if !(*least..=*most).contains(&items.len()) {
                return wrong(format!("{} of them", items.len()));
            }
            numbers(&items, symbol, *sign, path, key, found)
        }
        (Kind::Count([least, most]), DeValue::Integer(number)) => match number.as_str().parse() {
            Ok(count) if (*least..=*most).contains(&count) => Some(Value::Count(count)),
            _ => wrong(format!("`{}` is none", number.as_str())),
        },
        (Kind::Named, DeValue::Table(table)) => Some(named(table, path, key, found)),
        (Kind::Quantity(symbol, _) | Kind::Weight(symbol, _), DeValue::Integer(_) | DeValue::Float(_)) => {
            let text = match value.get_ref() {
                DeValue::Integer(number) => number.as_str().to_owned(),
                other => other
                    .as_float()
                    .map(|number| number.as_str().to_owned())
                    .unwrap_or_default(),
            };
            let unit = symbol.display.name;
            found.push(
                Diagnostic::new(value.span(), format!("`{path}` has no unit"), "a bare number")
                    .help(format!("write \"{text} {unit}\" if it is in {unit}"))
                    .fix(Edit::new(value.span(), format!("\"{text} {unit}\""))),
            );
            None
        }
        (_, other) => wrong(format!("a TOML {}", other.type_str())),
    }
}

/// A quantity with a decimal point, or with its unit, where it is one then.
fn mended(text: &str, key: &Key) -> Option<String> {
    let (symbol, _) = key.number()?;
    let point = text.trim().replacen(',', ".", 1);
    let unit = format!("{point} {}", symbol.display.name);
    let readable = [point, unit].into_iter().find(|text| number(text, key).is_ok())?;
    Some(format!("\"{readable}\""))
}

/// A table whose keys follow from its `kind`.
fn of_kind(
    source: &str,
    table: &DeTable<'_>,
    span: Range<usize>,
    path: &str,
    kinds: &'static [(&'static str, &'static [Key])],
    found: &mut Vec<Diagnostic>,
) -> Option<Value> {
    let given = table.iter().find(|(name, _)| name.get_ref() == KIND);
    let Some((_, given)) = given else {
        return Some(Value::Table(check(source, table, span, path, kinds[0].1, found)));
    };
    let text = given.get_ref().as_str();
    if let Some((_, keys)) = kinds.iter().find(|(kind, _)| Some(*kind) == text) {
        return Some(Value::Table(check(source, table, span, path, keys, found)));
    }
    let known: Vec<&str> = kinds.iter().map(|(kind, _)| *kind).collect();
    let message = format!("`{path}.{KIND}` is not one of {}", known.join(", "));
    let of_type = || format!("a TOML {}", given.get_ref().type_str());
    let label = text.map_or_else(of_type, |text| format!("`{text}` is none of them"));
    let help = format!("{KIND} = \"{}\"", known[0]);
    found.push(Diagnostic::new(given.span(), message, label).help(help));
    None
}

fn texts(items: &DeArray<'_>, path: &str, key: &'static Key, found: &mut Vec<Diagnostic>) -> Value {
    let mut texts: Vec<(String, Range<usize>)> = Vec::new();
    for item in items {
        let allowed = |text: &str| match key.kind {
            Kind::Choices(choices) => choices.contains(&text) && texts.iter().all(|(known, _)| known != text),
            _ => true,
        };
        match item.get_ref() {
            DeValue::String(text) if allowed(text) => texts.push((text.to_string(), item.span())),
            _ => {
                let message = format!("`{path}` is not {}", wanted(key));
                found.push(Diagnostic::new(item.span(), message, "not this").help(example(path, key)));
            }
        }
    }
    Value::Texts(texts)
}

/// A list of tables under a key, each with these keys.
fn tables(
    source: &str,
    items: &DeArray<'_>,
    path: &str,
    (key, keys): (&'static Key, &'static [Key]),
    found: &mut Vec<Diagnostic>,
) -> Value {
    let mut tables = Vec::new();
    for item in items {
        if let DeValue::Table(table) = item.get_ref() {
            tables.push(check(source, table, item.span(), path, keys, found));
        } else {
            let message = format!("`{path}` is not {}", wanted(key));
            found.push(Diagnostic::new(item.span(), message, "not a table").help(example(path, key)));
        }
    }
    Value::Tables(tables)
}

fn numbers(
    items: &[&Spanned<DeValue<'_>>],
    symbol: &'static Symbol,
    sign: Sign,
    path: &str,
    key: &'static Key,
    found: &mut Vec<Diagnostic>,
) -> Option<Value> {
    let before = found.len();
    let mut numbers = Vec::new();
    for item in items {
        let DeValue::String(text) = item.get_ref() else {
            let message = format!("`{path}` is not {}", wanted(key));
            found.push(Diagnostic::new(item.span(), message, "not a text").help(example(path, key)));
            continue;
        };
        match quantity(text, symbol, sign) {
            Ok(number) => numbers.push((number, item.span())),
            Err((message, label, help)) => {
                found.push(Diagnostic::new(item.span(), format!("`{path}`: {message}"), label).help(help));
            }
        }
    }
    (found.len() == before).then_some(Value::Numbers(numbers))
}

fn named(table: &DeTable<'_>, path: &str, key: &'static Key, found: &mut Vec<Diagnostic>) -> Value {
    let mut named = Vec::new();
    for (name, value) in table {
        if let DeValue::String(text) = value.get_ref() {
            named.push((name.get_ref().to_string(), text.to_string(), value.span()));
        } else {
            let message = format!("`{path}.{}` is not a number with a unit, as text", name.get_ref());
            found.push(Diagnostic::new(value.span(), message, "not a text").help(example(path, key)));
        }
    }
    Value::Named(named)
}

/// A text in several languages.
fn translated(
    table: &DeTable<'_>,
    span: Range<usize>,
    path: &str,
    key: &'static Key,
    found: &mut Vec<Diagnostic>,
) -> Option<Value> {
    let (before, mut texts) = (found.len(), Vec::new());
    for (name, value) in table {
        let path = format!("{path}.{}", name.get_ref());
        let Some(code) = LANGUAGES.into_iter().find(|code| code == name.get_ref()) else {
            let message = format!("`{path}` is in no language of books");
            let help = format!("languages: {}", LANGUAGES.join(", "));
            found.push(Diagnostic::new(name.span(), message, "not known").help(help));
            continue;
        };
        match value.get_ref() {
            DeValue::String(text) => {
                texts.extend(printable(text, value.span(), &path, key, found).map(|text| (code, text)));
            }
            other => {
                let label = format!("a TOML {}", other.type_str());
                let help = format!("{code} = \"...\"");
                found.push(Diagnostic::new(value.span(), format!("`{path}` is not a text"), label).help(help));
            }
        }
    }
    let text = Text::translated(texts).filter(|_| found.len() == before);
    if text.is_none() && found.len() == before {
        let message = format!("`{path}` is in no language");
        found.push(Diagnostic::new(span, message, "empty").help(example(path, key)));
    }
    text.map(Value::Text)
}

/// A text that can be printed; what is wrong with another one goes to the list.
fn printable(text: &str, span: Range<usize>, path: &str, key: &Key, found: &mut Vec<Diagnostic>) -> Option<String> {
    let Some((message, help)) = unprintable(text, &key.kind) else {
        return Some(text.to_owned());
    };
    found.push(Diagnostic::new(span, format!("`{path}` {message}"), "not this").help(help));
    None
}

/// Most characters of a line.
const LONGEST_LINE: usize = 500;

/// Why a text cannot be printed, and what to do.
fn unprintable(text: &str, kind: &Kind) -> Option<(String, String)> {
    // Those beyond the control characters are no characters, or mark the order of bytes: PDF/A allows none of them.
    let broken = |c: &char| matches!(c, '\n' | '\r' | '\u{85}' | '\u{2028}' | '\u{2029}');
    let hidden = |c: &char| c.is_control() || matches!(c, '\u{feff}' | '\u{fffe}' | '\u{ffff}');
    let allowed = |c: &char| matches!(c, '\t' | '\n' | '\r');
    if let Some(c) = text.chars().find(|c| hidden(c) && !allowed(c) && !broken(c)) {
        let message = format!("has a character that cannot be printed, U+{:04X}", u32::from(c));
        return Some((message, "remove it".to_owned()));
    }
    match kind {
        Kind::Line if text.trim().is_empty() => Some(("is empty".to_owned(), "write something".to_owned())),
        Kind::Line if text.contains(|c| broken(&c)) => Some((
            "has more than one line".to_owned(),
            "write it in one line; what is too long for a line of the book is broken there".to_owned(),
        )),
        Kind::Line if text.chars().count() > LONGEST_LINE => Some((
            format!("has {} characters", text.chars().count()),
            format!("at most {LONGEST_LINE} are printed"),
        )),
        Kind::Date if looks_iso(text) && date(text).is_none() => Some((
            format!("is no date: {text} does not exist"),
            "write the year, the month and the day as YYYY-MM-DD".to_owned(),
        )),
        _ => None,
    }
}

/// Four, two and two digits with strokes between them.
fn looks_iso(text: &str) -> bool {
    let parts: Vec<usize> = text.split('-').map(str::len).collect();
    parts == [4, 2, 2] && text.bytes().all(|c| c.is_ascii_digit() || c == b'-')
}

/// Year, month and day of a date as `YYYY-MM-DD`; `None` of any other text, and of a day that does not exist.
#[must_use]
pub fn date(text: &str) -> Option<(u16, u8, u8)> {
    let date = text.parse::<Datetime>().ok().filter(|_| looks_iso(text))?.date?;
    Some((date.year, date.month, date.day))
}

/// The lines of a text that are not empty, each with its place in the scene; with that of the whole text where escapes
/// stand in it.
fn lines(scene: &str, text: &str, span: Range<usize>) -> Vec<(String, Range<usize>)> {
    let filled = |line: &str| !line.trim().is_empty();
    let mut places = Vec::new();
    let mut start = span.start;
    for line in scene.get(span.clone()).unwrap_or_default().split_inclusive('\n') {
        let content = line.trim().trim_matches(['"', '\'']).trim();
        let at = start + content.as_ptr().addr() - line.as_ptr().addr();
        places.extend(filled(content).then(|| (content, at..at + content.len())));
        start += line.len();
    }
    let lines: Vec<&str> = text.lines().filter(|line| filled(line)).map(str::trim).collect();
    let plain = lines.len() == places.len() && lines.iter().zip(&places).all(|(line, (raw, _))| line == raw);
    let placed = lines.iter().enumerate().map(|(i, line)| {
        let place = if plain { places[i].1.clone() } else { span.clone() };
        ((*line).to_owned(), place)
    });
    placed.collect()
}

/// Where a quantity comes from.
fn note(scene: &str, value: &Spanned<DeValue<'_>>, path: &str, found: &mut Vec<Diagnostic>) -> Option<Text> {
    match check_value(scene, value, &format!("{path}.{}", NOTE.name), &NOTE, found) {
        Some(Value::Text(text)) => Some(text),
        _ => None,
    }
}

/// A quantity with a note where it comes from.
fn noted(
    scene: &str,
    table: &DeTable<'_>,
    span: Range<usize>,
    path: &str,
    key: &'static Key,
    found: &mut Vec<Diagnostic>,
) -> Option<Value> {
    let before = found.len();
    let (mut number, mut source): (Option<GivenNumber>, _) = (None, None);
    for (name, value) in table {
        match (name.get_ref().as_ref(), value.get_ref()) {
            (name @ ("value" | "input"), DeValue::String(_)) if number.is_none() && (key.input || name == "value") => {
                match check_value(scene, value, path, key, found) {
                    Some(Value::Number(value)) => {
                        let input = name == "input";
                        number = Some(GivenNumber { input, ..value });
                    }
                    _ => return None,
                }
            }
            ("source", DeValue::String(_) | DeValue::Table(_)) => {
                source = Some(note(scene, value, path, found)?);
            }
            _ => {
                let message = match name.get_ref().as_ref() {
                    "input" if !key.input => format!("`{path}` cannot be an input: it has a `value`"),
                    _ => {
                        let value = if key.input { "`value` or `input`" } else { "`value`" };
                        format!("`{path}` has {value} and `source`, both texts, and nothing else")
                    }
                };
                found.push(Diagnostic::new(name.span(), message, "not this").help(example(path, key)));
            }
        }
    }
    if number.is_none() && found.len() == before {
        found.push(Diagnostic::new(span, format!("`{path}` has no `value`"), "needed here").help(example(path, key)));
    }
    number.map(|number| Value::Number(GivenNumber { source, ..number }))
}

/// A quantity over time, with a note where it comes from.
fn over_time(
    scene: &str,
    table: &DeTable<'_>,
    span: Range<usize>,
    path: &str,
    key: &'static Key,
    found: &mut Vec<Diagnostic>,
) -> Option<Value> {
    let course = courses::read(table, &span, path, key, found);
    let said = table.iter().find(|(name, _)| name.get_ref() == NOTE.name);
    let source = match said {
        None => None,
        Some((_, value)) => Some(note(scene, value, path, found)?),
    };
    let course = course?;
    Some(Value::Number(GivenNumber {
        value: course.rows[0][1],
        mass: None,
        input: false,
        course: Some(course),
        source,
    }))
}

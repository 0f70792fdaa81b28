//! What a scene may say, as data: the one place behind reading, checking and
//! the JSON Schema for editors.

use std::ops::Range;

use serde_json::{Map, Value as Json, json};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::diagnostic::Diagnostic;
use crate::symbol::Symbol;
use crate::unit::{self, Unit};

/// A key of a scene.
#[derive(Debug)]
pub struct Key {
    pub name: &'static str,
    pub kind: Kind,
    pub required: bool,
    pub text: &'static str,
}

/// What stands behind a key.
#[derive(Debug)]
pub enum Kind {
    Text,
    Choice(&'static [&'static str]),
    /// A number with a unit, as text: `"19.3 m"`; or with a note where it comes
    /// from: `{ value = "19.3 m", source = "drawing 12-345" }`.
    Quantity(&'static Symbol, Sign),
    Table(&'static [Key]),
    /// A list of texts.
    Texts,
    /// A list of some of these, none twice.
    Choices(&'static [&'static str]),
    /// A list of tables: `[[...]]`.
    Tables(&'static [Key]),
    /// A list of at least and at most so many quantities; one may stand without brackets.
    Quantities(&'static Symbol, Sign, [usize; 2]),
    /// A whole number, zero or greater.
    Count,
    /// A table of quantities by the names of variables: `{ "A.x" = "1 mm" }`.
    Named,
}

/// Which numbers a quantity may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    Positive,
    NotNegative,
    Any,
    /// Positive, and up to [`COARSEST`].
    Tolerance,
}

/// Greatest relative tolerance of a solver or an interpolation: what is only a tenth right is bounded, and means little.
pub const COARSEST: f64 = 0.1;

impl Key {
    #[must_use]
    pub const fn quantity(symbol: &'static Symbol, sign: Sign) -> Key {
        Key::named(symbol.id, symbol, sign, symbol.text)
    }

    /// A quantity under a name of its own.
    #[must_use]
    pub const fn named(name: &'static str, symbol: &'static Symbol, sign: Sign, text: &'static str) -> Key {
        Key {
            name,
            kind: Kind::Quantity(symbol, sign),
            required: true,
            text,
        }
    }

    #[must_use]
    pub const fn table(name: &'static str, keys: &'static [Key], text: &'static str) -> Key {
        Key {
            name,
            kind: Kind::Table(keys),
            required: true,
            text,
        }
    }

    /// A text that may be left out.
    #[must_use]
    pub const fn text(name: &'static str, text: &'static str) -> Key {
        Key {
            name,
            kind: Kind::Text,
            required: false,
            text,
        }
    }

    #[must_use]
    pub const fn optional(mut self) -> Key {
        self.required = false;
        self
    }
}

impl Sign {
    /// Whether `value` is one of these numbers.
    #[must_use]
    pub fn allows(self, value: f64) -> bool {
        value.is_finite()
            && match self {
                Sign::Positive => value > 0.0,
                Sign::NotNegative => value >= 0.0,
                Sign::Any => true,
                Sign::Tolerance => value > 0.0 && value <= COARSEST,
            }
    }

    /// In words.
    #[must_use]
    pub fn words(self) -> &'static str {
        match self {
            Sign::Positive => "a finite number greater than zero",
            Sign::NotNegative => "a finite number, zero or greater",
            Sign::Any => "a finite number",
            Sign::Tolerance => "greater than zero and at most 0.1",
        }
    }
}

/// A checked part of a scene.
#[derive(Clone, Debug)]
pub enum Value {
    Text(String),
    /// In SI, with the note where it comes from.
    Number(f64, Option<String>),
    Table(Values),
    /// With their places.
    Texts(Vec<(String, Range<usize>)>),
    Tables(Vec<Values>),
    /// In SI, with their places.
    Numbers(Vec<(f64, Range<usize>)>),
    Count(u64),
    /// Names and texts, each with the place of its text.
    Named(Vec<(String, String, Range<usize>)>),
}

/// A checked table: every value with its place.
#[derive(Clone, Debug, Default)]
pub struct Values {
    /// In the order of their names.
    entries: Vec<(&'static str, Value, Range<usize>)>,
    /// Place of the table itself.
    pub span: Range<usize>,
}

impl Values {
    /// Not inlined: scenes ask for hundreds of keys.
    #[inline(never)]
    fn entry(&self, name: &str) -> Option<(&Value, &Range<usize>)> {
        let found = self.entries.iter().find(|(known, ..)| *known == name);
        found.map(|(_, value, place)| (value, place))
    }

    /// In SI; `None` where the scene does not give it.
    #[must_use]
    pub fn number(&self, name: &str) -> Option<f64> {
        match self.entry(name) {
            Some((Value::Number(number, _), _)) => Some(*number),
            _ => None,
        }
    }

    #[must_use]
    pub fn text(&self, name: &str) -> Option<&str> {
        match self.entry(name) {
            Some((Value::Text(text), _)) => Some(text),
            _ => None,
        }
    }

    #[must_use]
    pub fn table(&self, name: &str) -> Option<&Values> {
        match self.entry(name) {
            Some((Value::Table(table), _)) => Some(table),
            _ => None,
        }
    }

    /// The texts of a list with their places; empty where the scene gives none.
    #[must_use]
    pub fn texts(&self, name: &str) -> &[(String, Range<usize>)] {
        match self.entry(name) {
            Some((Value::Texts(texts), _)) => texts,
            _ => &[],
        }
    }

    /// The tables of a list; empty where the scene gives none.
    #[must_use]
    pub fn tables(&self, name: &str) -> &[Values] {
        match self.entry(name) {
            Some((Value::Tables(tables), _)) => tables,
            _ => &[],
        }
    }

    /// The quantities of a list with their places; empty where the scene gives none.
    #[must_use]
    pub fn numbers(&self, name: &str) -> &[(f64, Range<usize>)] {
        match self.entry(name) {
            Some((Value::Numbers(numbers), _)) => numbers,
            _ => &[],
        }
    }

    #[must_use]
    pub fn count(&self, name: &str) -> Option<u64> {
        match self.entry(name) {
            Some((Value::Count(count), _)) => Some(*count),
            _ => None,
        }
    }

    /// Names and texts of a table of named quantities; empty where the scene gives none.
    #[must_use]
    pub fn named(&self, name: &str) -> &[(String, String, Range<usize>)] {
        match self.entry(name) {
            Some((Value::Named(named), _)) => named,
            _ => &[],
        }
    }

    /// Every quantity of this table and of the tables in it: its key from the
    /// top of the scene, its place, and where it comes from by its own note or
    /// by the `source` of its table.
    pub fn quantities(&self, path: &str, found: &mut Vec<(String, Range<usize>, Option<String>)>) {
        for (name, value, place) in &self.entries {
            let key = if path.is_empty() {
                (*name).to_owned()
            } else {
                format!("{path}.{name}")
            };
            match value {
                Value::Number(_, source) => {
                    let source = source.as_deref().or_else(|| self.text("source"));
                    found.push((key, place.clone(), source.map(str::to_owned)));
                }
                Value::Table(table) => table.quantities(&key, found),
                Value::Tables(tables) => {
                    for (number, table) in (1..).zip(tables) {
                        let number: usize = number;
                        table.quantities(&format!("{key}[{number}]"), found);
                    }
                }
                _ => {}
            }
        }
    }

    /// Whether the scene gives a sound value for a key.
    #[must_use]
    pub fn has(&self, name: &str) -> bool {
        self.entry(name).is_some()
    }

    /// Place of a key's value; of the table where the key is absent.
    #[must_use]
    pub fn place(&self, name: &str) -> Range<usize> {
        self.entry(name)
            .map_or_else(|| self.span.clone(), |(_, span)| span.clone())
    }
}

/// Checks a table against its keys. All mistakes are collected, not only the first.
pub fn check(
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
    let mut entries: Vec<(&'static str, Value, Range<usize>)> = Vec::new();
    for (name, value) in table {
        let Some(key) = keys.iter().find(|key| key.name == name.get_ref().as_ref()) else {
            found.push(unknown(name, &place, keys));
            continue;
        };
        let full = if path.is_empty() {
            key.name.to_owned()
        } else {
            format!("{path}.{}", key.name)
        };
        if let Some(checked) = check_value(value, &full, key, found) {
            let at = entries.partition_point(|(before, ..)| *before < key.name);
            entries.insert(at, (key.name, checked, value.span()));
        }
    }
    for key in keys.iter().filter(|key| key.required) {
        if !table.keys().any(|name| name.get_ref() == key.name) {
            found.push(missing(span.clone(), &place, key));
        }
    }
    Values { entries, span }
}

/// A key that is needed in a table and not there; `place` as "in [luffing]".
pub(crate) fn missing(span: Range<usize>, place: &str, key: &Key) -> Diagnostic {
    Diagnostic::new(span, format!("`{}` is missing {place}", key.name), "needed here")
        .help(format!("add {}", example(key)))
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
}

fn check_value(
    value: &Spanned<DeValue<'_>>,
    path: &str,
    key: &'static Key,
    found: &mut Vec<Diagnostic>,
) -> Option<Value> {
    let mut wrong = |label: String| {
        found.push(Diagnostic::new(value.span(), format!("`{path}` is not {}", wanted(key)), label).help(example(key)));
        None
    };
    match (&key.kind, value.get_ref()) {
        (Kind::Text, DeValue::String(text)) => Some(Value::Text(text.to_string())),
        (Kind::Choice(choices), DeValue::String(text)) => {
            if choices.contains(&text.as_ref()) {
                Some(Value::Text(text.to_string()))
            } else {
                wrong(format!("`{text}` is none of them"))
            }
        }
        (Kind::Table(keys), DeValue::Table(table)) => Some(Value::Table(check(table, value.span(), path, keys, found))),
        (Kind::Quantity(symbol, sign), DeValue::String(text)) => match quantity(text, symbol, *sign) {
            Ok(number) => Some(Value::Number(number, None)),
            Err((message, label, help)) => {
                found.push(Diagnostic::new(value.span(), format!("`{path}`: {message}"), label).help(help));
                None
            }
        },
        (Kind::Quantity(..), DeValue::Table(table)) => noted(table, value.span(), path, key, found),
        (Kind::Texts | Kind::Choices(_), DeValue::Array(items)) => {
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
                        found.push(Diagnostic::new(item.span(), message, "not this").help(example(key)));
                    }
                }
            }
            Some(Value::Texts(texts))
        }
        (Kind::Tables(keys), DeValue::Array(items)) => {
            let mut tables = Vec::new();
            for item in items {
                if let DeValue::Table(table) = item.get_ref() {
                    tables.push(check(table, item.span(), path, keys, found));
                } else {
                    let message = format!("`{path}` is not {}", wanted(key));
                    found.push(Diagnostic::new(item.span(), message, "not a table").help(example(key)));
                }
            }
            Some(Value::Tables(tables))
        }
        (Kind::Quantities(symbol, sign, [least, most]), DeValue::Array(_) | DeValue::String(_)) => {
            let items = match value.get_ref() {
                DeValue::Array(items) => items.iter().collect(),
                _ => vec![value],
            };
            if !(*least..=*most).contains(&items.len()) {
                return wrong(format!("{} of them", items.len()));
            }
            let before = found.len();
            let mut numbers = Vec::new();
            for item in items {
                let DeValue::String(text) = item.get_ref() else {
                    let message = format!("`{path}` is not {}", wanted(key));
                    found.push(Diagnostic::new(item.span(), message, "not a text").help(example(key)));
                    continue;
                };
                match quantity(text, symbol, *sign) {
                    Ok(number) => numbers.push((number, item.span())),
                    Err((message, label, help)) => {
                        found.push(Diagnostic::new(item.span(), format!("`{path}`: {message}"), label).help(help));
                    }
                }
            }
            (found.len() == before).then_some(Value::Numbers(numbers))
        }
        (Kind::Count, DeValue::Integer(number)) => match number.as_str().parse::<i64>().map(u64::try_from) {
            Ok(Ok(count)) => Some(Value::Count(count)),
            _ => wrong(format!("`{}` is none", number.as_str())),
        },
        (Kind::Named, DeValue::Table(table)) => {
            let mut named = Vec::new();
            for (name, value) in table {
                if let DeValue::String(text) = value.get_ref() {
                    named.push((name.get_ref().to_string(), text.to_string(), value.span()));
                } else {
                    let message = format!("`{path}.{}` is not a number with a unit, as text", name.get_ref());
                    found.push(Diagnostic::new(value.span(), message, "not a text").help(example(key)));
                }
            }
            Some(Value::Named(named))
        }
        (Kind::Quantity(symbol, _), DeValue::Integer(_) | DeValue::Float(_)) => {
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
                    .help(format!("write \"{text} {unit}\" if it is in {unit}")),
            );
            None
        }
        (_, other) => wrong(format!("a TOML {}", other.type_str())),
    }
}

/// A quantity with a note where it comes from.
fn noted(
    table: &DeTable<'_>,
    span: Range<usize>,
    path: &str,
    key: &'static Key,
    found: &mut Vec<Diagnostic>,
) -> Option<Value> {
    let before = found.len();
    let (mut number, mut source) = (None, None);
    for (name, value) in table {
        match (name.get_ref().as_ref(), value.get_ref()) {
            ("value", DeValue::String(_)) => match check_value(value, path, key, found) {
                Some(Value::Number(value, _)) => number = Some(value),
                _ => return None,
            },
            ("source", DeValue::String(text)) => source = Some(text.to_string()),
            _ => {
                let message = format!("`{path}` has `value` and `source`, both texts, and nothing else");
                found.push(Diagnostic::new(name.span(), message, "not this").help(example(key)));
            }
        }
    }
    if number.is_none() && found.len() == before {
        found.push(Diagnostic::new(span, format!("`{path}` has no `value`"), "needed here").help(example(key)));
    }
    Some(Value::Number(number?, source))
}

/// Reads `"19.3 m"` for `symbol`; on failure message, label and help.
pub(crate) fn quantity(text: &str, symbol: &'static Symbol, sign: Sign) -> Result<f64, (String, String, String)> {
    let text = text.trim();
    let display = symbol.display.name;
    let end = text
        .find(|c: char| !(c.is_ascii_digit() || "+-.,eE_".contains(c)))
        .unwrap_or(text.len());
    // "5 em": an exponent without digits belongs to the unit.
    let end = text[..end].trim_end_matches(['e', 'E']).len();
    let (number, unit_text) = (&text[..end], text[end..].trim());
    let Ok(number) = number.parse::<f64>() else {
        let help = if number.contains(',') {
            "use a decimal point".to_owned()
        } else {
            format!("write a number and a unit: \"1.5 {display}\"")
        };
        return Err((
            format!("\"{text}\" does not begin with a number"),
            "cannot be read".to_owned(),
            help,
        ));
    };
    let unit = if unit_text.is_empty() {
        Some(&unit::ONE)
    } else {
        unit::find(unit_text)
    };
    let Some(unit) = unit else {
        return Err((
            format!("the unit \"{unit_text}\" is not known"),
            "unknown unit".to_owned(),
            format!("units for it: {}", units_of(symbol)),
        ));
    };
    if unit.dimension != symbol.unit.dimension || unit.rad != symbol.unit.rad {
        let given = if unit_text.is_empty() {
            "no unit".to_owned()
        } else {
            format!("the unit {}", unit.name)
        };
        return Err((
            format!("{given} does not fit, it is measured in {display}"),
            "wrong unit".to_owned(),
            format!("units for it: {}", units_of(symbol)),
        ));
    }
    let value = number * unit.factor;
    if !sign.allows(value) {
        return Err((
            format!("{text} is not allowed, it must be {}", sign.words()),
            "out of range".to_owned(),
            format!("{}: {}", symbol.id, symbol.text),
        ));
    }
    Ok(value)
}

fn units_of(symbol: &Symbol) -> String {
    let fits = |unit: &&&Unit| unit.dimension == symbol.unit.dimension && unit.rad == symbol.unit.rad;
    unit::ALL
        .iter()
        .filter(fits)
        .map(|unit| unit.name)
        .collect::<Vec<_>>()
        .join(", ")
}

fn wanted(key: &Key) -> String {
    match key.kind {
        Kind::Text => "a text".to_owned(),
        Kind::Choice(choices) => format!("one of {}", choices.join(", ")),
        Kind::Quantity(symbol, _) => format!("a number with a unit such as \"1 {}\"", symbol.display.name),
        Kind::Table(_) => "a table".to_owned(),
        Kind::Texts => "a list of texts".to_owned(),
        Kind::Choices(choices) => format!("a list of {}, none twice", choices.join(", ")),
        Kind::Tables(_) => "a list of tables".to_owned(),
        Kind::Quantities(symbol, _, [least, most]) => {
            let unit = symbol.display.name;
            let count = if least == most {
                format!("{least}")
            } else {
                format!("{least} to {most}")
            };
            format!("a list of {count} numbers with units such as \"1 {unit}\"")
        }
        Kind::Count => "a whole number, zero or greater".to_owned(),
        Kind::Named => "a table of quantities by the names of results".to_owned(),
    }
}

fn example(key: &Key) -> String {
    match key.kind {
        Kind::Text => format!("{} = \"...\"", key.name),
        Kind::Choice(choices) => format!("{} = \"{}\"", key.name, choices[0]),
        Kind::Quantity(symbol, _) => format!("{} = \"... {}\"  ({})", key.name, symbol.display.name, key.text),
        Kind::Table(_) => format!("a table [{}]  ({})", key.name, key.text),
        Kind::Texts => format!("{} = [\"...\"]  ({})", key.name, key.text),
        Kind::Choices(choices) => format!("{} = [\"{}\"]", key.name, choices[0]),
        Kind::Tables(_) => format!("tables [[{}]]  ({})", key.name, key.text),
        Kind::Quantities(symbol, _, [_, most]) => {
            let each = vec![format!("\"... {}\"", symbol.display.name); most];
            format!("{} = [{}]  ({})", key.name, each.join(", "), key.text)
        }
        Kind::Count => format!("{} = 1  ({})", key.name, key.text),
        Kind::Named => format!("{} = {{ \"A.x\" = \"1 mm\" }}  ({})", key.name, key.text),
    }
}

/// The JSON Schema of a table with these keys.
#[must_use]
pub fn json_schema(keys: &'static [Key]) -> Json {
    let properties: Map<String, Json> = keys.iter().map(|key| (key.name.to_owned(), property(key))).collect();
    let required: Vec<&str> = keys.iter().filter(|key| key.required).map(|key| key.name).collect();
    json!({ "type": "object", "additionalProperties": false, "properties": properties, "required": required })
}

fn property(key: &Key) -> Json {
    let text = |symbol: &Symbol| {
        json!({
            "type": "string",
            "pattern": r"^\s*[+-]?[0-9.]+([eE][+-]?[0-9]+)?\s*\S.*$",
            "examples": [format!("1 {}", symbol.display.name)],
        })
    };
    let mut schema = match key.kind {
        Kind::Text => json!({ "type": "string" }),
        Kind::Count => json!({ "type": "integer", "minimum": 0 }),
        Kind::Named => json!({ "type": "object", "additionalProperties": { "type": "string" } }),
        Kind::Quantities(symbol, _, [least, most]) => {
            let list = json!({ "type": "array", "items": text(symbol), "minItems": least, "maxItems": most });
            if least > 1 {
                list
            } else {
                json!({ "anyOf": [text(symbol), list] })
            }
        }
        Kind::Choice(choices) => json!({ "type": "string", "enum": choices }),
        Kind::Quantity(symbol, _) => {
            let value = text(symbol);
            let noted = json!({
                "type": "object",
                "additionalProperties": false,
                "properties": { "value": value, "source": { "type": "string" } },
                "required": ["value"],
            });
            json!({ "anyOf": [value, noted] })
        }
        Kind::Texts => json!({ "type": "array", "items": { "type": "string" } }),
        Kind::Choices(choices) => {
            json!({ "type": "array", "items": { "type": "string", "enum": choices }, "uniqueItems": true })
        }
        Kind::Tables(keys) => json!({ "type": "array", "items": json_schema(keys) }),
        Kind::Table(keys) => json_schema(keys),
    };
    schema["description"] = json!(key.text);
    schema
}

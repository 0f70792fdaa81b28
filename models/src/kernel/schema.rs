//! What a scene may say, as data: the one place behind reading, checking and
//! the JSON Schema for editors.

use std::ops::Range;

use serde_json::{Map, Value as Json, json};

use crate::kernel::number::short;
use crate::kernel::symbol::{COARSEST, Symbol};
use crate::kernel::unit::Unit;

/// A key of a scene.
#[derive(Debug)]
pub struct Key {
    pub name: &'static str,
    pub kind: Kind,
    pub required: bool,
    pub text: &'static str,
}

/// Key that says of which kind a table is.
pub const KIND: &str = "kind";

/// What stands behind a key.
#[derive(Debug)]
pub enum Kind {
    Text,
    /// A text of one line, not empty.
    Line,
    /// A date in any form; one that looks like `YYYY-MM-DD` exists.
    Date,
    /// A text of several lines, each with its place.
    Lines,
    Choice(&'static [&'static str]),
    /// A number with a unit, as text: `"19.3 m"`; or with a note where it comes
    /// from: `{ value = "19.3 m", source = "drawing 12-345" }`.
    Quantity(&'static Symbol, Sign),
    /// A weight, zero or greater, or the mass that weighs it: `"160 kN"`, `"16 t"`.
    Weight(&'static Symbol),
    Table(&'static [Key]),
    /// A table whose keys hang on the value of its key [`KIND`]: each value with its keys, the first one without that key.
    Kinds(&'static [(&'static str, &'static [Key])]),
    /// A list of so many texts at most.
    Texts(usize),
    /// A list of some of these, none twice.
    Choices(&'static [&'static str]),
    /// A list of so many tables at most: `[[...]]`.
    Tables(&'static [Key], usize),
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
    /// Positive, however small.
    Deviation,
}

impl Key {
    #[must_use]
    pub const fn new(name: &'static str, kind: Kind, text: &'static str) -> Key {
        Key {
            name,
            kind,
            required: true,
            text,
        }
    }

    /// One of several, which may be left out.
    #[must_use]
    pub const fn choice(name: &'static str, of: &'static [&'static str], text: &'static str) -> Key {
        Key::new(name, Kind::Choice(of), text).optional()
    }

    #[must_use]
    pub const fn quantity(symbol: &'static Symbol, sign: Sign) -> Key {
        Key::named(symbol.id, symbol, sign, symbol.text)
    }

    /// A quantity under a name of its own.
    #[must_use]
    pub const fn named(name: &'static str, symbol: &'static Symbol, sign: Sign, text: &'static str) -> Key {
        Key::new(name, Kind::Quantity(symbol, sign), text)
    }

    /// A weight that may be given as a mass.
    #[must_use]
    pub const fn weight(symbol: &'static Symbol) -> Key {
        Key::new(symbol.id, Kind::Weight(symbol), symbol.text)
    }

    /// The quantity that stands behind the key, and which numbers it may have; `None` where it is something else.
    #[must_use]
    pub fn number(&self) -> Option<(&'static Symbol, Sign)> {
        match self.kind {
            Kind::Quantity(symbol, sign) => Some((symbol, sign)),
            Kind::Weight(symbol) => Some((symbol, Sign::NotNegative)),
            _ => None,
        }
    }

    #[must_use]
    pub const fn table(name: &'static str, keys: &'static [Key], text: &'static str) -> Key {
        Key::new(name, Kind::Table(keys), text)
    }

    /// A table of several kinds, each with its keys.
    #[must_use]
    pub const fn kinds(
        name: &'static str,
        kinds: &'static [(&'static str, &'static [Key])],
        text: &'static str,
    ) -> Key {
        Key::new(name, Kind::Kinds(kinds), text).optional()
    }

    /// Which kind of a table of several kinds it is, the only one of these.
    #[must_use]
    pub const fn kind(of: &'static [&'static str], text: &'static str) -> Key {
        Key::choice(KIND, of, text)
    }

    /// A text that may be left out.
    #[must_use]
    pub const fn text(name: &'static str, text: &'static str) -> Key {
        Key::new(name, Kind::Text, text).optional()
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
                Sign::Positive | Sign::Deviation => value > 0.0,
                Sign::NotNegative => value >= 0.0,
                Sign::Any => true,
                Sign::Tolerance => value > 0.0 && value <= COARSEST,
            }
    }

    /// In words.
    #[must_use]
    pub fn words(self) -> &'static str {
        match self {
            Sign::Positive | Sign::Deviation => "a finite number greater than zero",
            Sign::NotNegative => "a finite number, zero or greater",
            Sign::Any => "a finite number",
            Sign::Tolerance => "greater than zero and at most 0.1",
        }
    }

    /// What a scene may give of a quantity, in SI: beyond that a number is a slip of its unit.
    pub(super) fn limits(self, unit: &Unit) -> [f64; 2] {
        let [least, most] = unit.limits();
        match self {
            Sign::Positive => [least, most],
            Sign::NotNegative | Sign::Deviation => [0.0, most],
            Sign::Any => [-most, most],
            Sign::Tolerance => [0.0, COARSEST],
        }
    }
}

/// A checked part of a scene.
#[derive(Clone, Debug)]
pub enum Value {
    Text(String),
    Number(GivenNumber),
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

/// A quantity of a scene.
#[derive(Clone, Debug)]
pub struct GivenNumber {
    /// In SI.
    pub value: f64,
    /// In kg, where it is a weight given as a mass.
    pub mass: Option<f64>,
    /// Where the scene says that it comes from.
    pub source: Option<String>,
}

/// A checked table: every value with its place.
#[derive(Clone, Debug, Default)]
pub struct Values {
    /// In the order of their names.
    pub(super) entries: Vec<(&'static str, Value, Range<usize>)>,
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
            Some((Value::Number(number), _)) => Some(number.value),
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

    /// Gives every mass of this table and of the tables in it its weight, by the acceleration of gravity (m/s²).
    pub fn weigh(&mut self, g: f64) {
        for (_, value, _) in &mut self.entries {
            match value {
                Value::Number(number) => {
                    if let Some(mass) = number.mass {
                        number.value = mass * g;
                    }
                }
                Value::Table(table) => table.weigh(g),
                Value::Tables(tables) => tables.iter_mut().for_each(|table| table.weigh(g)),
                _ => {}
            }
        }
    }

    /// Every quantity of this table and of the tables in it: its key from the
    /// top of the scene and its place; it comes from what its own note says, or
    /// the `source` of its table.
    pub fn quantities(&self, path: &str, found: &mut Vec<(String, Range<usize>, GivenNumber)>) {
        for (name, value, place) in &self.entries {
            let key = if path.is_empty() {
                (*name).to_owned()
            } else {
                format!("{path}.{name}")
            };
            match value {
                Value::Number(number) => {
                    let mut number = number.clone();
                    number.source = number.source.or_else(|| self.text("source").map(str::to_owned));
                    found.push((key, place.clone(), number));
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

    /// The quantities of a table that has these keys, in their order.
    #[must_use]
    pub fn quantities_of(&self, keys: &'static [Key]) -> Vec<(&'static Symbol, f64)> {
        let number = |key: &Key| match key.kind {
            Kind::Quantity(symbol, _) => Some((symbol, self.number(key.name)?)),
            _ => None,
        };
        keys.iter().filter_map(number).collect()
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

/// The JSON Schema of a table with these keys.
#[must_use]
pub fn json_schema(keys: &'static [Key]) -> Json {
    let properties: Map<String, Json> = keys.iter().map(|key| (key.name.to_owned(), property(key))).collect();
    let required: Vec<&str> = keys.iter().filter(|key| key.required).map(|key| key.name).collect();
    json!({ "type": "object", "additionalProperties": false, "properties": properties, "required": required })
}

fn property(key: &Key) -> Json {
    let text = |symbol: &Symbol| {
        // What has no dimension needs no unit.
        let pattern = match symbol.display.name {
            "1" => r"^\s*[+-]?[0-9.]+([eE][+-]?[0-9]+)?\s*\S*$",
            _ => r"^\s*[+-]?[0-9.]+([eE][+-]?[0-9]+)?\s*\S.*$",
        };
        json!({
            "type": "string",
            "pattern": pattern,
            "examples": [format!("1 {}", symbol.display.name)],
        })
    };
    let mut schema = match key.kind {
        Kind::Text | Kind::Date | Kind::Lines => json!({ "type": "string" }),
        Kind::Line => json!({ "type": "string", "pattern": r"^.*\S.*$" }),
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
        Kind::Quantity(symbol, _) | Kind::Weight(symbol) => {
            let value = text(symbol);
            let noted = json!({
                "type": "object",
                "additionalProperties": false,
                "properties": { "value": value, "source": { "type": "string" } },
                "required": ["value"],
            });
            json!({ "anyOf": [value, noted] })
        }
        Kind::Texts(most) => json!({ "type": "array", "items": { "type": "string" }, "maxItems": most }),
        Kind::Choices(choices) => {
            json!({ "type": "array", "items": { "type": "string", "enum": choices }, "uniqueItems": true })
        }
        Kind::Tables(keys, most) => json!({ "type": "array", "items": json_schema(keys), "maxItems": most }),
        Kind::Table(keys) => json_schema(keys),
        Kind::Kinds(kinds) => {
            let named = |kind: &str| json!({ "properties": { KIND: { "const": kind } }, "required": [KIND] });
            let first = json_schema(kinds[0].1);
            kinds[1..].iter().rev().fold(
                first,
                |other, (kind, keys)| json!({ "if": named(kind), "then": json_schema(keys), "else": other }),
            )
        }
    };
    let limits = key.number().map_or_else(String::new, |(symbol, sign)| {
        let [least, most] = sign.limits(symbol.unit);
        let mass = match key.kind {
            Kind::Weight(_) => "; or a mass, in kg or t",
            _ => "",
        };
        format!(
            " From {} to {}{mass}.",
            short(symbol.shown(least)),
            symbol.written(most)
        )
    });
    schema["description"] = json!(format!("{}{limits}", key.text));
    schema
}

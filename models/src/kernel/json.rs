//! The JSON Schema of scenes, for editors.

use serde_json::{Map, Value as Json, json};

use crate::kernel::courses::{PULSES_ALLOWED, SWINGS};
use crate::kernel::number::short;
use crate::kernel::schema::{KIND, Key, Kind};
use crate::kernel::symbol::Symbol;
use crate::kernel::text::LANGUAGES;
use crate::kernel::variable::TIME;

/// The JSON Schema of a table with these keys.
#[must_use]
pub fn json_schema(keys: &'static [Key]) -> Json {
    let properties: Map<String, Json> = keys.iter().map(|key| (key.name.to_owned(), property(key))).collect();
    let required: Vec<&str> = keys.iter().filter(|key| key.required).map(|key| key.name).collect();
    json!({ "type": "object", "additionalProperties": false, "properties": properties, "required": required })
}

/// A text, or a table of it in several languages.
fn translated(text: &Json) -> Json {
    let own: Map<String, Json> = LANGUAGES
        .map(|code| (code.to_owned(), text.clone()))
        .into_iter()
        .collect();
    let table = json!({ "type": "object", "additionalProperties": false, "properties": own, "minProperties": 1 });
    json!({ "anyOf": [text, table] })
}

/// A time and a value in every row, and what the value does between two of them.
fn over_time(time: &Json, value: &Json, between: &[&str]) -> Json {
    let row = json!({ "type": "array", "prefixItems": [time, value], "minItems": 2, "maxItems": 2 });
    json!({
        "type": "object",
        "additionalProperties": false,
        "properties": {
            "over": { "type": "array", "items": row, "minItems": 2 },
            "between": { "type": "string", "enum": between },
            "shaped": { "anyOf": [time, { "type": "array", "items": time, "minItems": 1, "maxItems": SWINGS }] },
            "pulses": { "type": "integer", "minimum": PULSES_ALLOWED[0], "maximum": PULSES_ALLOWED[1] },
            "source": translated(&json!({ "type": "string" })),
        },
        "required": ["over", "between"],
    })
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
        Kind::Name | Kind::Date | Kind::Lines => json!({ "type": "string" }),
        Kind::Text => translated(&json!({ "type": "string" })),
        Kind::Line => translated(&json!({ "type": "string", "pattern": r"^.*\S.*$" })),
        Kind::Count([least, most]) => json!({ "type": "integer", "minimum": least, "maximum": most }),
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
        Kind::Quantity(symbol, _) | Kind::Weight(symbol, _) => {
            let value = text(symbol);
            let noted = |name: &str| {
                json!({
                    "type": "object",
                    "additionalProperties": false,
                    "properties": { name: value, "source": translated(&json!({ "type": "string" })) },
                    "required": [name],
                })
            };
            let input = key.input.then(|| noted("input"));
            let over = (!key.between.is_empty()).then(|| over_time(&text(&TIME), &value, key.between));
            let all: Vec<Json> = [value.clone(), noted("value")]
                .into_iter()
                .chain(input)
                .chain(over)
                .collect();
            json!({ "anyOf": all })
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
        let [least, most] = sign.limits(symbol, symbol.unit);
        let mass = match key.kind {
            Kind::Weight(..) => "; or a mass, in kg or t",
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

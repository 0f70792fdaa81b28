//! How keys of scenes are written: in words, as an example, to begin with.

use crate::kernel::schema::{COUNTLESS, Key, Kind};
use crate::kernel::unit;

/// What must stand behind a key.
pub(super) fn wanted(key: &Key) -> String {
    match key.kind {
        Kind::Text | Kind::Line => "a text, or a table of it in several languages".to_owned(),
        Kind::Name | Kind::Date | Kind::Lines => "a text".to_owned(),
        Kind::Choice(choices) => format!("one of {}", choices.join(", ")),
        Kind::Quantity(symbol, _) | Kind::Weight(symbol, _) => {
            format!("a number with a unit such as \"1 {}\"", symbol.display.name)
        }
        Kind::Table(_) | Kind::Kinds(_) => "a table".to_owned(),
        Kind::Texts(_) => "a list of texts".to_owned(),
        Kind::Choices(choices) => format!("a list of {}, none twice", choices.join(", ")),
        Kind::Tables(..) => "a list of tables".to_owned(),
        Kind::Quantities(symbol, _, [least, most]) => {
            let unit = symbol.display.name;
            let count = if least == most {
                format!("{least}")
            } else {
                format!("{least} to {most}")
            };
            format!("a list of {count} numbers with units such as \"1 {unit}\"")
        }
        Kind::Count([0, COUNTLESS]) => "a whole number, zero or greater".to_owned(),
        Kind::Count([least, most]) => format!("a whole number, {least} to {most}"),
        Kind::Named => "a table of quantities by the names of results".to_owned(),
    }
}

/// A key with a value, and what it is; a table by its path.
pub(super) fn example(path: &str, key: &Key) -> String {
    match key.kind {
        Kind::Text | Kind::Line | Kind::Name | Kind::Date | Kind::Lines => format!("{} = \"...\"", key.name),
        Kind::Choice(choices) => format!("{} = \"{}\"", key.name, choices[0]),
        Kind::Quantity(symbol, _) | Kind::Weight(symbol, _) => {
            format!("{} = \"... {}\"  ({})", key.name, symbol.display.name, key.text)
        }
        Kind::Table(_) | Kind::Kinds(_) => format!("a table [{path}]  ({})", key.text),
        Kind::Texts(_) => format!("{} = [\"...\"]  ({})", key.name, key.text),
        Kind::Choices(choices) => format!("{} = [\"{}\"]", key.name, choices[0]),
        Kind::Tables(..) => format!("tables [[{path}]]  ({})", key.text),
        Kind::Quantities(symbol, _, [_, most]) => {
            let each = vec![format!("\"... {}\"", symbol.display.name); most];
            format!("{} = [{}]  ({})", key.name, each.join(", "), key.text)
        }
        Kind::Count([least, _]) => format!("{} = {}  ({})", key.name, least.max(1), key.text),
        Kind::Named => format!("{} = {{ \"...\" = \"...\" }}  ({})", key.name, key.text),
    }
}

/// Whether a key has a header of its own: `[name]`, or `[[name]]`.
pub(super) fn is_table(key: &Key) -> bool {
    matches!(key.kind, Kind::Table(_) | Kind::Kinds(_) | Kind::Tables(..))
}

/// A key to begin with, and where one goes on writing, in bytes.
pub(super) fn template(key: &Key) -> (String, usize) {
    let (open, close) = match key.kind {
        Kind::Quantity(symbol, _) | Kind::Weight(symbol, _) if symbol.display != &unit::ONE => {
            ("\"", format!(" {}\"", symbol.display.name))
        }
        Kind::Texts(_) | Kind::Choices(_) | Kind::Tables(..) | Kind::Quantities(..) => ("[", "]".to_owned()),
        Kind::Named | Kind::Table(_) | Kind::Kinds(_) => ("{ ", " }".to_owned()),
        Kind::Count(_) => ("", String::new()),
        _ => ("\"", "\"".to_owned()),
    };
    let text = format!("{} = {open}{close}", key.name);
    let caret = text.len() - close.len();
    (text, caret)
}

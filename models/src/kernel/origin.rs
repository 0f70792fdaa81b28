//! Where a scene gives its quantities.

use std::ops::Range;
use std::sync::{Arc, OnceLock};

use crate::kernel::schema::{GivenNumber, Key, Value, Values};
use crate::kernel::symbol::Symbol;
use crate::kernel::text::Text;

/// Where the scene gives a quantity.
#[derive(Clone, Debug, PartialEq)]
pub struct Origin {
    /// Key as the scene has it, such as `luffing.X_1`.
    pub key: String,
    /// Line of the scene, counted from 1.
    pub line: usize,
    /// Bytes of the scene's text.
    pub place: Range<usize>,
    /// In kg, where it is a weight given as a mass.
    pub mass: Option<f64>,
    /// Whether the scene makes an input of it, which starts there.
    pub input: bool,
    /// Whether the scene tells it over time; its value is the first one.
    pub over_time: bool,
    /// Where the scene says that it comes from.
    pub source: Option<Text>,
    /// Half of its last digit, in SI, where a publication has printed it: its source begins with a citation.
    pub rounding: Option<f64>,
}

/// A quantity of a scene.
#[derive(Clone, Debug)]
pub struct Known {
    /// Key, such as `luffing.drive.E_x`, wherever the scene gives its table.
    pub key: String,
    pub symbol: &'static Symbol,
    /// In SI.
    pub value: f64,
    /// `None` where the scene leaves it at what is usual.
    pub given: Option<Origin>,
}

/// A value of a scene as it is written there.
#[derive(Clone, Debug)]
pub struct Written {
    /// Key as the scene has it.
    pub key: String,
    /// Line of the scene, counted from 1.
    pub line: usize,
    pub text: String,
}

/// All quantities of a scene, in the order of the keys, and where they are given; and everything that it says, in the
/// order of its lines. Looked for when the first is asked for: an FMU runs without them.
#[derive(Clone, Debug)]
pub struct Origins {
    text: Arc<str>,
    values: Arc<Values>,
    found: OnceLock<(Vec<Known>, Vec<Written>)>,
}

impl Origins {
    /// Of a scene's text with its values.
    pub fn new(text: Arc<str>, values: Arc<Values>) -> Origins {
        let found = OnceLock::new();
        Origins { text, values, found }
    }

    fn found(&self) -> &(Vec<Known>, Vec<Written>) {
        self.found.get_or_init(|| self.read())
    }

    fn read(&self) -> (Vec<Known>, Vec<Written>) {
        let Origins { text, values, .. } = self;
        let (mut found, lines) = (Vec::new(), Lines::new(text));
        quantities(values, "", "", &mut found);
        let known = found.into_iter().map(|(key, symbol, value, placed)| Known {
            given: placed.map(|(place, number, key)| Origin {
                key,
                line: lines.at(&place),
                rounding: rounding(&text[place.clone()], value, number.source.as_ref()),
                place,
                mass: number.mass,
                input: number.input,
                over_time: number.course.is_some(),
                source: number.source,
            }),
            key,
            symbol,
            value,
        });
        let mut places = Vec::new();
        everything(values, "", &mut places);
        places.sort_by_key(|(_, place)| place.start);
        let written = places.into_iter().map(|(key, place)| Written {
            key,
            line: lines.at(&place),
            text: shortened(&text[place]),
        });
        (known.collect(), written.collect())
    }

    /// What the scene says, in the order of its lines.
    #[must_use]
    pub fn written(&self) -> &[Written] {
        &self.found().1
    }

    /// What the scene says under another key of the table in which it gives a quantity.
    #[must_use]
    pub fn beside(&self, given: &Origin, key: &str) -> Option<&str> {
        let (table, _) = given.key.rsplit_once('.')?;
        let of_table = |written: &&Written| written.key.rsplit_once('.') == Some((table, key));
        self.written()
            .iter()
            .find(of_table)
            .map(|written| written.text.as_str())
    }

    /// Where the scene gives the quantity with a key such as `luffing.X_1`.
    #[must_use]
    pub fn of(&self, key: &str) -> Option<&Origin> {
        self.found().0.iter().find(|known| known.key == key)?.given.as_ref()
    }

    /// A quantity by its key, from the top of the scene or as the scene has it.
    #[must_use]
    pub fn known(&self, key: &str) -> Option<&Known> {
        let own = |known: &&Known| known.given.as_ref().is_some_and(|origin| origin.key == key);
        let known = self.found().0.iter().find(|known| known.key == key);
        known.or_else(|| self.found().0.iter().find(own))
    }

    /// All quantities, in the order of the keys.
    pub fn all(&self) -> impl Iterator<Item = &Known> {
        self.found().0.iter()
    }

    /// The quantities of a table, of each of a list of tables with its number, or the one with this key.
    pub fn within<'a>(&'a self, path: &'a str) -> impl Iterator<Item = (Option<u16>, &'a Known)> {
        self.found().0.iter().filter_map(move |known| {
            let rest = known.key.strip_prefix(path)?;
            let (number, name) = rest.split_once('.').unwrap_or((rest, ""));
            let number = number.strip_prefix('[').and_then(|number| number.strip_suffix(']'));
            let number = number.and_then(|number| number.parse().ok());
            (!name.contains('.') && (number.is_some() || rest.len() <= 1 + name.len())).then_some((number, known))
        })
    }

    /// Whether a weight is given as a mass.
    #[must_use]
    pub fn has_masses(&self) -> bool {
        self.found()
            .0
            .iter()
            .filter_map(|known| known.given.as_ref())
            .any(|origin| origin.mass.is_some())
    }
}

/// A quantity with its place and the key under which the scene gives it.
type Placed = (Range<usize>, GivenNumber, String);

/// Every quantity of a table and of those within it, in the order of the keys: its key from the top of the scene, its
/// symbol, its value in SI, and its place, where it is not the usual one; it comes from what its own note says, or the
/// `source` of its table, or of the one that has a list of such tables. `path` leads to the table, `shown` as the scene writes it.
fn quantities(
    values: &Values,
    path: &str,
    shown: &str,
    found: &mut Vec<(String, &'static Symbol, f64, Option<Placed>)>,
) {
    let joined = |path: &str, key: &Key| match path {
        "" => key.name.to_owned(),
        _ => format!("{path}.{}", key.name),
    };
    for key in values.keys {
        let entry = values.entry(key.name);
        let usual = values.usual(key);
        if entry.is_none() && usual.is_none() {
            continue;
        }
        let path = joined(path, key);
        let mut add =
            |value, placed| found.extend(key.number().map(|(symbol, _)| (path.clone(), symbol, value, placed)));
        let Some((value, place)) = entry else {
            usual.into_iter().for_each(|value| add(value, None));
            continue;
        };
        let shown = joined(shown, key);
        match value {
            Value::Number(number) => {
                let mut number = number.clone();
                number.source = number.source.or_else(|| values.words("source").cloned());
                add(number.value, Some((place.clone(), number, shown)));
            }
            Value::Table(table) => {
                let shown = if table.beside { key.name } else { &shown };
                quantities(table, &path, shown, found);
            }
            Value::Tables(tables) => {
                let from = found.len();
                for (number, table) in (1..).zip(tables) {
                    let number: usize = number;
                    let numbered = |path: &str| format!("{path}[{number}]");
                    quantities(table, &numbered(&path), &numbered(&shown), found);
                }
                let given = found[from..].iter_mut().filter_map(|(.., placed)| placed.as_mut());
                for (_, number, _) in given.filter(|(_, number, _)| number.source.is_none()) {
                    number.source = values.words("source").cloned();
                }
            }
            _ => {}
        }
    }
}

/// Every value of a table and of those within it: its key as the scene has it, and its place.
fn everything(values: &Values, shown: &str, found: &mut Vec<(String, Range<usize>)>) {
    for (name, value, place) in &values.entries {
        let key = match shown {
            "" => (*name).to_owned(),
            _ => format!("{shown}.{name}"),
        };
        match value {
            Value::Table(table) => everything(table, if table.beside { name } else { &key }, found),
            Value::Tables(tables) => {
                let numbered = (1..).zip(tables);
                numbered.for_each(|(number, table): (usize, _)| everything(table, &format!("{key}[{number}]"), found));
            }
            Value::Named(named) => {
                let each = named
                    .iter()
                    .map(|(name, _, place)| (format!("{key}.\"{name}\""), place.clone()));
                found.extend(each);
            }
            _ => found.push((key, place.clone())),
        }
    }
}

/// The first line of what a scene says, and whether more follows.
fn shortened(text: &str) -> String {
    match text.trim_matches('"').trim().split_once('\n') {
        Some((first, _)) => format!("{} …", first.trim_end()),
        None => text.trim_matches('"').to_owned(),
    }
}

/// Half of the last digit of a value (in SI) as the scene writes it; `None` for zero, whose digits say nothing, and for
/// what no publication has printed.
fn rounding(written: &str, value: f64, source: Option<&Text>) -> Option<f64> {
    source?.english().strip_prefix('[')?;
    let number = written.split('"').nth(1)?.trim();
    let end = number.find(|c: char| !(c.is_ascii_digit() || "+-.".contains(c)));
    let number = &number[..end.unwrap_or(number.len())];
    let shown: f64 = number.parse().ok().filter(|shown| *shown != 0.0)?;
    let decimals = number.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let last = (0..decimals).fold(1.0, |last, _| last / 10.0);
    Some(0.5 * last * (value / shown).abs())
}

/// Where lines of a scene's text end.
struct Lines(Vec<usize>);

impl Lines {
    fn new(text: &str) -> Lines {
        Lines(text.match_indices('\n').map(|(at, _)| at).collect())
    }

    /// Line of a place in the scene, counted from 1.
    fn at(&self, place: &Range<usize>) -> usize {
        1 + self.0.partition_point(|end| *end < place.start)
    }
}

/// Line of a place in a scene's text, counted from 1.
#[must_use]
pub fn line(text: &str, place: &Range<usize>) -> usize {
    Lines::new(text).at(place)
}

impl Values {
    /// The quantity of a symbol, from this table or one within it, in SI.
    #[must_use]
    pub fn of(&self, symbol: &'static Symbol) -> Option<f64> {
        self.holder(symbol)?.number(symbol.id)
    }

    /// This table, or the one within it that has a symbol's quantity.
    pub(crate) fn holder(&self, symbol: &'static Symbol) -> Option<&Values> {
        let own = |key: &Key| key.number().is_some_and(|(known, _)| known == symbol);
        if self.keys.iter().any(own) {
            return Some(self);
        }
        let mut within = self.entries.iter().filter_map(|(_, value, _)| match value {
            Value::Table(table) => table.holder(symbol),
            _ => None,
        });
        within.find(|table| table.number(symbol.id).is_some())
    }
}

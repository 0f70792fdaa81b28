//! What a scene may say, as data, for reading, checking and the JSON Schema of editors; and what it says, checked.

use std::ops::Range;

use crate::kernel::course::Course;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::sign::Sign;
use crate::kernel::symbol::Symbol;
use crate::kernel::text::Text;

/// A key of a scene.
#[derive(Clone, Copy, Debug)]
pub struct Key {
    pub name: &'static str,
    pub kind: Kind,
    pub required: bool,
    /// Of a quantity that a scene leaves out, in SI; and the key of the same table without which it says nothing, if any.
    pub usual: Option<f64>,
    pub only_with: Option<&'static str>,
    /// Whether a scene may make an input of it.
    pub input: bool,
    /// How a scene may tell it over time, if it may: names of what it does from one time to the next.
    pub between: &'static [&'static str],
    pub text: &'static str,
}

/// Where the quantities of a table come from that do not say it themselves.
pub const SOURCE: Key = Key::text(
    "source",
    "Where the quantities of this table come from: a drawing, a publication, an assumption.",
);

/// Key that says of which kind a table is.
pub const KIND: &str = "kind";

/// The greatest whole number of a scene.
pub const COUNTLESS: u64 = i64::MAX.cast_unsigned();

/// What stands behind a key.
#[derive(Clone, Copy, Debug)]
pub enum Kind {
    /// A text, or a table of it in several languages.
    Text,
    /// A text of one line, not empty, or a table of it in several languages.
    Line,
    /// A text that is the same in every language.
    Name,
    /// A date in any form; one that looks like `YYYY-MM-DD` exists.
    Date,
    /// A text of several lines, each with its place.
    Lines,
    Choice(&'static [&'static str]),
    /// A number with a unit, as text: `"19.3 m"`; or with a note where it comes
    /// from: `{ value = "19.3 m", source = "drawing 12-345" }`.
    Quantity(&'static Symbol, Sign),
    /// A weight, greater than zero or that too, or the mass that weighs it: `"160 kN"`, `"16 t"`.
    Weight(&'static Symbol, Sign),
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
    /// A whole number, the least and the greatest.
    Count([u64; 2]),
    /// A table of quantities by the names of variables: `{ "A.x" = "1 mm" }`.
    Named,
}

impl Key {
    /// A key that is needed.
    #[must_use]
    pub const fn new(name: &'static str, kind: Kind, text: &'static str) -> Key {
        Key {
            name,
            kind,
            required: true,
            usual: None,
            only_with: None,
            input: false,
            between: &[],
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
        Key::quantity(symbol, Sign::NotNegative).or_mass()
    }

    /// As a weight, which may be given as a mass.
    #[must_use]
    pub const fn or_mass(mut self) -> Key {
        if let Kind::Quantity(symbol, sign) = self.kind {
            let sign = if matches!(sign, Sign::Positive) {
                sign
            } else {
                Sign::NotNegative
            };
            self.kind = Kind::Weight(symbol, sign);
        }
        self
    }

    /// What a scene may leave open: `{ input = "20 m" }` is an input that starts there.
    #[must_use]
    pub const fn or_input(mut self) -> Key {
        self.input = true;
        self
    }

    /// What a scene may tell over time: in steps, or straight from one value to the next.
    #[must_use]
    pub const fn over_time(mut self) -> Key {
        self.between = &["linear", "steps"];
        self
    }

    /// What a scene may tell over time in steps alone.
    #[must_use]
    pub const fn in_steps(mut self) -> Key {
        self.between = &["steps"];
        self
    }

    /// A relative tolerance.
    #[must_use]
    pub const fn tolerance(mut self) -> Key {
        if let Kind::Quantity(symbol, _) = self.kind {
            self.kind = Kind::Quantity(symbol, Sign::Tolerance);
        }
        self
    }

    /// The quantity that stands behind the key, and which numbers it may have; `None` where it is something else.
    #[must_use]
    pub fn number(&self) -> Option<(&'static Symbol, Sign)> {
        match self.kind {
            Kind::Quantity(symbol, sign) | Kind::Weight(symbol, sign) => Some((symbol, sign)),
            _ => None,
        }
    }

    #[must_use]
    pub const fn table(name: &'static str, keys: &'static [Key], text: &'static str) -> Key {
        Key::new(name, Kind::Table(keys), text)
    }

    /// A table that may be left out.
    #[must_use]
    pub const fn part(name: &'static str, keys: &'static [Key], text: &'static str) -> Key {
        Key::table(name, keys, text).optional()
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

    /// A quantity that may be left out: what it usually is, in SI.
    #[must_use]
    pub const fn usually(mut self, value: f64) -> Key {
        self.usual = Some(value);
        self.optional()
    }

    /// What it usually is counts where another key of its table stands.
    #[must_use]
    pub const fn only_with(mut self, key: &'static str) -> Key {
        self.only_with = Some(key);
        self
    }
}

/// A checked part of a scene.
#[derive(Clone, Debug)]
pub enum Value {
    Text(Text),
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
    /// Whether it is where an input starts.
    pub input: bool,
    /// What it is over time, where the scene tells that; its value is the first one.
    pub course: Option<Course>,
    /// Where the scene says that it comes from.
    pub source: Option<Text>,
}

/// A checked table: every value with its place.
#[derive(Clone, Debug, Default)]
pub struct Values {
    /// In the order of their names.
    pub(super) entries: Vec<(&'static str, Value, Range<usize>)>,
    /// Keys that are there with a value that is none of theirs.
    pub(super) unsound: Vec<&'static str>,
    /// Against which it was checked.
    pub(super) keys: &'static [Key],
    /// Place of the table itself.
    pub span: Range<usize>,
    /// Whether it stands at the top of the scene, beside the table that it belongs to.
    pub(super) beside: bool,
}

/// What scenes ask for hundreds of times is not inlined.
impl Values {
    pub(super) fn entry(&self, name: &str) -> Option<(&Value, &Range<usize>)> {
        let at = self.entries.partition_point(|(known, ..)| *known < name);
        let (_, value, place) = self.entries.get(at).filter(|(known, ..)| *known == name)?;
        Some((value, place))
    }

    /// In SI; what is usual, or `None`, where the scene does not give it.
    #[must_use]
    #[inline(never)]
    pub fn number(&self, name: &str) -> Option<f64> {
        match self.entry(name) {
            Some((Value::Number(number), _)) => Some(number.value),
            Some(_) => None,
            None => self.usual(self.keys.iter().find(|key| key.name == name)?),
        }
    }

    /// What is usual of a key, where it says anything.
    pub(super) fn usual(&self, key: &Key) -> Option<f64> {
        key.usual
            .filter(|_| key.only_with.is_none_or(|other| self.entry(other).is_some()))
    }

    /// Whether the scene makes an input of a quantity.
    #[must_use]
    pub fn is_input(&self, name: &str) -> bool {
        matches!(self.entry(name), Some((Value::Number(number), _)) if number.input)
    }

    /// What the scene tells of a quantity over time.
    #[must_use]
    pub fn course(&self, name: &str) -> Option<&Course> {
        match self.entry(name) {
            Some((Value::Number(number), _)) => number.course.as_ref(),
            _ => None,
        }
    }

    /// As [`number`](Values::number); of a quantity that is told over time the greatest by amount.
    #[must_use]
    pub fn greatest(&self, name: &str) -> Option<f64> {
        self.course(name).map(Course::greatest).or_else(|| self.number(name))
    }

    /// All that is told over time in this table and in those within it.
    #[must_use]
    pub fn courses(&self) -> Vec<(&'static Symbol, Course)> {
        let of = |key: &Key| match self.entry(key.name) {
            Some((Value::Table(table), _)) => table.courses(),
            _ => (key.number().zip(self.course(key.name)))
                .map(|((symbol, _), course)| (symbol, course.clone()))
                .into_iter()
                .collect(),
        };
        self.keys.iter().flat_map(of).collect()
    }

    /// In English, where the scene gives it in several languages.
    #[must_use]
    pub fn text(&self, name: &str) -> Option<&str> {
        self.words(name).map(Text::english)
    }

    /// In every language that the scene gives it in.
    #[must_use]
    #[inline(never)]
    pub fn words(&self, name: &str) -> Option<&Text> {
        match self.entry(name) {
            Some((Value::Text(text), _)) => Some(text),
            _ => None,
        }
    }

    #[must_use]
    #[inline(never)]
    pub fn table(&self, name: &str) -> Option<&Values> {
        match self.entry(name) {
            Some((Value::Table(table), _)) => Some(table),
            _ => None,
        }
    }

    /// What is read of a table, if the scene has it; `None` where something in it cannot be read.
    pub fn part<T>(&self, name: &str, read: impl FnOnce(&Values) -> Option<T>) -> Option<Option<T>> {
        match self.table(name) {
            Some(table) => read(table).map(Some),
            None => Some(None),
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

    /// The quantities that the scene gives in this table, in the order of the keys.
    #[must_use]
    pub fn own(&self) -> Vec<(&'static Symbol, f64)> {
        let number = |key: &Key| Some((key.number()?.0, self.number(key.name)?));
        self.keys.iter().filter_map(number).collect()
    }

    /// Whether the scene gives a sound value for a key.
    #[must_use]
    pub fn has(&self, name: &str) -> bool {
        self.entry(name).is_some()
    }

    /// Whether the scene gives a key at all, be its value sound or not: it is not missing then.
    #[must_use]
    pub fn stands(&self, name: &str) -> bool {
        self.has(name) || self.unsound.contains(&name)
    }

    /// Whether every value that the scene gives in this table itself is sound.
    #[must_use]
    pub fn is_sound(&self) -> bool {
        self.unsound.is_empty()
    }

    /// Place of a key's value; of the table where the key is absent.
    #[must_use]
    #[inline(never)]
    pub fn place(&self, name: &str) -> Range<usize> {
        self.entry(name)
            .map_or_else(|| self.span.clone(), |(_, span)| span.clone())
    }

    /// What is wrong with a key's value, with its place.
    #[must_use]
    #[cold]
    pub fn refuse(
        &self,
        key: &str,
        what: impl Into<String>,
        label: impl Into<String>,
        help: impl Into<String>,
    ) -> Diagnostic {
        Diagnostic::new(self.place(key), what, label).help(help)
    }

    /// Refuses a count, where it is given, that is no whole number.
    #[must_use]
    pub fn broken(&self, symbol: &'static Symbol) -> Option<Diagnostic> {
        let count = self.of(symbol).filter(|count| count.fract() != 0.0)?;
        let (least, above) = (symbol.range.least, f64::from(u8::from(symbol.range.open)));
        let help = format!("give a whole number, from {} on", (least.max(0.0) + above).ceil());
        let what = format!("{} = {}", symbol.id, symbol.written(count));
        Some(self.refuse(symbol.id, what, "no whole number", help))
    }
}

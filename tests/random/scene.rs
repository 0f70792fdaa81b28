//! Random scenes, made from the keys of the schema. A mechanism adds only what makes its scenes legal, and the edges
//! that only it has.

use std::f64::consts::PI;

use fastrand::Rng;
use lemnis_models::kernel::schema::{KIND, Key, Kind};
use lemnis_models::kernel::sign::Sign;
use lemnis_models::kernel::symbol::{Range, Symbol};
use lemnis_models::kernel::unit::{self, RAD};
use lemnis_models::kernel::variable::{TIME, Type, Variable};
use lemnis_models::registry::{self, MECHANISMS};
use lemnis_models::scene::KEYS;
use toml::{Table, Value};

use crate::{
    afloat, bridge, column, curved_trunk, ellipsograph, hopper, hung, luffing, mobile, portal, ring, rope, slewing,
    steering, unloader,
};

/// What a mechanism adds: a legal table, one that lies on an edge, and a result that every level has.
struct Maker {
    legal: fn(&mut Draw, &'static [Key]) -> Table,
    edge: fn(&mut Node),
    result: (&'static str, &'static Symbol),
}

/// Of a mechanism that has none yet, scenes are nearly legal.
fn maker(mechanism: &str) -> Option<Maker> {
    match mechanism {
        "double_link" => Some(Maker {
            legal: luffing::legal,
            edge: luffing::edge,
            result: luffing::RESULT,
        }),
        "rope" | "rope_compensation" => Some(Maker {
            legal: rope::legal,
            edge: rope::edge,
            result: rope::RESULT,
        }),
        "ellipsograph" => Some(Maker {
            legal: ellipsograph::legal,
            edge: ellipsograph::edge,
            result: ellipsograph::RESULT,
        }),
        "curved_trunk" => Some(Maker {
            legal: curved_trunk::legal,
            edge: curved_trunk::edge,
            result: curved_trunk::RESULT,
        }),
        "groups" => Some(Maker {
            legal: steering::legal,
            edge: steering::edge,
            result: steering::RESULT,
        }),
        "platform" => Some(Maker {
            legal: slewing::legal,
            edge: slewing::edge,
            result: slewing::RESULT,
        }),
        "mobile" => Some(Maker {
            legal: mobile::legal,
            edge: mobile::edge,
            result: mobile::RESULT,
        }),
        "portal" => Some(Maker {
            legal: portal::legal,
            edge: portal::edge,
            result: portal::RESULT,
        }),
        "ring" => Some(Maker {
            legal: ring::legal,
            edge: ring::edge,
            result: ring::RESULT,
        }),
        "column" => Some(Maker {
            legal: column::legal,
            edge: column::edge,
            result: column::RESULT,
        }),
        "hopper" => Some(Maker {
            legal: hopper::legal,
            edge: hopper::edge,
            result: hopper::RESULT,
        }),
        "grab_unloader" => Some(Maker {
            legal: unloader::legal,
            edge: unloader::edge,
            result: unloader::RESULT,
        }),
        "trolley" => Some(Maker {
            legal: bridge::legal,
            edge: bridge::edge,
            result: bridge::RESULT,
        }),
        "hull" => Some(Maker {
            legal: afloat::legal,
            edge: afloat::edge,
            result: afloat::RESULT,
        }),
        _ => None,
    }
}

/// A random scene.
#[derive(Clone, Debug)]
pub struct Case {
    pub table: Table,
    /// It must be taken; another one may be refused.
    pub legal: bool,
    /// Length (m), mass (kg) and time (s) of the machine.
    pub scale: [f64; 3],
}

impl Case {
    /// The scene with this number of the series of a seed.
    pub fn new(seed: u64, number: u64) -> Case {
        let mut draw = Draw::new(seed ^ number.wrapping_mul(0x9E37_79B9_7F4A_7C15));
        let entry = &MECHANISMS[draw.rng.usize(..MECHANISMS.len())];
        let (mechanism, keys) = (entry.table, entry.keys);
        let maker = maker(entry.kind);
        let legal = draw.coin(0.5) && maker.is_some();
        let mut made = match &maker {
            Some(maker) => (maker.legal)(&mut draw, keys),
            None => draw.table(keys),
        };
        let stands =
            mechanism == "slewing" && !matches!(made.get("fidelity").and_then(Value::as_str), Some("rigid" | "swing"));
        if draw.coin(0.2) && !stands {
            let oil = matches!(made.get("fidelity").and_then(Value::as_str), Some("hydraulic" | "auto"));
            draw.tell_over_time(keys, &mut made, oil);
        }
        let alone = MECHANISMS.iter().filter(|other| other.table == mechanism).count() == 1;
        let names = |key: &Key| key.name == KIND && matches!(key.kind, Kind::Choice(of) if of.contains(&entry.kind));
        if !alone || keys.iter().any(names) && draw.coin(0.5) {
            made.insert(KIND.to_owned(), entry.kind.into());
        }
        hung::hung(mechanism, &mut made, draw.g);
        // What slews beside a support has results of its own.
        let slews = mechanism == "supports" && made.contains_key("slewing");
        let result = |maker: &Maker| if slews { slewing::RESULT } else { maker.result };
        let mut table = draw.around(mechanism, made, maker.as_ref().map(result));
        if !legal {
            let edge = draw.coin(0.5);
            let mut top = Node::new(&mut draw, KEYS, &mut table);
            if let (Some(maker), true, Some(mut inner)) = (&maker, edge, top.child(mechanism)) {
                (maker.edge)(&mut inner);
            }
            if !edge || draw.coin(0.3) {
                for _ in 0..draw.rng.u32(1..=3) {
                    match table.get_mut(mechanism).and_then(Value::as_table_mut) {
                        Some(inner) if draw.coin(0.85) => draw.spoil(keys, inner),
                        _ => draw.spoil(KEYS, &mut table),
                    }
                }
            }
        }
        Case {
            table,
            legal,
            scale: draw.scale,
        }
    }

    pub fn text(&self) -> String {
        toml::to_string(&self.table).expect("a table")
    }
}

/// Random numbers of the size of one machine.
pub struct Draw {
    pub rng: Rng,
    /// Length (m), mass (kg) and time (s): together the size of a quantity of any dimension.
    pub scale: [f64; 3],
    /// Acceleration of gravity, in m/s².
    pub g: f64,
}

impl Draw {
    /// Numbers of a size.
    pub fn of(seed: u64, scale: [f64; 3]) -> Draw {
        Draw {
            rng: Rng::with_seed(seed),
            scale,
            g: 9.81,
        }
    }

    fn new(seed: u64) -> Draw {
        let mut draw = Draw::of(seed, [1.0; 3]);
        if draw.coin(0.2) {
            draw.g = (draw.between(1.0, 30.0) * 100.0).round() / 100.0;
        }
        let length = draw.decades(-2, 5);
        // Inertias within their limit, and much greater ones than single parts have.
        let mass = draw.decades(-1, 8).min(1e15 / (length * length));
        draw.size(length, mass);
        draw
    }

    /// Sets the machine's length (m) and mass (kg); its time is that of a pendulum so long.
    pub fn size(&mut self, length: f64, mass: f64) {
        self.scale = [length, mass, (length / self.g).sqrt()];
    }

    pub fn coin(&mut self, chance: f64) -> bool {
        self.rng.f64() < chance
    }

    pub fn pick<T: Copy>(&mut self, of: &[T]) -> T {
        of[self.rng.usize(0..of.len())]
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.rng.f64()
    }

    /// From ten to the power of `low` to that of `high`, every decade as often as another.
    pub fn decades(&mut self, low: i32, high: i32) -> f64 {
        10_f64.powi(self.rng.i32(low..high)) * self.between(1.0, 10.0)
    }

    pub fn angle(&mut self) -> f64 {
        self.between(-PI, PI)
    }

    /// The size of a quantity of this machine, in SI.
    pub fn natural(&self, symbol: &Symbol) -> f64 {
        let dimension = symbol.unit.dimension;
        let powers = [dimension.m, dimension.kg, dimension.s];
        let parts = self
            .scale
            .iter()
            .zip(powers)
            .map(|(scale, power)| scale.powi(power.into()));
        parts.product()
    }

    /// A value that the sign allows, in SI: of this machine's size, with zeros.
    fn value(&mut self, symbol: &Symbol, sign: Sign) -> f64 {
        if sign == Sign::Tolerance {
            return self.decades(-8, -1);
        }
        let [least, most] = symbol.unit.limits();
        // Results are compared with numbers that they cannot have.
        let range = match sign {
            Sign::AtMost | Sign::AtLeast | Sign::Result => Range::ANY,
            _ => symbol.range,
        };
        if sign.allows(0.0) && self.coin(0.15) {
            return 0.0;
        }
        let amount = match symbol.unit {
            unit if *unit == RAD => self.between(0.0, PI),
            _ => self.natural(symbol) * self.decades(-1, 1),
        }
        .clamp(least, most);
        let value = if sign.allows(-1.0) && self.coin(0.5) {
            -amount
        } else {
            amount
        };
        value.clamp(range.least, range.most)
    }

    /// A value (SI) as a scene has it, and the value that is read from there.
    pub fn written(&mut self, symbol: &Symbol, value: f64) -> (String, f64) {
        let fits = |unit: &&&unit::Unit| unit.is_like(symbol.unit);
        let units: Vec<&unit::Unit> = unit::ALL.iter().filter(fits).copied().collect();
        let unit = if self.coin(0.8) {
            symbol.display
        } else {
            self.pick(&units)
        };
        let digits = format!("{:.5e}", value / unit.factor);
        // Zero has no sign.
        let number: f64 = digits.parse::<f64>().expect("a number") + 0.0;
        // People write plain numbers where these are short.
        let plain = number == 0.0 || (1e-6..1e9).contains(&number.abs());
        let text = if plain { number.to_string() } else { digits };
        let name = if *unit == unit::ONE { "" } else { unit.name };
        (format!("{text} {name}").trim_end().to_owned(), number * unit.factor)
    }

    /// A value of an input between its least and greatest one, these and zero often among them.
    pub fn input(&mut self, variable: &Variable) -> f64 {
        if let Type::Enumeration(of) = variable.kind {
            return (1 + self.rng.usize(0..of.items.len())) as f64;
        }
        let [least, most] = variable.bounds;
        let beyond = if self.coin(0.02) { 1e3 } else { 1.0 };
        let any = self.natural(variable.symbol) * self.decades(-3, 0) * self.pick(&[beyond, -beyond]);
        let inner = if least.is_finite() && most.is_finite() {
            self.between(least, most)
        } else {
            any
        };
        let ends = [least, most, 0.0].map(|end| if end.is_finite() { end } else { any });
        let value = if self.coin(0.8) { inner } else { self.pick(&ends) };
        value.clamp(least, most)
    }

    fn words(&mut self) -> &'static str {
        self.pick(&[
            "x",
            "drawing 12-345",
            "$x_1$ *b* _i_ #read(\"/etc/passwd\") <l> @r `c` // /* \\",
            "起重机",
            "Кран 16 т × 30 м",
            "{{ 7 }} <% if %> %s %n & < > \" '",
        ])
    }

    /// What may stand behind a key.
    fn fresh(&mut self, key: &'static Key) -> Value {
        let one = |draw: &mut Draw, symbol, sign| {
            let value = draw.value(symbol, sign);
            draw.written(symbol, value)
        };
        if let Some((symbol, sign)) = key.number() {
            let mut text = one(self, symbol, sign).0;
            if matches!(key.kind, Kind::Weight(..)) && self.coin(0.3) {
                text = format!("{:.3e} kg", self.natural(symbol) / self.g);
            }
            if self.coin(0.9) {
                return text.into();
            }
            let value = if key.input && self.coin(0.5) { "input" } else { "value" };
            let noted = [(value, text), ("source", self.words().to_owned())];
            return Table::from_iter(noted.map(|(name, text)| (name.to_owned(), text.into()))).into();
        }
        match key.kind {
            Kind::Text | Kind::Line => match self.words() {
                // In two languages, neither of which is the default.
                text @ "起重机" => Table::from_iter(["bg", "zh"].map(|code| (code.to_owned(), text.into()))).into(),
                text => text.into(),
            },
            Kind::Name | Kind::Lines => self.words().into(),
            Kind::Date => "2026-02-28".into(),
            Kind::Choice(choices) => self.pick(choices).into(),
            Kind::Table(keys) => self.table(keys).into(),
            Kind::Kinds(kinds) => self.table(kinds[0].1).into(),
            Kind::Texts(_) => Value::Array(Vec::new()),
            Kind::Choices(choices) => {
                let chosen: Vec<&str> = choices.iter().copied().filter(|_| self.coin(0.3)).collect();
                chosen.into()
            }
            Kind::Tables(keys, _) => {
                let tables = (0..self.rng.u32(0..3)).map(|_| self.table(keys).into());
                Value::Array(tables.collect())
            }
            Kind::Quantities(symbol, sign, [least, most]) => {
                let count = self.rng.usize(least..=most);
                let mut list: Vec<(String, f64)> = (0..count).map(|_| one(self, symbol, sign)).collect();
                list.sort_by(|a, b| a.1.total_cmp(&b.1));
                Value::Array(list.into_iter().map(|(text, _)| text.into()).collect())
            }
            Kind::Count([least, most]) => {
                let count = self.rng.u64(least..=most.min(u16::MAX.into()));
                i64::try_from(count).expect("small").into()
            }
            Kind::Quantity(..) | Kind::Weight(..) | Kind::Named => Value::Table(Table::new()),
        }
    }

    /// Tells over time what may be told so, no greater than it is; in steps where it must be so, beside oil.
    fn tell_over_time(&mut self, keys: &'static [Key], made: &mut Table, steps: bool) {
        for key in keys {
            if let (Kind::Table(keys), Some(Value::Table(inner))) = (key.kind, made.get_mut(key.name)) {
                self.tell_over_time(keys, inner, steps);
            }
            let text = made.get(key.name).and_then(Value::as_str);
            let value = text.and_then(|text| read(text, self.g));
            let (Some((symbol, _)), Some(value), false) = (key.number(), value, key.between.is_empty()) else {
                continue;
            };
            let end = self.scale[2] * self.between(0.2, 1.0);
            let mut rows = Vec::new();
            for (part, much) in [(0.0, 1.0), (0.3, 0.5), (0.7, 1.0), (1.0, 0.8)] {
                let row = [(&TIME, part * end), (symbol, much * value)];
                rows.push(Value::from(
                    row.map(|(symbol, value)| self.written(symbol, value).0).to_vec(),
                ));
            }
            let between = if steps { "steps" } else { self.pick(key.between) };
            let told = [("over", Value::from(rows)), ("between", between.into())];
            let told = Table::from_iter(told.map(|(name, value)| (name.to_owned(), value)));
            made.insert(key.name.to_owned(), told.into());
        }
    }

    /// A table with all that its keys require, and half of what they allow.
    pub fn table(&mut self, keys: &'static [Key]) -> Table {
        let mut table = Table::new();
        for key in keys {
            // An optional kind says which mechanism it is.
            if key.required || key.name != KIND && self.coin(0.5) {
                table.insert(key.name.to_owned(), self.fresh(key));
            }
        }
        table
    }

    /// The scene around a mechanism's table, with an accuracy of one of its results.
    fn around(&mut self, mechanism: &str, mut made: Table, result: Option<(&str, &Symbol)>) -> Table {
        let others: Vec<&Key> = KEYS
            .iter()
            .filter(|key| registry::tables().all(|table| table != key.name))
            .filter(|key| registry::PARTS.iter().all(|part| part.name != key.name))
            .collect();
        let mut table = Table::new();
        for key in others {
            if key.required || self.coin(0.3) {
                table.insert(key.name.to_owned(), self.fresh(key));
            }
        }
        table.insert("name".to_owned(), "Random".into());
        // Parts stand within the mechanism or beside it.
        for part in &registry::PARTS {
            if let Some(part_of) = made.get(part.name).cloned()
                && self.coin(0.3)
            {
                made.remove(part.name);
                table.insert(part.name.to_owned(), part_of);
            }
        }
        table.insert(mechanism.to_owned(), made.into());
        let mut top = Node::new(self, KEYS, &mut table);
        top.keep("g", false);
        if top.draw.g != 9.81 {
            top.set("g", top.draw.g);
        }
        let dated = top.child("project").is_some_and(|project| project.has("date"));
        if let Some(mut book) = top.child("book") {
            if !dated {
                book.remove(&["pdf_standard"]);
            }
            let chosen: Vec<&str> = ["from", "middle", "to", "governing"]
                .into_iter()
                .filter(|_| book.draw.coin(0.3))
                .collect();
            book.put("positions", chosen);
            // Many runs each.
            let chapters = book.table.get("chapters").and_then(Value::as_array);
            let quick =
                |chapter: &&Value| !matches!(chapter.as_str(), Some("trade" | "synthesis" | "study" | "results"));
            let others = chapters.into_iter().flatten().filter(quick).cloned();
            let chapters: Vec<Value> = std::iter::once("results".into()).chain(others).collect();
            book.put("chapters", chapters);
        }
        let auto = top
            .child(mechanism)
            .is_some_and(|inner| inner.text("fidelity") == Some("auto"));
        // Searches and studies name quantities and results that this mechanism has: their own tests have some.
        top.remove(&["accuracy", "synthesis", "study"]);
        if let Some((name, symbol)) = result
            && (auto || top.draw.coin(0.2))
        {
            let value = top.draw.natural(symbol) * top.draw.decades(-6, 1);
            let text = top.draw.written(symbol, value).0;
            top.put("accuracy", Table::from_iter([(name.to_owned(), text.into())]));
        }
        table
    }

    /// Spoils one key of a table or of those in it: it is gone, zero, of another size or sign, or one more.
    fn spoil(&mut self, keys: &'static [Key], table: &mut Table) {
        let present: Vec<&'static Key> = keys.iter().filter(|key| table.contains_key(key.name)).collect();
        let key = if !present.is_empty() && self.coin(0.85) {
            self.pick(&present)
        } else {
            let all: Vec<&'static Key> = keys.iter().collect();
            self.pick(&all)
        };
        let deeper = self.coin(0.95);
        let value = match (&key.kind, table.get_mut(key.name)) {
            (Kind::Table(keys), Some(Value::Table(inner))) if deeper => return self.spoil(keys, inner),
            (Kind::Tables(keys, _), Some(Value::Array(list))) if deeper && !list.is_empty() => {
                let at = self.rng.usize(0..list.len());
                match list[at].as_table_mut() {
                    Some(inner) => return self.spoil(keys, inner),
                    None => None,
                }
            }
            (Kind::Quantity(symbol, _) | Kind::Weight(symbol, _), Some(Value::String(text))) => {
                let value = read(text, self.g).unwrap_or(1.0);
                let other = match self.rng.u8(0..10) {
                    0 => None,
                    1 | 2 => Some(0.0),
                    3 => Some(-value),
                    4 | 5 => Some(value * (1.0 + self.pick(&[1.0, -1.0]) * self.decades(-12, -1))),
                    6 | 7 => Some(value * self.decades(-9, 0)),
                    _ => Some(value * self.decades(0, 9)),
                };
                other.map(|value| self.written(symbol, value).0.into())
            }
            (_, Some(_)) if self.coin(0.3) => None,
            _ => Some(self.fresh(key)),
        };
        match value {
            Some(value) => table.insert(key.name.to_owned(), value),
            None => table.remove(key.name),
        };
    }
}

fn key(keys: &'static [Key], name: &str) -> &'static Key {
    let found = keys.iter().find(|key| key.name == name);
    found.unwrap_or_else(|| panic!("no key {name}"))
}

/// The keys of a table, of its kind where there are several.
fn tables(key: &'static Key, kind: Option<&str>) -> &'static [Key] {
    match key.kind {
        Kind::Table(keys) => keys,
        Kind::Kinds(kinds) => {
            let named = kinds.iter().find(|(name, _)| Some(*name) == kind);
            named.unwrap_or(&kinds[0]).1
        }
        _ => panic!("{} is no table", key.name),
    }
}

/// A quantity of a scene, in SI; a mass as its weight.
fn read(text: &str, g: f64) -> Option<f64> {
    let (number, name) = text.split_once(' ').unwrap_or((text, "1"));
    let unit = unit::find(name)?;
    let weight = if unit.is_like(&unit::KG) { g } else { 1.0 };
    Some(number.parse::<f64>().ok()? * unit.factor * weight)
}

/// A table with its keys.
pub struct Node<'a> {
    pub draw: &'a mut Draw,
    keys: &'static [Key],
    pub table: &'a mut Table,
}

impl Node<'_> {
    pub fn new<'a>(draw: &'a mut Draw, keys: &'static [Key], table: &'a mut Table) -> Node<'a> {
        Node { draw, keys, table }
    }

    /// Whether there is such a key.
    pub fn knows(&self, name: &str) -> bool {
        self.keys.iter().any(|key| key.name == name)
    }

    pub fn has(&self, name: &str) -> bool {
        self.table.contains_key(name)
    }

    pub fn text(&self, name: &str) -> Option<&str> {
        self.table.get(name)?.as_str()
    }

    /// A quantity or the start of an input, in SI; zero where it is not given.
    pub fn get(&self, name: &str) -> f64 {
        let value = self.table.get(name);
        let noted = value
            .and_then(Value::as_table)
            .and_then(|table| table.get("value").or(table.get("input")));
        let text = noted.or(value).and_then(Value::as_str);
        text.and_then(|text| read(text, self.draw.g)).unwrap_or(0.0)
    }

    /// Sets a quantity (SI), and returns it as a scene has it.
    pub fn set(&mut self, name: &str, value: f64) -> f64 {
        let (symbol, _) = key(self.keys, name).number().expect("a quantity");
        let (text, value) = self.draw.written(symbol, value);
        self.table.insert(name.to_owned(), text.into());
        value
    }

    pub fn put(&mut self, name: &str, value: impl Into<Value>) {
        self.table.insert(name.to_owned(), value.into());
    }

    pub fn remove(&mut self, names: &[&str]) {
        for name in names {
            self.table.remove(*name);
        }
    }

    /// A key that is there, or is not.
    pub fn keep(&mut self, name: &str, wanted: bool) {
        if !wanted {
            self.table.remove(name);
        } else if !self.has(name) {
            let value = self.draw.fresh(key(self.keys, name));
            self.table.insert(name.to_owned(), value);
        }
    }

    /// One more table of a list.
    pub fn more(&mut self, name: &str, make: impl FnOnce(&mut Node)) {
        let Kind::Tables(keys, _) = key(self.keys, name).kind else {
            panic!("{name} is no list of tables")
        };
        let mut table = self.draw.table(keys);
        make(&mut Node::new(self.draw, keys, &mut table));
        let list = self.table.entry(name).or_insert_with(|| Value::Array(Vec::new()));
        list.as_array_mut().expect("a list").push(table.into());
    }

    pub fn child(&mut self, name: &str) -> Option<Node<'_>> {
        let table = self.table.get_mut(name)?.as_table_mut()?;
        let keys = tables(key(self.keys, name), table.get(KIND).and_then(Value::as_str));
        Some(Node {
            draw: self.draw,
            keys,
            table,
        })
    }
}

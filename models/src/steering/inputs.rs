//! What the scene gives, in the order of the book.

use crate::component::sheet::Input;
use crate::component::stages::Stages;
use crate::kernel::origin::Origins;
use crate::kernel::schema::{Key, Kind};
use crate::kernel::symbol::Symbol;
use crate::steering::keys::KEYS;
use crate::steering::scene::Steering;
use crate::steering::stages::SteeredGroups;
use crate::steering::symbols as s;

/// Tables of the scene in the order of the book, after the groups.
const TABLES: [&str; 12] = [
    "outline",
    "range",
    "load",
    "tyre",
    "ring",
    "cylinder",
    "accuracy",
    "transition",
    "hydraulics",
    "dynamics",
    "oil",
    "plc",
];

/// Quantities that the scene gives; what is taken by default is no input of the book.
pub fn inputs(origins: &Origins, steering: &Steering) -> Vec<Input> {
    let given = &steering.given;
    let values = values(steering);
    let mut inputs = Vec::new();
    let mut add = |chapter: &'static str, key: &str, symbol: &'static Symbol, number: Option<u16>, value: f64| {
        inputs.push(Input {
            symbol,
            number,
            value,
            chapter,
            given: origins.of(key).cloned(),
        });
    };
    for (number, axis) in (1..).zip(&given.axes) {
        axis.map(&mut |symbol, value| {
            let key = format!("steering.groups[{number}].{}", symbol.id);
            add("groups", &key, symbol, Some(number), value);
        });
    }
    for table in TABLES {
        for (name, symbol) in quantities(table) {
            let key = format!("steering.{table}.{name}");
            let value = values.iter().find(|(known, _)| *known == symbol);
            if let Some((_, value)) = value.filter(|_| origins.of(&key).is_some()) {
                add(table, &key, symbol, None, *value);
            }
        }
        if table == "range" {
            for (number, mount) in (1..).zip(&given.mounts) {
                for [from, to] in &mount.forbidden {
                    add(table, "", &s::BARRED_FROM, Some(number), *from);
                    add(table, "", &s::BARRED_TO, Some(number), *to);
                }
            }
        }
        if table == "load" && steering.weight.is_none() {
            for (number, load) in (1..).zip(&given.loads) {
                add(
                    table,
                    &format!("steering.groups[{number}].G"),
                    &s::G,
                    Some(number),
                    load.g,
                );
            }
        }
    }
    let motion = &steering.motion;
    for (name, symbol, value) in [
        ("from", &s::FROM, motion.from),
        ("to", &s::TO, motion.to),
        ("speed", &s::OMEGA_S, motion.speed),
        ("v_t", &s::V_T, given.v_t.1),
    ] {
        add("motion", &format!("steering.motion.{name}"), symbol, None, value);
    }
    inputs
}

/// The quantities of a table with their names in it.
fn quantities(table: &str) -> impl Iterator<Item = (&'static str, &'static Symbol)> {
    let found = KEYS.iter().find(|key| key.name == table);
    let keys: &'static [Key] = match found.map(|key| &key.kind) {
        Some(Kind::Table(keys)) => keys,
        _ => &[],
    };
    keys.iter().filter_map(|key| Some((key.name, key.number()?.0)))
}

/// All that the scene may give in these tables.
fn values(steering: &Steering) -> Vec<(&'static Symbol, f64)> {
    let given = &steering.given;
    let mut values: Vec<(&'static Symbol, f64)> = Vec::new();
    let mut add = |symbol, value| values.push((symbol, value));
    if let Some([front, rear, left, right]) = given.outline.0 {
        let sides = [
            (&s::E_F, front),
            (&s::E_R, rear),
            (&s::E_LEFT, left),
            (&s::E_RIGHT, right),
        ];
        sides.into_iter().for_each(|(symbol, value)| add(symbol, value));
    }
    if let Some([min, max]) = given.mounts.iter().find_map(|mount| mount.range) {
        add(&s::THETA_MIN, min);
        add(&s::THETA_MAX, max);
    }
    if let Some((weight, centre)) = steering.weight {
        let of_load = [(&s::W, weight), (&s::X_G, centre.x), (&s::Y_G, centre.y)];
        of_load.into_iter().for_each(|(symbol, value)| add(symbol, value));
    }
    if let Some(limit) = steering.slip_limit {
        add(&s::SLIP_LIMIT, limit);
    }
    steering.safety.map(|safety| safety.map(&mut add));
    steering.hydraulics.map(|hydraulics| hydraulics.map(&mut add));
    steering.moving.map(|moving| {
        moving.map(&mut |symbol, value| {
            add(symbol, value);
            value
        })
    });
    SteeredGroups::map(given, &mut |_, (symbol, _), value: f64| {
        add(symbol, value);
        value
    });
    values
}

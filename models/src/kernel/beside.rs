//! What stands beside a mechanism, at the top of a scene, as a part of its table.

use std::ops::Range;

use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::schema::{GivenNumber, KIND, Key, Kind, Value, Values};
use crate::kernel::symbol::Symbol;

impl Values {
    /// Moves a table from the top of the scene to the one that it is a part of.
    ///
    /// # Errors
    /// There is no such part, or it stands there already.
    pub fn adopt(&mut self, part: &'static str, of: &'static str) -> Result<(), Diagnostic> {
        let Some(at) = self.entries.iter().position(|(name, ..)| *name == part) else {
            return Ok(());
        };
        let (_, value, place) = self.entries.remove(at);
        let (Value::Table(mut table), Some((_, Value::Table(whole), _))) =
            (value, self.entries.iter_mut().find(|(name, ..)| *name == of))
        else {
            return Ok(());
        };
        let refused =
            |what: String, label: &str, help: String| Err(Diagnostic::new(place.clone(), what, label).help(help));
        if !whole.keys.iter().any(|key| key.name == part) {
            let known = whole.keys.iter().filter(|key| matches!(key.kind, Kind::Table(_)));
            let known: Vec<&str> = known.map(|key| key.name).collect();
            return refused(
                format!("[{part}] is no part of this [{of}]"),
                "not used",
                format!("remove it; parts here: {}", known.join(", ")),
            );
        }
        if whole.has(part) {
            return refused(
                format!("[{part}] and [{of}.{part}] are one"),
                "given twice",
                "remove one of them".to_owned(),
            );
        }
        let keys = match whole.keys.iter().find(|key| key.name == part).map(|key| key.kind) {
            Some(Kind::Table(keys)) => keys,
            Some(Kind::Kinds(kinds)) => {
                let kind = table.text(KIND).unwrap_or(kinds[0].0);
                let Some((_, keys)) = kinds.iter().find(|(known, _)| *known == kind) else {
                    let known: Vec<&str> = kinds.iter().map(|(known, _)| *known).collect();
                    let help = format!("take one of these: {}", known.join(", "));
                    return refused(
                        format!("{KIND} = \"{kind}\" of [{part}] beside [{of}]"),
                        "not beside it",
                        help,
                    );
                };
                keys
            }
            _ => return Ok(()),
        };
        // What a part needs by itself its mechanism gives.
        if let Some((path, place)) = table.within(keys, part) {
            let message = format!("`{path}` beside [{of}]: that gives it, or has no use for it");
            let refused = Diagnostic::new(place, message, "not used here");
            return Err(refused.help(format!("remove it, or [{of}]")));
        }
        table.beside = true;
        let at = whole.entries.partition_point(|(before, ..)| *before < part);
        whole.entries.insert(at, (part, Value::Table(table), place));
        Ok(())
    }

    /// The same against other keys, with what something else gives: tables, and quantities (SI), inputs or not, each where these
    /// keys have it.
    #[must_use]
    pub fn completed(
        &self,
        keys: &'static [Key],
        tables: &[(&'static str, &Values)],
        quantities: &[(&'static Symbol, f64, bool)],
    ) -> Values {
        let mut all = Values { keys, ..self.clone() };
        for (name, table) in tables {
            all.put(name, Value::Table((*table).clone()));
        }
        for key in keys {
            let own = quantities
                .iter()
                .find(|(symbol, ..)| key.number().is_some_and(|(known, _)| known == *symbol));
            if let Some(&(_, value, input)) = own {
                let number = GivenNumber {
                    value,
                    mass: None,
                    input,
                    course: None,
                    source: None,
                };
                all.put(key.name, Value::Number(number));
            }
            let Kind::Table(within) = key.kind else { continue };
            let table = Values {
                span: self.span.clone(),
                ..Values::default()
            }
            .completed(within, &[], quantities);
            if !table.entries.is_empty() && !all.has(key.name) {
                all.put(key.name, Value::Table(table));
            }
        }
        all
    }

    /// Puts a value to its place in the order of names; it stands nowhere but in the table.
    fn put(&mut self, name: &'static str, value: Value) {
        let at = self.entries.partition_point(|(before, ..)| *before < name);
        self.entries.insert(at, (name, value, self.span.clone()));
    }

    /// Puts other keys in the place of those against which it was checked; the first entry that is none of them, as it would be
    /// written, with its place.
    fn within(&mut self, keys: &'static [Key], path: &str) -> Option<(String, Range<usize>)> {
        self.keys = keys;
        self.entries.iter_mut().find_map(|(name, value, place)| {
            let path = format!("{path}.{name}");
            match (keys.iter().find(|key| key.name == *name).map(|key| key.kind), value) {
                (None, _) => Some((path, place.clone())),
                (Some(Kind::Table(keys)), Value::Table(table)) => table.within(keys, &path),
                _ => None,
            }
        })
    }
}

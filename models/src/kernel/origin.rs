//! Where a scene gives its quantities.

use std::ops::Range;

use crate::kernel::schema::Values;

/// Where the scene gives a quantity.
#[derive(Clone, Debug, PartialEq)]
pub struct Origin {
    /// Key, such as `luffing.X_1`.
    pub key: String,
    /// Line of the scene, counted from 1.
    pub line: usize,
    /// Bytes of the scene's text.
    pub place: Range<usize>,
    /// In kg, where it is a weight given as a mass.
    pub mass: Option<f64>,
    /// Where the scene says that it comes from.
    pub source: Option<String>,
}

/// Where all quantities of a scene are given.
#[derive(Clone, Debug)]
pub struct Origins(Vec<Origin>);

impl Origins {
    /// Of a scene's text with its values.
    pub fn read(text: &str, values: &Values) -> Origins {
        let mut found = Vec::new();
        values.quantities("", &mut found);
        let given = found.into_iter().map(|(key, place, number)| Origin {
            key,
            line: line(text, &place),
            place,
            mass: number.mass,
            source: number.source,
        });
        Origins(given.collect())
    }

    /// Where the quantity with a key such as `luffing.X_1` is given.
    #[must_use]
    pub fn of(&self, key: &str) -> Option<&Origin> {
        self.0.iter().find(|origin| origin.key == key)
    }

    /// Whether a weight is given as a mass.
    #[must_use]
    pub fn has_masses(&self) -> bool {
        self.0.iter().any(|origin| origin.mass.is_some())
    }
}

/// Line of a place in the scene, counted from 1.
#[must_use]
pub fn line(text: &str, place: &Range<usize>) -> usize {
    1 + text[..place.start].matches('\n').count()
}

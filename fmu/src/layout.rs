//! Value references, the same in both standards: 0 is time, then the model's
//! variables, then the FMU's own strings, then (in FMI 3) the vectors.

use lemnis_models::model::{Role, Variable};

/// The FMU's own constants, with what they are.
pub const STRINGS: [(&str, &str); 2] = [
    ("lemnis.version", "Version of Lemnis that the FMU was made with."),
    ("lemnis.scene", "SHA-256 of the scene, as it stands in the book."),
];

/// What a value reference means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    Time,
    /// Index into the model's variables.
    Variable(usize),
    /// Index into [`STRINGS`].
    String(usize),
    /// Index of the first of two components among the model's variables.
    Vector(usize),
}

/// A vector of the plane: its two components are variables of their own as well.
#[derive(Clone, Debug)]
pub struct Vector {
    pub name: &'static str,
    /// Index of the first component among the model's variables.
    pub first: usize,
}

/// The outputs that come in pairs `A.x`, `A.y`.
pub fn vectors(variables: &[Variable]) -> impl Iterator<Item = Vector> {
    variables.windows(2).enumerate().filter_map(|(first, pair)| {
        let name = pair[0].symbol.id.strip_suffix(".x")?;
        let vector = pair.iter().all(|v| v.role == Role::Output && !v.boolean);
        (vector && pair[1].symbol.id.strip_suffix(".y") == Some(name)).then_some(Vector { name, first })
    })
}

/// Value reference of a place; `None` for a vector that does not exist.
#[must_use]
pub fn reference(variables: &[Variable], place: Place) -> Option<u32> {
    let number = match place {
        Place::Time => 0,
        Place::Variable(index) => 1 + index,
        Place::String(index) => 1 + variables.len() + index,
        Place::Vector(first) => {
            let position = vectors(variables).position(|vector| vector.first == first)?;
            1 + variables.len() + STRINGS.len() + position
        }
    };
    u32::try_from(number).ok()
}

/// What a value reference means, if anything. `vectors` are the first components' indices.
#[must_use]
pub fn place(reference: u32, variables: usize, vectors: &[usize]) -> Option<Place> {
    let index = match (reference as usize).checked_sub(1) {
        None => return Some(Place::Time),
        Some(index) if index < variables => return Some(Place::Variable(index)),
        Some(index) => index - variables,
    };
    if index < STRINGS.len() {
        return Some(Place::String(index));
    }
    vectors.get(index - STRINGS.len()).map(|&first| Place::Vector(first))
}

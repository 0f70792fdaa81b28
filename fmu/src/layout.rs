//! Value references, the same in both standards: 0 is time, then the model's
//! variables, then the FMU's own strings, then (in FMI 3) the vectors.

use std::ops::Range;

use lemnis_models::kernel::variable::{Role, Type, Variable};

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
    /// Index into [`vectors`].
    Vector(usize),
}

/// Results that are also one array in FMI 3: the two components of a vector of
/// the plane, or the values of a quantity that there are several of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Vector {
    pub name: &'static str,
    /// Their indices among the model's variables.
    pub components: Range<usize>,
}

/// Outputs that come in pairs `A.x`, `A.y`, or numbered `theta[1]`, `theta[2]`, ...
#[must_use]
pub fn vectors(variables: &[Variable]) -> Vec<Vector> {
    let real = |v: &Variable| v.role == Role::Output && v.kind == Type::Real;
    let vector = |first: usize| {
        let (one, rest) = (&variables[first], &variables[first + 1..]);
        let (name, others) = match one.number {
            Some(1) => (
                one.symbol.id,
                rest.iter().take_while(|v| v.symbol == one.symbol).count(),
            ),
            Some(_) => return None,
            None => {
                let name = one.symbol.id.strip_suffix(".x")?;
                let second = |v: &&Variable| real(v) && v.symbol.id.strip_suffix(".y") == Some(name);
                (name, rest.first().filter(second).map(|_| 1)?)
            }
        };
        Some(Vector {
            name,
            components: first..first + 1 + others,
        })
    };
    (0..variables.len())
        .filter(|&first| real(&variables[first]))
        .filter_map(vector)
        .collect()
}

/// Value reference of a place.
///
/// # Panics
/// A model with 2³² variables or more.
#[must_use]
pub fn reference(variables: usize, place: Place) -> u32 {
    let number = match place {
        Place::Time => 0,
        Place::Variable(index) => 1 + index,
        Place::String(index) => 1 + variables + index,
        Place::Vector(index) => 1 + variables + STRINGS.len() + index,
    };
    u32::try_from(number).expect("a model has few variables")
}

/// What a value reference means, if anything, where there are this many variables and vectors.
#[must_use]
pub fn place(reference: u32, variables: usize, vectors: usize) -> Option<Place> {
    let index = match (reference as usize).checked_sub(1) {
        None => return Some(Place::Time),
        Some(index) if index < variables => return Some(Place::Variable(index)),
        Some(index) => index - variables,
    };
    if index < STRINGS.len() {
        return Some(Place::String(index));
    }
    let index = index - STRINGS.len();
    (index < vectors).then_some(Place::Vector(index))
}

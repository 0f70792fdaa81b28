//! A run of a model under other commands over time, as tables compare them.

use crate::component::description::{Described, Description};
use crate::component::running::Running;
use crate::kernel::course::Course;
use crate::kernel::symbol::Symbol;

/// Instants of each span of time.
pub const INSTANTS: u32 = 400;

/// Results at all instants from the start to some times (s), one span after the other, of what moves as it is told; `None` of a
/// run that does not come to its end.
pub fn ride<T: Described>(
    told: &Description<T>,
    courses: Vec<(&'static Symbol, Course)>,
    followed: &[&'static Symbol],
    ends: &[f64],
) -> Option<Vec<Vec<Vec<f64>>>> {
    let mut other = told.clone();
    other.courses = courses;
    let mut model = other.moving()?.ok()?;
    let place = |symbol: &&'static Symbol| model.variables().iter().position(|known| known.symbol == *symbol);
    let places: Vec<usize> = followed.iter().map(place).collect::<Option<_>>()?;
    model.start().ok()?;
    let mut from = 0.0;
    let mut spans = Vec::new();
    for end in ends {
        let at = |i: u32| from + (end - from) * f64::from(i) / f64::from(INSTANTS);
        let mut span = Vec::new();
        for i in 0..INSTANTS {
            model.advance(at(i), at(i + 1)).ok()?;
            span.push(
                places
                    .iter()
                    .map(|index| model.get(*index).ok())
                    .collect::<Option<_>>()?,
            );
        }
        spans.push(span);
        from = *end;
    }
    Some(spans)
}

/// The greatest amount of the first result in a span.
#[must_use]
pub fn most(span: &[Vec<f64>]) -> f64 {
    let amounts = span.iter().filter_map(|row| row.first());
    amounts.fold(0.0, |most, value| most.max(value.abs()))
}

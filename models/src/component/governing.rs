//! Governing positions: where in the working range each result is greatest.

use crate::component::extreme::Extreme;
use crate::component::outline::{Greatest, Outline};
use crate::component::peaks::Peaks;
use crate::component::probe::slot;
use crate::component::sheet::Summary;
use crate::component::stages::Slot;
use crate::component::standing::Standing;
use crate::kernel::symbol::Symbol;

/// The extremes that exist in a scene.
pub fn extremes<'a>(
    model: &'a Standing,
    outline: &'static Outline,
) -> impl Iterator<Item = (&'static Greatest, Slot)> + 'a {
    let all = outline.extremes.iter();
    all.filter_map(move |extreme| Some((extreme, slot(model, extreme.of)?)))
}

/// Those governing results of a scene that are wanted, with their positions.
#[must_use]
pub fn governing(
    model: &Standing,
    outline: &'static Outline,
    wanted: &dyn Fn(&'static Symbol) -> bool,
) -> Vec<Summary> {
    Peaks::new(model).governing(model, outline, wanted)
}

/// An extreme over the working range, of a numbered result over all of them; `None` where the scene does not have it.
#[must_use]
pub fn most(model: &Standing, extreme: &Greatest) -> Option<Extreme> {
    let mut peaks = Peaks::new(model);
    peaks.look(model, [extreme.of].into_iter());
    peaks.most(model, extreme).map(|found| found.extreme)
}

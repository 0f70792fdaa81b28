//! Independent ways to a drive's torque.

use crate::component::sheet::Check;
use crate::component::standing::Standing;
use crate::component::telling::{fine, sample};
use crate::drive::scene::Driving;
use crate::drive::symbols as s;
use crate::kernel::symbol::Symbol;

/// Of a crank, by lever arms and by the form for a slider: their greatest difference over the working range, relative to the
/// greatest torque.
pub fn by_slider(driving: &Driving, model: &mut Standing, agreement: &'static Symbol) -> Option<Check> {
    driving.crank?;
    let motion = *model.motion();
    let mut both = sample(model, &[&s::T_D, &s::T_CR], fine(&motion));
    both.retain(|row| row[0].is_finite());
    let apart = both.iter().map(|row| (row[0] - row[1]).abs()).fold(0.0, f64::max);
    let most = both.iter().map(|row| row[0].abs()).fold(f64::MIN_POSITIVE, f64::max);
    Some(Check::at_most("crank_agreement", agreement, apart / most, 1e-12))
}

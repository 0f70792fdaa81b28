//! What the scenes of all booms that stand still, with or without a balance, have in common.

use crate::balance::scene::Form;
use crate::balance::symbols as b;
use crate::component::description::TABLE;
use crate::component::extreme::fine;
use crate::component::sheet::Check;
use crate::component::standing::Standing;
use crate::component::telling::sample;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::schema::{Key, Values};
use crate::kernel::symbol::Symbol;
use crate::luffing::with_balance::{WithBalance, agreement, complete};
use crate::parts::motion::Motion;

pub const FIDELITY: Key = Key::choice(
    "fidelity",
    &["static", "table"],
    "How deep it is modelled: \"static\" (the angle is an input), \"table\" (the same, interpolated over the working range).",
);

/// The same of one that may move by itself.
pub const MOVING_FIDELITY: Key = Key::choice(
    "fidelity",
    &["static", "table", "rigid", "swing", "auto"],
    "How deep it is modelled: \"static\" (the angle is an input), \"table\" (the same, interpolated over the working range), \"rigid\" (it moves under a moment), \"swing\" (and the load swings on its rope), \"auto\" (the cheapest that keeps to `accuracy`).",
);

/// The same of one that a cylinder may move too.
pub const OILED_FIDELITY: Key = Key::choice(
    "fidelity",
    &["static", "table", "rigid", "swing", "hydraulic", "auto"],
    "How deep it is modelled: \"static\" (the angle is an input), \"table\" (the same, interpolated over the working range), \"rigid\" (it moves under a moment), \"swing\" (and the load swings on its rope), \"hydraulic\" (a cylinder with oil and valve moves it), \"auto\" (the cheapest that keeps to `accuracy`).",
);

pub const INTERPOLATION: Key = Key::part("table", TABLE, "Interpolation, with fidelity \"table\".");

/// Keys of the working range, with the symbols of its ends and of the boom's angular velocity.
pub const fn motion(from: &'static Symbol, to: &'static Symbol, omega: &'static Symbol) -> [Key; 6] {
    Motion::keys([from, to], &b::PHI, (omega, "Angular velocity of the boom."))
}

/// Working range and balance of a checked table, in whose words the weights are `weights`; mistakes go to `found`.
pub fn begun(v: &Values, weights: &str, found: &mut Vec<Diagnostic>) -> Option<(Motion, Option<Form<f64>>)> {
    let range = Motion::read(v.table("motion")?, found);
    let balance = v.part("balance", |table| Form::read(table, found))?;
    complete(v, balance.as_ref(), weights, found);
    Some((range?, balance))
}

/// The check of a balance by its energy; none where there is no balance.
pub fn balance_work<T: WithBalance>(model: &Standing, symbol: &'static Symbol) -> Vec<Check> {
    // The moment of the weights has one way here.
    let found = agreement::<T>(model, |_| Ok(0.0));
    let check = found.map(|[work, _]| Check::at_most("balance_work", symbol, work, 1e-12));
    check.into_iter().collect()
}

/// The check that parts of each position's results vanish together, relative to the greatest of them.
pub fn vanishing<const PARTS: usize>(
    model: &mut Standing,
    (id, symbol): (&'static str, &'static Symbol),
    of: &[&'static Symbol],
    parts: impl Fn(&[f64]) -> [f64; PARTS],
) -> Check {
    let (mut left, mut scale) = (0.0_f64, f64::MIN_POSITIVE);
    let motion = *model.motion();
    for row in sample(model, of, fine(&motion)) {
        let parts = parts(&row);
        left = left.max(parts.iter().sum::<f64>().abs());
        scale = parts.iter().fold(scale, |scale, part| scale.max(part.abs()));
    }
    Check::at_most(id, symbol, left / scale, 1e-12)
}

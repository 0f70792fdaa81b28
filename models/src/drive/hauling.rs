//! The rope of a drive in motion: what it pulls with, and that it cannot push.

use crate::component::extreme::fine;
use crate::component::running::Running;
use crate::component::stages::{Found, absent, results};
use crate::component::standing::Standing;
use crate::drive::gear::Gear;
use crate::drive::symbols as s;
use crate::kernel::calc::Calc;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::group::One;
use crate::kernel::schema::Values;
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::variable::Fault;

/// Forces of a mechanism in motion, of which a drive is a part.
pub trait Pushes<C> {
    /// Force of the drive, push positive, in N; `None` where there is no drive.
    fn f_d(&self) -> Option<C>;
}

/// Pull of the rope in motion, in N: without friction, while the tackle lengthens and while it shortens.
#[derive(Clone, Copy, Debug)]
pub struct Hauling<C>([C; 3]);
results! { Hauling as h => {
    S_LM: h.0[0];
    S_LM_OUT: h.0[1];
    S_LM_IN: h.0[2];
    Z_PULL: h.0[0];
} }

/// Its results but for the event.
pub const PULLS: [&Symbol; 3] = *listed!(s: S_LM, S_LM_OUT, S_LM_IN);

/// Of a tackle under the force that the motion asks of the drive.
///
/// # Errors
/// None where the drive is a tackle.
pub fn hauling<C: Calc, F: Pushes<C>>(gear: &Gear<C>, forces: &F) -> Found<Hauling<C>> {
    match (gear, forces.f_d()) {
        (Gear::Tackle(tackle), Some(f_d)) => Ok(Hauling(tackle.pulls(f_d, PULLS))),
        _ => Err(absent()),
    }
}

impl Hauling<f64> {
    /// Whether it pulls, at an angle (rad), or may go `slack`.
    ///
    /// # Errors
    /// A rope that would have to push.
    pub fn holds(&self, angle: &One<f64>, slack: bool) -> Found<()> {
        let [pull, ..] = self.0;
        let pull = if slack { pull.max(0.0) } else { pull };
        push(angle, pull).map_or(Ok(()), |what| {
            let help = "this motion ends there: drive, brake and stop more gently, or give the inertia of its drum by [cases.motor], \
                        with which it goes slack";
            Err(Box::new(Fault::outside(format!("{what}; {help}"))))
        })
    }
}

/// What is wrong at an angle (rad) with a pull of the rope (N): a rope cannot push, nor pull without end.
fn push(angle: &One<f64>, pull: f64) -> Option<String> {
    let at = format!("{} = {}", angle.0.id, angle.0.written(angle.1));
    if pull.is_infinite() {
        return Some(format!("{at}: the luffing rope points at the foot of its bar"));
    }
    (pull < 0.0).then(|| {
        let push = s::S_L.written(-pull);
        format!("{at}: the luffing rope is slack, it would have to push with {push}")
    })
}

/// Refuses, where the mechanism moves, a rope that does not pull at rest all over the working range.
pub fn check(model: &mut Standing, v: &Values, found: &mut Vec<Diagnostic>) {
    let variables = model.variables();
    let Some(pull) = variables.iter().position(|variable| variable.symbol == &s::S_L) else {
        return;
    };
    let coordinate = variables[0].symbol;
    let what = fine(&model.motion().clone()).find_map(|at| {
        model.set(0, at).ok()?;
        push(&One(coordinate, at), model.get(pull).ok()?)
    });
    if let Some(what) = what {
        let help = "let the balance leave more of the weights, or move E_x and E_y to the other side of the link; at the \
                    levels \"static\" and \"table\" it is a requirement that fails";
        found.push(v.refuse("drive", what, "no motion begins there", help));
    }
}

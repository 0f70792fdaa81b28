//! What controllers hold at the start: the moments under which their axes stay at rest.

use crate::kernel::number::short;
use crate::kernel::variable::Fault;
use crate::luffing::moving::control::{AXES, ByAxis};
use crate::luffing::moving::given::{Fitted, rates};
use crate::luffing::moving::level::{CraneAt, Level};
use crate::parts::control::{Latched, SpeedControl};
use crate::parts::joint::Bar;

/// Longest inner step, over the time in which a continuous controller changes the speed.
const FINEST: f64 = 0.25;

/// Moments (N·m) that give their axes no acceleration where the crane is, each alone, without dry friction and within its
/// limit; `None` where no moment does.
///
/// # Errors
/// Samples under which an axis swings up; a continuous controller that is too quick for inner steps of `step` s.
pub fn holding(
    level: &Level,
    at: &CraneAt,
    fitted: &Fitted,
    control: &ByAxis<SpeedControl>,
    step: f64,
) -> Result<[Option<f64>; AXES.len()], Fault> {
    let rates = rates(fitted);
    let mut found = [None; AXES.len()];
    for (axis, found) in found.iter_mut().enumerate() {
        let (Some(control), Some(rate)) = (control.0[axis], rates[axis]) else {
            continue;
        };
        let gains = |way: Bar, moment: f64| {
            let mut at = *at;
            match axis {
                2 => at.past.drum.way = way,
                _ => at.past.joints[axis] = way,
            }
            at.inputs.drive(axis).moment = moment;
            let told = level.told(&at.inputs);
            Some(told.as_ref().unwrap_or(level).rates(&at)?[rate])
        };
        let limit = control.limit();
        let ways = gains(Bar::Forward, 0.0).zip(gains(Bar::Backward, 0.0));
        let Some(((forward, backward), driven)) = ways.zip(gains(Bar::Forward, limit)) else {
            continue;
        };
        let inertia = limit / (driven - forward);
        if !inertia.is_finite() {
            continue;
        }
        if let Some([what, help]) = control.swings_up(inertia.abs()) {
            return Err(Fault::outside(format!("{what}: {help}")).about(control.axis.settings[2]));
        }
        if let Some(quickest) = control.quickest(inertia.abs()).filter(|time| *time * FINEST < step) {
            return Err(too_quick(&control, quickest, step));
        }
        *found = Some((-0.5 * (forward + backward) * inertia).clamp(-limit, limit));
    }
    Ok(found)
}

/// A continuous controller that inner steps do not see.
fn too_quick(control: &SpeedControl, quickest: f64, step: f64) -> Fault {
    let [k_p, k_i, cycle, ..] = control.axis.settings;
    Fault::outside(format!(
        "a continuous controller that changes the speed within {time} s, in inner steps of {step} s: set step to {least} s or less, \
         or give less {p} and {i}, since J/{p} and √(J/{i}) of {most} s and more are seen, where J is the moment over the \
         acceleration that it gives; or add {cycle} = \"20 ms\", the cycle of a sampled one",
        time = short(quickest),
        step = short(step),
        least = short(quickest * FINEST),
        p = k_p.id,
        i = k_i.id,
        most = short(step / FINEST),
        cycle = cycle.id,
    ))
    .about(k_p)
}

impl ByAxis<Latched> {
    /// They hold moments (N·m).
    pub fn hold(&mut self, moments: [Option<f64>; AXES.len()]) {
        for (held, moment) in self.0.iter_mut().zip(moments) {
            if let Some((held, moment)) = held.as_mut().zip(moment) {
                (held.moment, held.integral) = (moment, moment);
            }
        }
    }
}

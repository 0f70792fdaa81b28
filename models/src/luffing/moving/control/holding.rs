//! What controllers hold at the start: the moments under which their axes stay at rest.

use crate::kernel::variable::Fault;
use crate::luffing::moving::control::ByAxis;
use crate::luffing::moving::given::{Fitted, OMEGA_SL, V_R, order};
use crate::luffing::moving::level::{CraneAt, Level};
use crate::parts::control::{Latched, SpeedControl};
use crate::parts::joint::Bar;

/// The same held so far with moments (N·m) that give their axes no acceleration where the crane is, each alone, without dry
/// friction and within its limit; as it is where no moment does.
///
/// # Errors
/// Samples under which an axis swings up.
pub fn holding(
    level: &Level,
    at: &CraneAt,
    fitted: &Fitted,
    control: &ByAxis<SpeedControl>,
    held: &ByAxis<Latched>,
) -> Result<ByAxis<Latched>, Fault> {
    let states = order(fitted.oil, fitted.slewing.is_some());
    let rate = |place: usize| states.iter().position(|state| *state == place).map(|found| found + 2);
    let rates = [Some(1), rate(OMEGA_SL), rate(V_R)];
    let mut now = *held;
    for (axis, held) in now.0.iter_mut().enumerate() {
        let (Some(control), Some(held), Some(rate)) = (control.0[axis], held, rates[axis]) else {
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
        held.moment = (-0.5 * (forward + backward) * inertia).clamp(-limit, limit);
        held.integral = held.moment;
    }
    Ok(now)
}

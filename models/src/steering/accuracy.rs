//! How exactly the groups' angles are kept, by encoder resolution and dead band of the valve, and what slip that makes.

use crate::kernel::calc::Calc;
use crate::kernel::group::quantities;
use crate::steering::centre::Centre;
use crate::steering::cylinder::Pose;
use crate::steering::machine::Machine;
use crate::steering::slip::worst;
use crate::steering::symbols as s;

quantities! {
    /// Step of the encoder (rad), and stroke of a cylinder that the valve's dead band leaves (m).
    Accuracy { step: RESOLUTION, dead_band: DEAD_BAND }
}

impl<C: Calc> Accuracy<C> {
    /// Greatest error of a group's angle, in rad: half a step of the encoder, and the dead band at its lever arm.
    #[inline]
    pub fn angle_error(&self, pose: &Pose<C>) -> C {
        (self.step / C::constant(2.0) + self.dead_band / pose.od.abs()).def(&s::DELTA)
    }
}

/// Slip of a group by its own error, were the machine to keep its motion; what that gives way follows from all groups.
pub fn alone<C: Calc>(speed: &C, error: &C, v_t: &C) -> C {
    (speed.abs() * error.sin() / v_t.abs()).def(&s::SLIP_ALONE)
}

/// Greatest slip of each group, for all signs of the angle errors.
pub fn slips(machine: &Machine<f64>, centre: &Centre<f64>, errors: &[f64], slips: &mut Vec<f64>) {
    slips.clear();
    slips.resize(errors.len(), 0.0);
    worst(machine, centre, errors, slips);
}

/// Greatest slip of all groups.
#[must_use]
pub fn greatest(slips: &[f64]) -> f64 {
    slips.iter().copied().fold(0.0, f64::max)
}

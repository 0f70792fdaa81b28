//! How exactly the groups' angles are kept, by encoder resolution and dead band of the valve, and what slip that makes.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::quantities;
use crate::steering::centre::Centre;
use crate::steering::cylinder::Pose;
use crate::steering::machine::{GROUPS, Machine};
use crate::steering::slip::worst;
use crate::steering::symbols as s;
use crate::steering::wheels::Speed;

quantities! {
    /// Step of the encoder (rad), and stroke of a cylinder that the valve's dead band leaves (m).
    Accuracy { step: Q_E, dead_band: B_V }
}

impl<C: Calc> Accuracy<C> {
    /// Angle error of a group at the lever arm `od` (m), in rad: half a step of the encoder, and the dead band.
    #[inline]
    pub fn angle_error(&self, od: C) -> C {
        (self.step / C::constant(2.0) + self.dead_band / od.abs()).def(&s::DELTA)
    }
}

/// Greatest error of a group's angle, in rad.
#[derive(Clone, Copy, Debug)]
pub struct Error<C>(pub C);
results! { each Error as e => { DELTA: e.0; } }

impl<C: Calc> Error<C> {
    pub fn new(accuracy: &Accuracy<C>, pose: &Pose<C>) -> Error<C> {
        Error(accuracy.angle_error(pose.od))
    }
}

/// Slip of a group by its own error, were the machine to keep its motion; what that gives way follows from all groups.
#[derive(Clone, Copy, Debug)]
pub struct Alone<C>(pub C);
results! { each Alone; }

impl<C: Calc> Alone<C> {
    pub fn new(speed: &Speed<C>, error: &Error<C>, v_t: &C) -> Alone<C> {
        Alone((speed.0.abs() * error.0.sin() / v_t.abs()).def(&s::SLIP_ALONE))
    }
}

/// Greatest slip of a group, for all signs of the angle errors.
#[derive(Clone, Copy, Debug)]
pub struct Slipping<C>(C);
results! { each Slipping as slip => { SLIP: slip.0; } }

/// Of all groups.
pub fn slips(machine: &Machine<f64>, centre: &Centre<f64>, errors: &[Error<f64>], slips: &mut Vec<Slipping<f64>>) {
    let (mut given, mut found) = ([0.0; GROUPS[1]], [0.0; GROUPS[1]]);
    given.iter_mut().zip(errors).for_each(|(slot, error)| *slot = error.0);
    let n = errors.len();
    worst(machine, centre, &given[..n], &mut found[..n]);
    slips.clear();
    slips.extend(found[..n].iter().map(|slip| Slipping(*slip)));
}

/// Greatest slip of all groups.
#[derive(Clone, Copy, Debug)]
pub struct GreatestSlip<C>(C);
results! { GreatestSlip as slip => { SLIP_MAX: slip.0; } }

impl GreatestSlip<f64> {
    #[must_use]
    pub fn new(slips: &[Slipping<f64>]) -> GreatestSlip<f64> {
        GreatestSlip(slips.iter().map(|slip| slip.0).fold(0.0, f64::max))
    }
}

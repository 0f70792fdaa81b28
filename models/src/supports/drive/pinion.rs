//! Pinions on the toothed ring.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::parts::teeth;
use crate::supports::drive::gear::TurningDrive;
use crate::supports::drive::given::{RingPinion, TurningChoice};
use crate::supports::drive::motor::TurningMotor;
use crate::supports::drive::resistance::TurningMoments;
use crate::supports::drive::starts::HardestPush;
use crate::supports::drive::symbols as s;

/// Radius of curvature of the teeth against each other (m): 1/ρ = (1/r_z ± 1/r_g)/sin α, minus where the ring has its teeth
/// inside. (Hertz)
pub fn meshed<C: Calc>(pinion: &RingPinion<C>, choice: &TurningChoice) -> C {
    let (r_z, r_g) = (pinion.r_z, pinion.r_g);
    let other = if choice.inside { r_g - r_z } else { r_z + r_g };
    (r_z * r_g / other * pinion.alpha.sin()).def(&s::RHO_C)
}

/// Force (N) and stresses (Pa) of a pinion's teeth in a case.
#[derive(Clone, Copy, Debug)]
pub struct PinionForce<C> {
    force: C,
    bending: C,
    contact: C,
}
results! { each PinionForce as p => { F_T: p.force; SIGMA_FZ: p.bending; SIGMA_HZ: p.contact; } }

impl<C: Calc> PinionForce<C> {
    /// F_t = (M_st + M_J)/(r_g z), M_J in the hardest push of the start; σ_F and σ_H as of a drive's pinion. [Ports001, 6.5.4]
    pub fn new(
        drive: &TurningDrive<C>,
        pinion: &RingPinion<C>,
        radius: &C,
        turned: &TurningMoments<C>,
        motor: &TurningMotor<C>,
        pushed: &HardestPush<C>,
    ) -> PinionForce<C> {
        let moment = pushed.moment(drive, turned, motor);
        let force = ((turned.steady + moment) / (pinion.r_g * drive.z)).def(&s::F_T);
        let bending = teeth::bending(pinion.k, force, pinion.y, [pinion.b, pinion.m]).def(&s::SIGMA_FZ);
        let contact = if force.value() == 0.0 {
            force
        } else {
            teeth::contact(
                pinion.k,
                force,
                [pinion.e, pinion.nu],
                [pinion.b, *radius],
                pinion.alpha,
            )
            .def(&s::SIGMA_HZ)
        };
        PinionForce {
            force,
            bending,
            contact,
        }
    }
}

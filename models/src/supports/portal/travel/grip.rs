//! Driven wheels of a portal, which must not slip in a start nor slide in a stop.

use crate::component::stages::results;
use crate::kernel::calc::{Calc, sum};
use crate::parts::safety::safety;
use crate::supports::portal::symbols as s;
use crate::supports::portal::travel::given::{CornerDrive, PortalTravel};
use crate::supports::portal::travel::resistance::PortalResistance;
use crate::supports::portal::travel::stop::PortalStop;
use crate::supports::portal::wheels::CornerLoad;

/// Driven wheels, and the force of each in a start and in a stop, in N.
#[derive(Clone, Copy, Debug)]
pub struct WheelForces<C> {
    count: C,
    start: C,
    stop: C,
}
results! { WheelForces as w => { N_ALL: w.count; F_1A: w.start; F_1B: w.stop; } }

impl<C: Calc> WheelForces<C> {
    /// n_dr = Σ n_dr,i, F_1a = F_ta/n_dr, F_1b = |F_tb|/n_dr: all motors and brakes are alike.
    pub fn new(driven: &[CornerDrive<C>], forces: &PortalResistance<C>, stop: &PortalStop<C>) -> WheelForces<C> {
        let count = sum(driven.iter().map(|corner| corner.n_dr)).def(&s::N_ALL);
        WheelForces {
            count,
            start: (forces.start / count).def(&s::F_1A),
            stop: (stop.rails.abs() / count).def(&s::F_1B),
        }
    }
}

/// What a wheel of a corner can give (N), and its safety in a start and in a stop.
#[derive(Clone, Copy, Debug)]
pub struct WheelGrip<C> {
    force: C,
    slips: C,
    slides: C,
}
results! { each WheelGrip as g => { F_AD: g.force; K_ST: g.slips; K_BR: g.slides; } }

impl<C: Calc> WheelGrip<C> {
    /// F_ad = μ_a F_w, k_st = F_ad/F_1a, k_br = F_ad/F_1b where the corner has driven wheels. (Coulomb)
    pub fn new(
        travel: &PortalTravel<C>,
        driven: &CornerDrive<C>,
        wheels: &WheelForces<C>,
        load: &CornerLoad<C>,
    ) -> WheelGrip<C> {
        let force = (travel.mu_a * load.wheel).def(&s::F_AD);
        // Of a corner without driven wheels nothing is asked.
        let asked = |force: C| match driven.n_dr.value() > 0.0 {
            true => force,
            false => C::constant(0.0).over(driven.n_dr).over(force),
        };
        WheelGrip {
            force,
            slips: safety(force, asked(wheels.start), &s::K_ST),
            slides: safety(force, asked(wheels.stop), &s::K_BR),
        }
    }
}

//! Life of the raceway in each load case.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::quantities;
use crate::supports::ring::elements::RollingForces;
use crate::supports::ring::law::RollingElements;
use crate::supports::ring::symbols as s;
use crate::supports::upper::load::SupportLoad;

quantities! {
    /// Dynamic capacity (N), and how the horizontal force counts.
    DynamicCapacity { c: C_D, k_h: K_H }
}

/// Equivalent force (N) and life (million revolutions) in a case.
#[derive(Clone, Copy, Debug)]
pub struct RacewayLife<C> {
    force: C,
    turns: C,
}
results! { each RacewayLife as l => { P_E: l.force; L_10: l.turns; } }

impl<C: Calc> RacewayLife<C> {
    /// P_e = V_M + k_h H = V + 2M/D + k_h H, L_10 = (C/P_e)^p with p = 3 of balls, 10/3 of rollers. (Lundberg and Palmgren)
    pub fn new(
        rolling: &RollingElements,
        capacity: &DynamicCapacity<C>,
        load: &SupportLoad<C>,
        spread: &RollingForces<C>,
    ) -> RacewayLife<C> {
        let force = (spread.whole + capacity.k_h * load.horizontal).def(&s::P_E);
        RacewayLife {
            force,
            turns: (capacity.c / force).power(rolling.life).def(&s::L_10),
        }
    }
}

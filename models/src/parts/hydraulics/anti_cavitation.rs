//! Anti-cavitation valves: oil that flows from the tank into a chamber which falls below it.

use crate::kernel::calc::{Calc, Over};
use crate::kernel::group::quantities;
use crate::parts::hydraulics::symbols as s;
use crate::parts::hydraulics::throttle::relief;

quantities! {
    /// Of the two from the tank into the chambers.
    AntiCavitation { p_ac: P_AC, k_ac: K_AC }
}

impl<P: Calc> AntiCavitation<P> {
    /// Flow from the tank into a chamber at a pressure above its own (Pa), in m³/s: Q = k_ac (−p_ac − p), none at higher pressures.
    #[inline]
    pub fn flow<C: Over<P>>(&self, chamber: C) -> C {
        relief(-chamber, self.p_ac, self.k_ac)
    }

    /// What is left until it opens, in Pa.
    #[inline]
    pub fn margin<C: Over<P>>(&self, chamber: C) -> C {
        chamber + C::of(self.p_ac)
    }
}

//! A tank whose oil is under pressure.

use crate::kernel::calc::{Calc, Over};
use crate::kernel::group::quantities;
use crate::parts::hydraulics::symbols as s;

quantities! {
    /// Of the tank; without it the tank is open to the atmosphere.
    Tank { p_tank: P_TANK }
}

impl<P: Calc> Tank<P> {
    /// Pressures above that of the tank, in Pa.
    #[inline]
    pub fn above<C: Over<P>>(&self, pressures: [C; 2]) -> [C; 2] {
        pressures.map(|pressure| pressure - C::of(self.p_tank))
    }
}

//! Load-holding valves: one in each line, at the cylinder. Oil flows freely into the chamber; out of it only as far as the
//! chamber's own pressure and that of the other port, by the pilot ratio, open it against its spring. In the middle the
//! proportional valve relieves both ports to the tank: a pilot that stayed shut in would keep them open.

use crate::kernel::calc::{Calc, Over};
use crate::kernel::group::quantities;
use crate::parts::hydraulics::symbols as s;

quantities! {
    /// Of both, whose springs are vented: the pressure behind them does not count.
    LoadHolding { p_lh: P_LH, i_lh: I_LH, dp_lh: DP_LH, x_t: X_T }
}

impl<P: Calc> LoadHolding<P> {
    /// Pressure of a chamber, with that of its pilot, above the setting, in Pa: p + i_lh p_pilot − p_lh.
    #[inline]
    pub fn excess<C: Over<P>>(&self, chamber: C, pilot: C) -> C {
        chamber + pilot.times(self.i_lh) - C::of(self.p_lh)
    }

    /// Part that is open to oil out of the chamber: none up to the setting, all from dp_lh above it on.
    #[inline]
    pub fn opening<C: Over<P>>(&self, chamber: C, pilot: C) -> C {
        let excess = self.excess(chamber, pilot);
        match excess.value() {
            closed if closed <= 0.0 => C::constant(0.0),
            open if open >= self.dp_lh.value() => C::constant(1.0),
            _ => excess / C::of(self.dp_lh),
        }
    }

    /// What is left of a spool's stroke, in [−1, 1], until it shuts the ports off from the tank: x_T − |x|.
    #[inline]
    pub fn underlap<C: Over<P>>(&self, spool: C) -> C {
        C::of(self.x_t) - spool.abs()
    }

    /// The same as an opening; none beyond.
    #[inline]
    pub fn relieves<C: Over<P>>(&self, spool: C) -> C {
        let open = self.underlap(spool);
        if open.value() > 0.0 { open } else { C::constant(0.0) }
    }
}

/// What a line passes of the flow (m³/s, positive into the chamber) that it would pass without its valve.
#[inline]
pub fn checked<C: Calc>(free: C, opening: C) -> C {
    if free.value() < 0.0 { opening * free } else { free }
}

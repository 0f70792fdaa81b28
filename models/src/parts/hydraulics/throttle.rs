//! Flow through sharp edges and gaps.

use crate::kernel::calc::{Calc, Function, Over};
use crate::parts::hydraulics::symbols::DP_LAM;

/// Pressure difference, in Pa, below which a sharp edge passes oil in
/// proportion to it: 0.2 bar, where the flow turns laminar. It also keeps the
/// derivative finite at rest.
pub const LAMINAR: f64 = 2e4;

/// Flow through a sharp edge over its conductance: Δp/(Δp² + Δp_l²)^(1/4), in √Pa, which is
/// √Δp with the sign of Δp beyond the laminar range.
#[inline]
pub fn root<C: Calc>(difference: C) -> C {
    difference.through(Root)
}

/// The pressure difference (Pa) over an edge that passes what it would pass at `turbulent` (Pa, not negative), were its flow
/// turbulent all along: Δp² = (Δp_t² + √(Δp_t⁴ + 4 Δp_l² Δp_t²))/2.
#[inline]
pub fn difference<C: Calc>(turbulent: C) -> C {
    let square = turbulent.square();
    let inner = square.square() + C::constant(4.0) * C::known(&DP_LAM, LAMINAR).square() * square;
    (C::constant(0.5) * (square + inner.sqrt())).sqrt()
}

struct Root;

impl Function for Root {
    #[inline]
    fn at<C: Calc>(&self, difference: C) -> C {
        let laminar = C::known(&DP_LAM, LAMINAR);
        difference / (difference.square() + laminar.square()).sqrt().sqrt()
    }
}

/// Flow out of a volume through a relief valve, in m³/s: above `opening` (Pa) in proportion to the
/// excess, by `slope` in m³/(s·Pa).
#[inline]
pub fn relief<P: Calc, C: Over<P>>(pressure: C, opening: P, slope: P) -> C {
    if pressure.value() > opening.value() {
        (pressure - C::of(opening)).times(slope)
    } else {
        C::constant(0.0)
    }
}

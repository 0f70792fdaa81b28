//! What holds slewing and luffing at rest on a hull that lies aslant.

use crate::afloat::crane::{CraneWeights, slewed};
use crate::afloat::luffed::Luffed;
use crate::afloat::posture::Posture;
use crate::afloat::symbols as s;
use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::One;

/// Moments that hold slewing and luffing at rest, in N·m.
#[derive(Clone, Copy, Debug)]
pub struct HeldAtRest<C>([C; 2]);
results! { HeldAtRest as h => { M_SL0: h.0[0]; M_10: h.0[1]; } }

impl<C: Calc> HeldAtRest<C> {
    /// M_sl0 = cos β (Y tan θ − X tan φ) with X, Y = M_ξ + Q R and M_η as they lie along and across the hull;
    /// M_10 = cos β (M'_h1 + Q h'_A − (M'_r1 + Q R') (cos ψ tan θ + sin ψ tan φ)). [virtual work]
    pub fn new(
        psi: &One<C>,
        load: &One<C>,
        luffed: &Luffed<C>,
        crane: &CraneWeights<C>,
        posture: &Posture<C>,
    ) -> HeldAtRest<C> {
        let [reach, _, travel, rise, _, _, _, along, up] = luffed.sums;
        let ([_, trim, heel], (sin, cos)) = (posture.lie(), psi.sin_cos());
        let (_, level) = posture.inclination().sin_cos();
        let [ahead, aside] = slewed(crane.forward + load.1 * reach, crane.aside, (sin, cos));
        let slewing = level * (aside * trim - ahead * heel);
        let luffing = level * (up + load.1 * rise - (along + load.1 * travel) * (cos * trim + sin * heel));
        HeldAtRest([slewing.def(&s::M_SL0), luffing.def(&s::M_10)])
    }
}

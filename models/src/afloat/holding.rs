//! What holds slewing and luffing at rest on a hull that lies aslant.

use crate::afloat::crane::{CraneWeights, slewed};
use crate::afloat::posture::Posture;
use crate::afloat::symbols as s;
use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::luffing::luffed::{Luffed, LuffedRates};

/// Moments of what slews with the load (N·m), the water's slope in the boom's plane, how luffing changes moments (N·m/rad), and what holds both at rest (N·m).
#[derive(Clone, Copy, Debug)]
pub struct HeldAtRest<C> {
    own: [C; 2],
    slope: C,
    changes: [C; 2],
    holds: [C; 2],
}
results! { HeldAtRest as h => {
    M_XS: h.own[0];
    M_YS: h.own[1];
    T_XI: h.slope;
    DM_R: h.changes[0];
    DM_H: h.changes[1];
    M_SL0: h.holds[0];
    M_10: h.holds[1];
} }

impl<C: Calc> HeldAtRest<C> {
    /// M_xs = (M_ξ + Q R) cos ψ − M_η sin ψ, M_ys = (M_ξ + Q R) sin ψ + M_η cos ψ, M'_r = M'_r1 + Q R', M'_h = M'_h1 + Q h'_A;
    /// M_sl0 = cos β (M_ys tan θ − M_xs tan φ), t_ξ = cos ψ tan θ + sin ψ tan φ, M_10 = cos β (M'_h − M'_r t_ξ). [virtual work]
    pub fn new(
        psi: &One<C>,
        load: &One<C>,
        luffed: &Luffed<C>,
        rates: &LuffedRates<C>,
        crane: &CraneWeights<C>,
        posture: &Posture<C>,
    ) -> HeldAtRest<C> {
        let ([_, trim, heel], (sin, cos)) = (posture.lie(), psi.sin_cos());
        let (_, level) = posture.inclination().sin_cos();
        let [x, y] = slewed(crane.forward + load.1 * luffed.reach, crane.aside, (sin, cos));
        let own = [x.def(&s::M_XS), y.def(&s::M_YS)];
        let changes = [
            (rates.forward + load.1 * rates.reach).def(&s::DM_R),
            (rates.up + load.1 * rates.height).def(&s::DM_H),
        ];
        let slope = (cos * trim + sin * heel).def(&s::T_XI);
        let slewing = level * (own[1] * trim - own[0] * heel);
        let luffing = level * (changes[1] - changes[0] * slope);
        HeldAtRest {
            own,
            slope,
            changes,
            holds: [slewing.def(&s::M_SL0), luffing.def(&s::M_10)],
        }
    }
}

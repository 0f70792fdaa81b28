//! Heel and trim for small angles, by the metacentric heights.

use crate::afloat::loaded::Loaded;
use crate::afloat::symbols as s;
use crate::afloat::upright::Upright;
use crate::component::stages::results;
use crate::kernel::calc::Calc;

/// Heel and trim by the metacentric heights, and both combined: slopes, and angles (rad).
#[derive(Clone, Copy, Debug)]
pub struct SmallAngles<C> {
    slopes: [C; 2],
    angles: [C; 3],
}
results! { SmallAngles as a => {
    T_PHI_M: a.slopes[0];
    T_THETA_M: a.slopes[1];
    PHI_M: a.angles[0];
    THETA_M: a.angles[1];
    PHI_R: a.angles[2];
} }

impl<C: Calc> SmallAngles<C> {
    /// tan φ = (M_T − W y_B)/(W GM), tan θ = (M_L − W x_B)/(W GM_L), tan² φ_r = tan² φ + tan² θ. [Ports001, 7.3]
    pub fn new(loaded: &Loaded<C>, upright: &Upright<C>) -> SmallAngles<C> {
        let all = &loaded.all;
        let moment = upright
            .aside
            .map_or(all.across, |aside| all.across - all.weight * aside);
        let across = (moment / (all.weight * upright.height[0])).def(&s::T_PHI_M);
        let along = ((all.along - all.weight * upright.hull[1]) / (all.weight * upright.height[1])).def(&s::T_THETA_M);
        let squares = across.square() + along.square();
        let both = if squares.value() > 0.0 { squares.sqrt() } else { squares };
        let one = C::constant(1.0);
        SmallAngles {
            slopes: [across, along],
            angles: [
                C::direction(one, across).def(&s::PHI_M),
                C::direction(one, along).def(&s::THETA_M),
                C::direction(one, both).def(&s::PHI_R),
            ],
        }
    }
}

//! What holds a portal against the wind out of service: rail clamps, and anchors that keep it from tipping.

use crate::component::stages::results;
use crate::kernel::calc::{Calc, sum};
use crate::parts::safety::safety;
use crate::supports::portal::symbols as s;
use crate::supports::portal::tipping::Edge;
use crate::supports::portal::travel::given::{PortalStorm, PortalTravel};
use crate::supports::portal::travel::resistance::TravelWind;
use crate::supports::portal::weights::{StillMoment, WindArea};

/// Of the crane without load: force (N) and moment (N·m) of the wind, wheels' resistance, slope, what all clamps and each must
/// hold (N), over what it holds.
#[derive(Clone, Copy, Debug)]
pub struct StormForces<C> {
    wind: C,
    pub moment: C,
    free: C,
    slope: C,
    clamps: C,
    each: C,
    used: C,
}
results! { StormForces as f => {
    F_SW: f.wind;
    M_SW: f.moment;
    F_0S: f.free;
    F_GS: f.slope;
    F_CL: f.clamps;
    F_C1: f.each;
    U_C: f.used;
} }

impl<C: Calc> StormForces<C> {
    /// F_sw = p_s A_w, M_sw = p_s Σ A_w h_w, F_0s = w V_0 cos γ, F_γs = V_0 sin γ, F_cl = k_w F_sw + F_γs − F_0s, F_c1 = F_cl/z_c:
    /// the brakes do not count. (equilibrium)
    pub fn new(
        travel: &PortalTravel<C>,
        storm: &PortalStorm<C>,
        areas: &[WindArea<C>],
        still: &StillMoment<C>,
        rolling: &C,
        blown: &TravelWind<C>,
    ) -> StormForces<C> {
        let (sin, cos) = travel.gamma_t.sin_cos();
        let wind = (storm.p_s * blown.area).def(&s::F_SW);
        let moment = (storm.p_s * sum(areas.iter().map(|area| area.a_w * area.h_w))).def(&s::M_SW);
        let free = (*rolling * still.weight * cos).def(&s::F_0S);
        let slope = (still.weight * sin).def(&s::F_GS);
        let clamps = (travel.k_w * wind + slope - free).def(&s::F_CL);
        let each = (clamps / storm.z_c).def(&s::F_C1);
        StormForces {
            wind,
            moment,
            free,
            slope,
            clamps,
            each,
            used: (each / storm.f_c).def(&s::U_C),
        }
    }
}

/// Safety of the untied crane about an edge, and the pull down of the anchors across from it (N).
#[derive(Clone, Copy, Debug)]
pub struct StormEdge<C> {
    safety: C,
    pull: C,
}
results! { each StormEdge as e => { K_S: e.safety; U: e.pull; } }

impl<C: Calc> StormEdge<C> {
    /// K_s = M_s/M_sw, U = (k_w M_sw − M_s)/a, or b: the wind blows towards the edge. (equilibrium)
    pub fn new(travel: &PortalTravel<C>, storm: &StormForces<C>, edge: &Edge<C>) -> StormEdge<C> {
        StormEdge {
            safety: safety(edge.holds, storm.moment, &s::K_S),
            pull: ((travel.k_w * storm.moment - edge.holds) / edge.width).def(&s::U),
        }
    }
}

//! What resists the travel of a portal.

use crate::component::stages::results;
use crate::kernel::calc::{Calc, sum};
use crate::kernel::group::One;
use crate::supports::portal::load::SlewingLoad;
use crate::supports::portal::symbols as s;
use crate::supports::portal::travel::given::{PortalTravel, PortalWheels};
use crate::supports::portal::weights::{Blowing, WindArea};

/// w = (2 f_r + μ_j d_j)/D_t: the moment about a wheel's axle of its rolling and of its bearings. (equilibrium)
pub fn rolling<C: Calc>(wheels: &PortalWheels<C>) -> C {
    ((wheels.f_r.scaled(2.0) + wheels.mu_j * wheels.d_j) / wheels.d_t).def(&s::W)
}

/// The wind at work: the area on which it acts (m²), its force along the rails (N).
#[derive(Clone, Copy, Debug)]
pub struct TravelWind<C> {
    pub area: C,
    force: C,
}
results! { TravelWind as w => { A_SUM: w.area; F_WT: w.force; } }

impl<C: Calc> TravelWind<C> {
    /// A_w = Σ A_w,i, F_wt = p_w A_w |cos χ_w|. (equilibrium)
    pub fn new(_: &PortalTravel<C>, wind: &Blowing<C>, areas: &[WindArea<C>]) -> TravelWind<C> {
        let area = sum(areas.iter().map(|area| area.a_w)).def(&s::A_SUM);
        let along = wind.chi_w.sin_cos().1.abs();
        TravelWind {
            area,
            force: (wind.p_w * area * along).def(&s::F_WT),
        }
    }
}

/// Forces of travel, in N: of the wheels without flanges and with them, of slope, wind and steady travel, of inertia, of a
/// start.
#[derive(Clone, Copy, Debug)]
pub struct PortalResistance<C> {
    pub free: C,
    wheels: C,
    pub slope: C,
    wind: Option<C>,
    pub steady: C,
    inertia: C,
    pub start: C,
}
results! { PortalResistance as r => {
    F_0: r.free;
    F_F: r.wheels;
    F_GAMMA: r.slope;
    F_T: r.steady;
    F_A: r.inertia;
    F_TA: r.start;
} }

impl<C: Calc> PortalResistance<C> {
    /// F_0 = w V cos γ, F_f = β F_0, F_γ = V sin γ, F_t = F_f + F_γ + F_wt, F_a = V a_t/g,
    /// F_ta = F_t + F_a. (equilibrium)
    pub fn new(
        gravity: &One<C>,
        wheels: &PortalWheels<C>,
        travel: &PortalTravel<C>,
        slewing: &SlewingLoad<C>,
        rolling: &C,
        blown: Option<&TravelWind<C>>,
    ) -> PortalResistance<C> {
        let (sin, cos) = travel.gamma_t.sin_cos();
        let free = (*rolling * slewing.force * cos).def(&s::F_0);
        let rubbing = (wheels.beta_t * free).def(&s::F_F);
        let slope = (slewing.force * sin).def(&s::F_GAMMA);
        let wind = blown.map(|blown| blown.force);
        let still = rubbing + slope;
        let steady = wind.map_or(still, |wind| still + wind).def(&s::F_T);
        let inertia = (slewing.force / **gravity * travel.a_t).def(&s::F_A);
        PortalResistance {
            free,
            wheels: rubbing,
            slope,
            wind,
            steady,
            inertia,
            start: (steady + inertia).def(&s::F_TA),
        }
    }

    /// What drives the crane on, down the slope with the wind so many times (N): F_wt + F_γ − F_0.
    pub fn drives_on(&self, times: Option<C>) -> C {
        let wind = self.wind.map(|wind| times.map_or(wind, |times| times * wind));
        wind.map_or(self.slope, |wind| wind + self.slope) - self.free
    }
}

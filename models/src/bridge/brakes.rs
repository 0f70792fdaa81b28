//! The brakes of the trolley: what a stop asks of them, time and way of a stop, wheels that must not slide.

use crate::bridge::given::BridgeTrolley;
use crate::bridge::profiles::TravelProfile;
use crate::bridge::symbols as s;
use crate::bridge::trolley::{Grip, TravelForces};
use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::{One, quantities};
use crate::kernel::variable::Fault;
use crate::parts::safety::safety;
use crate::parts::travel::stopped;

quantities! {
    /// The brakes: their force at wheels or tow rope, all together, in N.
    TrolleyBrakes { f_br: F_BR }
}

/// Force that drives it on, and that a stop asks for (N), that of the brakes over it, deceleration (m/s²), time (s) and way (m) of a stop.
#[derive(Clone, Copy, Debug)]
pub struct TrolleyBraking<C> {
    drives: C,
    asked: C,
    safety: C,
    rate: C,
    time: C,
    way: C,
}
results! { TrolleyBraking as b => {
    F_DO: b.drives;
    F_BN: b.asked;
    NU_BR: b.safety;
    A_BR: b.rate;
    T_BR: b.time;
    S_BR: b.way;
} }

impl<C: Calc> TrolleyBraking<C> {
    /// F_bn = (G_t + W) a_c/g + F_drive, a_br = g (F_br − F_drive)/(G_t + W) with what drives it on, F_w + |F_γ| − F_μ − F_s: wind
    /// from behind, down the slope; t = v_c/a_br, s = v_c²/(2 a_br). (Newton and Euler)
    ///
    /// # Errors
    /// Brakes that do not stop it.
    pub fn new(
        brakes: &TrolleyBrakes<C>,
        profile: &TravelProfile<C>,
        unit: &BridgeTrolley<C>,
        gravity: &One<C>,
        weight: &C,
        forces: &TravelForces<C>,
    ) -> Result<TrolleyBraking<C>, Fault> {
        let borne = unit.g_t + *weight;
        let drives = forces.drives_on().def(&s::F_DO);
        let asked = (borne * profile.a_c / **gravity + drives).def(&s::F_BN);
        if brakes.f_br.value() <= drives.value() {
            let (force, on) = (s::F_BR.written(brakes.f_br.value()), s::F_DO.written(drives.value()));
            let message = format!("F_br = {force} does not stop the trolley, which wind and slope drive on with {on}");
            return Err(Fault::outside(message).about(&s::F_BR));
        }
        let rate = (**gravity * (brakes.f_br - drives) / borne).def(&s::A_BR);
        let [time, way] = stopped(profile.v_c, rate);
        Ok(TrolleyBraking {
            drives,
            asked,
            safety: safety(brakes.f_br, asked, &s::NU_BR),
            rate,
            time: time.def(&s::T_BR),
            way: way.def(&s::S_BR),
        })
    }
}

/// k_br = F_ad/F_br: the driven wheels are those that are braked. (Coulomb)
pub fn holds<C: Calc>(brakes: &TrolleyBrakes<C>, grip: &Grip<C>) -> C {
    (grip.force / brakes.f_br).def(&s::K_BR)
}

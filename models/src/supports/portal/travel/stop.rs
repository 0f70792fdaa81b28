//! The brakes of a portal's travel: what they hold, and how they stop it.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::kernel::variable::Fault;
use crate::parts::travel::stopped;
use crate::supports::portal::load::SlewingLoad;
use crate::supports::portal::symbols as s;
use crate::supports::portal::travel::given::PortalTravel;
use crate::supports::portal::travel::motor::TravelMotor;
use crate::supports::portal::travel::resistance::PortalResistance;

/// What drives the crane on, what the brakes must hold (N) over their force, deceleration (m/s²), time (s) and way (m) of a
/// stop, force on the rails (N).
#[derive(Clone, Copy, Debug)]
pub struct PortalStop<C> {
    drives: C,
    holds: C,
    used: C,
    rate: C,
    time: C,
    way: C,
    pub rails: C,
}
results! { PortalStop as p => {
    F_DO: p.drives;
    F_HD: p.holds;
    U_HD: p.used;
    A_BR: p.rate;
    T_BR: p.time;
    S_BR: p.way;
    F_TB: p.rails;
} }

impl<C: Calc> PortalStop<C> {
    /// F_do = F_wt + F_γ − F_0, F_hd = k_w F_wt + F_γ − F_0, a_br = (F_br − F_do)/(V/g + m_J), t = v_t/a_br, s = v_t²/(2 a_br),
    /// F_tb = F_br − m_J a_br. (Newton and Euler)
    ///
    /// # Errors
    /// Brakes that do not stop it.
    pub fn new(
        gravity: &One<C>,
        travel: &PortalTravel<C>,
        slewing: &SlewingLoad<C>,
        forces: &PortalResistance<C>,
        motors: &TravelMotor<C>,
    ) -> Result<PortalStop<C>, Fault> {
        let drives = forces.drives_on(None).def(&s::F_DO);
        let holds = forces.drives_on(Some(travel.k_w)).def(&s::F_HD);
        if travel.f_br.value() <= drives.value() {
            let (force, on) = (s::F_BR.written(travel.f_br.value()), s::F_DO.written(drives.value()));
            let message = format!(
                "F_br = {force} does not stop the crane, which wind and slope drive on with {on}: give a greater F_br"
            );
            return Err(Fault::outside(message).about(&s::F_BR));
        }
        let all = slewing.force / **gravity + motors.mass;
        let rate = ((travel.f_br - drives) / all).def(&s::A_BR);
        let [time, way] = stopped(travel.v_t, rate);
        Ok(PortalStop {
            drives,
            holds,
            used: (holds / travel.f_br).def(&s::U_HD),
            rate,
            time: time.def(&s::T_BR),
            way: way.def(&s::S_BR),
            rails: (travel.f_br - motors.mass * rate).def(&s::F_TB),
        })
    }
}

//! The controller of slewing by itself: [`crate::parts::control`] as the source of its drive's moment.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::kernel::variable::Fault;
use crate::parts::control::{Latched, SpeedControl};
use crate::parts::turntable::Turning;
use crate::slewing::coupling::{DriveSide, SlipCoupling};
use crate::slewing::motion::SlewingDrive;
use crate::slewing::swinging::SwingingLoad;
use crate::slewing::symbols as s;

/// What the controller holds.
#[derive(Clone, Copy, Debug)]
pub struct Controlled<C>(Latched<C>);
results! { Controlled as c => { M_SL: c.0.moment.def(&s::M_SL); OMEGA_S_SL: c.0.set; M_I_SL: c.0.integral; } }

impl<C: Calc> Controlled<C> {
    pub fn new(held: &Latched<C>) -> Controlled<C> {
        Controlled(*held)
    }
}

/// The drive: its moment as given, or as the controller holds it.
pub fn acting<C: Calc>(given: &SlewingDrive<C>, held: &Option<Latched<C>>) -> SlewingDrive<C> {
    held.map_or(*given, |held| SlewingDrive {
        m_sl: held.moment,
        ..*given
    })
}

/// What the controller moves, in kg·m²: without the load where that swings.
fn moved<C: Calc>(turning: &Turning<C>, swung: &Option<SwingingLoad<C>>, total: &C) -> C {
    if swung.is_some() { turning.j_sl } else { *total }
}

/// One sample of the controller, at an angle (rad) and an angular velocity (rad/s), the drive's where a coupling may part it
/// from what slews; then the drive alone must not swing up either.
///
/// # Errors
/// Gains under which the speed swings up.
#[expect(clippy::too_many_arguments, reason = "all that it needs")]
pub fn sampled<C: Calc>(
    control: &SpeedControl<C>,
    commanded: &One<C>,
    held: &Latched<C>,
    turning: &Turning<C>,
    swung: &Option<SwingingLoad<C>>,
    total: &C,
    coupling: &Option<SlipCoupling<C>>,
    side: &Option<DriveSide<C>>,
    psi: &One<C>,
    omega: &One<C>,
) -> Result<Latched<C>, Fault> {
    let least = coupling.map_or_else(|| moved(turning, swung, total), |coupling| coupling.j_d);
    match control.swings_up(least.value()) {
        Some([what, help]) => Err(Fault::outside(format!("{what}: {help}"))),
        None => {
            let speed = side.map_or(omega.1, |side| side.omega_d);
            Ok(control.sample(held, commanded, [psi.1, speed]))
        }
    }
}

/// The speed under the controller, in closed form.
#[derive(Clone, Copy, Debug)]
pub struct Regulated<C>([C; 2]);
results! { Regulated as r => { OMEGA_0_SL: r.0[0]; ZETA_SL: r.0[1]; } }

impl<C: Calc> Regulated<C> {
    /// With the load where that keeps its place under the head.
    pub fn new(
        control: &SpeedControl<C>,
        turning: &Turning<C>,
        swung: &Option<SwingingLoad<C>>,
        total: &C,
    ) -> Regulated<C> {
        let inertia = moved(turning, swung, total);
        Regulated(control.vibration(inertia, turning.c_sl, [&s::OMEGA_0_SL, &s::ZETA_SL]))
    }
}

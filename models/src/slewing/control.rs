//! The controller of slewing by itself: [`crate::parts::control`] as the source of its drive's moment.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::kernel::variable::Fault;
use crate::parts::control::continuous::{Ordered, Regime, Regulating, Sensed};
use crate::parts::control::{Latched, SpeedControl};
use crate::parts::turntable::Turning;
use crate::slewing::coupling::{DriveRates, DriveSide, SlipCoupling};
use crate::slewing::motion::{SlewingDrive, Turned};
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

/// What the continuous controller gives.
#[derive(Clone, Copy, Debug)]
pub struct Regulation<C>(pub Ordered<C>);
results! { Regulation as r => { E_R_SL: r.0.error; M_A_SL: r.0.asked; M_SL: r.0.moment; } }

impl<C: Calc> Regulation<C> {
    /// At an angular velocity (rad/s), the drive's where a coupling may part it from what slews.
    pub fn new(
        control: &SpeedControl<C>,
        state: &Regulating<C>,
        past: &Regime<C>,
        side: &Option<DriveSide<C>>,
        omega: &One<C>,
    ) -> Regulation<C> {
        let ordered = control.order(state, past, speed(side, omega));
        Regulation(Ordered {
            moment: ordered.moment.def(&s::M_SL),
            ..ordered
        })
    }
}

/// What the controller has the speed of, in rad/s: the drive.
pub fn speed<C: Calc>(side: &Option<DriveSide<C>>, omega: &One<C>) -> C {
    side.map_or(omega.1, |side| side.omega_d)
}

/// What the continuous controller sees: the angle of what slews, and the speed of its drive, where a coupling may part them.
pub fn seen<C: Calc>(
    commanded: &One<C>,
    side: &Option<DriveSide<C>>,
    psi: &One<C>,
    omega: &One<C>,
    turned: &Turned<C>,
    coupled: Option<&DriveRates<C>>,
) -> Sensed<C> {
    Sensed {
        commanded: commanded.1,
        place: psi.1,
        speed: speed(side, omega),
        acceleration: coupled.map_or(turned.acceleration, |coupled| coupled.acceleration),
    }
}

/// Rates of the continuous controller's states.
#[derive(Clone, Copy, Debug)]
pub struct Winding<C>([C; 2]);
results! { Winding as w => { D_OMEGA_R_SL: w.0[0]; D_EPSILON_SL: w.0[1]; } }

impl<C: Calc> Winding<C> {
    pub fn new(
        control: &SpeedControl<C>,
        past: &Regime<C>,
        regulation: &Regulation<C>,
        seen: &Sensed<C>,
    ) -> Winding<C> {
        let [set, integral] = control.winding(past, &regulation.0, seen);
        Winding([set.def(&s::D_OMEGA_R_SL), integral.def(&s::D_EPSILON_SL)])
    }
}

/// What falls below zero where a smooth piece of the continuous controller's law ends.
#[derive(Clone, Copy, Debug)]
pub struct ControlEvents<C>([C; 3]);
results! { ControlEvents as e => { Z_SL_RAMP: e.0[0]; Z_SL_LIMIT: e.0[1]; Z_SL_WIND: e.0[2]; } }

impl<C: Calc> ControlEvents<C> {
    pub fn new(
        control: &SpeedControl<C>,
        state: &Regulating<C>,
        past: &Regime<C>,
        regulation: &Regulation<C>,
        seen: &Sensed<C>,
    ) -> ControlEvents<C> {
        ControlEvents(control.regulates_until(state, past, &regulation.0, seen))
    }
}

/// The drive: its moment as given, as the controller holds it, or as the continuous one gives it.
pub fn acting<C: Calc>(
    given: &SlewingDrive<C>,
    held: &Option<Latched<C>>,
    regulation: Option<&Regulation<C>>,
) -> SlewingDrive<C> {
    let held = held.as_ref().map(|held| held.moment);
    let moment = held.or_else(|| regulation.map(|regulation| regulation.0.moment));
    moment.map_or(*given, |m_sl| SlewingDrive { m_sl, ..*given })
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
        None => Ok(control.sample(held, commanded, [psi.1, speed(side, omega)])),
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

//! Shafts of the gear, from a motor to its pinion.

use std::f64::consts::TAU;

use crate::component::stages::{Found, absent, results};
use crate::kernel::calc::Calc;
use crate::supports::drive::gear::{TurningDrive, through};
use crate::supports::drive::given::{GearStage, TurningChoice};
use crate::supports::drive::motor::TurningMotor;
use crate::supports::drive::starts::HardestPush;
use crate::supports::drive::symbols as s;
use crate::supports::upper::load::most;

/// A motor's shaft in the case of heating: speed (1/s), torque (N·m) and power (W) against steady slewing; the greatest torque
/// (N·m) that it gives to its gear in a start, of all cases.
#[derive(Clone, Copy, Debug)]
pub struct DrivingShaft<C> {
    n: C,
    torque: C,
    power: C,
    push: C,
}
results! { DrivingShaft as m => { N_G0: m.n; T_G0: m.torque; P_G0: m.power; T_GP0: m.push; } }

impl<C: Calc> DrivingShaft<C> {
    /// n, T_0 and P_M of the case of heating; max (T_0 + (J_t − J_M) ω̇) over all cases. [Ports001, 6.5.2]
    ///
    /// # Errors
    /// A case of heating that there is not.
    pub fn new(
        drive: &TurningDrive<C>,
        choice: &TurningChoice,
        motors: &[TurningMotor<C>],
        pushed: &[HardestPush<C>],
    ) -> Found<DrivingShaft<C>> {
        let motor = motors.get(choice.heating).ok_or_else(absent)?;
        let pushes = motors
            .iter()
            .zip(pushed)
            .map(|(motor, pushed)| pushed.behind(drive, motor));
        Ok(DrivingShaft {
            n: motor.n.tabled(&s::N_G0).def(&s::N_G0),
            torque: motor.against.tabled(&s::T_G0).def(&s::T_G0),
            power: motor.power.tabled(&s::P_G0).def(&s::P_G0),
            push: most(pushes).tabled(&s::T_GP0).def(&s::T_GP0),
        })
    }
}

/// The shaft behind a gear stage: turns of the motor for one of it and efficiency up to it; speed (1/s), torque (N·m) and power
/// (W) in the case of heating, greatest torque (N·m) in a start.
#[derive(Clone, Copy, Debug)]
pub struct GearShaft<C> {
    ratio: C,
    efficiency: C,
    n: C,
    torque: C,
    power: C,
    push: C,
}
results! { each GearShaft as g => {
    U_G: g.ratio;
    ETA_U: g.efficiency;
    N_G: g.n;
    T_G: g.torque;
    P_G: g.power;
    T_GP: g.push;
} }

impl<C: Calc> GearShaft<C> {
    /// u_j = i_1 ⋯ i_j, η_uj = η_1 ⋯ η_j; n_j = n_0/u_j, T_j = T_0 u_j η_uj, P_j = 2π n_j T_j. [Ports001, 6.5.4]
    fn new(stages: &[GearStage<C>], motor: &DrivingShaft<C>) -> GearShaft<C> {
        let [ratio, efficiency] = through(stages);
        let (ratio, efficiency) = (ratio.def(&s::U_G), efficiency.def(&s::ETA_U));
        let n = (motor.n / ratio).def(&s::N_G);
        let torque = (motor.torque * ratio * efficiency).def(&s::T_G);
        GearShaft {
            ratio,
            efficiency,
            n,
            torque,
            power: (C::constant(TAU) * n * torque).def(&s::P_G),
            push: (motor.push * ratio * efficiency).def(&s::T_GP),
        }
    }
}

/// All shafts behind the motor's, the last one that of the pinion.
pub fn shafts<C: Calc>(stages: &[GearStage<C>], motor: &DrivingShaft<C>, room: &mut Vec<GearShaft<C>>) {
    room.clear();
    room.extend((0..stages.len()).map(|at| C::body(at, || GearShaft::new(&stages[..=at], motor))));
}

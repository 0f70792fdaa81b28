//! Starts of a slewing motor by what it gives on the way, besides by its mean torque, and the greatest torque of each.

use std::f64::consts::TAU;

use crate::component::stages::{absent, results};
use crate::kernel::calc::Calc;
use crate::parts::starts::inverter::Ramped;
use crate::parts::starts::slip::Slipped;
use crate::parts::starts::{InverterStart, RatedPoint, SlipStart, Starting};
use crate::supports::drive::gear::TurningDrive;
use crate::supports::drive::inertia::Outswing;
use crate::supports::drive::motor::TurningMotor;
use crate::supports::drive::resistance::TurningMoments;
use crate::supports::drive::symbols as s;

impl<C: Calc> TurningDrive<C> {
    fn point(&self) -> RatedPoint<C> {
        RatedPoint {
            torque: self.rated(),
            n: self.n_n,
        }
    }
}

/// To the speed of the case.
fn starting<C: Calc>(swung: &Outswing<C>, motor: &TurningMotor<C>) -> Starting<C> {
    Starting {
        moves: motor.n.value() > 0.0,
        n: motor.n,
        against: motor.against,
        inertia: motor.inertia,
        head: swung.reach.abs() * swung.omega,
    }
}

/// Along the motor's slip curve. [Ports001, 6.5.2]
pub fn slipped<C: Calc>(
    drive: &TurningDrive<C>,
    start: &SlipStart<C>,
    swung: &Outswing<C>,
    motor: &TurningMotor<C>,
) -> Slipped<C> {
    Slipped::new(&drive.point(), start, &starting(swung, motor))
}

/// On an inverter. [Ports001, 6.5.2]
pub fn ramped<C: Calc>(
    drive: &TurningDrive<C>,
    start: &InverterStart<C>,
    swung: &Outswing<C>,
    motor: &TurningMotor<C>,
) -> Ramped<C> {
    Ramped::new(&drive.point(), start, &starting(swung, motor))
}

/// What a start asks of all behind the motor at most: the motor's greatest torque on the way (N·m), and how it then quickens its
/// shaft (rad/s²); nothing where only the mean torque is known.
#[derive(Clone, Copy, Debug)]
pub struct HardestPush<C>(Option<[C; 2]>);
results! { each HardestPush as p => { T_P: p.0.ok_or_else(absent)?[0]; ALPHA_P: p.0.ok_or_else(absent)?[1]; } }

impl<C: Calc> HardestPush<C> {
    /// T_p = T(s) where that is greatest between the slip of the case and 1, or the ramp's torque within the inverter's limit;
    /// ω̇_p = (T_p − T_0)/J_t. [Ports001, 6.5.2, derived]
    pub fn new(
        drive: &TurningDrive<C>,
        slip: &Option<SlipStart<C>>,
        inverter: &Option<InverterStart<C>>,
        motor: &TurningMotor<C>,
    ) -> HardestPush<C> {
        let (point, turning) = (drive.point(), C::constant(TAU) * motor.n);
        let torque = match (slip, inverter) {
            (Some(slip), _) => slip.most(&point, motor.n),
            (None, Some(inverter)) => inverter.asked(motor.against, motor.inertia * turning, &point),
            (None, None) => return HardestPush(None),
        };
        if motor.n.value() == 0.0 {
            return HardestPush(Some([C::constant(0.0).over(torque); 2]));
        }
        let torque = torque.def(&s::T_P);
        HardestPush(Some([
            torque,
            ((torque - motor.against) / motor.inertia).def(&s::ALPHA_P),
        ]))
    }

    /// Moment at the slewing axis that then accelerates all that slews, in N·m; of the mean torque where nothing else is known.
    pub fn moment(&self, drive: &TurningDrive<C>, turned: &TurningMoments<C>, motor: &TurningMotor<C>) -> C {
        match self.0 {
            Some([_, rate]) => turned.inertia * rate / drive.i,
            None => motor.moment,
        }
    }

    /// Torque behind the motor's own inertia in a start, in N·m: T_0 + (J_t − J_M) ω̇; of a case in which nothing slews T_0.
    pub fn behind(&self, drive: &TurningDrive<C>, motor: &TurningMotor<C>) -> C {
        if motor.n.value() > 0.0 {
            motor.against + self.torque(motor.inertia - drive.j, motor)
        } else {
            motor.against
        }
    }

    /// Torque that an inertia at the motor's shaft (kg·m²) takes then, in N·m.
    fn torque(&self, inertia: C, motor: &TurningMotor<C>) -> C {
        match self.0 {
            Some([_, rate]) => inertia * rate,
            None => inertia * (C::constant(TAU) * motor.n) / motor.time,
        }
    }
}

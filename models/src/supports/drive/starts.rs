//! Starts of a slewing motor by what it gives on the way, besides by its mean torque, and the greatest torque of each.

use std::f64::consts::TAU;

use crate::component::stages::{absent, results};
use crate::kernel::calc::Calc;
use crate::parts::starts::way::{StartWay, Started};
use crate::parts::starts::{RatedPoint, Starting, T_ID};
use crate::supports::drive::gear::TurningDrive;
use crate::supports::drive::inertia::Outswing;
use crate::supports::drive::motor::TurningMotor;
use crate::supports::drive::resistance::TurningMoments;
use crate::supports::drive::symbols as s;

impl<C: Calc> TurningDrive<C> {
    fn point(&self) -> RatedPoint<C> {
        RatedPoint::new(self.p_n, self.n_n)
    }
}

/// To the speed of the case.
fn starting<C: Calc>(drive: &TurningDrive<C>, swung: &Outswing<C>, motor: &TurningMotor<C>) -> Starting<C> {
    Starting {
        moves: motor.n.value() > 0.0,
        n: motor.n,
        against: motor.against,
        inertia: motor.inertia,
        own: drive.j,
        head: swung.reach.abs() * swung.omega,
    }
}

/// In the way that the scene names. [Ports001, 6.5.2 and 6.5.3]
pub fn started<C: Calc>(
    drive: &TurningDrive<C>,
    way: &StartWay<C>,
    swung: &Outswing<C>,
    motor: &TurningMotor<C>,
) -> Started<C> {
    Started::new(&drive.point(), way, &starting(drive, swung, motor))
}

/// What a start asks of all behind the motor at most: the motor's greatest torque on the way (N·m), and how it then quickens its
/// shaft (rad/s²); nothing where only the mean torque is known.
#[derive(Clone, Copy, Debug)]
pub struct HardestPush<C>(Option<[C; 2]>);
results! { each HardestPush as p => { T_P: p.0.ok_or_else(absent)?[0]; ALPHA_P: p.0.ok_or_else(absent)?[1]; } }

impl<C: Calc> HardestPush<C> {
    /// T_p = T(s) where that is greatest between the slip of the case and 1, the ramp's torque within the inverter's limit, or
    /// an engine's greatest from idle to the speed of the case; ω̇_p = (T_p − T_0)/J_t, or (T_id − T_0)/(J_t − J_M) while an
    /// engine's clutch slips, if that is more. [Ports001, 6.5.2, derived]
    pub fn new(drive: &TurningDrive<C>, way: &Option<StartWay<C>>, motor: &TurningMotor<C>) -> HardestPush<C> {
        let (point, turning) = (drive.point(), C::constant(TAU) * motor.n);
        let torque = match way {
            Some(StartWay::SlipStart(slip)) => slip.most(&point, motor.n),
            Some(StartWay::InverterStart(inverter)) => inverter.asked(motor.against, motor.inertia * turning, &point),
            Some(StartWay::EngineStart(engine)) => engine.most(motor.n),
            None => return HardestPush(None),
        };
        if motor.n.value() == 0.0 {
            return HardestPush(Some([C::constant(0.0).over(torque); 2]));
        }
        let torque = torque.def(&s::T_P);
        let mut rate = (torque - motor.against) / motor.inertia;
        if let Some(StartWay::EngineStart(engine)) = way {
            let idle = engine.at_idle().tabled(&T_ID);
            rate = rate.greater((idle - motor.against) / (motor.inertia - drive.j));
        }
        HardestPush(Some([torque, rate.def(&s::ALPHA_P)]))
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

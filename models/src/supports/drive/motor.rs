//! A slewing motor in a load case: steady slewing, start, heating.

use std::f64::consts::TAU;

use crate::component::stages::{Found, absent, results};
use crate::kernel::calc::Calc;
use crate::supports::drive::gear::TurningDrive;
use crate::supports::drive::given::{TurningCase, TurningChoice};
use crate::supports::drive::inertia::Outswing;
use crate::supports::drive::resistance::TurningMoments;
use crate::supports::drive::symbols as s;

/// At each motor's shaft: speed (1/s), torque (N·m) and power (W) against steady slewing, both ways' powers; inertia
/// (kg·m²), time (s) and acceleration of the head (m/s²) of a start, with its moment at the axis (N·m).
#[derive(Clone, Copy, Debug)]
pub struct TurningMotor<C> {
    pub n: C,
    pub against: C,
    pub power: C,
    used: C,
    ways: [C; 2],
    both: C,
    pub inertia: C,
    pub time: C,
    quickens: C,
    pub moment: C,
}
results! { each TurningMotor as m => {
    N_MOT: m.n;
    T_0: m.against;
    P_M: m.power;
    U_M: m.used;
    P_CCW: m.ways[0];
    P_CW: m.ways[1];
    P_LR: m.both;
    J_START: m.inertia;
    T_START: m.time;
    A_START: m.quickens;
    M_J: m.moment;
} }

impl<C: Calc> TurningMotor<C> {
    /// T_0 = M_st/(i z η), P_M = 2π n T_0, J_t = J_M + J/(i² z η), t = 2π n J_t/(k_a T_N − T_0). [Ports001, 6.5.2]
    pub fn new(
        drive: &TurningDrive<C>,
        work: &TurningCase<C>,
        turned: &TurningMoments<C>,
        swung: &Outswing<C>,
    ) -> TurningMotor<C> {
        let two = C::constant(2.0);
        let n = (work.n_s * drive.i).def(&s::N_MOT);
        let turning = C::constant(TAU) * n;
        let against = drive.torque(turned.steady).def(&s::T_0);
        let power = (against * turning).def(&s::P_M);
        let way = |outer: C| drive.torque(turned.inner(false) + outer) * turning;
        let ways = [way(-turned.outer).def(&s::P_CCW), way(turned.outer).def(&s::P_CW)];
        let inertia = (drive.j + turned.inertia / (drive.i.square() * drive.z * drive.eta)).def(&s::J_START);
        let spare = drive.k_a * drive.rated() - against;
        let time = if spare.value() > 0.0 {
            (inertia * turning / spare).def(&s::T_START)
        } else {
            C::known(&s::T_START, f64::INFINITY).over(spare)
        };
        let (quickens, moment) = if work.n_s.value() > 0.0 {
            let rate = swung.omega / time;
            (swung.reach.abs() * rate, turned.inertia * rate)
        } else {
            let none = C::constant(0.0).over(work.n_s);
            (none, none)
        };
        TurningMotor {
            n,
            against,
            power,
            used: (power / (drive.lambda * drive.p_n)).def(&s::U_M),
            ways,
            both: both(ways, two).def(&s::P_LR),
            inertia,
            time,
            quickens: quickens.def(&s::A_START),
            moment: moment.def(&s::M_J),
        }
    }
}

/// Root of the mean square of two.
fn both<C: Calc>([there, back]: [C; 2], two: C) -> C {
    let squares = there.square() + back.square();
    if squares.value() == 0.0 {
        return squares;
    }
    (squares / two).sqrt()
}

/// The case of the motors' heating at one slewing angle.
#[derive(Clone, Copy, Debug)]
pub struct TurningHeat<C> {
    power: C,
    used: C,
    slowness: C,
}
results! { TurningHeat as h => { P_HS: h.power; U_HS: h.used; TAU_S: h.slowness; } }

impl<C: Calc> TurningHeat<C> {
    /// # Errors
    /// A case in which nothing slews.
    pub fn new(
        drive: &TurningDrive<C>,
        choice: &TurningChoice,
        swung: &[Outswing<C>],
        motors: &[TurningMotor<C>],
    ) -> Found<TurningHeat<C>> {
        let (motor, rate) = motors
            .get(choice.heating)
            .zip(swung.get(choice.heating))
            .ok_or_else(absent)?;
        if rate.omega.value() == 0.0 {
            return Err(absent());
        }
        Ok(TurningHeat {
            power: motor.both,
            used: motor.both / drive.p_n,
            slowness: C::constant(1.0) / rate.omega,
        })
    }
}

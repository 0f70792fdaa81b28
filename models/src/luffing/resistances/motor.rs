//! The motor under what its drive overcomes in a case, and the starts that it makes.
//!
//! Between motor and drive is a gear with an efficiency: it costs where the motor drives, and helps where the load does.

use std::f64::consts::TAU;

use crate::component::stages::{Found, absent, results};
use crate::kernel::calc::Calc;
use crate::luffing::resistances::friction::Rubbed;
use crate::luffing::resistances::given::{Case, CaseMotor, CasesChoice};
use crate::luffing::resistances::moments::Resisted;
use crate::luffing::resistances::sums::Sums;
use crate::luffing::resistances::symbols as s;
use crate::parts::starts::RatedPoint;

impl<C: Calc> CaseMotor<C> {
    /// Travel of the drive for one radian of the motor, in m.
    pub fn arm(&self) -> C {
        self.l / C::constant(TAU)
    }

    /// Torque at the motor's shaft (N·m) for a force of the drive (N) at its speed. [Ports001, 5.3]
    pub fn torque(&self, force: C, speed: C) -> C {
        let free = force * self.arm();
        match force.value() * speed.value() {
            power if power > 0.0 => free / self.eta,
            power if power < 0.0 => free * self.eta,
            _ => free,
        }
    }

    /// Inertia at the motor's shaft (kg·m²) of the bodies, reduced to the luffing angle, with that of the motor.
    pub fn inertia(&self, sums: &Sums<C>, loss: C) -> C {
        self.j + sums.inertia[0] * (self.arm() / sums.way[0]).square() * loss
    }

    /// Rated torque, in N·m.
    pub fn rated(&self) -> C {
        RatedPoint::new(self.p_n, self.n_n).torque
    }
}

/// A case at the motor's shaft. Torques in N·m, positive where the drive presses its ends apart.
#[derive(Clone, Copy, Debug)]
pub struct Motored<C> {
    pub n: C,
    torque: C,
    power: C,
    used: C,
    both: C,
    /// Of steady motion, positive against it.
    pub against: C,
    /// Of all that a start accelerates, in kg·m².
    pub inertia: C,
    time: C,
    quickens: C,
}
results! { each Motored as m => {
    N_MOT: m.n;
    T_M: m.torque;
    P_M: m.power;
    U_M: m.used;
    P_C: m.both;
    T_0: m.against;
    J_START: m.inertia;
    T_START: m.time;
    A_START: m.quickens;
} }

impl<C: Calc> Motored<C> {
    /// Under the force of the drive (N). The way back has the same force but for friction, which is turned round.
    /// [Ports001, 5.6]
    pub fn new(
        motor: &CaseMotor<C>,
        sums: &Sums<C>,
        case: &Case<C>,
        resisted: &Resisted<C>,
        rubbed: &Rubbed<C>,
        force: &C,
    ) -> Motored<C> {
        let (two, zero) = (C::constant(2.0), C::constant(0.0));
        let n = (case.v / motor.l).def(&s::N_MOT);
        let turning = C::constant(TAU) * n;
        if case.v.value() == 0.0 {
            let torque = if force.value().is_finite() {
                motor.torque(*force, case.v).def(&s::T_M)
            } else {
                *force
            };
            return Motored {
                n,
                torque,
                power: zero,
                used: zero,
                both: zero,
                against: zero,
                inertia: zero,
                time: zero,
                quickens: zero,
            };
        }
        let torque = motor.torque(*force, case.v).def(&s::T_M);
        let power = (torque * turning).def(&s::P_M);
        let way = sums.way[0];
        let back = *force + two * rubbed.friction / way;
        let returning = motor.torque(back, -case.v) * turning;
        let both = ((power.square() + returning.square()) / two).sqrt().def(&s::P_C);
        let steady = (resisted.inertia - rubbed.sum) / way;
        let against = motor.torque(steady, case.v);
        let against = if case.v.value() < 0.0 { -against } else { against }.def(&s::T_0);
        let inertia = motor.inertia(sums, C::constant(1.0) / motor.eta).def(&s::J_START);
        let spare = motor.k_a * motor.rated() - against;
        let time = if spare.value() > 0.0 {
            (inertia * turning.abs() / spare).def(&s::T_START)
        } else {
            C::known(&s::T_START, f64::INFINITY).over(spare)
        };
        Motored {
            n,
            torque,
            power,
            used: (power / (motor.lambda * motor.p_n)).def(&s::U_M),
            both,
            against,
            inertia,
            time,
            quickens: ((sums.head.x * case.v / way).abs() / time).def(&s::A_START),
        }
    }
}

/// The case for which the motor's heating is asked, at one position of its cycle.
#[derive(Clone, Copy, Debug)]
pub struct Heating<C> {
    power: C,
    used: C,
    slowness: C,
    speed: C,
}
results! { Heating as h => {
    P_H: h.power;
    U_H: h.used;
    TAU_H: h.slowness;
    V_H_A: h.speed;
} }

impl<C: Calc> Heating<C> {
    /// # Errors
    /// A case in which nothing moves.
    pub fn new(
        motor: &CaseMotor<C>,
        sums: &Sums<C>,
        resisted: &[Resisted<C>],
        motored: &[Motored<C>],
        choice: &CasesChoice,
    ) -> Found<Heating<C>> {
        let case = choice.heating.ok_or_else(absent)?;
        let (rate, power) = (resisted[case].rate.abs(), motored[case].both);
        if rate.value() == 0.0 {
            return Err(absent());
        }
        Ok(Heating {
            power,
            used: power / motor.p_n,
            slowness: C::constant(1.0) / rate,
            speed: sums.head.x.abs() * rate,
        })
    }
}

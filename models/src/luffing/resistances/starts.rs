//! Starts of the motor from each position, against what the case asks for there.
//!
//! What the case asks for is that of the place where the start begins, as with a mean torque.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::luffing::resistances::given::{Case, CaseMotor};
use crate::luffing::resistances::motor::Motored;
use crate::luffing::resistances::sums::Sums;
use crate::parts::starts::inverter::Ramped;
use crate::parts::starts::slip::Slipped;
use crate::parts::starts::{self as s, InverterStart, RatedPoint, SlipStart, Starting};

// Of slewing motors too, which stand above.
results! { each Slipped as m => {
    S_K: m.at;
    T_BD: m.breakdown;
    S_F: m.slip;
    T_LEAST: m.least;
    I_S: m.spared;
    T_SLIP: m.time;
    A_SLIP: m.quickens;
} }

results! { each Ramped as m => {
    T_U: m.limit;
    T_RAMP: m.asked;
    T_INV: m.time;
    A_INV: m.quickens;
} }

impl<C: Calc> CaseMotor<C> {
    fn point(&self) -> RatedPoint<C> {
        RatedPoint {
            torque: self.rated(),
            n: self.n_n,
        }
    }
}

/// To the speed of the case.
fn starting<C: Calc>(sums: &Sums<C>, case: &Case<C>, motored: &Motored<C>) -> Starting<C> {
    Starting {
        moves: case.v.value() != 0.0,
        n: motored.n,
        against: motored.against,
        inertia: motored.inertia,
        head: (sums.head.x * case.v / sums.way[0]).abs(),
    }
}

/// Along the motor's slip curve. [Ports001, 5.6]
pub fn slipped<C: Calc>(
    motor: &CaseMotor<C>,
    start: &SlipStart<C>,
    sums: &Sums<C>,
    case: &Case<C>,
    motored: &Motored<C>,
) -> Slipped<C> {
    Slipped::new(&motor.point(), start, &starting(sums, case, motored))
}

/// On an inverter. [Ports001, 5.6]
pub fn ramped<C: Calc>(
    motor: &CaseMotor<C>,
    start: &InverterStart<C>,
    sums: &Sums<C>,
    case: &Case<C>,
    motored: &Motored<C>,
) -> Ramped<C> {
    Ramped::new(&motor.point(), start, &starting(sums, case, motored))
}

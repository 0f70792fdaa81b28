//! Starts of the motor from each position, against what the case asks for there.
//!
//! What the case asks for is that of the place where the start begins, as with a mean torque.

use crate::component::stages::{absent, results};
use crate::kernel::calc::Calc;
use crate::luffing::resistances::given::{Case, CaseMotor};
use crate::luffing::resistances::motor::Motored;
use crate::luffing::resistances::sums::Sums;
use crate::parts::starts::way::{StartWay, Started};
use crate::parts::starts::{self as s, RatedPoint, Starting};

// Of slewing motors too, which stand above.
results! { each Started as m => {
    S_K: m.slipped().ok_or_else(absent)?.at;
    T_BD: m.slipped().ok_or_else(absent)?.breakdown;
    S_F: m.slipped().ok_or_else(absent)?.slip;
    T_LEAST: m.slipped().ok_or_else(absent)?.least;
    I_S: m.slipped().ok_or_else(absent)?.spared;
    T_SLIP: m.slipped().ok_or_else(absent)?.time;
    A_SLIP: m.slipped().ok_or_else(absent)?.quickens;
    T_U: m.ramped().ok_or_else(absent)?.limit;
    T_RAMP: m.ramped().ok_or_else(absent)?.asked;
    T_INV: m.ramped().ok_or_else(absent)?.time;
    A_INV: m.ramped().ok_or_else(absent)?.quickens;
    T_E_MAX: m.engined().ok_or_else(absent)?.peak;
    K_E: m.engined().ok_or_else(absent)?.reserve;
    T_ID: m.engined().ok_or_else(absent)?.idle;
    T_E_LEAST: m.engined().ok_or_else(absent)?.least;
    T_CL: m.engined().ok_or_else(absent)?.clutch;
    I_E: m.engined().ok_or_else(absent)?.spared;
    T_ENG: m.engined().ok_or_else(absent)?.time;
    A_ENG: m.engined().ok_or_else(absent)?.quickens;
} }

impl<C: Calc> CaseMotor<C> {
    pub(super) fn point(&self) -> RatedPoint<C> {
        RatedPoint::new(self.p_n, self.n_n)
    }
}

/// To the speed of the case.
fn starting<C: Calc>(motor: &CaseMotor<C>, sums: &Sums<C>, case: &Case<C>, motored: &Motored<C>) -> Starting<C> {
    Starting {
        moves: case.v.value() != 0.0,
        n: motored.n,
        against: motored.against,
        inertia: motored.inertia,
        own: motor.j,
        head: (sums.head.x * case.v / sums.way[0]).abs(),
    }
}

/// In the way that the scene names. [Ports001, 5.6]
pub fn started<C: Calc>(
    motor: &CaseMotor<C>,
    way: &StartWay<C>,
    sums: &Sums<C>,
    case: &Case<C>,
    motored: &Motored<C>,
) -> Started<C> {
    Started::new(&motor.point(), way, &starting(motor, sums, case, motored))
}

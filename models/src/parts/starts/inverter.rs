//! Starts of the motor on an inverter, which ramps its speed up under a limit of its torque.

use std::f64::consts::TAU;

use crate::kernel::calc::Calc;
use crate::parts::starts::{self as s, InverterStart, RatedPoint, Starting};

impl<C: Calc> InverterStart<C> {
    /// Torque (N·m) of a start against a torque (N·m) to an angular momentum (N·m·s): that of the ramp, within the limit.
    pub fn asked(&self, against: C, momentum: C, rated: &RatedPoint<C>) -> C {
        (against + momentum / self.time).smaller(self.lambda * rated.torque)
    }
}

/// A start on an inverter.
#[derive(Clone, Copy, Debug)]
pub struct Ramped<C> {
    pub limit: C,
    pub asked: C,
    pub time: C,
    pub quickens: C,
}

impl<C: Calc> Ramped<C> {
    /// T = T_0 + J ω / t_r as far as the limit of the inverter allows it; where that is less, t = J ω / (T − T_0) with it.
    /// [Ports001, 5.6, derived]
    pub fn new(rated: &RatedPoint<C>, start: &InverterStart<C>, run: &Starting<C>) -> Ramped<C> {
        let none = C::constant(0.0);
        let limit = (start.lambda * rated.torque).def(&s::T_U);
        if !run.moves {
            return Ramped {
                limit,
                asked: none,
                time: none,
                quickens: none,
            };
        }
        let momentum = run.inertia * (C::constant(TAU) * run.n).abs();
        let asked = (run.against + momentum / start.time).def(&s::T_RAMP);
        let spare = limit - run.against;
        let time = if spare.value() <= 0.0 {
            C::known(&s::T_INV, f64::INFINITY).over(spare)
        } else if asked.value() > limit.value() {
            (momentum / spare).def(&s::T_INV)
        } else {
            start.time.over(asked).def(&s::T_INV)
        };
        let quickens = (run.head / time).def(&s::A_INV);
        Ramped {
            limit,
            asked,
            time,
            quickens,
        }
    }
}

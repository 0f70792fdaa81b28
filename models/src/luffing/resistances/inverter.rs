//! Starts of the motor on an inverter, which ramps its speed up under a limit of its torque.

use std::f64::consts::TAU;

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::luffing::resistances::given::{Case, CaseMotor, InverterStart};
use crate::luffing::resistances::motor::Motored;
use crate::luffing::resistances::sums::Sums;
use crate::luffing::resistances::symbols as s;

/// A start on an inverter.
#[derive(Clone, Copy, Debug)]
pub struct Ramped<C> {
    limit: C,
    asked: C,
    time: C,
    quickens: C,
}
results! { each Ramped as m => {
    T_LIM: m.limit;
    T_RAMP: m.asked;
    T_INV: m.time;
    A_INV: m.quickens;
} }

impl<C: Calc> Ramped<C> {
    /// T = T_0 + J ω / t_r as far as the limit of the inverter allows it; where that is less, t = J ω / (T − T_0) with it.
    /// [Ports001, 5.6, derived]
    pub fn new(
        motor: &CaseMotor<C>,
        start: &InverterStart<C>,
        sums: &Sums<C>,
        case: &Case<C>,
        motored: &Motored<C>,
    ) -> Ramped<C> {
        let none = C::constant(0.0);
        let limit = (start.lambda * motor.rated()).def(&s::T_LIM);
        if case.v.value() == 0.0 {
            return Ramped {
                limit,
                asked: none,
                time: none,
                quickens: none,
            };
        }
        let momentum = motored.inertia * (C::constant(TAU) * motored.n).abs();
        let asked = (motored.against + momentum / start.time).def(&s::T_RAMP);
        let spare = limit - motored.against;
        let time = if spare.value() <= 0.0 {
            C::known(&s::T_INV, f64::INFINITY).over(spare)
        } else if asked.value() > limit.value() {
            (momentum / spare).def(&s::T_INV)
        } else {
            start.time.over(asked).def(&s::T_INV)
        };
        let quickens = ((sums.head.x * case.v / sums.way[0]).abs() / time).def(&s::A_INV);
        Ramped {
            limit,
            asked,
            time,
            quickens,
        }
    }
}

//! The grab as it sways: on parallel ropes a simple pendulum under the trolley, which goes from ship to hopper.

use std::f64::consts::TAU;

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::{One, quantities};
use crate::sway::pendulum::{Damped, Feedback, HungLoad, SwayingLoad, Swung};
use crate::sway::starts::Start;
use crate::unloader::symbols as s;
use crate::unloader::trolley::GrabCommand;

quantities! {
    /// The way from ship to hopper: speed (m/s), acceleration (m/s²), its length (m).
    GrabWay { v: V_M, a: A_M, s: S_M }
}

quantities! {
    /// Where the trolley is, in m.
    GrabPlace { x: X_T }
}

/// Small sway: frequency (rad/s) and period (s), what hangs back steadily (rad), what a plain start leaves of it (rad), times of the
/// way, plain and programmed (s).
#[derive(Clone, Copy, Debug)]
pub struct SwayOnWay<C> {
    frequency: C,
    period: C,
    steady: C,
    left: C,
    times: [C; 2],
}
results! { SwayOnWay as w => {
    OMEGA_G: w.frequency;
    T_G: w.period;
    PHI_ST: w.steady;
    RHO_PL: w.left;
    T_PL: w.times[0];
    T_PR: w.times[1];
} }

impl<C: Calc> SwayOnWay<C> {
    /// ω = √(g/l), φ_st = a/g, ρ = 2 φ_st |sin(ω v/(2 a))|; t = s/v + v/a, and by sixths of the period s/v + v/a + T/3.
    /// [linear oscillator; Ports001, 5.10]
    pub fn new(way: &GrabWay<C>, load: &SwayingLoad<C>, gravity: &One<C>) -> SwayOnWay<C> {
        let frequency = (**gravity / load.l).sqrt().def(&s::OMEGA_G);
        let period = (C::constant(TAU) / frequency).def(&s::T_G);
        let steady = (way.a / **gravity).def(&s::PHI_ST);
        let start = way.v / way.a;
        let swings = (frequency * start / C::constant(2.0)).sin().abs();
        let [_, lasts] = Start::Sixths.timed([way.v, way.a], period);
        SwayOnWay {
            frequency,
            period,
            steady,
            left: (steady.scaled(2.0) * swings).def(&s::RHO_PL),
            times: [
                (way.s / way.v + start).def(&s::T_PL),
                (way.s / way.v + lasts).def(&s::T_PR),
            ],
        }
    }
}

/// Small sway of the grab under feedback.
pub fn damped<C: Calc>(feedback: &Feedback<C>, on_way: &SwayOnWay<C>) -> Damped<C> {
    Damped::new(feedback, on_way.frequency, None)
}

/// What the trolley is told, and what it answers to the sway, in m/s².
pub fn answer<C: Calc>(
    feedback: &Feedback<C>,
    load: &SwayingLoad<C>,
    command: &GrabCommand<C>,
    rate: &One<C>,
    gravity: &One<C>,
) -> C {
    feedback.answer(**rate, load, **gravity, [load.l, -command.v_h])
}

/// The trolley follows: rates of its speed and of its place.
#[derive(Clone, Copy, Debug)]
pub struct GrabTravel<C>([C; 2]);
results! { GrabTravel as t => { D_V_T: t.0[0]; D_X_T: t.0[1]; } }

/// With its acceleration (m/s²) and speed (m/s), from where it is.
pub fn travels<C: Calc>(_: &GrabPlace<C>, speed: &One<C>, answer: &C) -> GrabTravel<C> {
    GrabTravel([*answer, **speed])
}

/// The grab as it sways.
pub fn swung<C: Calc>(
    load: &SwayingLoad<C>,
    place: &GrabPlace<C>,
    command: &GrabCommand<C>,
    gravity: &One<C>,
    weight: &C,
    answer: &C,
) -> Swung<C> {
    let pendulum = HungLoad {
        length: load.l,
        slope: C::constant(1.0),
        felt: C::constant(1.0),
        deep: load.l,
    };
    Swung::new(load, [*answer, command.v_h], gravity, place.x, *weight, &pendulum)
}

//! The time of a cycle, and starts of the trolley that leave no sway, in closed form for small sway.
//!
//! A step of the acceleration by Δa at a time t leaves a sway Δa/g about the vertical that goes round with ω: what a start
//! leaves is the sum of its steps, as arrows that are turned by ω t. All starts are as forward as backward in time, so that
//! the sum is real about their middle.

use crate::bridge::suspension::Suspended;
use crate::bridge::symbols as s;
use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::course::{Between, Course};
use crate::kernel::group::{One, quantities};

quantities! {
    /// A start and the way: speed (m/s), acceleration (m/s²), way (m), time of a cycle besides it (s).
    TravelProfile { v_c: V_C, a_c: A_C, s_c: S_C, t_e: T_E }
}

/// Times of the way and of a cycle, in s.
#[derive(Clone, Copy, Debug)]
pub struct CycleTime<C>([C; 2]);
results! { CycleTime as c => { T_TR: c.0[0]; T_CYC: c.0[1]; } }

impl<C: Calc> CycleTime<C> {
    /// t_tr = s/v + v/a; 2 √(s/a) of a way too short for the speed; t_cyc = 2 t_tr + t_e.
    pub fn new(profile: &TravelProfile<C>) -> CycleTime<C> {
        let TravelProfile { v_c, a_c, s_c, t_e } = *profile;
        let long = s_c.value() * a_c.value() >= v_c.value() * v_c.value();
        let way = match long {
            true => s_c / v_c + v_c / a_c,
            false => (s_c / a_c).sqrt().scaled(2.0).over(v_c),
        };
        let way = way.def(&s::T_TR);
        CycleTime([way, (way.scaled(2.0) + t_e).def(&s::T_CYC)])
    }
}

/// A start that leaves no sway where it is made for its period.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Start {
    /// One pulse as long as the period.
    Pulse,
    /// Two equal pulses half a period apart.
    TwoPulses,
    /// On, off and on again by sixths of the period, and its mirror.
    Sixths,
}

impl Start {
    pub const ALL: [Start; 3] = [Start::Pulse, Start::TwoPulses, Start::Sixths];

    /// Acceleration (m/s²) and duration (s) for a period (s): v/T and T; a_c and v/a_c + T/2; at most a_c, and v/a + T/3.
    pub fn timed<C: Calc>(self, profile: &TravelProfile<C>, period: C) -> [C; 2] {
        let TravelProfile { v_c, a_c, .. } = *profile;
        match self {
            Start::Pulse => [v_c / period, period],
            Start::TwoPulses => [a_c, v_c / a_c + period.scaled(0.5)],
            Start::Sixths => {
                let rate = a_c.smaller(v_c.scaled(3.0) / period);
                [rate, v_c / rate + period / C::constant(3.0)]
            }
        }
    }

    /// Greatest sway over that which hangs back steadily, at its own period (s): 2; sin(π τ/T), one from half a period on; 1.
    pub fn greatest<C: Calc>(self, profile: &TravelProfile<C>, frequency: C, period: C) -> C {
        let TravelProfile { v_c, a_c, .. } = *profile;
        match self {
            Start::Pulse => C::constant(2.0),
            Start::TwoPulses => {
                let half = (v_c / a_c).scaled(0.5).smaller(period.scaled(0.25));
                (frequency * half).sin()
            }
            Start::Sixths => C::constant(1.0),
        }
    }

    /// What is left over that which hangs back steadily, at a frequency (rad/s), of a start made for a period (s):
    /// 2|sin(ω T/2)|; 2|sin(ω τ/2) cos(ω T/4)|; 2|sin(ω τ/2)(2 cos(ω T/6) − 1)|, with τ = v/a.
    pub fn left<C: Calc>(self, profile: &TravelProfile<C>, frequency: C, period: C) -> C {
        let [rate, _] = self.timed(profile, period);
        let sine = |time: C| (frequency * time.scaled(0.5)).sin();
        let cosine = |part: f64| (frequency * period / C::constant(part)).sin_cos().1;
        let sum = match self {
            Start::Pulse => sine(period),
            Start::TwoPulses => sine(profile.v_c / rate) * cosine(4.0),
            Start::Sixths => sine(profile.v_c / rate) * (cosine(6.0).scaled(2.0) - C::constant(1.0)),
        };
        sum.scaled(2.0).abs()
    }

    /// The acceleration over time, in m/s².
    #[must_use]
    pub fn course(self, profile: &TravelProfile<f64>, period: f64) -> Course {
        let [rate, lasts] = self.timed(profile, period);
        let sixth = period / 6.0;
        let rows = match self {
            Start::Pulse => vec![[0.0, rate], [lasts, 0.0]],
            // What comes before the first row is as that one.
            Start::TwoPulses => vec![[-period, 0.0], [0.0, rate], [profile.v_c / rate, 0.0]],
            Start::Sixths => {
                let [on, off] = [[2.0 * sixth, rate], [lasts - 2.0 * sixth, 0.0]];
                let middle = (off[0] > on[0]).then_some([on, off]).into_iter().flatten();
                let [first, last] = [[[0.0, rate], [sixth, 0.0]], [[lasts - sixth, rate], [lasts, 0.0]]];
                first.into_iter().chain(middle).chain(last).collect()
            }
        };
        let mut course = Course {
            rows,
            between: Between::Steps,
            shaped: None,
        };
        if self == Start::TwoPulses {
            course = course.shaped(period);
            course.rows.retain(|[time, _]| *time >= 0.0);
        }
        course
    }
}

/// The three starts: acceleration (m/s²), duration (s), greatest sway and what is left of it for the simple pendulum's period
/// (rad).
#[derive(Clone, Copy, Debug)]
pub struct Profiles<C>([[C; 4]; 3]);
results! { Profiles as p => {
    A_P1: p.0[0][0];
    T_P1: p.0[0][1];
    PHI_P1: p.0[0][2];
    RHO_P1: p.0[0][3];
    A_P2: p.0[1][0];
    T_P2: p.0[1][1];
    PHI_P2: p.0[1][2];
    RHO_P2: p.0[1][3];
    A_P3: p.0[2][0];
    T_P3: p.0[2][1];
    PHI_P3: p.0[2][2];
    RHO_P3: p.0[2][3];
} }

impl<C: Calc> Profiles<C> {
    /// Greatest and left sway, each times what hangs back steadily: ν_x a/g. [linear oscillator]
    pub fn new(profile: &TravelProfile<C>, gravity: &One<C>, hanging: &Suspended<C>) -> Profiles<C> {
        let names = [
            [&s::A_P1, &s::T_P1, &s::PHI_P1, &s::RHO_P1],
            [&s::A_P2, &s::T_P2, &s::PHI_P2, &s::RHO_P2],
            [&s::A_P3, &s::T_P3, &s::PHI_P3, &s::RHO_P3],
        ];
        Profiles(std::array::from_fn(|i| {
            let (start, [a, t, phi, rho]) = (Start::ALL[i], names[i]);
            let [rate, lasts] = start.timed(profile, hanging.period);
            let [rate, lasts] = [rate.def(a), lasts.def(t)];
            let steady = |rate: C| hanging.felt * rate / **gravity;
            let [slow, _] = start.timed(profile, hanging.simple_period);
            let left = start.left(profile, hanging.frequency, hanging.simple_period);
            [
                rate,
                lasts,
                (steady(rate) * start.greatest(profile, hanging.frequency, hanging.period)).def(phi),
                (steady(slow) * left).def(rho),
            ]
        }))
    }
}

//! Starts of a trolley that leave no sway, in closed form for small sway.
//!
//! A step of the acceleration by Δa at a time t leaves a sway Δa/g about the vertical that goes round with ω: what a start
//! leaves is the sum of its steps, as arrows that are turned by ω t. All starts are as forward as backward in time, so that
//! the sum is real about their middle.

use crate::kernel::calc::Calc;
use crate::kernel::course::{Between, Course};

/// A start that leaves no sway where it is made for its period.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Start {
    /// One pulse as long as the period.
    Pulse,
    /// Two equal pulses half a period apart.
    TwoPulses,
    /// On, off and on again by sixths of the period, and its mirror.
    Sixths,
    /// A quarter, a half and a quarter of the acceleration, half a period apart each: two equal pulses of two equal pulses.
    Robust,
}

impl Start {
    pub const ALL: [Start; 4] = [Start::Pulse, Start::TwoPulses, Start::Sixths, Start::Robust];

    /// Acceleration (m/s²) and duration (s) of a start to a speed (m/s) by an acceleration (m/s²), for a period (s): v/T and T;
    /// a_c and v/a_c + T/2; at most a_c, and v/a + T/3; a_c and v/a_c + T.
    pub fn timed<C: Calc>(self, [v_c, a_c]: [C; 2], period: C) -> [C; 2] {
        match self {
            Start::Pulse => [v_c / period, period],
            Start::TwoPulses => [a_c, v_c / a_c + period.scaled(0.5)],
            Start::Sixths => {
                let rate = a_c.smaller(v_c.scaled(3.0) / period);
                [rate, v_c / rate + period / C::constant(3.0)]
            }
            Start::Robust => [a_c, v_c / a_c + period],
        }
    }

    /// Greatest sway over that which hangs back steadily, at its own period (s): 2; sin(π τ/T), one from half a period on; 1;
    /// sin(π τ/T)/2, from half a period on (1 − cos(π τ/T))/2, one from a period on.
    pub fn greatest<C: Calc>(self, [v_c, a_c]: [C; 2], frequency: C, period: C) -> C {
        match self {
            Start::Pulse => C::constant(2.0),
            Start::TwoPulses => {
                let half = (v_c / a_c).scaled(0.5).smaller(period.scaled(0.25));
                (frequency * half).sin()
            }
            Start::Sixths => C::constant(1.0),
            Start::Robust => {
                let half = (v_c / a_c).smaller(period).scaled(0.5);
                let (sin, cos) = (frequency * half).sin_cos();
                let whole = match half.value() < 0.25 * period.value() {
                    true => sin,
                    false => C::constant(1.0) - cos,
                };
                whole.scaled(0.5)
            }
        }
    }

    /// What is left over that which hangs back steadily, at a frequency (rad/s), of a start made for a period (s):
    /// 2|sin(ω T/2)|; 2|sin(ω τ/2) cos(ω T/4)|; 2|sin(ω τ/2)(2 cos(ω T/6) − 1)|;
    /// 2|sin(ω τ/2)| cos²(ω T/4), with τ = v/a.
    pub fn left<C: Calc>(self, told: [C; 2], frequency: C, period: C) -> C {
        let [rate, _] = self.timed(told, period);
        let sine = |time: C| (frequency * time.scaled(0.5)).sin();
        let cosine = |part: f64| (frequency * period / C::constant(part)).sin_cos().1;
        let sum = match self {
            Start::Pulse => sine(period),
            Start::TwoPulses => sine(told[0] / rate) * cosine(4.0),
            Start::Sixths => sine(told[0] / rate) * (cosine(6.0).scaled(2.0) - C::constant(1.0)),
            Start::Robust => sine(told[0] / rate) * cosine(4.0).square(),
        };
        sum.scaled(2.0).abs()
    }

    /// The acceleration over time, in m/s².
    #[must_use]
    pub fn course(self, told: [f64; 2], period: f64) -> Course {
        let [rate, lasts] = self.timed(told, period);
        let sixth = period / 6.0;
        let rows = match self {
            Start::Pulse => vec![[0.0, rate], [lasts, 0.0]],
            Start::TwoPulses => return pulses(told, &[period], 2),
            Start::Robust => return pulses(told, &[period], 3),
            Start::Sixths => {
                let [on, off] = [[2.0 * sixth, rate], [lasts - 2.0 * sixth, 0.0]];
                let middle = (off[0] > on[0]).then_some([on, off]).into_iter().flatten();
                let [first, last] = [[[0.0, rate], [sixth, 0.0]], [[lasts - sixth, rate], [lasts, 0.0]]];
                first.into_iter().chain(middle).chain(last).collect()
            }
        };
        steps(rows)
    }
}

fn steps(rows: Vec<[f64; 2]>) -> Course {
    Course {
        rows,
        between: Between::Steps,
        shaped: None,
    }
}

/// A start to a speed (m/s) by an acceleration (m/s²), shaped against periods (s) in so many pulses.
fn pulses([v_c, a_c]: [f64; 2], periods: &[f64], count: u64) -> Course {
    let late = periods.iter().sum::<f64>() * count as f64;
    // What comes before the first row is as that one.
    let plain = steps(vec![[-late, 0.0], [0.0, a_c], [v_c / a_c, 0.0]]);
    let mut course = plain.shaped(periods, count);
    course.rows.retain(|[time, _]| *time >= 0.0);
    course
}

/// A start in two equal pulses against each of two swings: what the one of their periods (s) leaves the other halves again.
#[must_use]
pub fn against_both(told: [f64; 2], periods: [f64; 2]) -> Course {
    pulses(told, &periods, 2)
}

/// What that leaves over what hangs back steadily, at a frequency (rad/s): 2|sin(ω τ/2) cos(ω T_1/4) cos(ω T_2/4)|.
#[must_use]
pub fn left_by_both<C: Calc>(told: [C; 2], frequency: C, [one, other]: [C; 2]) -> C {
    let (_, cos) = (frequency * other.scaled(0.25)).sin_cos();
    Start::TwoPulses.left(told, frequency, one) * cos.abs()
}

//! Four-bars of 1 m in a row: IFToMM benchmark A02.

#![allow(dead_code, reason = "not every test uses all of it")]

use lemnis_models::kernel::calc::Calc;
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::kernel::unit;
use lemnis_models::parts::closure::Closure;
use lemnis_models::parts::four_bar::{Branch, FourBar, Names};
use lemnis_models::parts::plane::Point;
use lemnis_models::parts::solver::runge_kutta;
use num_dual::Dual2_64;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

static ANY: Symbol = Symbol::new("x", "x", [&unit::M, &unit::M], "A length.", "given");

pub static NAMES: Names = Names {
    frame: &ANY,
    frame_angle: &ANY,
    stretched: [&ANY; 2],
    folded: [&ANY; 2],
    crank: [&ANY; 2],
    diagonal: [&ANY; 2],
    diagonal_length: &ANY,
    stretched_margin: &ANY,
    folded_margin: &ANY,
    area: &ANY,
    follower: [&ANY; 2],
    coupler: [&ANY; 2],
};

/// Of bars and frame with these lengths, in m.
pub fn linkage<C: Calc>([crank, coupler, follower, frame]: [f64; 4], branch: Branch) -> FourBar<C> {
    let bars = [crank, coupler, follower].map(C::constant);
    let frame = Point::new(C::constant(frame), C::constant(0.0));
    FourBar::new(bars, frame, branch, &NAMES).expect("closes")
}

/// Windows in a row: every window's follower is the next one's crank.
pub struct Row {
    windows: usize,
    linkage: FourBar<Dual2_64>,
}

impl Row {
    #[must_use]
    pub fn new(windows: usize) -> Row {
        Row {
            windows,
            linkage: linkage([1.0; 4], Branch::Left),
        }
    }

    /// Acceleration of the first bar (rad/s²), at its angle from the horizontal (rad) and rate (rad/s).
    fn acceleration(&self, theta: f64, omega: f64) -> Option<f64> {
        let mut angle = Dual2_64::new(theta, 1.0, 0.0);
        let (mut inertia, mut slope, mut moment) = (0.0, 0.0, 0.0);
        let mut bar = |centre: Point<Dual2_64>, along: Point<Dual2_64>| {
            let (d, dd) = (centre.map(|x| x.v1), centre.map(|x| x.v2));
            let (turn, turned) = (along.map(|x| x.v1), along.map(|x| x.v2));
            inertia += d.norm_squared() + turn.norm_squared() / 12.0;
            slope += 2.0 * (d.dot(&dd) + turn.dot(&turned) / 12.0);
            moment += 9.81 * d.y;
        };
        for _ in 0..self.windows {
            let Closure {
                crank,
                coupler,
                follower,
                ..
            } = Closure::new(&self.linkage, angle, &NAMES)?;
            let half = Dual2_64::from_re(0.5);
            bar(crank * half, crank);
            bar(crank + coupler * half, coupler);
            let next = Dual2_64::direction(follower.x, follower.y);
            angle = next + Dual2_64::from_re(TAU * ((angle.re - next.re) / TAU).round());
        }
        let (sin, cos) = Calc::sin_cos(angle);
        let last = Point::new(cos, sin);
        bar(last * Dual2_64::from_re(0.5), last);
        Some((-moment - 0.5 * slope * omega * omega) / inertia)
    }

    /// 20 s from upright with 1 m/s: the angle turned through (rad), and how often bars were in one line.
    #[must_use]
    pub fn run(&self, steps: u32) -> (f64, u32) {
        let h = 20.0 / f64::from(steps);
        // Rising to the rear: the first metre per second goes to the left.
        let (mut y, mut passages) = ([FRAC_PI_2, 1.0], 0);
        for _ in 0..steps {
            let before = y[0];
            y = runge_kutta::step(&y, h, |y| Some([y[1], self.acceleration(y[0], y[1])?])).expect("closes");
            passages += u32::from((before / PI).floor() != (y[0] / PI).floor());
        }
        (y[0] - FRAC_PI_2, passages)
    }
}

/// phi(20 s) in rad for N = 2 and N = 40.
pub const REFERENCE: [f64; 2] = [63.828_669_393_146_12, 63.255_295_368_190_93];

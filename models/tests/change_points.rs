//! IFToMM benchmark A02: N four-bars of 1 m in a row, bars of 1 kg, g = 9.81, started upright with
//! 1 m/s, for 20 s through all their change points, where the branches of every window meet.
//!
//! References: `tests/oracles/four_bars.py`, Legendre's integral with 50 digits.

use lemnis_models::calc::Calc;
use lemnis_models::four_bar::{Branch, Closure, FourBar, Names};
use lemnis_models::plane::Point;
use lemnis_models::solver::runge_kutta;
use lemnis_models::symbol::Symbol;
use lemnis_models::unit;
use num_dual::Dual2_64;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

static ANY: Symbol = Symbol {
    id: "x",
    print: "x",
    unit: &unit::M,
    display: &unit::M,
    text: "A length.",
    source: "given",
};

static NAMES: Names = Names {
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

fn linkage<C: Calc>([crank, coupler, follower, frame]: [f64; 4], branch: Branch) -> FourBar<C> {
    let bars = [crank, coupler, follower].map(C::constant);
    let frame = Point::new(C::constant(frame), C::constant(0.0));
    FourBar::new(bars, frame, branch, &NAMES).expect("closes")
}

/// Windows in a row: every window's follower is the next one's crank.
struct Row {
    windows: usize,
    linkage: FourBar<Dual2_64>,
}

impl Row {
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
            } = self.linkage.close(angle, &NAMES)?;
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

    fn run(&self, steps: u32) -> (f64, u32) {
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

#[test]
fn benchmark_a02_agrees_with_its_closed_form() {
    for (windows, reference, steps) in [(2, REFERENCE[0], 20_000), (40, REFERENCE[1], 20_000)] {
        let row = Row {
            windows,
            linkage: linkage([1.0; 4], Branch::Left),
        };
        let (angle, passages) = row.run(steps);
        // The free end of the first bar, in m: its error is that of the angle times 1 m.
        let error = (angle - reference).abs();
        println!("N = {windows}: phi(20 s) = {angle}, {passages} passages, error {error:.1e}");
        assert_eq!(passages, 20, "half turns, each through a singular position");
        assert!(error <= 1e-6, "N = {windows}: {angle} {reference}");
    }
}

/// phi(20 s) in rad for N = 2 and N = 40.
const REFERENCE: [f64; 2] = [63.828_669_393_146_12, 63.255_295_368_190_93];

/// In a change point itself, and on both sides of it, the bars and their derivatives are those of the
/// branch: with parallel bars follower and crank move alike; the crossed linkage mirrors there.
#[test]
fn the_branch_is_kept_exactly_in_a_change_point() {
    for turns in [0.0, 1.0, -3.0, 1e3] {
        for offset in [0.0, 1e-300, 1e-15, -1e-15, 1e-8, -1e-3, 0.1] {
            for bars in [[1.0; 4], [2.0, 5.0, 2.0, 5.0]] {
                let theta = Dual2_64::new(turns * PI + offset, 1.0, 0.0);
                let parallel = linkage::<Dual2_64>(bars, Branch::Left)
                    .close(theta, &NAMES)
                    .expect("closes");
                assert_eq!(parallel.follower, parallel.crank);
                assert_eq!((parallel.coupler.x.re, parallel.coupler.y.re), (bars[3], 0.0));
            }
            // Crossed: the coupler turns against the crank, twice in one turn through the frame's line.
            let bars = [2.0, 5.0, 2.0, 5.0];
            let theta = Dual2_64::new(turns * PI + offset, 1.0, 0.0);
            let crossed = linkage::<Dual2_64>(bars, Branch::Right)
                .close(theta, &NAMES)
                .expect("closes");
            let lengths = [crossed.coupler, crossed.follower].map(|v| v.map(|x| x.re).norm());
            assert!(
                (lengths[0] - 5.0).abs() < 1e-14 && (lengths[1] - 2.0).abs() < 1e-14,
                "{lengths:?}"
            );
            // Velocity of K along both bars vanishes: K stays on its circles.
            let loop_speed = [crossed.coupler, crossed.follower].map(|v| v.map(|x| x.re).dot(&v.map(|x| x.v1)).abs());
            assert!(loop_speed.iter().all(|x| *x < 1e-12), "{loop_speed:?}");
            let turn = crossed.follower.map(|x| x.v1).norm();
            assert!(turn > 0.5 && turn.is_finite(), "{turns} {offset}: {turn}");
        }
    }
}

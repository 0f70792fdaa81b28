//! IFToMM benchmark A02: N four-bars of 1 m in a row, bars of 1 kg, g = 9.81, started upright with
//! 1 m/s, for 20 s through all their change points, where the branches of every window meet.
//!
//! References: `tests/oracles/four_bars.py`, Legendre's integral with 50 digits.

use lemnis_models::four_bar::Branch;
use num_dual::Dual2_64;
use std::f64::consts::PI;

use four_bars::{NAMES, REFERENCE, Row, linkage};

#[path = "common/four_bars.rs"]
mod four_bars;

#[test]
fn benchmark_a02_agrees_with_its_closed_form() {
    for (windows, reference, steps) in [(2, REFERENCE[0], 20_000), (40, REFERENCE[1], 20_000)] {
        let (angle, passages) = Row::new(windows).run(steps);
        // The free end of the first bar, in m: its error is that of the angle times 1 m.
        let error = (angle - reference).abs();
        println!("N = {windows}: phi(20 s) = {angle}, {passages} passages, error {error:.1e}");
        assert_eq!(passages, 20, "half turns, each through a singular position");
        assert!(error <= 1e-6, "N = {windows}: {angle} {reference}");
    }
}

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

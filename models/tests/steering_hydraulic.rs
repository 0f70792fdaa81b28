//! Eight steering cylinders under the PLC's control loop, against an independent code
//! (`tests/oracles/steering_hydraulics.py`), and their cost.

use std::f64::consts::TAU;
use std::time::Instant;

use lemnis_models::hydraulics::cylinder::Cylinder;
use lemnis_models::hydraulics::valve::Valve;
use lemnis_models::solver::rodas::Tolerance;
use lemnis_models::steering::cylinder;
use lemnis_models::steering::hydraulic::{Control, Group, Steered};

const ORACLE: &str = include_str!("../../tests/oracles/steering_hydraulics.csv");

const CONTROL: Control = Control {
    period: 0.01,
    resolution: TAU / 8192.0,
    gains: [12.0, 3.0],
};

fn steered(group: usize) -> Steered {
    let linkage = cylinder::Cylinder {
        r: 0.5,
        alpha: 0.3,
        l_x: 0.9,
        l_a: 0.4,
    };
    let group = Group {
        linkage: linkage.linkage(group >= 4),
        cylinder: Cylinder {
            areas: Cylinder::areas(0.125, 0.07),
            lengths: [1.3, 2.2],
            dead_volume: 5e-4,
            port_volume: 1e-4,
            line: Valve::rated(1.5e-3, 2e5),
            leakage: 1e-13,
            bulk_modulus: 1.4e9,
            relief: [250e5, 1e-9],
            valve: Valve {
                conductance: Valve::rated(1.5e-3, 35e5),
                frequency: 300.0,
                damping: 0.7,
            },
        },
        inertia: 3000.0,
        resistance: 8e3 + 1e3 * group as f64,
        supply: 200e5,
        command: 0.0,
    };
    Steered::new(group, CONTROL, 0.0, 20e5)
}

/// Ramps to a different angle for every group, in rad; back from 2 s on.
fn wanted(group: usize, t: f64) -> f64 {
    let last = [30.0_f64, 22.0, -22.0, -30.0, 20.0, 15.0, -15.0, -20.0][group].to_radians();
    if t < 2.0 {
        last * (t / 1.2).min(1.0)
    } else {
        last * (1.0 - 0.5 * ((t - 2.0) / 0.6).min(1.0))
    }
}

#[test]
fn eight_cylinders_meet_their_reference_faster_than_real_time() {
    let rows: Vec<Vec<f64>> = ORACLE
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(|cell| cell.parse().expect("a number")).collect())
        .collect();
    println!("tolerance  error/deg  steps  times real time");
    for (relative, bound) in [(1e-2, 0.1), (1e-3, 0.1), (1e-5, 0.05)] {
        let scale = [1e-1, 1e-1, 1e5, 1e5, 1e5, 1e5, 1e-1, 10.0];
        let tolerance = Tolerance {
            relative,
            absolute: scale.map(|x| relative * x),
        };
        let (mut worst, mut steps, mut compared, mut follows) = (0.0_f64, 0, 0, 0.0_f64);
        let mut best = f64::INFINITY;
        for round in 0..5 {
            let mut all: [Steered; 8] = std::array::from_fn(steered);
            let clock = Instant::now();
            for cycle in 0..300_u32 {
                let t = f64::from(cycle) * CONTROL.period;
                for (i, group) in all.iter_mut().enumerate() {
                    group.cycle(wanted(i, t), &tolerance).expect("solves");
                }
                if round == 0 && cycle % 5 == 4 {
                    for (i, group) in all.iter().enumerate() {
                        worst = worst.max((group.run.states()[0] - rows[compared][i + 1]).abs());
                    }
                    compared += 1;
                }
            }
            best = best.min(clock.elapsed().as_secs_f64());
            steps = all.iter().map(|group| group.run.count.steps).sum();
            follows = all
                .iter()
                .enumerate()
                .map(|(i, g)| (g.run.states()[0] - wanted(i, 3.0)).abs())
                .fold(0.0, f64::max);
        }
        assert_eq!(compared, rows.len());
        let (error, speed) = (worst.to_degrees(), 3.0 / best);
        println!(
            "{relative:9.0e} {error:10.2e} {steps:6} {speed:10.0}; end off by {:.2} deg",
            follows.to_degrees()
        );
        assert!(error <= bound, "{relative:e}: {error} deg");
        assert!(follows.to_degrees() < 2.0, "the loop follows");
        // Eight cylinders, 300 cycles each: at most 40 steps for each cycle. 50 times real time is
        // 25 us for each cycle of a cylinder.
        assert!(steps < 8 * 300 * 40, "{steps}");
    }
}

//! Steering of 10,000 random machines against a complex velocity field in another
//! language: `tests/oracles/steering_rigid_body.py` made the references.

use lemnis_models::parts::plane::{self, Point};
use lemnis_models::steering::centre::residual;
use lemnis_models::steering::machine::Machine;
use lemnis_models::steering::mode::{Command, Mode};

#[path = "common/rolled.rs"]
mod common;

use common::{free, plain, rolled};

const ORACLE: &str = include_str!("../../tests/oracles/steering_rigid_body.csv");

/// The oracle's random numbers.
struct Random(u64);

impl Random {
    fn uniform(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * ((self.0 >> 11) as f64 / 9_007_199_254_740_992.0)
    }
}

/// Angle, speed and angular velocity to 1e-12; and, for every group of every
/// machine, the velocity of the rigid body lies along its heading to 1e-12 of the
/// travel speed, and its axle line passes the turning centre at most 1e-12 m away.
#[test]
#[expect(clippy::too_many_lines, reason = "one case after the other")]
fn ten_thousand_machines() {
    let mut random = Random(1);
    let mut worst = [0.0_f64; 5];
    let (mut machines, mut groups_checked, mut on_the_line) = (0, 0, 0);
    for line in ORACLE.lines().skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        let number = |i: usize| -> f64 { cells[i].parse().expect("a number") };
        let n = 4 + random.uniform(0.0, 61.0) as usize;
        let points: Vec<Point<f64>> = (0..n)
            .map(|_| {
                let x = random.uniform(-20.0, 20.0);
                Point::new(x, random.uniform(-10.0, 10.0))
            })
            .collect();
        let kind = random.uniform(0.0, 6.0) as usize;
        let v = random.uniform(-2.0, 2.0);
        let first = random.uniform(-1.5, 1.5);
        let second = random.uniform(-60.0, 60.0);
        let group = random.uniform(0.0, n as f64) as usize;
        let machine = Machine {
            rear_base: 1,
            ..plain(&points)
        };
        let (mut mode, mut command) = match kind {
            0 => (Mode::Free, Command::Centre(Point::new(40.0 * first, second))),
            1 => (Mode::AllWheel, Command::Angle(first)),
            2 => (Mode::FrontAxle, Command::Angle(first)),
            3 => (Mode::RearAxle, Command::Angle(first)),
            4 => (Mode::AllWheel, Command::Radius(second)),
            _ => (Mode::Pivot, Command::None),
        };
        if let (Command::Angle(_), Some((line, base))) = (command, machine.line(mode))
            && machine.groups[base].x == line
        {
            assert!(mode.centre(&machine, command).is_err());
            (mode, command) = (Mode::Pivot, Command::None);
            on_the_line += 1;
        }
        let centre = mode.centre(&machine, command).expect("allowed");
        assert!(centre.turning().is_some(), "turns");
        let (wheels, travel) = rolled(&machine, &free(n), &centre, v);
        let omega = travel.omega;
        assert_eq!(group, number(2) as usize);
        let turned = (wheels[group].theta - number(3)).abs();
        // Half a turn over is the same axle line, with the opposite speed.
        let (angle, sign) = if turned > 3.0 {
            ((turned - std::f64::consts::PI).abs(), -1.0)
        } else {
            (turned, 1.0)
        };
        let errors = [
            angle,
            (wheels[group].v - sign * number(4)).abs(),
            (omega - number(1)).abs(),
        ];
        for (worst, error) in worst.iter_mut().zip(errors) {
            assert!(error <= 1e-12, "machine {}: {errors:?}", cells[0]);
            *worst = worst.max(error);
        }
        for (p, wheel) in machine.groups.iter().zip(&wheels) {
            // The rigid body from the middle's velocity and omega, not from the centre.
            let arm = p - machine.middle;
            let velocity = travel.middle + Point::new(-omega * arm.y, omega * arm.x);
            assert!(wheel.placed, "every heading is allowed");
            let astray = plane::cross(wheel.turn, velocity).abs() / v.abs();
            let along = (plane::dot(wheel.turn, velocity) - wheel.v).abs() / v.abs();
            assert!(
                astray <= 1e-12 && along <= 1e-12,
                "machine {}: {astray:e} {along:e}",
                cells[0]
            );
            worst[3] = worst[3].max(astray).max(along);
            let residual = residual(&centre, *p, wheel.theta).abs();
            assert!(residual <= 1e-12, "machine {}: {residual:e} m", cells[0]);
            worst[4] = worst[4].max(residual);
            groups_checked += 1;
        }
        machines += 1;
    }
    assert_eq!(machines, 10_000);
    println!(
        "{machines} machines, {groups_checked} groups, {on_the_line} bases on the line of centres; \
         angle {:.1e} rad, speed {:.1e} m/s, omega {:.1e} rad/s, across the heading {:.1e}, axle lines {:.1e} m",
        worst[0], worst[1], worst[2], worst[3], worst[4]
    );
}

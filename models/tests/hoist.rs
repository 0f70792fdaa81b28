//! The hoist's dynamics by what theory says of a point on a rope whose head is held, and by balances of momentum and
//! energy where it gives way.

use lemnis_models::luffing::moving::bodies::Pendulum;
use lemnis_models::luffing::moving::crane::Commands;
use lemnis_models::luffing::moving::dynamics::Coordinate;
use lemnis_models::luffing::moving::motion::{MotionState, MovingLinkage};
use lemnis_models::luffing::moving::space::{Slewing, SlewingState};
use lemnis_models::parts::hoist::{Drum, Hoist, HoistCommand, Winch};
use lemnis_models::parts::joint::{Friction, Joint, JointDrive};

#[path = "common/crane.rs"]
mod crane;

/// A load of 160 kN.
const G: f64 = 9.81;
const Q: f64 = 160e3;
const STEP: f64 = 1e-3;

/// The same crane in its plane and on a turntable, held by its brakes, with its load hanging straight down.
struct Both {
    plane: MovingLinkage,
    space: Slewing,
    flat: MotionState,
    hung: SlewingState,
}

impl Both {
    /// With an acceleration of the hoist (m/s²), which pays out at a rate (m/s).
    fn new(winch: Option<f64>, rate: f64) -> Both {
        let pendulum = Some(Pendulum {
            mass: Q / G,
            length: 10.0,
            hoist: Hoist {
                winch: winch.map_or(Winch::AtOnce, Winch::Ramp),
                rope: None,
            },
        });
        let (mut flat, mut hung) = (MotionState::resting(1.3, 10.0), SlewingState::resting(1.3, 10.0));
        (flat.y[7], flat.drum) = (rate, Drum::at(rate));
        (hung.y[11], hung.drum) = (rate, Drum::at(rate));
        Both {
            plane: MovingLinkage {
                dynamics: crane::dynamics(pendulum),
                joints: [Joint {
                    friction: Friction {
                        viscous: 0.0,
                        coulomb: 0.0,
                    },
                    stops: [1.0, 2.0],
                }],
            },
            space: crane::slewing(pendulum, 5e6, [[0.0; 2]; 2]),
            flat,
            hung,
        }
    }

    /// Moves on for a step under a command of the hoist, in m/s. Returns whether the rope pulls and with what force (N).
    fn step(&mut self, hoist: f64) -> [(bool, f64); 2] {
        let held = Commands {
            shaft: 0.0,
            drives: [JointDrive {
                moment: 0.0,
                brake: 1e12,
            }],
            hoist: HoistCommand::speed(hoist),
        };
        let joint = JointDrive {
            moment: 0.0,
            brake: 1e12,
        };
        let both = Commands {
            shaft: 0.0,
            drives: [joint; 2],
            hoist: HoistCommand::speed(hoist),
        };
        self.plane.advance(&mut self.flat, &held, STEP, STEP).expect("moves");
        self.space.advance(&mut self.hung, &both, STEP, STEP).expect("moves");
        let forces = [
            self.plane.rope_force(&self.flat, &held, &self.flat.y),
            self.space.rope_force(&self.hung, &both, &self.hung.y),
        ];
        let forces = forces.map(|force| force.expect("closes"));
        [(self.flat.taut, forces[0]), (self.hung.taut, forces[1])]
    }
}

/// A ramp of 2 m/s² upwards: S_R = Q (1 + a/g) = 192.620 kN; then Q again.
#[test]
fn a_ramp_pulls_by_its_acceleration() {
    let mut both = Both::new(Some(2.0), 0.0);
    for i in 0..900 {
        for (taut, force) in both.step(-1.5) {
            let (during, expected) = (i < 750, [Q * (1.0 + 2.0 / G), Q]);
            // The step that ends at the ramp's end is of either.
            if i != 749 {
                let expected = expected[usize::from(!during)];
                assert!(taut && (force - expected).abs() < 1e-6, "{i}: {force} {expected}");
            }
        }
    }
    assert!((Q * (1.0 + 2.0 / G) - 192_620.0).abs() < 0.5);
    // What was reeled in: the ramp's half and the rest.
    for (length, rate) in [(both.flat.y[4], both.flat.y[7]), (both.hung.y[10], both.hung.y[11])] {
        assert!((length - (10.0 - 0.5 * 1.5 * 0.75 - 1.5 * 0.15)).abs() < 1e-12 && rate == -1.5);
    }
}

/// A stop of hoisting at v with a deceleration a > g leaves the rope slack for (v/g)(1 + √(1 − g/a)).
#[test]
fn a_stop_faster_than_gravity_leaves_the_rope_slack() {
    let v = 2.0;
    for (winch, expected) in [(Some(10.0), 0.2320), (Some(20.0), 0.3494), (None, 0.4077)] {
        let theory = v / G * (1.0 + (1.0 - winch.map_or(0.0, |a| G / a)).sqrt());
        assert!((theory - expected).abs() < 5e-5, "{theory}");
        let mut both = Both::new(winch, -v);
        both.step(-v);
        let mut slack = [0.0; 2];
        for _ in 0..600 {
            for (slack, (taut, force)) in slack.iter_mut().zip(both.step(0.0)) {
                *slack += if taut { 0.0 } else { STEP };
                assert!(taut || force == 0.0);
            }
        }
        for slack in slack {
            assert!((slack - theory).abs() <= 2.0 * STEP, "{winch:?}: {slack} {theory}");
        }
        // The drum has stopped by then, and the load, slack from its speed v on, falls back with v − g t.
        let caught = 0.5 * Q / G * (v - G * theory).powi(2);
        for blown in [both.flat.blown, both.hung.blown] {
            assert!((blown - caught).abs() < 1e-9 * caught, "{winch:?}: {blown} {caught}");
        }
    }
}

/// A jump of the command gives a blow P along the rope: by hand the load rises with P / m, the head, which travels y' up
/// for one radian of the boom, falls with P y'² / I, and both together are the 0.3 m/s of the hoist.
#[test]
fn a_blow_is_shared_with_the_boom() {
    let commands = |hoist: f64| Commands {
        shaft: 0.0,
        drives: [JointDrive {
            moment: 0.0,
            brake: 0.0,
        }],
        hoist: HoistCommand::speed(hoist),
    };
    let joint = JointDrive {
        moment: 0.0,
        brake: 0.0,
    };
    let both_commands = |hoist: f64| Commands {
        shaft: 0.0,
        drives: [joint; 2],
        hoist: HoistCommand::speed(hoist),
    };
    let mut both = Both::new(None, 0.0);
    // The boom moves, by next to nothing: nothing holds it.
    (both.flat.y[1], both.hung.y[1]) = (1e-12, 1e-12);
    both.plane.event(&mut both.flat, &commands(0.0)).expect("closes");
    both.space.event(&mut both.hung, &both_commands(0.0)).expect("closes");
    both.plane.event(&mut both.flat, &commands(-0.3)).expect("closes");
    both.space.event(&mut both.hung, &both_commands(-0.3)).expect("closes");

    let r = f64::reduced(&both.plane.dynamics, 1.3).expect("closes");
    let (mass, rise) = (Q / G, r.head[1].y);
    let blow = 0.3 / (1.0 / mass + rise * rise / r.inertia);
    let (omega, speed) = (-blow * rise / r.inertia, blow / mass);
    let given = 0.5 * (mass * speed * speed + r.inertia * omega * omega);
    assert!(rise.abs() > 0.1, "the boom feels it");
    for (found, blown) in [(both.flat.y[1], both.flat.blown), (both.hung.y[1], both.hung.blown)] {
        assert!((found - omega).abs() < 1e-9 * omega.abs() + 2e-12, "{found} {omega}");
        assert!((blown + given).abs() < 1e-6 * given, "{blown} {given}");
    }
    // Straight below its head the load is not moved aside, and it rises towards the head with the hoist.
    let aside = -r.head[1].x * omega;
    assert!((10.0 * both.flat.y[3] - aside).abs() < 1e-9 && (both.hung.y[7] - aside).abs() < 1e-9);
    assert!((both.hung.y[8] - 0.3).abs() < 1e-12);
    assert!(both.flat.taut && both.hung.taut);
}

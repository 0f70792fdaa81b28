//! A hoist's motor and a rope that gives way, by closed forms of one and two masses on a line: the crane is held by its
//! brakes, its load hangs straight down. In the plane and on a turntable.

use std::f64::consts::{PI, TAU};

use lemnis_models::kernel::calc::Calc;
use lemnis_models::luffing::moving::bodies::Pendulum;
use lemnis_models::luffing::moving::crane::Commands;
use lemnis_models::luffing::moving::motion::{MotionState, MovingLinkage};
use lemnis_models::luffing::moving::space::{Slewing, SlewingState};
use lemnis_models::parts::hoist::{Elastic, Hoist, HoistCommand, Winch, WinchDrive};
use lemnis_models::parts::joint::{Bar, Friction, Joint, JointDrive};

#[path = "common/crane.rs"]
mod crane;

const G: f64 = 9.81;
const MASS: f64 = 16e3;
const LENGTH: f64 = 20.0;
/// Stiffness of the rope, in N/m: the load hangs on 0.157 m of stretch, and swings up and down in 0.79 s.
const STIFFNESS: f64 = 1e6;
/// A drum of 250 kg·m² and 0.25 m under two falls: 16 t at the head.
const DRUM: WinchDrive = WinchDrive {
    mass: 250.0 * 8.0 * 8.0,
    ratio: 8.0,
    coulomb: 0.0,
};
const HELD: JointDrive = JointDrive {
    moment: 0.0,
    brake: 1e15,
};

/// The same crane twice.
struct Both {
    plane: MovingLinkage,
    space: Slewing,
    flat: MotionState,
    hung: SlewingState,
    step: f64,
}

impl Both {
    fn new(hoist: Hoist) -> Both {
        let pendulum = Some(Pendulum {
            mass: MASS,
            length: LENGTH,
            hoist,
        });
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
            flat: MotionState::resting(1.3, LENGTH),
            hung: SlewingState::resting(1.3, LENGTH),
            step: 1e-3,
        }
    }

    /// The load below the head by a stretch (m), going down at a speed (m/s).
    fn put(&mut self, stretch: f64, speed: f64, taut: bool) {
        (self.flat.y[5], self.flat.y[6], self.flat.taut) = (LENGTH + stretch, speed, taut);
        (self.hung.y[5], self.hung.y[8], self.hung.taut) = (-LENGTH - stretch, -speed, taut);
    }

    /// Moves on for a step. Returns the forces of the rope (N).
    fn step(&mut self, hoist: HoistCommand) -> [f64; 2] {
        let held = Commands {
            shaft: 0.0,
            drives: [JointDrive {
                moment: 0.0,
                brake: HELD.brake,
            }],
            hoist,
        };
        let both = Commands {
            shaft: 0.0,
            drives: [HELD; 2],
            hoist,
        };
        let step = self.step;
        self.plane.advance(&mut self.flat, &held, step, step).expect("moves");
        self.space.advance(&mut self.hung, &both, step, step).expect("moves");
        let forces = [
            self.plane.rope_force(&self.flat, &held, &self.flat.y),
            self.space.rope_force(&self.hung, &both, &self.hung.y),
        ];
        forces.map(|force| force.expect("closes"))
    }

    /// Rates at which the drums pay out, in m/s.
    fn drums(&self) -> [f64; 2] {
        [self.flat.y[7], self.hung.y[11]]
    }
}

fn elastic(winch: Winch) -> Hoist {
    Hoist {
        winch,
        rope: Some(Elastic {
            stiffness: STIFFNESS,
            damping: 0.0,
        }),
    }
}

fn motor(moment: f64, brake: f64) -> HoistCommand {
    HoistCommand {
        speed: 0.0,
        drive: JointDrive { moment, brake },
    }
}

/// A load caught from a slack rope at a speed v gives S_max = m g + √((m g)² + c_R m v²), one set off from its hanging rest
/// m g + v √(c_R m): by the energy of a mass on a spring.
#[test]
fn the_greatest_force_of_an_elastic_rope() {
    let (weight, v) = (MASS * G, 1.2_f64);
    let caught = weight + (weight * weight + STIFFNESS * MASS * v * v).sqrt();
    let set_off = weight + v * (STIFFNESS * MASS).sqrt();
    for (stretch, taut, expected) in [(-0.0, false, caught), (weight / STIFFNESS, true, set_off)] {
        let mut both = Both::new(elastic(Winch::AtOnce));
        both.put(stretch, v, taut);
        let mut most = [0.0_f64; 2];
        for _ in 0..1000 {
            for (most, force) in most.iter_mut().zip(both.step(HoistCommand::speed(0.0))) {
                *most = most.max(force);
                assert!(force >= 0.0, "a rope pulls");
            }
        }
        for most in most {
            // Between two samples of 1 ms the peak may be missed by (ω h)²/8 of its swing.
            assert!((most - expected).abs() < 1e-5 * expected, "{most} {expected}");
        }
        // Nothing is lost by a rope without damping.
        assert_eq!((both.flat.blown, both.hung.blown), (0.0, 0.0));
    }
}

/// What falls from a slack elastic rope and is thrown up again comes back to its height: nothing is lost at its events.
#[test]
fn an_elastic_rope_gives_back_what_it_takes() {
    let mut both = Both::new(elastic(Winch::AtOnce));
    both.put(-0.8, 0.0, false);
    both.step = 1e-4;
    let before = [both.plane.energy(&both.flat), both.space.energy(&both.hung)];
    let mut slack = 0;
    for _ in 0..40_000 {
        let [force, _] = both.step(HoistCommand::speed(0.0));
        slack += u32::from(force == 0.0);
    }
    assert!((10_000..39_000).contains(&slack), "{slack}");
    let after = [both.plane.energy(&both.flat), both.space.energy(&both.hung)];
    // Falling 0.8 m onto a spring, in J.
    let turned = MASS * G * 1.5;
    for (before, after) in before.into_iter().zip(after) {
        let (before, after) = (before.expect("closes"), after.expect("closes"));
        assert!((after - before).abs() < 1e-8 * turned, "{before} {after}");
    }
}

/// Damping takes 2 π ζ of it by each swing, with ζ = d_R / (2 √(c_R m)): the logarithmic decrement.
#[test]
fn damping_of_a_rope_by_its_decrement() {
    let zeta = 0.03_f64;
    let mut hoist = elastic(Winch::AtOnce);
    hoist.rope = hoist.rope.map(|rope| Elastic {
        damping: 2.0 * zeta * (STIFFNESS * MASS).sqrt(),
        ..rope
    });
    let (omega, rest) = ((STIFFNESS / MASS).sqrt(), MASS * G / STIFFNESS);
    let period = TAU / (omega * (1.0 - zeta * zeta).sqrt());
    let mut both = Both::new(hoist);
    both.step = period / 1000.0;
    both.put(rest + 0.05, 0.0, true);
    for _ in 0..4000 {
        both.step(HoistCommand::speed(0.0));
    }
    // e^(−4 T ζ ω) = e^(−8 π ζ / √(1 − ζ²)), with mpmath.
    let expected = 0.05 * 0.470_329_503_770_421_26;
    for length in [both.flat.y[5], -both.hung.y[5]] {
        let amplitude = length - LENGTH - rest;
        assert!((amplitude - expected).abs() < 1e-7 * expected, "{amplitude} {expected}");
    }
}

/// A winch of reduced mass m_1 under a step of its motor's moment: two masses on a spring with ω² = c_R (1/m_1 + 1/m),
/// their centre under the force that is left.
#[test]
fn a_motor_on_an_elastic_rope_is_two_masses() {
    let mut both = Both::new(elastic(Winch::Motor(DRUM)));
    let weight = MASS * G;
    both.put(weight / STIFFNESS, 0.0, true);
    // Both hang on the motor at first, which then pulls by a tenth of the weight more.
    let more = 0.1 * weight;
    let command = motor((weight + more) / DRUM.ratio, 0.0);
    let omega = (STIFFNESS * (1.0 / DRUM.mass + 1.0 / MASS)).sqrt();
    // Accelerated from the drum: S swings about the weight and the load's share of what is left.
    let share = more * MASS / (MASS + DRUM.mass);
    let mut worst = 0.0_f64;
    for i in 1..=2000 {
        let time = f64::from(i) * both.step;
        let expected = weight + share * (1.0 - Calc::sin_cos(omega * time).1);
        for force in both.step(command) {
            worst = worst.max((force - expected).abs() / weight);
        }
        let relative = more / DRUM.mass * Calc::sin(omega * time) / omega;
        let centre = more / (MASS + DRUM.mass) * time;
        let drum = -(centre + relative * MASS / (MASS + DRUM.mass));
        for rate in both.drums() {
            worst = worst.max((rate - drum).abs());
        }
    }
    assert!(worst < 1e-9, "{worst:e}");
}

/// On a rope that keeps its length a motor lifts drum and load together: a = (F − m g) / (m + m_1), and the rope pulls by
/// m (g + a).
#[test]
fn a_motor_on_a_stiff_rope_is_one_mass() {
    let mut both = Both::new(Hoist {
        winch: Winch::Motor(DRUM),
        rope: None,
    });
    let pull = 1.2 * MASS * G;
    let gain = (pull - MASS * G) / (MASS + DRUM.mass);
    for i in 1..=1000 {
        for force in both.step(motor(pull / DRUM.ratio, 0.0)) {
            assert!((force - MASS * (G + gain)).abs() < 1e-9 * force, "{force}");
        }
        for rate in both.drums() {
            let expected = -gain * f64::from(i) * both.step;
            assert!((rate - expected).abs() < 1e-11, "{rate} {expected}");
        }
    }
}

/// The brake holds the drum up to its moment and no further; closed on a falling load it brings it to rest after
/// v² / (2 a), with a = (F_B − m g) / (m + m_1).
#[test]
fn a_brake_holds_the_drum_and_stops_it() {
    for rope in [None, elastic(Winch::AtOnce).rope] {
        let hoist = Hoist {
            winch: Winch::Motor(DRUM),
            rope,
        };
        let hold = MASS * G / DRUM.ratio;
        let mut both = Both::new(hoist);
        both.put(rope.map_or(0.0, |rope| MASS * G / rope.stiffness), 0.0, true);
        for _ in 0..100 {
            both.step(motor(0.0, 1.000_001 * hold));
        }
        assert_eq!(both.drums(), [0.0; 2]);
        assert_eq!((both.flat.drum.way, both.hung.drum.way), (Bar::Held, Bar::Held));
        for _ in 0..100 {
            both.step(motor(0.0, 0.999 * hold));
        }
        assert!(both.drums().iter().all(|rate| *rate > 0.0), "{:?}", both.drums());
    }
    let mut both = Both::new(Hoist {
        winch: Winch::Motor(DRUM),
        rope: None,
    });
    for _ in 0..500 {
        both.step(motor(0.0, 0.0));
    }
    let [speed, _] = both.drums();
    let falling = MASS * G / (MASS + DRUM.mass);
    assert!((speed - 0.5 * falling).abs() < 1e-11, "{speed}");
    let (brake, before) = (1.5 * MASS * G / DRUM.ratio, [both.flat.y[4], both.hung.y[10]]);
    for _ in 0..5000 {
        both.step(motor(0.0, brake));
    }
    let way = speed * speed / (2.0 * 0.5 * falling);
    for (after, before) in [both.flat.y[4], both.hung.y[10]].into_iter().zip(before) {
        assert!((after - before - way).abs() < 1e-9, "{after} {before} {way}");
    }
    assert_eq!(both.drums(), [0.0; 2]);
}

/// A load that falls into its rope pulls the drum along: a plastic blow of two masses keeps their momentum.
#[test]
fn a_drum_gives_way_to_a_blow() {
    let mut both = Both::new(Hoist {
        winch: Winch::Motor(DRUM),
        rope: None,
    });
    // The drum pays out slowly, and the load falls faster, a millimetre above its end.
    let (slow, fast) = (0.1, 0.7);
    both.put(-1e-9, fast, false);
    (both.flat.y[7], both.hung.y[11]) = (slow, slow);
    both.step = 1e-6;
    both.step(motor(0.0, 0.0));
    let together = (MASS * fast + DRUM.mass * slow) / (MASS + DRUM.mass);
    let lost = 0.5 * MASS * DRUM.mass / (MASS + DRUM.mass) * (fast - slow) * (fast - slow);
    for rate in both.drums() {
        assert!((rate - together).abs() < 2e-5, "{rate} {together}");
    }
    for blown in [both.flat.blown, both.hung.blown] {
        assert!((blown - lost).abs() < 1e-4 * lost, "{blown} {lost}");
    }
}

/// In the plane and in space at once, with boom, slewing and load moving and the boom's end stop in the way: the same
/// crane while it does not slew.
#[test]
fn plane_and_space_agree_while_all_moves() {
    let damped = Elastic {
        stiffness: STIFFNESS,
        damping: 2e4,
    };
    let hoists = [
        (Winch::Motor(DRUM), None),
        (Winch::Motor(DRUM), Some(damped)),
        (Winch::Ramp(3.0), Some(damped)),
        (Winch::AtOnce, Some(damped)),
    ];
    for (winch, rope) in hoists {
        let pendulum = Some(Pendulum {
            mass: MASS,
            length: LENGTH,
            hoist: Hoist { winch, rope },
        });
        let stops = [PI / 3.0, 2.0 * PI / 3.0];
        let plane = MovingLinkage {
            dynamics: crane::dynamics(pendulum),
            joints: [Joint {
                friction: Friction {
                    viscous: 1e5,
                    coulomb: 20e3,
                },
                stops,
            }],
        };
        let mut space = crane::slewing(pendulum, 5e6, [[1e5, 20e3], [0.0; 2]]);
        space.joints[0].stops = stops;
        let (mut flat, mut hung) = (MotionState::resting(1.2, LENGTH), SlewingState::resting(1.2, LENGTH));
        let hoist = HoistCommand {
            speed: -0.4,
            drive: JointDrive {
                moment: 1.05 * MASS * G / DRUM.ratio,
                brake: 0.0,
            },
        };
        let mut worst = 0.0_f64;
        for i in 0..3000 {
            let moment = if i < 1500 { 2.4e6 } else { 0.6e6 };
            let commands = Commands {
                shaft: 0.0,
                drives: [JointDrive { moment, brake: 0.0 }],
                hoist,
            };
            let both = Commands {
                shaft: 0.0,
                drives: [JointDrive { moment, brake: 0.0 }, HELD],
                hoist,
            };
            plane.advance(&mut flat, &commands, 1e-3, 1e-3).expect("moves");
            space.advance(&mut hung, &both, 1e-3, 1e-3).expect("moves");
            let force = plane.rope_force(&flat, &commands, &flat.y).expect("closes");
            let other = space.rope_force(&hung, &both, &hung.y).expect("closes");
            let apart = [
                flat.y[0] - hung.y[0],
                flat.y[1] - hung.y[1],
                flat.y[4] - hung.y[10],
                flat.y[7] - hung.y[11],
                flat.y[5] * Calc::sin(flat.y[2]) - hung.y[4],
                (force - other) / (MASS * G),
            ];
            worst = apart.iter().fold(worst, |worst, x| worst.max(x.abs()));
        }
        assert!((flat.y[0] - 1.2).abs() > 0.05, "it luffs");
        println!("{worst:e}");
        assert!(worst < 1e-6, "{worst:e} {winch:?}");
    }
}

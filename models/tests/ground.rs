//! A load put down on the ground and picked up from it by a rope that gives way: closed forms, the plane against space, and
//! the account of energy with what the blow takes.

use lemnis_models::kernel::calc::Calc;
use lemnis_models::luffing::moving::bodies::Pendulum;
use lemnis_models::luffing::moving::crane::Commands;
use lemnis_models::luffing::moving::dynamics::Coordinate;
use lemnis_models::luffing::moving::motion::{MotionState, MovingLinkage};
use lemnis_models::luffing::moving::space::{Slewing, SlewingState};
use lemnis_models::parts::hoist::{Drum, Elastic, Hoist, HoistCommand, Winch};
use lemnis_models::parts::joint::{Friction, Joint, JointDrive};

#[path = "common/crane.rs"]
mod crane;

const G: f64 = 9.81;
const MASS: f64 = 16e3;
const LENGTH: f64 = 10.0;
const THETA: f64 = 1.3;
/// In N/m: the load hangs on 0.157 m of stretch.
const STIFFNESS: f64 = 1e6;
const STRETCH: f64 = MASS * G / STIFFNESS;
const STEP: f64 = 1e-3;
const HELD: JointDrive = JointDrive {
    moment: 0.0,
    brake: 1e15,
};

/// The same crane twice, in the plane and in space.
struct Both {
    plane: MovingLinkage,
    space: Slewing,
    flat: MotionState,
    hung: SlewingState,
}

impl Both {
    /// Its load hangs at rest at the stretch of its weight, above ground by a height (m).
    fn new(above: f64, damping: f64, friction: [f64; 2]) -> Both {
        let [viscous, coulomb] = friction;
        let rope = Some(Elastic {
            stiffness: STIFFNESS,
            damping,
        });
        let pendulum = Some(Pendulum {
            mass: MASS,
            length: LENGTH,
            hoist: Hoist {
                winch: Winch::AtOnce,
                rope,
            },
        });
        let mut both = Both {
            plane: MovingLinkage {
                dynamics: crane::dynamics(pendulum),
                joints: [Joint {
                    friction: Friction { viscous, coulomb },
                    stops: [1.0, 2.0],
                }],
            },
            space: crane::slewing(pendulum, 5e6, [friction, [0.0; 2]]),
            flat: MotionState::resting(THETA, LENGTH),
            hung: SlewingState::resting(THETA, LENGTH),
        };
        both.space.joints[0].stops = [1.0, 2.0];
        both.put(STRETCH);
        let ground = both.head() - LENGTH - STRETCH - above;
        both.plane.dynamics = both.plane.dynamics.clone().above_ground(ground);
        both.space.dynamics = both.space.dynamics.clone().above_ground(ground);
        both
    }

    /// The load below the head by a stretch (m).
    fn put(&mut self, stretch: f64) {
        self.flat.y[5] = LENGTH + stretch;
        self.hung.y[5] = -LENGTH - stretch;
    }

    /// Load and rope go down at a speed (m/s).
    fn lower(&mut self, speed: f64) {
        (self.flat.y[6], self.flat.y[7]) = (speed, speed);
        (self.hung.y[8], self.hung.y[11]) = (-speed, speed);
        (self.flat.drum, self.hung.drum) = (Drum::at(speed), Drum::at(speed));
    }

    /// Height of the head, in m.
    fn head(&self) -> f64 {
        f64::reduced(&self.plane.dynamics, self.flat.y[0]).expect("closes").head[0].y
    }

    fn commands(speed: f64, drive: JointDrive) -> (Commands<1>, Commands<2>) {
        let hoist = HoistCommand::speed(speed);
        let one = Commands {
            shaft: 0.0,
            drives: [drive],
            hoist,
        };
        let both = Commands {
            shaft: 0.0,
            drives: [drive, HELD],
            hoist,
        };
        (one, both)
    }

    /// Moves on by a time (s), the hoist at a speed (m/s). Returns the forces of the rope (N).
    fn advance(&mut self, time: f64, speed: f64, drive: JointDrive) -> [f64; 2] {
        let (one, both) = Self::commands(speed, drive);
        self.plane.advance(&mut self.flat, &one, time, STEP).expect("moves");
        self.space.advance(&mut self.hung, &both, time, STEP).expect("moves");
        [
            self.plane.rope_force(&self.flat, &one, &self.flat.y).expect("closes"),
            self.space.rope_force(&self.hung, &both, &self.hung.y).expect("closes"),
        ]
    }

    fn grounded(&self) -> [bool; 2] {
        [self.flat.grounded, self.hung.grounded]
    }

    fn blown(&self) -> [f64; 2] {
        [self.flat.blown, self.hung.blown]
    }

    /// Kinetic and potential energy, in J.
    fn energies(&self) -> [f64; 2] {
        [
            self.plane.energy(&self.flat).expect("closes"),
            self.space.energy(&self.hung).expect("closes"),
        ]
    }
}

fn near(found: f64, wanted: f64, scale: f64) {
    assert!(
        ((found - wanted) / scale).abs() < 1e-9,
        "{found} where {wanted} is wanted"
    );
}

/// Lowered at a speed v the load loses ½ m v² as it touches the ground, at m g in its rope, whose force falls with c v t to
/// slack; reeled in again its force rises with c v t, lifts at m g without a jump, and swings about m g with v √(c m).
#[test]
fn put_down_and_picked_up() {
    let (speed, above, weight) = (0.2, 0.1, MASS * G);
    let mut both = Both::new(above, 0.0, [0.0; 2]);
    both.lower(speed);
    let touches = above / speed;
    for i in 1..=2000 {
        let t = f64::from(i) * STEP;
        let forces = both.advance(STEP, speed, HELD);
        let wanted = (weight - STIFFNESS * speed * (t - touches).max(0.0)).max(0.0);
        for force in forces {
            near(force, wanted, weight);
        }
        if (t - touches).abs() > 1e-9 {
            assert_eq!(both.grounded(), [t > touches; 2], "{t}");
        }
    }
    for blown in both.blown() {
        near(blown, 0.5 * MASS * speed * speed, 1.0);
    }
    assert_eq!((both.flat.taut, both.hung.taut), (false, false));
    near(both.flat.y[5], LENGTH + STRETCH + above, 1.0);

    // As much slack as was paid out behind what the rope was stretched by.
    let slack = 2.0 * speed - above - STRETCH;
    let omega = (STIFFNESS / MASS).sqrt();
    let (taut, lifts) = (slack / speed, (slack + STRETCH) / speed);
    let (mut most, mut before) = (0.0_f64, 0.0);
    for i in 1..=4000 {
        let t = f64::from(i) * STEP;
        let forces = both.advance(STEP, -speed, HELD);
        let wanted = if t < taut {
            0.0
        } else if t < lifts {
            STIFFNESS * speed * (t - taut)
        } else {
            weight + speed * (STIFFNESS * MASS).sqrt() * Calc::sin(omega * (t - lifts))
        };
        for force in forces {
            assert!((force - wanted).abs() < 1e-7 * weight, "{t}: {force} where {wanted}");
        }
        assert!((forces[0] - before).abs() < 1.001 * STIFFNESS * speed * STEP, "no jump");
        (most, before) = (most.max(forces[0]), forces[0]);
        if (t - lifts).abs() > 1e-9 {
            assert_eq!(both.grounded(), [t < lifts; 2], "{t}");
        }
    }
    let peak = weight + speed * (STIFFNESS * MASS).sqrt();
    assert!((most - peak).abs() < 1e-5 * peak, "{most} where {peak}");
    for blown in both.blown() {
        near(blown, 0.5 * MASS * speed * speed, 1.0);
    }
}

/// A load that flies onto the ground on a slack rope stops there at once: all that it moved with is taken.
#[test]
fn thrown_onto_the_ground() {
    let (above, aside) = (0.3, 1.0);
    let mut both = Both::new(above, 0.0, [0.0; 2]);
    (both.flat.y[4], both.hung.y[10]) = (LENGTH + 2.0, LENGTH + 2.0);
    (both.flat.y[3], both.hung.y[7]) = (aside / both.flat.y[5], aside);
    let before = both.energies();
    let falls = (2.0 * above / G).sqrt();
    both.advance(falls - 1e-6, 0.0, HELD);
    assert_eq!(both.grounded(), [false; 2]);
    both.advance(2e-6, 0.0, HELD);
    assert_eq!(both.grounded(), [true; 2]);
    for ((before, after), blown) in before.into_iter().zip(both.energies()).zip(both.blown()) {
        near(before - after, blown, blown);
        near(blown, 0.5 * MASS * aside * aside + MASS * G * above, blown);
    }
    let place = (both.flat.y, both.hung.y);
    both.advance(1.0, 0.0, HELD);
    assert_eq!((both.flat.y, both.hung.y), place);
}

/// The boom luffs over a load on the ground and drags at it: the plane agrees with space, the load stays where it is, and
/// what drive and hoist give is stored, rubbed and taken by blows, over putting down, dragging, lifting and swinging.
#[test]
fn luffed_over_a_load_that_stands() {
    let mut both = Both::new(0.05, 2e4, [5e7, 20e3]);
    let start = both.energies();
    let mut work = [0.0; 2];
    let (mut stood, mut lifted, mut worst) = (0, false, 0.0_f64);
    let mut stands = None;
    for i in 0..9000 {
        let t = f64::from(i) * STEP;
        let speed = if t < 3.0 { 0.1 } else { -0.12 };
        let (moment, brake) = if t < 2.0 { (0.0, 1e7) } else { (2.2e6, 0.0) };
        let drive = JointDrive { moment, brake };
        let powers = |both: &Both| {
            let (one, _) = Both::commands(speed, drive);
            let (y, rope) = (
                &both.flat.y,
                both.plane.rope_force(&both.flat, &one, &both.flat.y).expect("closes"),
            );
            let friction = both.plane.friction_moment(0, &both.flat, &one, y).expect("closes");
            let stretching = if both.flat.taut { y[6] - y[7] } else { 0.0 };
            (moment + friction) * y[1] - rope * y[7] - 2e4 * stretching * stretching
        };
        both.advance(1e-12, speed, drive);
        let before = powers(&both);
        let grounded = both.flat.grounded;
        let forces = both.advance(STEP - 1e-12, speed, drive);
        work[0] += 0.5 * STEP * (before + powers(&both));
        let (y, z) = (&both.flat.y, &both.hung.y);
        let (sin, cos) = Calc::sin_cos(y[2]);
        let apart = [
            y[0] - z[0],
            y[1] - z[1],
            y[5] * sin - z[4],
            -y[5] * cos - z[5],
            (forces[0] - forces[1]) / (MASS * G),
        ];
        worst = apart.iter().fold(worst, |worst, x| worst.max(x.abs()));
        if both.flat.grounded && grounded {
            let head = f64::reduced(&both.plane.dynamics, y[0]).expect("closes").head[0];
            let place = [head.x + y[5] * sin, head.y - y[5] * cos];
            let [x, height] = *stands.get_or_insert(place);
            assert!(
                (place[0] - x).abs() < 1e-7 && (place[1] - height).abs() < 1e-7,
                "{place:?}"
            );
            stood += 1;
        }
        lifted |= grounded && !both.flat.grounded;
    }
    assert!(
        stood > 2000 && lifted && (both.flat.y[0] - THETA).abs() > 0.05,
        "{stood} {lifted} {:?}",
        both.flat
    );
    assert!(worst < 1e-5, "{worst:e}");
    let stored = both.energies()[0] - start[0] + both.blown()[0];
    println!("{worst:e} {stood} {} {stored} {:?}", work[0], both.blown());
    assert!(
        (work[0] - stored).abs() < 1e-4 * stored.abs(),
        "{} where {stored}",
        work[0]
    );
}

/// The same whatever the communication step.
#[test]
fn any_communication_step_has_the_same_events() {
    let run = |parts: u32| {
        let mut both = Both::new(0.03, 0.0, [0.0; 2]);
        both.lower(0.2);
        for _ in 0..4 * parts {
            both.advance(0.25 / f64::from(parts), 0.2, HELD);
        }
        for _ in 0..8 * parts {
            both.advance(0.25 / f64::from(parts), -0.2, HELD);
        }
        (both.flat, both.hung)
    };
    let (flat, hung) = run(1);
    for parts in [5, 25] {
        let (one, other) = run(parts);
        for (found, wanted) in one.y.iter().chain(&other.y).zip(flat.y.iter().chain(&hung.y)) {
            near(*found, *wanted, 1.0);
        }
        near(one.blown, flat.blown, 1.0);
    }
}

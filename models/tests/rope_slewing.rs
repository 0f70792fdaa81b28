//! A boom on a luffing rope that luffs and slews, its load on a rope that luffing draws over a sheave: against a Lagrangian of
//! points in space, against the plane, and by what theory conserves.

#[path = "common/roped.rs"]
mod roped;
#[path = "common/single_boom.rs"]
mod single_boom;

use lemnis_models::kernel::calc::Calc;
use lemnis_models::luffing::moving::bodies::Turntable;
use lemnis_models::luffing::moving::crane::{Commands, CraneState};
use lemnis_models::luffing::moving::dynamics::Dynamics;
use lemnis_models::luffing::moving::motion::{MotionState, MovingLinkage};
use lemnis_models::luffing::moving::space::{Slewing, SlewingState};
use lemnis_models::luffing::rope::position::Compensation;
use lemnis_models::parts::hanging::HangingLoad;
use lemnis_models::parts::hoist::{Drum, Hoist, HoistCommand};
use lemnis_models::parts::joint::{Bar, Friction, Joint, JointDrive};
use nalgebra::{Matrix3x4, Matrix4, Vector3, Vector4};
use num_dual::{Dual2_64, Dual64, DualNum};
use roped::{BOOM, CENTRE, LOAD, OWN, PARTS, RIG, ROPE, crane, head, hoists};
use single_boom::G;

/// All that slews but the boom, in kg·m².
const REST: f64 = 4e6;
const FREE: JointDrive = JointDrive {
    moment: 0.0,
    brake: 0.0,
};
const HELD: JointDrive = JointDrive {
    moment: 0.0,
    brake: f64::INFINITY,
};

fn slewing(dynamics: Dynamics, stops: [f64; 2]) -> Slewing {
    let joint = |stops| Joint {
        friction: Friction {
            viscous: 0.0,
            coulomb: 0.0,
        },
        stops,
    };
    Slewing {
        dynamics: dynamics.with_slewing(Turntable {
            axis: -RIG.x_8,
            inertia: REST,
        }),
        joints: [joint(stops), joint([-1e9, 1e9])],
    }
}

fn told(drives: [JointDrive; 2], speed: f64) -> Commands<2> {
    Commands {
        shaft: 0.0,
        drives,
        hoist: HoistCommand::speed(speed),
    }
}

/// Boom and load by luffing, slewing, and two angles of the rope, (phi, psi, alpha, beta): where the load is in space (m), and the
/// rope's length (m) as it was `paid` out (m) since the boom was at `from` (rad).
struct Space {
    falls: f64,
    from: f64,
}

impl Space {
    fn new(parts: Option<Compensation<f64>>, from: f64) -> Space {
        let falls = parts.map_or(1.0, |parts| parts.m_k) / RIG.m_h;
        Space { falls, from }
    }

    fn length<D: DualNum<Primitive = f64> + Copy>(&self, phi: D, paid: D) -> D {
        let between = |phi: D| {
            let (sin, cos) = phi.sin_cos();
            let x = cos * RIG.l - sin * RIG.f_a - RIG.b_x;
            let y = sin * RIG.l + cos * RIG.f_a - RIG.b_y;
            (x * x + y * y).sqrt()
        };
        paid - (between(phi) - between(D::from(self.from))) * self.falls + ROPE
    }

    /// In the frame that slews, from the head: forward, up, left.
    fn seen<D: DualNum<Primitive = f64> + Copy>(&self, [phi, _, alpha, beta]: [D; 4], paid: D) -> [D; 3] {
        let length = self.length(phi, paid);
        let ((sin, cos), (aside, within)) = (alpha.sin_cos(), beta.sin_cos());
        [length * within * sin, -length * within * cos, length * aside]
    }

    /// On the ground: along, up, and across, to where slewing to the left turns.
    fn place<D: DualNum<Primitive = f64> + Copy>(&self, q: [D; 4], paid: D) -> [D; 3] {
        let [x, y, z] = self.seen(q, paid);
        let (sin, cos) = q[0].sin_cos();
        let (ahead, up) = (
            x + cos * RIG.l - sin * RIG.f_a + RIG.x_8,
            y + sin * RIG.l + cos * RIG.f_a,
        );
        let (turned, along) = q[1].sin_cos();
        [ahead * along - z * turned, up, ahead * turned + z * along]
    }
}

/// Inertia of the boom about the slewing axis with all else that slews (kg·m²), and its change by the angle: the boom is thin, and
/// lies along its line.
fn about_axis(phi: f64) -> [f64; 2] {
    let (sin, cos) = Calc::sin_cos(phi);
    let ahead = CENTRE.x * cos - CENTRE.y * sin + RIG.x_8;
    let change = -CENTRE.x * sin - CENTRE.y * cos;
    [
        REST + BOOM * ahead * ahead + OWN * cos * cos,
        2.0 * BOOM * ahead * change - 2.0 * OWN * sin * cos,
    ]
}

/// Coordinates in motion: what they are, their rates, and how fast the hoist pays out (m/s).
struct Motion {
    q: [f64; 4],
    rates: [f64; 4],
    hoist: f64,
}

impl Motion {
    /// The coordinates over time, with accelerations.
    fn over_time(&self, accelerations: &Vector4<f64>) -> ([Dual2_64; 4], Dual2_64) {
        let q = std::array::from_fn(|i| Dual2_64::new(self.q[i], self.rates[i], accelerations[i]));
        (q, Dual2_64::new(0.0, self.hoist, 0.0))
    }

    /// M q″ = f of boom, all that slews and load, under moments on both joints (N·m).
    fn accelerations(&self, space: &Space, moments: [f64; 2]) -> Vector4<f64> {
        let jacobian = Matrix3x4::from_fn(|row, column| {
            let q = std::array::from_fn(|i| Dual64::new(self.q[i], f64::from(u8::from(i == column))));
            space.place(q, Dual64::from(0.0))[row].eps
        });
        let (q, paid) = self.over_time(&Vector4::zeros());
        let rest = Vector3::from(space.place(q, paid).map(|x| x.v2)) + Vector3::new(0.0, G, 0.0);
        let [own, weight] = roped::boom(self.q[0]);
        let [upright, change] = about_axis(self.q[0]);
        let [omega, turning, ..] = self.rates;
        let mut mass: Matrix4<f64> = jacobian.transpose() * jacobian * LOAD;
        mass[(0, 0)] += own;
        mass[(1, 1)] += upright;
        let mut forces = -(jacobian.transpose() * rest) * LOAD;
        forces[0] += moments[0] - weight + 0.5 * change * turning * turning;
        forces[1] += moments[1] - change * omega * turning;
        mass.lu().solve(&forces).expect("regular")
    }
}

/// The state of the crane that moves so.
fn state(space: &Space, motion: &Motion) -> SlewingState {
    let (q, paid) = motion.over_time(&Vector4::zeros());
    let seen = space.seen(q, paid);
    let mut state = SlewingState::resting(motion.q[0], space.length(motion.q[0], 0.0));
    let load = HangingLoad {
        place: Vector3::from(seen.map(|x| x.re)),
        rate: Vector3::from(seen.map(|x| x.v1)),
    };
    state.y[..4].copy_from_slice(&[motion.q[0], motion.rates[0], motion.q[1], motion.rates[1]]);
    state.y[4..7].copy_from_slice(load.place.as_slice());
    state.y[7..10].copy_from_slice(load.rate.as_slice());
    state.y[11] = motion.hoist;
    state.joints = [Bar::Forward; 2];
    state.drum = Drum::at(motion.hoist);
    state
}

#[test]
fn it_moves_as_points_in_space() {
    let mut worst = [0.0_f64; 2];
    for parts in PARTS {
        for i in 1..60 {
            let k = f64::from(i);
            let motion = Motion {
                q: [0.025 * k, 0.7 * k, 1.2 - 0.04 * k, 0.9 - 0.03 * k],
                rates: [0.3 - 0.01 * k, 0.007 * k - 0.2, 0.4 - 0.015 * k, 0.02 * k - 0.5],
                hoist: 0.05 * k - 1.1,
            };
            let moments = [2e5 * k, 3e6 - 1e5 * k];
            let space = Space::new(parts, motion.q[0]);
            let accelerations = motion.accelerations(&space, moments);
            let (q, paid) = motion.over_time(&accelerations);
            let seen = space.seen(q, paid).map(|x| x.v2);
            let whole = Vector3::from(space.place(q, paid).map(|x| x.v2)) + Vector3::new(0.0, G, 0.0);
            let free = slewing(crane(parts, Some(Hoist::AT_ONCE)), [-1.6, 1.6]);
            let state = state(&space, &motion);
            let drives = moments.map(|moment| JointDrive { moment, brake: 0.0 });
            let commands = told(drives, motion.hoist);
            let found = free.rates(&state, &commands, &state.y).expect("exists");
            let paid = space.length(q[0], paid);
            let expected = [accelerations[0], accelerations[1], seen[0], seen[1], seen[2]];
            let places = [1, 3, 7, 8, 9];
            let size = seen.iter().fold(G, |size, x| size.max(x.abs()));
            for (place, expected) in places.into_iter().zip(expected) {
                worst[0] = worst[0].max((found[place] - expected).abs() / size);
            }
            assert!((found[10] - paid.v1).abs() <= 1e-13 * size, "{i}");
            // The rope carries what weight and inertia of the load ask for.
            let pull = free.rope_force(&state, &commands, &state.y).expect("exists");
            let sign = if pull < 0.0 { -1.0 } else { 1.0 };
            worst[1] = worst[1].max((pull - sign * LOAD * whole.norm()).abs() / (LOAD * size));
        }
    }
    println!("worst {worst:?}");
    assert!(worst.iter().all(|worst| *worst < 1e-12), "{worst:?}");
}

/// In its plane, slewing held, it is the boom that does not slew: through a slack rope and its blow too.
#[test]
fn in_the_plane_it_is_the_boom_that_does_not_slew() {
    let mut slack = 0;
    for hoist in hoists().into_iter().flatten() {
        for (parts, swing, moment) in [(PARTS[0], 0.3, 5e6), (PARTS[1], 2.1, 4e6)] {
            let stops = [-1.5, 1.4];
            let joint = Joint {
                friction: Friction {
                    viscous: 0.0,
                    coulomb: 0.0,
                },
                stops,
            };
            let plane = MovingLinkage {
                dynamics: crane(parts, Some(hoist)),
                joints: [joint],
            };
            let space = slewing(crane(parts, Some(hoist)), stops);
            let mut flat = MotionState::resting(0.6, ROPE);
            let mut state = SlewingState::resting(0.6, ROPE);
            flat.y[2] = swing;
            state.put_load([swing, 0.0]);
            let drive = JointDrive { moment, brake: 0.0 };
            let flat_commands = Commands {
                shaft: 0.0,
                drives: [drive],
                hoist: HoistCommand::speed(0.2),
            };
            let commands = told([drive, HELD], 0.2);
            for _ in 0..300 {
                plane.advance(&mut flat, &flat_commands, 0.01, 5e-4).expect("moves");
                space.advance(&mut state, &commands, 0.01, 5e-4).expect("moves");
                slack += u32::from(!state.taut);
                let (sin, cos) = Calc::sin_cos(flat.y[2]);
                let errors = [
                    state.y[0] - flat.y[0],
                    state.y[1] - flat.y[1],
                    state.y[4] - flat.y[5] * sin,
                    state.y[5] + flat.y[5] * cos,
                    state.y[10] - flat.y[4],
                    state.blown / (LOAD * G * ROPE) - flat.blown / (LOAD * G * ROPE),
                ];
                assert!(errors.iter().all(|e| e.abs() < 1e-7), "{errors:?} {state:?} {flat:?}");
                assert_eq!((state.taut, state.joints[0]), (flat.taut, flat.joints[0]));
                assert_eq!((state.y[2], state.y[3], state.y[6]), (0.0, 0.0, 0.0));
            }
        }
    }
    assert!(slack > 20, "{slack}");
}

/// The work of both drives is what the energy gains, whichever rope gives way or goes slack; without a drive of slewing the
/// angular momentum about its axis stays.
#[test]
fn work_is_energy_and_angular_momentum_stays() {
    for (i, hoist) in hoists().into_iter().enumerate() {
        for parts in PARTS {
            let free = slewing(crane(parts, hoist), [-1.5, 1.5]);
            for turn in [0.0, 8e5] {
                let mut state = SlewingState::resting(0.6, ROPE);
                state.put_load([0.4, 0.3]);
                (state.y[1], state.y[3]) = (0.02, 0.05);
                let lift = JointDrive {
                    moment: 5e6,
                    brake: 0.0,
                };
                let drives = [lift, JointDrive { moment: turn, ..FREE }];
                let commands = told(drives, 0.0);
                free.event(&mut state, &commands).expect("exists");
                let of = |state: &SlewingState| {
                    let energy = free.energy(state).expect("exists") + state.blown;
                    (energy, free.angular_momentum(state).expect("exists"))
                };
                let (first, begun) = (of(&state), state.y);
                for _ in 0..200 {
                    free.advance(&mut state, &commands, 0.01, 2.5e-4).expect("exists");
                }
                let ways = [state.y[0] - begun[0], state.y[2] - begun[2]];
                let work = 5e6 * ways[0] + turn * ways[1];
                let last = of(&state);
                println!("{i}: {work} J over {ways:?} rad, {} J", last.0 - first.0);
                assert!(ways.iter().all(|way| way.abs() > 0.02), "{ways:?}");
                assert!((last.0 - first.0 - work).abs() < 1e-9 * LOAD * G * RIG.l, "{i}");
                let turned = first.1 + 2.0 * turn;
                assert!((last.1 - turned).abs() < 1e-9 * turned, "{i}: {} {turned}", last.1);
            }
        }
    }
}

/// A load thrown up falls into its rope: along the rope all that it is made of has one speed after the blow, and nothing is gained.
#[test]
fn a_caught_load_takes_its_blow_from_boom_and_slewing() {
    for parts in PARTS {
        let free = slewing(crane(parts, Some(Hoist::AT_ONCE)), [-1.5, 1.5]);
        let mut state: CraneState<12, 2> = SlewingState::resting(0.8, ROPE);
        state.put_load([0.5, -0.4]);
        (state.y[1], state.y[3], state.taut) = (0.03, 0.06, false);
        state.joints = [Bar::Forward; 2];
        let direction = Vector3::new(state.y[4], state.y[5], state.y[6]) / ROPE;
        let before = direction * 2.0;
        state.y[7..10].copy_from_slice(before.as_slice());
        let struck = state;
        let commands = told([FREE; 2], 0.0);
        free.event(&mut state, &commands).expect("exists");
        assert!(state.taut && state.blown > 0.0);
        let ([..], [_, led, _]) = (head(0.8, parts).0, head(0.8, parts).1);
        let along = Vector3::new(state.y[7], state.y[8], state.y[9]).dot(&direction);
        // The rope grows by what luffing pays out: as |A B| falls.
        let paid = -led * state.y[1];
        assert!((along - paid).abs() < 1e-12, "{along} {paid}");
        let energies = [&struck, &state].map(|state| free.energy(state).expect("exists"));
        assert!(energies[1] < energies[0]);
        assert!((energies[0] - energies[1] - state.blown).abs() < 1e-9 * energies[0].abs());
        let momenta = [&struck, &state].map(|state| free.angular_momentum(state).expect("exists"));
        assert!((momenta[1] / momenta[0] - 1.0).abs() < 1e-13, "{momenta:?}");
    }
}

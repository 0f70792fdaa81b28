//! Slewing: against a reference of points in space with 40 digits (`tests/oracles/slewing.py`), against the
//! plane, and by what theory conserves.

use lemnis_models::component::model::Model;
use lemnis_models::kernel::calc::Calc;
use lemnis_models::kernel::variable::Role;
use lemnis_models::luffing::moving::bodies::Pendulum;
use lemnis_models::luffing::moving::crane::Commands;
use lemnis_models::luffing::moving::dynamics::Coordinate;
use lemnis_models::luffing::moving::motion::{self, MovingLinkage};
use lemnis_models::luffing::moving::space::{Slewing, SlewingState, angles};
use lemnis_models::parts::ground::Surroundings;
use lemnis_models::parts::hanging::HangingLoad;
use lemnis_models::parts::hoist::{Drum, Hoist, HoistCommand, RopeAction};
use lemnis_models::parts::joint::{Bar, Friction, Joint, JointDrive};
use nalgebra::Vector3;

#[path = "common/crane.rs"]
mod crane;
#[path = "common/levels.rs"]
mod levels;

const ORACLE: &str = include_str!("../../tests/oracles/slewing.csv");
const NONE: JointDrive = JointDrive {
    moment: 0.0,
    brake: 0.0,
};
const HELD: JointDrive = JointDrive {
    moment: 0.0,
    brake: f64::INFINITY,
};
const BRAKED: Commands<2> = Commands {
    shaft: 0.0,
    drives: [HELD, HELD],
    hoist: HoistCommand::speed(0.0),
};
const G: f64 = 9.81;
const M: f64 = 16e3;

fn at(degrees: f64, length: f64, load: [f64; 2]) -> SlewingState {
    let mut state = SlewingState::resting(degrees.to_radians(), length);
    state.put_load(load);
    state
}

fn run(crane: &Slewing, state: &mut SlewingState, commands: &Commands<2>, duration: f64, h: f64) {
    crane.advance(state, commands, duration, h).expect("moves");
}

fn energy(crane: &Slewing, state: &SlewingState) -> f64 {
    crane.energy(state).expect("closes")
}

#[test]
fn accelerations_agree_with_points_in_space() {
    let mut worst = 0.0_f64;
    for line in ORACLE.lines().skip(1) {
        let cells: Vec<f64> = line.split(',').map(|x| x.parse().expect("a number")).collect();
        let &[
            theta,
            _,
            phi,
            chi,
            omega,
            turning,
            d_phi,
            d_chi,
            length,
            hoist,
            m_1,
            m_2,
            ..,
        ] = cells.as_slice()
        else {
            panic!("{line}");
        };
        let d = crane::turning(
            Some(Pendulum {
                mass: M,
                length,
                hoist: Hoist::AT_ONCE,
            }),
            5e6,
        );
        let ((sp, cp), (sc, cc)) = (Calc::sin_cos(phi), Calc::sin_cos(chi));
        let direction = Vector3::new(cc * sp, -cc * cp, sc);
        let rate = direction * hoist
            + Vector3::new(cc * cp, cc * sp, 0.0) * (length * d_phi)
            + Vector3::new(-sc * sp, sc * cp, cc) * (length * d_chi);
        let load = HangingLoad {
            place: direction * length,
            rate,
        };
        let line = RopeAction::Taut {
            rate: hoist,
            gain: None,
            drum: None,
        };
        let r = f64::reduced(&d, theta).expect("closes");
        let around = Surroundings::Free {
            gravity: Vector3::new(0.0, -G, 0.0),
            air: None,
        };
        let a = d.slewed(&r, [omega, turning], load, [m_1, m_2], line, [true; 2], around);
        let found = [a.joints[0], a.joints[1], a.load.x, a.load.y, a.load.z, a.rope / M];
        for (i, (found, expected)) in found.iter().zip(&cells[12..]).enumerate() {
            let expected = if i == 5 { expected / M } else { *expected };
            // Relative to the largest acceleration of the case: the forces that cancel are of that size.
            let size = cells[14..17].iter().map(|x| x.abs()).fold(G, f64::max);
            worst = worst.max((found - expected).abs() / size);
        }
    }
    println!("worst {worst:e}");
    assert!(worst < 1e-13, "{worst:e}");
}

/// In its plane, slewing held, the crane is the one that does not slew: rates to rounding, paths to the
/// solver's error, through a slack rope and its blow too.
#[test]
fn in_the_plane_it_is_the_crane_that_does_not_slew() {
    let friction = Friction {
        viscous: 1e5,
        coulomb: 20e3,
    };
    let plane = MovingLinkage {
        dynamics: crane::dynamics(Some(crane::PENDULUM)),
        joints: [Joint {
            friction,
            stops: [60_f64.to_radians(), 120_f64.to_radians()],
        }],
    };
    let space = crane::slewing(Some(crane::PENDULUM), 5e6, [[1e5, 20e3], [0.0, 0.0]]);
    for (swing, moment) in [(0.3, 1.8e6), (125_f64.to_radians(), 1.5e6)] {
        let mut flat = motion::MotionState::resting(75_f64.to_radians(), 10.0);
        flat.y[2] = swing;
        let mut state = at(75.0, 10.0, [swing, 0.0]);
        (flat.y[7], flat.drum) = (0.2, Drum::at(0.2));
        (state.y[11], state.drum) = (0.2, Drum::at(0.2));
        let flat_commands = Commands {
            shaft: 0.0,
            drives: [JointDrive { moment, brake: 0.0 }],
            hoist: HoistCommand::speed(0.2),
        };
        let push = JointDrive { moment, brake: 0.0 };
        let commands = Commands {
            shaft: 0.0,
            drives: [push, HELD],
            hoist: HoistCommand::speed(0.2),
        };
        let mut slack = 0;
        for _ in 0..400 {
            plane.advance(&mut flat, &flat_commands, 0.01, 5e-4).expect("moves");
            run(&space, &mut state, &commands, 0.01, 5e-4);
            slack += u32::from(!state.taut);
            let (sin, cos) = Calc::sin_cos(flat.y[2]);
            let place = [flat.y[5] * sin, -flat.y[5] * cos];
            let errors = [
                state.y[0] - flat.y[0],
                state.y[1] - flat.y[1],
                state.y[4] - place[0],
                state.y[5] - place[1],
                state.y[10] - flat.y[4],
            ];
            assert!(errors.iter().all(|e| e.abs() < 1e-8), "{errors:?} {state:?} {flat:?}");
            assert_eq!((state.taut, state.joints[0]), (flat.taut, flat.joints[0]));
            assert_eq!((state.y[2], state.y[3], state.y[6]), (0.0, 0.0, 0.0));
            // Rates at this very state, to rounding.
            let [a, b] = [
                plane.rates(&flat, &flat_commands, &flat.y).expect("closes")[1],
                space.rates(&state, &commands, &state.y).expect("closes")[1],
            ];
            assert!((a - b).abs() < 1e-7, "{a} {b}");
        }
        assert_eq!(slack > 0, swing > 2.0);
    }
}

/// A slewing crane that carries its load round steadily: the rope leans outward as a conical pendulum.
#[test]
fn a_conical_pendulum_stands_still() {
    let rigid = crane::slewing(Some(crane::PENDULUM), 5e6, [[0.0; 2]; 2]);
    let mut state = at(75.0, 10.0, [0.0; 2]);
    state.y[3] = 0.3;
    let r = f64::reduced(&rigid.dynamics, state.y[0]).expect("closes");
    let reach = r.head[0].x + 5.2;
    // tan(phi) = omega² (reach + l sin(phi)) / g, by fixed point.
    let mut phi = 0.0_f64;
    for _ in 0..200 {
        let (sin, _) = Calc::sin_cos(phi);
        phi = f64::direction(G, 0.09 * (reach + 10.0 * sin));
    }
    state.put_load([phi, 0.0]);
    state.y[3] = 0.3;
    let commands = Commands {
        shaft: 0.0,
        drives: [HELD, NONE],
        hoist: HoistCommand::speed(0.0),
    };
    rigid.event(&mut state, &commands).expect("closes");
    let rates = rigid.rates(&state, &commands, &state.y).expect("closes");
    assert_eq!(rates[2], 0.3);
    for i in [3, 7, 8, 9] {
        assert!(rates[i].abs() < 1e-12, "{i}: {}", rates[i]);
    }
    let tension = rigid.rope_force(&state, &commands, &state.y).expect("closes");
    let (_, cos) = Calc::sin_cos(phi);
    assert!((tension - M * G / cos).abs() < 1e-8 * tension);
}

/// Without torque about the slewing axis its angular momentum stays, without friction the energy; luffing,
/// slewing and a load that swings round all at once, for a hundred thousand steps.
#[test]
fn angular_momentum_and_energy_are_conserved() {
    let mut free = crane::slewing(Some(crane::PENDULUM), 5e6, [[0.0; 2]; 2]);
    free.joints[0].stops = [0.3, 2.8];
    // The luffing drive carries the crane's own moment, as a spring would: a heavy tail does it without work.
    let mut state = at(75.0, 10.0, [0.4, 0.3]);
    (state.y[3], state.y[9]) = (0.2, 1.5);
    let held = Commands {
        shaft: 0.0,
        drives: [HELD, NONE],
        hoist: HoistCommand::speed(0.0),
    };
    free.event(&mut state, &held).expect("closes");
    let momentum = |state: &SlewingState| free.angular_momentum(state).expect("closes");
    let (first, whole) = (momentum(&state), energy(&free, &state));
    let mut turned = [0.0_f64; 2];
    for _ in 0..100 {
        run(&free, &mut state, &held, 1.0, 1e-3);
        turned = [turned[0].min(state.y[6]), turned[1].max(state.y[6])];
    }
    let drift = [
        (momentum(&state) - first) / first,
        (energy(&free, &state) - whole) / (M * G * 10.0),
    ];
    println!("drift {drift:?}, side {turned:?}");
    assert!(turned[0] < -1.0 && turned[1] > 1.0);
    assert!(drift.iter().all(|x| x.abs() < 1e-9), "{drift:?}");

    // Luffing free as well, under a constant moment: its work is what the energy gains.
    let mut state = at(75.0, 10.0, [0.4, 0.3]);
    state.y[3] = 0.2;
    let commands = Commands {
        shaft: 0.0,
        drives: [
            JointDrive {
                moment: 2.2e6,
                brake: 0.0,
            },
            NONE,
        ],
        hoist: HoistCommand::speed(0.0),
    };
    free.event(&mut state, &commands).expect("closes");
    let (first, whole, from) = (momentum(&state), energy(&free, &state), state.y[0]);
    run(&free, &mut state, &commands, 4.0, 1e-3);
    let gained = energy(&free, &state) - whole;
    let work = 2.2e6 * (state.y[0] - from);
    println!("work {work}, gained {gained}, at {:?}", state.y);
    assert!((gained - work).abs() < 1e-8 * work.abs() && (state.y[0] - from).abs() > 0.1);
    assert!(((momentum(&state) - first) / first).abs() < 1e-10);
}

/// A held crane has a spherical pendulum: its energy and its angular momentum about the vertical through the
/// head stay, and its path does not depend on the direction in which it starts, not even sideways.
#[test]
fn a_held_crane_has_a_spherical_pendulum() {
    let held = crane::slewing(Some(crane::PENDULUM), 5e6, [[0.0; 2]; 2]);
    let about = |s: &SlewingState| s.y[4] * s.y[9] - s.y[6] * s.y[7];
    let mut heights = Vec::new();
    for turn in [0.0_f64, 0.7, std::f64::consts::FRAC_PI_2, 2.5] {
        let (sin, cos) = Calc::sin_cos(turn);
        let turned = |[x, z]: [f64; 2]| [cos * x - sin * z, sin * x + cos * z];
        let mut state = at(90.0, 10.0, [0.0; 2]);
        // 80 degrees from the vertical, thrown across.
        let (high, low) = Calc::sin_cos(80_f64.to_radians());
        [state.y[4], state.y[6]] = turned([10.0 * high, 0.0]);
        state.y[5] = -10.0 * low;
        [state.y[7], state.y[9]] = turned([0.0, 2.0]);
        let (first, momentum) = (energy(&held, &state), about(&state));
        run(&held, &mut state, &BRAKED, 20.0, 1e-3);
        assert!(((about(&state) - momentum) / momentum).abs() < 1e-9);
        assert!((energy(&held, &state) - first).abs() < 1e-9 * M * G * 10.0);
        heights.push(state.y[5]);
    }
    assert!(heights.iter().all(|h| (h - heights[0]).abs() < 1e-9), "{heights:?}");
}

/// Friction that holds, on both axes, does not give by one bit; a hair more and it gives.
#[test]
fn slewing_truly_sticks() {
    let m = crane::slewing(Some(crane::PENDULUM), 5e6, [[0.0, f64::INFINITY], [1e5, 50e3]]);
    for (moment, moves) in [
        (49_999.0, false),
        (-49_999.0, false),
        (50_001.0, true),
        (-50_001.0, true),
    ] {
        let commands = Commands {
            shaft: 0.0,
            drives: [NONE, JointDrive { moment, brake: 0.0 }],
            hoist: HoistCommand::speed(0.0),
        };
        let start = at(75.0, 10.0, [0.0; 2]);
        let mut state = start;
        for h in [1e-9, 1e-3, 0.1, 1.0, 10.0] {
            run(&m, &mut state, &commands, h, 0.01);
        }
        assert_eq!(state.y[2] != 0.0, moves, "{moment}");
        assert!(moves || state.y == start.y);
        assert!(!moves || state.y[2].signum() == moment.signum(), "{moment}");
    }
}

/// A load that swings sideways pulls on the slewing brake by S · reach · sin: the brake's moment is that.
#[test]
fn the_brake_holds_the_moment_of_the_rope() {
    let m = crane::slewing(Some(crane::PENDULUM), 5e6, [[0.0; 2]; 2]);
    let mut state = at(75.0, 10.0, [0.0, 0.5]);
    m.event(&mut state, &BRAKED).expect("closes");
    let tension = m.rope_force(&state, &BRAKED, &state.y).expect("closes");
    // At rest, aside: S = m g cos(chi).
    let (sin, cos) = Calc::sin_cos(0.5);
    assert!((tension - M * G * cos).abs() < 1e-8 * tension);
    let r = f64::reduced(&m.dynamics, state.y[0]).expect("closes");
    let moment = m.friction_moment(1, &state, &BRAKED, &state.y).expect("closes");
    let expected = -tension * sin * (r.head[0].x + 5.2);
    assert!((moment - expected).abs() < 1e-9 * expected.abs(), "{moment} {expected}");
}

/// Input work = stored + dissipated, over slewing to and fro with luffing, friction on both and a swinging load.
#[test]
fn work_is_stored_or_dissipated() {
    let friction = [[2e5, 40e3], [5e5, 60e3]];
    let m = crane::slewing(Some(crane::PENDULUM), 5e6, friction);
    let mut state = at(75.0, 10.0, [0.1, 0.2]);
    let resting = at(75.0, 10.0, [0.0; 2]);
    let hold = m.friction_moment(0, &resting, &BRAKED, &resting.y).expect("closes");
    let first = energy(&m, &state);
    let (mut work, mut lost, mut reversals, h) = (0.0, 0.0, 0, 1e-4);
    for i in 0..60_000 {
        let way = if (i / 20_000) % 2 == 0 { 1.0 } else { -1.0 };
        let drive = |moment: f64| JointDrive { moment, brake: 0.0 };
        let commands = Commands {
            shaft: 0.0,
            drives: [drive(hold + 3e5 * way), drive(6e5 * way)],
            hoist: HoistCommand::speed(0.0),
        };
        let before = state;
        let mut half = state;
        run(&m, &mut half, &commands, h / 2.0, h);
        run(&m, &mut state, &commands, h, h);
        for (joint, [viscous, dry]) in friction.into_iter().enumerate() {
            let way = state.y[2 * joint] - before.y[2 * joint];
            work += commands.drives[joint].moment * way;
            let power = [before, half, state].map(|s| viscous * s.y[2 * joint + 1] * s.y[2 * joint + 1]);
            lost += (power[0] + 4.0 * power[1] + power[2]) / 6.0 * h + dry * way.abs();
            reversals += u32::from(before.joints[joint] != state.joints[joint]);
        }
    }
    let gained = energy(&m, &state) - first;
    println!("work {work:.3} J, stored {gained:.3} J, lost {lost:.3} J, {reversals} changes");
    assert!(reversals >= 4 && lost > 1e4);
    assert!(
        (work - gained - lost).abs() < 1e-6 * (work.abs() + lost),
        "{}",
        work - gained - lost
    );
}

/// Let go from 150 degrees sideways at rest: slack at once, a vertical free fall, and a blow after which
/// only the motion across the rope is left. Nothing is gained, wherever the joints stand.
#[test]
fn a_slack_rope_catches_its_load_sideways() {
    let m = crane::slewing(Some(crane::PENDULUM), 5e6, [[0.0; 2]; 2]);
    let mut state = at(90.0, 10.0, [0.0; 2]);
    // 8.66 m above the head, 5 m to its left.
    (state.y[5], state.y[6]) = (5.0 * 3_f64.sqrt(), 5.0);
    run(&m, &mut state, &BRAKED, 1e-9, 0.01);
    assert!(!state.taut && m.rope_force(&state, &BRAKED, &state.y) == Some(0.0));
    let fall = (2.0 * 10.0 * 3_f64.sqrt() / G).sqrt();
    run(&m, &mut state, &BRAKED, fall - 1e-6, 1e-3);
    assert!(!state.taut && state.y[4].abs() < 1e-9 && (state.y[6] - 5.0).abs() < 1e-9);
    run(&m, &mut state, &BRAKED, 2e-6, 1e-3);
    assert!(state.taut);
    // Speed g·t straight down at 30 degrees to the rope: g·t·sin 30° across it is left.
    let speed = Vector3::new(state.y[7], state.y[8], state.y[9]).norm();
    assert!((speed - G * fall * 0.5).abs() < 1e-4, "{speed}");

    // Both joints free: the blow moves them, and no energy comes from nowhere.
    let mut state = at(90.0, 10.0, [0.5, 1.2]);
    state.y[5] = state.y[5].abs() + 5.0;
    let length = Vector3::new(state.y[4], state.y[5], state.y[6]).norm();
    let scale = 10.0 / length;
    state.y[4..7].iter_mut().for_each(|x| *x *= scale);
    let commands = Commands {
        shaft: 0.0,
        drives: [
            JointDrive {
                moment: 3e6,
                brake: 0.0,
            },
            NONE,
        ],
        hoist: HoistCommand::speed(0.0),
    };
    let (mut last, mut blows) = (energy(&m, &state), 0);
    for _ in 0..4000 {
        let before = state;
        run(&m, &mut state, &commands, 1e-3, 1e-3);
        let now = energy(&m, &state);
        let work = 3e6 * (state.y[0] - before.y[0]);
        assert!(now - last - work < 1e-3, "gained {}", now - last - work);
        blows += u32::from(!before.taut && state.taut);
        last = now;
    }
    assert!(blows >= 1 && state.y[3] != 0.0);
}

/// A slewing stop catches the crane; the load swings on and pulls at it no more than it can.
#[test]
fn a_slewing_stop_catches_the_crane() {
    let mut m = crane::slewing(Some(crane::PENDULUM), 5e6, [[0.0, f64::INFINITY], [0.0, 1e4]]);
    m.joints[1].stops = [-0.5, 0.5];
    let push = |moment: f64| Commands {
        shaft: 0.0,
        drives: [NONE, JointDrive { moment, brake: 0.0 }],
        hoist: HoistCommand::speed(0.0),
    };
    let mut state = at(75.0, 10.0, [0.0; 2]);
    let mut first = f64::INFINITY;
    for _ in 0..3000 {
        run(&m, &mut state, &push(5e6), 0.01, 0.01);
        if first.is_infinite() && state.y[2] == 0.5 {
            first = energy(&m, &state);
        }
        // Only the swinging is left, of which friction may take some where the load pulls the crane off.
        assert!(state.y[2] <= 0.5 && energy(&m, &state) <= first + 5e6 * 0.5);
    }
    assert_eq!((state.y[2], state.y[3], state.joints[1]), (0.5, 0.0, Bar::Held));
    run(&m, &mut state, &push(-5e6), 20.0, 0.01);
    assert_eq!((state.y[2], state.y[3]), (-0.5, 0.0));
}

/// The load fixed to the head: luffing in makes the crane slew faster, as angular momentum asks for.
#[test]
fn luffing_in_slews_faster() {
    let m = crane::slewing(None, 1e6, [[0.0; 2]; 2]);
    let mut state = SlewingState::resting(70_f64.to_radians(), 0.0);
    state.y[3] = 0.2;
    let commands = Commands {
        shaft: 0.0,
        drives: [
            JointDrive {
                moment: 3.2e6,
                brake: 0.0,
            },
            NONE,
        ],
        hoist: HoistCommand::speed(0.0),
    };
    m.event(&mut state, &commands).expect("closes");
    let momentum = |s: &SlewingState| m.angular_momentum(s).expect("closes");
    let first = momentum(&state);
    let inertia = |s: &SlewingState| f64::reduced(&m.dynamics, s.y[0]).expect("closes").turn[0];
    let before = inertia(&state);
    run(&m, &mut state, &commands, 5.0, 1e-3);
    let ratio = before / inertia(&state);
    println!("inertia fell by {ratio}, rate {} rad/s", state.y[3]);
    assert!(ratio > 1.1 && (state.y[3] / 0.2 / ratio - 1.0).abs() < 1e-10);
    assert!(((momentum(&state) - first) / first).abs() < 1e-10);
}

/// Angles to a place and back, in all directions.
#[test]
fn angles_and_places_agree() {
    for swing in [-3.1, -2.0, -1.0, 0.0, 0.3, 1.57, 2.5, 3.1] {
        for side in [-1.5, -0.4, 0.0, 0.9, 1.5] {
            let state = at(90.0, 7.0, [swing, side]);
            let [a, b] = angles(&state.y);
            assert!(
                (a - swing).abs() < 1e-12 && (b - side).abs() < 1e-12,
                "{swing} {side}: {a} {b}"
            );
        }
    }
}

/// Copied on the way and cut into irregular steps: the same bits, and the same path within the solver's error.
#[test]
fn restored_and_irregular_steps_agree() {
    let m = crane::slewing(Some(crane::PENDULUM), 5e6, [[1e5, 20e3], [2e5, 20e3]]);
    let commands = Commands {
        shaft: 0.0,
        drives: [
            JointDrive {
                moment: 2.4e6,
                brake: 0.0,
            },
            JointDrive {
                moment: 5e5,
                brake: 0.0,
            },
        ],
        hoist: HoistCommand::speed(0.1),
    };
    let start = at(75.0, 10.0, [0.1, 0.1]);
    let whole = || {
        let mut state = start;
        run(&m, &mut state, &commands, 1.0, 1e-3);
        let saved = state;
        run(&m, &mut state, &commands, 0.5, 1e-3);
        saved
    };
    let once = whole();
    assert_eq!(once, whole());
    let mut cut = start;
    for size in [0.1, 1e-9, 0.3, 0.007, 0.593 - 1e-9] {
        run(&m, &mut cut, &commands, size, 1e-3);
    }
    let error = (0..11).map(|i| (once.y[i] - cut.y[i]).abs()).fold(0.0, f64::max);
    assert!(error < 1e-10, "{error:e}");
}

/// Derivatives of rates, event indicators and reactions by every state, input and parameter against central
/// differences, whose error is of the order of the step's square, and roundings over the step.
#[test]
#[expect(clippy::too_many_lines, reason = "one case after the other")]
fn derivatives_are_those_of_differences() {
    let slewing = levels::LEVELS.into_iter().filter(|level| level.contains("slewing"));
    for level in slewing.chain(levels::HOISTS) {
        let mut model = levels::model(level);
        let index = |model: &Model, name: &str| {
            let mut variables = model.variables().iter();
            variables.position(|v| v.symbol.id == name).expect("exists")
        };
        let (slews, elastic) = (level.contains("slewing"), level.contains("elastic"));
        let (swings, oil) = (level.contains("swing"), level.starts_with("hydraulic"));
        let mut given = vec![("theta_1", 1.3), ("omega_1", 0.11)];
        if slews {
            given.extend([("psi_sl", 0.4), ("omega_sl", -0.17)]);
        }
        if level.contains("motor") {
            given.push(("v_R", -0.3));
        }
        if swings && !slews {
            given.extend([("phi_R", 0.2), ("omega_R", 0.13)]);
            // Stretched by 5 cm.
            given.extend([("s_Q", 10.05), ("v_Q", -0.2)].into_iter().filter(|_| elastic));
        }
        if swings && slews {
            given.extend([
                ("x_Q", 3.0),
                // Stretched by 2 cm where it gives way: √(3² + 9.41² + 1.7²) = 10.02 m.
                ("y_Q", if elastic { -9.41 } else { -9.0 }),
                ("z_Q", 1.7),
                ("v_Qx", 0.4),
                ("v_Qy", 0.3),
                ("v_Qz", -0.9),
            ]);
        }
        if oil {
            given.extend([
                ("x_v", 0.3),
                ("v_v", 5.0),
                ("p_1", 120e5),
                ("p_2", 25e5),
                ("p_A", 90e5),
                ("p_B", 60e5),
            ]);
        }
        for (name, value) in given {
            let at = index(&model, name);
            model.set(at, value).expect("allowed");
        }
        // The load to the end of its rope, its speed across it.
        model.update().expect("closes");
        let all: Vec<(usize, Role)> = (0..model.variables().len())
            .map(|i| (i, model.variables()[i].role))
            .collect();
        let moving = |id: &str| {
            id.starts_with("der(")
                || id.starts_with("z.")
                || ["M_R", "M_Rsl", "M_Rh", "S_R", "F_c", "phi_R"].contains(&id)
        };
        let unknowns: Vec<usize> = (all.iter().map(|(i, _)| *i))
            .filter(|&i| moving(model.variables()[i].symbol.id))
            .collect();
        let saved = model.state();
        let mut compared = 0;
        for (known, role) in all {
            if !matches!(role, Role::State | Role::Input | Role::Parameter | Role::Tunable) {
                continue;
            }
            let quantity = model.variables()[known].quantity();
            let mut tangent = model.tangent(&|other| f64::from(other == quantity));
            let exact: Vec<f64> = (unknowns.iter())
                .map(|&i| model.derivative(&mut tangent, i).expect("a derivative"))
                .collect();
            let value = model.get(known).expect("known");
            // Parameters may be small; states and inputs pass through zero.
            let scale = match role {
                Role::Parameter | Role::Tunable if value != 0.0 => value.abs(),
                _ => value.abs().max(0.1),
            };
            let h = 1e-5 * scale;
            let mut beside = |at: f64| -> Option<Vec<f64>> {
                if role == Role::State {
                    // As a solver does: which way a joint goes stays as it is.
                    let mut y = vec![0.0; model.states()];
                    model.get_states(&mut y);
                    y[known] = at;
                    model.set_states(&y).expect("finite");
                } else {
                    model.set(known, at).ok()?;
                    if quantity.0.id == "v_h" {
                        // By the speed at which the hoist then runs; a load on a rope that gives way does not yet.
                        let runs = if elastic {
                            model.event().map(drop)
                        } else {
                            model.start()
                        };
                        runs.ok()?;
                    }
                }
                let found = unknowns.iter().map(|&i| model.get(i).ok()).collect();
                model.set_state(&saved);
                found
            };
            // What must not be negative has one side only.
            let Some((low, high)) = beside(value - h).zip(beside(value + h)) else {
                continue;
            };
            for (j, &i) in unknowns.iter().enumerate() {
                let difference = (high[j] - low[j]) / (2.0 * h);
                let size = high[j].abs().max(1.0) / scale + exact[j].abs();
                let name = model.variables()[i].symbol.id;
                assert!(
                    (difference - exact[j]).abs() < 1e-6 * size,
                    "{level}: {name} by {}: {} {difference}",
                    quantity.0.id,
                    exact[j]
                );
                compared += usize::from(exact[j] != 0.0);
            }
        }
        println!("{level}: {compared} derivatives");
        assert!(compared > 60);
    }
}

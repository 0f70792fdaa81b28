//! A load on its rope on a crane that stands on its oil: ropes of 0.01 m and of 1 km, 179 degrees, a rope that is
//! reeled in to nothing.

use lemnis_models::kernel::calc::Calc;
use lemnis_models::luffing::moving::bodies::Pendulum;
use lemnis_models::luffing::moving::hydraulic::{Crane, Hydraulic, MOST, PresentCrane};
use lemnis_models::luffing::moving::space::SlewingState;
use lemnis_models::parts::hoist::{Hoist, HoistCommand};
use lemnis_models::parts::joint::JointDrive;
use lemnis_models::parts::solver::Halt;
use lemnis_models::parts::solver::rodas::Tolerance;

use super::crane;

const G: f64 = 9.81;

/// A light load, whose swing does not move the crane; nothing leaks, and slewing is braked. At angles (rad) of the
/// rope in the plane and, where it slews, from it.
fn hanging(length: f64, [swing, side]: [f64; 2], slews: bool) -> (Hydraulic<MOST>, PresentCrane<MOST>) {
    let pendulum = Some(Pendulum {
        mass: 1e-3,
        length,
        hoist: Hoist::AT_ONCE,
    });
    let mut system: Hydraulic<MOST> = if slews {
        crane::hydraulic_slewing(pendulum, 5e6)
    } else {
        crane::hydraulic(pendulum)
    };
    system.cylinder.leakage = 0.0;
    system.slewing = JointDrive {
        moment: 0.0,
        brake: f64::INFINITY,
    };
    let mut y = system.resting(1.5, 20e5).expect("closes");
    if slews {
        let mut state = SlewingState::resting(1.5, length);
        state.put_load([swing, side]);
        y[8..].copy_from_slice(&state.y[2..]);
    } else {
        y[8] = swing;
    }
    (system, PresentCrane::new(y))
}

/// Cosine of the rope's angle from the vertical, and speed of the load, in m/s.
fn seen(system: &Hydraulic<MOST>, present: &PresentCrane<MOST>) -> [f64; 2] {
    let y = present.run.states();
    match system.crane {
        Crane::Plane(_) => [
            Calc::sin_cos(y[8]).1,
            Calc::sqrt(y[12] * y[12] + y[11] * y[11] * y[9] * y[9]),
        ],
        Crane::Slewing(_) => [
            -y[11] / y[16],
            Calc::sqrt(y[13] * y[13] + y[14] * y[14] + y[15] * y[15]),
        ],
    }
}

fn run(system: &Hydraulic<MOST>, present: &mut PresentCrane<MOST>, duration: f64) -> Result<(), Halt> {
    let mut absolute = [f64::INFINITY; MOST];
    absolute[..system.states()].fill(1e-12);
    absolute[2..6].fill(1e-3);
    let tolerance = Tolerance {
        relative: 1e-9,
        absolute,
    };
    system.advance(present, &tolerance, duration, 1.0)
}

/// The period is that of theory, T = 4 sqrt(l/g) K(sin(a/2)), in the plane and aside.
#[test]
fn ropes_of_a_centimetre_and_of_a_kilometre() {
    let (mut a, mut b) = (1.0_f64, Calc::sin_cos(0.25_f64).1);
    for _ in 0..6 {
        (a, b) = (f64::midpoint(a, b), (a * b).sqrt());
    }
    for length in [0.01, 0.1, 100.0, 1000.0] {
        let period = std::f64::consts::TAU * (length / G).sqrt() / a;
        for (load, slews) in [([0.5, 0.0], false), ([0.5, 0.0], true), ([0.0, 0.5], true)] {
            let (system, mut present) = hanging(length, load, slews);
            // At a quarter the load hangs straight below, at the whole it stands where it started.
            run(&system, &mut present, period / 4.0).expect("swings");
            let [cos, speed] = seen(&system, &present);
            let most = (2.0 * G * length * (1.0 - Calc::sin_cos(0.5_f64).1)).sqrt();
            assert!(
                (cos - 1.0).abs() < 1e-9 && (speed / most - 1.0).abs() < 1e-6,
                "{length} {load:?}"
            );
            run(&system, &mut present, 0.75 * period).expect("swings");
            let [cos, speed] = seen(&system, &present);
            assert!(
                (cos - Calc::sin_cos(0.5_f64).1).abs() < 1e-7,
                "{length} {load:?}: {cos}"
            );
            assert!(speed < 1e-6 * most && present.modes.taut, "{length} {load:?}: {speed}");
        }
    }
}

/// Let go at 179 degrees: slack, a fall of 2 l cos(1 deg), and a blow 1 degree from straight below that leaves only
/// the motion across the rope.
#[test]
fn let_go_at_179_degrees() {
    let (sin, cos) = Calc::sin_cos(1_f64.to_radians());
    let (straight, fall) = (179_f64.to_radians(), (4.0 * 10.0 * cos / G).sqrt());
    for (load, slews) in [
        ([straight, 0.0], false),
        ([straight, 0.0], true),
        ([straight, 1e-3], true),
    ] {
        let (system, mut present) = hanging(10.0, load, slews);
        run(&system, &mut present, fall - 1e-6).expect("falls");
        assert!(!present.modes.taut);
        run(&system, &mut present, 2e-6).expect("is caught");
        let [_, speed] = seen(&system, &present);
        assert!(
            present.modes.taut && (speed - G * fall * sin).abs() < 1e-3,
            "{load:?}: {speed}"
        );
    }
}

/// A rope of half a metre reeled in by a metre: refused where nothing is left of it, after bounded work.
#[test]
fn a_rope_that_is_reeled_in_to_nothing() {
    for slews in [false, true] {
        for swing in [0.0, 0.01] {
            let (mut system, mut present) = hanging(0.5, [swing, 0.0], slews);
            system.hoist = HoistCommand::speed(-1.0);
            // A load that swings does so ever faster: the tolerance may ask for too much first.
            let end = run(&system, &mut present, 1.0);
            let halts = [Halt::Outside, Halt::TooSmall];
            assert!(end.is_err_and(|halt| halts.contains(&halt)), "{end:?}");
            let y = present.run.states();
            assert!(y.iter().all(|x| x.is_finite()) && y[if slews { 16 } else { 10 }] > 0.0);
            assert!(present.run.count.steps + present.run.count.rejected < 100_000);
        }
    }
}

//! Bulk modulus, port volumes, tolerances: the stiff cylinder.

use lemnis_models::luffing::moving::dynamics::Coordinate;
use lemnis_models::luffing::moving::hydraulic::{Hydraulic, Modes, Piece};
use lemnis_models::parts::solver::rodas::{Run, Tolerance};
use lemnis_models::parts::solver::{Halt, System};

use super::crane;

fn tolerance(relative: f64) -> Tolerance<8> {
    let scale = [1e-3, 1e-3, 1e5, 1e5, 1e5, 1e5, 1e-2, 1.0];
    Tolerance {
        relative,
        absolute: scale.map(|x| relative * x),
    }
}

fn with(bulk_modulus: f64, port_volume: f64) -> Hydraulic<8> {
    let mut system = crane::hydraulic(None);
    system.cylinder.bulk_modulus = bulk_modulus;
    system.cylinder.port_volume = port_volume;
    // Without leakage the resting state is exact.
    system.cylinder.leakage = 0.0;
    system
}

/// For the solver; with nothing that sticks or goes slack all of the way is one piece.
fn way<const N: usize>(system: &Hydraulic<N>) -> Piece<'_, N> {
    system.between(Modes::AT_REST)
}

fn after(system: &Hydraulic<8>, relative: f64, duration: f64) -> ([f64; 8], u32) {
    let y = system.resting(65_f64.to_radians(), 20e5).expect("closes");
    let mut run = Run::new(y, 1e-3);
    run.advance(&way(system), &tolerance(relative), duration, 1.0)
        .expect("solves");
    (run.states(), run.count.steps + run.count.rejected)
}

/// At rest the crane stays at rest: angle to 1e-9 rad over 100 s. On oil as soft as a gas the rest is
/// unstable in truth, as its spring is weaker than the weights' moment changes: rounding grows, 1 s.
#[test]
fn rest_stays_rest() {
    for bulk_modulus in [1e5, 1e7, 1e9, 1e12] {
        for port_volume in [1e-9, 1e-6, 1e-3] {
            let system = with(bulk_modulus, port_volume);
            let duration = if bulk_modulus < 1e6 { 1.0 } else { 100.0 };
            let (y, steps) = after(&system, 1e-6, duration);
            let moved = (y[0] - 65_f64.to_radians()).abs();
            assert!(
                moved < 1e-9 && steps < 10_000,
                "{bulk_modulus:e} {port_volume:e}: {moved:e}, {steps} steps"
            );
        }
    }
}

/// Eigenvalues beyond -1e9 1/s, and the stiffer the oil the nearer to the incompressible limit: the boom
/// on its oil swings about it with the amplitude omega/omega_n, which bounds every difference, and the
/// work does not explode.
#[test]
fn stiff_oil_approaches_the_incompressible_limit() {
    let (_, jacobian) = {
        let system = with(1.4e9, 1e-9);
        way(&system)
            .jacobian(&system.resting(65_f64.to_radians(), 20e5).expect("closes"))
            .expect("closes")
    };
    assert!(jacobian[2][2] < -1e9, "{}", jacobian[2][2]);
    let end = |bulk_modulus: f64| {
        let mut system = with(bulk_modulus, 1e-6);
        system.command = 0.3;
        let (y, steps) = after(&system, 1e-9, 1.0);
        assert!(steps < 100_000, "{bulk_modulus:e}: {steps}");
        // Natural frequency of the inertia on the two columns of oil.
        let r = f64::reduced(system.dynamics(), y[0]).expect("closes");
        let volumes = system.cylinder.volumes(r.drive[0]);
        let spring = (0..2)
            .map(|i| system.cylinder.areas[i].powi(2) / volumes[i])
            .sum::<f64>()
            * bulk_modulus;
        (y[0], y[1].abs() / (spring * r.drive[1] * r.drive[1] / r.inertia).sqrt())
    };
    let ends = [1e9, 1e10, 1e11, 1e12].map(end);
    for pair in ends.windows(2) {
        let (difference, amplitude) = ((pair[1].0 - pair[0].0).abs(), pair[0].1);
        println!("difference {difference:.1e}, amplitude {amplitude:.1e}");
        assert!(difference < amplitude, "{ends:?}");
    }
}

/// Soft as a gas, 1e5 Pa: the cylinder gives way by metres under a change of force; solved or refused
/// at the end of assembly, with finite numbers and bounded work.
#[test]
fn oil_as_soft_as_gas() {
    let mut system = with(1e5, 2e-4);
    system.command = 0.5;
    let y = system.resting(65_f64.to_radians(), 20e5).expect("closes");
    let mut run = Run::new(y, 1e-3);
    let end = run.advance(&way(&system), &tolerance(1e-4), 5.0, 1.0);
    assert!(matches!(end, Ok(()) | Err(Halt::Outside | Halt::TooSmall)), "{end:?}");
    assert!(run.states().iter().all(|x| x.is_finite()));
    assert!(run.count.steps + run.count.rejected < 100_000, "{:?}", run.count);
}

/// Tolerances that no double can hold are refused at once, without a loop that runs away.
#[test]
fn subnormal_tolerances_are_refused() {
    let mut system = with(1.4e9, 2e-4);
    system.command = 0.5;
    for relative in [0.0, 5e-324, 1e-310, 1e-200] {
        let y = system.resting(65_f64.to_radians(), 20e5).expect("closes");
        let mut run = Run::new(y, 1e-3);
        let end = run.advance(&way(&system), &tolerance(relative), 0.1, 1.0);
        assert!(
            matches!(end, Err(Halt::TooSmall | Halt::TooMany)),
            "{relative:e}: {end:?}"
        );
        assert!(run.count.rejected < 200, "{relative:e}: {:?}", run.count);
    }
}

/// States that are no numbers are refused, and the present states stay.
#[test]
fn broken_states_are_refused() {
    let system = with(1.4e9, 2e-4);
    let good = system.resting(65_f64.to_radians(), 20e5).expect("closes");
    for value in [f64::NAN, f64::INFINITY, f64::MAX] {
        for i in 0..8 {
            let mut y = good;
            y[i] = value;
            let mut run = Run::new(y, 1e-3);
            let end = run.advance(&way(&system), &tolerance(1e-6), 0.1, 1.0);
            assert!(end.is_err(), "state {i} = {value}");
            assert_eq!(run.states().map(f64::to_bits), y.map(f64::to_bits));
            assert!(run.count.rejected < 200, "{:?}", run.count);
        }
    }
}

/// Communication steps from 1e-9 to 1e3 s, irregular, in one run: the end is that of a run at once,
/// within the tolerance.
#[test]
fn communication_steps_of_any_size() {
    let mut system = with(1.4e9, 2e-4);
    system.command = 0.2;
    let y = system.resting(65_f64.to_radians(), 20e5).expect("closes");
    let run = |sizes: &[f64]| {
        let mut run = Run::new(y, 1e-3);
        for size in sizes {
            run.advance(&way(&system), &tolerance(1e-8), *size, 1.0)
                .expect("solves");
        }
        run.states()
    };
    let whole = run(&[2.0]);
    let cut = run(&[1e-9, 1e-6, 0.1, 1e-9, 0.899_998_998, 1e-3, 0.5, 0.499]);
    for i in 0..8 {
        let scale = [1.0, 1.0, 1e7, 1e7, 1e7, 1e7, 1.0, 1.0][i];
        assert!(
            (whole[i] - cut[i]).abs() < 1e-6 * scale,
            "state {i}: {} {}",
            whole[i],
            cut[i]
        );
    }
    // 1e3 s with the valve closed: the leakage alone moves it, in few steps.
    system.command = 0.0;
    let mut long = Run::new(y, 1e-3);
    long.advance(&way(&system), &tolerance(1e-6), 1e3, 1e3).expect("solves");
    assert!(long.count.steps < 2000, "{:?}", long.count);
}

//! Extremes of the groups that are turned by their cylinders under the PLC: oil, steps, inputs, tolerances, loads.

use lemnis_models::component::model::Model;
use lemnis_models::kernel::variable::Fault;
use lemnis_models::scene::Scene;

use super::running::{bits, run, states};

const SCENE: &str = include_str!("../../models/scenes/boat_hoist_003_hydraulic.toml");

pub fn model() -> Model {
    let scene = Scene::parse(SCENE).unwrap_or_else(|found| panic!("{found:?}"));
    scene.model().expect("built")
}

pub fn index(model: &Model, name: &str) -> usize {
    let found = model.variables().iter().position(|variable| variable.name() == name);
    found.unwrap_or_else(|| panic!("{name}"))
}

fn set(model: &mut Model, name: &str, value: f64) -> Result<(), Fault> {
    let at = index(model, name);
    model.set(at, value)
}

fn get(model: &mut Model, name: &str) -> f64 {
    let at = index(model, name);
    model
        .get(at)
        .unwrap_or_else(|fault| panic!("{name}: {}", fault.message))
}

/// How far the angle of a group on its way of two degrees is off with a longest step (s), over that way, against a
/// tolerance of 1e-9.
pub fn strayed(step: f64) -> Option<f64> {
    let end = |step: f64, tolerance: f64| {
        let mut model = model();
        let start = get(&mut model, "theta[1]");
        for (name, value) in [("step", step), ("tol", tolerance), ("theta_b", start + 0.035)] {
            set(&mut model, name, value).expect("allowed");
        }
        run(&mut model, &[0.3])
            .ok()
            .map(|()| [start, get(&mut model, "theta[1]")])
    };
    let [start, exact] = end(1.0, 1e-9)?;
    assert!((exact - start).abs() > 0.01, "it moves: {start} {exact}");
    Some((end(step, 1e-5)?[1] - exact).abs() / (exact - start).abs())
}

/// Bulk modulus from 1e5 to 1e12 Pa and ports from 1e-9 m³, eigenvalues beyond -1e9 1/s: commanded where they stand, the
/// groups stay there, to the PLC's own step of angle.
#[test]
fn oil_of_any_stiffness_rests() {
    for modulus in [1e5, 1e7, 1e9, 1e12] {
        for port in [1e-9, 1e-6, 1e-3] {
            let mut model = model();
            for (name, value) in [("beta_E", modulus), ("V_1", port), ("k_L", 0.0)] {
                set(&mut model, name, value).expect("allowed");
            }
            let start = states(&model)[..8].to_vec();
            let commanded = get(&mut model, "theta[1]");
            set(&mut model, "theta_b", commanded).expect("allowed");
            run(&mut model, &[1e-9, 0.5]).unwrap_or_else(|f| panic!("{modulus:e} {port:e}: {}", f.message));
            let moved = states(&model)[..8]
                .iter()
                .zip(&start)
                .map(|(a, b)| (a - b).abs())
                .fold(0.0, f64::max);
            assert!(moved < 0.045_f64.to_radians(), "{modulus:e} {port:e}: {moved:e}");
        }
    }
}

/// Communication steps from 1e-9 to 1e2 s, irregular and again after a restore: the same bits. One of 1e4 s would have
/// more samples of the PLC than one call may take, and is refused at once without a change.
#[test]
fn steps_of_any_size_again_after_a_restore() {
    let mut model = model();
    run(&mut model, &[0.013, 1e-9, 0.2]).expect("moves");
    let (saved, from) = (model.state(), 0.213_000_001);
    let sizes = [1e-9, 0.37, 1e-6, 1e-3, 2e-9, 0.05, 1e2];
    let again = |model: &mut Model| {
        let mut time = from;
        for size in sizes {
            model.advance(time, time + size).expect("moves");
            time += size;
        }
        (bits(model), time)
    };
    let (first, time) = again(&mut model);
    model.set_state(&saved);
    assert_eq!(again(&mut model).0, first);
    let fault = model.advance(time, time + 1e4).expect_err("too many samples");
    assert!(fault.outside && fault.message.contains("T_c"), "{}", fault.message);
    assert_eq!(bits(&model), first);
}

/// Inputs that are no numbers are refused, denormal ones are as zero, huge ones end at a stop or are refused; after all of
/// them the model goes on.
#[test]
fn inputs_of_any_size_during_a_run() {
    for input in ["theta_b", "omega_s", "v_t", "G[3]", "p_P"] {
        let mut model = model();
        run(&mut model, &[0.1]).expect("moves");
        for broken in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let refused = set(&mut model, input, broken);
            assert!(refused.is_err_and(|fault| fault.outside), "{input} = {broken}");
        }
        let saved = model.state();
        let mut end = |value: f64| {
            model.set_state(&saved);
            let done = set(&mut model, input, value).and_then(|()| model.advance(0.1, 0.3));
            assert!(states(&model).iter().all(|x| x.is_finite()), "{input} = {value:e}");
            assert!(
                done.as_ref().map_err(|fault| fault.outside) != Err(false),
                "{input} = {value:e}: {done:?}"
            );
            done.map(|()| states(&model))
        };
        let zero = end(0.0);
        for tiny in [5e-324, 1e-310] {
            // A travel speed that is not zero is one: the tyres roll.
            if input != "v_t" {
                assert_eq!(end(tiny), zero, "{input} = {tiny:e}");
            }
        }
        for huge in [1e15, 1e300, f64::MAX] {
            let _ = end(huge);
        }
        assert_eq!(end(0.0), zero, "{input}: it goes on");
    }
}

/// No load, no friction, hardly any inertia, loads and inertias beyond all machines: solved with finite numbers, or
/// refused. Tolerances below rounding and coarser than a tenth are refused when they are set.
#[test]
fn parameters_of_any_size() {
    for (name, values) in [
        ("f_t", &[0.0, 5e-324][..]),
        ("mu_r", &[0.0]),
        ("k_L", &[0.0, 1e-300]),
        ("k_R", &[0.0, 1e3]),
        ("J", &[1e-6, 1.0, 1e9, 1e300]),
        ("V_0", &[1e-9, 1e9]),
        ("omega_v", &[1e-6, 1e6]),
        ("zeta_v", &[0.0, 1e6]),
        ("k_P", &[0.0, 1e300]),
    ] {
        for &value in values {
            let mut model = model();
            set(&mut model, name, value).expect("allowed");
            let done = run(&mut model, &[1e-3, 0.2]);
            assert!(
                done.as_ref().map_err(|fault| fault.outside) != Err(false),
                "{name} = {value:e}: {done:?}"
            );
            assert!(states(&model).iter().all(|x| x.is_finite()), "{name} = {value:e}");
        }
    }
    let mut model = model();
    for tolerance in [0.0, 5e-324, 1e-310, 1e-13, 0.100_001, 1.0, 1e300] {
        let fault = set(&mut model, "tol", tolerance).expect_err("out of range");
        assert!(fault.outside && fault.message.contains("0.1"), "{}", fault.message);
    }
    run(&mut model, &[0.1]).expect("goes on");
}

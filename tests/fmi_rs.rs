//! The FMUs of the default scene, imported and stepped by `fmi-rs`: in both
//! standards, as Co-Simulation and as Model Exchange, every output is that of
//! the model, bit for bit.

use fmi_rs::fmi2::builder::FMU2Builder;
use fmi_rs::fmi2::types::fmi2Status;
use fmi_rs::fmi3::builder::FMU3Builder;
use fmi_rs::fmi3::types::fmi3Status;
use lemnis_fmu::description::Standard;
use lemnis_fmu::package::{self, Library};
use lemnis_models::component::model::Model;
use lemnis_models::kernel::variable::{Role, Type};
use lemnis_models::scene::{self, Scene};
use std::path::PathBuf;
use tempfile::TempDir;

/// Step in s; the default experiment takes 60 s.
const STEP: f64 = 1.0;
const STEPS: u32 = 60;

/// The default scene's FMU in a folder of its own, and its model.
fn fmu(standard: Standard) -> (TempDir, PathBuf, Model) {
    let scene = Scene::parse(scene::DEFAULT).unwrap();
    let library = Library::of_this_platform().unwrap_or_else(|fault| panic!("{}", fault.message));
    let bytes = package::fmu(&scene, standard, &[library], &[]).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("LemniscateCrane.fmu");
    std::fs::write(&file, bytes).unwrap();
    (folder, file, scene.model().unwrap())
}

/// The model's outputs: their value references, in the order real, then boolean, and their values as the model steps.
struct Expected {
    model: Model,
    reals: Vec<u32>,
    booleans: Vec<u32>,
}

impl Expected {
    fn new(model: Model) -> Expected {
        let references = |kind| {
            let variables = model.variables().iter().zip(1..);
            variables
                .filter(|(variable, _)| variable.kind == kind && variable.role != Role::Parameter)
                .map(|(_, reference)| reference)
                .collect()
        };
        let (reals, booleans) = (references(Type::Real), references(Type::Boolean));
        Expected { model, reals, booleans }
    }

    /// Compares what `get` reads from the FMU with the model at `time`.
    fn check(&mut self, time: f64, get: impl FnOnce(&[u32], &mut [f64], &[u32], &mut [bool])) {
        let (mut reals, mut booleans) = (vec![f64::NAN; self.reals.len()], vec![false; self.booleans.len()]);
        get(&self.reals, &mut reals, &self.booleans, &mut booleans);
        self.model.set_time(time);
        let found = reals.into_iter().chain(booleans.into_iter().map(f64::from));
        for (&reference, value) in self.reals.iter().chain(&self.booleans).zip(found) {
            let index = reference as usize - 1;
            let expected = self.model.get(index).unwrap();
            let id = self.model.variables()[index].symbol.id;
            assert_eq!(
                value.to_bits(),
                expected.to_bits(),
                "{id} at {time} s: {value}, the model has {expected}"
            );
        }
    }
}

fn times() -> impl Iterator<Item = f64> {
    (0..STEPS).map(|step| f64::from(step) * STEP)
}

/// FMI 2 has its truth values in integers.
macro_rules! check2 {
    ($expected:ident, $fmu:ident, $time:expr) => {
        $expected.check($time, |reals, values, booleans, truths| {
            assert_eq!($fmu.getReal(reals, values), fmi2Status::Ok);
            let mut integers = vec![7; truths.len()];
            assert_eq!($fmu.getBoolean(booleans, &mut integers), fmi2Status::Ok);
            truths
                .iter_mut()
                .zip(integers)
                .for_each(|(truth, integer)| *truth = integer == 1);
        })
    };
}

#[test]
fn fmi2_co_simulation() {
    let (_folder, file, model) = fmu(Standard::Fmi2);
    let builder = FMU2Builder::new(&file).unwrap();
    assert!(
        builder.model_description.validate().is_empty(),
        "{:?}",
        builder.model_description.validate()
    );
    let fmu = builder.instantiate_cs("crane").unwrap();
    assert_eq!(fmu.setupExperiment(None, 0.0, None), fmi2Status::Ok);
    assert_eq!(fmu.enterInitializationMode(), fmi2Status::Ok);
    assert_eq!(fmu.exitInitializationMode(), fmi2Status::Ok);
    let mut expected = Expected::new(model);
    check2!(expected, fmu, 0.0);
    for time in times() {
        assert_eq!(fmu.doStep(time, STEP, 1), fmi2Status::Ok);
        check2!(expected, fmu, time + STEP);
    }
    assert_eq!(fmu.terminate(), fmi2Status::Ok);
}

#[test]
fn fmi2_model_exchange() {
    let (_folder, file, model) = fmu(Standard::Fmi2);
    let fmu = FMU2Builder::new(&file).unwrap().instantiate_me("crane").unwrap();
    assert_eq!(fmu.setupExperiment(None, 0.0, None), fmi2Status::Ok);
    assert_eq!(fmu.enterInitializationMode(), fmi2Status::Ok);
    assert_eq!(fmu.exitInitializationMode(), fmi2Status::Ok);
    assert_eq!(fmu.enterContinuousTimeMode(), fmi2Status::Ok);
    let mut expected = Expected::new(model);
    for time in times() {
        let (mut enter_event_mode, mut terminate) = (1, 1);
        assert_eq!(fmu.setTime(time), fmi2Status::Ok);
        assert_eq!(fmu.getDerivatives(&mut []), fmi2Status::Ok);
        check2!(expected, fmu, time);
        assert_eq!(
            fmu.completedIntegratorStep(1, &mut enter_event_mode, &mut terminate),
            fmi2Status::Ok
        );
        assert_eq!((enter_event_mode, terminate), (0, 0));
    }
    assert_eq!(fmu.terminate(), fmi2Status::Ok);
}

macro_rules! check3 {
    ($expected:ident, $fmu:ident, $time:expr) => {
        $expected.check($time, |reals, values, booleans, truths| {
            assert_eq!($fmu.getFloat64(reals, values), fmi3Status::Ok);
            assert_eq!($fmu.getBoolean(booleans, truths), fmi3Status::Ok);
        })
    };
}

#[test]
fn fmi3_co_simulation() {
    let (_folder, file, model) = fmu(Standard::Fmi3);
    let builder = FMU3Builder::new(&file).unwrap();
    assert!(
        builder.model_description.validate().is_empty(),
        "{:?}",
        builder.model_description.validate()
    );
    let fmu = builder.instantiate_cs("crane").unwrap();
    assert_eq!(fmu.enterInitializationMode(None, 0.0, None), fmi3Status::Ok);
    assert_eq!(fmu.exitInitializationMode(), fmi3Status::Ok);
    assert_eq!(fmu.enterStepMode(), fmi3Status::Ok, "fmi-rs uses event mode");
    let mut expected = Expected::new(model);
    check3!(expected, fmu, 0.0);
    for time in times() {
        let (mut event, mut terminate, mut early, mut reached) = (true, true, true, f64::NAN);
        let status = fmu.doStep(time, STEP, true, &mut event, &mut terminate, &mut early, &mut reached);
        assert_eq!(
            (status, event, terminate, early, reached),
            (fmi3Status::Ok, false, false, false, time + STEP)
        );
        check3!(expected, fmu, time + STEP);
    }
    assert_eq!(fmu.terminate(), fmi3Status::Ok);
}

#[test]
fn fmi3_model_exchange() {
    let (_folder, file, model) = fmu(Standard::Fmi3);
    let fmu = FMU3Builder::new(&file).unwrap().instantiate_me("crane").unwrap();
    assert_eq!(fmu.enterInitializationMode(None, 0.0, None), fmi3Status::Ok);
    assert_eq!(fmu.exitInitializationMode(), fmi3Status::Ok);
    let (mut update, mut terminate, mut nominals, mut values, mut next) = (true, true, true, true, Some(0.0));
    let status = fmu.updateDiscreteStates(&mut update, &mut terminate, &mut nominals, &mut values, &mut next);
    assert_eq!(
        (status, update, terminate, nominals, values, next),
        (fmi3Status::Ok, false, false, false, false, None)
    );
    assert_eq!(fmu.enterContinuousTimeMode(), fmi3Status::Ok);
    let mut expected = Expected::new(model);
    for time in times() {
        let mut enter_event_mode = true;
        assert_eq!(fmu.setTime(time), fmi3Status::Ok);
        assert_eq!(fmu.getContinuousStateDerivatives(&mut []), fmi3Status::Ok);
        check3!(expected, fmu, time);
        assert_eq!(
            fmu.completedIntegratorStep(true, &mut enter_event_mode, &mut terminate),
            fmi3Status::Ok
        );
        assert_eq!((enter_event_mode, terminate), (false, false));
    }
    assert_eq!(fmu.terminate(), fmi3Status::Ok);
}

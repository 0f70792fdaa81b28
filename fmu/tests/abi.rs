//! Both standards through their C functions: life cycle, errors, and what hosts get wrong.

mod common;

#[path = "../../models/tests/common/levels.rs"]
mod levels;

use common::{Messages, REACHABLE, UNREACHABLE, Unpacked, instantiate2, instantiate3, log3, step3};
use lemnis_fmu::abi::{Component, STATUS_DISCARD, STATUS_ERROR, STATUS_OK, STATUS_WARNING, Status, fmi2::*, fmi3::*};
use lemnis_fmu::description::Standard;
use lemnis_fmu::package;
use lemnis_models::scene::{self, Scene};
use libloading::Library;
use std::ffi::{c_char, c_void};
use std::ptr::{null, null_mut};

// SAFETY in this file: instances are freed once, arrays have the lengths given, and the
// environment is the list of messages.

#[test]
fn life_cycle_of_co_simulation_fmi2() {
    let mut fmu = Unpacked::new();
    let mut messages = Vec::new();
    let c = instantiate2(&fmu, 1, &mut messages);
    let (theta_1, reach) = (fmu.reference("theta_1"), fmu.reference("A.x"));
    let mut value = 0.0;
    // SAFETY: see above.
    unsafe {
        assert_eq!(fmi2SetupExperiment(c, 0, 0.0, 0.0, 1, 2.0), STATUS_OK);
        assert_eq!(fmi2EnterInitializationMode(c), STATUS_OK);
        assert_eq!(fmi2ExitInitializationMode(c), STATUS_OK);
        assert_eq!(fmi2SetReal(c, &theta_1, 1, &REACHABLE), STATUS_OK);
        assert_eq!(fmi2DoStep(c, 0.0, 1.0, 1), STATUS_OK);
        assert_eq!(
            fmi2DoStep(c, 1.0 + 1e-9, 1.0, 1),
            STATUS_OK,
            "a communication point a little off"
        );
        assert_eq!(fmi2GetReal(c, &reach, 1, &mut value), STATUS_OK);
        assert_eq!(fmi2GetRealStatus(c, 2, &mut value), STATUS_OK);
        assert_eq!(messages, []);
        assert_eq!(fmi2DoStep(c, 2.0, 1.0, 1), STATUS_ERROR, "beyond the stop time");
        assert_eq!(fmi2Terminate(c), STATUS_OK);
        assert_eq!(fmi2DoStep(c, 2.0, 1.0, 1), STATUS_ERROR, "after the end");
        assert_eq!(fmi2GetReal(c, &reach, 1, &mut value), STATUS_OK);
        fmi2FreeInstance(c);
    }
    assert_eq!(messages.len(), 2);
    fmu.model.set(fmu.index("theta_1"), REACHABLE).unwrap();
    assert_eq!(value, fmu.model.get(fmu.index("A.x")).unwrap());
}

#[test]
fn life_cycle_of_model_exchange() {
    let mut fmu = Unpacked::new();
    let mut messages = Vec::new();
    let c = instantiate2(&fmu, 0, &mut messages);
    let reach = fmu.reference("A.x");
    let (mut value, mut info, mut enter, mut terminate) = (0.0, fmi2EventInfo::default(), 9, 9);
    // SAFETY: see above.
    unsafe {
        assert_eq!(
            fmi2EnterInitializationMode(c) + fmi2ExitInitializationMode(c),
            STATUS_OK
        );
        info.newDiscreteStatesNeeded = 1;
        assert_eq!(fmi2NewDiscreteStates(c, &mut info), STATUS_OK);
        assert_eq!(info.newDiscreteStatesNeeded, 0);
        assert_eq!(fmi2EnterContinuousTimeMode(c), STATUS_OK);
        assert_eq!(fmi2SetTime(c, 0.5), STATUS_OK);
        assert_eq!(fmi2GetDerivatives(c, null_mut(), 0), STATUS_OK);
        assert_eq!(fmi2GetReal(c, &reach, 1, &mut value), STATUS_OK);
        assert_eq!(fmi2CompletedIntegratorStep(c, 1, &mut enter, &mut terminate), STATUS_OK);
        assert_eq!((enter, terminate), (0, 0));
        assert_eq!(
            fmi2DoStep(c, 0.5, 0.1, 1),
            STATUS_ERROR,
            "Co-Simulation in Model Exchange"
        );
        assert_eq!(fmi2SetTime(c, f64::NAN), STATUS_ERROR);
        fmi2FreeInstance(c);
    }
    assert_eq!(messages.len(), 2);
    fmu.model.set_time(0.5);
    assert_eq!(value, fmu.model.get(fmu.index("A.x")).unwrap());
}

#[test]
fn an_unreachable_configuration_is_discarded_and_the_instance_survives() {
    let fmu = Unpacked::new();
    let mut messages = Vec::new();
    let i = instantiate3(&fmu, false, &mut messages);
    let (theta_1, reach) = (fmu.reference("theta_1"), fmu.reference("A.x"));
    let mut value = 0.0;
    // SAFETY: see above.
    unsafe {
        let start = |i| fmi3EnterInitializationMode(i, 0, 0.0, 0.0, 0, 0.0) + fmi3ExitInitializationMode(i);
        assert_eq!(start(i), STATUS_OK);
        assert_eq!(step3(i, 0.0, 0.1), (STATUS_OK, 0.1));
        assert_eq!(messages.len(), 0);

        assert_eq!(fmi3SetFloat64(i, &theta_1, 1, &UNREACHABLE, 1), STATUS_OK);
        assert_eq!(step3(i, 0.1, 0.1), (STATUS_DISCARD, 0.1), "time stays");
        assert_eq!(messages.len(), 1, "one message: {messages:?}");
        assert!(
            messages[0].1.starts_with("fmi3DoStep: theta_1 = 5.72958 deg"),
            "{messages:?}"
        );
        assert_eq!(
            fmi3GetFloat64(i, &reach, 1, &mut value, 1),
            STATUS_DISCARD,
            "no outputs at that angle"
        );

        assert_eq!(fmi3SetFloat64(i, &theta_1, 1, &REACHABLE, 1), STATUS_OK);
        assert_eq!(step3(i, 0.1, 0.1).0, STATUS_OK, "repeated");
        assert_eq!(fmi3SetFloat64(i, &theta_1, 1, &UNREACHABLE, 1), STATUS_OK);
        assert_eq!(step3(i, 0.2, 0.1).0, STATUS_DISCARD);
        assert_eq!(fmi3SetFloat64(i, &theta_1, 1, &REACHABLE, 1), STATUS_OK);
        assert_eq!(step3(i, 0.3, 0.1).0, STATUS_OK, "the importer went on");

        assert_eq!(fmi3SetFloat64(i, &theta_1, 1, &UNREACHABLE, 1), STATUS_OK);
        assert_eq!(step3(i, 0.4, 0.1).0, STATUS_DISCARD);
        assert_eq!(fmi3Reset(i), STATUS_OK, "after an error");
        assert_eq!(start(i), STATUS_OK);
        assert_eq!(fmi3GetFloat64(i, &theta_1, 1, &mut value, 1), STATUS_OK);
        assert_eq!(value, fmu.model.clone().get(fmu.index("theta_1")).unwrap());
        assert_eq!(step3(i, 0.0, 0.1).0, STATUS_OK);
        fmi3FreeInstance(i);
    }
}

/// No number that overflows or does not exist reaches a simulator, where only what says so may be infinite. The refusal
/// names the variable, and the instance is as it was.
#[test]
fn no_value_is_infinite_that_does_not_say_so() {
    let fmu = Unpacked::new();
    // Boom and rocker are parallel there: `boom_parallel` of lemniscate_extremes.csv.
    let parallel = f64::from_bits(0x3ff8_eaa3_34fd_b5bb);
    let (angle, load) = (fmu.reference("theta_1"), fmu.reference("Q"));
    let moment = ["M_D", "A.x"].map(|id| fmu.reference(id));
    let centre = ["O1P", "P.x", "P.y"].map(|id| fmu.reference(id));
    let (mut values, mut before) = ([0.0; 3], [0.0; 2]);
    let (mut of_2, mut of_3) = (Messages::new(), Messages::new());
    // SAFETY: see above.
    unsafe {
        let (c, i) = (instantiate2(&fmu, 1, &mut of_2), instantiate3(&fmu, false, &mut of_3));
        let started = fmi2EnterInitializationMode(c) + fmi3EnterInitializationMode(i, 0, 0.0, 0.0, 0, 0.0);
        assert_eq!(started, STATUS_OK);
        assert_eq!(fmi2SetReal(c, &angle, 1, &parallel), STATUS_OK);
        assert_eq!(fmi3SetFloat64(i, &angle, 1, &parallel, 1), STATUS_OK);
        assert_eq!(fmi2ExitInitializationMode(c) + fmi3ExitInitializationMode(i), STATUS_OK);
        assert_eq!(fmi2GetReal(c, centre.as_ptr(), 3, values.as_mut_ptr()), STATUS_OK);
        assert_eq!(values, [f64::INFINITY; 3]);
        assert_eq!(fmi3GetFloat64(i, centre.as_ptr(), 3, values.as_mut_ptr(), 3), STATUS_OK);
        assert_eq!(values, [f64::INFINITY; 3]);

        assert_eq!(fmi2GetReal(c, moment.as_ptr(), 2, before.as_mut_ptr()), STATUS_OK);
        assert_eq!(fmi2SetReal(c, &load, 1, &f64::MAX), STATUS_OK);
        assert_eq!(fmi3SetFloat64(i, &load, 1, &f64::MAX, 1), STATUS_OK);
        assert_eq!(fmi2GetReal(c, moment.as_ptr(), 2, values.as_mut_ptr()), STATUS_ERROR);
        assert_eq!(
            fmi3GetFloat64(i, moment.as_ptr(), 2, values.as_mut_ptr(), 2),
            STATUS_DISCARD
        );
        for (messages, function) in [(&of_2, "fmi2GetReal"), (&of_3, "fmi3GetFloat64")] {
            assert_eq!(messages.len(), 1, "{messages:?}");
            let text = &messages[0].1;
            assert!(text.starts_with(&format!("{function}: M_D is undefined: ")), "{text}");
        }
        assert_eq!(fmi2SetReal(c, &load, 1, &160e3), STATUS_OK);
        assert_eq!(fmi3SetFloat64(i, &load, 1, &160e3, 1), STATUS_OK);
        assert_eq!(fmi2GetReal(c, moment.as_ptr(), 2, values.as_mut_ptr()), STATUS_OK);
        assert_eq!(values[..2], before);
        assert_eq!(fmi3GetFloat64(i, moment.as_ptr(), 2, values.as_mut_ptr(), 2), STATUS_OK);
        assert_eq!(values[..2], before);
        fmi2FreeInstance(c);
        fmi3FreeInstance(i);
    }
}

#[test]
fn event_mode_of_co_simulation() {
    let fmu = Unpacked::new();
    let mut messages = Vec::new();
    let i = instantiate3(&fmu, true, &mut messages);
    let (mut a, mut b, mut c, mut d, mut e, mut time) = (9, 9, 9, 9, 9, 9.0);
    // SAFETY: see above.
    unsafe {
        assert_eq!(
            fmi3EnterInitializationMode(i, 0, 0.0, 0.0, 0, 0.0) + fmi3ExitInitializationMode(i),
            STATUS_OK
        );
        assert_eq!(step3(i, 0.0, 0.1).0, STATUS_ERROR, "still in event mode");
        let status = fmi3UpdateDiscreteStates(i, &mut a, &mut b, &mut c, &mut d, &mut e, &mut time);
        assert_eq!((status, a, b, c, d, e), (STATUS_OK, 0, 0, 0, 0, 0));
        assert_eq!(
            fmi3EnterContinuousTimeMode(i),
            STATUS_ERROR,
            "Model Exchange in Co-Simulation"
        );
        assert_eq!(fmi3EnterStepMode(i), STATUS_OK);
        assert_eq!(step3(i, 0.0, 0.1).0, STATUS_OK);
        assert_eq!(fmi3EnterEventMode(i), STATUS_OK);
        fmi3FreeInstance(i);
    }
}

#[test]
fn saved_states_come_back_bit_for_bit() {
    let fmu = Unpacked::new();
    let mut messages = Vec::new();
    let i = instantiate3(&fmu, false, &mut messages);
    let reach = fmu.reference("A.x");
    // SAFETY: see above.
    unsafe {
        assert_eq!(
            fmi3EnterInitializationMode(i, 0, 0.0, 0.0, 0, 0.0) + fmi3ExitInitializationMode(i),
            STATUS_OK
        );
        let run = || {
            let mut values = [0.0; 5];
            for (step, value) in values.iter_mut().enumerate() {
                assert_eq!(step3(i, 0.1 + 0.1 * step as f64, 0.1).0, STATUS_OK);
                assert_eq!(fmi3GetFloat64(i, &reach, 1, value, 1), STATUS_OK);
            }
            values
        };
        assert_eq!(step3(i, 0.0, 0.1).0, STATUS_OK);
        let (mut state, mut copy, mut size) = (0, 0, 0);
        assert_eq!(fmi3GetFMUState(i, &mut state), STATUS_OK);
        let expected = run();
        assert_eq!(fmi3SetFMUState(i, state), STATUS_OK);
        assert_eq!(run(), expected);

        assert_eq!(fmi3SerializedFMUStateSize(i, state, &mut size), STATUS_OK);
        let mut bytes = vec![0; size];
        assert_eq!(fmi3SerializeFMUState(i, state, bytes.as_mut_ptr(), size), STATUS_OK);
        assert_eq!(fmi3DeserializeFMUState(i, bytes.as_ptr(), size, &mut copy), STATUS_OK);
        assert_eq!(fmi3FreeFMUState(i, &mut state.clone()), STATUS_OK);
        assert_eq!(fmi3SetFMUState(i, copy), STATUS_OK);
        assert_eq!(run(), expected);
        assert_eq!(messages.len(), 0);

        assert_eq!(fmi3SetFMUState(i, state), STATUS_ERROR, "freed");
        assert_eq!(
            fmi3DeserializeFMUState(i, bytes.as_ptr(), size - 1, &mut copy),
            STATUS_ERROR,
            "cut short"
        );
        bytes[size / 2] ^= 1;
        assert_eq!(
            fmi3DeserializeFMUState(i, bytes.as_ptr(), size, &mut copy),
            STATUS_ERROR,
            "damaged"
        );
        assert_eq!(fmi3FreeFMUState(i, &mut copy), STATUS_OK);
        assert_eq!(copy, 0);
        fmi3FreeInstance(i);
    }
    assert_eq!(messages.len(), 3);
}

#[test]
fn wrong_calls_are_refused_with_a_message() {
    let fmu = Unpacked::new();
    let mut messages = Vec::new();
    let c = instantiate2(&fmu, 1, &mut messages);
    let (theta_1, reach, mut value) = (fmu.reference("theta_1"), fmu.reference("A.x"), 0.0);
    let parameter = fmu
        .model
        .variables()
        .iter()
        .position(|v| v.role == lemnis_models::kernel::variable::Role::Parameter)
        .unwrap() as u32
        + 1;
    // SAFETY: see above.
    unsafe {
        assert_eq!(fmi2EnterInitializationMode(null_mut()), STATUS_ERROR);
        assert_eq!(messages.len(), 0, "nobody to tell");
        let mut expected = 0;
        let mut refused = |status: Status, what: &str| {
            expected += 1;
            assert_eq!(status, STATUS_ERROR, "{what}");
            expected
        };
        refused(fmi2DoStep(c, 0.0, 0.1, 1), "before initialization");
        assert_eq!(
            fmi2EnterInitializationMode(c) + fmi2ExitInitializationMode(c),
            STATUS_OK
        );
        for (point, size) in [
            (f64::NAN, 0.1),
            (0.0, f64::NAN),
            (0.0, -0.1),
            (0.0, 0.0),
            (0.0, f64::INFINITY),
            (7.0, 0.1),
        ] {
            refused(fmi2DoStep(c, point, size, 1), "point or size");
        }
        refused(fmi2GetReal(c, null(), 1, &mut value), "null references");
        refused(fmi2GetReal(c, &reach, 1, null_mut()), "null values");
        refused(fmi2GetReal(c, &99_999, 1, &mut value), "unknown reference");
        refused(fmi2GetReal(c, &reach, usize::MAX, &mut value), "too many");
        refused(fmi2GetBoolean(c, &reach, 1, &mut 0), "a real number as a truth value");
        refused(fmi2GetInteger(c, &reach, 1, &mut 0), "no integers");
        refused(fmi2SetReal(c, &reach, 1, &1.0), "an output");
        refused(fmi2SetReal(c, &0, 1, &1.0), "time");
        refused(fmi2SetReal(c, &parameter, 1, &1.0), "a parameter during the simulation");
        refused(fmi2SetFMUstate(c, 0), "no state");
        refused(
            fmi2GetDirectionalDerivative(c, &reach, 1, &reach, 1, &1.0, &mut value),
            "derivative by a result",
        );
        refused(
            fmi2GetDirectionalDerivative(c, &theta_1, 1, &theta_1, 1, &1.0, &mut value),
            "derivative of an input",
        );
        refused(fmi2SetDebugLogging(c, 0, 1, &c"%s".as_ptr()), "unknown category");
        let count = refused(fmi2CancelStep(c), "not claimed");
        assert_eq!(fmi2GetReal(c, null(), 0, null_mut()), STATUS_OK);
        assert!(messages.iter().all(|(status, _)| *status == STATUS_ERROR));
        assert_eq!(messages.len(), count, "{messages:#?}");
        assert!(
            messages[count - 2].1.contains("%%s"),
            "the message is a format: {messages:#?}"
        );
        assert_eq!(fmi2SetDebugLogging(c, 0, 0, null()), STATUS_OK);
        assert_eq!(fmi2CancelStep(c), STATUS_ERROR);
        assert_eq!(messages.len(), count, "logging is off");
        fmi2FreeInstance(c);
        fmi2FreeInstance(null_mut());
    }
}

#[test]
fn what_cannot_be_instantiated() {
    let fmu = Unpacked::new();
    let mut messages = Vec::new();
    let scene_file = fmu.path().join("resources/scene.toml");
    let scene = std::fs::read(&scene_file).unwrap();
    let mut refused = |what: &str, words: &str| {
        assert!(instantiate2(&fmu, 1, &mut messages).is_null(), "{what}");
        let (_, message) = messages.pop().unwrap();
        assert!(messages.is_empty() && message.contains(words), "{what}: {message}");
    };
    std::fs::write(&scene_file, [&scene[..], b"\n# another crane\n"].concat()).unwrap();
    refused("another scene", "token");
    std::fs::write(&scene_file, vec![b'#'; (1 << 20) + 1]).unwrap();
    refused("a huge scene", "at most");
    std::fs::write(&scene_file, b"\xff\xfe\0").unwrap();
    refused("no text", "scene.toml");
    std::fs::write(&scene_file, "[[[[").unwrap();
    refused("garbage", "scene.toml");
    let text = std::str::from_utf8(&scene).unwrap();
    for hostile in [
        r#""1e308 m""#,
        r#""1e-300 m""#,
        r#""-1e999 m""#,
        r#""nan m""#,
        r#""../../../../etc/passwd""#,
    ] {
        std::fs::write(&scene_file, text.replace(r#""19.3 m""#, hostile)).unwrap();
        refused(hostile, "");
    }
    std::fs::write(
        &scene_file,
        text.replace("\"LemniscateCrane\"", "\"../../LemniscateCrane\""),
    )
    .unwrap();
    refused("a name that leads out of the folder", "cannot name a model");
    std::fs::write(&scene_file, &scene[..scene.len() / 2]).unwrap();
    refused("a truncated scene", "scene.toml");
    std::fs::remove_file(&scene_file).unwrap();
    std::fs::create_dir(&scene_file).unwrap();
    refused("a folder", "not a file");
    std::fs::remove_dir(&scene_file).unwrap();
    #[cfg(unix)]
    {
        let pipe = std::process::Command::new("mkfifo").arg(&scene_file).status();
        assert!(pipe.expect("mkfifo is a part of every Unix").success());
        refused("a pipe that nobody writes to", "not a file");
        std::fs::remove_file(&scene_file).unwrap();
    }
    refused("no scene", "scene.toml");
    std::fs::write(&scene_file, &scene).unwrap();
    assert!(instantiate2(&fmu, 7, &mut messages).is_null());

    // SAFETY: see above.
    unsafe {
        let resources = fmu.resources();
        let c = fmi2Instantiate(
            c"crane".as_ptr(),
            1,
            fmu.token.as_ptr(),
            resources.as_ptr(),
            null(),
            0,
            0,
        );
        assert_eq!(fmi2DoStep(c, 0.0, 0.1, 1), STATUS_ERROR, "and no logger to tell");
        fmi2FreeInstance(c);
        assert!(fmi2Instantiate(null(), 1, null(), null(), null(), 0, 0).is_null());
    }
}

#[test]
fn the_library_exports_every_function_and_finds_its_scene_without_a_path() {
    assert_eq!(FMI2.len() + 4, 44);
    assert_eq!(FMI3.len() + 5, 75);
    let fmu = Unpacked::new();
    let folder = fmu.path().join("binaries/x86_64-linux");
    std::fs::create_dir_all(&folder).unwrap();
    let file = folder.join("LemniscateCrane.so");
    std::fs::copy(package::find_library().unwrap(), &file).unwrap();
    // SAFETY: the library is this crate; see above.
    unsafe {
        let library = Library::new(&file).unwrap();
        for (name, _) in FMI2.iter().chain(FMI3) {
            assert!(library.get::<*const c_void>(*name).is_ok(), "{name}");
        }
        let instantiate = library.get::<fn() -> ()>("fmi3InstantiateModelExchange").unwrap();
        let instantiate: unsafe extern "C" fn(
            *const c_char,
            *const c_char,
            *const c_char,
            u8,
            u8,
            *mut c_void,
            Option<fmi3LogMessageCallback>,
        ) -> *mut Component = std::mem::transmute(*instantiate);
        let mut messages: Messages = Vec::new();
        let environment = (&raw mut messages).cast();
        let i = instantiate(
            c"crane".as_ptr(),
            fmu.token.as_ptr(),
            null(),
            0,
            0,
            environment,
            Some(log3),
        );
        assert!(!i.is_null(), "{messages:?}");
        let free = library
            .get::<unsafe extern "C" fn(*mut Component)>("fmi3FreeInstance")
            .unwrap();
        free(i);
    }
}

#[test]
fn the_same_scene_gives_the_same_bytes() {
    let scene = Scene::parse(scene::DEFAULT).unwrap_or_else(|_| panic!("the default scene is valid"));
    let library = package::Library {
        platform: "x86_64-linux".to_owned(),
        suffix: ".so".to_owned(),
        bytes: vec![7; 100_000],
    };
    for standard in [Standard::Fmi2, Standard::Fmi3] {
        let make = || {
            let documentation = [("book.pdf".to_owned(), b"%PDF".to_vec())];
            package::fmu(&scene, standard, std::slice::from_ref(&library), &documentation).unwrap()
        };
        assert_eq!(make(), make());
    }
}

/// Oil below vacuum is a warning of the call that meets it, once in a run, and a truth value as long as it lasts; a new
/// run warns anew, and a category that is switched off is not logged.
#[test]
#[expect(clippy::too_many_lines, reason = "one case after the other")]
fn oil_below_vacuum_is_warned_of_once_in_a_run() {
    let fmu = Unpacked::of(&levels::scene("hydraulic"));
    let (command, flag) = (fmu.reference("u_v"), fmu.reference("cavitates"));
    let mut messages = Vec::new();
    let i = instantiate3(&fmu, false, &mut messages);
    let mut second = Vec::new();
    let c = instantiate2(&fmu, 1, &mut second);
    // SAFETY: see above.
    unsafe {
        for run in 1..=2 {
            assert_eq!(
                fmi3EnterInitializationMode(i, 0, 0.0, 0.0, 0, 0.0) + fmi3ExitInitializationMode(i),
                STATUS_OK
            );
            assert_eq!(fmi2SetupExperiment(c, 0, 0.0, 0.0, 0, 0.0), STATUS_OK);
            assert_eq!(
                fmi2EnterInitializationMode(c) + fmi2ExitInitializationMode(c),
                STATUS_OK
            );
            let (mut warnings, mut torn) = (0, 0);
            for step in 0..60 {
                let time = 0.05 * f64::from(step);
                let value = if step < 20 { 1.0 } else { -1.0 };
                assert_eq!(fmi3SetFloat64(i, &command, 1, &value, 1), STATUS_OK);
                assert_eq!(fmi2SetReal(c, &command, 1, &value), STATUS_OK);
                let statuses = [step3(i, time, 0.05).0, fmi2DoStep(c, time, 0.05, 1)];
                assert_eq!(statuses[0], statuses[1], "both standards at {time} s");
                assert!([STATUS_OK, STATUS_WARNING].contains(&statuses[0]));
                warnings += statuses[0];
                let (mut now, mut same) = (9, 9);
                assert_eq!(fmi3GetBoolean(i, &flag, 1, &mut now, 1), STATUS_OK);
                assert_eq!(fmi2GetBoolean(c, &flag, 1, &mut same), STATUS_OK);
                assert_eq!(i32::from(now), same, "{time} s");
                torn += same;
            }
            assert_eq!(warnings, 1, "run {run}");
            assert!(torn > 0 && torn < 40, "{torn}");
            assert_eq!((messages.len(), second.len()), (run, run));
            for (status, words) in messages.iter().chain(&second) {
                assert_eq!(*status, STATUS_WARNING);
                assert!(words.contains("DoStep: the oil has fallen below -0.1 MPa"), "{words}");
            }
            assert_eq!(fmi3Reset(i) + fmi2Reset(c), STATUS_OK);
        }
        fmi3FreeInstance(i);
        fmi2FreeInstance(c);

        // In Model Exchange the event at which the oil falls below, told by its indicator.
        let mut messages = Vec::new();
        let c = instantiate2(&fmu, 0, &mut messages);
        let off = [c"logStatusWarning".as_ptr()];
        let mut info = fmi2EventInfo::default();
        assert_eq!(
            fmi2EnterInitializationMode(c) + fmi2ExitInitializationMode(c),
            STATUS_OK
        );
        assert_eq!(fmi2NewDiscreteStates(c, &mut info), STATUS_OK);
        let mut states = [0.0; 8];
        let mut indicators = [0.0; 6];
        let mut now = 9;
        for (run, pressure) in [(1, -1.5e5), (2, 20e5), (3, -1.5e5)] {
            assert_eq!(fmi2EnterContinuousTimeMode(c), STATUS_OK);
            assert_eq!(fmi2GetContinuousStates(c, states.as_mut_ptr(), 8), STATUS_OK);
            assert_eq!(fmi2GetEventIndicators(c, indicators.as_mut_ptr(), 6), STATUS_OK);
            let before = indicators[5];
            states[5] = pressure;
            assert_eq!(fmi2SetContinuousStates(c, states.as_ptr(), 8), STATUS_OK);
            assert_eq!(fmi2GetEventIndicators(c, indicators.as_mut_ptr(), 6), STATUS_OK);
            assert!(before * indicators[5] < 0.0, "an event: {before} {}", indicators[5]);
            assert_eq!(fmi2GetBoolean(c, &flag, 1, &mut now), STATUS_OK);
            assert_eq!(now != 0, run == 2, "held until the event");
            assert_eq!(fmi2EnterEventMode(c), STATUS_OK);
            let status = fmi2NewDiscreteStates(c, &mut info);
            assert_eq!(status, if run == 1 { STATUS_WARNING } else { STATUS_OK });
            assert_eq!(fmi2GetBoolean(c, &flag, 1, &mut now), STATUS_OK);
            assert_eq!(now != 0, run != 2);
        }
        assert_eq!(messages.len(), 1, "{messages:?}");
        assert_eq!(fmi2SetDebugLogging(c, 0, 1, off.as_ptr()), STATUS_OK);
        assert_eq!(fmi2Reset(c), STATUS_OK);
        assert_eq!(fmi2EnterInitializationMode(c), STATUS_OK);
        let pressure = fmu.reference("p_B");
        assert_eq!(fmi2SetReal(c, &pressure, 1, &-1.5e5), STATUS_OK);
        assert_eq!(fmi2ExitInitializationMode(c), STATUS_WARNING, "from the start");
        assert_eq!(messages.len(), 1, "switched off");
        fmi2FreeInstance(c);
    }
}

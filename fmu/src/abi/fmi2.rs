//! FMI 2.0: the C functions, under their names in the standard.

#![allow(non_snake_case, non_camel_case_types)]
#![expect(clippy::missing_safety_doc, reason = "the standard says what each function expects")]

use super::{Component, Log, Status, c_string, exports, free, guard, instantiate, own_resources};
use super::{place, slice, slice_mut, text, texts};
use crate::instance::{ANY, CONTINUOUS, EVENT, INITIALIZATION, INSTANTIATED, NEVER, STEP, States, TERMINATED};
use crate::instance::{Instance, Interface, expect_none};
use crate::refuse;
use lemnis_models::kernel::variable::Fault;
use std::ffi::{c_char, c_int, c_void};
use std::path::PathBuf;

/// C's `int`: 0 is false.
pub type fmi2Boolean = c_int;

/// The variadic logger of the importer; its message is a printf format.
pub type fmi2CallbackLogger =
    unsafe extern "C" fn(*mut c_void, *const c_char, Status, *const c_char, *const c_char, ...);

/// What the importer provides. Memory is Rust's own here, and no step is asynchronous.
#[repr(C)]
pub struct fmi2CallbackFunctions {
    pub logger: Option<fmi2CallbackLogger>,
    pub allocateMemory: *const c_void,
    pub freeMemory: *const c_void,
    pub stepFinished: *const c_void,
    pub componentEnvironment: *mut c_void,
}

/// Answer of [`fmi2NewDiscreteStates`].
#[derive(Debug, Default)]
#[repr(C)]
pub struct fmi2EventInfo {
    pub newDiscreteStatesNeeded: fmi2Boolean,
    pub terminateSimulation: fmi2Boolean,
    pub nominalsOfContinuousStatesChanged: fmi2Boolean,
    pub valuesOfContinuousStatesChanged: fmi2Boolean,
    pub nextEventTimeDefined: fmi2Boolean,
    pub nextEventTime: f64,
}

/// `fmi2LastSuccessfulTime` and `fmi2Terminated` of `fmi2StatusKind`.
const LAST_SUCCESSFUL_TIME: c_int = 2;
const TERMINATED_STATUS: c_int = 3;

#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetTypesPlatform() -> *const c_char {
    c"default".as_ptr()
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetVersion() -> *const c_char {
    c"2.0".as_ptr()
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2Instantiate(
    instanceName: *const c_char,
    fmuType: c_int,
    fmuGUID: *const c_char,
    fmuResourceLocation: *const c_char,
    functions: *const fmi2CallbackFunctions,
    _visible: fmi2Boolean,
    _loggingOn: fmi2Boolean,
) -> *mut Component {
    // SAFETY: the standard has the importer pass strings that end with a zero, and its functions.
    unsafe {
        let name = text(instanceName, "instanceName");
        let log = logger(functions, name.as_deref().unwrap_or(""));
        instantiate(log, "fmi2Instantiate", || {
            name?;
            let interface = match fmuType {
                0 => Interface::ModelExchange,
                1 => Interface::CoSimulation,
                _ => return refuse(format!("fmuType {fmuType} does not exist")),
            };
            let resources = match fmuResourceLocation.is_null() {
                true => own_resources()?,
                false => path_of_uri(text(fmuResourceLocation, "fmuResourceLocation")?)?,
            };
            Instance::load(&resources, text(fmuGUID, "fmuGUID")?, interface)
        })
    }
}

/// The importer's logger: the message is a format, so each `%` in it is doubled.
///
/// # Safety
/// `functions` is null or as the standard has it, and its logger outlives the instance.
unsafe fn logger(functions: *const fmi2CallbackFunctions, name: &str) -> Log {
    // SAFETY: the caller's promise.
    let Some(&fmi2CallbackFunctions {
        logger: Some(logger),
        componentEnvironment,
        ..
    }) = (unsafe { functions.as_ref() })
    else {
        return Box::new(|_, _, _| ());
    };
    let name = c_string(name);
    Box::new(move |status, category, message| {
        let format = c_string(&message.to_string_lossy().replace('%', "%%"));
        // SAFETY: the strings outlive the call, and the format has no conversions.
        unsafe {
            logger(
                componentEnvironment,
                name.as_ptr(),
                status,
                category.as_ptr(),
                format.as_ptr(),
            )
        }
    })
}

/// The folder that a resource location means: a file URI in any of its forms, or a plain path.
fn path_of_uri(uri: &str) -> Result<PathBuf, Fault> {
    let Some(rest) = uri.strip_prefix("file:") else {
        return Ok(uri.into());
    };
    let path = match rest.strip_prefix("//") {
        Some(rest) => rest.strip_prefix("localhost").unwrap_or(rest),
        None => rest,
    };
    let mut bytes = Vec::with_capacity(path.len());
    let mut rest = path.as_bytes();
    while let Some((&byte, tail)) = rest.split_first() {
        let code = tail
            .get(..2)
            .filter(|_| byte == b'%')
            .and_then(|hex| std::str::from_utf8(hex).ok());
        match code.and_then(|hex| u8::from_str_radix(hex, 16).ok()) {
            Some(decoded) => {
                bytes.push(decoded);
                rest = &tail[2..];
            }
            None => {
                bytes.push(byte);
                rest = tail;
            }
        }
    }
    let path = String::from_utf8(bytes).map_err(|_| Fault::new(format!("the resource location {uri} is not UTF-8")))?;
    // file:///C:/folder
    let drive = path.get(2..3) == Some(":") && path.starts_with('/');
    Ok(PathBuf::from(if drive { &path[1..] } else { &path }))
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2FreeInstance(component: *mut Component) {
    // SAFETY: the standard has the importer free an instance once.
    unsafe { free(component) }
}

const GET: States = INITIALIZATION | EVENT | CONTINUOUS | STEP | TERMINATED;
const SET: States = INSTANTIATED | INITIALIZATION | EVENT | STEP;

/// The functions for which the standard provides `fmi2Discard`. A step that
/// could not be carried out at all is an error in its words.
fn discards(name: &str) -> States {
    match name {
        "fmi2SetReal" => ANY,
        "fmi2GetReal" => EVENT | CONTINUOUS,
        _ => NEVER,
    }
}

// FMU states are handles in the instance, in the place of the standard's pointers.
exports! { FMI2, i;
    fn fmi2SetDebugLogging(on: fmi2Boolean, n: usize, categories: *const *const c_char) in ANY =>
        i.set_logged(on != 0, &texts(categories, n)?);

    fn fmi2SetupExperiment(_: fmi2Boolean, _: f64, start: f64, stop_defined: fmi2Boolean, stop: f64) in INSTANTIATED =>
        i.set_up(start, (stop_defined != 0).then_some(stop));
    fn fmi2EnterInitializationMode() in INSTANTIATED => i.enter(INITIALIZATION);
    fn fmi2ExitInitializationMode() in INITIALIZATION => i.start();
    fn fmi2Terminate() in EVENT | CONTINUOUS | STEP => i.enter(TERMINATED);
    fn fmi2Reset() in ANY => i.reset();

    fn fmi2GetReal(references: *const u32, n: usize, values: *mut f64) in GET =>
        i.get_reals(slice(references, n)?, slice_mut(values, n)?);
    fn fmi2GetInteger(references: *const u32, n: usize, values: *mut c_int) in GET =>
        i.get_enumerations(slice(references, n)?, slice_mut(values, n)?);
    fn fmi2GetBoolean(references: *const u32, n: usize, values: *mut fmi2Boolean) in GET =>
        i.get_booleans(slice(references, n)?, slice_mut(values, n)?);
    fn fmi2GetString(references: *const u32, n: usize, values: *mut *const c_char) in GET =>
        i.get_strings(slice(references, n)?, slice_mut(values, n)?);

    fn fmi2SetReal(references: *const u32, n: usize, values: *const f64) in SET | CONTINUOUS =>
        i.set_reals(slice(references, n)?, slice(values, n)?);
    fn fmi2SetInteger(references: *const u32, n: usize, values: *const c_int) in SET | CONTINUOUS =>
        i.set_enumerations(slice(references, n)?, slice(values, n)?);
    fn fmi2SetBoolean(references: *const u32, n: usize, _: *const fmi2Boolean) in SET =>
        i.set_booleans(slice(references, n)?);
    fn fmi2SetString(_: *const u32, n: usize, _: *const *const c_char) in SET => expect_none(n);

    fn fmi2GetFMUstate(state: *mut usize) in ANY => {
        let state = place(state)?;
        *state = i.save(*state)?;
        Ok(())
    };
    fn fmi2SetFMUstate(state: usize) in ANY => i.load_saved(state);
    fn fmi2FreeFMUstate(state: *mut usize) in ANY => i.forget(std::mem::take(place(state)?));
    fn fmi2SerializedFMUstateSize(state: usize, size: *mut usize) in ANY => {
        *place(size)? = i.serialized_size(state)?;
        Ok(())
    };
    fn fmi2SerializeFMUstate(state: usize, bytes: *mut u8, size: usize) in ANY =>
        i.serialize(state, slice_mut(bytes, size)?);
    fn fmi2DeSerializeFMUstate(bytes: *const u8, size: usize, state: *mut usize) in ANY => {
        let state = place(state)?;
        *state = i.deserialize(slice(bytes, size)?, *state)?;
        Ok(())
    };

    fn fmi2GetDirectionalDerivative(
        unknowns: *const u32, m: usize, knowns: *const u32, n: usize, seed: *const f64, sensitivity: *mut f64,
    ) in GET => i.directional(slice(unknowns, m)?, slice(knowns, n)?, slice(seed, n)?, slice_mut(sensitivity, m)?);

    // Model Exchange
    fn fmi2EnterEventMode() in EVENT | CONTINUOUS => i.enter_event_mode();
    fn fmi2NewDiscreteStates(info: *mut fmi2EventInfo) in EVENT => {
        let values_changed = i.update_discrete()?;
        let next = i.next_event();
        *place(info)? = fmi2EventInfo {
            valuesOfContinuousStatesChanged: values_changed.into(),
            nextEventTimeDefined: next.is_some().into(),
            nextEventTime: next.unwrap_or(0.0),
            ..fmi2EventInfo::default()
        };
        Ok(())
    };
    fn fmi2EnterContinuousTimeMode() in EVENT => i.enter(CONTINUOUS);
    fn fmi2CompletedIntegratorStep(_: fmi2Boolean, enter_event: *mut fmi2Boolean, terminate: *mut fmi2Boolean)
        in CONTINUOUS => {
        *place(enter_event)? = i.wants_event().into();
        *place(terminate)? = 0;
        Ok(())
    };
    fn fmi2SetTime(time: f64) in EVENT | CONTINUOUS => i.set_time(time);
    fn fmi2SetContinuousStates(values: *const f64, n: usize) in CONTINUOUS => i.set_states(slice(values, n)?);
    fn fmi2GetDerivatives(values: *mut f64, n: usize) in EVENT | CONTINUOUS | TERMINATED =>
        i.get_rates(slice_mut(values, n)?);
    fn fmi2GetEventIndicators(values: *mut f64, n: usize) in INITIALIZATION | EVENT | CONTINUOUS | TERMINATED =>
        i.get_indicators(slice_mut(values, n)?);
    fn fmi2GetContinuousStates(values: *mut f64, n: usize) in INITIALIZATION | EVENT | CONTINUOUS | TERMINATED =>
        i.get_states(slice_mut(values, n)?);
    fn fmi2GetNominalsOfContinuousStates(values: *mut f64, n: usize) in INSTANTIATED | EVENT | CONTINUOUS | TERMINATED =>
        i.get_nominals(slice_mut(values, n)?);

    // Co-Simulation
    fn fmi2SetRealInputDerivatives(_: *const u32, _: usize, _: *const c_int, _: *const f64) in NEVER => Ok(());
    fn fmi2GetRealOutputDerivatives(_: *const u32, _: usize, _: *const c_int, _: *mut f64) in NEVER => Ok(());
    fn fmi2DoStep(point: f64, size: f64, _: fmi2Boolean) in STEP => i.step(point, size);
    fn fmi2CancelStep() in NEVER => Ok(());
    fn fmi2GetStatus(_: c_int, _: *mut Status) in NEVER => Ok(());
    fn fmi2GetRealStatus(kind: c_int, value: *mut f64) in STEP | TERMINATED => match kind {
        LAST_SUCCESSFUL_TIME => {
            *place(value)? = i.time();
            Ok(())
        }
        _ => refuse(format!("status kind {kind} is not a real number")),
    };
    fn fmi2GetIntegerStatus(_: c_int, _: *mut c_int) in NEVER => Ok(());
    fn fmi2GetBooleanStatus(kind: c_int, value: *mut fmi2Boolean) in STEP | TERMINATED => match kind {
        TERMINATED_STATUS => {
            *place(value)? = 0;
            Ok(())
        }
        _ => refuse(format!("status kind {kind} is not a truth value")),
    };
    fn fmi2GetStringStatus(_: c_int, _: *mut *const c_char) in NEVER => Ok(());
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn resource_locations() {
        for (uri, path) in [
            ("file:///tmp/a%20b/resources", "/tmp/a b/resources"),
            ("file:/tmp/resources/", "/tmp/resources/"),
            ("file://localhost/tmp/r", "/tmp/r"),
            ("file:///C:/fmu/resources", "C:/fmu/resources"),
            ("/tmp/100%/r", "/tmp/100%/r"),
            ("file:///tmp/100%/%C3%A4", "/tmp/100%/ä"),
            ("file:", ""),
        ] {
            assert_eq!(path_of_uri(uri), Ok(PathBuf::from(path)), "{uri}");
        }
        assert!(path_of_uri("file:///%ff").is_err());
    }
}

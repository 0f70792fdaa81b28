//! FMI 3.0: the C functions, under their names in the standard.

#![allow(non_snake_case, non_camel_case_types)]
#![expect(clippy::missing_safety_doc, reason = "the standard says what each function expects")]

use super::{Component, Log, Status, exports, free, guard, instantiate, own_resources};
use super::{place, slice, slice_mut, text, texts};
use crate::instance::{
    ANY, CONTINUOUS, EVENT, INITIALIZATION, INSTANTIATED, NEVER, STEP, STEP_EVENT, States, TERMINATED,
};
use crate::instance::{Instance, Interface, expect_none};
use crate::refuse;
use std::ffi::{c_char, c_int, c_void};

/// C's `bool`, as the byte that it is: importers may pass any value.
pub type fmi3Boolean = u8;

/// The logger of the importer.
pub type fmi3LogMessageCallback = unsafe extern "C" fn(*mut c_void, Status, *const c_char, *const c_char);

#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetVersion() -> *const c_char {
    c"3.0".as_ptr()
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3InstantiateModelExchange(
    instanceName: *const c_char,
    instantiationToken: *const c_char,
    resourcePath: *const c_char,
    _visible: fmi3Boolean,
    _loggingOn: fmi3Boolean,
    instanceEnvironment: *mut c_void,
    logMessage: Option<fmi3LogMessageCallback>,
) -> *mut Component {
    let log = logger(instanceEnvironment, logMessage);
    // SAFETY: the standard has the importer pass strings that end with a zero.
    unsafe {
        instantiate(log, "fmi3InstantiateModelExchange", || {
            load(instanceName, instantiationToken, resourcePath, Interface::ModelExchange)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3InstantiateCoSimulation(
    instanceName: *const c_char,
    instantiationToken: *const c_char,
    resourcePath: *const c_char,
    _visible: fmi3Boolean,
    _loggingOn: fmi3Boolean,
    eventModeUsed: fmi3Boolean,
    _earlyReturnAllowed: fmi3Boolean,
    _requiredIntermediateVariables: *const u32,
    _nRequiredIntermediateVariables: usize,
    instanceEnvironment: *mut c_void,
    logMessage: Option<fmi3LogMessageCallback>,
    _intermediateUpdate: *const c_void,
) -> *mut Component {
    let log = logger(instanceEnvironment, logMessage);
    let interface = if eventModeUsed == 0 {
        Interface::CoSimulation
    } else {
        Interface::CoSimulationWithEvents
    };
    // SAFETY: the standard has the importer pass strings that end with a zero.
    unsafe {
        instantiate(log, "fmi3InstantiateCoSimulation", || {
            load(instanceName, instantiationToken, resourcePath, interface)
        })
    }
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi3InstantiateScheduledExecution(
    _instanceName: *const c_char,
    _instantiationToken: *const c_char,
    _resourcePath: *const c_char,
    _visible: fmi3Boolean,
    _loggingOn: fmi3Boolean,
    instanceEnvironment: *mut c_void,
    logMessage: Option<fmi3LogMessageCallback>,
    _clockUpdate: *const c_void,
    _lockPreemption: *const c_void,
    _unlockPreemption: *const c_void,
) -> *mut Component {
    instantiate(
        logger(instanceEnvironment, logMessage),
        "fmi3InstantiateScheduledExecution",
        || refuse("the FMU has no Scheduled Execution"),
    )
}

fn logger(environment: *mut c_void, callback: Option<fmi3LogMessageCallback>) -> Log {
    match callback {
        // SAFETY: the strings outlive the call; the importer's logger outlives the instance.
        Some(log) => Box::new(move |status, category, message| unsafe {
            log(environment, status, category.as_ptr(), message.as_ptr());
        }),
        None => Box::new(|_, _, _| ()),
    }
}

/// # Safety
/// The pointers are null or point to strings that end with a zero.
unsafe fn load(
    name: *const c_char,
    token: *const c_char,
    resources: *const c_char,
    interface: Interface,
) -> Result<Instance, lemnis_models::kernel::variable::Fault> {
    // SAFETY: the caller's promise.
    unsafe {
        text(name, "instanceName")?;
        let resources = match resources.is_null() {
            true => own_resources()?,
            false => text(resources, "resourcePath")?.into(),
        };
        Instance::load(&resources, text(token, "instantiationToken")?, interface)
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3FreeInstance(component: *mut Component) {
    // SAFETY: the standard has the importer free an instance once.
    unsafe { free(component) }
}

const GET: States = INITIALIZATION | EVENT | CONTINUOUS | STEP | STEP_EVENT | TERMINATED;
const SET: States = INSTANTIATED | INITIALIZATION | EVENT | STEP | STEP_EVENT;
const MODEL_EXCHANGE: States = INITIALIZATION | EVENT | CONTINUOUS | TERMINATED;

/// A call that came to nothing leaves the instance as it was, and other values may do.
fn discards(_: &str) -> States {
    ANY
}

// FMU states are handles in the instance, in the place of the standard's pointers.
exports! { FMI3, i;
    fn fmi3SetDebugLogging(on: fmi3Boolean, n: usize, categories: *const *const c_char) in ANY =>
        i.set_logged(on != 0, &texts(categories, n)?);

    fn fmi3EnterInitializationMode(_: fmi3Boolean, _: f64, start: f64, stop_defined: fmi3Boolean, stop: f64)
        in INSTANTIATED => {
        i.set_up(start, (stop_defined != 0).then_some(stop))?;
        i.enter(INITIALIZATION)
    };
    fn fmi3ExitInitializationMode() in INITIALIZATION => i.start();
    fn fmi3EnterEventMode() in CONTINUOUS | STEP => i.enter_event_mode();
    fn fmi3Terminate() in EVENT | CONTINUOUS | STEP | STEP_EVENT => i.enter(TERMINATED);
    fn fmi3Reset() in ANY => i.reset();

    fn fmi3GetFloat32(_: *const u32, n: usize, _: *mut f32, _: usize) in GET => expect_none(n);
    fn fmi3GetFloat64(references: *const u32, n: usize, values: *mut f64, m: usize) in GET =>
        i.get_reals(slice(references, n)?, slice_mut(values, m)?);
    fn fmi3GetInt8(_: *const u32, n: usize, _: *mut i8, _: usize) in GET => expect_none(n);
    fn fmi3GetUInt8(_: *const u32, n: usize, _: *mut u8, _: usize) in GET => expect_none(n);
    fn fmi3GetInt16(_: *const u32, n: usize, _: *mut i16, _: usize) in GET => expect_none(n);
    fn fmi3GetUInt16(_: *const u32, n: usize, _: *mut u16, _: usize) in GET => expect_none(n);
    fn fmi3GetInt32(_: *const u32, n: usize, _: *mut i32, _: usize) in GET => expect_none(n);
    fn fmi3GetUInt32(_: *const u32, n: usize, _: *mut u32, _: usize) in GET => expect_none(n);
    fn fmi3GetInt64(references: *const u32, n: usize, values: *mut i64, m: usize) in GET =>
        i.get_enumerations(slice(references, n)?, slice_mut(values, m)?);
    fn fmi3GetUInt64(_: *const u32, n: usize, _: *mut u64, _: usize) in GET => expect_none(n);
    fn fmi3GetBoolean(references: *const u32, n: usize, values: *mut fmi3Boolean, m: usize) in GET =>
        i.get_booleans(slice(references, n)?, slice_mut(values, m)?);
    fn fmi3GetString(references: *const u32, n: usize, values: *mut *const c_char, m: usize) in GET =>
        i.get_strings(slice(references, n)?, slice_mut(values, m)?);
    fn fmi3GetBinary(_: *const u32, n: usize, _: *mut usize, _: *mut *const u8, _: usize) in GET =>
        expect_none(n);
    fn fmi3GetClock(_: *const u32, n: usize, _: *mut fmi3Boolean) in GET => expect_none(n);

    fn fmi3SetFloat32(_: *const u32, n: usize, _: *const f32, _: usize) in SET | CONTINUOUS => expect_none(n);
    fn fmi3SetFloat64(references: *const u32, n: usize, values: *const f64, m: usize) in SET | CONTINUOUS =>
        i.set_reals(slice(references, n)?, slice(values, m)?);
    fn fmi3SetInt8(_: *const u32, n: usize, _: *const i8, _: usize) in SET => expect_none(n);
    fn fmi3SetUInt8(_: *const u32, n: usize, _: *const u8, _: usize) in SET => expect_none(n);
    fn fmi3SetInt16(_: *const u32, n: usize, _: *const i16, _: usize) in SET => expect_none(n);
    fn fmi3SetUInt16(_: *const u32, n: usize, _: *const u16, _: usize) in SET => expect_none(n);
    fn fmi3SetInt32(_: *const u32, n: usize, _: *const i32, _: usize) in SET => expect_none(n);
    fn fmi3SetUInt32(_: *const u32, n: usize, _: *const u32, _: usize) in SET => expect_none(n);
    fn fmi3SetInt64(references: *const u32, n: usize, values: *const i64, m: usize) in SET | CONTINUOUS =>
        i.set_enumerations(slice(references, n)?, slice(values, m)?);
    fn fmi3SetUInt64(_: *const u32, n: usize, _: *const u64, _: usize) in SET => expect_none(n);
    fn fmi3SetBoolean(references: *const u32, n: usize, _: *const fmi3Boolean, _: usize) in SET =>
        i.set_booleans(slice(references, n)?);
    fn fmi3SetString(_: *const u32, n: usize, _: *const *const c_char, _: usize) in SET => expect_none(n);
    fn fmi3SetBinary(_: *const u32, n: usize, _: *const usize, _: *const *const u8, _: usize) in SET =>
        expect_none(n);
    fn fmi3SetClock(_: *const u32, n: usize, _: *const fmi3Boolean) in SET => expect_none(n);

    fn fmi3GetNumberOfVariableDependencies(_: u32, _: *mut usize) in NEVER => Ok(());
    fn fmi3GetVariableDependencies(_: u32, _: *mut usize, _: *mut u32, _: *mut usize, _: *mut c_int, _: usize)
        in NEVER => Ok(());

    fn fmi3GetFMUState(state: *mut usize) in ANY => {
        let state = place(state)?;
        *state = i.save(*state)?;
        Ok(())
    };
    fn fmi3SetFMUState(state: usize) in ANY => i.load_saved(state);
    fn fmi3FreeFMUState(state: *mut usize) in ANY => i.forget(std::mem::take(place(state)?));
    fn fmi3SerializedFMUStateSize(state: usize, size: *mut usize) in ANY => {
        *place(size)? = i.serialized_size(state)?;
        Ok(())
    };
    fn fmi3SerializeFMUState(state: usize, bytes: *mut u8, size: usize) in ANY =>
        i.serialize(state, slice_mut(bytes, size)?);
    fn fmi3DeserializeFMUState(bytes: *const u8, size: usize, state: *mut usize) in ANY => {
        let state = place(state)?;
        *state = i.deserialize(slice(bytes, size)?, *state)?;
        Ok(())
    };

    fn fmi3GetDirectionalDerivative(
        unknowns: *const u32, m: usize, knowns: *const u32, n: usize,
        seed: *const f64, seeds: usize, sensitivity: *mut f64, sensitivities: usize,
    ) in GET => i.directional(
        slice(unknowns, m)?, slice(knowns, n)?, slice(seed, seeds)?, slice_mut(sensitivity, sensitivities)?,
    );
    fn fmi3GetAdjointDerivative(
        unknowns: *const u32, m: usize, knowns: *const u32, n: usize,
        seed: *const f64, seeds: usize, sensitivity: *mut f64, sensitivities: usize,
    ) in GET => i.adjoint(
        slice(unknowns, m)?, slice(knowns, n)?, slice(seed, seeds)?, slice_mut(sensitivity, sensitivities)?,
    );

    fn fmi3EnterConfigurationMode() in NEVER => Ok(());
    fn fmi3ExitConfigurationMode() in NEVER => Ok(());

    fn fmi3GetIntervalDecimal(_: *const u32, _: usize, _: *mut f64, _: *mut c_int) in NEVER => Ok(());
    fn fmi3GetIntervalFraction(_: *const u32, _: usize, _: *mut u64, _: *mut u64, _: *mut c_int) in NEVER => Ok(());
    fn fmi3GetShiftDecimal(_: *const u32, _: usize, _: *mut f64) in NEVER => Ok(());
    fn fmi3GetShiftFraction(_: *const u32, _: usize, _: *mut u64, _: *mut u64) in NEVER => Ok(());
    fn fmi3SetIntervalDecimal(_: *const u32, _: usize, _: *const f64) in NEVER => Ok(());
    fn fmi3SetIntervalFraction(_: *const u32, _: usize, _: *const u64, _: *const u64) in NEVER => Ok(());
    fn fmi3SetShiftDecimal(_: *const u32, _: usize, _: *const f64) in NEVER => Ok(());
    fn fmi3SetShiftFraction(_: *const u32, _: usize, _: *const u64, _: *const u64) in NEVER => Ok(());

    fn fmi3EvaluateDiscreteStates() in INITIALIZATION | EVENT | STEP_EVENT => Ok(());
    fn fmi3UpdateDiscreteStates(
        needs_update: *mut fmi3Boolean, terminate: *mut fmi3Boolean, nominals_changed: *mut fmi3Boolean,
        values_changed: *mut fmi3Boolean, next_event_defined: *mut fmi3Boolean, next_event: *mut f64,
    ) in EVENT | STEP_EVENT => {
        for flag in [needs_update, terminate, nominals_changed] {
            *place(flag)? = 0;
        }
        *place(values_changed)? = i.update_discrete()?.into();
        let next = i.next_event();
        *place(next_event_defined)? = next.is_some().into();
        *place(next_event)? = next.unwrap_or(0.0);
        Ok(())
    };

    // Model Exchange
    fn fmi3EnterContinuousTimeMode() in EVENT => i.enter(CONTINUOUS);
    fn fmi3CompletedIntegratorStep(_: fmi3Boolean, enter_event: *mut fmi3Boolean, terminate: *mut fmi3Boolean)
        in CONTINUOUS => {
        *place(enter_event)? = i.wants_event().into();
        *place(terminate)? = 0;
        Ok(())
    };
    fn fmi3SetTime(time: f64) in EVENT | CONTINUOUS => i.set_time(time);
    fn fmi3SetContinuousStates(values: *const f64, n: usize) in CONTINUOUS => i.set_states(slice(values, n)?);
    fn fmi3GetContinuousStateDerivatives(values: *mut f64, n: usize) in MODEL_EXCHANGE =>
        i.get_rates(slice_mut(values, n)?);
    fn fmi3GetEventIndicators(values: *mut f64, n: usize) in MODEL_EXCHANGE => i.get_indicators(slice_mut(values, n)?);
    fn fmi3GetContinuousStates(values: *mut f64, n: usize) in MODEL_EXCHANGE => i.get_states(slice_mut(values, n)?);
    fn fmi3GetNominalsOfContinuousStates(values: *mut f64, n: usize) in MODEL_EXCHANGE =>
        i.get_nominals(slice_mut(values, n)?);
    fn fmi3GetNumberOfEventIndicators(n: *mut usize) in INSTANTIATED | MODEL_EXCHANGE => {
        *place(n)? = i.indicators();
        Ok(())
    };
    fn fmi3GetNumberOfContinuousStates(n: *mut usize) in INSTANTIATED | MODEL_EXCHANGE => {
        *place(n)? = i.states();
        Ok(())
    };

    // Co-Simulation
    fn fmi3EnterStepMode() in STEP_EVENT => i.enter(STEP);
    fn fmi3GetOutputDerivatives(_: *const u32, _: usize, _: *const i32, _: *mut f64, _: usize) in NEVER => Ok(());
    fn fmi3DoStep(
        point: f64, size: f64, _: fmi3Boolean, event_needed: *mut fmi3Boolean, terminate: *mut fmi3Boolean,
        early_return: *mut fmi3Boolean, last_successful_time: *mut f64,
    ) in STEP => {
        for flag in [event_needed, terminate, early_return] {
            *place(flag)? = 0;
        }
        let result = i.step(point, size);
        *place(last_successful_time)? = i.time();
        result
    };

    // Scheduled Execution
    fn fmi3ActivateModelPartition(_: u32, _: f64) in NEVER => Ok(());
}

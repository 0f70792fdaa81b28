//! Which function is allowed in which state, pair by pair, called through the C functions.
//!
//! The tables here were written from the standards (FMI 2.0.4, 3.2.3 and 4.2.4; FMI 3.0,
//! 2.3 to 4.2), not from those in the code: I instantiated, N initialization mode, E event mode
//! of Model Exchange, C continuous-time mode, S step mode, V event mode of Co-Simulation,
//! T terminated. A function of a capability that the description does not claim is allowed nowhere.

mod common;

use common::{Messages, Unpacked, instantiate2, instantiate3, instantiate3_model_exchange};
use lemnis_fmu::abi::{Component, STATUS_ERROR, STATUS_OK, Status, fmi2::*, fmi3::*};
use std::ptr::{null, null_mut};

/// A function by name, the states that allow it, and a call that has nothing else wrong.
type Case = (&'static str, &'static str, fn(*mut Component) -> Status);

macro_rules! cases {
    ($($allowed:literal $function:ident($($argument:expr),*);)*) => {
        // SAFETY: the component is alive, and every array has the length given.
        &[$((stringify!($function), $allowed, |c| unsafe { $function(c $(, $argument)*) })),*]
    };
}

const FMI2_CASES: &[Case] = cases! {
    "INECST" fmi2SetDebugLogging(0, 0, null());
    "I"      fmi2SetupExperiment(0, 0.0, 0.0, 0, 0.0);
    "I"      fmi2EnterInitializationMode();
    "N"      fmi2ExitInitializationMode();
    "ECS"    fmi2Terminate();
    "INECST" fmi2Reset();
    "NECST"  fmi2GetReal(null(), 0, null_mut());
    "NECST"  fmi2GetInteger(null(), 0, null_mut());
    "NECST"  fmi2GetBoolean(null(), 0, null_mut());
    "NECST"  fmi2GetString(null(), 0, null_mut());
    "INECS"  fmi2SetReal(null(), 0, null());
    "INECS"  fmi2SetInteger(null(), 0, null());
    "INES"   fmi2SetBoolean(null(), 0, null());
    "INES"   fmi2SetString(null(), 0, null());
    "INECST" fmi2GetFMUstate(&mut 0);
    "INECST" fmi2FreeFMUstate(&mut 0);
    "NECST"  fmi2GetDirectionalDerivative(null(), 0, null(), 0, null(), null_mut());
    "EC"     fmi2EnterEventMode();
    "E"      fmi2NewDiscreteStates(&mut fmi2EventInfo::default());
    "E"      fmi2EnterContinuousTimeMode();
    "C"      fmi2CompletedIntegratorStep(1, &mut 0, &mut 0);
    "EC"     fmi2SetTime(0.5);
    "C"      fmi2SetContinuousStates(null(), 0);
    "ECT"    fmi2GetDerivatives(null_mut(), 0);
    "NECT"   fmi2GetEventIndicators(null_mut(), 0);
    "NECT"   fmi2GetContinuousStates(null_mut(), 0);
    "IECT"   fmi2GetNominalsOfContinuousStates(null_mut(), 0);
    ""       fmi2SetRealInputDerivatives(null(), 0, null(), null());
    ""       fmi2GetRealOutputDerivatives(null(), 0, null(), null_mut());
    "S"      fmi2DoStep(0.0, 0.1, 1);
    ""       fmi2CancelStep();
    ""       fmi2GetStatus(0, &mut 0);
    "ST"     fmi2GetRealStatus(2, &mut 0.0);
    ""       fmi2GetIntegerStatus(0, &mut 0);
    "ST"     fmi2GetBooleanStatus(3, &mut 0);
    ""       fmi2GetStringStatus(0, &mut null());
};

/// With a state saved before.
const FMI2_STATE_CASES: &[Case] = cases! {
    "INECST" fmi2SetFMUstate(1);
    "INECST" fmi2SerializedFMUstateSize(1, &mut 0);
};

const FMI3_CASES: &[Case] = cases! {
    "INECSVT" fmi3SetDebugLogging(0, 0, null());
    "I"       fmi3EnterInitializationMode(0, 0.0, 0.0, 0, 0.0);
    "N"       fmi3ExitInitializationMode();
    "CW"      fmi3EnterEventMode();
    "ECSVW"   fmi3Terminate();
    "INECSVT" fmi3Reset();
    "NECSVT"  fmi3GetFloat32(null(), 0, null_mut(), 0);
    "NECSVT"  fmi3GetFloat64(null(), 0, null_mut(), 0);
    "NECSVT"  fmi3GetInt8(null(), 0, null_mut(), 0);
    "NECSVT"  fmi3GetUInt8(null(), 0, null_mut(), 0);
    "NECSVT"  fmi3GetInt16(null(), 0, null_mut(), 0);
    "NECSVT"  fmi3GetUInt16(null(), 0, null_mut(), 0);
    "NECSVT"  fmi3GetInt32(null(), 0, null_mut(), 0);
    "NECSVT"  fmi3GetUInt32(null(), 0, null_mut(), 0);
    "NECSVT"  fmi3GetInt64(null(), 0, null_mut(), 0);
    "NECSVT"  fmi3GetUInt64(null(), 0, null_mut(), 0);
    "NECSVT"  fmi3GetBoolean(null(), 0, null_mut(), 0);
    "NECSVT"  fmi3GetString(null(), 0, null_mut(), 0);
    "NECSVT"  fmi3GetBinary(null(), 0, null_mut(), null_mut(), 0);
    "NECSVT"  fmi3GetClock(null(), 0, null_mut());
    "INECSV"  fmi3SetFloat32(null(), 0, null(), 0);
    "INECSV"  fmi3SetFloat64(null(), 0, null(), 0);
    "INESV"   fmi3SetInt8(null(), 0, null(), 0);
    "INESV"   fmi3SetUInt8(null(), 0, null(), 0);
    "INESV"   fmi3SetInt16(null(), 0, null(), 0);
    "INESV"   fmi3SetUInt16(null(), 0, null(), 0);
    "INESV"   fmi3SetInt32(null(), 0, null(), 0);
    "INESV"   fmi3SetUInt32(null(), 0, null(), 0);
    "INECSV"  fmi3SetInt64(null(), 0, null(), 0);
    "INESV"   fmi3SetUInt64(null(), 0, null(), 0);
    "INESV"   fmi3SetBoolean(null(), 0, null(), 0);
    "INESV"   fmi3SetString(null(), 0, null(), 0);
    "INESV"   fmi3SetBinary(null(), 0, null(), null(), 0);
    "INESV"   fmi3SetClock(null(), 0, null());
    ""        fmi3GetNumberOfVariableDependencies(1, &mut 0);
    ""        fmi3GetVariableDependencies(1, null_mut(), null_mut(), null_mut(), null_mut(), 0);
    "INECSVT" fmi3GetFMUState(&mut 0);
    "INECSVT" fmi3FreeFMUState(&mut 0);
    "NECSVT"  fmi3GetDirectionalDerivative(null(), 0, null(), 0, null(), 0, null_mut(), 0);
    "NECSVT"  fmi3GetAdjointDerivative(null(), 0, null(), 0, null(), 0, null_mut(), 0);
    ""        fmi3EnterConfigurationMode();
    ""        fmi3ExitConfigurationMode();
    ""        fmi3GetIntervalDecimal(null(), 0, null_mut(), null_mut());
    ""        fmi3GetIntervalFraction(null(), 0, null_mut(), null_mut(), null_mut());
    ""        fmi3GetShiftDecimal(null(), 0, null_mut());
    ""        fmi3GetShiftFraction(null(), 0, null_mut(), null_mut());
    ""        fmi3SetIntervalDecimal(null(), 0, null());
    ""        fmi3SetIntervalFraction(null(), 0, null(), null());
    ""        fmi3SetShiftDecimal(null(), 0, null());
    ""        fmi3SetShiftFraction(null(), 0, null(), null());
    "NEV"     fmi3EvaluateDiscreteStates();
    "EV"      fmi3UpdateDiscreteStates(&mut 0, &mut 0, &mut 0, &mut 0, &mut 0, &mut 0.0);
    "E"       fmi3EnterContinuousTimeMode();
    "C"       fmi3CompletedIntegratorStep(1, &mut 0, &mut 0);
    "EC"      fmi3SetTime(0.5);
    "C"       fmi3SetContinuousStates(null(), 0);
    "NECT"    fmi3GetContinuousStateDerivatives(null_mut(), 0);
    "NECT"    fmi3GetEventIndicators(null_mut(), 0);
    "NECT"    fmi3GetContinuousStates(null_mut(), 0);
    "NECT"    fmi3GetNominalsOfContinuousStates(null_mut(), 0);
    "INECT"   fmi3GetNumberOfEventIndicators(&mut 0);
    "INECT"   fmi3GetNumberOfContinuousStates(&mut 0);
    "V"       fmi3EnterStepMode();
    ""        fmi3GetOutputDerivatives(null(), 0, null(), null_mut(), 0);
    "S"       fmi3DoStep(0.0, 0.1, 1, &mut 0, &mut 0, &mut 0, &mut 0.0);
    ""        fmi3ActivateModelPartition(0, 0.0);
};

const FMI3_STATE_CASES: &[Case] = cases! {
    "INECSVT" fmi3SetFMUState(1);
    "INECSVT" fmi3SerializedFMUStateSize(1, &mut 0);
};

/// An instance in a state. W is the step mode of an instance with event mode.
fn instance2(fmu: &Unpacked, state: char, messages: &mut Messages) -> *mut Component {
    let c = instantiate2(fmu, i32::from("NST".contains(state)), messages);
    let event = fmi2EnterInitializationMode;
    // SAFETY: the instance is alive.
    let status = unsafe {
        match state {
            'I' => STATUS_OK,
            'N' => event(c),
            'E' | 'S' => event(c) + fmi2ExitInitializationMode(c),
            'C' => event(c) + fmi2ExitInitializationMode(c) + fmi2EnterContinuousTimeMode(c),
            _ => event(c) + fmi2ExitInitializationMode(c) + fmi2Terminate(c),
        }
    };
    assert_eq!(status, STATUS_OK);
    c
}

fn instance3(fmu: &Unpacked, state: char, messages: &mut Messages) -> *mut Component {
    let c = match state {
        'N' | 'E' | 'C' => instantiate3_model_exchange(fmu, messages),
        _ => instantiate3(fmu, "VW".contains(state), messages),
    };
    // SAFETY: the instance is alive.
    let status = unsafe {
        let enter = |c| fmi3EnterInitializationMode(c, 0, 0.0, 0.0, 0, 0.0);
        match state {
            'I' => STATUS_OK,
            'N' => enter(c),
            'E' | 'S' | 'V' => enter(c) + fmi3ExitInitializationMode(c),
            'C' => enter(c) + fmi3ExitInitializationMode(c) + fmi3EnterContinuousTimeMode(c),
            'W' => enter(c) + fmi3ExitInitializationMode(c) + fmi3EnterStepMode(c),
            _ => enter(c) + fmi3ExitInitializationMode(c) + fmi3Terminate(c),
        }
    };
    assert_eq!(status, STATUS_OK);
    c
}

fn check(cases: &[Case], states: &str, make: impl Fn(char, &mut Messages) -> *mut Component) -> usize {
    for (name, allowed, call) in cases {
        for state in states.chars() {
            let mut messages = Messages::new();
            let c = make(state, &mut messages);
            // What holds for step mode holds with event mode too.
            let expected = allowed.contains(state) || state == 'W' && allowed.contains('S');
            let status = call(c);
            assert_eq!(
                status,
                if expected { STATUS_OK } else { STATUS_ERROR },
                "{name} in {state}: {messages:?}"
            );
            assert_eq!(
                messages.len(),
                usize::from(!expected),
                "one message for each refusal: {name} in {state}"
            );
            if !expected {
                let text = &messages[0].1;
                let capability = text.contains("does not have this capability");
                assert!(text.starts_with(name) && capability == allowed.is_empty(), "{text}");
            }
            // SAFETY: freed once.
            unsafe { fmi3FreeInstance(c) };
        }
    }
    cases.len()
}

#[test]
fn every_function_of_fmi2_in_every_state() {
    let fmu = Unpacked::new();
    let plain = check(FMI2_CASES, "INECST", |state, messages| instance2(&fmu, state, messages));
    let with_state = check(FMI2_STATE_CASES, "INECST", |state, messages| {
        let c = instance2(&fmu, state, messages);
        // SAFETY: the instance is alive.
        assert_eq!(unsafe { fmi2GetFMUstate(c, &mut 0) }, STATUS_OK);
        c
    });
    // Serialising needs the size, which the round trip in abi.rs asks for.
    assert_eq!(plain + with_state + 2, FMI2.len(), "a function is missing here");
}

#[test]
fn every_function_of_fmi3_in_every_state() {
    let fmu = Unpacked::new();
    let plain = check(FMI3_CASES, "INECSVWT", |state, messages| {
        instance3(&fmu, state, messages)
    });
    let with_state = check(FMI3_STATE_CASES, "INECSVWT", |state, messages| {
        let c = instance3(&fmu, state, messages);
        // SAFETY: the instance is alive.
        assert_eq!(unsafe { fmi3GetFMUState(c, &mut 0) }, STATUS_OK);
        c
    });
    assert_eq!(plain + with_state + 2, FMI3.len(), "a function is missing here");
}

#[test]
fn reset_leads_from_every_state_to_a_run_with_the_same_bits() {
    let fmu = Unpacked::new();
    let reach = fmu.reference("A.x");
    let run = |c: *mut Component| {
        let mut values = [0.0; 3];
        // SAFETY: the instance is alive.
        unsafe {
            assert_eq!(fmi3EnterInitializationMode(c, 0, 0.0, 0.0, 0, 0.0), STATUS_OK);
            assert_eq!(fmi3ExitInitializationMode(c), STATUS_OK);
            for value in &mut values {
                assert_eq!(fmi3GetFloat64(c, &reach, 1, value, 1), STATUS_OK);
            }
        }
        values
    };
    let mut messages = Messages::new();
    let fresh = instance3(&fmu, 'I', &mut messages);
    let expected = run(fresh);
    for state in "INECSVWT".chars() {
        let c = instance3(&fmu, state, &mut messages);
        // SAFETY: the instances are alive, and freed once.
        unsafe {
            // Whatever was set is gone, and so is an error.
            let _ = fmi3SetFloat64(c, &fmu.reference("theta_1"), 1, &common::REACHABLE, 1);
            assert_eq!(fmi3GetFloat64(c, &u32::MAX, 1, &mut 0.0, 1), STATUS_ERROR);
            assert_eq!(fmi3Reset(c), STATUS_OK);
            assert_eq!(run(c), expected, "from {state}");
            fmi3FreeInstance(c);
        }
    }
    // SAFETY: freed once.
    unsafe { fmi3FreeInstance(fresh) };
}

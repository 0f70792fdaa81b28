//! A host that does everything wrong: calls in any order with any arguments. Nothing crashes,
//! hangs or turns fatal, every refusal has a message, and a reset makes the instance as new.
//!
//! `LEMNIS_CALLS=100000000 cargo test --release --workspace --test random_calls` goes on for longer.

mod common;

use common::{Messages, Unpacked, instantiate2, instantiate3, instantiate3_model_exchange};
use fastrand::Rng;
use lemnis_fmu::abi::{Component, STATUS_DISCARD, STATUS_ERROR, STATUS_OK, Status, fmi2::*, fmi3::*};
use std::ffi::c_char;
use std::ptr::{null, null_mut};

/// Calls of each standard, unless the environment says otherwise.
const CALLS: u64 = 3_000_000;
const LONGEST: usize = 6;

/// Arguments of a call: arrays that are long enough for every count that is passed.
struct Arguments {
    rng: Rng,
    references: [u32; LONGEST],
    reals: [f64; 2 * LONGEST],
    integers: [i32; LONGEST],
    bytes: Vec<u8>,
    handles: Vec<usize>,
    strings: [*const c_char; LONGEST],
    variables: u32,
}

impl Arguments {
    fn new(seed: u64, variables: usize) -> Arguments {
        Arguments {
            rng: Rng::with_seed(seed),
            references: [0; LONGEST],
            reals: [0.0; 2 * LONGEST],
            integers: [0; LONGEST],
            bytes: Vec::new(),
            handles: vec![0],
            strings: [null(); LONGEST],
            variables: variables as u32,
        }
    }

    fn shake(&mut self) {
        let rng = &mut self.rng;
        for reference in &mut self.references {
            *reference = match rng.u8(..) {
                0..10 => rng.u32(..),
                // Inputs, parameters, results, strings, vectors, and a little beyond.
                _ => rng.u32(0..self.variables + 14),
            };
        }
        for real in &mut self.reals {
            *real = match rng.u8(0..20) {
                0 => f64::NAN,
                1 => f64::INFINITY,
                2 => f64::NEG_INFINITY,
                3 => f64::MIN_POSITIVE / 8.0,
                4 => f64::MAX,
                5 => -rng.f64() * 1e3,
                6 => f64::from_bits(rng.u64(..)),
                7..10 => rng.f64() * 1e6,
                _ => 0.8 + rng.f64() * 1.5,
            };
        }
    }

    fn count(&mut self) -> usize {
        self.rng.usize(0..=LONGEST)
    }

    /// A valid handle, a freed one or nonsense.
    fn handle(&mut self) -> usize {
        match self.rng.u8(0..8) {
            0 => self.rng.usize(..),
            _ => self.handles[self.rng.usize(0..self.handles.len())],
        }
    }

    fn keep(&mut self, handle: usize) {
        if self.handles.len() < 40 {
            self.handles.push(handle);
        } else {
            let at = self.rng.usize(1..self.handles.len());
            self.handles[at] = handle;
        }
    }

    /// A count that is mostly that of the references.
    fn other(&mut self, count: usize) -> usize {
        if self.rng.u8(0..6) == 0 {
            self.rng.usize(0..=2 * LONGEST)
        } else {
            count
        }
    }

    /// A pointer, or now and then null.
    fn or_null<T>(&mut self, pointer: *const T) -> *const T {
        if self.rng.u8(0..24) == 0 { null() } else { pointer }
    }

    fn or_null_mut<T>(&mut self, pointer: *mut T) -> *mut T {
        self.or_null(pointer).cast_mut()
    }
}

/// Both standards act on the same instance: a host that mixes them must survive as well.
///
/// Returns the status, and how many messages an inquiry before the call gave.
#[expect(clippy::too_many_lines, reason = "one function of the standard after the other")]
fn call(c: *mut Component, a: &mut Arguments) -> (Status, usize) {
    let mut inquiries = 0;
    a.shake();
    let n = a.count();
    let m = a.other(n);
    let (references, integers, strings) = (a.references.as_ptr(), a.integers.as_mut_ptr(), a.strings.as_mut_ptr());
    let references = a.or_null(references);
    let reals = a.reals.as_mut_ptr();
    let reals = a.or_null_mut(reals);
    let sensitivities = a.reals[LONGEST..].as_mut_ptr();
    let sensitivities = a.or_null_mut(sensitivities);
    let (x, y) = (a.reals[0], a.reals[1]);
    let (mut bytes, mut flags) = ([0_u8; LONGEST], [0_u8; 5]);
    let mut handle = a.handle();
    let mut size = 0;
    let mut time = 0.0;
    let bytes = bytes.as_mut_ptr();
    // SAFETY: the instance is alive, and no count is greater than its array is long.
    let status = unsafe {
        match a.rng.u8(0..52) {
            0 => fmi2SetupExperiment(c, 0, 0.0, x, i32::from(y > 1.0), y),
            1 => fmi2EnterInitializationMode(c),
            2 => fmi3EnterInitializationMode(c, 0, 0.0, x, u8::from(y > 1.0), y),
            3 => fmi2ExitInitializationMode(c),
            4 => fmi3ExitInitializationMode(c),
            5 if a.rng.u8(0..4) == 0 => fmi2Terminate(c),
            6 if a.rng.u8(0..4) == 0 => fmi3Terminate(c),
            7 => fmi2Reset(c),
            8 => fmi3Reset(c),
            9 | 10 => fmi2GetReal(c, references, n, reals),
            11 | 12 => fmi3GetFloat64(c, references, n, reals, m.min(2 * LONGEST)),
            13 => fmi2GetBoolean(c, references, n, integers),
            14 => fmi3GetBoolean(c, references, n, bytes, m.min(LONGEST)),
            15 => fmi2GetString(c, references, n, strings),
            16 => fmi3GetString(c, references, n, strings, m.min(LONGEST)),
            17..20 => fmi2SetReal(c, references, n, reals),
            20..23 => fmi3SetFloat64(c, references, n, reals, m.min(2 * LONGEST)),
            23 => fmi2SetBoolean(c, references, n, integers),
            24 => fmi3SetBoolean(c, references, n, bytes, m.min(LONGEST)),
            25 => fmi2GetInteger(c, references, n, integers),
            26 => fmi3SetInt32(c, references, n, integers, m.min(LONGEST)),
            27 => {
                let status = fmi2GetFMUstate(c, &mut handle);
                a.keep(handle);
                status
            }
            28 => {
                let status = fmi3GetFMUState(c, &mut handle);
                a.keep(handle);
                status
            }
            29 => fmi2SetFMUstate(c, handle),
            30 => fmi3SetFMUState(c, handle),
            31 => fmi2FreeFMUstate(c, &mut handle),
            32 => fmi3FreeFMUState(c, &mut handle),
            33 => {
                let status = fmi3SerializedFMUStateSize(c, handle, &mut size);
                if status == STATUS_OK {
                    a.bytes.resize(size, 0);
                }
                status
            }
            34 => {
                let length = a.bytes.len();
                fmi3SerializeFMUState(c, handle, a.bytes.as_mut_ptr(), length)
            }
            35 => {
                // As it is, damaged, or cut short.
                let length = a.bytes.len();
                let cut = if a.rng.bool() { length } else { a.rng.usize(0..=length) };
                if length > 0 && a.rng.bool() {
                    let at = a.rng.usize(0..length);
                    a.bytes[at] ^= a.rng.u8(..);
                }
                let mut handle = if a.rng.bool() { 0 } else { handle };
                let status = fmi2DeSerializeFMUstate(c, a.bytes.as_ptr(), cut, &mut handle);
                a.keep(handle);
                status
            }
            36 => fmi2GetDirectionalDerivative(c, references, n, references, n, reals, sensitivities),
            37 => {
                fmi3GetDirectionalDerivative(c, references, n, references, n, reals, m.min(LONGEST), sensitivities, n)
            }
            38 => fmi3GetAdjointDerivative(c, references, n, references, n, reals, m.min(LONGEST), sensitivities, n),
            39 => fmi2EnterEventMode(c),
            40 => fmi3EnterEventMode(c),
            41 => fmi2EnterContinuousTimeMode(c),
            42 => fmi3EnterStepMode(c),
            43 => fmi2SetTime(c, x),
            44 => fmi3CompletedIntegratorStep(c, 1, &mut flags[0], &mut flags[1]),
            45 => fmi2NewDiscreteStates(c, &mut fmi2EventInfo::default()),
            46 => {
                let [f, g, h, i, j] = &mut flags;
                fmi3UpdateDiscreteStates(c, f, g, h, i, j, &mut time)
            }
            47 | 48 => {
                // The end of the last step is what a host would know.
                let mut now = 0.0;
                inquiries += usize::from(fmi2GetReal(c, &0, 1, &mut now) != STATUS_OK);
                fmi2DoStep(c, now, x, 1)
            }
            49 => {
                let [f, g, h, ..] = &mut flags;
                fmi3DoStep(c, x, y, 1, f, g, h, &mut time)
            }
            50 => fmi2SetDebugLogging(c, 1, n.min(1), &c"logStatusError".as_ptr()),
            _ => fmi3GetNumberOfEventIndicators(c, &mut size),
        }
    };
    (status, inquiries)
}

/// A short run that touches positions, forces and derivatives.
fn run(c: *mut Component, fmu: &Unpacked) -> Vec<u64> {
    let references = ["theta_3", "R", "A.y", "M_Q", "F_d"].map(|id| fmu.reference(id));
    let (mut values, mut bits, mut derivative) = ([0.0; 5], Vec::new(), 0.0);
    // SAFETY: the instance is alive.
    unsafe {
        let (reach, angle) = (fmu.reference("R"), fmu.reference("theta_1"));
        assert_eq!(fmi3EnterInitializationMode(c, 0, 0.0, 0.0, 0, 0.0), STATUS_OK);
        assert_eq!(fmi3SetFloat64(c, &angle, 1, &common::REACHABLE, 1), STATUS_OK);
        assert_eq!(fmi3ExitInitializationMode(c), STATUS_OK);
        assert_eq!(
            fmi3GetFloat64(c, references.as_ptr(), 5, values.as_mut_ptr(), 5),
            STATUS_OK
        );
        let status = fmi3GetDirectionalDerivative(c, &reach, 1, &angle, 1, &1.0, 1, &mut derivative, 1);
        assert_eq!(status, STATUS_OK);
        assert_eq!(fmi3Reset(c), STATUS_OK);
    }
    bits.extend(values.iter().chain([&derivative]).map(|value| value.to_bits()));
    bits
}

#[test]
fn no_host_can_break_an_instance() {
    let calls = std::env::var("LEMNIS_CALLS").map_or(CALLS, |text| text.parse().expect("a number of calls"));
    let fmu = Unpacked::new();
    let (mut total, mut counts, mut seed) = (0, [0_u64; 4], 0);
    let mut first = None;
    while total < calls {
        let mut messages = Messages::new();
        let c = match seed % 4 {
            0 => instantiate2(&fmu, 0, &mut messages),
            1 => instantiate2(&fmu, 1, &mut messages),
            2 => instantiate3(&fmu, true, &mut messages),
            _ => instantiate3_model_exchange(&fmu, &mut messages),
        };
        assert!(!c.is_null());
        let expected = first.get_or_insert_with(|| run(c, &fmu)).clone();
        let mut arguments = Arguments::new(seed, fmu.model.variables().len());
        for _ in 0..20_000 {
            let (status, inquiries) = call(c, &mut arguments);
            assert!(
                [STATUS_OK, STATUS_DISCARD, STATUS_ERROR].contains(&status),
                "seed {seed}: {status} {:?}",
                messages.last()
            );
            counts[status as usize] += 1;
            // One message for each refusal, and none otherwise.
            let expected = usize::from(status != STATUS_OK) + inquiries;
            assert_eq!(messages.len(), expected, "seed {seed}: {status} {messages:?}");
            messages.clear();
            total += 1;
        }
        // SAFETY: the instance is alive, and freed once.
        unsafe {
            assert_eq!(fmi3Reset(c), STATUS_OK, "seed {seed}");
            assert_eq!(run(c, &fmu), expected, "seed {seed}: as new after a reset");
            fmi2FreeInstance(c);
        }
        seed += 1;
    }
    println!(
        "{total} calls: {} ok, {} discarded, {} refused",
        counts[0], counts[2], counts[3]
    );
    assert!(
        counts[0] > calls / 10 && counts[2] > 0 && counts[3] > calls / 10,
        "both ways are tried: {counts:?}"
    );
}

#[test]
fn instances_in_many_threads_give_the_same_bits() {
    let fmu = Unpacked::new();
    let mut messages = Messages::new();
    let c = instantiate2(&fmu, 1, &mut messages);
    let expected = run(c, &fmu);
    // One instance, each call from another thread.
    let address = c as usize;
    for _ in 0..4 {
        let bits = std::thread::spawn(move || run(address as *mut Component, &Unpacked::new())).join();
        assert_eq!(bits.expect("no panic"), expected);
    }
    // SAFETY: freed once.
    unsafe { fmi2FreeInstance(c) };
    // Many instances at once.
    std::thread::scope(|scope| {
        let threads: Vec<_> = (0..8)
            .map(|_| {
                scope.spawn(|| {
                    let (fmu, mut messages) = (Unpacked::new(), Messages::new());
                    for _ in 0..25 {
                        let c = instantiate2(&fmu, 1, &mut messages);
                        assert_eq!(run(c, &fmu), expected);
                        // SAFETY: freed once.
                        unsafe { fmi2FreeInstance(c) };
                    }
                })
            })
            .collect();
        threads.into_iter().for_each(|thread| thread.join().expect("no panic"));
    });
}

#[test]
fn null_instances_are_refused() {
    // SAFETY: null is allowed.
    unsafe {
        assert_eq!(fmi2Reset(null_mut()), STATUS_ERROR);
        assert_eq!(fmi3GetFloat64(null_mut(), null(), 0, null_mut(), 0), STATUS_ERROR);
        fmi2FreeInstance(null_mut());
        fmi3FreeInstance(null_mut());
    }
}

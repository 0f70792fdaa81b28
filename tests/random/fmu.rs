//! One run of a scene three times: in the model itself, and in both FMUs through their C functions.

use std::ffi::{CStr, c_char, c_int, c_void};
use std::ptr::null;

use lemnis_models::component::model::Model;
use lemnis_models::kernel::number::short;
use lemnis_models::kernel::variable::{Role, Type, Variable};
use lemnis_tests::unpacked::{Call, DoStep, Enter, Real, SetReal, Unpacked};

use crate::scene::Draw;

/// Nothing, or why not.
pub type Said<T> = Result<T, String>;

/// What can be run.
pub trait Run {
    fn start(&mut self) -> Said<()>;
    /// Sets a variable by its index.
    fn set(&mut self, index: usize, value: f64) -> Said<()>;
    fn get(&mut self, index: usize) -> Said<f64>;
    fn step(&mut self, at: f64, size: f64) -> Said<()>;
    /// Evaluations of the right-hand side so far, where it can be told.
    fn rates(&self) -> u32 {
        0
    }
}

impl Run for Model {
    fn rates(&self) -> u32 {
        self.count().rates
    }

    fn start(&mut self) -> Said<()> {
        (**self).start().map_err(|fault| fault.message)
    }

    fn set(&mut self, index: usize, value: f64) -> Said<()> {
        Model::set(self, index, value).map_err(|fault| fault.message)
    }

    fn get(&mut self, index: usize) -> Said<f64> {
        let value = Model::get(self, index).map_err(|fault| fault.message)?;
        let variable = self.variables()[index];
        let documented = value.is_finite() || value.is_infinite() && variable.symbol.infinite.is_some();
        documented
            .then_some(value)
            .ok_or_else(|| format!("{variable} is {}", short(value)))
    }

    fn step(&mut self, at: f64, size: f64) -> Said<()> {
        self.advance(at, at + size).map_err(|fault| fault.message)
    }
}

const WARNING: c_int = 1;
const DISCARD: c_int = 2;
const ERROR: c_int = 3;

type Messages = Vec<(c_int, String)>;

unsafe extern "C" fn log_3(told: *mut c_void, status: c_int, _: *const c_char, message: *const c_char) {
    // SAFETY: the environment is the list of messages, and the text ends with a zero.
    unsafe {
        let message = CStr::from_ptr(message).to_string_lossy().into_owned();
        (*told.cast::<Messages>()).push((status, message));
    }
}

/// Stable Rust defines no variadic function; this one ignores what a format would need.
unsafe extern "C" fn log_2(
    told: *mut c_void,
    _: *const c_char,
    status: c_int,
    category: *const c_char,
    message: *const c_char,
) {
    // SAFETY: as above.
    unsafe { log_3(told, status, category, message) }
}

#[repr(C)]
struct Callbacks {
    logger: unsafe extern "C" fn(*mut c_void, *const c_char, c_int, *const c_char, *const c_char),
    others: [*const c_void; 3],
    environment: *mut c_void,
}

type Instantiate2 = unsafe extern "C" fn(
    *const c_char,
    c_int,
    *const c_char,
    *const c_char,
    *const Callbacks,
    c_int,
    c_int,
) -> *mut c_void;
type Setup2 = unsafe extern "C" fn(*mut c_void, c_int, f64, f64, c_int, f64) -> c_int;
type DoStep2 = unsafe extern "C" fn(*mut c_void, f64, f64, c_int) -> c_int;
type Get2<T> = unsafe extern "C" fn(*mut c_void, *const u32, usize, *mut T) -> c_int;
type Set2<T> = unsafe extern "C" fn(*mut c_void, *const u32, usize, *const T) -> c_int;
type Get3<T> = unsafe extern "C" fn(*mut c_void, *const u32, usize, *mut T, usize) -> c_int;
type Set3<T> = unsafe extern "C" fn(*mut c_void, *const u32, usize, *const T, usize) -> c_int;

/// An instance of an FMU for Co-Simulation.
pub struct Instance<'a> {
    fmu: &'a Unpacked,
    second: bool,
    component: *mut c_void,
    variables: &'a [Variable],
    told: Box<Messages>,
    /// Statuses that are none, and refusals without a word.
    pub wrong: Vec<String>,
}

impl<'a> Instance<'a> {
    /// Of FMI 2 or 3; on failure its message.
    pub fn new(fmu: &'a Unpacked, second: bool, variables: &'a [Variable]) -> Said<Instance<'a>> {
        let mut told = Box::<Messages>::default();
        let environment: *mut c_void = (&raw mut *told).cast();
        let component = if second {
            let callbacks = Callbacks {
                logger: log_2,
                others: [null(); 3],
                environment,
            };
            let resources = fmu.resources("file://");
            // SAFETY: the type is that of the standard, the strings end with a zero.
            unsafe {
                let instantiate = fmu.function::<Instantiate2>("fmi2Instantiate");
                instantiate(
                    c"crane".as_ptr(),
                    1,
                    fmu.token.as_ptr(),
                    resources.as_ptr(),
                    &callbacks,
                    0,
                    0,
                )
            }
        } else {
            fmu.instantiate(environment, Some(log_3))
        };
        if component.is_null() {
            return Err(told.pop().map_or_else(String::new, |(_, message)| message));
        }
        Ok(Instance {
            fmu,
            second,
            component,
            variables,
            told,
            wrong: Vec::new(),
        })
    }

    /// One message for each warning and each refusal, and none otherwise.
    fn said(&mut self, status: c_int) -> Said<()> {
        let told = std::mem::take(&mut *self.told);
        match (status, told.as_slice()) {
            (0, []) | (WARNING, [(WARNING, _)]) => Ok(()),
            (DISCARD | ERROR, [(known, message)]) if *known == status && !message.is_empty() => Err(message.clone()),
            _ => {
                self.wrong.push(format!("status {status} with {told:?}"));
                Err(String::new())
            }
        }
    }

    fn reference(index: usize) -> u32 {
        u32::try_from(index + 1).expect("few variables")
    }
}

impl Drop for Instance<'_> {
    fn drop(&mut self) {
        self.fmu.free(self.component);
    }
}

impl Run for Instance<'_> {
    fn start(&mut self) -> Said<()> {
        let (fmu, c) = (self.fmu, self.component);
        // SAFETY: the types are those of the standard, and the arrays have the lengths given.
        let entered = unsafe {
            if self.second {
                fmu.function::<Setup2>("fmi2SetupExperiment")(c, 0, 0.0, 0.0, 0, 0.0)
                    | fmu.function::<Call>("fmi2EnterInitializationMode")(c)
            } else {
                fmu.function::<Enter>("fmi3EnterInitializationMode")(c, 0, 0.0, 0.0, 0, 0.0)
            }
        };
        self.said(entered)?;
        let name = if self.second {
            "fmi2ExitInitializationMode"
        } else {
            "fmi3ExitInitializationMode"
        };
        // SAFETY: the types are those of the standard, and the arrays have the lengths given.
        let left = unsafe { fmu.function::<Call>(name)(c) };
        self.said(left)
    }

    fn set(&mut self, index: usize, value: f64) -> Said<()> {
        let (fmu, c, reference) = (self.fmu, self.component, Self::reference(index));
        let real = self.variables[index].kind == Type::Real;
        // SAFETY: the types are those of the standard, and the arrays have the lengths given.
        let status = unsafe {
            match (self.second, real) {
                (true, true) => fmu.function::<Set2<f64>>("fmi2SetReal")(c, &reference, 1, &value),
                (true, false) => fmu.function::<Set2<i32>>("fmi2SetInteger")(c, &reference, 1, &(value as i32)),
                (false, true) => fmu.function::<SetReal>("fmi3SetFloat64")(c, &reference, 1, &value, 1),
                (false, false) => fmu.function::<Set3<i64>>("fmi3SetInt64")(c, &reference, 1, &(value as i64), 1),
            }
        };
        self.said(status)
    }

    fn get(&mut self, index: usize) -> Said<f64> {
        let (fmu, c, reference) = (self.fmu, self.component, Self::reference(index));
        let (mut real, mut truth) = (f64::NAN, [0_u8; 4]);
        let (mut count_2, mut count_3) = (0_i32, 0_i64);
        // SAFETY: the types are those of the standard, and the arrays have the lengths given.
        let (status, value) = unsafe {
            match (self.second, self.variables[index].kind) {
                (true, Type::Real) => {
                    let status = fmu.function::<Get2<f64>>("fmi2GetReal")(c, &reference, 1, &mut real);
                    (status, real)
                }
                (false, Type::Real) => {
                    let status = fmu.function::<Real>("fmi3GetFloat64")(c, &reference, 1, &mut real, 1);
                    (status, real)
                }
                (true, Type::Boolean) => {
                    let status = fmu.function::<Get2<i32>>("fmi2GetBoolean")(c, &reference, 1, &mut count_2);
                    (status, count_2.into())
                }
                (false, Type::Boolean) => {
                    let status = fmu.function::<Get3<u8>>("fmi3GetBoolean")(c, &reference, 1, truth.as_mut_ptr(), 1);
                    (status, truth[0].into())
                }
                (true, Type::Enumeration(_)) => {
                    let status = fmu.function::<Get2<i32>>("fmi2GetInteger")(c, &reference, 1, &mut count_2);
                    (status, count_2.into())
                }
                (false, Type::Enumeration(_)) => {
                    let status = fmu.function::<Get3<i64>>("fmi3GetInt64")(c, &reference, 1, &mut count_3, 1);
                    (status, count_3 as f64)
                }
            }
        };
        self.said(status)?;
        let variable = &self.variables[index];
        if !value.is_finite() && (value.is_nan() || variable.symbol.infinite.is_none()) {
            self.wrong.push(format!("{variable} = {value} with status OK"));
        }
        Ok(value)
    }

    fn step(&mut self, at: f64, size: f64) -> Said<()> {
        let (fmu, c) = (self.fmu, self.component);
        let (mut flags, mut last) = ([0_u8; 3], f64::NAN);
        let [event, terminate, early] = &mut flags;
        // SAFETY: the types are those of the standard, and the arrays have the lengths given.
        let status = unsafe {
            if self.second {
                fmu.function::<DoStep2>("fmi2DoStep")(c, at, size, 1)
            } else {
                fmu.function::<DoStep>("fmi3DoStep")(c, at, size, 1, event, terminate, early, &mut last)
            }
        };
        self.said(status)
    }
}

/// What became of a run.
#[derive(Default)]
pub struct Story {
    /// Every value by its bits, and where there was none.
    pub values: Vec<(usize, Option<u64>)>,
    /// What was refused: first in the default experiment, then with other inputs.
    pub refused: [Vec<String>; 2],
    /// Time that the default experiment has taken, in s; a communication step as one inner step of an explicit solver at
    /// least, which it costs however short it is.
    pub taken: f64,
    /// Evaluations of the right-hand side until then.
    pub rates: u32,
}

/// Steps of the default experiment's own size, and longer ones to its end.
const STEPS: [u32; 2] = [20, 10];
/// Sets of random inputs.
const ROUNDS: u32 = 6;

/// The default experiment, then random inputs between their least and greatest values, then all zero.
pub fn tell(run: &mut dyn Run, model: &Model, draw: &mut Draw) -> Story {
    let mut story = Story::default();
    let variables = model.variables();
    let (stop, size) = (model.stop_time(), model.step_size());
    let look = |run: &mut dyn Run, story: &mut Story, part: usize| {
        for index in 0..variables.len() {
            let value = run.get(index);
            story
                .values
                .push((index, value.as_ref().ok().map(|value| value.to_bits())));
            story.refused[part].extend(value.err());
        }
    };
    if let Err(message) = run.start() {
        story.refused[0].push(message);
        return story;
    }
    look(run, &mut story, 0);
    let own = f64::from(STEPS[0]) * size;
    let mut value = |id: &str| variables.iter().position(|v| v.symbol.id == id).map(|at| run.get(at));
    let least = match (value("step"), value("tol")) {
        (Some(Ok(step)), None) => step,
        _ => 0.0,
    };
    let mut time = 0.0;
    // What rounding leaves of the experiment is no step.
    while stop - time > 1e-9 * stop && story.refused[0].is_empty() {
        let size = if time < own {
            size
        } else {
            (stop - own) / f64::from(STEPS[1])
        };
        match run.step(time, size) {
            Ok(()) => {
                time += size;
                story.taken += size.max(least);
            }
            Err(message) => story.refused[0].push(message),
        }
        look(run, &mut story, 0);
    }
    story.rates = run.rates();
    let inputs: Vec<usize> = (0..variables.len())
        .filter(|&index| variables[index].role == Role::Input)
        .collect();
    for round in 0..=ROUNDS {
        let zero = round == ROUNDS;
        for &index in &inputs {
            let value = if zero { 0.0 } else { draw.input(&variables[index]) };
            story.refused[1].extend(run.set(index, value).err());
        }
        for part in [0.01, 0.3] {
            let size = part * size.min(draw.scale[2]);
            match run.step(time, size) {
                Ok(()) => time += size,
                Err(message) => story.refused[1].push(message),
            }
            look(run, &mut story, 1);
        }
    }
    story
}

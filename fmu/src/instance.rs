//! One instance of a model as a simulator sees it: time, the state machine and
//! FMU states. What both standards share is here, in safe code.

use crate::layout::{self, Place, Vector};
use crate::refuse;
use lemnis_models::component::model::Model;
use lemnis_models::component::running::{State, Tangent};
use lemnis_models::kernel::number::{exact, short};
use lemnis_models::kernel::variable::{Fault, Quantity, Role, TIME, Type, Variable};
use lemnis_models::scene::{LONGEST, Scene};
use sha2::{Digest, Sha256};
use std::cell::RefCell;
use std::ffi::{CStr, CString, c_char};
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// A state of an instance as a bit, or a set of states.
pub type States = u16;
pub const INSTANTIATED: States = 1;
pub const INITIALIZATION: States = 1 << 1;
/// Event mode of Model Exchange.
pub const EVENT: States = 1 << 2;
/// Continuous-time mode of Model Exchange.
pub const CONTINUOUS: States = 1 << 3;
/// Step mode of Co-Simulation.
pub const STEP: States = 1 << 4;
/// Event mode of FMI 3 Co-Simulation.
pub const STEP_EVENT: States = 1 << 5;
pub const TERMINATED: States = 1 << 6;
/// After a defect of the program: nothing but freeing the instance is allowed.
pub const FATAL: States = 1 << 7;
/// Every state that an instance can be in and go on.
pub const ANY: States = FATAL - 1;
/// For functions of capabilities that the description does not claim.
pub const NEVER: States = 0;

const STATE_NAMES: [&str; 8] = [
    "instantiated",
    "initialization mode",
    "event mode",
    "continuous-time mode",
    "step mode",
    "event mode",
    "terminated",
    "fatal error",
];

/// Log categories with their descriptions, in the order of the statuses warning, discard, error, fatal.
pub const CATEGORIES: [(&CStr, &str); 4] = [
    (
        c"logStatusWarning",
        "Results that the model has and a machine has not, told once in a run",
    ),
    (
        c"logStatusDiscard",
        "Values and configurations that do not exist: another value or a smaller step may do",
    ),
    (c"logStatusError", "Calls that were refused"),
    (c"logStatusFatal", "Defects of the program"),
];

/// Name of the scene in an FMU's resources.
pub const SCENE_FILE: &str = "scene.toml";

/// Allowed deviation of a communication point, as a part of the step: importers
/// add up step sizes, and the sums differ in the last digits.
const POINT_TOLERANCE: f64 = 1e-6;

/// First bytes of a serialised FMU state: name and format version.
const MAGIC: [u8; 8] = *b"lemnis\0\x01";
const HEADER: usize = MAGIC.len() + 32;

/// What the importer runs the instance as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interface {
    ModelExchange,
    CoSimulation,
    /// FMI 3 Co-Simulation with event mode.
    CoSimulationWithEvents,
}

/// The FMU's GUID or instantiation token: it follows from the scene's text and
/// the version of Lemnis.
#[must_use]
pub fn token(scene: &Scene) -> String {
    identity(scene).0
}

/// Version of Lemnis and SHA-256 of the scene's text, in the order of [`layout::STRINGS`].
#[must_use]
pub fn strings(scene: &Scene) -> [String; 2] {
    identity(scene).1
}

/// Both of them.
fn identity(scene: &Scene) -> (String, [String; 2]) {
    let version = env!("CARGO_PKG_VERSION");
    let text = Sha256::new().chain_update(scene.text());
    let digest = hex(&text.clone().chain_update(version).finalize()[..16]);
    let groups = [0..8, 8..12, 12..16, 16..20, 20..32].map(|group| &digest[group]);
    (
        format!("{{{}}}", groups.join("-")),
        [version.to_owned(), hex(&text.finalize())],
    )
}

fn hex(bytes: &[u8]) -> String {
    let digits = bytes.iter().flat_map(|byte| [byte >> 4, byte & 15]);
    digits.filter_map(|digit| char::from_digit(digit.into(), 16)).collect()
}

/// A model under a simulator's control.
pub struct Instance {
    model: Model,
    /// For derivatives, made when the first one is asked for.
    tangent: RefCell<Option<Tangent>>,
    interface: Interface,
    token: String,
    /// Truth values and enumerations by index, as they were at the last event: they may change at events only.
    held: Vec<(usize, f64)>,
    vectors: Vec<Vector>,
    /// Which of [`CATEGORIES`] are reported.
    logged: [bool; CATEGORIES.len()],
    now: Now,
    /// The model's warning of this run, and whether the importer has still to be told.
    warning: Option<(&'static str, bool)>,
    /// The instance as it was instantiated, for reset.
    initial: Saved,
    /// FMU states by handle, in ascending order of handles.
    saved: Vec<(usize, Saved)>,
    last_handle: usize,
    /// The values of [`strings`].
    strings: [CString; 2],
}

/// What changes in an instance besides the model.
#[derive(Clone, Copy, Debug)]
struct Now {
    state: States,
    /// Time reached, in s.
    time: f64,
    /// End of the last step that was tried, in s: beyond `time` after a step that failed.
    tried: f64,
    /// End of the experiment, in s; infinite where none was given.
    stop: f64,
}

/// An FMU state.
struct Saved {
    now: Now,
    model: State,
    held: Vec<(usize, f64)>,
}

impl Instance {
    /// Reads the scene in `resources` and builds its model.
    ///
    /// # Errors
    /// The scene is missing, too large or invalid, or it is not the one that `token` was made for.
    pub fn load(resources: &Path, token: &str, interface: Interface) -> Result<Instance, Fault> {
        let path = resources.join(SCENE_FILE);
        let unreadable = |error| Fault::new(format!("cannot read {}: {error}", path.display()));
        let mut text = Vec::new();
        // A pipe or a device might never end.
        if !std::fs::metadata(&path).map_err(unreadable)?.is_file() {
            return refuse(format!("cannot read {}: it is not a file", path.display()));
        }
        // One byte more than a scene may have, so that a longer one is refused and not cut.
        File::open(&path)
            .and_then(|file| file.take(LONGEST as u64 + 1).read_to_end(&mut text))
            .map_err(unreadable)?;
        let text =
            String::from_utf8(text).unwrap_or_else(|error| String::from_utf8_lossy(error.as_bytes()).into_owned());
        let scene = Scene::parse(&text).map_err(|diagnostics| {
            let lines: Vec<String> = diagnostics.iter().map(ToString::to_string).collect();
            Fault::new(format!("{}: {}", path.display(), lines.join("; ")))
        })?;
        Instance::new(&scene, token, interface)
    }

    /// # Errors
    /// The scene's model cannot be built, or `token` belongs to another scene or version.
    pub fn new(scene: &Scene, token: &str, interface: Interface) -> Result<Instance, Fault> {
        let (expected, strings) = identity(scene);
        if token != expected {
            return refuse(format!(
                "the token {token:?} does not belong to this scene and version: {expected} was expected"
            ));
        }
        let model = scene.model()?;
        let variables = model.variables().iter().enumerate();
        let held: Vec<(usize, f64)> = variables
            .filter(|(_, v)| v.kind != Type::Real)
            .map(|(i, _)| (i, 0.0))
            .collect();
        let vectors = layout::vectors(model.variables());
        let now = Now {
            state: INSTANTIATED,
            time: 0.0,
            tried: 0.0,
            stop: f64::INFINITY,
        };
        let initial = Saved {
            now,
            model: model.state(),
            held: held.clone(),
        };
        Ok(Instance {
            tangent: RefCell::new(None),
            model,
            interface,
            token: expected,
            held,
            vectors,
            logged: [true; CATEGORIES.len()],
            now,
            warning: None,
            initial,
            saved: Vec::new(),
            last_handle: 0,
            strings: strings.map(|text| CString::new(text).expect("digits and letters")),
        })
    }

    #[must_use]
    pub fn state(&self) -> States {
        self.now.state
    }

    #[must_use]
    pub fn state_name(&self) -> &'static str {
        STATE_NAMES[self.now.state.trailing_zeros() as usize]
    }

    /// Time reached, in s.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.now.time
    }

    #[must_use]
    pub fn is_logged(&self, category: usize) -> bool {
        self.logged[category]
    }

    /// Switches log categories on or off; none named means all.
    ///
    /// # Errors
    /// A category does not exist.
    pub fn set_logged(&mut self, on: bool, categories: &[&str]) -> Result<(), Fault> {
        if categories.is_empty() {
            self.logged = [on; CATEGORIES.len()];
        }
        for &name in categories {
            let Some(index) = CATEGORIES
                .iter()
                .position(|(category, _)| category.to_bytes() == name.as_bytes())
            else {
                return refuse(format!("there is no log category {name:?}"));
            };
            self.logged[index] = on;
        }
        Ok(())
    }

    /// Sets the experiment's start and stop time, in s.
    ///
    /// # Errors
    /// A time is not finite, or the experiment ends before it starts.
    pub fn set_up(&mut self, start: f64, stop: Option<f64>) -> Result<(), Fault> {
        let stop = stop.unwrap_or(f64::INFINITY);
        if stop.is_nan() || stop < start {
            return refuse(format!(
                "the stop time, {} s, is not after the start time, {} s",
                exact(stop),
                exact(start)
            ));
        }
        self.set_time(start)?;
        self.now.stop = stop;
        Ok(())
    }

    /// Enters a state; which function may do so from where is the standards' tables' business.
    ///
    /// # Errors
    /// None; a result for the functions that do nothing else.
    pub fn enter(&mut self, state: States) -> Result<(), Fault> {
        if state == CONTINUOUS {
            for (index, value) in &mut self.held {
                // Where there is no value, the last one stays.
                *value = self.model.get(*index).unwrap_or(*value);
            }
        }
        self.now.state = state;
        Ok(())
    }

    /// Leaves initialization mode.
    ///
    /// # Errors
    /// The initial configuration cannot be reached; the instance stays in initialization mode.
    pub fn start(&mut self) -> Result<(), Fault> {
        self.model.start()?;
        self.watch();
        self.enter(match self.interface {
            Interface::ModelExchange => EVENT,
            Interface::CoSimulation => STEP,
            Interface::CoSimulationWithEvents => STEP_EVENT,
        })
    }

    /// Enters event mode.
    ///
    /// # Errors
    /// The instance was made without event mode.
    pub fn enter_event_mode(&mut self) -> Result<(), Fault> {
        match self.interface {
            Interface::ModelExchange => self.enter(EVENT),
            Interface::CoSimulationWithEvents => self.enter(STEP_EVENT),
            Interface::CoSimulation => refuse("the instance was made without event mode"),
        }
    }

    /// Back to the instance as it was instantiated, from any state.
    ///
    /// # Errors
    /// None; a result like those of the other functions.
    pub fn reset(&mut self) -> Result<(), Fault> {
        self.now = self.initial.now;
        self.warning = None;
        self.held.clone_from(&self.initial.held);
        self.model.set_state(&self.initial.model);
        Ok(())
    }

    /// Sets the time of the model, in s.
    ///
    /// # Errors
    /// The time is not finite.
    pub fn set_time(&mut self, time: f64) -> Result<(), Fault> {
        if !time.is_finite() {
            return refuse(format!("the time {} is not finite", exact(time)));
        }
        (self.now.time, self.now.tried) = (time, time);
        self.model.set_time(time);
        Ok(())
    }

    /// Advances from `point` by `size`, both in s.
    ///
    /// # Errors
    /// The step does not start where the last one ended or goes beyond the stop time, or the
    /// configuration at its end cannot be reached. The instance is as it was before the step;
    /// after setting other inputs, stepping can go on from here or from the end of the failed step.
    pub fn step(&mut self, point: f64, size: f64) -> Result<(), Fault> {
        if !(size.is_finite() && size > 0.0) {
            return refuse(format!("the step size {} s is not positive", exact(size)));
        }
        let tolerance = POINT_TOLERANCE * size + 4.0 * f64::EPSILON * point.abs();
        let is_near = |time: f64| (point - time).abs() <= tolerance;
        if !is_near(self.now.time) && !is_near(self.now.tried) {
            return refuse(format!(
                "the step starts at {} s, but the last one ended at {} s",
                exact(point),
                exact(self.now.time)
            ));
        }
        let end = point + size;
        if end > self.now.stop + tolerance {
            return refuse(format!(
                "the step ends at {} s, beyond the stop time {} s",
                exact(end),
                exact(self.now.stop)
            ));
        }
        self.now.tried = end;
        self.model.advance(self.now.time, end)?;
        self.now.time = end;
        self.watch();
        Ok(())
    }

    /// Looks whether there is something to warn of, as far as it is not known in this run.
    fn watch(&mut self) {
        if self.warning.is_none() {
            self.warning = self.model.warning().map(|words| (words, true));
        }
    }

    /// What the importer is to be warned of, once in a run.
    #[inline]
    pub fn take_warning(&mut self) -> Option<&'static str> {
        let (words, new) = self.warning.as_mut()?;
        std::mem::take(new).then_some(*words)
    }

    /// Number of continuous states.
    #[must_use]
    pub fn states(&self) -> usize {
        self.model.states()
    }

    /// Number of event indicators.
    #[must_use]
    pub fn indicators(&self) -> usize {
        self.model.indicators()
    }

    /// Reads the continuous states.
    ///
    /// # Errors
    /// Another number of values than there are states.
    pub fn get_states(&self, values: &mut [f64]) -> Result<(), Fault> {
        expect_length(values.len(), self.model.states())?;
        self.model.get_states(values);
        Ok(())
    }

    /// Sets the continuous states.
    ///
    /// # Errors
    /// Another number of values than there are states, or one is not finite; none changes.
    pub fn set_states(&mut self, values: &[f64]) -> Result<(), Fault> {
        expect_length(values.len(), self.model.states())?;
        self.model.set_states(values)
    }

    /// Reads the rates of the continuous states.
    ///
    /// # Errors
    /// Another number of values than there are states, or a configuration that does not exist.
    pub fn get_rates(&mut self, values: &mut [f64]) -> Result<(), Fault> {
        expect_length(values.len(), self.model.states())?;
        self.model.rates(values)
    }

    /// Orders of magnitude of the continuous states.
    ///
    /// # Errors
    /// Another number of values than there are states.
    pub fn get_nominals(&self, values: &mut [f64]) -> Result<(), Fault> {
        expect_length(values.len(), self.model.states())?;
        self.model.nominals(values);
        Ok(())
    }

    /// Reads the event indicators.
    ///
    /// # Errors
    /// Another number of values than there are indicators, or a configuration that does not exist.
    pub fn get_indicators(&mut self, values: &mut [f64]) -> Result<(), Fault> {
        expect_length(values.len(), self.model.indicators())?;
        self.model.event_indicators(values)
    }

    /// Decides what follows at an event; returns whether a continuous state jumped.
    ///
    /// # Errors
    /// A configuration that does not exist.
    pub fn update_discrete(&mut self) -> Result<bool, Fault> {
        let jumped = self.model.event()?;
        self.watch();
        Ok(jumped)
    }

    /// Time of the next event that is known beforehand, in s. In Co-Simulation steps handle theirs inside.
    #[must_use]
    pub fn next_event(&self) -> Option<f64> {
        match self.interface {
            Interface::ModelExchange => self.model.next_event(),
            Interface::CoSimulation | Interface::CoSimulationWithEvents => None,
        }
    }

    /// Reads real variables; a vector gives all of its components.
    ///
    /// # Errors
    /// A reference is not that of a real variable, there are fewer or more values than the
    /// variables have, or a value does not exist in this configuration.
    pub fn get_reals(&mut self, references: &[u32], values: &mut [f64]) -> Result<(), Fault> {
        let given = values.len();
        let mut rest = values.iter_mut();
        for &reference in references {
            let indices = match self.place(reference)? {
                Place::Variable(index) => self.real(index)?..index + 1,
                Place::Vector(index) => self.vectors[index].components.clone(),
                Place::Time => {
                    *rest.next().ok_or_else(|| too_few(given))? = self.now.time;
                    continue;
                }
                Place::String(_) => return refuse(format!("value reference {reference} is not a real variable")),
            };
            for index in indices {
                *rest.next().ok_or_else(|| too_few(given))? = self.value(index)?;
            }
        }
        expect_length(given, given - rest.len())
    }

    /// Reads truth values, in the standard's own type for them.
    ///
    /// # Errors
    /// As [`Instance::get_reals`].
    pub fn get_booleans<T: From<bool>>(&mut self, references: &[u32], values: &mut [T]) -> Result<(), Fault> {
        expect_length(values.len(), references.len())?;
        for (&reference, value) in references.iter().zip(values) {
            let index = self.boolean(reference)?;
            *value = (self.at_event(index)? != 0.0).into();
        }
        Ok(())
    }

    /// What may change at events only: between them as it was at the last one.
    fn at_event(&mut self, index: usize) -> Result<f64, Fault> {
        let held = self.held.iter().find(|(held, _)| *held == index);
        match held {
            Some((_, held)) if self.now.state == CONTINUOUS => Ok(*held),
            _ => self.value(index),
        }
    }

    /// Whether what may change at events only is to change: at the end of a step the importer is asked for an event.
    pub fn wants_event(&mut self) -> bool {
        let Instance { held, model, .. } = self;
        held.iter()
            .any(|(index, value)| model.get(*index).is_ok_and(|now| now != *value))
    }

    /// Reads strings; they live as long as the instance.
    ///
    /// # Errors
    /// As [`Instance::get_reals`].
    pub fn get_strings(&self, references: &[u32], values: &mut [*const c_char]) -> Result<(), Fault> {
        expect_length(values.len(), references.len())?;
        for (&reference, value) in references.iter().zip(values) {
            *value = match self.place(reference)? {
                Place::String(index) => self.strings[index].as_ptr(),
                _ => return refuse(format!("value reference {reference} is not a string")),
            };
        }
        Ok(())
    }

    /// Sets real variables, all or none. What acts at events only may be set between them, as FMPy does, and acts at the
    /// next one.
    ///
    /// # Errors
    /// A reference is not that of a real variable, the variable cannot be set now, or the model
    /// refuses the value.
    pub fn set_reals(&mut self, references: &[u32], values: &[f64]) -> Result<(), Fault> {
        expect_length(values.len(), references.len())?;
        for (&reference, &value) in references.iter().zip(values) {
            let index = match self.place(reference)? {
                Place::Variable(index) => self.real(index)?,
                Place::Time => return refuse("time is no variable that can be set here"),
                Place::Vector(_) => return refuse(format!("value reference {reference} is a result")),
                Place::String(_) => return refuse(format!("value reference {reference} is not a real variable")),
            };
            self.check_now(index)?;
            self.model.check(index, value)?;
        }
        for (&reference, &value) in references.iter().zip(values) {
            self.model.set(reference as usize - 1, value)?;
        }
        Ok(())
    }

    /// Reads enumerations, in the standard's own type for them.
    ///
    /// # Errors
    /// As [`Instance::get_reals`].
    pub fn get_enumerations<T: From<i32>>(&mut self, references: &[u32], values: &mut [T]) -> Result<(), Fault> {
        expect_length(values.len(), references.len())?;
        for (&reference, value) in references.iter().zip(values) {
            let index = self.enumeration(reference)?;
            *value = (self.at_event(index)? as i32).into();
        }
        Ok(())
    }

    /// Sets enumerations, all or none. Between events they keep their values: FMPy sets them
    /// there again to what they are, which is no change.
    ///
    /// # Errors
    /// As [`Instance::set_reals`].
    pub fn set_enumerations<T: Copy + Into<i64>>(&mut self, references: &[u32], values: &[T]) -> Result<(), Fault> {
        expect_length(values.len(), references.len())?;
        // Numbers of items are small: a greater one is refused however it is rounded.
        let number = |value: T| value.into() as f64;
        for (&reference, &value) in references.iter().zip(values) {
            let index = self.enumeration(reference)?;
            self.model.check(index, number(value))?;
            if self.model.get(index)? != number(value) {
                self.check_now(index)?;
            }
        }
        for (&reference, &value) in references.iter().zip(values) {
            self.model.set(reference as usize - 1, number(value))?;
        }
        Ok(())
    }

    /// Sets truth values: the models have none that can be set.
    ///
    /// # Errors
    /// Any value.
    pub fn set_booleans(&self, references: &[u32]) -> Result<(), Fault> {
        match references.first() {
            None => Ok(()),
            Some(&reference) => {
                let index = self.boolean(reference)?;
                self.model.check(index, 0.0)
            }
        }
    }

    /// Derivative of `unknowns` when `knowns` change at the rates `seed`, in SI; vectors have
    /// two values each.
    ///
    /// # Errors
    /// A reference that is no result or no input or parameter, wrong lengths, or a place where
    /// there is no derivative.
    pub fn directional(
        &self,
        unknowns: &[u32],
        knowns: &[u32],
        seed: &[f64],
        sensitivity: &mut [f64],
    ) -> Result<(), Fault> {
        expect_length(seed.len(), knowns.len())?;
        for &known in knowns {
            self.known(known)?;
        }
        let rate = |quantity| {
            let of = |&(&known, _): &(&u32, &f64)| self.known(known).is_ok_and(|known| known == quantity);
            knowns.iter().zip(seed).filter(of).map(|(_, rate)| rate).sum()
        };
        let mut tangent = self.tangent.borrow_mut();
        let tangent = self.along(&rate, &mut tangent);
        let given = sensitivity.len();
        let mut rest = sensitivity.iter_mut();
        for &unknown in unknowns {
            for index in self.unknown(unknown)? {
                *rest.next().ok_or_else(|| too_few(given))? = self.model.derivative(tangent, index)?;
            }
        }
        expect_length(given, given - rest.len())
    }

    /// Rates of change of a sum of `unknowns`, weighted with `seed`, with each of `knowns`.
    ///
    /// # Errors
    /// As [`Instance::directional`].
    pub fn adjoint(
        &self,
        unknowns: &[u32],
        knowns: &[u32],
        seed: &[f64],
        sensitivity: &mut [f64],
    ) -> Result<(), Fault> {
        expect_length(sensitivity.len(), knowns.len())?;
        let mut tangent = self.tangent.borrow_mut();
        for (&known, sensitivity) in knowns.iter().zip(sensitivity) {
            let known = self.known(known)?;
            let one = |quantity| f64::from(quantity == known);
            let tangent = self.along(&one, &mut tangent);
            let mut weights = seed.iter();
            *sensitivity = 0.0;
            for &unknown in unknowns {
                for index in self.unknown(unknown)? {
                    let weight = weights.next().ok_or_else(|| too_few(seed.len()))?;
                    *sensitivity += weight * self.model.derivative(tangent, index)?;
                }
            }
            expect_length(seed.len(), seed.len() - weights.len())?;
        }
        Ok(())
    }

    /// The tangent along a direction, made where there is none yet.
    fn along<'a>(&self, seed: &dyn Fn(Quantity) -> f64, made: &'a mut Option<Tangent>) -> &'a mut Tangent {
        if let Some(tangent) = made {
            self.model.tangent_into(seed, tangent);
        }
        made.get_or_insert_with(|| self.model.tangent(seed))
    }

    /// The quantity that a derivative is taken by.
    fn known(&self, reference: u32) -> Result<Quantity, Fault> {
        match self.place(reference)? {
            Place::Time => Ok((&TIME, None)),
            Place::Variable(index) => {
                let variable = self.model.variables()[self.real(index)?];
                match variable.role {
                    Role::Input | Role::Parameter | Role::Tunable | Role::State => Ok(variable.quantity()),
                    _ => refuse(format!(
                        "{variable} is a result: derivatives are by inputs, parameters and states"
                    )),
                }
            }
            _ => refuse(format!("derivatives by value reference {reference} do not exist")),
        }
    }

    /// The results that a derivative is taken of; the model refuses what is none.
    fn unknown(&self, reference: u32) -> Result<std::ops::Range<usize>, Fault> {
        match self.place(reference)? {
            Place::Variable(index) => Ok(self.real(index)?..index + 1),
            Place::Vector(index) => Ok(self.vectors[index].components.clone()),
            _ => refuse(format!("derivatives of value reference {reference} do not exist")),
        }
    }

    /// A value as importers may have it: finite, or infinite where its description says so.
    #[inline]
    fn value(&mut self, index: usize) -> Result<f64, Fault> {
        match self.model.get(index)? {
            value if value.is_finite() => Ok(value),
            value => not_finite(&self.model.variables()[index], value),
        }
    }

    #[inline]
    fn place(&self, reference: u32) -> Result<Place, Fault> {
        match layout::place(reference, self.model.variables().len(), self.vectors.len()) {
            Some(place) => Ok(place),
            None => no_reference(reference),
        }
    }

    /// The index, if it is that of a real variable.
    #[inline]
    fn real(&self, index: usize) -> Result<usize, Fault> {
        let variable = &self.model.variables()[index];
        match variable.kind {
            Type::Real => Ok(index),
            _ => not_real(variable),
        }
    }

    fn boolean(&self, reference: u32) -> Result<usize, Fault> {
        self.discrete(reference, "a boolean variable", |kind| kind == Type::Boolean)
    }

    fn enumeration(&self, reference: u32) -> Result<usize, Fault> {
        self.discrete(reference, "an enumeration", |kind| matches!(kind, Type::Enumeration(_)))
    }

    /// Index of a variable of a kind that is told in words.
    fn discrete(&self, reference: u32, words: &str, is: fn(Type) -> bool) -> Result<usize, Fault> {
        match self.place(reference)? {
            Place::Variable(index) if is(self.model.variables()[index].kind) => Ok(index),
            Place::Variable(index) => refuse(format!("{} is not {words}", self.model.variables()[index])),
            _ => refuse(format!("value reference {reference} is not {words}")),
        }
    }

    /// Whether a variable may be set in this state.
    #[inline]
    fn check_now(&self, index: usize) -> Result<(), Fault> {
        let variable = &self.model.variables()[index];
        let between_events = self.now.state == CONTINUOUS
            || (self.now.state == STEP && self.interface == Interface::CoSimulationWithEvents);
        let (what, until) = match variable.role {
            Role::State if self.now.state & (INSTANTIATED | INITIALIZATION) == 0 => {
                ("a state", "before the end of initialization")
            }
            Role::Parameter if self.now.state & (INSTANTIATED | INITIALIZATION) == 0 => {
                ("a parameter", "before the end of initialization")
            }
            Role::Tunable if self.now.state == CONTINUOUS => ("a parameter", "at events"),
            Role::Input if variable.kind != Type::Real && between_events => ("discrete", "at events"),
            _ => return Ok(()),
        };
        refuse(format!("{variable} is {what}: it can be set {until} only"))
    }

    /// Saves the instance under `handle`, or under a new handle if that is 0.
    ///
    /// # Errors
    /// The handle does not exist.
    pub fn save(&mut self, handle: usize) -> Result<usize, Fault> {
        if handle == 0 {
            return Ok(self.keep(self.snapshot()));
        }
        let at = self.find(handle)?;
        let saved = &mut self.saved[at].1;
        saved.now = self.now;
        self.model.state_into(&mut saved.model);
        saved.held.clone_from(&self.held);
        Ok(handle)
    }

    /// Brings a saved instance back.
    ///
    /// # Errors
    /// The handle does not exist.
    pub fn load_saved(&mut self, handle: usize) -> Result<(), Fault> {
        let saved = &self.saved[self.find(handle)?].1;
        self.now = saved.now;
        self.held.clone_from(&saved.held);
        self.model.set_state(&saved.model);
        Ok(())
    }

    /// Frees a saved instance; 0 is ignored.
    ///
    /// # Errors
    /// The handle does not exist.
    pub fn forget(&mut self, handle: usize) -> Result<(), Fault> {
        if handle != 0 {
            let at = self.find(handle)?;
            self.saved.remove(at);
        }
        Ok(())
    }

    /// Size of a saved instance as bytes.
    ///
    /// # Errors
    /// The handle does not exist.
    pub fn serialized_size(&self, handle: usize) -> Result<usize, Fault> {
        Ok(HEADER + 8 * self.numbers(&self.saved[self.find(handle)?].1).len())
    }

    /// Writes a saved instance as bytes: name and version of the format, a hash, the numbers.
    ///
    /// # Errors
    /// The handle does not exist, or the size is not [`Instance::serialized_size`].
    pub fn serialize(&self, handle: usize, bytes: &mut [u8]) -> Result<(), Fault> {
        let numbers = self.numbers(&self.saved[self.find(handle)?].1);
        expect_length(bytes.len(), HEADER + 8 * numbers.len())?;
        let (header, body) = bytes.split_at_mut(HEADER);
        for (number, place) in numbers.iter().zip(body.chunks_exact_mut(8)) {
            place.copy_from_slice(&number.to_le_bytes());
        }
        header[..MAGIC.len()].copy_from_slice(&MAGIC);
        header[MAGIC.len()..].copy_from_slice(&self.hash(body));
        Ok(())
    }

    /// Reads what [`Instance::serialize`] wrote, as [`Instance::save`] does.
    ///
    /// # Errors
    /// The bytes are damaged, or are those of another scene or version.
    pub fn deserialize(&mut self, bytes: &[u8], handle: usize) -> Result<usize, Fault> {
        let body = bytes
            .strip_prefix(&MAGIC)
            .and_then(|rest| rest.split_first_chunk::<32>());
        let saved = match body {
            Some((hash, body)) if *hash == self.hash(body) => {
                let (numbers, _) = body.as_chunks::<8>();
                self.saved_of(
                    &numbers
                        .iter()
                        .map(|&number| f64::from_le_bytes(number))
                        .collect::<Vec<_>>(),
                )?
            }
            _ => return refuse("the serialised FMU state is damaged, or that of another scene or version"),
        };
        if handle == 0 {
            return Ok(self.keep(saved));
        }
        let at = self.find(handle)?;
        self.saved[at].1 = saved;
        Ok(handle)
    }

    fn hash(&self, body: &[u8]) -> [u8; 32] {
        Sha256::new()
            .chain_update(&self.token)
            .chain_update(body)
            .finalize()
            .into()
    }

    fn find(&self, handle: usize) -> Result<usize, Fault> {
        self.saved
            .binary_search_by_key(&handle, |entry| entry.0)
            .map_err(|_| Fault::new("the FMU state does not exist in this instance, or has been freed"))
    }

    fn keep(&mut self, saved: Saved) -> usize {
        self.last_handle += 1;
        self.saved.push((self.last_handle, saved));
        self.last_handle
    }

    fn snapshot(&self) -> Saved {
        Saved {
            now: self.now,
            model: self.model.state(),
            held: self.held.clone(),
        }
    }

    /// A saved instance as numbers.
    fn numbers(&self, saved: &Saved) -> Vec<f64> {
        let Now {
            state,
            time,
            tried,
            stop,
        } = saved.now;
        let mut numbers = vec![f64::from(state), time, tried, stop];
        numbers.extend(saved.held.iter().map(|&(_, value)| value));
        numbers.extend(self.model.numbers(&saved.model));
        numbers
    }

    fn saved_of(&self, numbers: &[f64]) -> Result<Saved, Fault> {
        let known = |state: f64| {
            (0..7)
                .map(|bit| 1 << bit)
                .find(|&known: &States| f64::from(known) == state)
        };
        let (&[state, time, tried, stop], rest) = numbers
            .split_first_chunk::<4>()
            .ok_or_else(|| Fault::new("the FMU state is incomplete"))?;
        let (Some(state), Some((held, model))) = (known(state), rest.split_at_checked(self.held.len())) else {
            return refuse("the FMU state is that of no known state");
        };
        Ok(Saved {
            now: Now {
                state,
                time,
                tried,
                stop,
            },
            model: self.model.state_of(model)?,
            held: self
                .held
                .iter()
                .zip(held)
                .map(|(&(index, _), &value)| (index, value))
                .collect(),
        })
    }
}

#[cold]
fn no_reference(reference: u32) -> Result<Place, Fault> {
    refuse(format!("no variable has the value reference {reference}"))
}

#[cold]
fn not_finite(variable: &Variable, value: f64) -> Result<f64, Fault> {
    if value.is_infinite() && variable.symbol.infinite.is_some() {
        return Ok(value);
    }
    Err(Fault::outside(format!(
        "{variable} is {}: it does not exist in this configuration, or inputs and parameters are too great or too small \
         for it",
        short(value)
    )))
}

#[cold]
fn not_real(variable: &Variable) -> Result<usize, Fault> {
    refuse(format!("{variable} is not a real variable"))
}

/// For quantities that a model has none of.
///
/// # Errors
/// Some were asked for.
#[inline(never)]
pub fn expect_none(count: usize) -> Result<(), Fault> {
    if count == 0 {
        Ok(())
    } else {
        refuse(format!("{count} values were asked for, the FMU has none of this kind"))
    }
}

fn too_few(given: usize) -> Fault {
    Fault::new(format!("{given} values are fewer than these variables have"))
}

fn expect_length(given: usize, expected: usize) -> Result<(), Fault> {
    if given == expected {
        Ok(())
    } else {
        wrong_length(given, expected)
    }
}

#[cold]
fn wrong_length(given: usize, expected: usize) -> Result<(), Fault> {
    refuse(format!("{given} values were given, {expected} were expected"))
}

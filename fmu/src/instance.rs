//! One instance of a model as a simulator sees it: time, the state machine and
//! FMU states. What both standards share is here, in safe code.

use crate::refuse;
use lemnis_models::model::{Fault, Model, Role};
use lemnis_models::scene::{LONGEST, Scene};
use sha2::{Digest, Sha256};
use std::ffi::CStr;
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

/// Log categories with their descriptions; the first is for errors, the second for panics.
pub const CATEGORIES: [(&CStr, &str); 2] = [
    (
        c"logStatusError",
        "Calls that were refused and configurations that cannot be reached",
    ),
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
    let digest = Sha256::new()
        .chain_update(scene.text())
        .chain_update(env!("CARGO_PKG_VERSION"))
        .finalize();
    let hex: String = digest[..16].iter().map(|byte| format!("{byte:02x}")).collect();
    format!(
        "{{{}-{}-{}-{}-{}}}",
        &hex[..8],
        &hex[8..12],
        &hex[12..16],
        &hex[16..20],
        &hex[20..]
    )
}

/// A model under a simulator's control.
pub struct Instance {
    model: Model,
    interface: Interface,
    token: String,
    /// Which of [`CATEGORIES`] are reported.
    logged: [bool; 2],
    state: States,
    /// Time reached, in s.
    time: f64,
    /// Time of the model, in s: beyond `time` after a step that failed.
    model_time: f64,
    /// End of the experiment, in s; infinite where none was given.
    stop: f64,
    /// The instance as it was instantiated, for reset.
    initial: Vec<f64>,
    /// FMU states by handle, in ascending order of handles.
    saved: Vec<(usize, Vec<f64>)>,
    last_handle: usize,
}

impl Instance {
    /// Reads the scene in `resources` and builds its model.
    ///
    /// # Errors
    /// The scene is missing, too large or invalid, or it is not the one that `token` was made for.
    pub fn load(resources: &Path, token: &str, interface: Interface) -> Result<Instance, Fault> {
        let path = resources.join(SCENE_FILE);
        let unreadable = |error| Fault(format!("cannot read {}: {error}", path.display()));
        let mut text = Vec::new();
        // One byte more than a scene may have, so that a longer one is refused and not cut.
        File::open(&path)
            .and_then(|file| file.take(LONGEST as u64 + 1).read_to_end(&mut text))
            .map_err(unreadable)?;
        let scene = Scene::parse(&String::from_utf8_lossy(&text)).map_err(|diagnostics| {
            let lines: Vec<String> = diagnostics.iter().map(ToString::to_string).collect();
            Fault(format!("{}: {}", path.display(), lines.join("; ")))
        })?;
        Instance::new(&scene, token, interface)
    }

    /// # Errors
    /// The scene's model cannot be built, or `token` belongs to another scene or version.
    pub fn new(scene: &Scene, token: &str, interface: Interface) -> Result<Instance, Fault> {
        let expected = self::token(scene);
        if token != expected {
            return refuse(format!(
                "the token {token:?} does not belong to this scene and version: {expected} was expected"
            ));
        }
        let mut instance = Instance {
            model: Model::new(scene)?,
            interface,
            token: expected,
            logged: [true; 2],
            state: INSTANTIATED,
            time: 0.0,
            model_time: 0.0,
            stop: f64::INFINITY,
            initial: Vec::new(),
            saved: Vec::new(),
            last_handle: 0,
        };
        instance.initial = instance.snapshot();
        Ok(instance)
    }

    #[must_use]
    pub fn state(&self) -> States {
        self.state
    }

    #[must_use]
    pub fn state_name(&self) -> &'static str {
        STATE_NAMES[self.state.trailing_zeros() as usize]
    }

    /// Time reached, in s.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.time
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
            self.logged = [on; 2];
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
                "the stop time, {stop} s, is not after the start time, {start} s"
            ));
        }
        self.set_time(start)?;
        self.stop = stop;
        Ok(())
    }

    /// Enters a state; which function may do so from where is the standards' tables' business.
    ///
    /// # Errors
    /// None; a result for the functions that do nothing else.
    pub fn enter(&mut self, state: States) -> Result<(), Fault> {
        self.state = state;
        Ok(())
    }

    /// Leaves initialization mode.
    ///
    /// # Errors
    /// The initial configuration cannot be reached; the instance stays in initialization mode.
    pub fn start(&mut self) -> Result<(), Fault> {
        self.model.update()?;
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
    /// None that an intact instance gives.
    pub fn reset(&mut self) -> Result<(), Fault> {
        let initial = std::mem::take(&mut self.initial);
        let result = self.restore(&initial);
        self.initial = initial;
        result
    }

    /// Sets the time of the model, in s.
    ///
    /// # Errors
    /// The time is not finite.
    pub fn set_time(&mut self, time: f64) -> Result<(), Fault> {
        if !time.is_finite() {
            return refuse(format!("the time {time} is not finite"));
        }
        (self.time, self.model_time) = (time, time);
        self.model.set_time(time);
        Ok(())
    }

    /// Advances from `point` by `size`, both in s.
    ///
    /// # Errors
    /// The step does not start where the last one ended or goes beyond the stop time, or the
    /// configuration at its end cannot be reached. Time stays where it was; after setting other
    /// inputs, stepping can go on from here or from the end of the failed step.
    pub fn step(&mut self, point: f64, size: f64) -> Result<(), Fault> {
        if !(size.is_finite() && size > 0.0) {
            return refuse(format!("the step size {size} s is not positive"));
        }
        let tolerance = POINT_TOLERANCE * size + 4.0 * f64::EPSILON * point.abs();
        let is_near = |time: f64| (point - time).abs() <= tolerance;
        if !is_near(self.time) && !is_near(self.model_time) {
            return refuse(format!(
                "the step starts at {point} s, but the last one ended at {} s",
                self.time
            ));
        }
        let end = point + size;
        if end > self.stop + tolerance {
            return refuse(format!(
                "the step ends at {end} s, beyond the stop time {} s",
                self.stop
            ));
        }
        self.model_time = end;
        self.model.set_time(end);
        self.model.update()?;
        self.time = end;
        Ok(())
    }

    /// Reads real variables; reference 0 is time.
    ///
    /// # Errors
    /// A reference is not that of a real variable, or its value does not exist in this configuration.
    pub fn get_reals(&mut self, references: &[u32], values: &mut [f64]) -> Result<(), Fault> {
        expect_length(values.len(), references.len())?;
        for (&reference, value) in references.iter().zip(values) {
            *value = match reference {
                0 => self.time,
                _ => self.model.get(self.index(reference, false)?)?,
            };
        }
        Ok(())
    }

    /// Reads truth values, in the standard's own type for them.
    ///
    /// # Errors
    /// As [`Instance::get_reals`].
    pub fn get_booleans<T: From<bool>>(&mut self, references: &[u32], values: &mut [T]) -> Result<(), Fault> {
        expect_length(values.len(), references.len())?;
        for (&reference, value) in references.iter().zip(values) {
            *value = (self.model.get(self.index(reference, true)?)? != 0.0).into();
        }
        Ok(())
    }

    /// Sets real variables.
    ///
    /// # Errors
    /// A reference is not that of a real variable, the variable cannot be set now, or the model
    /// refuses the value. What stands before it has been set.
    pub fn set_reals(&mut self, references: &[u32], values: &[f64]) -> Result<(), Fault> {
        expect_length(values.len(), references.len())?;
        references
            .iter()
            .zip(values)
            .try_for_each(|(&reference, &value)| self.set(reference, false, value))
    }

    /// Sets truth values.
    ///
    /// # Errors
    /// As [`Instance::set_reals`].
    pub fn set_booleans<T: Copy + PartialEq + From<bool>>(
        &mut self,
        references: &[u32],
        values: &[T],
    ) -> Result<(), Fault> {
        expect_length(values.len(), references.len())?;
        references.iter().zip(values).try_for_each(|(&reference, &value)| {
            self.set(reference, true, if value == T::from(false) { 0.0 } else { 1.0 })
        })
    }

    fn set(&mut self, reference: u32, boolean: bool, value: f64) -> Result<(), Fault> {
        let index = self.index(reference, boolean)?;
        let variable = self.model.variables()[index];
        if variable.role == Role::Parameter && self.state & (INSTANTIATED | INITIALIZATION) == 0 {
            return refuse(format!(
                "{} is a parameter: it can be set before the end of initialization only",
                variable.symbol.id
            ));
        }
        self.model.set(index, value)
    }

    /// The model's index of a value reference.
    fn index(&self, reference: u32, boolean: bool) -> Result<usize, Fault> {
        let kind = if boolean { "boolean" } else { "real" };
        let index = (reference as usize).wrapping_sub(1);
        match self.model.variables().get(index) {
            Some(variable) if variable.boolean == boolean => Ok(index),
            Some(variable) => refuse(format!("{} is not a {kind} variable", variable.symbol.id)),
            None => refuse(format!("no {kind} variable has the value reference {reference}")),
        }
    }

    /// Saves the instance under `handle`, or under a new handle if that is 0.
    ///
    /// # Errors
    /// The handle does not exist.
    pub fn save(&mut self, handle: usize) -> Result<usize, Fault> {
        let snapshot = self.snapshot();
        self.keep(handle, snapshot)
    }

    /// Brings a saved instance back.
    ///
    /// # Errors
    /// The handle does not exist.
    pub fn load_saved(&mut self, handle: usize) -> Result<(), Fault> {
        let at = self.find(handle)?;
        let snapshot = std::mem::take(&mut self.saved[at].1);
        let result = self.restore(&snapshot);
        self.saved[at].1 = snapshot;
        result
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
        Ok(HEADER + 8 * self.saved[self.find(handle)?].1.len())
    }

    /// Writes a saved instance as bytes: name and version of the format, a hash, the numbers.
    ///
    /// # Errors
    /// The handle does not exist, or the size is not [`Instance::serialized_size`].
    pub fn serialize(&self, handle: usize, bytes: &mut [u8]) -> Result<(), Fault> {
        expect_length(bytes.len(), self.serialized_size(handle)?)?;
        let (header, body) = bytes.split_at_mut(HEADER);
        for (number, place) in self.saved[self.find(handle)?].1.iter().zip(body.chunks_exact_mut(8)) {
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
        match body {
            Some((hash, body)) if *hash == self.hash(body) && body.len() == 8 * self.initial.len() => {
                let numbers = body.as_chunks::<8>().0.iter().map(|&number| f64::from_le_bytes(number));
                self.keep(handle, numbers.collect())
            }
            _ => refuse("the serialised FMU state is damaged, or that of another scene or version"),
        }
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
            .map_err(|_| Fault("the FMU state does not exist in this instance, or has been freed".to_owned()))
    }

    fn keep(&mut self, handle: usize, snapshot: Vec<f64>) -> Result<usize, Fault> {
        if handle != 0 {
            let at = self.find(handle)?;
            self.saved[at].1 = snapshot;
            return Ok(handle);
        }
        self.last_handle += 1;
        self.saved.push((self.last_handle, snapshot));
        Ok(self.last_handle)
    }

    /// All that changes in an instance, as numbers.
    fn snapshot(&self) -> Vec<f64> {
        let mut numbers = vec![f64::from(self.state), self.time, self.model_time, self.stop];
        numbers.extend(self.model.values());
        numbers
    }

    fn restore(&mut self, snapshot: &[f64]) -> Result<(), Fault> {
        let &[state, time, model_time, stop, ref values @ ..] = snapshot else {
            return refuse("the FMU state is incomplete");
        };
        let Some(state) = (0..7)
            .map(|bit| 1 << bit)
            .find(|&known: &States| f64::from(known) == state)
        else {
            return refuse("the FMU state is that of no known state");
        };
        self.model.restore(values)?;
        self.set_time(model_time)?;
        (self.state, self.time, self.stop) = (state, time, stop);
        Ok(())
    }
}

/// For quantities that a model has none of.
///
/// # Errors
/// Some were asked for.
pub fn expect_none(count: usize) -> Result<(), Fault> {
    if count == 0 {
        Ok(())
    } else {
        refuse(format!("{count} values were asked for, the FMU has none of this kind"))
    }
}

fn expect_length(given: usize, expected: usize) -> Result<(), Fault> {
    if given == expected {
        Ok(())
    } else {
        refuse(format!("{given} values were given, {expected} were expected"))
    }
}

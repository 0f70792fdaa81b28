//! The default scene as an importer finds it: a resources folder, a token, value references.
#![allow(dead_code, reason = "each test uses its own part")]

use lemnis_fmu::abi::{
    Component, STATUS_DISCARD, STATUS_ERROR, STATUS_FATAL, STATUS_WARNING, Status, fmi2::*, fmi3::*,
};
use lemnis_fmu::layout::{self, Place};
use lemnis_models::component::model::Model;
use lemnis_models::scene::{self, Scene};
use std::ffi::{CStr, CString, c_char, c_void};
use std::path::Path;
use std::ptr::null;
use tempfile::TempDir;

/// An angle of the boom that the default crane can reach, and one that it cannot, in rad.
pub const REACHABLE: f64 = 1.3;
pub const UNREACHABLE: f64 = 0.1;

/// What the logger was told: status and text.
pub type Messages = Vec<(Status, String)>;

pub struct Unpacked {
    pub model: Model,
    pub token: CString,
    pub folder: TempDir,
}

impl Unpacked {
    pub fn new() -> Unpacked {
        let scene = Scene::parse(scene::DEFAULT).unwrap_or_else(|_| panic!("the default scene is valid"));
        Unpacked::of(&scene)
    }

    pub fn of(scene: &Scene) -> Unpacked {
        let folder = tempfile::tempdir().unwrap();
        std::fs::create_dir(folder.path().join("resources")).unwrap();
        std::fs::write(folder.path().join("resources/scene.toml"), scene.text()).unwrap();
        Unpacked {
            model: scene.model().unwrap(),
            token: CString::new(lemnis_fmu::instance::token(scene)).unwrap(),
            folder,
        }
    }

    pub fn path(&self) -> &Path {
        self.folder.path()
    }

    /// The resources folder as FMI 3 passes it.
    pub fn resources(&self) -> CString {
        CString::new(format!("{}/resources/", self.path().display())).unwrap()
    }

    /// Position of a variable in the model.
    pub fn index(&self, id: &str) -> usize {
        let variables = self.model.variables().iter();
        variables.map(|v| v.name()).position(|name| name == id).unwrap()
    }

    /// Value reference of a variable, a string or a vector.
    pub fn reference(&self, name: &str) -> u32 {
        let variables = self.model.variables();
        let string = layout::STRINGS.iter().position(|(string, _)| *string == name);
        let mut vectors = layout::vectors(variables).into_iter();
        let place = match (string, vectors.position(|vector| vector.name == name)) {
            (Some(index), _) => Place::String(index),
            (_, Some(index)) => Place::Vector(index),
            _ => Place::Variable(self.index(name)),
        };
        layout::reference(variables.len(), place)
    }
}

// SAFETY in these tests: instances are freed once, arrays have the lengths given, and the
// environment is the list of messages.

unsafe extern "C" fn log2(
    environment: *mut c_void,
    name: *const c_char,
    status: Status,
    category: *const c_char,
    message: *const c_char,
) {
    // SAFETY: see above.
    unsafe {
        assert_eq!(CStr::from_ptr(name), c"crane");
        log3(environment, status, category, message);
    }
}

pub unsafe extern "C" fn log3(
    environment: *mut c_void,
    status: Status,
    category: *const c_char,
    message: *const c_char,
) {
    // SAFETY: see above.
    unsafe {
        let expected = match status {
            STATUS_WARNING => c"logStatusWarning",
            STATUS_DISCARD => c"logStatusDiscard",
            STATUS_ERROR => c"logStatusError",
            STATUS_FATAL => c"logStatusFatal",
            _ => c"no other status is logged",
        };
        assert_eq!(CStr::from_ptr(category), expected);
        let messages = &mut *environment.cast::<Messages>();
        messages.push((status, CStr::from_ptr(message).to_str().unwrap().to_owned()));
    }
}

pub fn callbacks(messages: &mut Messages) -> fmi2CallbackFunctions {
    fmi2CallbackFunctions {
        // SAFETY: stable Rust cannot define a variadic function; this one ignores the missing arguments.
        logger: Some(unsafe { std::mem::transmute::<*const c_void, fmi2CallbackLogger>(log2 as *const c_void) }),
        allocateMemory: null(),
        freeMemory: null(),
        stepFinished: null(),
        componentEnvironment: (&raw mut *messages).cast(),
    }
}

/// `kind`: 0 for Model Exchange, 1 for Co-Simulation.
pub fn instantiate2(fmu: &Unpacked, kind: i32, messages: &mut Messages) -> *mut Component {
    let location = CString::new(format!("file://{}/resources", fmu.path().display())).unwrap();
    // SAFETY: see above.
    unsafe {
        fmi2Instantiate(
            c"crane".as_ptr(),
            kind,
            fmu.token.as_ptr(),
            location.as_ptr(),
            &callbacks(messages),
            0,
            0,
        )
    }
}

pub fn instantiate3(fmu: &Unpacked, events: bool, messages: &mut Messages) -> *mut Component {
    // SAFETY: see above.
    unsafe {
        fmi3InstantiateCoSimulation(
            c"crane".as_ptr(),
            fmu.token.as_ptr(),
            fmu.resources().as_ptr(),
            0,
            0,
            events.into(),
            0,
            null(),
            0,
            (&raw mut *messages).cast(),
            Some(log3),
            null(),
        )
    }
}

pub fn instantiate3_model_exchange(fmu: &Unpacked, messages: &mut Messages) -> *mut Component {
    // SAFETY: see above.
    unsafe {
        fmi3InstantiateModelExchange(
            c"crane".as_ptr(),
            fmu.token.as_ptr(),
            fmu.resources().as_ptr(),
            0,
            0,
            (&raw mut *messages).cast(),
            Some(log3),
        )
    }
}

pub fn step3(i: *mut Component, point: f64, size: f64) -> (Status, f64) {
    let (mut event, mut terminate, mut early, mut reached) = (9, 9, 9, f64::NAN);
    // SAFETY: see above.
    let status = unsafe { fmi3DoStep(i, point, size, 0, &mut event, &mut terminate, &mut early, &mut reached) };
    (status, reached)
}

//! The FMU's shared library beside the scene that it reads, called as an importer calls it.

use std::ffi::{CString, c_char, c_int, c_void};
use std::path::Path;
use std::ptr::{null, null_mut};

use lemnis_fmu::instance::token;
use lemnis_fmu::package;
use lemnis_models::scene::Scene;
use libloading::{Library, Symbol};

/// Of FMI 3, if nothing else is said; FMI 2 has no numbers of values beside those of references.
pub type Logger = unsafe extern "C" fn(*mut c_void, c_int, *const c_char, *const c_char);
pub type Instantiate = unsafe extern "C" fn(
    *const c_char,
    *const c_char,
    *const c_char,
    u8,
    u8,
    u8,
    u8,
    *const u32,
    usize,
    *mut c_void,
    Option<Logger>,
    *const c_void,
) -> *mut c_void;
pub type Enter = unsafe extern "C" fn(*mut c_void, u8, f64, f64, u8, f64) -> c_int;
pub type Call = unsafe extern "C" fn(*mut c_void) -> c_int;
pub type SetReal = unsafe extern "C" fn(*mut c_void, *const u32, usize, *const f64, usize) -> c_int;
pub type Real = unsafe extern "C" fn(*mut c_void, *const u32, usize, *mut f64, usize) -> c_int;
pub type DoStep = unsafe extern "C" fn(*mut c_void, f64, f64, u8, *mut u8, *mut u8, *mut u8, *mut f64) -> c_int;
pub type GetState = unsafe extern "C" fn(*mut c_void, *mut *mut c_void) -> c_int;
pub type SetState = unsafe extern "C" fn(*mut c_void, *mut c_void) -> c_int;
pub type Free = unsafe extern "C" fn(*mut c_void);

/// An FMU, unpacked.
pub struct Unpacked {
    pub scene: Scene,
    pub token: CString,
    library: Library,
    folder: tempfile::TempDir,
}

impl Unpacked {
    /// # Panics
    /// With a scene that cannot be read, or where the library was not built.
    #[must_use]
    pub fn new(text: &str) -> Unpacked {
        Unpacked::with(text, &package::find_library().expect("built"))
    }

    /// The same with the library of this path.
    ///
    /// # Panics
    /// With a scene that cannot be read, or a library that cannot be loaded.
    #[must_use]
    pub fn with(text: &str, path: &Path) -> Unpacked {
        let scene = Scene::parse(text).unwrap_or_else(|found| panic!("{found:?}"));
        let folder = tempfile::tempdir().expect("a folder");
        std::fs::write(folder.path().join("scene.toml"), text).expect("writable");
        Unpacked {
            token: CString::new(token(&scene)).expect("a token"),
            // SAFETY: the library is our own, and loading it runs nothing.
            library: unsafe { Library::new(path) }.expect("loads"),
            scene,
            folder,
        }
    }

    /// Where the scene lies, with a prefix.
    ///
    /// # Panics
    /// Where the system's folder has a zero in its name.
    #[must_use]
    pub fn resources(&self, prefix: &str) -> CString {
        CString::new(format!("{prefix}{}/", self.folder.path().display())).expect("a path")
    }

    /// A function of the library.
    ///
    /// # Safety
    /// `T` is the type that the standard gives the function.
    ///
    /// # Panics
    /// Where there is no such function.
    #[must_use]
    pub unsafe fn function<T>(&self, name: &str) -> Symbol<'_, T> {
        // SAFETY: the caller's promise.
        unsafe { self.library.get(name) }.expect("exported")
    }

    /// A new instance for Co-Simulation; null where it is refused.
    #[must_use]
    pub fn instantiate(&self, environment: *mut c_void, logger: Option<Logger>) -> *mut c_void {
        let resources = self.resources("");
        // SAFETY: the type is that of the standard, the strings end with a zero.
        unsafe {
            self.function::<Instantiate>("fmi3InstantiateCoSimulation")(
                c"crane".as_ptr(),
                self.token.as_ptr(),
                resources.as_ptr(),
                0,
                0,
                0,
                0,
                null(),
                0,
                environment,
                logger,
                null(),
            )
        }
    }

    /// A new instance, initialized.
    ///
    /// # Panics
    /// Where it cannot be.
    #[must_use]
    pub fn start(&self) -> *mut c_void {
        let instance = self.instantiate(null_mut(), None);
        assert!(!instance.is_null());
        // SAFETY: the types are those of the standard.
        unsafe {
            let entered = self.function::<Enter>("fmi3EnterInitializationMode")(instance, 0, 0.0, 0.0, 0, 0.0);
            let left = self.function::<Call>("fmi3ExitInitializationMode")(instance);
            assert_eq!((entered, left), (0, 0));
        }
        instance
    }

    /// Frees an instance, which is to be done once.
    pub fn free(&self, instance: *mut c_void) {
        // SAFETY: the type is that of the standard; every caller frees what it started, once.
        unsafe { self.function::<Free>("fmi3FreeInstance")(instance) }
    }
}

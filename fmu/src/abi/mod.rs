//! The C boundary: what every exported function of both standards passes
//! through. No panic, null pointer or call in the wrong state gets any further.

pub mod fmi2;
pub mod fmi3;

use crate::instance::{CATEGORIES, FATAL, Instance, NEVER, States};
use crate::refuse;
use lemnis_models::kernel::variable::Fault;
use std::any::Any;
use std::ffi::{CStr, CString, c_char, c_int};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;

/// `fmi2Status` and `fmi3Status`, which agree in the values used here.
pub type Status = c_int;
pub const STATUS_OK: Status = 0;
pub const STATUS_WARNING: Status = 1;
pub const STATUS_DISCARD: Status = 2;
pub const STATUS_ERROR: Status = 3;
pub const STATUS_FATAL: Status = 4;

/// Takes a status, a category and a message to the importer's logger.
type Log = Box<dyn Fn(Status, &CStr, &CStr)>;

/// What the importer holds a pointer to.
pub struct Component {
    instance: Instance,
    log: Log,
}

/// Declares the functions of a standard that act on an instance, each with the
/// states in which it is allowed, and collects them in one table. The function
/// `discards` of the same file tells in which states a value or a configuration
/// that does not exist is discarded instead of an error.
macro_rules! exports {
    ($table:ident, $instance:ident;
     $(fn $name:ident($($arg:tt: $type:ty),* $(,)?) in $allowed:expr => $body:expr;)*) => {
        /// Every function that acts on an instance, with the states in which it is allowed.
        pub const $table: &[(&str, $crate::instance::States)] = &[$((stringify!($name), $allowed)),*];
        $(
            #[allow(unused_variables, reason = "some functions only answer that there is nothing to do")]
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn $name(component: *mut Component $(, $arg: $type)*) -> Status {
                // SAFETY: the standard has the importer pass a pointer from the instantiation that is
                // not yet freed, and arrays that are as long as the numbers beside them say.
                unsafe { guard(component, stringify!($name), $allowed, discards, &mut |$instance| $body) }
            }
        )*
    };
}
use exports;

/// Runs one call on an instance: everything that can go wrong becomes a status
/// and one message; `discards` tells in which states a function may discard.
/// By reference: eighty copies of this are a part of the library.
///
/// # Safety
/// `component` is null or comes from [`instantiate`] and has not been freed.
unsafe fn guard(
    component: *mut Component,
    name: &str,
    allowed: States,
    discards: fn(&str) -> States,
    call: &mut dyn FnMut(&mut Instance) -> Result<(), Fault>,
) -> Status {
    // SAFETY: the caller's promise.
    let Some(Component { instance, log }) = (unsafe { component.as_mut() }) else {
        return STATUS_ERROR;
    };
    if instance.state() & allowed == 0 {
        return untimely(instance, log, name, allowed);
    }
    match catch_unwind(AssertUnwindSafe(|| call(instance))) {
        Ok(Ok(())) => match instance.take_warning() {
            None => STATUS_OK,
            Some(words) => report(instance, log, name, STATUS_WARNING, words),
        },
        Ok(Err(fault)) => refused(instance, log, name, discards, &fault),
        Err(panic) => panicked(instance, log, name, panic.as_ref()),
    }
}

#[cold]
fn untimely(instance: &Instance, log: &Log, name: &str, allowed: States) -> Status {
    let reason = match allowed {
        NEVER => "the FMU does not have this capability".to_owned(),
        _ => format!("not allowed in the state {:?}", instance.state_name()),
    };
    report(instance, log, name, STATUS_ERROR, &reason)
}

#[cold]
fn refused(instance: &Instance, log: &Log, name: &str, discards: fn(&str) -> States, fault: &Fault) -> Status {
    let discard = fault.outside && discards(name) & instance.state() != 0;
    let status = if discard { STATUS_DISCARD } else { STATUS_ERROR };
    report(instance, log, name, status, &fault.message)
}

#[cold]
fn panicked(instance: &mut Instance, log: &Log, name: &str, panic: &(dyn Any + Send)) -> Status {
    let status = report(instance, log, name, STATUS_FATAL, &panic_message(panic));
    instance.enter(FATAL).map_or(STATUS_ERROR, |()| status)
}

/// Index of a status in [`CATEGORIES`].
fn category(status: Status) -> usize {
    (status - STATUS_WARNING) as usize
}

#[cold]
fn report(instance: &Instance, log: &Log, name: &str, status: Status, message: &str) -> Status {
    let category = category(status);
    if instance.is_logged(category) {
        log(status, CATEGORIES[category].0, &c_string(&format!("{name}: {message}")));
    }
    status
}

/// Makes an instance, or reports why not and returns null.
fn instantiate(log: Log, name: &str, make: impl FnOnce() -> Result<Instance, Fault>) -> *mut Component {
    let (status, message) = match catch_unwind(AssertUnwindSafe(make)) {
        Ok(Ok(instance)) => return Box::into_raw(Box::new(Component { instance, log })),
        Ok(Err(Fault { message, .. })) => (STATUS_ERROR, message),
        Err(panic) => (STATUS_FATAL, panic_message(panic.as_ref())),
    };
    log(
        status,
        CATEGORIES[category(status)].0,
        &c_string(&format!("{name}: {message}")),
    );
    std::ptr::null_mut()
}

/// # Safety
/// `component` is null or comes from [`instantiate`] and has not been freed.
unsafe fn free(component: *mut Component) {
    if !component.is_null() {
        // SAFETY: the caller's promise.
        let component = unsafe { Box::from_raw(component) };
        // Nothing is left to report a panic to.
        let _ = catch_unwind(AssertUnwindSafe(|| drop(component)));
    }
}

fn panic_message(panic: &(dyn Any + Send)) -> String {
    let text = panic
        .downcast_ref::<String>()
        .map(String::as_str)
        .or_else(|| panic.downcast_ref::<&str>().copied());
    format!(
        "defect of the program, the instance cannot be used any more: {}",
        text.unwrap_or("no message")
    )
}

fn c_string(text: &str) -> CString {
    CString::new(text.replace('\0', "")).unwrap_or_default()
}

/// # Safety
/// `pointer` is null or points to `length` values that live as long as the result is used.
unsafe fn slice<'a, T>(pointer: *const T, length: usize) -> Result<&'a [T], Fault> {
    check(pointer, length)?;
    if length == 0 {
        return Ok(&[]);
    }
    // SAFETY: the caller's promise; not null, aligned, and no longer than an object can be.
    Ok(unsafe { std::slice::from_raw_parts(pointer, length) })
}

/// # Safety
/// As [`slice`], and nothing else refers to the values.
unsafe fn slice_mut<'a, T>(pointer: *mut T, length: usize) -> Result<&'a mut [T], Fault> {
    check(pointer, length)?;
    if length == 0 {
        return Ok(&mut []);
    }
    // SAFETY: the caller's promise; not null, aligned, and no longer than an object can be.
    Ok(unsafe { std::slice::from_raw_parts_mut(pointer, length) })
}

fn check<T>(pointer: *const T, length: usize) -> Result<(), Fault> {
    if length > 0 && pointer.is_null() {
        return refuse("a pointer is null");
    }
    if length > 0 && !pointer.is_aligned() || length > isize::MAX as usize / size_of::<T>() {
        return refuse("an array is misaligned or too long");
    }
    Ok(())
}

/// # Safety
/// `pointer` is null or points to a value that nothing else refers to.
unsafe fn place<'a, T>(pointer: *mut T) -> Result<&'a mut T, Fault> {
    // SAFETY: the caller's promise.
    unsafe { slice_mut(pointer, 1) }.map(|values| &mut values[0])
}

/// # Safety
/// `pointer` is null or points to a string that ends with a zero and lives as long as the result is used.
unsafe fn text<'a>(pointer: *const c_char, what: &str) -> Result<&'a str, Fault> {
    if pointer.is_null() {
        return refuse(format!("{what} is null"));
    }
    // SAFETY: the caller's promise; not null.
    unsafe { CStr::from_ptr(pointer) }
        .to_str()
        .map_err(|_| Fault::new(format!("{what} is not UTF-8")))
}

/// # Safety
/// `pointer` is null or points to `length` strings as for [`text`].
unsafe fn texts<'a>(pointer: *const *const c_char, length: usize) -> Result<Vec<&'a str>, Fault> {
    // SAFETY: the caller's promise.
    unsafe {
        slice(pointer, length)?
            .iter()
            .map(|&pointer| text(pointer, "a string"))
            .collect()
    }
}

/// The `resources` folder of the FMU that this library lies in, for importers that pass no path.
fn own_resources() -> Result<PathBuf, Fault> {
    let library =
        own_path().ok_or_else(|| Fault::new("no resource path was given, and none could be found".to_owned()))?;
    match library.ancestors().nth(3) {
        Some(root) => Ok(root.join("resources")),
        None => refuse(format!(
            "no resource path was given, and {} lies in no FMU",
            library.display()
        )),
    }
}

#[cfg(unix)]
fn own_path() -> Option<PathBuf> {
    use std::ffi::{OsStr, c_void};
    use std::os::unix::ffi::OsStrExt;

    /// `Dl_info` of dlfcn.h.
    #[repr(C)]
    struct Info {
        file_name: *const c_char,
        base: *mut c_void,
        symbol_name: *const c_char,
        symbol: *mut c_void,
    }
    unsafe extern "C" {
        fn dladdr(address: *const c_void, info: *mut Info) -> c_int;
    }
    let mut info = Info {
        file_name: std::ptr::null(),
        base: std::ptr::null_mut(),
        symbol_name: std::ptr::null(),
        symbol: std::ptr::null_mut(),
    };
    // SAFETY: the address is one of this library, and `info` outlives the call.
    let found = unsafe { dladdr(own_path as *const c_void, &mut info) };
    if found == 0 || info.file_name.is_null() {
        return None;
    }
    // SAFETY: dladdr succeeded, its string lives as long as the library is loaded.
    let name = unsafe { CStr::from_ptr(info.file_name) };
    std::fs::canonicalize(OsStr::from_bytes(name.to_bytes())).ok()
}

#[cfg(windows)]
fn own_path() -> Option<PathBuf> {
    use std::ffi::{OsString, c_void};
    use std::os::windows::ffi::OsStringExt;

    unsafe extern "system" {
        fn GetModuleHandleExW(flags: u32, address: *const c_void, module: *mut *mut c_void) -> i32;
        fn GetModuleFileNameW(module: *mut c_void, name: *mut u16, size: u32) -> u32;
    }
    /// GET_MODULE_HANDLE_EX_FLAG_FROM_ADDRESS and _UNCHANGED_REFCOUNT.
    const FLAGS: u32 = 4 | 2;
    let mut module = std::ptr::null_mut();
    let mut name = vec![0; 32_768];
    // SAFETY: the address is one of this library, and `module` outlives the call.
    if unsafe { GetModuleHandleExW(FLAGS, own_path as *const c_void, &mut module) } == 0 {
        return None;
    }
    // SAFETY: the name has the size that is given.
    let length = unsafe { GetModuleFileNameW(module, name.as_mut_ptr(), name.len() as u32) };
    (length > 0).then(|| OsString::from_wide(&name[..length as usize]).into())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::instance::{ANY, Interface, token};
    use lemnis_models::scene::{DEFAULT, Scene};
    use std::sync::{Arc, Mutex};

    /// A defect of the program becomes the fatal status and one message; then only freeing is left.
    #[test]
    fn a_panic_does_not_reach_the_host() {
        let told = Arc::new(Mutex::new(Vec::new()));
        let log = {
            let told = Arc::clone(&told);
            Box::new(move |status, category: &CStr, message: &CStr| {
                let text = |words: &CStr| words.to_string_lossy().into_owned();
                told.lock().unwrap().push((status, text(category), text(message)));
            })
        };
        let scene = Scene::parse(DEFAULT).expect("valid");
        let component = instantiate(log, "instantiate", || {
            Instance::new(&scene, &token(&scene), Interface::CoSimulation)
        });
        // SAFETY: the component is alive until it is freed.
        unsafe {
            let call =
                |mut body: fn(&mut Instance) -> Result<(), Fault>| guard(component, "call", ANY, |_| ANY, &mut body);
            assert_eq!(call(|_| Ok(())), STATUS_OK);
            assert_eq!(call(|_| panic!("a planted defect")), STATUS_FATAL);
            assert_eq!(call(|_| Ok(())), STATUS_ERROR);
            assert_eq!(fmi2::fmi2Reset(component), STATUS_ERROR);
            free(component);
        }
        let told = told.lock().unwrap();
        assert_eq!(told.len(), 3, "{told:?}");
        assert_eq!((told[0].0, told[0].1.as_str()), (STATUS_FATAL, "logStatusFatal"));
        assert!(told[0].2.starts_with("call: defect of the program") && told[0].2.ends_with("a planted defect"));

        let log: Log = Box::new(|_, _, _| ());
        assert!(instantiate(log, "instantiate", || panic!("a planted defect")).is_null());
    }
}

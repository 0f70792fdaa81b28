//! The FMU: FMI 2.0 and FMI 3.0, Co-Simulation and Model Exchange, over a
//! `lemnis_models::kernel::variable::Model`.
//!
//! ```text
//! abi/fmi2.rs  abi/fmi3.rs   the C functions of the standards, names verbatim
//!         abi/mod.rs         the guard that each of them passes: null pointers, states, panics, log
//!        instance.rs         one instance: time, state machine, FMU states; no unsafe code
//!                            (from here on it is lemnis_models)
//!          layout.rs         value references
//!     description.rs         modelDescription.xml, terminalsAndIcons.xml
//!         package.rs         the .fmu file
//! ```
//!
//! The shared library in an FMU is this crate. It reads its scene from the
//! FMU's `resources/scene.toml`, so that making an FMU needs no compiler.

#![deny(unsafe_code)]

#[allow(unsafe_code, reason = "the C boundary; each block says why it is sound")]
pub mod abi;
pub mod description;
pub mod instance;
pub mod layout;
pub mod package;

use lemnis_models::kernel::variable::Fault;

/// Shorthand for leaving a function with a message.
#[cold]
fn refuse<T>(message: impl Into<String>) -> Result<T, Fault> {
    Err(Fault::new(message))
}

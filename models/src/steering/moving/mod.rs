//! The groups in motion, as a scene asks for it: `fidelity = "hydraulic"`.
//!
//! | file | what |
//! |---|---|
//! | `symbols` | quantities that exist in motion only |
//! | `scene` | keys of `[steering.dynamics]`, `[steering.oil]` and `[steering.plc]` |
//! | `motion` | stages: the equations of all groups under present inputs, what follows from their states |
//! | `sampled` | how they are carried on: samples of the PLC, what the solver keeps |
//! | `told` | what the book tells: a movement of the running model, and the equations at one instant |
//!
//! The equations are in [`hydraulic`](crate::steering::hydraulic).

pub mod motion;
pub mod sampled;
pub mod scene;
pub mod symbols;
pub mod told;

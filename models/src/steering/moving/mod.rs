//! The groups in motion, as a scene asks for it: `fidelity = "hydraulic"`.
//!
//! | file | what |
//! |---|---|
//! | `symbols` | quantities that exist in motion only |
//! | `scene` | keys of `[steering.dynamics]`, `[steering.oil]` and `[steering.plc]` |
//! | `level` | equations of all groups, the solver's and the PLC's state of each |
//! | `told` | what the book tells: a movement of the running model, and the equations at one instant |
//! | `model` | the running model: states, rates, samples, steps; everything else from the algebraic model |
//!
//! The equations are in [`hydraulic`](crate::steering::hydraulic).

pub mod level;
pub mod model;
pub mod scene;
pub mod symbols;
pub mod told;

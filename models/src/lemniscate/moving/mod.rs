//! The mechanism in motion, as a scene asks for it: `fidelity = "rigid"` or `"swing"`.
//!
//! | file | what |
//! |---|---|
//! | `symbols` | quantities that exist in motion only |
//! | `scene` | keys of `[luffing.dynamics]` |
//! | `model` | the running model: states, rates, events, steps; everything else from the algebraic model |
//!
//! The equations are in [`dynamics`](crate::lemniscate::dynamics) and [`motion`](crate::lemniscate::motion).

pub mod model;
pub mod scene;
pub mod symbols;

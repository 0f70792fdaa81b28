//! The mechanism in motion, as a scene asks for it: `fidelity = "rigid"`, `"swing"` or `"hydraulic"`.
//!
//! | file | what |
//! |---|---|
//! | `symbols` | quantities that exist in motion only |
//! | `scene` | keys of `[luffing.dynamics]`, `[luffing.slewing]` and `[luffing.hydraulics]` |
//! | `hoisting` | keys of `[luffing.hoisting]`: rope and hoist |
//! | `level` | equations and solver of each level |
//! | `model` | the running model: states, rates, events, steps; everything else from the algebraic model |
//!
//! The equations are in [`dynamics`](crate::luffing::double_link::dynamics), [`motion`](crate::luffing::double_link::motion),
//! [`hanging`](crate::luffing::double_link::hanging), [`slewing`](crate::luffing::double_link::slewing) and [`hydraulic`](crate::luffing::double_link::hydraulic).
//! Forces of the motion follow from them in [`forces_in_motion`](crate::luffing::double_link::forces_in_motion).

pub mod given;
pub mod hoisting;
pub mod level;
pub mod model;
pub mod scene;
pub mod symbols;

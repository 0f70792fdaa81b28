//! The mechanism in motion, as a scene asks for it: `fidelity = "rigid"`, `"swing"` or `"hydraulic"`.
//!
//! | file | what |
//! |---|---|
//! | `symbols` | quantities that exist in motion only |
//! | `scene` | keys of `[luffing.dynamics]`, `[luffing.slewing]` and `[luffing.hydraulics]` |
//! | `hoisting` | keys of `[luffing.hoisting]`: rope and hoist |
//! | `given` | inputs, states and memory as groups |
//! | `level`, `built` | equations of each level, and how they are made from what is given |
//! | `motion` | stages: rates, event indicators, results of the motion |
//! | `listed` | what of all that a scene has |
//! | `start`, `carried` | where the motion begins; how it is carried on, what the solver keeps |
//! | `follows`, `told` | what depends on what; what the book tells |
//!
//! The equations are in [`dynamics`](crate::luffing::moving::dynamics), [`motion`](crate::luffing::moving::motion),
//! [`hanging`](crate::luffing::moving::hanging), [`slewing`](crate::luffing::moving::space) and [`hydraulic`](crate::luffing::moving::hydraulic).
//! Forces of the motion follow from them in [`forces_in_motion`](crate::luffing::double_link::forces_in_motion).

pub mod built;
mod carried;
pub mod follows;
pub mod listed;
pub mod motion;
pub mod scene;
pub mod start;
pub mod symbols;
pub(crate) mod told;

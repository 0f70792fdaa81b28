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
//! The equations are in [`dynamics`](crate::luffing::double_link::dynamics), [`motion`](crate::luffing::double_link::motion),
//! [`hanging`](crate::luffing::double_link::hanging), [`slewing`](crate::luffing::double_link::slewing) and [`hydraulic`](crate::luffing::double_link::hydraulic).
//! Forces of the motion follow from them in [`forces_in_motion`](crate::luffing::double_link::forces_in_motion).

mod built;
mod carried;
pub mod follows;
pub mod given;
pub mod hoisting;
pub mod level;
pub mod listed;
pub mod motion;
pub mod scene;
pub mod start;
pub mod symbols;
pub(crate) mod told;

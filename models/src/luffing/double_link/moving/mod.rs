//! The mechanism in motion, as a scene asks for it: `fidelity = "rigid"`, `"swing"` or `"hydraulic"`.
//!
//! | file | what |
//! |---|---|
//! | `symbols` | quantities that exist in motion only |
//! | `scene` | keys of `[luffing.dynamics]` |
//! | `built` | equations of its level, made from what is given |
//! | `motion` | stages: bodies, rates, forces |
//! | `shown` | what is its own in what the book tells |
//!
//! What any luffing mechanism has in motion stands in [`moving`](crate::luffing::moving). Forces follow from that in
//! [`forces_in_motion`](crate::luffing::double_link::forces_in_motion).

pub mod built;
pub mod motion;
pub mod scene;
pub mod shown;
pub mod symbols;

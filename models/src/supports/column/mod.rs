//! A crane that slews on a column in three bearings: an upper one and a foot bearing that share forces and moment of
//! [what slews](crate::supports::upper), and a pivot at the foot that bears the weight. [Ports001, 6.3.2]
//!
//! ```text
//!           o------------ Q      heights and moments count
//!    _______|____ boom           from the upper bearing
//!   |G_u  | |
//!   |_____|_|
//!       H_u -> | |  upper bearing, D_u, b_u
//!              | |
//!              | |  h_uf
//!              | |
//!       H_f <- | |  foot bearing, D_f, b_f
//!              |_|
//!               ^ V  pivot, D_p, d_i
//! ```
//!
//! | id | function | source |
//! |---|---|---|
//! | `column.bearings` | [`bearings::ColumnForces::new`] | Ports001, 6.3.2: equilibrium |
//! | `column.friction` | [`friction::pivot_radius`], [`friction::ColumnTurning::new`] | Ports001, 6.3.2 |
//! | `column.pressure` | [`pressure::BearingPressure::new`] | mean pressure |
//! | `column.counterweight` | [`counterweight::Evened::new`] | Ports001, 3.2.1 |

pub mod bearings;
pub mod checks;
pub mod counterweight;
pub mod friction;
mod outline;
pub mod pressure;
pub mod scene;
pub mod stages;
pub mod symbols;

//! The double-link level-luffing mechanism. [Li2022; Balance004 for the weights]
//!
//! ```text
//!              C ───_X_2_            X_4       A
//!             /          B ────────────────── o   R = x_A + X_8
//!      X_3  /           /                     |
//!         /           /  X_1                  Q
//!   O3  o           /
//!    X_6|         /  theta_1
//!       └──X_5──o O1 ─────── x          axis at x = −X_8
//! ```
//!
//! Angles counter-clockwise from the horizontal, x towards the load, y up.
//! Moments `M_Q`, `M_G` of loads are positive where they lower the driving link
//! (make theta smaller), the drive's moment `M_D` where it raises it.
//!
//! | id | function | source |
//! |---|---|---|
//! | `lemniscate.jib_angle` | [`geometry::Geometry::new`] | Li2022, eq. 6 |
//! | `lemniscate.closure` | [`crate::parts::closure::Closure::new`] | Li2022, eq. 3-5, product form derived |
//! | `lemniscate.position` | [`position::Position::new`] | Li2022, eq. 3-8 |
//! | `lemniscate.velocity` | [`velocity::Velocity::new`] | Li2022, eq. 9-10, by the loop |
//! | `lemniscate.pole` | [`pole::Pole::new`] | Li2022, eq. 1-2 |
//! | `lemniscate.luffing_moment` | [`statics::LoadMoment::new`], [`pole::Pole::moment`] | Li2022, eq. 11 |
//! | `lemniscate.led_rope` | [`leading::leads`], [`crate::luffing::led`] | Ports001, 5.9.2.4 |
//! | `lemniscate.weight_moment` | [`statics::Own::new`] | Balance004, eq. 1 |
//! | `lemniscate.pin_forces` | [`pin_forces::PinForces::new`] | equilibrium |
//! | `lemniscate.balance` | [`balancing::at`] | [`crate::balance`] |
//! | `lemniscate.drive` | [`driving::bar`], [`crate::drive::line::Drive::new`] | derived |
//! | `lemniscate.dynamics` | [`crate::luffing::moving::dynamics::Dynamics::accelerations`] | Lagrange, by derivatives |
//! | `lemniscate.inertia_forces` | [`crate::luffing::moving::inertia_forces::weight_and_inertia`] | Newton and Euler |
//! | `lemniscate.forces_in_motion` | [`pins_in_motion::PinsInMotion::new`], [`crate::luffing::moving::balance_in_motion::BalanceInMotion::new`], [`crate::luffing::moving::shares::Shares::new`] | Newton and Euler |
//! | `lemniscate.governing` | [`crate::component::governing::governing`] | derived |
//! | `lemniscate.sensitivity` | [`crate::component::sensitivity::sensitivity`] | derived |
//! | `lemniscate.resistances` | [`resisting::moved`], [`resisting::pins`] | [`crate::luffing::resistances`] |
//! | `lemniscate.unbalanced` | [`unbalanced::Unbalanced::new`], [`unbalanced::UnbalancedCase::new`] | Ports001, 5.10.3 |
//! | `lemniscate.published` | [`published::PublishedFormulas::new`] | Li2022, eq. 1, 4-7 |

pub mod aboard;
pub mod balancing;
pub mod drawing;
pub mod driving;
pub mod feet;
pub mod forces_in_motion;
pub mod geometry;
pub mod held;
pub mod keys;
pub mod leading;
pub mod linkage;
pub mod misfit;
pub mod moving;
pub mod outline;
pub mod parameters;
pub mod pin_forces;
pub mod pins_in_motion;
pub mod pole;
pub mod pose;
pub mod position;
pub mod published;
pub mod range;
pub mod resisting;
pub mod scene;
pub mod sheet;
pub mod stages;
pub mod statics;
pub mod symbols;
pub mod system;
pub mod unbalanced;
pub mod velocity;

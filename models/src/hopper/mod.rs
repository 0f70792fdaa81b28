//! The hopper of a hopper crane: the grab empties itself into it, a feeder empties it.
//!
//! ```text
//!        grab      q_in
//!         |
//!     \   v   /
//!      \ m_h /     m_max
//!       \   /
//!     ---| |---    feeder, q_out
//! ```
//!
//! Masses are positive; flows are positive the way the bulk goes: from the grab into the hopper, from there onto the feeder.
//!
//! | id | function | source |
//! |---|---|---|
//! | `hopper.balance` | [`balance::SteadyFlow::new`], [`balance::NeededCapacity::new`] | continuity |
//! | `hopper.contents` | [`balance::HopperContents::new`], [`balance::HopperTimes::new`] | continuity |
//! | `hopper.flow` | [`flow::HopperFlow::new`] | Ports001, 7.2.5 |
//! | `hopper.events` | [`flow::HopperEvents::new`], [`flow::decided`] | events |

pub mod balance;
pub mod flow;
mod outline;
pub mod scene;
pub mod stages;
pub mod symbols;

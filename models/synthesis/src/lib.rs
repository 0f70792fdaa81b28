//! Finding a lever counterweight: on the drawing board's three positions, on
//! four positions, and the best there is under constraints. A crate of its own,
//! so that an FMU carries no optimiser.
//!
//! A scene's task ([`lemnis_models::balance::task`]) goes through [`run`]; what
//! came of it is compared, for the book, by [`comparison`].

#![forbid(unsafe_code)]

pub mod candidate;
pub mod comparison;
pub mod four;
pub mod optimum;
pub mod run;
pub mod three;
pub mod tolerance;

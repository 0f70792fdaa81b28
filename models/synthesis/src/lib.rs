//! Finding a lever counterweight: on the drawing board's three positions, on
//! four positions, and the best there is under constraints. A crate of its own,
//! so that an FMU carries no optimiser.
//!
//! And finding any quantities of any scene: what makes a result of the whole range least or greatest under limits of
//! others ([`asked`]), two of them at once ([`front`](mod@front)), or brings results nearest to published ones ([`fit`](mod@fit)), finished
//! by exact derivatives ([`finish`]).
//!
//! A scene's task ([`lemnis_models::balance::task`]) goes through [`run`]; what
//! came of it is compared, for the book, by [`comparison`].

#![forbid(unsafe_code)]

pub mod asked;
pub mod candidate;
pub mod comparison;
pub mod equations;
pub mod finish;
pub mod fit;
pub mod four;
pub mod front;
pub mod levers;
pub mod optimum;
pub mod peaks;
pub mod quadratic;
pub mod run;
pub mod three;
pub mod tolerance;

//! Finding a lever counterweight: on the drawing board's three positions, on
//! four positions, and the best there is under constraints.

pub mod candidate;
pub mod four;
pub mod optimum;
pub mod three;
pub mod tolerance;

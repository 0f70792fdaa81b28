//! One thing each, ready to print.

pub mod diagram;
pub mod drawing;
mod factors;
pub mod formula;
mod label;
pub mod number;
pub mod picture;
pub mod plot;
pub mod precision;
pub(crate) mod prose;
mod quantity;
pub mod script;
pub(crate) mod speech;
pub mod spread;
mod term;
pub(crate) mod text;
mod width;

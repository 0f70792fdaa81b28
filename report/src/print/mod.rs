//! One thing each, ready to print.

pub mod diagram;
pub mod drawing;
mod factors;
pub mod formula;
pub mod number;
pub mod picture;
pub mod plot;
pub mod precision;
pub(crate) mod prose;
pub(crate) mod speech;
pub(crate) mod text;

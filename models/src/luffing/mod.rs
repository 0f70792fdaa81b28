//! What all luffing mechanisms have in common.

pub mod balancing;
pub mod counterweight;
pub mod double_link;
pub mod rope;

//! What a crane stands on.

pub mod mobile;
pub mod plan;
pub mod portal;
pub mod ring;

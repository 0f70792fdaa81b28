//! What a crane stands on.

pub mod column;
pub mod drive;
pub mod mobile;
pub mod plan;
pub mod portal;
pub mod ring;
pub mod upper;

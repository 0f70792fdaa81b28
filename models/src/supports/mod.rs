//! What a crane stands on.

pub mod mobile;

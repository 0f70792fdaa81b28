//! What several mechanisms are made of: plane geometry, a four-bar, motion over a range, oil, solvers.

pub mod arcs;
pub mod closure;
mod dead_points;
pub mod four_bar;
pub mod hydraulics;
pub mod motion;
pub mod plane;
pub mod solver;

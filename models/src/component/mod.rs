//! What every mechanism gets from its equations: a component writes groups, stages and rows, and everything else is
//! made here once.

pub mod account;
mod cycle;
pub mod dependencies;
pub mod description;
pub mod diagram;
pub mod draw;
pub mod drawing;
pub mod extreme;
pub mod found;
pub mod fragments;
pub mod governing;
pub mod judged;
mod leaving_out;
pub mod mechanism;
pub mod model;
pub mod moved;
pub mod moving;
pub mod outline;
pub mod over_time;
pub mod part;
pub mod peaks;
pub mod probe;
pub mod ride;
pub mod running;
pub mod scalar;
pub mod sensitivity;
pub mod series;
mod shaped;
pub mod sheet;
pub mod spread;
pub mod stages;
pub mod standing;
pub mod table;
pub mod telling;
pub mod whole;

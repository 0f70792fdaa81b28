//! The extremes: every case is named, and what must come out is known from theory or from a 50-digit
//! reference. No case hangs: every loop of the solvers is bounded and counted.

mod inputs;
mod oil;
mod oil_rope;
mod positions;
mod regions;
mod rope;
mod running;
mod scenes;
mod slewing;
mod steering;

#[path = "../../models/tests/common/crane.rs"]
mod crane;

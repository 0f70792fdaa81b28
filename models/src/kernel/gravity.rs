//! Gravity, by which masses weigh what they do.

use crate::kernel::symbol::symbols;

symbols! {
    G: "g" "g" M_PER_S2 / M_PER_S2 [positive], "Acceleration of gravity.", "input";
}

/// Where a scene gives none, in m/s².
pub const STANDARD: f64 = 9.81;

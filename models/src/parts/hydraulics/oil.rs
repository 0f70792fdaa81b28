//! Compressibility, and where it ends.

use crate::kernel::calc::Over;

/// Absolute vacuum as a pressure above the tank's, in Pa: below it oil cavitates, and this model's does not.
pub const VACUUM: f64 = -1e5;

/// What is to be said of a least pressure (Pa); nothing where oil can have it.
#[must_use]
pub fn warning(least: f64) -> Option<&'static str> {
    (least < VACUUM).then_some(
        "the oil has fallen below -0.1 MPa, absolute vacuum, where it cavitates and this model's does not: forces and \
         pressures are not those of a machine while cavitates is true",
    )
}

/// Rate of the pressure, in Pa/s, of a volume (m³) that a net flow (m³/s) enters and that grows at
/// `growth` (m³/s): p′ = β (Q − V′)/V.
#[inline]
pub fn pressure_rate<P, C: Over<P>>(bulk_modulus: P, volume: C, flow: C, growth: C) -> C {
    (flow - growth).times(bulk_modulus) / volume
}

//! Compressibility.

use crate::calc::Over;

/// Rate of the pressure, in Pa/s, of a volume (m³) that a net flow (m³/s) enters and that grows at
/// `growth` (m³/s): p′ = β (Q − V′)/V.
#[inline]
pub fn pressure_rate<P, C: Over<P>>(bulk_modulus: P, volume: C, flow: C, growth: C) -> C {
    (flow - growth).times(bulk_modulus) / volume
}

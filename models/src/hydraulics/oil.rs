//! Compressibility.

use crate::calc::Calc;

/// Rate of the pressure, in Pa/s, of a volume (m³) that a net flow (m³/s) enters and that grows at
/// `growth` (m³/s): p′ = β (Q − V′)/V.
#[inline]
pub fn pressure_rate<C: Calc>(bulk_modulus: C, volume: C, flow: C, growth: C) -> C {
    bulk_modulus * (flow - growth) / volume
}

//! Buckling of a straight bar under a push along it: elastic after Euler where it is slender, after Johnson where it is not.
//! Both curves have one value and one slope at the slenderness where they meet.

use std::f64::consts::PI;

use crate::kernel::calc::Calc;

/// Slenderness at which both curves meet, at half the yield point: λ_g = π √(2 E / σ_y), of Young's modulus and the yield
/// point, in Pa. (Johnson)
pub fn meeting<C: Calc>([e, sigma_y]: [C; 2]) -> C {
    C::constant(PI) * (C::constant(2.0) * e / sigma_y).sqrt()
}

/// Critical stress, in Pa, at a slenderness: π² E / λ² from where the curves meet, σ_y (1 − (λ/λ_g)²/2) below.
/// (Euler, Johnson)
pub fn critical<C: Calc>(lambda: C, meets: C, [e, sigma_y]: [C; 2]) -> C {
    if lambda.value() >= meets.value() {
        return ((C::constant(PI) / lambda).square() * e).over(meets);
    }
    sigma_y * (C::constant(1.0) - (lambda / meets).square() / C::constant(2.0))
}

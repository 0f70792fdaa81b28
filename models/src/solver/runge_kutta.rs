//! The classical explicit Runge-Kutta method of fourth order.
//!
//! Stable for |λ| h up to about 2.8 and accurate far below that. Beyond it the
//! result stays bounded in many systems and means nothing: use [`rodas`](super::rodas).

use crate::solver::finite;

/// One step of `h` s; `None` where the states do not exist on the way.
#[inline]
pub fn step<const N: usize>(
    y: &[f64; N],
    h: f64,
    mut rates: impl FnMut(&[f64; N]) -> Option<[f64; N]>,
) -> Option<[f64; N]> {
    let moved = |rate: &[f64; N], h: f64| -> [f64; N] { std::array::from_fn(|i| y[i] + h * rate[i]) };
    let k_1 = rates(y)?;
    let k_2 = rates(&moved(&k_1, h / 2.0))?;
    let k_3 = rates(&moved(&k_2, h / 2.0))?;
    let k_4 = rates(&moved(&k_3, h))?;
    let mean = std::array::from_fn(|i| (k_1[i] + 2.0 * (k_2[i] + k_3[i]) + k_4[i]) / 6.0);
    Some(moved(&mean, h)).filter(finite)
}

//! The classical explicit Runge-Kutta method of fourth order.
//!
//! Stable for |λ| h up to about 2.8 and accurate far below that: at 1 a step errs by a hundredth of what
//! changes. Beyond it the result stays bounded in many systems and means nothing, so that every step tells how
//! fast what it saw changes: [`Fast`]. For such systems there is [`rodas`](super::rodas).

use crate::parts::solver::finite;

/// Square of |λ| h that a step saw: of the fastest oscillation or decay that the motion excites. The two stages
/// in the middle of a step differ by h²/4 λ² of the rates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fast(pub f64);

/// One step of `h` s; `None` where the states do not exist on the way.
#[inline]
pub fn step<const N: usize>(
    y: &[f64; N],
    h: f64,
    mut rates: impl FnMut(&[f64; N]) -> Option<[f64; N]>,
) -> Option<[f64; N]> {
    measured(y, (h, false), |_, y| rates(y)).map(|(end, _)| end)
}

/// A step of `h` s, and how fast what it saw changes. Rates that are `forced` follow from the time since its start, too, in
/// s: they may be zero at its start, and then those in its middle tell how great they are.
#[inline]
pub fn measured<const N: usize>(
    y: &[f64; N],
    (h, forced): (f64, bool),
    mut rates: impl FnMut(f64, &[f64; N]) -> Option<[f64; N]>,
) -> Option<([f64; N], Fast)> {
    let moved = |rate: &[f64; N], h: f64| -> [f64; N] { std::array::from_fn(|i| y[i] + h * rate[i]) };
    let k_1 = rates(0.0, y)?;
    let k_2 = rates(h / 2.0, &moved(&k_1, h / 2.0))?;
    let k_3 = rates(h / 2.0, &moved(&k_2, h / 2.0))?;
    let k_4 = rates(h, &moved(&k_3, h))?;
    let mean = std::array::from_fn(|i| (k_1[i] + 2.0 * (k_2[i] + k_3[i]) + k_4[i]) / 6.0);
    let size = |of: &dyn Fn(usize) -> f64| (0..N).map(|i| of(i) * of(i)).sum::<f64>().sqrt();
    let middle = if forced { size(&|i| k_2[i]) } else { 0.0 };
    let (change, rate) = (size(&|i| k_3[i] - k_2[i]), size(&|i| k_1[i]).max(middle));
    // What stands still but for its rounding is not fast.
    let rounding = f64::EPSILON * size(&|i| y[i]);
    let fast = if h * change > rounding {
        4.0 * change / rate
    } else {
        0.0
    };
    Some((moved(&mean, h), Fast(fast))).filter(|(end, _)| finite(end))
}

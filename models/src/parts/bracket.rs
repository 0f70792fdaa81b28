//! A root between two ends.

/// Steps, at most.
const STEPS: usize = 200;

/// Where a function falls from above zero at the first end to zero or less at the other, whichever of both is greater: Newton's
/// method from a start between ends that close in, halved where a step would leave them. The function gives its value and its
/// slope; the step that is shorter than `last` is the last one, so that what is left is its square.
///
/// # Errors
/// Those of the function.
pub fn bracketed<E>(
    [mut near, mut far]: [f64; 2],
    start: f64,
    last: f64,
    mut of: impl FnMut(f64) -> Result<[f64; 2], E>,
) -> Result<f64, E> {
    let mut at = start;
    for _ in 0..STEPS {
        let [value, slope] = of(at)?;
        if value > 0.0 {
            near = at
        } else {
            far = at
        }
        let next = at - value / slope;
        let inside = next >= near.min(far) && next <= near.max(far);
        let next = if inside { next } else { f64::midpoint(near, far) };
        let done = (next - at).abs() <= last;
        at = next;
        if done {
            break;
        }
    }
    Ok(at)
}

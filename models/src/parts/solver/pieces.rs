//! A motion of smooth pieces between events: explicit steps, events located on the way by bisection.

use crate::parts::solver::{Count, Halt, MOST_STEPS, runge_kutta};

/// A communication step that is the longest step but for its rounding is one step, not two.
const ROUNDING: f64 = 1.0 - 1e-9;
/// Greatest |λ| h of a step: beyond it explicit steps are refused, as they err by more than a hundredth of what
/// changes and are soon unstable.
pub const FASTEST: f64 = 1.0;
/// Events in one call.
const MOST_EVENTS: u32 = 10_000;

/// A system of N states whose equations are smooth between events, and follow from the time (s) since the start of a call
/// besides. `S` holds states and modes.
pub trait Pieces<const N: usize, S> {
    fn states(state: &mut S) -> &mut [f64; N];

    /// Rates in the modes of a state; `None` where the states do not exist.
    fn rates(&self, time: f64, state: &S, y: &[f64; N]) -> Option<[f64; N]>;

    /// Whether the rates follow from the time.
    fn is_forced(&self) -> bool;

    /// Whether states lie beyond the end of the smooth piece.
    fn crossed(&self, time: f64, state: &S, y: &[f64; N]) -> bool;

    /// Decides what follows at an instant.
    ///
    /// # Errors
    /// The states do not exist.
    fn event(&self, time: f64, state: &mut S) -> Result<(), Halt>;
}

/// Moves on by a duration (s) in equal steps of at most `longest` (s), events located to the last bits of
/// the step. Returns the work done.
///
/// # Errors
/// See [`Halt`]; the state is that of the last step that succeeded.
pub fn advance<const N: usize, S: Copy, P: Pieces<N, S>>(
    system: &P,
    state: &mut S,
    duration: f64,
    longest: f64,
) -> Result<Count, Halt> {
    system.event(0.0, state)?;
    let steps = |left: f64| (left / longest * ROUNDING).ceil();
    let (mut left, mut equal) = (duration, steps(duration));
    // An event is decided at the very time at which it was located, which `left` has but for rounding.
    let mut time = 0.0;
    let mut count = Count::default();
    while left > 0.0 {
        // A step that an event cuts in two is still one.
        if f64::from(count.steps - count.events) + equal > f64::from(MOST_STEPS) {
            return Err(Halt::TooMany);
        }
        count.steps += 1;
        let h = left / equal;
        let (end, part, tried) = piece(system, time, state, h)?;
        time += part * h;
        count.rejected += tried - 1;
        count.rates += 4 * tried;
        *P::states(state) = end;
        // The last of equal steps ends exactly.
        left = if part == 1.0 && h >= left { 0.0 } else { left - part * h };
        equal -= 1.0;
        // A step that was tried again ends at an event.
        if tried > 1 {
            count.events += 1;
            if count.events > MOST_EVENTS {
                return Err(Halt::TooMany);
            }
            system.event(time, state)?;
            equal = steps(left);
        }
    }
    Ok(count)
}

/// Whether an indicator has fallen below zero, or there is none.
pub fn crossed<const M: usize>(indicators: Option<[f64; M]>) -> bool {
    indicators.is_none_or(|z| z.iter().any(|z| z.is_nan() || *z < 0.0))
}

/// A step of `h` s from a time (s), or the part of it up to just beyond the first event; the states there, which part, and
/// how many steps were tried.
fn piece<const N: usize, S: Copy, P: Pieces<N, S>>(
    system: &P,
    time: f64,
    state: &S,
    h: f64,
) -> Result<([f64; N], f64, u32), Halt> {
    let start = *P::states(&mut { *state });
    let after = |part: f64| {
        let (y, fast) = runge_kutta::measured(&start, (part * h, system.is_forced()), |since, y| {
            system.rates(time + since, state, y)
        })?;
        let crossed = system.crossed(time + part * h, state, &y);
        Some((y, crossed, fast.0 <= FASTEST * FASTEST))
    };
    let whole = after(1.0);
    match whole {
        Some((y, false, true)) => return Ok((y, 1.0, 1)),
        Some((_, _, false)) => return Err(Halt::TooFast),
        _ => {}
    }
    let (mut before, mut beyond) = (0.0, 1.0);
    let mut tried = 1;
    let mut found = whole;
    for _ in 0..60 {
        let middle = f64::midpoint(before, beyond);
        if middle <= before || middle >= beyond {
            break;
        }
        tried += 1;
        match after(middle) {
            Some((_, false, _)) => before = middle,
            other => (beyond, found) = (middle, other),
        }
    }
    match found {
        Some((y, ..)) => Ok((y, beyond, tried)),
        // The end of assembly lies before any stop.
        None => Err(Halt::Outside),
    }
}

//! A second solver, that of the library `numeris`, in an importer's loop of
//! Model Exchange: the model gives rates, event indicators and what follows an
//! event, and nothing of its own solvers, steps and searches for events is used.
//!
//! Explicit levels run on Verner's method of ninth order, of another family than
//! their own of fourth; stiff ones on the library's RODAS with Jacobians by
//! finite differences, where ours are exact. The equations are the model's own:
//! what checks these is the oracles and the balance of energy in the tests.

use lemnis_models::component::model::Model;
use lemnis_models::kernel::variable::Fault;
use numeris::Vector;
use numeris::ode::{AdaptiveSettings, RKAdaptive, RKV98NoInterp, RODAS4, Rosenbrock};

use crate::setting::Method;

/// The states are looked at for events this often, in s.
const LOOK: f64 = 0.005;
/// Times nearer than this, in s, are the same.
const ROUNDING: f64 = 1e-12;
/// Halvings by which an event is located.
const HALVINGS: u32 = 60;
/// Most evaluations of the rates in one run for each state, by an explicit and by an implicit method: to begin with, and
/// for each look. A bar that friction neither holds nor lets go has an event after the other.
const RATES: [[f64; 2]; 2] = [[1e4, 30.0], [1e5, 200.0]];
/// Steps of the library in one piece.
const MOST_STEPS: usize = 1_000_000;

/// Relative tolerances of the library: below those of our references.
const EXPLICIT: f64 = 1e-12;
const IMPLICIT: f64 = 1e-10;

/// The library's solver over a run.
#[derive(Clone, Copy, Debug)]
pub struct Library {
    /// Evaluations of the rates that are left.
    left: u32,
}

impl Library {
    /// For a run of a model by a method over a duration in s.
    #[must_use]
    pub fn new(model: &Model, method: Method, duration: f64) -> Library {
        let [least, each] = RATES[usize::from(matches!(method, Method::Implicit(_)))];
        Library {
            left: ((1 + model.states()) as f64 * (least + each * duration / LOOK)) as u32,
        }
    }

    /// Moves a model on from one time to another, both in s.
    ///
    /// # Errors
    /// The model refuses its states, or the library its step; too much work.
    pub fn advance(&mut self, model: &mut Model, method: Method, from: f64, to: f64) -> Result<(), Fault> {
        model.set_time(from);
        model.event()?;
        let mut left = to - from;
        let (states, indicators) = (model.states(), model.indicators());
        let mut nominals = vec![1.0; states];
        model.nominals(&mut nominals);
        let mut start = vec![0.0; states];
        let (mut before, mut after) = (vec![0.0; indicators], vec![0.0; indicators]);
        while left > 0.0 {
            // The times of breaks and of samples of the PLC are known; a sample at the end belongs to the next call.
            let now = to - left;
            let mut due = model.next_event().map_or(f64::INFINITY, |at| at - now);
            if due <= ROUNDING {
                model.set_time(now + due);
                model.event()?;
                due = model.next_event().map_or(f64::INFINITY, |at| at - now);
            }
            let whole = left.min(LOOK).min(due.max(ROUNDING));
            model.set_time(now);
            model.get_states(&mut start);
            model.event_indicators(&mut before)?;
            let end = self.piece(model, method, (&start, now), &nominals, whole)?;
            model.set_time(now + whole);
            model.set_states(&end)?;
            model.event_indicators(&mut after)?;
            if !crossed(&before, &after) {
                left = if left - whole > ROUNDING { left - whole } else { 0.0 };
                continue;
            }
            let (mut low, mut high, mut beyond) = (0.0, whole, end);
            for _ in 0..HALVINGS {
                let middle = f64::midpoint(low, high);
                if middle <= low || middle >= high {
                    break;
                }
                model.set_states(&start)?;
                let end = self.piece(model, method, (&start, now), &nominals, middle)?;
                model.set_time(now + middle);
                model.set_states(&end)?;
                model.event_indicators(&mut after)?;
                if crossed(&before, &after) {
                    (high, beyond) = (middle, end);
                } else {
                    low = middle;
                }
            }
            model.set_time(now + high);
            model.set_states(&beyond)?;
            model.event()?;
            left -= high;
        }
        model.set_time(to);
        // A command has its new value from a break on, also where the step ends there.
        if model.next_break().is_some_and(|at| at <= to + ROUNDING) {
            model.event()?;
        }
        model.update()
    }

    /// A smooth piece of `h` s from states at a time (s), on states over their nominals.
    fn piece(
        &mut self,
        model: &mut Model,
        method: Method,
        start: (&[f64], f64),
        nominals: &[f64],
        h: f64,
    ) -> Result<Vec<f64>, Fault> {
        // The library's systems have a size that is known when it is compiled: the next greater one, filled with zeros.
        match start.0.len() {
            0..=2 => self.sized::<2>(model, method, start, nominals, h),
            3..=7 => self.sized::<7>(model, method, start, nominals, h),
            8 => self.sized::<8>(model, method, start, nominals, h),
            9..=12 => self.sized::<12>(model, method, start, nominals, h),
            13..=24 => self.sized::<24>(model, method, start, nominals, h),
            25..=64 => self.sized::<64>(model, method, start, nominals, h),
            more => Err(Fault::new(format!(
                "{more} states are more than the second solver takes"
            ))),
        }
    }

    fn sized<const N: usize>(
        &mut self,
        model: &mut Model,
        method: Method,
        (start, from): (&[f64], f64),
        nominals: &[f64],
        h: f64,
    ) -> Result<Vec<f64>, Fault> {
        let count = start.len();
        let scaled = Vector::<f64, N>::from_array(std::array::from_fn(|i| {
            if i < count { start[i] / nominals[i] } else { 0.0 }
        }));
        let (mut y, mut rates) = (vec![0.0; count], vec![0.0; count]);
        let mut refused = None;
        let mut f = |since: f64, at: &Vector<f64, N>| {
            model.set_time(from + since);
            for (i, y) in y.iter_mut().enumerate() {
                *y = at[i] * nominals[i];
            }
            if self.left == 0 {
                refused = Some(Fault::outside(
                    "more events, or faster changes, than the second solver has steps for",
                ));
                return Vector::from_array([f64::NAN; N]);
            }
            self.left -= 1;
            match model.set_states(&y).and_then(|()| model.rates(&mut rates)) {
                Ok(()) => Vector::from_array(std::array::from_fn(|i| {
                    if i < count { rates[i] / nominals[i] } else { 0.0 }
                })),
                Err(fault) => {
                    refused = Some(fault);
                    Vector::from_array([f64::NAN; N])
                }
            }
        };
        let settings = |tolerance: f64| AdaptiveSettings {
            abs_tol: tolerance,
            rel_tol: tolerance,
            max_steps: MOST_STEPS,
            min_step: 1e-13,
            ..AdaptiveSettings::default()
        };
        let solved = match method {
            Method::Implicit(_) => RODAS4::integrate_auto(0.0, h, &scaled, &mut f, &settings(IMPLICIT)),
            Method::Explicit(_) | Method::Closed | Method::Interpolated(_) => {
                RKV98NoInterp::integrate(0.0, h, &scaled, &mut f, &settings(EXPLICIT))
            }
        };
        match solved {
            Ok(solution) => Ok((0..count).map(|i| solution.y[i] * nominals[i]).collect()),
            Err(error) => Err(refused.unwrap_or_else(|| Fault::outside(format!("the second solver stops: {error}")))),
        }
    }
}

/// As the standard says it: an indicator that was above zero is not any more, or the other way round.
fn crossed(before: &[f64], after: &[f64]) -> bool {
    before.iter().zip(after).any(|(a, b)| (*a > 0.0) != (*b > 0.0))
}

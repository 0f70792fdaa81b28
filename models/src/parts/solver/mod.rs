//! Solvers for the levels of modelling: small systems on fixed arrays, without
//! allocation, bounded and counted.
//!
//! | file | method | for |
//! |---|---|---|
//! | `runge_kutta` | explicit, fourth order, fixed step | levels without stiffness |
//! | `rodas` | linearly implicit, fourth order, L-stable, continuous to third order | hydraulics |
//! | `pieces` | smooth pieces between located events | levels that stick, stop or go slack |
//! | `gradient` | a number with its derivatives by all states | the exact Jacobian |
//!
//! Inputs are constant over a communication step, so that no system depends on time itself.
//! `numeris` has the same Rodas without single steps and continuous output, `diffsol` can neither
//! be saved nor hold a step: both were measured, both are fine references.

pub mod gradient;
pub mod pieces;
pub mod rodas;
pub mod runge_kutta;

pub use gradient::Gradient;

/// Rates of change of N states. In every system a state's unit is its own.
pub trait System<const N: usize> {
    /// `None` where the states do not exist, such as a linkage that does not close.
    fn rates(&self, y: &[f64; N]) -> Option<[f64; N]>;

    /// Rates and their derivatives: `jacobian[i][j]` is that of rate i by state j.
    fn jacobian(&self, y: &[f64; N]) -> Option<([f64; N], [[f64; N]; N])>;

    /// Where the rates have a kink these change their sign: a step ends there, as nearly as the tolerance
    /// tells one of them, which are of order one, from zero.
    #[inline]
    fn kinks(&self, _: &[f64; N]) -> [f64; MOST_KINKS] {
        [1.0; MOST_KINKS]
    }

    /// Whether states lie beyond the end of the smooth piece: a step ends just there.
    #[inline]
    fn ended(&self, _: &[f64; N]) -> bool {
        false
    }

    /// What must not fall too low, such as a pressure: a run keeps the least with which a step has ended.
    #[inline]
    fn least(&self, _: &[f64; N]) -> f64 {
        f64::INFINITY
    }

    /// Puts the states at the end of a step where their constraints want them, against the solver's error.
    #[inline]
    fn settle(&self, _: &mut [f64; N]) {}
}

/// Most kinks that a system has.
pub const MOST_KINKS: usize = 14;

/// Why a solver stops: the states stay those of the last step that succeeded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Halt {
    /// The states do not exist beyond this time: the linkage does not close, or a number overflows.
    Outside,
    /// The tolerance asks for steps below the resolution of the time.
    TooSmall,
    /// More steps than one call may take.
    TooMany,
    /// Steps too long for how fast the motion changes: their results would be bounded, and mean nothing.
    TooFast,
}

/// Work done, to be asserted where a clock would be noisy.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Count {
    pub steps: u32,
    pub rejected: u32,
    /// Steps cut at a kink.
    pub kinks: u32,
    /// Events that were located on the way, where it was decided what follows.
    pub events: u32,
    /// Evaluations of the rates.
    pub rates: u32,
    /// Evaluations of the Jacobian, each with one factorisation or more.
    pub jacobians: u32,
}

impl Count {
    /// What was done after an earlier count.
    #[must_use]
    pub fn since(self, earlier: Count) -> Count {
        Count {
            steps: self.steps - earlier.steps,
            rejected: self.rejected - earlier.rejected,
            kinks: self.kinks - earlier.kinks,
            events: self.events - earlier.events,
            rates: self.rates - earlier.rates,
            jacobians: self.jacobians - earlier.jacobians,
        }
    }

    #[must_use]
    pub fn and(self, more: Count) -> Count {
        Count {
            steps: self.steps + more.steps,
            rejected: self.rejected + more.rejected,
            kinks: self.kinks + more.kinks,
            events: self.events + more.events,
            rates: self.rates + more.rates,
            jacobians: self.jacobians + more.jacobians,
        }
    }
}

/// Steps that one call of an explicit solver may take.
pub const MOST_STEPS: u32 = 1_000_000;
/// Steps that one call of the implicit solver may take, tried ones included: each costs as much as some ten explicit ones, and
/// a motion that creeps towards where it does not exist would take them all.
pub const MOST_IMPLICIT: u32 = 200_000;

/// Whether every number is finite.
#[must_use]
pub fn finite<const N: usize>(y: &[f64; N]) -> bool {
    y.iter().all(|x| x.is_finite())
}

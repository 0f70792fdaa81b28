//! Energy of a crane that moves, what blows take of it, and what its hoist gives.

use crate::luffing::moving::crane::{Commands, CraneState, Hangs, MovingCrane, Struck};
use crate::parts::hoist::HoistPowers;

/// Part of an energy that rounding may be.
const ROUNDING: f64 = 1e-14;

impl<const N: usize, const J: usize> MovingCrane<N, J>
where
    Self: Struck<N, J>,
{
    /// What the hoist gives and takes; `None` where the linkage does not close.
    pub(crate) fn hoist_powers(&self, state: &CraneState<N, J>, commands: &Commands<J>) -> Option<HoistPowers> {
        let Some(hoist) = self.hoist() else {
            return Some(HoistPowers::default());
        };
        let rope = self.rope_force(state, commands, &state.y)?;
        let (y, [distance, speed]) = (&state.y, Self::reach(&state.y));
        let r = self.reduced(state, y[0])?;
        let rate = y[Self::OWN - 1];
        let stretch = [distance - y[Self::LENGTH], speed - r.paid(rate, y[1])];
        Some(hoist.powers(state.drum, &commands.hoist, rate, stretch, rope))
    }

    /// Kinetic and potential energy, in J; `None` where the linkage does not close.
    #[must_use]
    pub fn energy(&self, state: &CraneState<N, J>) -> Option<f64> {
        let (r, y) = (self.reduced(state, state.y[0])?, &state.y);
        let inertias = [r.inertia, r.turn[0]];
        let moving: f64 = (0..J).map(|i| inertias[i] * y[2 * i + 1] * y[2 * i + 1]).sum();
        let leaned = Self::slewed(y).map_or(0.0, |psi| self.dynamics.leaned_energy(&r, psi));
        let bars = 0.5 * moving + r.energy + leaned + self.drum_energy(state, &r);
        let Some(pendulum) = self.dynamics.pendulum() else {
            return Some(bars);
        };
        let [potential, speed] = self.height_and_speed(state, &r);
        let load = pendulum.mass * (0.5 * speed + potential);
        let stretch = Self::reach(y)[0] - y[Self::LENGTH];
        Some(bars + load + pendulum.hoist.energy(y[Self::OWN - 1], stretch))
    }

    /// What a blow takes (J), from the energy before and after it: nothing where that is rounding.
    pub(super) fn lost(&self, before: &CraneState<N, J>, after: &CraneState<N, J>) -> f64 {
        let Some((before, after)) = self.energy(before).zip(self.energy(after)) else {
            return 0.0;
        };
        let lost = before - after;
        if lost.abs() > ROUNDING * (before.abs() + after.abs()) {
            lost
        } else {
            0.0
        }
    }
}

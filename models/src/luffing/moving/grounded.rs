//! A load on the ground: what the ground bears, and when the load is put down and lifted.

use crate::kernel::calc::Calc;
use crate::luffing::moving::crane::{Commands, CraneState, Hangs, MovingCrane, Snapshot, Struck};
use crate::luffing::moving::dynamics::Coordinate;
use crate::luffing::moving::reduced::Reduced;
use crate::parts::ground::Raised;

impl<const N: usize, const J: usize, P: Calc> MovingCrane<N, J, P>
where
    Self: Hangs<N, J, P>,
{
    /// Force of the ground (N) on a load that stands on it.
    fn borne<C: Coordinate<P>>(&self, raised: &Raised<C>, at: &Snapshot<N, J, C>) -> C {
        let mass = self
            .dynamics
            .pendulum()
            .map_or(C::constant(0.0), |load| C::of(load.mass));
        raised.bears(mass * self.dynamics.upright(), self.tension(at))
    }

    /// Force of the ground on the load, in N, and its height above it, in m.
    pub(crate) fn on_ground<C: Coordinate<P>>(&self, at: &Snapshot<N, J, C>) -> [C; 2] {
        let still = C::constant(0.0);
        match self.dynamics.ground() {
            None => [still; 2],
            Some(ground) if at.state.grounded => [self.borne(&self.raised(ground, at), at), still],
            Some(ground) => [still, self.raised(ground, at).height],
        }
    }

    /// Falls below zero where the load touches ground at a height (m), or is lifted from it.
    pub(super) fn grounding<C: Coordinate<P>>(&self, ground: P, at: &Snapshot<N, J, C>) -> C {
        let raised = self.raised(ground, at);
        match at.state.grounded {
            true => self.borne(&raised, at),
            false => raised.touching(),
        }
    }
}

impl<const N: usize, const J: usize> MovingCrane<N, J>
where
    Self: Struck<N, J>,
{
    /// A load that touches the ground is at rest at once, and stands there unless its rope lifts it.
    pub(super) fn land(&self, state: &mut CraneState<N, J>, r: &Reduced<f64>, commands: &Commands<J>) {
        let Some(ground) = self.dynamics.ground() else { return };
        if !state.grounded && self.raised(ground, &state.at(r, commands)).touching() < 0.0 {
            self.put_down(state, r, ground);
            state.grounded = true;
            // An empty hook hangs on a rope that keeps its length.
            state.taut = state.taut && !self.is_kept(state);
        }
        if state.grounded && self.is_lifted(ground, &state.at(r, commands)) {
            self.put_down(state, r, ground);
            state.grounded = false;
        }
    }

    /// Whether the rope takes all of a load that stands on ground at a height (m): an empty hook's as soon as it is taut.
    fn is_lifted(&self, ground: f64, at: &Snapshot<N, J, f64>) -> bool {
        self.is_kept(at.state) || self.borne(&self.raised(ground, at), at) < 0.0
    }
}

//! What is decided of the rope of a drive that may go slack: that it lets go, and how it is caught.

use crate::luffing::moving::crane::{Commands, CraneState, FEW, Hangs, MovingCrane, Struck};
use crate::luffing::moving::reduced::{MotorShaft, Reduced};
use crate::parts::joint::Bar;
use crate::parts::solver::Halt;

impl<const N: usize, const J: usize> MovingCrane<N, J>
where
    Self: Struck<N, J>,
{
    /// The drum of a slack rope that has turned round is at rest; one that was set in motion moves.
    pub(super) fn turn_drum(state: &mut CraneState<N, J>) {
        if let Some(way) = state.unwound {
            let (way, speed) = way.turned(state.y[Self::OWN + 1]);
            (state.unwound, state.y[Self::OWN + 1]) = (Some(way), speed);
        }
    }

    /// The rope lets go: the drum goes on as fast as the link moved.
    pub(super) fn let_go(state: &mut CraneState<N, J>, shaft: &MotorShaft<f64>) {
        let (way, speed) = Bar::Held.turned(shaft.travel() * state.y[1]);
        state.unwound = Some(way);
        state.y[Self::OWN..].copy_from_slice(&[0.0, speed]);
        state.settle_luffing();
    }

    /// A rope that would have to push lets go, and a slack one is caught where nothing of it is left.
    ///
    /// # Errors
    /// The linkage does not close.
    pub(super) fn haul(&self, state: &mut CraneState<N, J>, commands: &Commands<J>) -> Result<(), Halt> {
        let r = &self.reduced(state, state.y[0]).ok_or(Halt::Outside)?;
        let Some(shaft) = r.shaft else { return Ok(()) };
        if state.unwound.is_none() {
            if self.hauling(&state.at(r, commands), &shaft) < 0.0 {
                Self::let_go(state, &shaft);
            }
            return Ok(());
        }
        let (travel, slack, speed) = (shaft.travel(), state.y[Self::OWN], state.y[Self::OWN + 1]);
        let grows = travel * state.y[1];
        let closing = grows - speed;
        if slack <= 0.0 && closing > FEW * (grows.abs() + speed.abs()) {
            // Friction and brakes hold nothing against a blow, and an end stop one way alone.
            let ([low, high], raises) = (self.joints[0].stops, travel < 0.0);
            let stopped = if raises { state.y[0] >= high } else { state.y[0] <= low };
            if !stopped {
                state.joints[0] = if raises { Bar::Forward } else { Bar::Backward };
                let light = 1.0 / shaft.mass();
                let give = |ease: f64| -travel * ease * closing / (travel * travel * ease + light);
                self.hauled(state, r, give, -shaft.sense());
                state.joints[0] = state.joints[0].struck(state.y[1]);
            }
            state.unwound = None;
            state.y[Self::OWN..].fill(0.0);
            state.settle_luffing();
        }
        Ok(())
    }

    /// The drum of a slack rope at rest breaks loose where its brakes do not hold the motor.
    pub(super) fn loosen_drum(&self, state: &mut CraneState<N, J>, r: &Reduced<f64>, commands: &Commands<J>) {
        if let (Some(Bar::Held), Some(shaft)) = (state.unwound, &r.shaft) {
            state.unwound = Some(Bar::loosened(Self::drum_held(commands, shaft)));
        }
    }

    /// Energy of a drum that turns by itself, in J.
    pub(super) fn drum_energy(&self, state: &CraneState<N, J>, r: &Reduced<f64>) -> f64 {
        match r.shaft.filter(|shaft| shaft.loose) {
            Some(shaft) => 0.5 * shaft.mass() * state.y[Self::OWN + 1].powi(2),
            None => 0.0,
        }
    }
}

impl<const N: usize, const J: usize> CraneState<N, J> {
    /// Where luffing rests it is decided again which way it goes.
    fn settle_luffing(&mut self) {
        if self.y[1] == 0.0 {
            self.joints[0] = Bar::Held;
        }
    }
}

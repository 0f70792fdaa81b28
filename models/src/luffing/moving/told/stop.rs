//! How the brakes on the motor's shaft stop luffing in a run, beside the closed form from its state when they are called.

use crate::component::moving::MovingComponent;
use crate::component::running::Running;
use crate::kernel::symbol::Symbol;
use crate::luffing::moving::carried;
use crate::luffing::moving::dynamics::Coordinate;
use crate::luffing::moving::level::MotionResult;
use crate::luffing::moving::luffs::Luffs;
use crate::luffing::moving::symbols as m;
use crate::parts::braking::LastBrake;
use crate::parts::joint::{Bar, JointDrive};

/// A stop that has begun.
#[derive(Clone, Copy)]
pub(super) struct Stop {
    /// Time of the call (s), and angle of the driven bar then (rad).
    called: [f64; 2],
    /// Time (s) and angle (rad) of the stop in closed form.
    expected: [f64; 2],
    /// Time since the call (s), angle (rad), rate (rad/s) and its change (rad/s²) when it was last seen moving.
    seen: [f64; 4],
    rests: bool,
}

impl Stop {
    /// Called at a time (s); `None` where nothing moves, or no brake is on a shaft that turns.
    pub(super) fn called<T: Luffs>(model: &mut MovingComponent, time: f64) -> Option<Stop> {
        let known = carried::known::<T>(model.parts().0);
        let given = T::luffing(T::given(known));
        let (level, at) = T::in_motion(known).ok()?;
        let [theta, omega] = [at.y[0], at.y[1]];
        let r = f64::reduced(level.dynamics(), theta)?;
        // Brakes on the drum of a slack rope stop nothing else.
        let taut = at.past.unwound.is_none();
        let (ratio, friction) = (r.shaft.filter(|_| taut)?.ratio.abs(), given.sources.constants?);
        let mut still = at;
        still.y[1] = 0.0;
        (still.inputs.drives[0], still.inputs.shaft) = (JointDrive::NONE, 0.0);
        still.past.joints[0] = Bar::Held;
        let holds = level.reaction(&still, MotionResult::Friction)?;
        let against = omega.signum() * holds + friction.m_f + friction.c_v * omega.abs();
        let brakes = given.brake.map(|brake| [brake.torque, brake.delay]).into_iter();
        let brakes = brakes.chain(given.second.map(|brake| [brake.torque, brake.delay]));
        let inertia = r.inertia / ratio.powi(2);
        let last = LastBrake::new(inertia, against / ratio, ratio * omega.abs(), brakes);
        let slows = last.torque / inertia;
        let turned = last.turned + 0.5 * last.speed.powi(2) / slows;
        (omega != 0.0 && slows > 0.0).then_some(Stop {
            called: [time, theta],
            expected: [last.time + last.speed / slows, omega.signum() * turned / ratio],
            seen: [0.0, theta, omega, 0.0],
            rests: false,
        })
    }

    /// Looks at the model at a time (s), by its rates.
    pub(super) fn look<T: Luffs>(&mut self, model: &mut MovingComponent, time: f64) {
        let at = carried::at::<T>(model.parts().0);
        self.rests |= at.y[1] == 0.0;
        let mut rates = vec![0.0; model.states()];
        if !self.rests && model.rates(&mut rates).is_ok() {
            self.seen = [time - self.called[0], at.y[0], at.y[1], rates[1]];
        }
    }

    /// What it came to, beside the closed form: time until rest and angle; none of one that did not come to rest.
    pub(super) fn told(&self) -> Vec<(&'static Symbol, [f64; 2])> {
        let [since, theta, omega, slowing] = self.seen;
        let left = -omega / slowing;
        if !self.rests || !left.is_finite() || left < 0.0 {
            return Vec::new();
        }
        let turned = theta + 0.5 * omega * left - self.called[1];
        vec![
            (&m::T_BS, [since + left, self.expected[0]]),
            (&m::DELTA_BS, [turned, self.expected[1]]),
        ]
    }
}

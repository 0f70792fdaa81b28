//! A crane whose luffing is driven by a rope: it pulls, and never pushes, and may go slack.
//!
//! Motor and brake stand at the rope's drum, which has no inertia of its own. While the bar rises, a brake that is stronger
//! than the motor holds the drum: the bar goes on alone, until it comes back to where the rope is taut again, and the brake
//! catches it. A motor that is stronger reels in what hangs loose at once.

use crate::kernel::calc::{Calc, Over};
use crate::luffing::moving::crane::{Commands, CraneState, Hangs, MovingCrane, Snapshot};
use crate::luffing::moving::dynamics::Coordinate;
use crate::luffing::moving::reduced::MotorShaft;
use crate::luffing::moving::shares::Shares;
use crate::parts::joint::{Bar, JointDrive};

impl<const N: usize, const J: usize, P: Calc> MovingCrane<N, J, P>
where
    Self: Hangs<N, J, P>,
{
    /// What drives joint `i`: motor and brake, of a rope no more than it can pull.
    pub(crate) fn drive<C: Coordinate<P>>(&self, i: usize, at: &Snapshot<N, J, C>) -> JointDrive<C> {
        let [rising, falling] = self.drives(i, at.state, at.commands, at.r.geared());
        match at.state.joints[i] {
            Bar::Forward => rising,
            _ => falling,
        }
    }

    /// The same against one direction and against the other; brakes on the shaft of a motor act by its ratio.
    pub(crate) fn drives<C: Calc>(
        &self,
        i: usize,
        state: &CraneState<N, J>,
        commands: &Commands<J, C>,
        shaft: Option<&MotorShaft<C>>,
    ) -> [JointDrive<C>; 2] {
        if i > 0 {
            return [commands.drives[i]; 2];
        }
        let drive = Self::motor(commands, shaft);
        if state.unwound.is_some() {
            [nothing(); 2]
        } else if self.dynamics.is_pulled() {
            pulling(drive, state.slack.is_some())
        } else {
            [drive; 2]
        }
    }

    /// What a rope without a drum of its own pulls beyond the moment that was asked for (N·m), where it is not that: the brake
    /// has it.
    pub(crate) fn kept_back<C: Calc>(&self, drive: &JointDrive<C>, asked: &JointDrive<C>) -> Option<C> {
        let apart = self.dynamics.is_pulled() && drive.moment.value() != asked.moment.value();
        apart.then(|| drive.moment - asked.moment)
    }

    /// What turns the driven bar, told apart, of friction, brake and end stop `together` (N·m).
    pub(crate) fn shares<C: Over<P>>(
        &self,
        state: &CraneState<N, J>,
        commands: &Commands<J, C>,
        y: &[C; N],
        (together, shaft): (C, Option<&MotorShaft<C>>),
    ) -> Shares<C> {
        let [rising, falling] = self.drives(0, state, commands, shaft);
        let more = self.kept_back(&falling, &commands.drives[0]);
        let resistance = more.map_or(together, |more| together - more);
        let brake = match state.joints[0] {
            Bar::Forward => rising.brake,
            Bar::Held if resistance.value() < 0.0 => rising.brake,
            _ => falling.brake,
        };
        let friction = &self.joints[0].friction;
        let shares = Shares::new(state.joints[0], resistance, y[1], friction, [falling.moment, brake]);
        match shaft {
            Some(shaft) if Self::HAULED && state.joints[0] == Bar::Held => shares.pulled(shaft.ratio.value()),
            _ => shares,
        }
    }
}

impl<const N: usize, const J: usize> CraneState<N, J> {
    /// The rope goes slack where the bar rises and the brake holds the drum. It is taut again where the bar has come back, or
    /// the motor reels it in.
    pub(crate) fn tighten(&mut self, drive: &JointDrive) {
        let (rises, reels) = (self.joints[0] == Bar::Forward, drive.moment > drive.brake);
        match self.slack {
            Some(caught) if reels || (!rises && self.y[0] <= caught) => {
                self.slack = None;
                if self.y[1] == 0.0 {
                    // It is decided again which way it goes.
                    self.joints[0] = Bar::Held;
                }
            }
            None if rises && !reels => self.slack = Some(self.y[0]),
            _ => {}
        }
    }
}

/// Neither drive nor brake.
pub(super) fn nothing<C: Calc>() -> JointDrive<C> {
    let nothing = C::constant(0.0);
    JointDrive {
        moment: nothing,
        brake: nothing,
    }
}

/// Motor and brake of a rope that pulls, against rising and against falling: they give it no force below zero, and none where
/// it is slack.
fn pulling<C: Calc>(drive: JointDrive<C>, slack: bool) -> [JointDrive<C>; 2] {
    if slack {
        return [nothing(); 2];
    }
    let zero = C::constant(0.0);
    // What asks for nothing has its derivatives all the same.
    let positive = |x: C| if x.value() >= 0.0 { x } else { zero };
    let moment = positive(drive.moment);
    let rising = if drive.brake.value() < moment.value() {
        drive.brake
    } else {
        moment
    };
    // A motor that pays out works against its brake.
    let falling = if drive.moment.value() < 0.0 {
        positive(drive.moment + drive.brake)
    } else {
        drive.brake
    };
    [rising, falling].map(|brake| JointDrive { moment, brake })
}

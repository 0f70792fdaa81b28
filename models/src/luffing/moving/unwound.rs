//! A crane whose drive has a rope between the driving link and the motor's shaft, which may go slack.
//!
//! ```text
//! taut:   L = r ψ       S = −M_D / L′ ≥ 0      M_D = M_A ∓ M_b − I_M α − ½ I_M′ ω²
//! slack:  δ′ = v − L′ ω       m v′ = (M_A ∓ M_b) / L′       m = J_M / r²       M_b = M_S + |ψ′| T
//! caught: (v − L′ ω)⁺ = 0     p = (L′ ω − v)⁻ / (L′² e + 1/m)       Δω = −L′ p e       Δv = p / m
//! ```
//!
//! All is told between the anchors of the tackle: δ is how much longer its rope would let it be, v how fast the drum lets it grow.
//! While it is slack the link moves without the shaft, and the drum turns by motor and brakes alone. The rope that is taut again
//! is a plastic blow along itself: e is what the link's speed changes by, for an impulse, with the load on its rope and slewing.

use crate::kernel::calc::Calc;
use crate::luffing::moving::crane::{Commands, CraneState, DRUM, HAULING_ENDS, Hangs, MovingCrane, Snapshot};
use crate::luffing::moving::dynamics::Coordinate;
use crate::luffing::moving::pulled::nothing;
use crate::luffing::moving::reduced::{MotorShaft, Reduced};
use crate::luffing::moving::symbols as s;
use crate::parts::joint::{Bar, JointDrive, LOOSE, capped};

impl<C: Calc> MotorShaft<C> {
    /// What the drive's line gains for one radian of the driving link, in m.
    pub(super) fn travel(&self) -> C {
        self.ratio * self.arm
    }

    /// Mass of drum and shaft, as the tackle feels it, in kg: J_M / r². [Lagrange]
    pub(super) fn mass(&self) -> C {
        (self.own / self.arm.square()).def(&s::MASS_TL)
    }

    /// Which way it turns by itself for a moment on the driving link: paying out is forward.
    pub(super) fn sense(&self) -> C {
        C::constant(1.0_f64.copysign(self.ratio.value()))
    }
}

impl<const N: usize, const J: usize, P: Calc> MovingCrane<N, J, P>
where
    Self: Hangs<N, J, P>,
{
    /// Whether the rope of its drive may go slack.
    pub(super) const HAULED: bool = N > Self::OWN;

    /// What the mechanism is at its angle (rad), without the motor's shaft where the rope between is slack; `None` where it does
    /// not close.
    #[inline]
    pub(crate) fn reduced<C: Coordinate<P>>(&self, state: &CraneState<N, J>, theta: C) -> Option<Reduced<C>> {
        let r = C::reduced(&self.dynamics, theta);
        match state.unwound {
            None => r,
            Some(_) => r.map(Reduced::freed),
        }
    }

    /// What motor and brakes give at the driving link, or would if the rope were taut (N·m).
    pub(super) fn motor<C: Calc>(commands: &Commands<J, C>, shaft: Option<&MotorShaft<C>>) -> JointDrive<C> {
        let mut drive = commands.drives[0];
        if let Some(shaft) = shaft {
            drive.brake += shaft.braked(commands.shaft);
        }
        drive
    }

    /// Rates of slack (m/s) and of the drum's speed (m/s²) while the rope is slack.
    pub(super) fn unwinding<C: Coordinate<P>>(&self, at: &Snapshot<N, J, C>) -> Option<[C; DRUM]> {
        let (shaft, way) = at.r.shaft.as_ref().zip(at.state.unwound)?;
        let (drive, travel, speed) = (
            Self::motor(at.commands, Some(shaft)),
            shaft.travel(),
            at.y[Self::OWN + 1],
        );
        let brake = drive.brake * shaft.sense();
        let acting = match way {
            Bar::Forward => drive.moment - brake,
            Bar::Backward => drive.moment + brake,
            Bar::Held | Bar::Loose => C::constant(0.0),
        };
        let slackens = (speed - travel * at.y[1]).def(&s::D_DELTA_L);
        Some([slackens, (acting / (travel * shaft.mass())).def(&s::D_V_TL)])
    }

    /// Power of the motor, on the drum of a slack rope in place of the driving link, and what brakes take there (W).
    pub(crate) fn drum_powers<C: Coordinate<P>>(&self, at: &Snapshot<N, J, C>) -> [C; 2] {
        let drive = Self::motor(at.commands, at.r.shaft.as_ref());
        match at.r.shaft.as_ref().filter(|shaft| shaft.loose) {
            None => [(drive.moment * at.y[1]).def(&s::P_ML), C::constant(0.0)],
            Some(shaft) => {
                let turns = at.y[Self::OWN + 1] / shaft.travel();
                let given = (drive.moment * turns).def(&s::P_ML);
                [given, (drive.brake * turns.abs()).def(&s::P_BL)]
            }
        }
    }

    /// Moment that the brakes must give to hold the drum of a slack rope, with the least and greatest that they can, as at the
    /// driving link and in the direction of paying out (N·m).
    pub(super) fn drum_held<C: Calc>(commands: &Commands<J, C>, shaft: &MotorShaft<C>) -> [C; 3] {
        let drive = Self::motor(commands, Some(shaft));
        let most = drive.brake * C::constant(LOOSE);
        [-(drive.moment * shaft.sense()), -most, most]
    }

    /// Pull of the rope between the anchors (N) by what motor, brakes and inertia of the shaft leave of the moment on the driving
    /// link; at rest how far it is from letting go, as the motor would pay out against its brakes, or the link rise by itself.
    pub(super) fn hauling<C: Coordinate<P>>(&self, at: &Snapshot<N, J, C>, shaft: &MotorShaft<C>) -> C {
        let (drive, sense) = (Self::motor(at.commands, Some(shaft)), shaft.sense());
        let moment = match at.state.joints[0] {
            Bar::Held | Bar::Loose => {
                let [hold, least, _] = Self::drum_held(at.commands, shaft);
                let by_drum = hold - least;
                let by_link = capped(self.held_alone(at, sense));
                if by_link.value() < by_drum.value() {
                    by_link
                } else {
                    by_drum
                }
            }
            bar => {
                let brake = if bar == Bar::Forward { -drive.brake } else { drive.brake };
                let alpha = self.rates_by(&self.accelerations(at), at)[1];
                -(drive.moment + brake + shaft.lags(at.y[1], alpha).0) * sense
            }
        };
        moment / shaft.travel().abs()
    }

    /// How far a link at rest is from rising without its rope, which pulls against the sense of its shaft (N·m).
    fn held_alone<C: Coordinate<P>>(&self, at: &Snapshot<N, J, C>, sense: C) -> C {
        let alone = CraneState {
            unwound: Some(Bar::Held),
            ..*at.state
        };
        let hold = self.needs(0, &Snapshot { state: &alone, ..*at });
        let [least, most] = self.joints[0].over().holds(at.y[0], &nothing());
        if sense.value() > 0.0 { most - hold } else { hold - least }
    }

    /// Numbers whose fall below zero ends a smooth piece. A slack rope is caught where it is shorter than the way between by more
    /// than rounding.
    pub(super) fn hauling_ends<C: Coordinate<P>>(&self, at: &Snapshot<N, J, C>) -> Option<[C; HAULING_ENDS]> {
        let (shaft, none) = (at.r.shaft.as_ref()?, C::constant(1.0));
        let Some(way) = at.state.unwound else {
            return Some([self.hauling(at, shaft), none, none]);
        };
        let room = at.y[Self::OWN] + shaft.travel().abs() * C::constant(LOOSE - 1.0);
        let speed = at.y[Self::OWN + 1];
        Some(match way {
            Bar::Forward => [room, speed, none],
            Bar::Backward => [room, -speed, none],
            Bar::Held | Bar::Loose => {
                let [hold, least, most] = Self::drum_held(at.commands, shaft);
                [room, most - hold, hold - least]
            }
        })
    }
}

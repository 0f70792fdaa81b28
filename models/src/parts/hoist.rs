//! A hoist: what reels the load's rope in and out, and how the rope gives way.
//!
//! Everything is told at the head: the rope there is paid out at a rate, whatever drum and falls are behind it.

use crate::kernel::calc::{Calc, Over};
use crate::parts::joint::{Bar, JointDrive, LOOSE, capped};

/// What the load hangs on.
#[derive(Clone, Copy, Debug)]
pub struct Hoist<P = f64> {
    pub winch: Winch<P>,
    /// `None` keeps its length under any force.
    pub rope: Option<Elastic<P>>,
}

impl Hoist {
    /// A rope that keeps its length, on a hoist that follows its command at once.
    pub const AT_ONCE: Hoist = Hoist {
        winch: Winch::AtOnce,
        rope: None,
    };
}

/// How a hoist follows what is asked of it.
#[derive(Clone, Copy, Debug)]
pub enum Winch<P = f64> {
    /// Its speed is the command's.
    AtOnce,
    /// It comes up to the commanded speed with an acceleration, in m/s².
    Ramp(P),
    /// A drum under the moment of a motor, with a brake.
    Motor(WinchDrive<P>),
}

/// A drum with all that turns with it, as the rope at the head feels it.
#[derive(Clone, Copy, Debug)]
pub struct WinchDrive<P = f64> {
    /// Reduced to the rope at the head, in kg: inertia times the square of the ratio.
    pub mass: P,
    /// Force at the head for a moment on the drum, in 1/m: falls over the drum's radius.
    pub ratio: P,
    /// Moment of dry friction on the drum, in N·m.
    pub coulomb: P,
}

/// A rope that gives way; it pulls, and never pushes.
#[derive(Clone, Copy, Debug)]
pub struct Elastic<P = f64> {
    /// In N/m.
    pub stiffness: P,
    /// In N·s/m.
    pub damping: P,
}

impl<P: Calc> Elastic<P> {
    /// Forces by stiffness and by damping (N) of a rope stretched by a length (m) at a rate (m/s).
    pub(crate) fn forces<C: Over<P>>(&self, stretch: C, rate: C) -> [C; 2] {
        [C::of(self.stiffness) * stretch, C::of(self.damping) * rate]
    }

    /// Falls below zero where the rope lets go, or begins to pull.
    pub(crate) fn slackening<C: Over<P>>(taut: bool, [spring, force]: [C; 2]) -> C {
        match taut {
            true => force,
            false if force.value() < spring.value() => -force,
            false => -spring,
        }
    }

    /// Whether it pulls, where it did so or not.
    pub(crate) fn pulls(taut: bool, [spring, force]: [f64; 2]) -> bool {
        force >= 0.0 && (taut || spring >= 0.0)
    }
}

/// What is asked of a hoist.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HoistCommand<P = f64> {
    /// How fast it is to pay out the rope at the head, in m/s.
    pub speed: P,
    /// Of its motor and brake, on the drum; a positive moment reels in.
    pub drive: JointDrive<P>,
}

impl HoistCommand {
    /// Of a hoist whose speed is commanded, in m/s.
    #[must_use]
    pub const fn speed(speed: f64) -> HoistCommand {
        HoistCommand {
            speed,
            drive: JointDrive::NONE,
        }
    }

    pub(crate) fn is_sound(&self) -> bool {
        self.speed.is_finite() && self.drive.is_sound()
    }
}

/// How a rope acts on the load at one instant.
#[derive(Clone, Copy, Debug)]
pub enum RopeAction<C> {
    Slack,
    /// Keeps it at its end, which is paid out at a rate (m/s).
    Taut {
        rate: C,
        /// How that changes, in m/s², where it does so by itself.
        gain: Option<C>,
        /// Mass (kg) and pull (N) of a drum that turns.
        drum: Option<[C; 2]>,
    },
    /// Pulls it with a force, in N.
    Force(C),
}

/// The drum of the hoist.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drum {
    /// Whether it runs as commanded, pays out ever faster, or reels in ever faster. With a motor: whether it is held,
    /// pays out, or reels in.
    pub way: Bar,
    /// What it was commanded when that was decided, in m/s.
    pub command: f64,
}

/// Least jump of the hoist's speed that is a blow, in m/s: a load follows less without anyone's notice.
const FELT: f64 = 1e-12;

impl Drum {
    /// As commanded (m/s).
    #[must_use]
    pub fn at(command: f64) -> Drum {
        Drum {
            way: Bar::Held,
            command,
        }
    }

    /// How the rate at which it pays out changes by itself, in m/s²; `None` where it does not.
    pub(crate) fn ramp<P: Calc, C: Over<P>>(self, hoist: &Hoist<P>) -> Option<C> {
        let Winch::Ramp(gain) = hoist.winch else { return None };
        match self.way {
            Bar::Forward => Some(C::of(gain)),
            Bar::Backward => Some(-C::of(gain)),
            Bar::Held | Bar::Loose => None,
        }
    }

    /// Mass (kg) of a drum that turns, and the pull (N) of its motor, brake and friction on the rope.
    pub(crate) fn turning<P: Calc, C: Over<P>>(self, hoist: &Hoist<P>, command: &HoistCommand<C>) -> Option<[C; 2]> {
        let Winch::Motor(drive) = &hoist.winch else { return None };
        let resistance = self.resistance(drive, command)?;
        let pull = C::of(drive.ratio) * (command.drive.moment + resistance);
        Some([C::of(drive.mass), pull])
    }

    /// Moment of brake and friction on a drum that turns, in N·m.
    fn resistance<P: Calc, C: Over<P>>(self, drive: &WinchDrive<P>, command: &HoistCommand<C>) -> Option<C> {
        let dry = C::of(drive.coulomb) + command.drive.brake;
        match self.way {
            Bar::Forward => Some(dry),
            Bar::Backward => Some(-dry),
            Bar::Held | Bar::Loose => None,
        }
    }

    /// How the rate at which it pays out changes under a force of the rope (N), in m/s²; `None` where it does not.
    pub(crate) fn gain<P: Calc, C: Over<P>>(
        self,
        hoist: &Hoist<P>,
        command: &HoistCommand<C>,
        rope: impl FnOnce() -> C,
    ) -> Option<C> {
        match self.turning(hoist, command) {
            Some([mass, pull]) => Some((rope() - pull) / mass),
            None => self.ramp(hoist),
        }
    }

    /// Moment that brake and friction must give to a drum at rest under a force of the rope (N), with the least and
    /// greatest that they can, in N·m; positive reels in.
    fn held<P: Calc, C: Over<P>>(drive: &WinchDrive<P>, command: &HoistCommand<C>, rope: C) -> [C; 3] {
        let dry = (C::of(drive.coulomb) + command.drive.brake) * C::constant(LOOSE);
        [rope / C::of(drive.ratio) - command.drive.moment, -dry, dry]
    }

    /// Moment of brake and friction on the drum of a motor under a force of the rope (N), in N·m; positive reels in.
    pub(crate) fn friction<P: Calc, C: Over<P>>(self, hoist: &Hoist<P>, command: &HoistCommand<C>, rope: C) -> C {
        match &hoist.winch {
            Winch::Motor(drive) => {
                let moving = self.resistance(drive, command);
                moving.unwrap_or_else(|| Self::held(drive, command, rope)[0])
            }
            Winch::AtOnce | Winch::Ramp(_) => C::constant(0.0),
        }
    }

    /// Fall below zero where it has come up to its command at a rate (m/s); with a motor, where it comes to rest or
    /// (two) breaks loose.
    pub(crate) fn reaching<P: Calc, C: Over<P>>(
        self,
        hoist: &Hoist<P>,
        command: &HoistCommand<C>,
        rate: C,
        rope: impl FnOnce() -> C,
    ) -> [C; 2] {
        let none = C::constant(1.0);
        match (&hoist.winch, self.way) {
            (Winch::Motor(drive), Bar::Held | Bar::Loose) => {
                let [hold, least, most] = Self::held(drive, command, rope());
                [capped(most - hold), capped(hold - least)]
            }
            (Winch::Motor(_), Bar::Forward) => [rate, none],
            (Winch::Motor(_), Bar::Backward) => [-rate, none],
            (_, Bar::Forward) => [C::constant(self.command) - rate, none],
            (_, Bar::Backward) => [rate - C::constant(self.command), none],
            (_, Bar::Held | Bar::Loose) => [none; 2],
        }
    }

    /// What it does under a command at an instant at which it pays out at a rate (m/s), its rate then, and how much
    /// that changed at once.
    pub(crate) fn decided(self, hoist: &Hoist, before: f64, command: &HoistCommand) -> (Drum, f64, f64) {
        if let Winch::Motor(_) = hoist.winch {
            let (way, rate) = self.way.turned(before);
            return (Drum { way, command: 0.0 }, rate, 0.0);
        }
        let (mut rate, command, at_once) = (before, command.speed, matches!(hoist.winch, Winch::AtOnce));
        let reached = self.command == command
            && match self.way {
                Bar::Forward => rate >= command,
                Bar::Backward => rate <= command,
                Bar::Held | Bar::Loose => false,
            };
        if reached || at_once {
            rate = command;
        }
        let way = if rate < command {
            Bar::Forward
        } else if rate > command {
            Bar::Backward
        } else {
            Bar::Held
        };
        let jump = if at_once && (rate - before).abs() > FELT {
            rate - before
        } else {
            0.0
        };
        (Drum { way, command }, rate, jump)
    }

    /// A drum with a motor at rest under a force of the rope (N): whether it breaks loose.
    pub(crate) fn loosen(&mut self, hoist: &Hoist, command: &HoistCommand, rope: impl FnOnce() -> f64) {
        if let (Winch::Motor(drive), Bar::Held) = (&hoist.winch, self.way) {
            // Who reels in pays out less: its own direction is the other one.
            let [hold, least, most] = Self::held(drive, command, rope());
            self.way = Bar::loosened([-hold, -most, -least]);
        }
    }

    /// One over the mass of a drum that turns, in 1/kg: how it gives way to a blow.
    pub(crate) fn ease(self, hoist: &Hoist) -> f64 {
        match &hoist.winch {
            Winch::Motor(drive) if self.way != Bar::Held => 1.0 / drive.mass,
            _ => 0.0,
        }
    }
}

/// What a hoist gives and takes at one instant, in W, and what it stores, in J.
#[derive(Clone, Copy, Debug, Default)]
pub struct HoistPowers {
    pub given: f64,
    pub lost: f64,
}

impl Hoist {
    /// Powers of a hoist that pays out at a rate (m/s) under a force of the rope (N), which is stretched by a length (m) at
    /// a rate (m/s). What is left in a rope that has let go is lost in it.
    pub(crate) fn powers(
        &self,
        drum: Drum,
        command: &HoistCommand,
        rate: f64,
        [stretch, stretching]: [f64; 2],
        rope: f64,
    ) -> HoistPowers {
        let within = |elastic: Elastic| {
            let spring = elastic.stiffness * stretch.max(0.0);
            (rope - spring) * stretching
        };
        let lost = self.rope.map_or(0.0, within);
        let Winch::Motor(drive) = &self.winch else {
            return HoistPowers {
                given: -rope * rate,
                lost,
            };
        };
        let turning = rate * drive.ratio;
        HoistPowers {
            given: -command.drive.moment * turning,
            lost: lost + drum.friction(self, command, rope) * turning,
        }
    }

    /// Energy (J) of a drum that pays out at a rate (m/s), and of a rope stretched by a length (m).
    pub(crate) fn energy(&self, rate: f64, stretch: f64) -> f64 {
        let drum = match &self.winch {
            Winch::Motor(drive) => 0.5 * drive.mass * rate * rate,
            Winch::AtOnce | Winch::Ramp(_) => 0.0,
        };
        let stretch = stretch.max(0.0);
        drum + self
            .rope
            .map_or(0.0, |elastic| 0.5 * elastic.stiffness * stretch * stretch)
    }
}

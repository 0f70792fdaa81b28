//! What turns the driving link, told apart: drive and brake, friction in its pins, end stop; and the rope at the head.

use crate::kernel::calc::{Calc, Over};
use crate::luffing::moving::symbols as s;
use crate::luffing::moving::weather::Pushed;
use crate::parts::joint::{Bar, Friction, LOOSE};
use crate::parts::plane::{self, Point};

/// Moments on the driving link, in N·m, in the direction of its angle.
#[derive(Clone, Copy, Debug)]
pub struct Shares<C> {
    /// Of motor and brake, or of the cylinder: what the line of the drive carries.
    pub drive: C,
    /// Of dry and of viscous friction in its pins.
    pub dry: C,
    pub viscous: C,
    pub stop: C,
    /// Force of a cylinder, push positive, in N.
    pub push: Option<C>,
    /// The greatest that the inertia of the motor's shaft asks for, as a moment on the driving link.
    pub lag: f64,
}

impl<C: Calc> Shares<C> {
    /// Of a motor's moment and of what friction, brake and end stop give `together` (N·m). A bar at rest is held by
    /// brake and dry friction in proportion to what they can hold, and by an end stop with what is left.
    pub fn new<P: Calc>(bar: Bar, together: C, omega: C, friction: &Friction<P>, [motor, brake]: [C; 2]) -> Shares<C>
    where
        C: Over<P>,
    {
        let (zero, coulomb) = (C::constant(0.0), C::of(friction.coulomb));
        let moving = |drive, dry| Shares {
            drive,
            dry,
            viscous: -(C::of(friction.viscous) * omega),
            stop: zero,
            push: None,
            lag: 0.0,
        };
        let shares = match bar {
            Bar::Forward => moving(motor - brake, -coulomb),
            Bar::Backward => moving(motor + brake, coulomb),
            Bar::Held | Bar::Loose => {
                let most = coulomb + brake;
                let (held, stop) = if together.value().abs() <= LOOSE * most.value() {
                    (together, zero)
                } else {
                    let held = if together.value() > 0.0 { most } else { -most };
                    (held, together - held)
                };
                let by_brake = if most.value() == 0.0 { zero } else { held * brake / most };
                Shares {
                    drive: motor + by_brake,
                    dry: held - by_brake,
                    viscous: zero,
                    stop,
                    push: None,
                    lag: 0.0,
                }
            }
        };
        shares.named()
    }

    /// What the line of the drive carries where a motor lags behind by its inertia, with a moment on the driving link and the
    /// greatest of what that is made of (N·m).
    pub fn less(self, lag: Option<(C, f64)>) -> Shares<C> {
        match lag {
            Some((moment, lag)) => Shares {
                drive: self.drive + moment,
                lag,
                ..self
            },
            None => self,
        }
    }

    /// Where a rope drives a bar at rest, which cannot push: it turns the bar against a sense, and dry friction has what the brake
    /// would have to give beyond that.
    pub fn pulled(self, sense: f64) -> Shares<C> {
        if self.drive.value() * sense <= 0.0 {
            return self;
        }
        Shares {
            drive: C::constant(0.0),
            dry: self.dry + self.drive,
            ..self
        }
        .named()
    }

    /// The moment on the driving link (N·m), and the greatest of what it is made of.
    pub fn acting(&self) -> (C, f64) {
        let Shares {
            drive,
            dry,
            viscous,
            stop,
            lag,
            ..
        } = *self;
        let parts = [drive, dry, viscous, stop].into_iter();
        let greatest = parts.fold(lag, |most, part| most.max(part.value().abs()));
        (drive + dry + viscous + stop, greatest)
    }

    /// For the book.
    pub fn named(self) -> Shares<C> {
        Shares {
            dry: self.dry.def(&s::M_RC),
            viscous: self.viscous.def(&s::M_RV),
            stop: self.stop.def(&s::M_RS),
            ..self
        }
    }
}

/// How the mechanism moves at one instant, and what acts on it besides weights.
#[derive(Clone, Copy, Debug)]
pub struct Instant<C> {
    /// Of the driving link, in rad/s and rad/s².
    pub omega: C,
    pub alpha: C,
    /// Angular velocity of slewing, in rad/s, where the crane slews.
    pub turning: Option<C>,
    /// Force of the rope on the head (N), where the load hangs on one.
    pub pull: Option<Point<C>>,
    /// The same along the rope.
    pub tension: Option<C>,
    /// By wind and slope, where it meets them.
    pub pushed: Option<Pushed<C>>,
    pub shares: Shares<C>,
}

impl<C: Calc> Instant<C> {
    /// Force of the wind forward on a body, by its place among bars and counterweight (N), and its moment about the origin
    /// (N·m, clockwise).
    pub fn blown(&self, body: usize) -> Option<[C; 2]> {
        self.pushed.and_then(|pushed| pushed.wind).map(|wind| wind[body])
    }
}

/// Force of a rope on the head: a pull (N) in the direction of the load.
pub fn rope_on_head<C: Calc>(pull: C, direction: Point<C>) -> Point<C> {
    plane::def(direction * pull, [&s::F_AX, &s::F_AY])
}

//! The turning centre that a command means.

use crate::kernel::calc::{Among, Calc};
use crate::kernel::number::short;
use crate::parts::plane::Point;
use crate::steering::centre::Centre;
use crate::steering::machine::Machine;
use crate::steering::mode::{Command, Mode};
use crate::steering::refusal::{Refusal, within};
use crate::steering::symbols as s;

/// Beyond this a turning centre is held by its direction and its curvature, in
/// m: squares of distances stay finite, and nothing changes in the last bit.
const FAR: f64 = 1e9;

/// A centre asked for on the machine's line of centres may miss it by this, in m.
const ON_LINE: f64 = 1e-9;

impl<C: Calc> Machine<C> {
    /// x of the line on which the turning centre moves, and the group whose angle commands it.
    #[must_use]
    pub fn line(&self, mode: Mode) -> Option<(C, usize)> {
        match mode {
            Mode::FrontAxle => Some((self.rear, 0)),
            // All of them have decided which one commands.
            Mode::RearAxle => Some((self.groups.iter().fold(self.front, |x, p| x.over(p.y)), self.rear_base)),
            Mode::AllWheel => Some((self.middle.x, 0)),
            _ => None,
        }
    }

    /// The group that commands.
    pub(super) fn commanding(&self, base: usize) -> Point<C> {
        let (at, which) = (self.groups[base], Among::Of(base as u16 + 1));
        Point::new(
            at.x.among(which, at.x).def(&s::X_B),
            at.y.among(which, at.y).def(&s::Y_B),
        )
    }
}

impl Mode {
    /// The turning centre of a command. Forward travel moves the base group along
    /// its heading where its angle commands; else the machine's middle forward, or
    /// to the left where it moves across, or counter-clockwise where it stands.
    pub fn centre<C: Calc>(self, machine: &Machine<C>, command: Command<C>) -> Result<Centre<C>, Refusal> {
        let constant = |x, y| Point::new(C::constant(x), C::constant(y));
        match (self, command) {
            (Mode::Straight, Command::None) => Ok(Centre::Far(constant(1.0, 0.0))),
            (Mode::Crosswise, Command::None) => Ok(Centre::Far(constant(0.0, 1.0))),
            (Mode::Pivot, Command::None) => Ok(Centre::At {
                at: machine.middle,
                clockwise: false,
            }),
            (Mode::Crab, Command::Angle(theta)) => {
                let (sin, cos) = within(&s::THETA_B, theta)?.sin_cos();
                Ok(Centre::Far(Point::new(cos, sin)))
            }
            (Mode::Corner, Command::Corner(index)) => {
                let at = machine.corners.get(index).ok_or_else(|| {
                    Refusal::new(
                        "corner",
                        format!("corner {}", index + 1),
                        format!("the machine's outline has {} corners", machine.corners.len()),
                    )
                })?;
                Ok(about(machine, *at))
            }
            (Mode::Free, Command::Centre(at)) => Ok(about(machine, finite_centre(at)?)),
            (Mode::FrontAxle | Mode::RearAxle | Mode::AllWheel, command) => {
                let (line, base) = machine.line(self).expect("these have one");
                match command {
                    Command::Angle(theta) => by_angle(machine, line, base, theta),
                    Command::Radius(radius) => by_radius(machine, line, radius),
                    Command::Centre(at) => {
                        let at = finite_centre(at)?;
                        if (at.x - line).value().abs() > ON_LINE {
                            return Err(Refusal::new(
                                "O.x",
                                format!("turning centre at x = {} m in mode {}", short(at.x.value()), self.id()),
                                format!(
                                    "in this mode it lies on the line x = {} m: move it there or choose the mode free",
                                    short(line.value())
                                ),
                            ));
                        }
                        Ok(about(machine, at))
                    }
                    other => Err(self.wants(other.name())),
                }
            }
            (_, other) => Err(self.wants(other.name())),
        }
    }

    fn wants(self, given: &str) -> Refusal {
        let wanted = match self {
            Mode::Straight | Mode::Crosswise | Mode::Pivot => "no command",
            Mode::Crab => "an angle",
            Mode::FrontAxle | Mode::RearAxle | Mode::AllWheel => "an angle, a radius or a turning centre",
            Mode::Corner => "a corner",
            Mode::Free => "a turning centre",
        };
        Refusal::new(
            "command",
            format!("mode {} was given {given}", self.id()),
            format!("it takes {wanted}"),
        )
    }
}

fn finite_centre<C: Calc>(at: Point<C>) -> Result<Point<C>, Refusal> {
    for (symbol, x) in [(&s::O_X, at.x.value()), (&s::O_Y, at.y.value())] {
        if !x.is_finite() {
            return Err(Refusal::new(
                symbol.id,
                format!("{} = {}", symbol.id, symbol.written(x)),
                "a turning centre is given by finite numbers; for one at infinity choose the mode straight or crab",
            ));
        }
    }
    // Both decide whether there is one.
    Ok(Point::new(at.x.over(at.y), at.y.over(at.x)))
}

/// Where the axle line of the base group meets the line of centres. The base's
/// own heading comes back exactly, and the groups on the line stand exactly straight.
fn by_angle<C: Calc>(machine: &Machine<C>, line: C, base: usize, theta: C) -> Result<Centre<C>, Refusal> {
    let from = machine.commanding(base);
    let lever = from.x - line;
    if lever.value() == 0.0 {
        return Err(Refusal::new(
            "theta_b",
            format!(
                "group {} commands by its angle, but stands on the line of turning centres x = {} m",
                base + 1,
                short(line.value())
            ),
            "there its angle is 0 for every radius: command by radius, or choose another base group",
        ));
    }
    let (sin, cos) = within(&s::THETA_B, theta)?.sin_cos();
    let d = Point::new(-(lever * sin), lever * cos);
    let (d, w) = if lever.value() > 0.0 { (d, sin) } else { (-d, -sin) };
    Ok(Centre::Beyond { from, d, w })
}

fn by_radius<C: Calc>(machine: &Machine<C>, line: C, radius: C) -> Result<Centre<C>, Refusal> {
    let value = radius.value();
    if value.is_nan() {
        return Err(Refusal::new(
            "R_t",
            "R_t = NaN m",
            "it must be a number, or infinite for straight ahead",
        ));
    }
    let from = Point::new(line, machine.middle.y);
    if value.abs() <= FAR {
        return Ok(Centre::At {
            at: Point::new(line, from.y + radius),
            clockwise: value < 0.0,
        });
    }
    Ok(Centre::Beyond {
        from,
        d: Point::new(C::constant(0.0), one()),
        w: one::<C>() / radius,
    })
}

/// What the machine's middle rolls where the centre lies beyond [`FAR`], in m: there rolling directions count by their
/// ratios alone.
fn one<C: Calc>() -> C {
    C::known(&s::U, 1.0)
}

/// A point as turning centre, with the forward sense of travel.
fn about<C: Calc>(machine: &Machine<C>, at: Point<C>) -> Centre<C> {
    let (ahead, left) = ((at.y - machine.middle.y).value(), (machine.middle.x - at.x).value());
    let clockwise = ahead < 0.0 || (ahead == 0.0 && left < 0.0);
    let (x, y) = (at.x.value().abs(), at.y.value().abs());
    if x.max(y) <= FAR {
        return Centre::At { at, clockwise };
    }
    let scale = if x > y { at.x } else { at.y };
    let scale = if (scale.value() < 0.0) != clockwise {
        -scale
    } else {
        scale
    };
    let from = machine.middle;
    Centre::Beyond {
        from,
        d: Point::new((at.x - from.x) / scale, (at.y - from.y) / scale) * one(),
        w: one::<C>() / scale,
    }
}

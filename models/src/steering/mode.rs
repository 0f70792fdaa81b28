//! Travel modes and commands, and the turning centre that they mean.

use crate::calc::Calc;
use crate::number::short;
use crate::plane::Point;
use crate::steering::machine::{Machine, Refusal};
use crate::steering::symbols as s;

/// Beyond this a turning centre is held by its direction and its curvature, in
/// m: squares of distances stay finite, and nothing changes in the last bit.
const FAR: f64 = 1e9;

/// A centre asked for on the machine's line of centres may miss it by this, in m.
const ON_LINE: f64 = 1e-9;

/// How the machine travels. Straight, crab, all-wheel and pivot are the paper's;
/// it counts nine modes and names these. [Zhang2016, abstract]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// All groups straight ahead. No command.
    Straight,
    /// All groups at one angle. Command: angle.
    Crab,
    /// All groups at a right angle. No command; positive travel goes left.
    Crosswise,
    /// Turning centre on the rearmost axle line. Command: angle, radius or centre.
    FrontAxle,
    /// Turning centre on the foremost axle line. Command: angle, radius or centre.
    RearAxle,
    /// Turning centre midway between foremost and rearmost axle. Command: angle, radius or centre.
    AllWheel,
    /// About the machine's middle. No command; positive travel turns left.
    Pivot,
    /// About a corner of the outline. Command: corner.
    Corner,
    /// About any point. Command: centre.
    Free,
}

impl Mode {
    /// In the order of their number in an FMU, from 1.
    pub const ALL: [Mode; 9] = [
        Mode::Straight,
        Mode::Crab,
        Mode::Crosswise,
        Mode::FrontAxle,
        Mode::RearAxle,
        Mode::AllWheel,
        Mode::Pivot,
        Mode::Corner,
        Mode::Free,
    ];

    #[must_use]
    pub fn id(self) -> &'static str {
        match self {
            Mode::Straight => "straight",
            Mode::Crab => "crab",
            Mode::Crosswise => "crosswise",
            Mode::FrontAxle => "front_axle",
            Mode::RearAxle => "rear_axle",
            Mode::AllWheel => "all_wheel",
            Mode::Pivot => "pivot",
            Mode::Corner => "corner",
            Mode::Free => "free",
        }
    }

    pub fn parse(text: &str) -> Result<Mode, Refusal> {
        let names = Mode::ALL.map(Mode::id);
        let found = Mode::ALL.into_iter().find(|mode| mode.id() == text);
        found.ok_or_else(|| {
            Refusal::new(
                "mode",
                format!("unknown travel mode \"{text}\""),
                format!("the modes are {}", names.join(", ")),
            )
        })
    }
}

/// What is asked of a mode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Command<C> {
    /// For modes that need none.
    None,
    /// Angle of the base group, in rad.
    Angle(C),
    /// From the machine's middle line to the turning centre, in m, left positive; may be infinite.
    Radius(C),
    /// The turning centre, in m.
    Centre(Point<C>),
    /// Corner of the outline, numbered from 0.
    Corner(usize),
}

impl<C> Command<C> {
    fn name(&self) -> &'static str {
        match self {
            Command::None => "no command",
            Command::Angle(_) => "an angle",
            Command::Radius(_) => "a radius",
            Command::Centre(_) => "a turning centre",
            Command::Corner(_) => "a corner",
        }
    }
}

/// The turning centre, projectively: it has no singular place, infinity included.
/// Each form is exact where it is used.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Centre<C> {
    /// At infinity: every group rolls along this direction (cosine, sine).
    Far(Point<C>),
    /// A point, in m; forward travel turns about it clockwise or counter-clockwise.
    At { at: Point<C>, clockwise: bool },
    /// `from` + `d`/`w`, at infinity in the direction `d` where `w` is zero.
    Beyond { from: Point<C>, d: Point<C>, w: C },
}

impl<C: Calc> Centre<C> {
    /// Direction in which the point `p` moves when the machine travels forward,
    /// with a length that grows in proportion to its speed; zero on the centre.
    #[inline]
    pub fn rolling(&self, p: Point<C>) -> Point<C> {
        match *self {
            Centre::Far(along) => along,
            Centre::At { at, clockwise: false } => Point::new(at.y - p.y, p.x - at.x),
            Centre::At { at, clockwise: true } => Point::new(p.y - at.y, at.x - p.x),
            Centre::Beyond { from, d, w } => Point::new(d.y - w * (p.y - from.y), w * (p.x - from.x) - d.x),
        }
    }

    /// Angular velocity that belongs to [`Centre::rolling`], counter-clockwise
    /// positive; `None` for none.
    #[inline]
    pub fn turning(&self) -> Option<C> {
        match *self {
            Centre::Far(_) => None,
            Centre::At { clockwise, .. } => Some(C::constant(if clockwise { -1.0 } else { 1.0 })),
            Centre::Beyond { w, .. } => Some(w),
        }
    }

    /// The point, in m; `None` at infinity.
    pub fn point(&self) -> Option<Point<C>> {
        match *self {
            Centre::Far(_) => None,
            Centre::At { at, .. } => Some(at),
            Centre::Beyond { from, d, w } => {
                let at = Point::new(from.x + d.x / w, from.y + d.y / w);
                (at.x.value().is_finite() && at.y.value().is_finite()).then_some(at)
            }
        }
        .map(|at| crate::plane::def(at, [&s::O_X, &s::O_Y]))
    }
}

impl<C: Calc> Machine<C> {
    /// x of the line on which the turning centre moves, and the group whose angle commands it.
    #[must_use]
    pub fn line(&self, mode: Mode) -> Option<(C, usize)> {
        match mode {
            Mode::FrontAxle => Some((self.rear, self.base)),
            Mode::RearAxle => Some((self.front, self.rear_base)),
            Mode::AllWheel => Some((self.middle.x, self.base)),
            _ => None,
        }
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
                let (sin, cos) = finite_angle(theta)?.sin_cos();
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

    /// How the turning centre moves with the commanded angle: its rolling
    /// directions are the derivatives of those of [`Mode::centre`]. `None` where
    /// the mode takes no angle.
    #[inline]
    pub fn slope<C: Calc>(self, machine: &Machine<C>, theta: C) -> Option<Centre<C>> {
        let (sin, cos) = theta.sin_cos();
        if self == Mode::Crab {
            return Some(Centre::Far(Point::new(-sin, cos)));
        }
        let (line, base) = machine.line(self)?;
        let from = machine.groups[base];
        let lever = from.x - line;
        let d = Point::new(-(lever * cos), -(lever * sin));
        Some(match lever.value() > 0.0 {
            true => Centre::Beyond { from, d, w: cos },
            false => Centre::Beyond { from, d: -d, w: -cos },
        })
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

fn finite_angle<C: Calc>(theta: C) -> Result<C, Refusal> {
    let limit = std::f64::consts::PI;
    crate::steering::machine::within(&s::THETA_B, theta, -limit, limit, false)
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
    Ok(at)
}

/// Where the axle line of the base group meets the line of centres. The base's
/// own heading comes back exactly, and the groups on the line stand exactly straight.
fn by_angle<C: Calc>(machine: &Machine<C>, line: C, base: usize, theta: C) -> Result<Centre<C>, Refusal> {
    let from = machine.groups[base];
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
    let (sin, cos) = finite_angle(theta)?.sin_cos();
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
        d: Point::new(C::constant(0.0), C::constant(1.0)),
        w: C::constant(1.0) / radius,
    })
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
        d: Point::new((at.x - from.x) / scale, (at.y - from.y) / scale),
        w: C::constant(1.0) / scale,
    }
}

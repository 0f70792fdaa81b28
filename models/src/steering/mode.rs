//! Travel modes, and what commands them.

use crate::kernel::calc::Calc;
use crate::kernel::group::{group, quantities};
use crate::parts::plane::Point;
use crate::steering::refusal::Refusal;
use crate::steering::symbols as s;

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
        s::MODES.items[self as usize].0
    }

    pub fn parse(text: &str) -> Result<Mode, Refusal> {
        let found = Mode::ALL.into_iter().find(|mode| mode.id() == text);
        found.ok_or_else(|| {
            Refusal::new(
                "mode",
                format!("unknown travel mode \"{text}\""),
                format!("the modes are {}", Mode::ALL.map(Mode::id).join(", ")),
            )
        })
    }
}
group!(Mode as s::MODE: |number| Mode::ALL[number as usize - 1], |mode| (1 + mode as usize) as f64);

/// What commands the modes whose turning centre moves on a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    Angle,
    Radius,
    Centre,
}

impl By {
    pub const ALL: [By; 3] = [By::Angle, By::Radius, By::Centre];
}
group!(By as s::COMMAND: |number| By::ALL[number as usize - 1], |by| (1 + by as usize) as f64);

/// A corner of the outline, from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Corner(pub usize);
group!(Corner as s::CORNER: |number| Corner(number as usize - 1), |corner| (1 + corner.0) as f64);

quantities! {
    /// The turning centre that is asked for, in m.
    Wanted { x: X_C, y: Y_C }
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

impl<C: Calc> Command<C> {
    /// What the inputs ask of their mode.
    pub fn new(wanted: &Wanted<C>, mode: &Mode, by: &By, corner: &Corner, theta_b: &C, r_t: &C) -> Command<C> {
        let centre = Command::Centre(Point::new(wanted.x, wanted.y));
        match (mode, by) {
            (Mode::Straight | Mode::Crosswise | Mode::Pivot, _) => Command::None,
            (Mode::Corner, _) => Command::Corner(corner.0),
            (Mode::Free, _) => centre,
            (Mode::Crab, _) | (_, By::Angle) => Command::Angle(*theta_b),
            (_, By::Radius) => Command::Radius(*r_t),
            (_, By::Centre) => centre,
        }
    }

    pub fn name(&self) -> &'static str {
        match self {
            Command::None => "no command",
            Command::Angle(_) => "an angle",
            Command::Radius(_) => "a radius",
            Command::Centre(_) => "a turning centre",
            Command::Corner(_) => "a corner",
        }
    }
}

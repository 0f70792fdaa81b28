//! Whether the groups can follow a command.

use crate::kernel::number::short;
use crate::steering::limits::Limits;
use crate::steering::machine::Machine;
use crate::steering::mode::{Command, Mode};
use crate::steering::nearest::nearest;
use crate::steering::refusal::Refusal;
use crate::steering::stand::obstacle;

/// What became of a command.
#[derive(Clone, Debug, PartialEq)]
pub enum Reach {
    Reachable,
    Unreachable {
        /// The first group that cannot, numbered from 0.
        group: usize,
        /// The angle that it would need, in rad, in (−π/2, π/2].
        needs: f64,
        /// As [`nearest`].
        nearest: Option<(Mode, Command<f64>)>,
    },
}

impl Reach {
    /// The message for a command that is out of reach.
    #[must_use]
    pub fn refusal(&self, limits: &[Limits]) -> Option<Refusal> {
        let Reach::Unreachable { group, needs, nearest } = self else {
            return None;
        };
        let range = &limits[*group];
        let degrees = |x: f64| short(x.to_degrees());
        let help = match nearest {
            Some((Mode::Crab, Command::Angle(theta))) => {
                format!(
                    "the nearest direction of travel is the mode crab at {} deg",
                    degrees(*theta)
                )
            }
            Some((_, Command::Angle(theta))) => {
                format!("the nearest angle of the base group is {} deg", degrees(*theta))
            }
            Some((_, Command::Radius(radius))) => format!("the nearest radius is {} m", short(*radius)),
            Some((mode, Command::Centre(at))) => format!(
                "the nearest turning centre is ({}, {}) m in the mode {}",
                short(at.x),
                short(at.y),
                mode.id()
            ),
            _ => "no command of this mode is reachable: choose another mode or widen the range".to_owned(),
        };
        let forbidden = if range.forbidden.is_empty() {
            ""
        } else {
            ", outside its forbidden ranges"
        };
        Some(Refusal::new(
            format!("theta[{}]", group + 1),
            format!("group {} would have to stand at {} deg", group + 1, degrees(*needs)),
            format!(
                "it turns from {} to {} deg{forbidden}; {help}",
                degrees(range.min),
                degrees(range.max)
            ),
        ))
    }
}

/// Whether every group can stand as the command asks. One range for each group.
pub fn reach(machine: &Machine<f64>, limits: &[Limits], mode: Mode, command: Command<f64>) -> Result<Reach, Refusal> {
    let centre = mode.centre(machine, command)?;
    Ok(match obstacle(machine, limits, &centre) {
        None => Reach::Reachable,
        Some((group, needs)) => Reach::Unreachable {
            group,
            needs,
            nearest: nearest(machine, limits, mode, command),
        },
    })
}

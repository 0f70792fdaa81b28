//! How the turning centre moves with the commanded angle.

use crate::kernel::calc::Calc;
use crate::parts::plane::Point;
use crate::steering::centre::Centre;
use crate::steering::machine::Machine;
use crate::steering::mode::{Command, Mode};

impl Mode {
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
        let from = machine.commanding(base);
        let lever = from.x - line;
        let d = Point::new(-(lever * cos), -(lever * sin));
        Some(match lever.value() > 0.0 {
            true => Centre::Beyond { from, d, w: cos },
            false => Centre::Beyond { from, d: -d, w: -cos },
        })
    }
}

/// How the turning centre moves with the commanded angle; `None` where no angle commands.
pub fn slope<C: Calc>(mode: &Mode, machine: &Machine<C>, command: &Command<C>) -> Option<Centre<C>> {
    match command {
        Command::Angle(theta) => mode.slope(machine, *theta),
        _ => None,
    }
}

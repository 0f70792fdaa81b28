//! A controller as scenes describe it.

use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::group::One;
use crate::kernel::schema::Values;
use crate::parts::control::{DriveAxis, SpeedControl};

/// The table of a scene whose drive has a controller, within that of the drive.
pub const TABLE: &str = "control";

impl SpeedControl {
    /// The controller of a table with its command, beside the table of the drive; `None` where there is none.
    ///
    /// # Errors
    /// Two commands, an approach that is not whole, a moment beside it.
    pub fn read(
        axis: &'static DriveAxis,
        of: &Values,
        drive: &Values,
    ) -> Result<Option<(SpeedControl, One<f64>)>, Diagnostic> {
        let Some(table) = of.table(TABLE) else {
            return Ok(None);
        };
        let [speed, place] = axis.commands;
        let moment = axis.drive.id;
        if drive.has(moment) {
            let what = format!("a moment {moment} beside the controller that gives it");
            let help = format!(
                "remove {moment}, and command {} or {} in [{TABLE}]; or remove that table",
                speed.id, place.id
            );
            return Err(drive.refuse(moment, what, "not used", help));
        }
        let to_place = table.stands(place.id);
        if to_place && table.stands(speed.id) {
            let what = format!("{} beside {}: two commands of one axis", speed.id, place.id);
            let help = format!("remove {}, or {}", speed.id, place.id);
            return Err(table.refuse(speed.id, what, "not used", help));
        }
        let [k, most] = axis.approach;
        if let Some(odd) = axis
            .approach
            .into_iter()
            .find(|symbol| table.stands(symbol.id) != to_place)
        {
            return Err(if to_place {
                let what = format!("{} without {}", place.id, odd.id);
                let help = format!("give {} and {}: how fast it goes there", k.id, most.id);
                table.refuse(place.id, what, "not known", help)
            } else {
                let what = format!("{} without a commanded place", odd.id);
                table.refuse(odd.id, what, "not used", format!("command {}, or remove it", place.id))
            });
        }
        let command = if to_place { place } else { speed };
        let whole = || {
            let [k_p, k_i, cycle, ramp, limit] = axis.settings.map(|symbol| table.of(symbol));
            if cycle.is_none() && table.stands(axis.settings[2].id) {
                return None;
            }
            let control = SpeedControl {
                axis,
                gains: [k_p?, k_i?],
                cycle,
                ramp: ramp?,
                limit: limit?,
                approach: if to_place {
                    Some([table.of(k)?, table.of(most)?])
                } else {
                    None
                },
            };
            Some((control, One(command, table.number(command.id).unwrap_or(0.0))))
        };
        Ok(whole())
    }

    /// Refuses one under which a shaft of an inertia swings up.
    #[must_use]
    pub fn unstable(&self, drive: &Values, inertia: f64) -> Option<Diagnostic> {
        let [what, help] = self.swings_up(inertia)?;
        Some(
            drive
                .table(TABLE)?
                .refuse(self.axis.settings[2].id, what, "unstable", help),
        )
    }
}

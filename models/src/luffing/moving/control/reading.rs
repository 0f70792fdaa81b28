//! The controllers of a crane as its scene describes them.

use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::group::One;
use crate::kernel::schema::Values;
use crate::luffing::moving::control::{AXES, ByAxis, cycle};
use crate::luffing::moving::given::Inputs;
use crate::parts::control::reading::TABLE;
use crate::parts::control::{Latched, SpeedControl, taken};

/// Cycles are one that differ by less than this part of them: other units are rounded otherwise.
const SAME: f64 = 1e-12;

/// Controllers with their commands.
#[derive(Clone, Copy, Debug)]
pub struct Controllers {
    pub control: ByAxis<SpeedControl>,
    pub commanded: ByAxis<One<f64>>,
}

/// Refuses a controller that is not sampled of a crane that a cylinder luffs.
fn beside_oil(table: &Values, control: &SpeedControl) -> Diagnostic {
    let id = control.axis.settings[2].id;
    let what = format!("a controller without its cycle {id}");
    let help = format!("add {id} = \"20 ms\": drives of a crane that a cylinder luffs have sampled controllers");
    table.refuse(id, what, "needed here", help)
}

/// Refuses controllers of two cycles, or of which one alone is sampled.
fn other(table: &Values, own: &SpeedControl, known: &SpeedControl) -> Option<Diagnostic> {
    let [of, than] = [own, known].map(|it| it.axis.settings[2]);
    let (what, label, help) = match (own.cycle(), known.cycle()) {
        (Some(cycle), Some(other)) if (other - cycle).abs() > SAME * cycle => (
            format!(
                "{} = {} beside {} = {}",
                of.id,
                of.written(cycle),
                than.id,
                than.written(other)
            ),
            "two cycles",
            "one PLC samples all drives: give its cycle to each of them".to_owned(),
        ),
        (Some(_), None) | (None, Some(_)) => {
            let [with, without] = if own.cycle().is_some() { [of, than] } else { [than, of] };
            (
                format!("{} without {}", with.id, without.id),
                "one alone is sampled",
                format!(
                    "one PLC samples all drives: give its cycle {} too, or no cycle at all",
                    without.id
                ),
            )
        }
        _ => return None,
    };
    Some(table.refuse(of.id, what, label, help))
}

impl Controllers {
    /// Those in the tables of luffing, slewing and hoist, each with that of its drive; `None` where there is none.
    ///
    /// # Errors
    /// As [`SpeedControl::read`]; two cycles, or one controller with it and one without, as one PLC samples all drives; one
    /// without where a cylinder luffs.
    pub fn read(tables: [Option<[&Values; 2]>; 3], oil: bool) -> Result<Option<Controllers>, Diagnostic> {
        let (mut control, mut commanded) = (ByAxis([None; 3]), ByAxis([None; 3]));
        let mut first: Option<SpeedControl> = None;
        for (i, (axis, tables)) in AXES.into_iter().zip(tables).enumerate() {
            let Some([table, drive]) = tables else { continue };
            let Some((own, command)) = SpeedControl::read(axis, table, drive)? else {
                continue;
            };
            let place = table.table(TABLE).unwrap_or(table);
            if oil && own.cycle().is_none() {
                return Err(beside_oil(place, &own));
            }
            if let Some(refused) = first.as_ref().and_then(|known| other(place, &own, known)) {
                return Err(refused);
            }
            first = first.or(Some(own));
            (control.0[i], commanded.0[i]) = (Some(own), Some(command));
        }
        Ok(first.map(|_| Controllers { control, commanded }))
    }

    /// Whether a PLC samples them.
    #[must_use]
    pub fn are_sampled(&self) -> bool {
        cycle(&self.control).is_some()
    }

    /// Drives give what their controllers may ask of them at most.
    pub fn limit(&self, strongest: &mut Inputs) {
        for (i, control) in self.control.0.iter().enumerate() {
            if let Some(control) = control {
                strongest.drive(i).moment = control.limit();
            }
        }
    }

    /// Ids of what the model takes for granted of them.
    pub fn taken(&self) -> impl Iterator<Item = &'static str> {
        taken(self.control.0.iter().flatten())
    }

    /// Without that of luffing (0), slewing (1) or hoist (2); `None` where none is left.
    #[must_use]
    pub fn without(mut self, axis: usize) -> Option<Controllers> {
        (self.control.0[axis], self.commanded.0[axis]) = (None, None);
        self.control.0.iter().any(Option::is_some).then_some(self)
    }

    /// What they hold where nothing has happened yet, at speeds of luffing, slewing and hoist.
    #[must_use]
    pub fn at_start(&self, speeds: [f64; 3]) -> ByAxis<Latched> {
        let ByAxis(control) = &self.control;
        ByAxis(std::array::from_fn(|i| {
            Some(Latched::steady(control[i].as_ref()?, speeds[i]))
        }))
    }
}

//! The controllers of a crane as its scene describes them.

use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::group::One;
use crate::kernel::schema::Values;
use crate::luffing::moving::control::{AXES, ByAxis};
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

/// Refuses a controller that is not sampled.
fn continuous(table: &Values, control: &SpeedControl) -> Diagnostic {
    let id = control.axis.settings[2].id;
    let what = format!("a controller without its cycle {id}");
    let help = format!("add {id} = \"20 ms\": drives of a crane that luffs have sampled controllers");
    table.refuse(id, what, "needed here", help)
}

impl Controllers {
    /// Those in the tables of luffing, slewing and hoist, each with that of its drive; `None` where there is none.
    ///
    /// # Errors
    /// As [`SpeedControl::read`]; a controller without a cycle; two cycles, as one PLC samples all drives.
    pub fn read(tables: [Option<[&Values; 2]>; 3]) -> Result<Option<Controllers>, Diagnostic> {
        let (mut control, mut commanded) = (ByAxis([None; 3]), ByAxis([None; 3]));
        let mut first: Option<(SpeedControl, f64)> = None;
        for (i, (axis, tables)) in AXES.into_iter().zip(tables).enumerate() {
            let Some([table, drive]) = tables else { continue };
            let Some((own, command)) = SpeedControl::read(axis, table, drive)? else {
                continue;
            };
            let Some(cycle) = own.cycle() else {
                return Err(continuous(table.table(TABLE).unwrap_or(table), &own));
            };
            let other = |known: &(SpeedControl, f64)| (known.1 - cycle).abs() > SAME * cycle;
            if let Some((known, than_cycle)) = first.filter(other) {
                let [of, than] = [&own, &known].map(|it| it.axis.settings[2]);
                let what = format!(
                    "{} = {} beside {} = {}",
                    of.id,
                    of.written(cycle),
                    than.id,
                    than.written(than_cycle)
                );
                let help = "one PLC samples all drives: give its cycle to each of them";
                return Err(table
                    .table(TABLE)
                    .unwrap_or(table)
                    .refuse(of.id, what, "two cycles", help));
            }
            first = first.or(Some((own, cycle)));
            (control.0[i], commanded.0[i]) = (Some(own), Some(command));
        }
        Ok(first.map(|_| Controllers { control, commanded }))
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

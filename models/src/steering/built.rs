//! The machine of plain numbers, for whoever asks more of it than a running model does.

use crate::steering::cylinder::Linkage;
use crate::steering::frame::limits;
use crate::steering::limits::Limits;
use crate::steering::machine::Machine;
use crate::steering::refusal::Refusal;
use crate::steering::stages::Given;

/// A machine with the ranges of its groups and their cylinders; no linkages where no cylinder is modelled.
#[derive(Clone, Debug)]
pub struct Built {
    pub machine: Machine<f64>,
    pub limits: Vec<Limits>,
    pub linkages: Vec<Linkage<f64>>,
}

impl Built {
    /// # Errors
    /// Quantities with which there is no machine.
    pub fn new(given: &Given<f64>) -> Result<Built, Refusal> {
        let machine = Machine::new(&given.axes, &given.outline)?;
        let mut ranges = Vec::new();
        limits(&given.mounts, &given.cylinder, &mut ranges)?;
        let cylinders = given.cylinder.iter();
        let linkages = cylinders.flat_map(|cylinder| given.mounts.iter().map(|mount| cylinder.linkage(mount.mirrored)));
        Ok(Built {
            machine,
            limits: ranges,
            linkages: linkages.collect(),
        })
    }

    /// The linkage that the book's formulas speak of, with its range: a direct one, if there is one.
    #[must_use]
    pub fn direct(&self) -> Option<(&Linkage<f64>, &Limits)> {
        let mut each = self.linkages.iter().zip(&self.limits);
        let first = each.clone().next();
        each.find(|(linkage, _)| !linkage.mirrored).or(first)
    }
}

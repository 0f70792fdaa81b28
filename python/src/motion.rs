//! A run over time, as an importer steps the FMU of Co-Simulation.

use std::sync::atomic::Ordering;
use std::sync::{Mutex, PoisonError};

use lemnis_models::component::model::Model;
use lemnis_models::kernel::number::short;
use lemnis_models::kernel::variable::Fault;
use pyo3::prelude::*;

use crate::errors::refused;
use crate::events::{Event, Finder};
use crate::work::shared;

/// What runs.
pub struct Run {
    /// Variables, by their indices, with the values that they begin with.
    pub start: Vec<(usize, f64)>,
    /// Inputs, each with its value from every time to the next one.
    pub inputs: Vec<(usize, Vec<f64>)>,
    /// Times at which outputs are taken, in s; the run begins at the first one, which is 0.
    pub times: Vec<f64>,
    pub outputs: Vec<usize>,
}

impl Run {
    fn set(&self, model: &mut Model, point: usize) -> Result<(), Fault> {
        self.inputs
            .iter()
            .try_for_each(|(index, values)| model.set(*index, values[point]))
    }

    fn look(&self, model: &mut Model, table: &mut Vec<f64>) -> Result<(), Fault> {
        let before = table.len();
        for &index in &self.outputs {
            match model.get(index) {
                Ok(value) => table.push(value),
                Err(fault) => {
                    table.truncate(before);
                    return Err(fault);
                }
            }
        }
        Ok(())
    }

    fn begin(&self, model: &mut Model, table: &mut Vec<f64>) -> Result<(), Fault> {
        for &(index, value) in &self.start {
            model.set(index, value)?;
        }
        self.set(model, 0)?;
        model.start()?;
        self.look(model, table)
    }

    /// A step to the next time, and what happened on the way.
    fn step(&self, model: &mut Model, finder: &mut Finder, point: usize, done: &mut Done) -> Result<(), Fault> {
        let times = [self.times[point], self.times[point + 1]];
        self.set(model, point)?;
        let (before, known) = (model.state(), model.count().events);
        model.advance(times[0], times[1])?;
        let count = model.count().events - known;
        if count > 0 {
            // The step was made, whatever becomes of looking for what happened in it.
            done.events
                .extend(finder.find(&before, times, count).unwrap_or_default());
        }
        self.look(model, &mut done.table)
    }
}

/// What a run gave.
#[derive(Default)]
pub struct Done {
    /// The outputs at each time, one time after the other.
    pub table: Vec<f64>,
    pub events: Vec<Event>,
    /// Why it ended before the last time, if it did.
    pub ended: Option<String>,
}

/// Runs a model through its times.
///
/// # Errors
/// Values that cannot be, a motion that cannot begin, Ctrl+C.
pub fn run(py: Python<'_>, run: Run, model: Model) -> PyResult<Done> {
    let model = Mutex::new(Some(model));
    let mut done = shared(py, 1, move |stop| {
        let model = model.lock().unwrap_or_else(PoisonError::into_inner).take();
        let mut model = model.expect("one thread");
        let mut done = Done::default();
        done.table.reserve(run.times.len() * run.outputs.len());
        run.begin(&mut model, &mut done.table)?;
        let mut finder = Finder::new(&model);
        for point in 1..run.times.len() {
            if stop.load(Ordering::Relaxed) {
                break;
            }
            if let Err(fault) = run.step(&mut model, &mut finder, point - 1, &mut done) {
                let at = short(run.times[point - 1]);
                done.ended = Some(format!("the run ends at {at} s: {}", fault.message));
                break;
            }
        }
        Ok(done)
    })?;
    let done: Result<_, Fault> = done.pop().expect("one thread");
    done.map_err(refused)
}

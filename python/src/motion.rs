//! A run over time, as an importer steps the FMU of Co-Simulation.

use std::sync::atomic::Ordering;
use std::sync::{Mutex, PoisonError};

use lemnis_models::component::model::Model;
use lemnis_models::kernel::number::short;
use lemnis_models::kernel::variable::Fault;
use pyo3::prelude::*;

use crate::errors::refused;
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
}

/// The outputs at each time, and why the run ended before the last one, if it did.
///
/// # Errors
/// Values that cannot be, a motion that cannot begin, Ctrl+C.
pub fn run(py: Python<'_>, run: Run, model: Model) -> PyResult<(Vec<f64>, Option<String>)> {
    let model = Mutex::new(Some(model));
    let mut done = shared(py, 1, move |stop| {
        let model = model.lock().unwrap_or_else(PoisonError::into_inner).take();
        let mut model = model.expect("one thread");
        let mut table = Vec::with_capacity(run.times.len() * run.outputs.len());
        run.begin(&mut model, &mut table)?;
        for (point, step) in run.times.windows(2).enumerate() {
            if stop.load(Ordering::Relaxed) {
                break;
            }
            let moved = run
                .set(&mut model, point)
                .and_then(|()| model.advance(step[0], step[1]))
                .and_then(|()| run.look(&mut model, &mut table));
            if let Err(fault) = moved {
                let told = format!("the run ends at {} s: {}", short(step[0]), fault.message);
                return Ok((table, Some(told)));
            }
        }
        Ok((table, None))
    })?;
    let done: Result<_, Fault> = done.pop().expect("one thread");
    done.map_err(refused)
}

//! Values of some results at many inputs, and their exact derivatives. No row depends on another one, nor on how many
//! threads share them.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use lemnis_models::component::model::Model;
use lemnis_models::kernel::number::short;
use lemnis_models::kernel::variable::{Fault, PART_OF_RANGE, Quantity, Role, Variable};
use pyo3::prelude::*;

use crate::work::shared;

/// Rows that a thread takes at a time.
const BLOCK: usize = 256;
/// Numbers that are computed at once, without threads: they take a millisecond or two.
const FEW: usize = 1_000;

/// Values of an input: one for all rows, or one for each.
pub struct Given {
    pub index: usize,
    pub values: Vec<f64>,
}

/// What is asked of a model.
pub struct Asked {
    variables: Arc<[Variable]>,
    /// Inputs and parameters.
    given: Vec<Given>,
    coordinate: Option<Given>,
    states: Vec<Given>,
    count: usize,
    outputs: Vec<usize>,
}

/// What was computed.
pub struct Rows {
    /// Numbers of a row.
    width: usize,
    /// Rows one after the other, with the first of them.
    blocks: Vec<(usize, Vec<f64>)>,
    /// What failed, in the order of the rows.
    pub faults: Vec<(usize, String)>,
}

impl Rows {
    /// One number of every row, of which there are so many; NaN where there is none.
    pub fn column(&self, at: usize, count: usize) -> Vec<f64> {
        let mut column = vec![f64::NAN; count];
        for (start, values) in &self.blocks {
            let numbers = values.iter().skip(at).step_by(self.width);
            column[*start..]
                .iter_mut()
                .zip(numbers)
                .for_each(|(to, from)| *to = *from);
        }
        column
    }

    /// All numbers, row by row.
    pub fn whole(&self, count: usize) -> Vec<f64> {
        let mut table = vec![f64::NAN; count * self.width];
        for (start, values) in &self.blocks {
            table[start * self.width..][..values.len()].copy_from_slice(values);
        }
        table
    }
}

impl Given {
    fn at(&self, row: usize) -> f64 {
        if self.values.len() == 1 {
            self.values[0]
        } else {
            self.values[row]
        }
    }
}

impl Asked {
    /// # Errors
    /// An input that cannot be set, or is given twice.
    pub fn new(
        variables: &Arc<[Variable]>,
        given: Vec<Given>,
        count: usize,
        outputs: Vec<usize>,
    ) -> Result<Asked, String> {
        let mut asked = Asked {
            variables: Arc::clone(variables),
            given: Vec::new(),
            coordinate: None,
            states: Vec::new(),
            count,
            outputs,
        };
        let mut seen = vec![false; variables.len()];
        for one in given {
            let variable = &variables[one.index];
            if std::mem::replace(&mut seen[one.index], true) {
                return Err(format!("{variable} is given twice"));
            }
            match variable.role {
                _ if one.index == 0 => asked.coordinate = Some(one),
                Role::Input | Role::Parameter | Role::Tunable => asked.given.push(one),
                Role::State => asked.states.push(one),
                Role::Output | Role::Calculated | Role::Rate | Role::Indicator => {
                    return Err(format!("{variable} is a result and cannot be set"));
                }
            }
        }
        let by_part = asked
            .given
            .iter()
            .any(|one| variables[one.index].symbol == &PART_OF_RANGE);
        if by_part && asked.coordinate.is_some() {
            return Err(format!(
                "{} and {} say the same: give one of them",
                PART_OF_RANGE.id, variables[0]
            ));
        }
        Ok(asked)
    }

    /// How many threads are worth while; none where the caller had better compute at once.
    pub fn threads(&self, most: usize) -> usize {
        match self.count * self.outputs.len() {
            0..=FEW => 0,
            _ => most.clamp(1, self.count.div_ceil(BLOCK)),
        }
    }

    /// Brings the model to a row of the inputs.
    fn set(&self, model: &mut Model, row: usize) -> Result<(), Fault> {
        for one in &self.given {
            model.set(one.index, one.at(row))?;
        }
        if let Some(one) = &self.coordinate {
            model.place(one.at(row))?;
        }
        for one in &self.states {
            model.set(one.index, one.at(row))?;
        }
        Ok(())
    }

    fn row(&self, model: &mut Model, row: usize, values: &mut Vec<f64>) -> Result<(), Fault> {
        self.set(model, row)?;
        for &index in &self.outputs {
            values.push(model.get(index)?);
        }
        Ok(())
    }

    /// All rows, here and now; only the first failure where not every one is wanted.
    pub fn here(&self, model: &mut Model, every: bool) -> Rows {
        let width = self.outputs.len();
        let (mut values, mut faults) = (Vec::with_capacity(self.count * width), Vec::new());
        for row in 0..self.count {
            if let Err(fault) = self.row(model, row, &mut values) {
                faults.push((row, fault.message));
                if !every {
                    break;
                }
            }
            values.resize((row + 1) * width, f64::NAN);
        }
        let blocks = vec![(0, values)];
        Rows { width, blocks, faults }
    }

    /// All rows, shared by as many threads as there are models. `row` appends so many numbers.
    fn shared<R>(self, py: Python<'_>, models: Vec<Model>, width: usize, every: bool, row: R) -> PyResult<Rows>
    where
        R: Fn(&Asked, &mut Model, usize, &mut Vec<f64>) -> Result<(), Fault> + Send + Sync + 'static,
    {
        let (count, threads) = (self.count, models.len());
        let models = Mutex::new(models);
        let next = AtomicUsize::new(0);
        // Rows behind the first failure need not be known, unless every one is wanted.
        let worst = AtomicUsize::new(usize::MAX);
        let parts = shared(py, threads, move |stop: &AtomicBool| {
            let model = models.lock().unwrap_or_else(PoisonError::into_inner).pop();
            let mut model = model.expect("as many models as threads");
            let (mut blocks, mut faults) = (Vec::new(), Vec::new());
            loop {
                let block = next.fetch_add(1, Ordering::Relaxed);
                let rows = block * BLOCK..((block + 1) * BLOCK).min(count);
                if rows.is_empty() || !every && worst.load(Ordering::Relaxed) < rows.start {
                    return (blocks, faults);
                }
                let (start, mut values) = (rows.start, Vec::with_capacity(rows.len() * width));
                for at in rows {
                    if stop.load(Ordering::Relaxed) {
                        return (Vec::new(), Vec::new());
                    }
                    if let Err(fault) = row(&self, &mut model, at, &mut values) {
                        faults.push((at, fault.message));
                        worst.fetch_min(at, Ordering::Relaxed);
                    }
                    values.resize((at + 1 - start) * width, f64::NAN);
                }
                blocks.push((start, values));
            }
        })?;
        let (mut blocks, mut faults) = (Vec::new(), Vec::new());
        for (some, failed) in parts {
            blocks.extend(some);
            faults.extend(failed);
        }
        faults.sort_by_key(|(row, _)| *row);
        faults.truncate(if every { usize::MAX } else { 1 });
        Ok(Rows { width, blocks, faults })
    }
}

/// Values of the outputs.
///
/// # Errors
/// Ctrl+C.
pub fn values(py: Python<'_>, asked: Asked, models: Vec<Model>, every: bool) -> PyResult<Rows> {
    let width = asked.outputs.len();
    asked.shared(py, models, width, every, Asked::row)
}

/// Derivatives of the outputs, each by every quantity.
///
/// # Errors
/// Ctrl+C.
pub fn derivatives(py: Python<'_>, asked: Asked, by: Vec<Quantity>, models: Vec<Model>) -> PyResult<Rows> {
    let (of, width) = (asked.outputs.len(), by.len());
    asked.shared(py, models, of * width, false, move |asked, model, row, values| {
        asked.set(model, row)?;
        let from = values.len();
        values.resize(from + of * width, 0.0);
        for (j, own) in by.iter().enumerate() {
            let mut tangent = model.tangent(&|quantity| f64::from(quantity == *own));
            for (i, &index) in asked.outputs.iter().enumerate() {
                let derivative = model.derivative(&mut tangent, index)?;
                if !derivative.is_finite() {
                    let variable = &asked.variables[index];
                    let message = format!("{variable} has no derivative here: {}", short(derivative));
                    return Err(Fault::outside(message));
                }
                values[from + i * width + j] = derivative;
            }
        }
        Ok(())
    })
}

//! What the model refuses, as Python has it.

use lemnis_models::kernel::variable::Fault;
use pyo3::create_exception;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

create_exception!(
    lemnis,
    ModelError,
    PyValueError,
    "A value that the model refuses, or a configuration that does not exist: the message names the quantity, its value and \
     what is allowed."
);

pub fn refused(fault: Fault) -> PyErr {
    ModelError::new_err(fault.message)
}

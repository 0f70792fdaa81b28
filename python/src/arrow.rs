//! Columns for all that reads Arrow: pandas, polars, pyarrow, duckdb.

use std::collections::HashMap;
use std::sync::Arc;

use arrow_array::ffi_stream::FFI_ArrowArrayStream;
use arrow_array::{ArrayRef, Float64Array, RecordBatch, RecordBatchIterator, StringArray};
use arrow_schema::{DataType, Field, Schema};
use numpy::PyReadonlyArray1;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyCapsule;

/// A text, or nothing, for each row.
type Texts = Vec<Option<String>>;

/// A stream of one batch with these columns, each with its name and what is known of it; then with columns of texts.
///
/// # Errors
/// Columns of different lengths.
#[pyfunction]
pub fn stream<'py>(
    py: Python<'py>,
    fields: Vec<(String, HashMap<String, String>)>,
    columns: Vec<PyReadonlyArray1<'py, f64>>,
    texts: Vec<(String, Texts)>,
) -> PyResult<Bound<'py, PyCapsule>> {
    let field = |(name, known)| Field::new(name, DataType::Float64, false).with_metadata(known);
    let text = |(name, _): &(String, Texts)| Field::new(name, DataType::Utf8, true);
    let fields = fields.into_iter().map(field).chain(texts.iter().map(text));
    let schema = Arc::new(Schema::new(fields.collect::<Vec<Field>>()));
    let column = |values: &PyReadonlyArray1<'py, f64>| -> ArrayRef {
        Arc::new(Float64Array::from_iter_values(values.as_array().iter().copied()))
    };
    let words = |(_, rows): (String, Texts)| -> ArrayRef { Arc::new(StringArray::from_iter(rows)) };
    let arrays = columns.iter().map(column).chain(texts.into_iter().map(words));
    let batch = RecordBatch::try_new(Arc::clone(&schema), arrays.collect());
    let batch = batch.map_err(|error| PyValueError::new_err(error.to_string()))?;
    let batches = RecordBatchIterator::new([Ok(batch)], schema);
    PyCapsule::new_with_value(py, FFI_ArrowArrayStream::new(Box::new(batches)), c"arrow_array_stream")
}

//! `_lemnis`: what the Python package computes with. Texts and arrays in, arrays and plain values out; all that people see
//! of it is written in Python, in `python/lemnis/`.
//!
//! ```text
//! scene.rs    a checked scene, its names and its models
//! edit.rs     its text with other values, comments kept
//! asked.rs    values of some results at many inputs, and their derivatives
//! motion.rs   a run over time
//! study.rs    the rows of a study
//! work.rs     threads that Ctrl+C ends, and a net under them
//! told.rs     what its book would say: results of the whole range, checks, the drawing
//! errors.rs   what the model refuses
//! arrow.rs    columns for pandas, polars and all else that reads Arrow
//! ```

#![deny(unsafe_code)]

mod arrow;
mod asked;
mod edit;
mod errors;
mod events;
mod motion;
mod scene;
mod study;
mod told;
mod work;

use pyo3::pymodule;

#[pymodule(gil_used = false)]
mod _lemnis {
    #[pymodule_export]
    const DEFAULT: &str = lemnis_models::scene::DEFAULT;
    #[pymodule_export]
    const VERSION: &str = env!("CARGO_PKG_VERSION");
    #[pymodule_export]
    use crate::arrow::stream;
    #[pymodule_export]
    use crate::errors::ModelError;
    #[pymodule_export]
    use crate::scene::{Scene, parse, schema};
    #[pymodule_export]
    use crate::study::{studied, study, study_rows};
}

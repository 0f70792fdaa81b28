//! The calculation book of a scene, its results as text, and the first page of an FMU's documentation.
//!
//! ```text
//! sheet (lemnis_models) → book.rs      plain data, ready to print
//!                         formula.rs   formulas in symbols and in numbers
//!                         plot.rs      drawings and curves as display lists
//!                         diagram.rs   cost over accuracy
//!                         language.rs  words and number formats of a language
//!                       → template.rs  templates/ and the words of a language → Typst source
//!                         speech.rs    every equation in words, for screen readers
//!                       → lemnis_typeset → PDF
//! ```

pub mod book;
pub mod diagram;
pub mod documentation;
pub mod formula;
pub mod language;
pub mod machine;
pub mod plot;
pub mod results;
mod speech;
pub mod template;

//! The calculation book of a scene, its results as text, and the first page of an FMU's documentation.
//!
//! ```text
//! sheet (lemnis_models) → book/            plain data, ready to print: chapters made of blocks
//!                         print/           numbers, formulas, drawings, curves: one thing each
//!                         language.rs      words and number formats of a language
//! answer/                 what a scene's text gives, as one value for command line, page and other programs
//!                       → template.rs      templates/ and the words of a language → Typst source
//!                         print/speech.rs  every equation in words, for screen readers
//!                       → lemnis_typeset → PDF
//! ```

pub mod answer;
pub mod book;
pub mod documentation;
pub mod language;
pub mod machine;
pub mod print;
pub mod results;
pub mod template;

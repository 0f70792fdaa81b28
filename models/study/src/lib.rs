//! Studies: what comes of many values of a scene's quantities. A crate of its own, so that an FMU carries none of it.
//!
//! | file | what |
//! |---|---|
//! | [`sobol`] | points that fill a cube evenly, each by its number |
//! | [`designs`] | the values of each design, by its number |
//! | [`rows`] | what comes of a design, or why there is nothing |
//! | [`run`] | many rows on several threads, in their order |
//! | [`summary`] | what the rows say together: percentiles, shares, what moves what |
//!
//! A row is a function of the scene and the row's number alone, whichever thread, process or machine computes it: the design
//! is read as any other scene, by the reader of scenes.

#![forbid(unsafe_code)]

pub mod designs;
pub mod rows;
pub mod run;
pub mod sobol;
pub mod summary;

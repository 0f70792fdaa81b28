//! One file for each command.

pub mod asked;
pub mod book;
pub mod build;
pub mod check;
pub mod fmu;
pub mod new;
pub mod pages;
pub mod serve;
pub mod sweep;
pub mod synth;
pub mod templates;
pub mod trade;
pub mod watched;

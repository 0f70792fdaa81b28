//! Equations, symbols and scenes of Lemnis. No I/O, no FMI, no templates.
//!
//! A scene's text ([`scene`]) is checked against its keys ([`kernel::schema`]) and
//! becomes a mechanism of the [`registry`]: [`luffing`] with its [`balance`] and [`drive`], [`sway`] under trolleys, [`slewing`], [`hopper`], [`unloader`], [`bridge`], [`afloat`], [`steering`], [`supports`]. Its equations, over
//! [`parts`], run on any scalar ([`kernel::calc`]): on `f64` in a model, which the
//! FMU steps, on the recorder ([`kernel::record`]) for the book's sheet; both are made in [`component`].
//! The synthesis of a balance, and of whatever a scene asks for ([`request`]), is searches without FMU;
//! its designs with many values ([`study`]) are found by the crate `lemnis_study`.

#![forbid(unsafe_code)]

pub mod afloat;
pub mod alone;
pub mod balance;
pub mod book;
pub mod bridge;
pub mod component;
pub mod drive;
pub mod hopper;
pub mod kernel;
pub mod luffing;
pub mod parts;
pub mod reading;
pub mod registry;
pub mod request;
pub mod scene;
pub mod slewing;
pub mod steering;
pub mod study;
pub mod supports;
pub mod sway;
pub mod unloader;
pub mod vary;

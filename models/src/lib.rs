//! Equations, symbols and scenes of Lemnis. No I/O, no FMI, no templates.
//!
//! A scene's text ([`scene`]) is checked against its keys ([`schema`]) and
//! becomes parameters; the equations ([`lemniscate`], over [`four_bar`] and
//! [`plane`]) run on any scalar ([`calc`]): on `f64` in a [`model`], which the
//! FMU steps, on the recorder ([`record`]) for the book's [`sheet`].
//!
//! [`balance`] is a part of a luffing mechanism; its synthesis is searches
//! without FMU.

#![forbid(unsafe_code)]

pub mod allowed;
pub mod balance;
pub mod book;
pub mod calc;
pub mod component;
pub mod diagnostic;
pub mod four_bar;
pub mod gravity;
pub mod group;
pub mod hydraulics;
pub mod lemniscate;
pub mod luffing;
pub mod mechanism;
pub mod model;
pub mod motion;
pub mod number;
pub mod origin;
pub mod plane;
pub mod record;
pub mod registry;
pub mod scene;
pub mod schema;
pub mod sheet;
pub mod solver;
pub mod steering;
pub mod symbol;
pub mod unit;

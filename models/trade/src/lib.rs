//! Speed against accuracy: what every level, solver and step of a scene costs,
//! and how far off it is. A crate of its own, so that an FMU carries none of it.
//!
//! | file | what |
//! |---|---|
//! | [`experiment`] | the motion that all levels make, and the drive that makes it |
//! | [`setting`] | a level with its solver and step, and the price of counted work |
//! | [`library`] | a second solver, of a library, over the model's rates and events |
//! | [`timed`] | one of them run, counted and clocked |
//! | [`compared`] | results that are compared, and errors |
//! | [`trade`] | references that two codes agree on, errors, the front, the choice |
//! | [`parts`] | what each part of a scene gives and costs |
//! | [`realtime`] | communication steps by the clock, one by one |
//!
//! *Modelling* error is a level's own solution against that of the deepest level;
//! *numerical* error is a setting against the solution of its level. All but the
//! seconds of the clock is the same on every run.

#![forbid(unsafe_code)]

pub mod compared;
pub mod experiment;
pub mod library;
pub mod parts;
pub mod realtime;
pub mod setting;
pub mod timed;
pub mod trade;

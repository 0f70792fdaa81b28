//! What everything stands on: quantities with symbols and units, scalars, the recorder, keys of scenes, messages.

pub mod allowed;
pub mod beside;
pub mod calc;
pub mod check;
pub mod course;
mod courses;
pub mod diagnostic;
pub mod editing;
mod example;
pub mod gravity;
pub mod group;
pub mod json;
pub mod keys;
pub mod measure;
pub mod number;
pub mod origin;
mod powers;
pub mod record;
pub mod schema;
pub mod shared;
pub mod sign;
pub mod site;
pub mod symbol;
pub mod text;
pub mod unit;
pub mod variable;

//! The kinds of luffing mechanisms that something else may carry.

use std::sync::Arc;

use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::schema::{Key, Values};
use crate::kernel::symbol::Symbol;
use crate::luffing::aboard::Aboard;
use crate::luffing::double_link::aboard as double_link;

/// The table `[luffing]` beside what carries it.
pub const CARRIED: Key = Key::kinds(
    "luffing",
    &[("double_link", double_link::KEYS)],
    "The luffing mechanism of the crane, which gives reach and height of its head, and its weights.",
);

/// What is given of it.
pub const GIVEN: &[&Symbol] = double_link::GIVEN;

/// Of a checked table under the acceleration of gravity (m/s²), its bodies with inertias where it `moves`; mistakes go to `found`.
pub fn carried(v: &Values, gravity: f64, moves: bool, found: &mut Vec<Diagnostic>) -> Option<Arc<dyn Aboard>> {
    Some(Arc::new(double_link::LinkAboard::read(v, gravity, moves, found)?))
}

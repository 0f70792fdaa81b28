//! What a book tells of a led hoist rope.

use crate::component::outline::Explained::Stage;
use crate::component::outline::{Limit, SectionOutline};
use crate::luffing::led::symbols as s;

/// Where the rope runs, how the load rises by it, and what it does to the bars.
pub const LED: SectionOutline = (
    "led_rope",
    &[
        Stage("begun"),
        Stage("stretched"),
        Stage("led"),
        Stage("rising"),
        Stage("pulled"),
    ],
);

pub const LEVEL: Limit = Limit::at_most("led_level", &s::EPSILON_YQ);

//! The counterweight that makes the moment without load minus that with it.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::{One, quantities};
use crate::supports::column::symbols as s;
use crate::supports::upper::weights::UpperWorks;

quantities! {
    /// Where it would lie.
    EvenedAt { r_d: R_D }
}

/// Weight (N), and the moment that remains (N·m).
#[derive(Clone, Copy, Debug)]
pub struct Evened<C> {
    weight: C,
    moment: C,
}
results! { Evened as e => { G_D: e.weight; M_D: e.moment; } }

impl<C: Calc> Evened<C> {
    /// M_u − G_d r_d + Q R = −(M_u − G_d r_d): G_d = (M_u + Q R/2)/r_d, and Q R/2 remains. [Ports001, 3.2.1]
    pub fn new(balancing: &EvenedAt<C>, upper: &UpperWorks<C>, load: &One<C>, reach: &C) -> Evened<C> {
        let moment = (**load * *reach / C::constant(2.0)).def(&s::M_D);
        Evened {
            weight: ((upper.moment + moment) / balancing.r_d).def(&s::G_D),
            moment,
        }
    }
}

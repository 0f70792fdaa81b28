//! What is left of the groups' ranges.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::steering::frame::Ends;
use crate::steering::limits::Limits;
use crate::steering::symbols as s;
use crate::steering::wheels::Wheel;

/// What is left of all ranges together.
#[derive(Clone, Copy, Debug)]
pub struct Margin<C> {
    /// Smallest angle that is left to an end of a range, in rad; negative beyond it.
    margin: C,
    /// Whether every group can stand as commanded.
    pub reachable: bool,
}
results! { Margin as m => {
    MARGIN: m.margin;
    REACHABLE: C::constant(f64::from(m.reachable));
} }

impl<C: Calc> Margin<C> {
    pub fn new(wheels: &[Wheel<C>], limits: &[Limits], ends: &[Ends<C>]) -> Margin<C> {
        let each = wheels.iter().zip(limits).zip(ends);
        let left = each.map(|((wheel, limits), ends)| limits.margin(ends.0, wheel.theta));
        Margin {
            margin: left.reduce(C::smaller).expect("at least one group"),
            reachable: wheels.iter().all(|wheel| wheel.placed),
        }
    }
}

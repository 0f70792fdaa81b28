//! A toothed sector on the driving link, turned by a pinion on the frame.

use crate::drive::symbols as s;
use crate::kernel::calc::Calc;
use crate::kernel::group::quantities;
use crate::parts::plane::Point;

quantities! {
    /// Pitch radius (m) about the foot of the driving link, and the direction (rad) from there to the pinion.
    Sector { r_s: R_S, delta_s: DELTA_S }
}

impl<C: Calc> Sector<C> {
    /// Unit vector of the teeth's force that turns the driving link counter-clockwise: F_t = M / r_s along it, whatever the
    /// angle of the link. [Ports001, 5.3]
    pub fn along(&self) -> Point<C> {
        let (sin, cos) = self.delta_s.sin_cos();
        Point::new(-sin, cos)
    }
}

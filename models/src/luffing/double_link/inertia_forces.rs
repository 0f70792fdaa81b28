//! Weight and inertia of one body while the mechanism moves, in its plane. [Newton and Euler]

use crate::kernel::calc::Calc;
use crate::kernel::symbol::Symbol;
use crate::luffing::double_link::pose::PosedBody;
use crate::luffing::moving::shares::Instant;
use crate::parts::plane::{self, Point, cross};

impl<C: Calc> PosedBody<C> {
    /// Weight and inertia, in N.
    pub fn force(&self, at: &Instant<C>, gravity: C, names: [&'static Symbol; 2]) -> Point<C> {
        let force = weight_and_inertia(self.mass, self.travel, self.reach, at, gravity);
        plane::def(force, names)
    }

    /// Moment of this force and of the inertia about the centre, about the bar's first joint: clockwise positive, in N·m.
    pub fn moment(&self, at: &Instant<C>, force: Point<C>) -> C {
        let [turn, change] = self.turn;
        let spin = turn * at.alpha + change * at.omega.square();
        let moment = self.inertia * spin - cross(self.place, force);
        match at.turning {
            Some(turning) => moment + self.deviation * turning.square(),
            None => moment,
        }
    }
}

/// Of a mass (kg) that is forward of the slewing axis by `reach` (m), in N.
pub fn weight_and_inertia<C: Calc>(
    mass: C,
    [travel, bend]: [Point<C>; 2],
    reach: C,
    at: &Instant<C>,
    gravity: C,
) -> Point<C> {
    let square = at.omega.square();
    let mut forward = travel.x * at.alpha + bend.x * square;
    if let Some(turning) = at.turning {
        forward -= reach * turning.square();
    }
    let upward = travel.y * at.alpha + bend.y * square + gravity;
    Point::new(-(mass * forward), -(mass * upward))
}

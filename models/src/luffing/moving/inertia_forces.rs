//! Weight and inertia of one body while the mechanism moves, in its plane. [Newton and Euler]

use crate::kernel::calc::Calc;
use crate::kernel::symbol::Symbol;
use crate::luffing::moving::shares::Instant;
use crate::luffing::moving::symbols as s;
use crate::parts::plane::{self, Point, cross};

/// A body in its bar.
#[derive(Clone, Copy, Debug)]
pub struct PosedBody<C> {
    /// In kg, and about its centre of gravity in kg·m².
    pub mass: C,
    pub inertia: C,
    /// Its place among the mechanism's bars, and how high its first joint is (m).
    pub bar: usize,
    pub joint: C,
    /// Mass times forward and upward distance from the centre, in kg·m².
    pub deviation: C,
    /// Centre of gravity from the bar's first joint and, forward, from the slewing axis, in m.
    pub place: Point<C>,
    pub reach: C,
    /// Travel of the centre (m) and turning of the bar for one radian of the driving link, and how they change.
    pub travel: [Point<C>; 2],
    pub turn: [C; 2],
}

impl<C: Calc> PosedBody<C> {
    /// One that turns with the coordinate about a joint: its place among the bars and how high the joint is (m), mass (kg),
    /// inertia about its centre (kg·m²), place of the centre from the joint (m) and what it moves by, once and once more, all
    /// in a plane that does not turn.
    pub fn in_plane(
        (bar, joint): (usize, C),
        [mass, inertia]: [C; 2],
        place: Point<C>,
        travel: [Point<C>; 2],
    ) -> PosedBody<C> {
        let zero = C::constant(0.0);
        PosedBody {
            mass,
            inertia,
            bar,
            joint,
            deviation: zero,
            place,
            reach: zero,
            travel,
            turn: [C::constant(1.0), zero],
        }
    }

    /// Weight and inertia, with the wind where it blows, in N.
    pub fn force(&self, at: &Instant<C>, gravity: C, names: [&'static Symbol; 2]) -> Point<C> {
        let mut force = weight_and_inertia(self.mass, self.travel, self.reach, at, gravity);
        if let Some([push, _]) = at.blown(self.bar) {
            force.x += push;
        }
        plane::def(force, names)
    }

    /// Moment of this force and of the inertia about the centre, about the bar's first joint: clockwise positive, in N·m.
    pub fn moment(&self, at: &Instant<C>, force: Point<C>) -> C {
        let [turn, change] = self.turn;
        let spin = turn * at.alpha + change * at.omega.square();
        let mut moment = self.inertia * spin - cross(self.place, force);
        if let Some([push, about]) = at.blown(self.bar) {
            // The wind is not where the weight is.
            moment += (about - push * (self.joint + self.place.y)).def(s::OF_WIND[self.bar]);
        }
        match at.turning {
            Some(turning) => moment + self.deviation * turning.square(),
            None => moment,
        }
    }
}

/// Of a mass (kg), on a slope too, that is forward of the slewing axis by `reach` (m), in N.
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
    let mut gravity = gravity;
    if let Some(pushed) = &at.pushed {
        forward -= pushed.lean.x;
        gravity = pushed.gravity;
    }
    let upward = travel.y * at.alpha + bend.y * square + gravity;
    Point::new(-(mass * forward), -(mass * upward))
}

/// With a load below the head that does not swing (kg), where it is and how it moves (m), this far forward of the slewing axis (m): it
/// hangs by its whole weight, whatever way that leans.
pub fn hanging<C: Calc>(
    at: Instant<C>,
    (mass, [_, travel, bend]): (C, [Point<C>; 3]),
    reach: C,
    gravity: C,
) -> Instant<C> {
    let pull = weight_and_inertia(mass, [travel, bend], reach, &at, gravity);
    let pull = plane::def(pull, [&s::F_AX, &s::F_AY]);
    let plumb = at.pushed.map_or(-pull.y, |pushed| mass * pushed.lean.y - pull.y);
    Instant {
        pull: Some(pull),
        tension: Some(plumb),
        ..at
    }
}

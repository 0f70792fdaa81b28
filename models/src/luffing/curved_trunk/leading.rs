//! Boom and trunk as they lead the hoist rope, and what that does to the load. [Ports001, 5.9.2.4]

use crate::component::stages::Found;
use crate::kernel::calc::{Calc, Over};
use crate::luffing::curved_trunk::contact::Contact;
use crate::luffing::curved_trunk::position::TrunkPosition;
use crate::luffing::curved_trunk::symbols as s;
use crate::luffing::curved_trunk::tail::{TrunkChoice, TrunkTail};
use crate::luffing::curved_trunk::velocity::{TrunkBend, TrunkTravel};
use crate::luffing::led::moving::LedMoves;
use crate::luffing::led::pull::Hauled;
use crate::luffing::led::reeved::Reeved;
use crate::luffing::led::stretch::LedBars;
use crate::luffing::moving::built::HoistParts;
use crate::luffing::moving::hoisting::{HoistFalls, HoistMotor, HoistRamp, RopeGive};
use crate::luffing::moving::symbols as m;
use crate::parts::plane::{self, Point};

/// The bar that carries the head.
pub const TRUNK: usize = 1;

/// Boom and trunk at the boom's angle (rad), and the trunk's head.
pub fn leads<C: Calc>(position: &TrunkPosition<C>, travel: &TrunkTravel<C>, phi: &C) -> LedBars<C> {
    let (zero, (sin, cos), b) = (C::constant(0.0), phi.sin_cos(), position.b);
    let foot = Point::new(zero, zero);
    let trunk = ([b, position.along], (Point::new(-b.y, b.x), travel.i_2));
    LedBars {
        at: [[foot, Point::new(cos, sin)], trunk.0, trunk.0],
        moves: [(foot, C::constant(1.0)), trunk.1, trunk.1],
        head: position.a,
        travel: travel.a,
        carries: TRUNK,
    }
}

/// The same at the start of the working range.
///
/// # Errors
/// A tie that does not reach there.
pub fn beginning<C: Calc>(tail: &TrunkTail<C>, choice: &TrunkChoice) -> Found<LedBars<C>> {
    C::aside(|| {
        let from = C::known(&s::FROM, choice.range.from);
        let position = TrunkPosition::new(tail, &Contact::new(tail, choice, &from)?);
        Ok(leads(&position, &TrunkTravel::new(&position), &from))
    })
}

/// Its hoist: a drum feels the load through the falls of the tackle, those of a rope that is led where there is one.
pub fn hoist<C: Calc>(
    ramp: &Option<HoistRamp<C>>,
    motor: &Option<HoistMotor<C>>,
    give: &Option<RopeGive<C>>,
    falls: &Option<HoistFalls<C>>,
    reeved: Option<&Reeved<C>>,
) -> HoistParts<C> {
    HoistParts::new(ramp, motor, give, falls).led(reeved.map(|led| led.falls.m_h))
}

/// Its power (N·m) for one radian of the boom: the trunk turns about its instantaneous centre, or moves along with B.
/// [Ports001, 5.9.2.4]
pub fn power<C: Calc>(
    position: &TrunkPosition<C>,
    travel: &TrunkTravel<C>,
    pole: &Point<C>,
    [boom, trunk, _]: &[Hauled<C>; 3],
) -> C {
    let b = position.b;
    let of_trunk = if travel.at_infinity() {
        plane::dot(trunk.force, Point::new(-b.y, b.x))
    } else {
        travel.i_2 * (trunk.moment + plane::cross(b - *pole, trunk.force))
    };
    boom.moment + of_trunk
}

/// Boom and trunk at one angle, and how they move.
type Bent<'a, C> = (&'a TrunkPosition<C>, &'a TrunkTravel<C>, &'a TrunkBend<C>);

/// The head with its travel and how that changes, in m.
pub fn bent_head<C: Calc>((position, travel, bend): Bent<C>) -> [Point<C>; 3] {
    let change = bend.of_point(position, travel, position.front);
    [position.a, travel.a, plane::def(change, [&m::DDA_X, &m::DDA_Y])]
}

/// What the rope does over sheaves on boom, which turns about its foot, and trunk, at the boom's angle (rad).
pub fn moves<P: Calc, C: Over<P>>(
    reeved: &Reeved<P>,
    phi: C,
    (position, travel, bend): Bent<C>,
    head: [Point<C>; 3],
) -> Option<LedMoves<C>> {
    let (sin, cos) = phi.sin_cos();
    let point = |bar: usize, at: Point<P>| {
        let (x, y) = (C::of(at.x), C::of(at.y));
        if bar == TRUNK {
            let from = plane::turned(position.along, x, y);
            return [
                position.b + from,
                travel.of_point(position, from),
                bend.of_point(position, travel, from),
            ];
        }
        let place = plane::turned(Point::new(cos, sin), x, y);
        [place, Point::new(-place.y, place.x), -place]
    };
    reeved.moves((TRUNK, head), point)
}

//! Boom and trunk as they lead the hoist rope, and what that does to the load. [Ports001, 5.9.2.4]

use crate::component::stages::Found;
use crate::kernel::calc::Calc;
use crate::luffing::curved_trunk::contact::Contact;
use crate::luffing::curved_trunk::position::TrunkPosition;
use crate::luffing::curved_trunk::symbols as s;
use crate::luffing::curved_trunk::tail::{TrunkChoice, TrunkTail};
use crate::luffing::curved_trunk::velocity::TrunkTravel;
use crate::luffing::led::pull::Hauled;
use crate::luffing::led::stretch::LedBars;
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

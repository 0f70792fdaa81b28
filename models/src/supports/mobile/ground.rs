//! Where the ground bears the crane.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::parts::plane::{self, Point};
use crate::supports::mobile::symbols as s;
use crate::supports::mobile::tipping::Sides;
use crate::supports::mobile::weights::{DeadWeight, Leaning, Payload};

/// The ground's force on all supports, and where it acts.
#[derive(Clone, Copy, Debug)]
pub struct GroundForce<C> {
    pub force: C,
    pub place: Point<C>,
    margin: C,
}
results! { GroundForce as r => { V: r.force; X_V: r.place.x; Y_V: r.place.y; A: r.margin; } }

impl<C: Calc> GroundForce<C> {
    /// x_V = (M_c + (M_e + Q R_E) e) / (V_0 + Q).
    pub fn new(
        sides: &Sides<C>,
        heading: &Point<C>,
        dead: &DeadWeight<C>,
        leaning: &Leaning<C>,
        payload: &Payload<C>,
    ) -> GroundForce<C> {
        let place = GroundForce::place(heading, dead, leaning, payload.hung);
        let left = sides.0.iter().map(|side| side.away - plane::dot(side.out, place));
        GroundForce {
            force: ((dead.weight + payload.hung) * leaning.upright).def(&s::V),
            margin: left.reduce(C::smaller).expect("three sides at least"),
            place: plane::def(place, [&s::X_V, &s::Y_V]),
        }
    }

    /// Under a load (N), in m.
    pub fn place(heading: &Point<C>, dead: &DeadWeight<C>, leaning: &Leaning<C>, load: C) -> Point<C> {
        let along = leaning.moment + load * leaning.reach;
        let weight = dead.weight + load;
        Point::new(
            (dead.carrier.x + along * heading.x) / weight,
            (dead.carrier.y + along * heading.y) / weight,
        )
    }
}

//! The machine's motion at a travel speed, and how fast its groups turn with the command.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::parts::plane::{self, Point};
use crate::steering::centre::Centre;
use crate::steering::commanding::CentreShift;
use crate::steering::machine::{Axis, Machine};
use crate::steering::symbols as s;
use crate::steering::wheels::{Rolling, Scale};

/// Angular velocity of the machine, in rad/s, counter-clockwise positive.
#[derive(Clone, Copy, Debug)]
pub struct Turn<C>(pub C);
results! { Turn as w => { OMEGA: w.0; } }

impl<C: Calc> Turn<C> {
    pub fn new(centre: &Centre<C>, scale: &Scale<C>) -> Turn<C> {
        let turning = centre.turning().map(|w| (w * scale.0).def(&s::OMEGA));
        Turn(turning.unwrap_or(C::constant(0.0)))
    }
}

/// Velocity of the machine's middle, in m/s.
#[derive(Clone, Copy, Debug)]
pub struct Travel<C>(pub Point<C>);
results! { Travel as v => {
    V_MX: v.0.x;
    V_MY: v.0.y;
} }

impl<C: Calc> Travel<C> {
    pub fn new(machine: &Machine<C>, centre: &Centre<C>, scale: &Scale<C>) -> Travel<C> {
        let along = centre.rolling(machine.middle);
        let velocity = Point::new(along.x * scale.0, along.y * scale.0);
        Travel(plane::def(velocity, [&s::V_MX, &s::V_MY]))
    }
}

/// Rate of a group's angle, in rad/s, while the commanded angle moves at the steering speed; zero where no angle
/// commands.
#[derive(Clone, Copy, Debug)]
pub struct Rate<C>(pub C);
results! { each Rate as w => { OMEGA_I: w.0; } }

/// Angle by which a group turns for one radian of the commanded angle, from its rolling direction and the change of
/// that. Zero for a group on the centre, whose angle stays.
#[inline]
pub fn rate<C: Calc>(along: Point<C>, change: Point<C>) -> C {
    let square = plane::dot(along, along);
    if square.value() == 0.0 {
        return C::constant(0.0);
    }
    plane::cross(along, change) / square
}

impl<C: Calc> Rate<C> {
    /// At a steering speed in rad/s.
    pub fn new(axis: &Axis<C>, rolling: &Rolling<C>, slope: &CentreShift<C>, omega_s: &C) -> Rate<C> {
        let Some(slope) = &slope.0 else {
            // There is none where there is no centre.
            return Rate(C::constant(0.0).over(rolling.length));
        };
        let change = slope.rolling(axis.point());
        let change = match slope.is_far() {
            true => change,
            false => plane::def(change, [&s::UD_X, &s::UD_Y]),
        };
        Rate((rate(rolling.along, change) * *omega_s).def(&s::OMEGA_I))
    }
}

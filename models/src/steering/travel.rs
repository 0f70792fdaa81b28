//! The machine's motion at a travel speed, and how fast its groups turn with the command.

use crate::kernel::calc::Calc;
use crate::parts::plane::{self, Point};
use crate::steering::centre::Centre;
use crate::steering::machine::{Axis, Machine};
use crate::steering::symbols as s;
use crate::steering::wheels::Rolling;

/// Angular velocity of the machine, in rad/s, counter-clockwise positive.
pub fn turn<C: Calc>(centre: &Centre<C>, scale: &C) -> C {
    let turning = centre.turning().map(|w| (w * *scale).def(&s::OMEGA));
    turning.unwrap_or(C::constant(0.0))
}

/// Velocity of the machine's middle, in m/s.
pub fn middle<C: Calc>(machine: &Machine<C>, centre: &Centre<C>, scale: &C) -> Point<C> {
    let along = centre.rolling(machine.middle);
    let velocity = Point::new(along.x * *scale, along.y * *scale);
    plane::def(velocity, [&s::V_MX, &s::V_MY])
}

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

/// Rate of a group's angle, in rad/s, while the commanded angle moves at a steering speed (rad/s); zero where no angle
/// commands.
pub fn steering<C: Calc>(axis: &Axis<C>, rolling: &Rolling<C>, slope: &Option<Centre<C>>, omega_s: &C) -> C {
    let Some(slope) = slope else {
        // There is none where there is no centre.
        return C::constant(0.0).over(rolling.length);
    };
    let change = slope.rolling(axis.point());
    let change = match slope.is_far() {
        true => change,
        false => plane::def(change, [&s::UD_X, &s::UD_Y]),
    };
    (rate(rolling.along, change) * *omega_s).def(&s::THETA_DOT)
}

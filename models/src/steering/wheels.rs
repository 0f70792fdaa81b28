//! Angles and speeds of the groups for a turning centre. No allocation.

use crate::calc::Calc;
use crate::plane::{self, Point};
use crate::steering::machine::Limits;
use crate::steering::mode::Centre;
use crate::steering::symbols as s;

/// One steered group.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wheel<C> {
    /// Heading from straight ahead, counter-clockwise, in rad.
    pub theta: C,
    /// Cosine and sine of the heading.
    pub turn: Point<C>,
    /// Rolling speed along the heading, in m/s; negative rolls backwards.
    pub v: C,
}

/// The machine's motion at a travel speed.
#[derive(Clone, Copy, Debug)]
pub struct Travel<C> {
    /// Angular velocity of the machine, in rad/s, counter-clockwise positive;
    /// `None` where its centre is at infinity.
    pub omega: Option<C>,
    /// Velocity of the machine's middle, in m/s.
    pub middle: Point<C>,
}

/// Angles and speeds of all groups so that nothing slips: every axle line passes
/// through the centre. [Zhang2016, eq. 1-9, for any layout]
///
/// `v` is the speed of the fastest group, in m/s; positive travels forward. No
/// group is ever faster, and the speed of straight travel is the machine's own.
/// Angles come in (−π/2, π/2]; [`place`] finds those that the groups can reach.
/// A group on the turning centre stands still and keeps the angle of `hold`.
///
/// # Panics
/// Where the slices differ in length.
#[inline]
pub fn roll<C: Calc>(
    groups: &[Point<C>],
    middle: Point<C>,
    centre: &Centre<C>,
    v: C,
    hold: &[C],
    wheels: &mut [Wheel<C>],
) -> Travel<C> {
    assert!(
        groups.len() == wheels.len() && hold.len() == wheels.len(),
        "one of each for every group"
    );
    let mut fastest: Option<C> = None;
    for (p, wheel) in groups.iter().zip(wheels.iter_mut()) {
        wheel.turn = centre.rolling(*p);
        wheel.v = plane::length(wheel.turn);
        fastest = Some(fastest.map_or(
            wheel.v,
            |best| if wheel.v.value() > best.value() { wheel.v } else { best },
        ));
    }
    let scale = v / fastest.expect("at least one group");
    for (wheel, &hold) in wheels.iter_mut().zip(hold) {
        *wheel = one(wheel.turn, wheel.v, scale, hold);
    }
    let middle = centre.rolling(middle);
    Travel {
        omega: centre.turning().map(|w| (w * scale).def(&s::OMEGA)),
        middle: plane::def(Point::new(middle.x * scale, middle.y * scale), [&s::V_MX, &s::V_MY]),
    }
}

/// One group from its rolling direction and the length of that; `scale` is the
/// travel speed over the greatest length of all groups.
#[inline]
pub fn one<C: Calc>(along: Point<C>, length: C, scale: C, hold: C) -> Wheel<C> {
    if length.value() == 0.0 {
        let (sin, cos) = hold.sin_cos();
        return Wheel {
            theta: hold,
            turn: Point::new(cos, sin),
            v: length * scale,
        };
    }
    let backwards = along.x.value() < 0.0 || (along.x.value() == 0.0 && along.y.value() < 0.0);
    let (along, v) = if backwards { (-along, -length) } else { (along, length) };
    Wheel {
        theta: C::direction(along.x, along.y).def(&s::THETA),
        turn: plane::def(Point::new(along.x / length, along.y / length), [&s::C_I, &s::S_I]),
        v: (v * scale).def(&s::V),
    }
}

/// Angle by which the group at `p` turns for one radian of the commanded angle,
/// from the centre and its [slope](crate::steering::mode::Mode::slope). Zero for a
/// group on the centre, whose angle stays.
#[inline]
pub fn rate<C: Calc>(centre: &Centre<C>, slope: &Centre<C>, p: Point<C>) -> C {
    let (along, change) = (centre.rolling(p), slope.rolling(p));
    let square = plane::dot(along, along);
    if square.value() == 0.0 {
        return C::constant(0.0);
    }
    plane::cross(along, change) / square
}

/// Turns each group over, by half a turn, where only that brings it into its
/// range. Returns the first group that cannot stand on its axle line at all; such
/// a group keeps its angle.
///
/// # Panics
/// Where the slices differ in length.
#[inline]
pub fn place<C: Calc>(limits: &[Limits], wheels: &mut [Wheel<C>]) -> Result<(), usize> {
    assert!(limits.len() == wheels.len(), "one of each for every group");
    let mut obstacle = Ok(());
    for (i, (wheel, limits)) in wheels.iter_mut().zip(limits).enumerate() {
        let theta = wheel.theta.value();
        if limits.allows(theta) {
            continue;
        }
        let Some(at) = limits.equivalents(theta).next() else {
            obstacle = obstacle.and(Err(i));
            continue;
        };
        let half = std::f64::consts::PI;
        wheel.theta += C::constant(half.copysign(at - theta));
        wheel.turn = -wheel.turn;
        wheel.v = -wheel.v;
    }
    obstacle
}

/// Distance, in m, at which the axle line of a group at `p` with heading `theta`
/// (rad) passes the turning centre; positive where the group must turn
/// counter-clockwise to meet it. A centre beyond 1 km, where axle lines are
/// parallel to the eye, counts at 1 km in its direction.
#[must_use]
pub fn residual(centre: &Centre<f64>, p: Point<f64>, theta: f64) -> f64 {
    const HORIZON: f64 = 1e3;
    let along = centre.rolling(p);
    let (sin, cos) = Calc::sin_cos(theta);
    let (astray, reach) = (plane::cross(Point::new(cos, sin), along), plane::length(along));
    if reach == 0.0 {
        return 0.0;
    }
    // A heading against the rolling direction has the same axle line.
    let astray = astray * plane::dot(Point::new(cos, sin), along).signum();
    let w = centre.turning().unwrap_or(0.0).abs();
    if reach <= HORIZON * w {
        astray / w
    } else {
        astray / reach * HORIZON
    }
}

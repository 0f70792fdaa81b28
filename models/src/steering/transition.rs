//! From one stance of the groups to another: path, time, and whether the machine
//! can travel meanwhile. No allocation.
//!
//! While the turning centre goes along one line through infinity or past the
//! machine, all axle lines meet in it and the machine may travel. Where that would
//! turn a group out of its range, through a forbidden range, or about a group
//! whose angle then jumps, the machine must stand and every cylinder runs straight
//! to its new length, all arriving together.

use std::f64::consts::PI;

use crate::kernel::calc::Calc;
use crate::kernel::group::quantities;
use crate::parts::plane::{self, Point};
use crate::steering::centre::Centre;
use crate::steering::cylinder::Linkage;
use crate::steering::machine::Machine;
use crate::steering::symbols as s;

/// Two angles of a stance are one below this, in rad.
pub const SAME_STANCE: f64 = 1e-9;

quantities! {
    /// Speed limit of the cylinders, in m/s.
    Pace { speed: V_C_MAX }
}

/// The motion of a machine about its turning centre as a unit vector: velocity of
/// the middle, angular velocity times the machine's size.
pub type Twist = [f64; 3];

/// The way from one direction of the motion to another, on the great circle through both.
#[derive(Clone, Copy, Debug)]
pub struct GreatCircle {
    from: Twist,
    /// At a right angle to it.
    towards: Twist,
    /// In rad.
    pub whole: f64,
    /// Of the machine.
    middle: Point<f64>,
    size: f64,
}

impl GreatCircle {
    /// `None` between opposite directions: there is no shortest way.
    #[must_use]
    pub fn new(machine: &Machine<f64>, [a, b]: [Twist; 2]) -> Option<GreatCircle> {
        let dot: f64 = (0..3).map(|i| a[i] * b[i]).sum();
        let across: Twist = std::array::from_fn(|i| b[i] - dot * a[i]);
        let apart = across.iter().map(|x| x * x).sum::<f64>().sqrt();
        if apart < SAME_STANCE && dot < 0.0 {
            return None;
        }
        let whole = if apart < SAME_STANCE {
            0.0
        } else {
            f64::direction(dot, apart)
        };
        Some(GreatCircle {
            from: a,
            towards: across.map(|x| if whole == 0.0 { 0.0 } else { x / apart }),
            whole,
            middle: machine.middle,
            size: machine.size(),
        })
    }

    #[must_use]
    pub fn centre(&self, motion: Twist) -> Centre<f64> {
        about(self.middle, self.size, motion)
    }

    #[must_use]
    pub fn at(&self, part: f64) -> Twist {
        let (sin, cos) = Calc::sin_cos(part * self.whole);
        std::array::from_fn(|i| cos * self.from[i] + sin * self.towards[i])
    }

    /// Angle of the group at `p` about a centre on the way from an angle `start`, in rad, and how far its cylinder's
    /// length changes with one radian of the arc, in m.
    #[must_use]
    pub fn on(&self, p: Point<f64>, linkage: &Linkage<f64>, centre: &Centre<f64>, start: f64) -> (f64, f64) {
        let (first, across) = (self.centre(self.from).rolling(p), self.centre(self.towards).rolling(p));
        let along = centre.rolling(p);
        let square = plane::dot(along, along);
        if square == 0.0 {
            return (start, 0.0);
        }
        // On less than half a great circle the heading turns one way, and by less than half a turn.
        let turn = if first == Point::zeros() {
            0.0
        } else {
            wrapped(f64::direction(plane::dot(first, along), plane::cross(first, along)))
        };
        let heading = f64::direction(along.x, along.y);
        let theta = heading + PI * ((start + turn - heading) / PI).round();
        let od = linkage.at_angle(theta).od;
        (theta, (od * plane::cross(first, across) / square).abs())
    }
}

impl Machine<f64> {
    /// The motion about a centre.
    #[must_use]
    pub fn motion(&self, centre: &Centre<f64>) -> Twist {
        let middle = centre.rolling(self.middle);
        let turn = centre.turning().unwrap_or(0.0) * self.size();
        let norm = (middle.x * middle.x + middle.y * middle.y + turn * turn).sqrt();
        [middle.x / norm, middle.y / norm, turn / norm]
    }

    /// The turning centre of a motion.
    #[must_use]
    pub fn about(&self, motion: Twist) -> Centre<f64> {
        about(self.middle, self.size(), motion)
    }
}

/// After this, in s, every cylinder has had the time to go through all its lengths after all others at this speed (m/s):
/// no change that is possible takes longer.
#[must_use]
pub fn longest(linkages: &[Linkage<f64>], speed: f64) -> f64 {
    let stroke = |linkage: &Linkage<f64>| 2.0 * plane::length(linkage.c) / speed;
    2.0 * linkages.iter().map(stroke).sum::<f64>()
}

fn about(middle: Point<f64>, size: f64, motion: Twist) -> Centre<f64> {
    Centre::Beyond {
        from: middle,
        d: Point::new(-motion[1], motion[0]),
        w: motion[2] / size,
    }
}

/// An angle in (−π, π].
fn wrapped(angle: f64) -> f64 {
    if angle > PI { angle - 2.0 * PI } else { angle }
}

//! Equations of motion of a crane that slews, with its load on a rope that swings in all directions.
//!
//! Everything stands in the frame that slews with the crane: x forward in the
//! plane of the mechanism, y up, z to the left, where a growing angle psi turns
//! x. The load's place is that of a point seen from the head, not two angles of
//! the rope: no direction of the rope is singular, not even straight up or
//! sideways. While the rope is taut its length is a constraint, and the rope's
//! force the multiplier that keeps it. [Lagrange, first kind]
//!
//! The mechanism enters by what [`Reduced`] holds, all of it by differentiation:
//! T = ½ I(theta) omega² + ½ J(theta) omega_psi², with their slopes, height and
//! place of the head. A thin mechanism that slews moves across its own plane, so
//! that both angular velocities do not couple but through the slopes.

use nalgebra::Vector3;

use crate::kernel::calc::Calc;
use crate::kernel::symbol::Symbol;
use crate::luffing::double_link::dynamics::{Coordinate, Dynamics, Reduced};
use crate::luffing::double_link::moving::symbols as s;
use crate::parts::hoist::RopeAction;

/// Accelerations of the joints (rad/s²) and of the load from the head in the frame that slews (m/s²), and the
/// force of the rope (N); `slackening` has its sign, that of an empty hook too.
#[derive(Clone, Copy, Debug)]
pub struct Accelerations<C> {
    pub joints: [C; 2],
    pub load: Vector3<C>,
    pub rope: C,
    pub slackening: C,
}

/// The load at one instant: place and rate from the head, in the frame that slews.
#[derive(Clone, Copy, Debug)]
pub struct HangingLoad<C> {
    pub place: Vector3<C>,
    pub rate: Vector3<C>,
}

/// Turned by a right angle about the slewing axis: what a point moves by when the crane slews by one.
pub(crate) fn turned<C: Calc>(v: Vector3<C>) -> Vector3<C> {
    Vector3::new(-v.z, C::constant(0.0), v.x)
}

pub(crate) fn dot<C: Calc>(a: Vector3<C>, b: Vector3<C>) -> C {
    a.x * b.x + a.y * b.y + a.z * b.z
}

pub(crate) fn squared<C: Calc>(v: Vector3<C>) -> C {
    v.x.square() + v.y.square() + v.z.square()
}

/// Names the components.
fn named<C: Calc>(v: Vector3<C>, [x, y, z]: [&'static Symbol; 3]) -> Vector3<C> {
    Vector3::new(v.x.def(x), v.y.def(y), v.z.def(z))
}

fn scaled<C: Calc>(v: Vector3<C>, by: C) -> Vector3<C> {
    v.map(|x| x * by)
}

/// Distance of the load from the head (m), and its direction.
pub(crate) fn to_load<C: Calc>(place: Vector3<C>) -> (C, Vector3<C>) {
    let length = squared(place).sqrt().def(&s::S_Q);
    (length, named(place.map(|x| x / length), [&s::N_X, &s::N_Y, &s::N_Z]))
}

/// Where the rope points, and what it moves: the head's displacement by each joint, and how much of it
/// goes along the rope.
pub(crate) struct Rope<C> {
    pub length: C,
    pub direction: Vector3<C>,
    pub arms: [C; 2],
}

impl<C: Calc> Rope<C> {
    pub fn new(place: Vector3<C>, head: &[Vector3<C>; 2]) -> Rope<C> {
        let (length, direction) = to_load(place);
        let [luffing, slewing] = head.map(|by| dot(direction, by));
        Rope {
            length,
            direction,
            arms: [luffing.def(&s::H_1R), slewing.def(&s::H_2R)],
        }
    }
}

impl<C: Calc> Rope<C> {
    /// Force over the load's mass (m/s²) that keeps it at the rope's end: it moves at a rate (m/s), and would fall with
    /// `fall` (m/s²) from joints which accelerate so without the rope, each with one over its inertia where it is free.
    fn keeping(
        &self,
        line: RopeAction<C>,
        rate: Vector3<C>,
        fall: Vector3<C>,
        mass: C,
        (alone, ease): ([C; 2], [C; 2]),
    ) -> C {
        let mut need = dot(self.direction, fall);
        let mut give = C::constant(1.0);
        if let RopeAction::Taut {
            rate: hoist,
            gain,
            drum,
        } = line
        {
            // Away from the head by the speed across the rope; the joints give way to the rope's force.
            let speed = squared(rate) - hoist.square();
            need += speed / self.length;
            if let Some(gain) = gain {
                need -= gain;
            }
            if let Some([drum, pull]) = drum {
                need += pull / drum;
                give += mass / drum;
            }
        }
        for i in 0..2 {
            need -= self.arms[i] * alone[i];
            give += mass * self.arms[i].square() * ease[i];
        }
        need.def(&s::A_N) / give.def(&s::KAPPA_R)
    }
}

impl<C: Calc> HangingLoad<C> {
    /// On a taut rope: away from the head exactly as fast as the rope is paid out. The rate along the rope
    /// that numbers carry besides is left alone by the equations, so that it cannot grow.
    pub(crate) fn on_rope(self, rope: &Rope<C>, hoist: C) -> HangingLoad<C> {
        let excess = (dot(rope.direction, self.rate) - hoist).def(&s::V_E);
        let rate = self.rate - scaled(rope.direction, excess);
        HangingLoad {
            rate: named(rate, [&s::W_X, &s::W_Y, &s::W_Z]),
            ..self
        }
    }
}

impl<P: Calc> Dynamics<P> {
    /// How the head moves with each joint, in the frame that slews, in m.
    pub(crate) fn head<C: Coordinate<P>>(&self, r: &Reduced<C>) -> [Vector3<C>; 2] {
        let zero = C::constant(0.0);
        let [a, d, _] = r.head;
        let axis = self.turntable().map_or(zero, |table| C::of(table.axis));
        [Vector3::new(d.x, d.y, zero), Vector3::new(zero, zero, a.x - axis)]
    }

    /// Motion under moments on both joints (N·m) at rates of the joints (rad/s), of those that are free; the load only
    /// where there is one on a rope, which acts on it as a line.
    pub fn slewed<C: Coordinate<P>>(
        &self,
        r: &Reduced<C>,
        [omega, turning]: [C; 2],
        load: HangingLoad<C>,
        moments: [C; 2],
        line: RopeAction<C>,
        free: [bool; 2],
    ) -> Accelerations<C> {
        let (zero, half, two) = (C::constant(0.0), C::constant(0.5), C::constant(2.0));
        let [inertia, slope] = r.turn;
        let forces = [
            (moments[0] - r.moment - half * r.slope * omega.square() + half * slope * turning.square()).def(&s::M_NET),
            (moments[1] - slope * omega * turning).def(&s::M_NET_SL),
        ];
        let ease = |i: usize, inertia: C| {
            if free[i] { C::constant(1.0) / inertia } else { zero }
        };
        let ease = [ease(0, r.inertia), ease(1, inertia)];
        let alone = [
            (forces[0] * ease[0]).def(&s::ALPHA_0),
            (forces[1] * ease[1]).def(&s::ALPHA_0SL),
        ];
        let Some(pendulum) = self.bodies().pendulum else {
            return Accelerations {
                joints: alone,
                load: Vector3::new(zero, zero, zero),
                rope: zero,
                slackening: zero,
            };
        };
        let head = self.head(r);
        let rope = match line {
            RopeAction::Slack => None,
            RopeAction::Taut { .. } | RopeAction::Force(_) => Some(Rope::new(load.place, &head)),
        };
        let load = match (&rope, line) {
            (Some(rope), RopeAction::Taut { rate, .. }) => load.on_rope(rope, rate),
            _ => load,
        };
        // From the slewing axis; how high does not matter to what slewing does.
        let from_axis = load.place + Vector3::new(head[1].z, zero, zero);
        let from_axis = Vector3::new(from_axis.x.def(&s::R_QX), from_axis.y, from_axis.z);
        let rate = load.rate + scaled(head[0], omega);
        let rate = Vector3::new(rate.x.def(&s::U_X), rate.y.def(&s::U_Y), rate.z);
        let [_, _, dd] = r.head;
        let bend = Vector3::new(dd.x, dd.y, zero);
        let coriolis = scaled(turned(rate), two * turning);
        let centripetal = scaled(turned(turned(from_axis)), turning.square());
        let gravity = Vector3::new(zero, -C::of(self.bodies().gravity), zero);
        // Of the free load, seen from a head whose joints keep their rates.
        let fall = gravity - scaled(bend, omega.square()) - coriolis - centripetal;
        let fall = named(fall, [&s::B_X, &s::B_Y, &s::B_Z]);
        let mass = C::of(pendulum.mass);
        let (joints, pull) = match &rope {
            None => (alone, zero),
            Some(rope) => {
                let pull = match line {
                    RopeAction::Force(force) => force / mass,
                    _ => rope.keeping(line, load.rate, fall, mass, (alone, ease)),
                };
                let pull = pull.def(&s::A_R);
                let joint = |i: usize, symbol| (alone[i] + mass * pull * rope.arms[i] * ease[i]).def(symbol);
                ([joint(0, self.acceleration()), joint(1, &s::D_OMEGA_SL)], pull)
            }
        };
        let mut relative = fall - scaled(head[0], joints[0]) - scaled(turned(from_axis), joints[1]);
        if let Some(rope) = &rope {
            relative -= scaled(rope.direction, pull);
        }
        Accelerations {
            joints,
            load: named(relative, [&s::D_V_QX, &s::D_V_QY, &s::D_V_QZ]),
            rope: match line {
                RopeAction::Force(force) => force,
                _ => (mass * pull).def(&s::S_R),
            },
            slackening: C::of(pendulum.cancelling()) * pull,
        }
    }
}

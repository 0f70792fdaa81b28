//! How a machine's groups stand and roll about a turning centre: the stages' own equations, without a scene.

use lemnis_models::kernel::calc::Calc;
use lemnis_models::parts::plane::Point;
use lemnis_models::steering::centre::Centre;
use lemnis_models::steering::limits::Limits;
use lemnis_models::steering::machine::{Axis, Footprint, Machine};
use lemnis_models::steering::travel::{self, turn};
use lemnis_models::steering::wheels::{Rolling, Wheel, scale, speed};

/// One steered group.
#[derive(Clone, Copy, Debug)]
pub struct Rolled<C> {
    /// Heading, in rad, with its cosine and sine.
    pub theta: C,
    pub turn: Point<C>,
    /// Rolling speed, in m/s.
    pub v: C,
    /// Whether its range allows the heading.
    pub placed: bool,
}

/// The machine's motion: angular velocity (rad/s) and velocity of its middle (m/s).
#[derive(Clone, Copy, Debug)]
pub struct Motion<C> {
    pub omega: C,
    pub middle: Point<C>,
}

pub fn axes<C: Calc>(points: &[Point<C>]) -> Vec<Axis<C>> {
    points.iter().map(|p| Axis { x: p.x, y: p.y }).collect()
}

/// A machine that reaches as far as its groups.
pub fn plain<C: Calc>(points: &[Point<C>]) -> Machine<C> {
    Machine::new(&axes(points), &Footprint(None)).expect("apart")
}

/// Ranges that allow every heading.
pub fn free(n: usize) -> Vec<Limits> {
    let half = std::f64::consts::PI;
    vec![Limits::new(-half, half, Vec::new()).expect("a whole turn"); n]
}

/// All groups within their ranges at a travel speed of `v`, in m/s.
pub fn rolled<C: Calc>(
    machine: &Machine<C>,
    limits: &[Limits],
    centre: &Centre<C>,
    v: C,
) -> (Vec<Rolled<C>>, Motion<C>) {
    let rollings: Vec<_> = axes(&machine.groups)
        .iter()
        .map(|axis| Rolling::new(centre, axis))
        .collect();
    let scale = scale(centre, &rollings, &v);
    let one = |(rolling, limits)| {
        let wheel = Wheel::new(rolling, limits);
        Rolled {
            theta: wheel.theta,
            turn: wheel.turn,
            v: speed(rolling, &wheel, &scale),
            placed: wheel.placed,
        }
    };
    let motion = Motion {
        omega: turn(centre, &scale),
        middle: travel::middle(machine, centre, &scale),
    };
    (rollings.iter().zip(limits).map(one).collect(), motion)
}

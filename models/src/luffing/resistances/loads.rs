//! What acts on each body of a mechanism in a case, for the forces in its pins.

use crate::balance::residual::Residual;
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::luffing::moving::bodies::deviation;
use crate::luffing::resistances::given::{Case, CaseBody, CasesChoice};
use crate::luffing::resistances::moments::Resisted;
use crate::luffing::resistances::placed::{BARS, MovedBars};
use crate::parts::plane::{Point, cross, dot};

/// Forces in N and moments in N·m, counter-clockwise.
#[derive(Clone, Copy, Debug)]
pub struct Loads<C> {
    /// Of each bar, with the moment about its first joint.
    pub bars: [(Point<C>, C); BARS],
    pub head: Point<C>,
    /// Weight in the hoist rope.
    pub load: C,
    pub counterweight: Point<C>,
}

impl<C: Calc> Loads<C> {
    /// Weight on the slope, wind, inertia and centrifugal forces, with the whole load (N). [Newton and Euler]
    pub fn new(
        moved: &MovedBars<C>,
        given: &[CaseBody<C>],
        choice: &CasesChoice,
        load: &One<C>,
        case: &Case<C>,
        resisted: &Resisted<C>,
    ) -> Loads<C> {
        let (zero, q) = (C::constant(0.0), case.k_q * load.1);
        let (sin, cos) = case.sigma.sin_cos();
        let down = Point::new(sin, -cos);
        let (bend, squared) = (resisted.bend, resisted.rate.square());
        let turned = resisted.slewing.square();
        let force = |mass: C, [r, v, a]: [Point<C>; 3]| {
            let slowed = (v * bend + a * squared) * mass;
            let flung = Point::new(mass * turned * (r.x - moved.of.axis), zero);
            down * (mass * moved.of.gravity) + flung - slowed
        };
        let blown = |body: usize, about: Point<C>| {
            let own = given.iter().zip(&choice.bodies).filter(|(_, on)| **on == body);
            own.fold((Point::new(zero, zero), zero), |(sum, moment), (it, _)| {
                let push = Point::new(resisted.pressure * (it.area * it.drag), zero);
                let arm = moved.on(body, it.middle())[0] - about;
                (sum + push, moment + cross(arm, push))
            })
        };
        let bar = |i: usize| {
            let (body, [joint, along]) = (&moved.of.bodies[i], moved.at[0].bars[i]);
            let centre = moved.point(i, body.centre);
            let (own, [w, dw]) = (force(body.mass, centre), moved.turn(i));
            let spun = turned * deviation(body.spread, along) + body.inertia * (w * bend + dw * squared);
            let (wind, by_wind) = blown(i, joint);
            (own + wind, cross(centre[0] - joint, own) - spun + by_wind)
        };
        let swaying = case.alpha.sin_cos();
        let place = moved.at.each_ref().map(|placed| placed.counterweight);
        Loads {
            bars: std::array::from_fn(bar),
            head: Point::new(q * (swaying.0 / swaying.1 + sin), -(q * cos)),
            load: q,
            counterweight: force(moved.of.counterweight, place) + blown(BARS, place[0]).0,
        }
    }
}

/// What a balance does in a case.
#[derive(Clone, Copy, Debug)]
pub struct Carrying<C> {
    pub on_boom: Point<C>,
    /// About the foot of the boom that it sees, counter-clockwise, in N·m.
    pub moment: C,
    /// Force in its rod, in N, tension positive, and that of the frame on its lever; nothing of one that has none.
    pub rod: C,
    pub on_pivot: Point<C>,
    /// Turns of lever and rod for one radian of the luffing angle.
    pub lever: C,
    pub turn: C,
}

impl<C: Calc> Carrying<C> {
    pub fn new(residual: Option<&Residual<C>>, moved: &MovedBars<C>, loads: &Loads<C>) -> Carrying<C> {
        let zero = C::constant(0.0);
        let nothing = Point::new(zero, zero);
        let force = residual.map_or(nothing, |_| loads.counterweight);
        let rod = moved.line.map_or(zero, |line| dot(line.per_force, force));
        let on_boom = moved.line.map_or(force, |line| line.along * rod);
        let lever = residual.and_then(|residual| residual.action.lever);
        Carrying {
            on_boom,
            // By power: the frame takes no part in it.
            moment: dot(force, moved.at[1].counterweight) / moved.balanced,
            rod,
            on_pivot: on_boom - force,
            lever: lever.map_or(zero, |lever| lever.i_5 * moved.balanced),
            turn: lever.map_or(zero, |lever| lever.i_1 * moved.balanced),
        }
    }
}

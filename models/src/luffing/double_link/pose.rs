//! Where every bar is and how it moves with the driving one, as the forces of motion want it: by derivatives of the
//! positions, and in the book by their names.

use num_dual::{Dual2, Dual64, DualNum};

use crate::balance::action::RodLine;
use crate::balance::symbols as b;
use crate::kernel::calc::{Calc, Over};
use crate::kernel::record::Rec;
use crate::kernel::symbol::Symbol;
use crate::luffing::double_link::balancing::{boom_angle, place};
use crate::luffing::double_link::dynamics::{Bar, Body, Coordinate, Dynamics, Positions, bars, parts};
use crate::luffing::double_link::moving::symbols as s;
use crate::luffing::double_link::parameters::Driven;
use crate::luffing::double_link::position::Position;
use crate::luffing::double_link::symbols as g;
use crate::parts::plane::{self, Point, cross, dot};

/// The mechanism at one angle of the driving link; lengths in m, everything from O1.
#[derive(Clone, Copy, Debug)]
pub struct PosedLinkage<C> {
    pub position: Position<C>,
    /// Length of the rocker.
    pub x_3: C,
    /// Boom, jib and rocker.
    pub bodies: [PosedBody<C>; 3],
    pub counterweight: Option<PosedCounterweight<C>>,
    /// From the anchor on the frame to the one on the driving link, its length, and its lever arm about that bar's foot.
    pub drive: Option<(Point<C>, [C; 2])>,
}

/// A body in its bar.
#[derive(Clone, Copy, Debug)]
pub struct PosedBody<C> {
    /// In kg, and about its centre of gravity in kg·m².
    pub mass: C,
    pub inertia: C,
    /// Mass times forward and upward distance from the centre, in kg·m².
    pub deviation: C,
    /// Centre of gravity from the bar's first joint and, forward, from the slewing axis, in m.
    pub place: Point<C>,
    pub reach: C,
    /// Travel of the centre (m) and turning of the bar for one radian of the driving link, and how they change.
    pub travel: [Point<C>; 2],
    pub turn: [C; 2],
}

/// The counterweight of a balance.
#[derive(Clone, Copy, Debug)]
pub struct PosedCounterweight<C> {
    /// In kg.
    pub mass: C,
    /// Forward of the slewing axis, in m.
    pub reach: C,
    /// Travel (m) for one radian of the driving link, and how it changes.
    pub travel: [Point<C>; 2],
    /// Turning of the boom for one radian of the driving link.
    pub boom: C,
    /// None where it is fixed to the boom.
    pub line: Option<RodLine<C>>,
}

/// A scalar over which forces of motion are found, with parameters known as `P`.
pub trait Posing<P = f64>: Coordinate<P> {
    /// `None` where linkage or balance do not close.
    fn pose(d: &Dynamics<P>, theta: Self) -> Option<PosedLinkage<Self>>;
}

impl Posing for f64 {
    fn pose(d: &Dynamics, theta: f64) -> Option<PosedLinkage<f64>> {
        PosedLinkage::new(d, &d.twice, theta)
    }
}

impl Posing<Dual64> for Dual64 {
    fn pose(d: &Dynamics<Dual64>, theta: Dual64) -> Option<PosedLinkage<Dual64>> {
        PosedLinkage::new(d, &d.thrice, theta)
    }
}

impl<T: Calc + DualNum> PosedLinkage<T> {
    fn new<P: Calc>(d: &Dynamics<P>, positions: &Positions<T>, theta: T) -> Option<PosedLinkage<T>>
    where
        T: Over<P>,
    {
        let (geometry, zero) = (&positions.geometry, T::constant(0.0));
        let angle = Dual2::new(theta, T::constant(1.0), zero);
        let p = Position::new(geometry, angle)?;
        let bars = bars(geometry, &p);
        let axis = d.turntable().map_or(zero, |table| T::of(table.axis));
        let bodies = [&d.bodies().boom, &d.bodies().jib, &d.bodies().rocker];
        let body = |i: usize| PosedBody::new(bodies[i], &bars[i], axis);
        let turn_of_boom = bars[0].turn()[0];
        let counterweight = match &positions.counterweight {
            None => None,
            Some(it) => {
                let [at, travel, bend] = parts(place(&it.balancing, geometry, &it.weights, &p, angle)?);
                let phi = boom_angle(&p, angle).re;
                let balance = it.balancing.balance.map(|x: Dual2<T>| x.re);
                Some(PosedCounterweight {
                    mass: it.mass,
                    reach: at.x - axis,
                    travel: [travel, bend],
                    boom: turn_of_boom,
                    line: balance.line(phi, at, travel / turn_of_boom),
                })
            }
        };
        let drive = d.push.as_ref().map(|push| {
            let [line, arm] = push.line(geometry.driven, &bars);
            let length = plane::length(line);
            (line, [length, dot(line, arm) / length])
        });
        Some(PosedLinkage {
            position: p.map(|x| x.re),
            x_3: geometry.lengths.x_3.re,
            bodies: [body(0), body(1), body(2)],
            counterweight,
            drive,
        })
    }
}

impl<T: Calc + DualNum> PosedBody<T> {
    fn new<P: Calc>(body: &Body<P>, bar: &Bar<T>, axis: T) -> PosedBody<T>
    where
        T: Over<P>,
    {
        let [at, travel, bend] = bar.point(body.centre.map(T::of));
        PosedBody {
            mass: T::of(body.mass),
            inertia: T::of(body.inertia),
            deviation: bar.deviation(body.spread.map(T::of)),
            place: at - bar.joint[0],
            reach: at.x - axis,
            travel: [travel, bend],
            turn: bar.turn(),
        }
    }
}

/// For the book: what derivatives give has names, and what follows from it is a formula.
impl Posing<Rec> for Rec {
    fn pose(d: &Dynamics<Rec>, theta: Rec) -> Option<PosedLinkage<Rec>> {
        let values = PosedLinkage::new(d, &d.twice, theta.value())?;
        let point = |p: Point<f64>, [x, y]: [&'static Symbol; 2]| Point::new(Rec::given(x, p.x), Rec::given(y, p.y));
        let p = &values.position;
        let mut position = p.map(Rec::constant);
        position.x_1 = point(p.x_1, [&g::B_X, &g::B_Y]);
        position.x_2 = match p.driven {
            Driven::Boom => point(p.x_2, [&g::X_2X, &g::X_2Y]),
            Driven::Rocker => -point(-p.x_2, [&g::X_2RX, &g::X_2RY]),
        };
        position.x_3 = point(p.x_3, [&g::X_3X, &g::X_3Y]);
        (position.a, position.b) = (point(p.a, [&g::A_X, &g::A_Y]), position.x_1);
        position.k = Rec::given(&g::K, p.k);
        let turns = d.turntable().is_some();
        let driven = match p.driven {
            Driven::Boom => 0,
            Driven::Rocker => 2,
        };
        let sources = [&d.bodies().boom, &d.bodies().jib, &d.bodies().rocker];
        let loaded = d.bodies().pendulum.is_none();
        let body = |i: usize| {
            let (it, names) = (&values.bodies[i], &s::OF_BODY[i]);
            let place = match (i, loaded) {
                (1, true) => [&s::R_2QX, &s::R_2QY],
                _ => names.place,
            };
            let reach = match turns {
                true => Rec::given(names.reach, it.reach),
                false => Rec::constant(it.reach),
            };
            PosedBody {
                mass: sources[i].mass.def(names.mass),
                inertia: sources[i].inertia,
                deviation: Rec::given(names.deviation, it.deviation),
                place: point(it.place, place),
                reach,
                travel: [0, 1].map(|order| point(it.travel[order], names.centre[order])),
                turn: match i == driven {
                    // The driving link turns with itself.
                    true => [Rec::constant(1.0), Rec::constant(0.0)],
                    false => [
                        Rec::given(names.ratio, it.turn[0]),
                        Rec::given(names.ratio_change, it.turn[1]),
                    ],
                },
            }
        };
        Some(PosedLinkage {
            position,
            x_3: Rec::given(&g::X_3, values.x_3),
            bodies: [body(0), body(1), body(2)],
            counterweight: values.counterweight.map(|it| PosedCounterweight {
                mass: Rec::given(&s::MASS_5, it.mass),
                reach: match turns {
                    true => Rec::given(&s::X_S5, it.reach),
                    false => Rec::constant(it.reach),
                },
                travel: [0, 1].map(|order| point(it.travel[order], s::OF_COUNTERWEIGHT[order])),
                boom: match p.driven {
                    Driven::Boom => Rec::constant(1.0),
                    Driven::Rocker => Rec::given(&g::I_1, it.boom),
                },
                line: it.line.map(|line| RodLine {
                    per_force: point(line.per_force, [&s::N_5X, &s::N_5Y]),
                    along: point(line.along, [&s::E_1X, &s::E_1Y]),
                    rail: line.rail.map(|up| {
                        let lambda = Rec::given(&b::LAMBDA, f64::direction(up.x, up.y));
                        let (sin, cos) = lambda.sin_cos();
                        Point::new(cos, sin)
                    }),
                }),
            }),
            drive: values.drive.map(|(line, [length, arm])| {
                let sizes = [Rec::given(&g::L_D, length), Rec::given(&g::H_D, arm)];
                (point(line, [&g::L_DX, &g::L_DY]), sizes)
            }),
        })
    }
}

impl<T: Calc + DualNum> Bar<T> {
    /// Turning for one radian of the driving link, and how it changes.
    fn turn(&self) -> [T; 2] {
        let [along, travel, bend] = self.along;
        let square = self.length * self.length;
        [cross(along, travel) / square, cross(along, bend) / square]
    }

    /// Mass times forward and upward distance from the centre of a body that lies in the bar's frame as `spread` says.
    fn deviation(&self, [xx, xy, yy]: [T; 3]) -> T {
        let e = self.along[0].map(|x| x / self.length);
        (xx - yy) * e.x * e.y + xy * (e.x * e.x - e.y * e.y)
    }
}

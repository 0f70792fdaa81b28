//! Where every bar is and how it moves with the driving one, as the forces of motion want it: by derivatives of the
//! positions, and in the book by their names.

use std::sync::Arc;

use num_dual::{Dual2, Dual64, DualNum};

use crate::balance::symbols as b;
use crate::kernel::calc::{Calc, Over};
use crate::kernel::record::Rec;
use crate::kernel::symbol::Symbol;
use crate::luffing::double_link::balancing::{self, boom_angle, place};
use crate::luffing::double_link::leading::JIB;
use crate::luffing::double_link::linkage::{Bodies, HeavyLinkage, Positions, bars};
use crate::luffing::double_link::moving::symbols as s;
use crate::luffing::double_link::parameters::Driven;
use crate::luffing::double_link::position::Position;
use crate::luffing::double_link::statics::Centres;
use crate::luffing::double_link::symbols as g;
use crate::luffing::double_link::system::height;
use crate::luffing::led::moving::LedMoves;
use crate::luffing::led::pull::Hauled;
use crate::luffing::led::reeved::Reeved;
use crate::luffing::led::stretch::LedBars;
use crate::luffing::led::symbols as w;
use crate::luffing::moving::balance_in_motion::{PosedCounterweight, named};
use crate::luffing::moving::bodies::{
    Asked, Bar, Body, MovedBody, Moves, Turntable, about_axis, changes, deviation, hung, parts, spread, weighed_forward,
};
use crate::luffing::moving::dynamics::Dynamics;
use crate::luffing::moving::inertia_forces::PosedBody;
use crate::luffing::moving::reduced::{CoordinateNames, Reduced, Reduces};
use crate::luffing::moving::symbols as m;
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
    pub rope: Option<PosedRope<C>>,
    /// Mass (kg) and place of a load on a led rope on which it does not swing.
    pub load: Option<(C, [Point<C>; 3])>,
    /// From the anchor on the frame to the one on the driving link, its length, and its lever arm about that bar's foot.
    pub drive: Option<(Point<C>, [C; 2])>,
}

/// A led hoist rope: what one newton in it does to the bars, the falls of its tackle; the head, and the rope that one radian adds
/// between head and load, with what that changes by, in m.
#[derive(Clone, Copy, Debug)]
pub struct PosedRope<C> {
    pub each: [Hauled<C>; 3],
    pub falls: C,
    head: [Point<C>; 3],
    lead: [C; 2],
}

/// A scalar over which the mechanism moves and forces of motion are found, with parameters known as `P`.
pub trait Posing<P = f64>: Over<P> {
    /// `None` where linkage or balance do not close.
    fn reduced(link: &HeavyLinkage<P>, theta: Self, asked: &Asked<P>) -> Option<Reduced<Self>>;

    /// As [`reduced`](Posing::reduced).
    fn pose(link: &HeavyLinkage<P>, theta: Self, turntable: Option<Turntable<P>>) -> Option<PosedLinkage<Self>>;
}

impl Posing for f64 {
    fn reduced(link: &HeavyLinkage, theta: f64, asked: &Asked<f64>) -> Option<Reduced<f64>> {
        link.reduced_by(&link.twice, theta, asked)
    }

    fn pose(link: &HeavyLinkage, theta: f64, turntable: Option<Turntable>) -> Option<PosedLinkage<f64>> {
        PosedLinkage::new(link, &link.twice, theta, turntable)
    }
}

impl Posing<Dual64> for Dual64 {
    fn reduced(link: &HeavyLinkage<Dual64>, theta: Dual64, asked: &Asked<Dual64>) -> Option<Reduced<Dual64>> {
        link.reduced_by(&link.thrice, theta, asked)
    }

    fn pose(
        link: &HeavyLinkage<Dual64>,
        theta: Dual64,
        turntable: Option<Turntable<Dual64>>,
    ) -> Option<PosedLinkage<Dual64>> {
        PosedLinkage::new(link, &link.thrice, theta, turntable)
    }
}

impl<P: Posing<P>> Reduces<P> for HeavyLinkage<P>
where
    Dual64: Over<P>,
{
    fn reduced(&self, at: P, asked: &Asked<P>) -> Option<Reduced<P>> {
        P::reduced(self, at, asked)
    }

    fn with_slope(&self, at: Dual64, asked: &Asked<P>) -> Option<Reduced<Dual64>> {
        self.reduced_by(&self.thrice, at, asked)
    }

    fn names(&self) -> CoordinateNames {
        CoordinateNames {
            acceleration: match self.driven() {
                Driven::Boom => &s::D_OMEGA_1,
                Driven::Rocker => &s::D_OMEGA_3,
            },
            stops: [&g::FROM, &g::TO],
        }
    }
}

impl<P: Posing<P> + Send + Sync + 'static> HeavyLinkage<P>
where
    Dual64: Over<P>,
{
    /// In motion, with what hangs on it.
    #[must_use]
    pub fn in_motion(self) -> Dynamics<P> {
        let Bodies { pendulum, gravity, .. } = self.bodies;
        Dynamics::new(Arc::new(self), pendulum, gravity)
    }
}

impl<T: Calc + DualNum> PosedLinkage<T> {
    fn new<P: Calc>(
        d: &HeavyLinkage<P>,
        positions: &Positions<T>,
        theta: T,
        turntable: Option<Turntable<P>>,
    ) -> Option<PosedLinkage<T>>
    where
        T: Over<P>,
    {
        let (geometry, zero) = (&positions.geometry, T::constant(0.0));
        let angle = Dual2::new(theta, T::constant(1.0), zero);
        let p = Position::new(geometry, angle)?;
        let bars = bars(geometry, &p);
        let axis = turntable.map_or(zero, |table| T::of(table.axis));
        let bodies = d.bodies.bars();
        let body = |i: usize| PosedBody::new(i, bodies[i], &bars[i], axis);
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
        let at = bars.each_ref().map(|bar| [bar.joint[0], bar.along[0] / bar.length]);
        let (mut rope, mut load) = (None, None);
        if let Some(led) = &d.led {
            let head = parts(p.a);
            let LedMoves { raised, lead } = led.moves((JIB, head), |bar, at| bars[bar].point(at.map(T::of)))?;
            load = d.bodies.load.map(|mass| (T::of(mass), hung(head, raised, lead)));
            let led = led.map(T::of);
            rope = Some(PosedRope {
                each: led.hauled(&LedBars::still(at, (JIB, head[0])))?,
                falls: led.falls.m_h,
                head,
                lead,
            });
        }
        Some(PosedLinkage {
            rope,
            load,
            position: p.map(|x| x.re),
            x_3: geometry.lengths.x_3.re,
            bodies: [body(0), body(1), body(2)],
            counterweight,
            drive,
        })
    }
}

impl<T: Calc + DualNum> PosedBody<T> {
    fn new<P: Calc>(place: usize, body: &Body<P>, bar: &Bar<T>, axis: T) -> PosedBody<T>
    where
        T: Over<P>,
    {
        let [at, travel, bend] = bar.point(body.centre.map(T::of));
        PosedBody {
            mass: T::of(body.mass),
            inertia: T::of(body.inertia),
            bar: place,
            joint: bar.joint[0].y,
            deviation: bar.deviation(body.spread.map(T::of)),
            place: at - bar.joint[0],
            reach: at.x - axis,
            travel: [travel, bend],
            turn: bar.turn(),
        }
    }
}

/// First joint and direction of boom, jib and rocker.
fn directed(d: &HeavyLinkage<Rec>, p: &Position<Rec>) -> [(Point<Rec>, Point<Rec>); 3] {
    let lengths = &d.twice.geometry.lengths;
    let given = |symbol, length: Dual2<f64>| Rec::given(symbol, length.re);
    let foot = Point::new(Rec::constant(0.0), Rec::constant(0.0));
    let o3 = Point::new(-given(&g::X_5, lengths.x_5), given(&g::X_6, lengths.x_6));
    [
        (foot, p.x_1 / given(&g::X_1, lengths.x_1)),
        (p.b, p.x_2 / given(&g::X_2, lengths.x_2)),
        (o3, p.x_3 / given(&g::X_3, lengths.x_3)),
    ]
}

/// Which of them is the driving link.
fn driven(d: &HeavyLinkage<Rec>) -> usize {
    match d.driven() {
        Driven::Boom => 0,
        Driven::Rocker => 2,
    }
}

/// Potential energy of boom, jib and rocker, in J, at an angle (rad) of the driving link.
fn potential(d: &HeavyLinkage<Rec>, theta: f64) -> f64 {
    let (geometry, counterweight) = (&d.twice.geometry, d.twice.counterweight.as_ref());
    let position = Position::new(geometry, Dual2::from_re(theta));
    let energy = counterweight.zip(position).map(|(it, p)| {
        let centres = Centres::new(&p, &geometry.lengths, &it.weights);
        height(geometry, &it.weights, &p, &centres).re
    });
    energy.expect("it was assembled at this angle")
}

/// For the book: what derivatives give has names, and what follows from it is a formula.
impl Posing<Rec> for Rec {
    /// The equations of motion ask for the same, and for inertias.
    fn reduced(d: &HeavyLinkage<Rec>, theta: Rec, asked: &Asked<Rec>) -> Option<Reduced<Rec>> {
        let values = d.moves(&d.twice, theta.value(), asked)?;
        let posed = Rec::pose(d, theta, asked.turntable)?;
        let bodies = d.bodies.bars();
        // Heights are those of the energy, which no formula of the book has.
        let nowhere = Point::new(Rec::constant(0.0), Rec::constant(0.0));
        let moved = |i: usize| {
            let PosedBody { travel, turn, .. } = posed.bodies[i];
            let [ratio, change] = turn;
            MovedBody {
                centre: [nowhere, travel[0], travel[1]],
                turn: match i == driven(d) {
                    true => turn,
                    false => {
                        let [square, half] = values.bodies[i].turn;
                        [(ratio * ratio).rounded_as(square), (ratio * change).rounded_as(half)]
                    }
                },
            }
        };
        let turn = asked.turntable.map(|table| {
            let bars = directed(d, &posed.position);
            let each = posed.bodies.iter().zip(bodies).zip(bars);
            let each = each.map(|((it, body), (_, along))| (it.mass, it.reach, Some(spread(body.spread, along))));
            let load = posed
                .load
                .iter()
                .map(|(mass, [at, ..])| (*mass, at.x - table.axis, None));
            let counterweight = posed.counterweight.iter().map(|it| (it.mass, it.reach, None));
            let whole = about_axis(table.inertia, each.chain(load).chain(counterweight));
            let whole = whole.rounded_as(values.turn[0]).def(&s::I_SL);
            [whole, whole.derivative(theta, values.turn[1]).def(&s::DI_SL)]
        });
        let [_, travel, bend] = values.head;
        let first = Point::new(Rec::given(&g::DA_X, travel.x), Rec::given(&g::DA_Y, travel.y));
        let second = Point::new(first.x.derivative(theta, bend.x), first.y.derivative(theta, bend.y));
        let second = match d.bodies.pendulum {
            Some(_) => plane::def(second, [&s::DDA_X, &s::DDA_Y]),
            None => second,
        };
        let moves = Moves {
            bodies: [moved(0), moved(1), moved(2)],
            counterweight: posed
                .counterweight
                .as_ref()
                .map(|it| (it.mass, [nowhere, it.travel[0], it.travel[1]])),
            head: [posed.position.a, first, second],
            load: posed.load,
            drive: match posed.drive.filter(|_| asked.drive) {
                Some((_, sizes)) => sizes,
                None => [Rec::constant(0.0); 2],
            },
            turn: turn.unwrap_or([Rec::constant(0.0); 2]),
            weighed: asked.turntable.filter(|_| asked.leans).map(|table| {
                let gravity = d.bodies.gravity;
                let of = |it: &PosedBody<Rec>| [it.mass * gravity, it.reach, it.travel[0].x];
                let hung =
                    |(mass, [at, travel, _]): &(Rec, [Point<Rec>; 3])| [*mass * gravity, at.x - table.axis, travel.x];
                let each = posed.bodies.iter().map(of).chain(posed.load.iter().map(hung));
                let counterweight = posed.counterweight.iter();
                weighed_forward(each.chain(counterweight.map(|it| [it.mass * gravity, it.reach, it.travel[0].x])))
            }),
            lead: posed.rope.filter(|_| posed.load.is_none()).map(|rope| rope.lead),
        };
        Some(d.sum(moves))
    }

    fn pose(d: &HeavyLinkage<Rec>, theta: Rec, turntable: Option<Turntable<Rec>>) -> Option<PosedLinkage<Rec>> {
        let values = PosedLinkage::new(d, &d.twice, theta.value(), turntable)?;
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
        let sources = d.bodies.bars();
        let loaded = d.bodies.pendulum.is_none();
        let bars = directed(d, &position);
        let axis = turntable.map(|table| table.axis);
        let from_axis = |x: Rec, value, name| axis.map_or(x, |axis| (x - axis).rounded_as(value).def(name));
        let body = |i: usize| {
            let (it, names, (joint, along)) = (&values.bodies[i], &s::OF_BODY[i], bars[i]);
            let place = match (i, loaded) {
                (1, true) => [&s::R_2QX, &s::R_2QY],
                _ => names.place,
            };
            let place = point(it.place, place);
            PosedBody {
                mass: sources[i].mass.def(names.sums.mass),
                inertia: sources[i].inertia,
                bar: i,
                joint: joint.y,
                deviation: match axis {
                    Some(_) => deviation(sources[i].spread, along)
                        .rounded_as(it.deviation)
                        .def(names.deviation),
                    None => Rec::constant(it.deviation),
                },
                place,
                reach: from_axis(joint.x + place.x, it.reach, names.reach),
                // A foot on the frame stays where it is.
                travel: changes(
                    if i == 1 { joint + place } else { place },
                    theta,
                    it.travel,
                    names.centre,
                ),
                turn: match i == driven(d) {
                    // The driving link turns with itself.
                    true => [Rec::constant(1.0), Rec::constant(0.0)],
                    false => {
                        let ratio = Rec::given(names.ratio, it.turn[0]);
                        [ratio, ratio.derivative(theta, it.turn[1]).def(names.ratio_change)]
                    }
                },
            }
        };
        let at = bars.map(|(joint, along)| [joint, along]);
        let rope = match d.led.as_ref().zip(values.rope) {
            Some((led, found)) => Some(named_rope(led, &found, at, position.a, theta)?),
            None => None,
        };
        let load = d.bodies.load.zip(rope);
        let load = load.map(|(mass, rope)| (mass, hung(rope.head, Rec::constant(0.0), rope.lead)));
        Some(PosedLinkage {
            rope,
            load,
            position,
            x_3: Rec::given(&g::X_3, values.x_3),
            bodies: [body(0), body(1), body(2)],
            counterweight: values
                .counterweight
                .and_then(|it| counterweight(d, p, theta, &it, &from_axis)),
            drive: values.drive.map(|(line, [length, arm])| {
                let sizes = [Rec::given(&g::L_D, length), Rec::given(&g::H_D, arm)];
                (point(line, [&g::L_DX, &g::L_DY]), sizes)
            }),
        })
    }
}

/// A led rope at bars that lie like this, with the head, and what it found by dual numbers.
fn named_rope(
    led: &Reeved<Rec>,
    found: &PosedRope<f64>,
    at: [[Point<Rec>; 2]; 3],
    head: Point<Rec>,
    theta: Rec,
) -> Option<PosedRope<Rec>> {
    let (falls, [lead, further]) = (led.falls.m_h, found.lead);
    let change = Rec::given(&w::DL_LED, -(lead * falls.value()));
    let lead = (-(change / falls)).rounded_as(lead).def(&m::DL_R);
    let [_, first, second] = found.head;
    let travel = Point::new(Rec::given(&g::DA_X, first.x), Rec::given(&g::DA_Y, first.y));
    let bend = Point::new(
        travel.x.derivative(theta, second.x),
        travel.y.derivative(theta, second.y),
    );
    Some(PosedRope {
        each: led.hauled(&LedBars::still(at, (JIB, head)))?,
        falls,
        head: [head, travel, bend],
        lead: [lead, lead.derivative(theta, further).def(&m::DDL_R)],
    })
}

/// A counterweight's place, and what follows from it, where a linkage stands.
fn counterweight(
    d: &HeavyLinkage<Rec>,
    p: &Position<f64>,
    theta: Rec,
    it: &PosedCounterweight<f64>,
    from_axis: &dyn Fn(Rec, f64, &'static Symbol) -> Rec,
) -> Option<PosedCounterweight<Rec>> {
    let (parameters, range) = d.quantities.as_ref()?;
    let balancing = balancing::new(parameters, range).ok()??;
    let phi = match p.driven {
        Driven::Boom => theta,
        Driven::Rocker => Rec::given(&g::THETA_1, p.follower_angle()),
    };
    let place = balancing.place(phi, || Rec::given(&b::U_0, potential(d, theta.value())))?;
    let place = plane::def(place, [&b::C_5X, &b::C_5Y]);
    let travel = changes(place, theta, it.travel, s::OF_COUNTERWEIGHT);
    let boom = match p.driven {
        Driven::Boom => Rec::constant(1.0),
        Driven::Rocker => Rec::given(&g::I_1, it.boom),
    };
    let line = balancing.balance.line(phi, place, travel[0] / boom).zip(it.line);
    Some(PosedCounterweight {
        mass: (balancing.balance.weight()? / d.bodies.gravity)
            .rounded_as(it.mass)
            .def(&s::MASS_5),
        reach: from_axis(place.x, it.reach, &s::X_S5),
        travel,
        boom,
        line: line.map(|(line, values)| named(&line, &values)),
    })
}

impl<T: Calc + DualNum> Bar<T> {
    /// Turning for one radian of the driving link, and how it changes.
    fn turn(&self) -> [T; 2] {
        let [along, travel, bend] = self.along;
        let square = self.length * self.length;
        [cross(along, travel) / square, cross(along, bend) / square]
    }

    fn deviation(&self, spread: [T; 3]) -> T {
        deviation(spread, self.along[0].map(|x| x / self.length))
    }
}

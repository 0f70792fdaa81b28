//! Bodies of a mechanism that moves by one coordinate, with their derivatives by it, and what is hung on it or turns it.

use num_dual::{Dual2, DualNum};

use crate::kernel::calc::{Calc, Over};
use crate::kernel::record::Rec;
use crate::kernel::symbol::Symbol;
use crate::luffing::moving::symbols as s;
use crate::parts::hanging::cancelling;
use crate::parts::hoist::Hoist;
use crate::parts::plane::{self, Point, dot};

/// A body that moves with one of the bars.
#[derive(Clone, Copy, Debug)]
pub struct Body<P = f64> {
    /// In kg.
    pub mass: P,
    /// About the centre of gravity, in kg·m².
    pub inertia: P,
    /// Centre of gravity from the bar's first joint, along the bar and to its left, in m.
    pub centre: Point<P>,
    /// Where the inertia lies: mass times xx, xy and yy of the same directions about the centre, in kg·m².
    pub spread: [P; 3],
}

impl Body {
    /// A uniform bar of a mass (kg) from one point to another, both in the frame of its bar, in m.
    #[must_use]
    pub fn uniform(mass: f64, from: Point<f64>, to: Point<f64>) -> Body {
        let inertia = mass * (to - from).norm_squared() / 12.0;
        Body::slender(mass, inertia, (from + to) / 2.0, to - from)
    }
}

impl<P: Calc> Body<P> {
    /// A slender body of a mass (kg), an inertia about its centre (kg·m²), the centre (m) and the direction
    /// along which it lies, both in the frame of its bar.
    #[must_use]
    pub fn slender(mass: P, inertia: P, centre: Point<P>, along: Point<P>) -> Body<P> {
        let square = dot(along, along);
        let per = match square.value() {
            0.0 => P::constant(0.0),
            _ => inertia / square,
        };
        Body {
            mass,
            inertia,
            centre,
            spread: products(along).map(|x| per * x),
        }
    }

    /// One that is not there.
    #[must_use]
    pub fn nothing() -> Body<P> {
        let zero = P::constant(0.0);
        Body::slender(zero, zero, Point::new(zero, zero), Point::new(zero, zero))
    }

    /// A slender body along its bar, of a weight (N) under gravity (m/s²), an inertia (kg·m²), and its centre from the
    /// bar's first joint (m, rad).
    #[must_use]
    pub fn along_bar(weight: P, gravity: P, inertia: P, [distance, angle]: [P; 2]) -> Body<P> {
        let (sin, cos) = angle.sin_cos();
        let line = Point::new(P::constant(1.0), P::constant(0.0));
        Body::slender(
            weight / gravity,
            inertia,
            Point::new(distance * cos, distance * sin),
            line,
        )
    }

    /// The body with a mass (kg) that is fixed to it at a point of its frame, in m.
    #[must_use]
    pub fn with_mass(self, mass: P, at: Point<P>) -> Body<P> {
        let sum = self.mass + mass;
        if sum.value() == 0.0 {
            return self;
        }
        let (apart, both) = (at - self.centre, self.mass * mass / sum);
        let more = products(apart);
        Body {
            mass: sum,
            inertia: self.inertia + both * dot(apart, apart),
            centre: (self.centre * self.mass + at * mass) / sum,
            spread: std::array::from_fn(|i| self.spread[i] + both * more[i]),
        }
    }
}

fn products<P: Calc>(v: Point<P>) -> [P; 3] {
    [v.x * v.x, v.x * v.y, v.y * v.y]
}

/// The crane as it turns about its vertical axis. Bodies are thin: across the mechanism's plane they have no width.
#[derive(Clone, Copy, Debug)]
pub struct Turntable<P = f64> {
    /// The axis from O1, in m; positive lies forward.
    pub axis: P,
    /// Of all that turns besides the bodies of the mechanism, about the axis, in kg·m².
    pub inertia: P,
}

/// What the equations of motion ask of a mechanism besides its bodies.
#[derive(Clone, Copy, Debug)]
pub struct Asked<P> {
    /// Where it slews.
    pub turntable: Option<Turntable<P>>,
    /// It does so on a slope.
    pub leans: bool,
    /// The length and the lever arm of its drive.
    pub drive: bool,
}

/// The load on its rope: a pendulum in the plane of the mechanism.
#[derive(Clone, Copy, Debug)]
pub struct Pendulum<P = f64> {
    /// In kg.
    pub mass: P,
    /// Length of the rope, in m.
    pub length: P,
    pub hoist: Hoist<P>,
}

impl<P: Calc> Pendulum<P> {
    /// As [`cancelling`].
    pub(crate) fn cancelling(&self) -> P {
        cancelling(self.mass)
    }
}

/// How N bodies, head and drive move with the coordinate, by derivatives of the positions.
#[derive(Clone, Copy)]
pub(crate) struct Moves<C, const N: usize> {
    pub bodies: [MovedBody<C>; N],
    /// Mass (kg) and place of a load that hangs below the head at any time and is no part of a body, and of the counterweight.
    pub load: Option<(C, [Point<C>; 3])>,
    pub counterweight: Option<(C, [Point<C>; 3])>,
    pub head: [Point<C>; 3],
    pub drive: [C; 2],
    pub turn: [C; 2],
    /// Weights times their distance forward of the slewing axis, and times their travel forward, in N·m.
    pub weighed: Option<[C; 2]>,
    pub lead: Option<[C; 2]>,
}

/// Weights of all bodies as a slope finds them: times their distance forward of the slewing axis (N·m), and times their travel
/// forward and up for one radian of the driving link (N·m), and their height (J); a load that hangs is at the head.
#[derive(Clone, Copy, Debug)]
pub struct WeighedBodies<C> {
    pub forward: C,
    pub travel: Point<C>,
    pub energy: C,
}

impl<C: Calc> WeighedBodies<C> {
    pub fn map<D>(self, f: impl Fn(C) -> D) -> WeighedBodies<D> {
        WeighedBodies {
            forward: f(self.forward),
            travel: Point::new(f(self.travel.x), f(self.travel.y)),
            energy: f(self.energy),
        }
    }
}

/// Sums over bodies of a weight (N), a distance forward of the slewing axis and its travel for one radian of the driving link (m):
/// both times the weight, in N·m.
pub(crate) fn weighed_forward<C: Calc>(bodies: impl Iterator<Item = [C; 3]>) -> [C; 2] {
    let none = [C::constant(0.0); 2];
    let [place, travel] = bodies.fold(none, |[place, travel], [weight, reach, ahead]| {
        [place + weight * reach, travel + weight * ahead]
    });
    [place.def(&s::W_SX), travel.def(&s::W_GX)]
}

/// Names of inertias about upright axes through the centres of boom and of link or trunk, and of their changes.
const UPRIGHT: [[&Symbol; 2]; 2] = [[&s::I_UB, &s::DI_UB], [&s::I_UL, &s::DI_UL]];

impl<C: Calc, const N: usize> Moves<C, N> {
    /// Of a mechanism whose plane does not turn, and whose drive nothing asks for.
    pub fn in_plane(
        bodies: [MovedBody<C>; N],
        counterweight: Option<(C, [Point<C>; 3])>,
        head: [Point<C>; 3],
        lead: Option<[C; 2]>,
    ) -> Moves<C, N> {
        let nothing = [C::constant(0.0); 2];
        Moves {
            bodies,
            load: None,
            counterweight,
            head,
            drive: nothing,
            turn: nothing,
            weighed: None,
            lead,
        }
    }

    /// With a drive of a length (m) and a lever arm (m), where one is asked for.
    #[must_use]
    pub fn pushed(self, drive: Option<[C; 2]>) -> Moves<C, N> {
        Moves {
            drive: drive.unwrap_or(self.drive),
            ..self
        }
    }

    /// With a load that hangs below the head at any time.
    #[must_use]
    pub fn hanging(self, load: Option<(C, [Point<C>; 3])>) -> Moves<C, N> {
        Moves { load, ..self }
    }

    /// About a slewing axis, where there is one, on a slope where that is asked, under gravity in m/s²: with unit vectors along the
    /// bodies' bars and the changes of these, where a body has inertia of its own.
    #[must_use]
    pub fn turning<P: Calc>(
        self,
        (gravity, asked): (P, &Asked<P>),
        bodies: [&Body<P>; N],
        bars: [Option<[Point<C>; 2]>; N],
    ) -> Moves<C, N>
    where
        C: Over<P>,
    {
        let Some(table) = &asked.turntable else { return self };
        let weighed = asked.leans.then(|| {
            let (gravity, axis) = (C::of(gravity), C::of(table.axis));
            let each = bodies.iter().zip(&self.bodies);
            let each = each.map(|(body, moved)| (C::of(body.mass), moved.centre));
            let of = |(mass, [at, travel, _]): (C, [Point<C>; 3])| [mass * gravity, at.x - axis, travel.x];
            weighed_forward(each.chain(self.load).chain(self.counterweight).map(of))
        });
        let (axis, two) = (C::of(table.axis), C::constant(2.0));
        let each = bodies.into_iter().zip(&self.bodies).zip(bars.into_iter().zip(UPRIGHT));
        let each = each.map(|((body, moved), (bar, [about, change]))| {
            let mut of = body.spread.map(C::of);
            if of[1].value() != 0.0 {
                of = [of[0].def(&s::J_XIU), of[1].def(&s::J_XIETAU), of[2].def(&s::J_ETAU)];
            }
            let about = bar.map(|bar| [spread(of, bar[0]).def(about), spread_change(of, bar).def(change)]);
            (C::of(body.mass), moved.centre, about)
        });
        let points = [self.load, self.counterweight].into_iter().flatten();
        let all = each.chain(points.map(|(mass, centre)| (mass, centre, None)));
        let (mut whole, mut change) = (C::of(table.inertia), C::constant(0.0));
        for (mass, [r, v, _], about) in all {
            let reach = r.x - axis;
            whole += mass * reach * reach;
            change += two * (mass * (reach * v.x));
            if let Some([spread, spread_change]) = about {
                whole += spread;
                change += spread_change;
            }
        }
        let turn = [whole.def(&s::I_SL), change.def(&s::DI_SL)];
        Moves { turn, weighed, ..self }
    }
}

/// A load below the head (m), with the rope that one radian adds between and its change (m), which has raised it by so much: place,
/// first and second derivative by the driven angle.
pub(crate) fn hung<C: Calc>([head, travel, bend]: [Point<C>; 3], raised: C, [lead, further]: [C; 2]) -> [Point<C>; 3] {
    [
        Point::new(head.x, head.y + raised),
        Point::new(travel.x, (travel.y - lead).def(&s::DY_Q)),
        Point::new(bend.x, (bend.y - further).def(&s::DDY_Q)),
    ]
}

/// A body's centre of gravity: place, first and second derivative by the driven angle, in m; square of the body's
/// turning by it, and half of how that changes.
#[derive(Clone, Copy)]
pub(crate) struct MovedBody<C> {
    pub centre: [Point<C>; 3],
    pub turn: [C; 2],
}

/// A bar with its derivatives by the driven angle.
pub(crate) struct Bar<T> {
    pub joint: [Point<T>; 3],
    pub along: [Point<T>; 3],
    pub length: T,
    /// Square of its turning by the driven angle, and half of how that changes.
    turn: T,
    turn_change: T,
}

impl<T: Calc + DualNum> Bar<T> {
    #[inline]
    pub fn new(joint: Point<Dual2<T>>, along: Point<Dual2<T>>) -> Bar<T> {
        let [e, d, dd] = parts(along);
        let square = dot(e, e);
        // A bar of constant length turns by phi: |d| = length · phi', and d · d″ = length² · phi' phi″.
        Bar {
            joint: parts(joint),
            along: [e, d, dd],
            length: Calc::sqrt(square),
            turn: dot(d, d) / square,
            turn_change: dot(d, dd) / square,
        }
    }

    /// How a body of the bar moves.
    pub fn moved<P: Calc>(&self, body: &Body<P>) -> MovedBody<T>
    where
        T: Over<P>,
    {
        MovedBody {
            centre: self.point(body.centre.map(T::of)),
            turn: [self.turn, self.turn_change],
        }
    }

    /// Inertia about a vertical axis through the centre of a body that lies in the bar's frame as `spread` says.
    fn spread(&self, of: [T; 3]) -> Dual2<T> {
        let [e, d, dd] = self.along.map(|x| x / self.length);
        let along = Point::new(Dual2::new(e.x, d.x, dd.x), Dual2::new(e.y, d.y, dd.y));
        spread(of.map(Dual2::from_re), along)
    }

    /// A point of the bar's frame: place, first and second derivative.
    #[inline]
    pub fn point(&self, at: Point<T>) -> [Point<T>; 3] {
        let (along, across) = (at.x / self.length, at.y / self.length);
        let of = |i: usize| self.joint[i] + plane::turned(self.along[i], along, across);
        [of(0), of(1), of(2)]
    }
}

/// Inertia about a vertical axis through the centre of a body that lies as [`Body::spread`] says in the frame of a bar
/// along a unit vector.
pub(crate) fn spread<C: Calc>([xx, xy, yy]: [C; 3], along: Point<C>) -> C {
    let (along, across) = (along.x, -along.y);
    xx * along * along + xy * along * across * C::constant(2.0) + yy * across * across
}

/// How that changes with the coordinate, of a bar along a unit vector that changes so.
pub(crate) fn spread_change<C: Calc>([xx, xy, yy]: [C; 3], [e, d]: [Point<C>; 2]) -> C {
    let two = C::constant(2.0);
    two * (xx * (e.x * d.x) + yy * (e.y * d.y) - xy * (e.x * d.y + d.x * e.y))
}

/// Mass times forward and upward distance from the centre of a body that lies as [`Body::spread`] says in the frame of
/// a bar along a unit vector.
pub(crate) fn deviation<C: Calc>([xx, xy, yy]: [C; 3], e: Point<C>) -> C {
    (xx - yy) * e.x * e.y + xy * (e.x * e.x - e.y * e.y)
}

/// Value, first and second derivative.
pub(crate) fn parts<T: Calc + DualNum>(v: Point<Dual2<T>>) -> [Point<T>; 3] {
    [v.map(|x| x.re), v.map(|x| x.v1), v.map(|x| x.v2)]
}

/// Inertia of all bodies about the slewing axis (kg·m²), and its change by the driven angle; points by their masses (kg)
/// and places (m).
pub(crate) fn turned_inertia<P: Calc, T: Calc + DualNum + Over<P>, const N: usize>(
    table: &Turntable<P>,
    bodies: [&Body<P>; N],
    bars: &[Bar<T>; N],
    points: impl Iterator<Item = (T, [Point<T>; 3])>,
) -> [T; 2] {
    let axis = Dual2::from_re(T::of(table.axis));
    let bodies = bodies.into_iter().zip(bars);
    let bodies = bodies.map(|(body, bar)| {
        let [r, v, a] = bar.point(body.centre.map(T::of));
        let mass = Dual2::from_re(T::of(body.mass));
        let spread = bar.spread(body.spread.map(T::of));
        (mass, Dual2::new(r.x, v.x, a.x) - axis, Some(spread))
    });
    let points = points.map(|(mass, [r, v, a])| (Dual2::from_re(mass), Dual2::new(r.x, v.x, a.x) - axis, None));
    let sum = about_axis(Dual2::from_re(T::of(table.inertia)), bodies.chain(points));
    [sum.re, sum.v1]
}

/// An inertia (kg·m²) with bodies: mass (kg), distance from the axis (m), inertia about the centre where it has one.
pub(crate) fn about_axis<C: Calc>(inertia: C, bodies: impl Iterator<Item = (C, C, Option<C>)>) -> C {
    bodies.fold(inertia, |sum, (mass, reach, spread)| {
        let about = mass * reach * reach;
        sum + spread.map_or(about, |spread| about + spread)
    })
}

/// How something at an angle of the driving link changes with it, as dual numbers have found: two coordinates, once and
/// once more.
pub(crate) fn changes(
    of: Point<Rec>,
    theta: Rec,
    values: [Point<f64>; 2],
    names: [[&'static Symbol; 2]; 2],
) -> [Point<Rec>; 2] {
    let once = |of: Point<Rec>, value: Point<f64>, [x, y]: [&'static Symbol; 2]| {
        Point::new(
            of.x.derivative(theta, value.x).def(x),
            of.y.derivative(theta, value.y).def(y),
        )
    };
    let first = once(of, values[0], names[0]);
    [first, once(first, values[1], names[1])]
}

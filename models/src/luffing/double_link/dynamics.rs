//! The mechanism in motion: its driven bar as a coordinate of its own, with the
//! inertia of all bodies, and the load as a pendulum on its rope.
//!
//! Nothing here is derived by hand from the mechanism: positions are run with
//! second-order dual numbers, and reduced inertia, its change and the moment of
//! the weights follow from their derivatives. [virtual work; Lagrange]

use std::cell::Cell;

use num_dual::{Dual2, Dual64, DualNum};

use crate::kernel::allowed::OutOfRange;
use crate::kernel::calc::{Calc, Over, Takes};
use crate::kernel::symbol::Symbol;
use crate::luffing::balancing::Balancing;
use crate::luffing::double_link::balancing;
use crate::luffing::double_link::geometry::Geometry;
use crate::luffing::double_link::moving::symbols as s;
use crate::luffing::double_link::parameters::{Anchors, Driven, Parameters, Weights};
use crate::luffing::double_link::position::Position;
use crate::parts::hanging::cancelling;
use crate::parts::hoist::Hoist;
use crate::parts::motion::Motion as Range;
use crate::parts::plane::{self, Point, dot, squared};
use crate::parts::solver::{Gradient, runge_kutta};

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

/// Bodies that the mechanism moves.
#[derive(Clone, Copy, Debug)]
pub struct Bodies<P = f64> {
    pub boom: Body<P>,
    pub jib: Body<P>,
    pub rocker: Body<P>,
    pub pendulum: Option<Pendulum<P>>,
    /// In m/s².
    pub gravity: P,
}

/// Angles in rad and their rates in rad/s: where the mechanism is and how it moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Phase<C = f64> {
    /// Angle of the driven bar.
    pub theta: C,
    pub omega: C,
    /// Rope from the vertical, forward positive; stays as it is without a pendulum.
    pub swing: C,
    pub swing_rate: C,
}

/// The rope: its length (m), how fast it is paid out (m/s), and how that changes (m/s²) where it does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reel<C> {
    pub length: C,
    pub rate: C,
    pub gain: Option<C>,
}

impl<C: Calc> Reel<C> {
    /// At rest.
    #[must_use]
    pub fn still(length: C) -> Reel<C> {
        Reel {
            length,
            rate: C::constant(0.0),
            gain: None,
        }
    }

    /// An acceleration towards the head (m/s²) less what the hoist gives way.
    pub(crate) fn less_gain(&self, inward: C) -> C {
        self.gain.map_or(inward, |gain| inward - gain)
    }
}

/// The pendulum's part of the equations of motion: the terms that it adds to the inertia of the driven bar (kg·m²) and
/// couples it with, how the bar couples back, its own inertia, and the moments on both (N·m). The rope's equation, with
/// `back`, `inertia` and the second moment, is multiplied by the mass that [cancels](Pendulum::cancelling).
struct Swing<C> {
    own: C,
    coupled: C,
    back: C,
    inertia: C,
    forces: [C; 2],
}

/// What the equations of motion need at one angle, all by derivatives of the positions.
#[derive(Clone, Copy, Debug)]
pub struct Reduced<C> {
    /// Inertia of boom, jib, rocker and counterweight at the driven bar (kg·m²), and its change by the angle.
    pub inertia: C,
    pub slope: C,
    /// Moment of their weights, in N·m; positive lowers the driven bar.
    pub moment: C,
    /// Height of their centres of gravity times their weights, in J.
    pub energy: C,
    /// Head A: place, first and second derivative by the angle, in m.
    pub head: [Point<C>; 3],
    /// Length of the drive (m) and its lever arm (m), which is its derivative by the angle; zero without one.
    pub drive: [C; 2],
    /// Inertia about the slewing axis (kg·m²), and its change by the angle; zero where the crane does not slew.
    pub turn: [C; 2],
}

/// Positions with their first and second derivatives by the driven angle.
#[derive(Copy, Debug)]
pub(super) struct Positions<T> {
    pub geometry: Geometry<Dual2<T>>,
    pub counterweight: Option<Counterweight<T>>,
}

/// In one piece: what is derived copies number by number.
impl<T: Copy> Clone for Positions<T> {
    fn clone(&self) -> Positions<T> {
        *self
    }
}

/// The counterweight of a balance: a body of its weight in its centre of gravity. A rope to it is taken as taut.
#[derive(Clone, Copy, Debug)]
pub(super) struct Counterweight<T> {
    pub balancing: Balancing<Dual2<T>>,
    pub weights: Weights<Dual2<T>>,
    /// In kg.
    pub mass: T,
}

impl<T: Calc + DualNum> Counterweight<T> {
    fn new(p: &Parameters<T>, range: &Range, gravity: T) -> Result<Option<Self>, OutOfRange> {
        let Some((balancing, weights)) = balancing::new(p, range)?.zip(p.weights) else {
            return Ok(None);
        };
        let weight = balancing.balance.weight();
        Ok(Some(Counterweight {
            balancing: balancing.map(Dual2::from_re),
            weights: weights.map(&mut |_, value| Dual2::from_re(value)),
            mass: weight.map_or(T::constant(0.0), |weight| weight / gravity),
        }))
    }
}

/// How bodies, head and drive move with the driven bar, by derivatives of the positions.
#[derive(Clone, Copy)]
pub(super) struct Moves<C> {
    /// Boom, jib and rocker.
    pub bodies: [Moved<C>; 3],
    /// Mass (kg) and place of the counterweight.
    pub counterweight: Option<(C, [Point<C>; 3])>,
    pub head: [Point<C>; 3],
    pub drive: [C; 2],
    pub turn: [C; 2],
}

/// A body's centre of gravity: place, first and second derivative by the driven angle, in m; square of the body's
/// turning by it, and half of how that changes.
#[derive(Clone, Copy)]
pub(super) struct Moved<C> {
    pub centre: [Point<C>; 3],
    pub turn: [C; 2],
}

impl<T: Calc + DualNum> Moves<T> {
    #[inline]
    pub(super) fn new<P: Calc>(d: &Dynamics<P>, positions: &Positions<T>, theta: T) -> Option<Self>
    where
        T: Over<P>,
    {
        let (bodies, push) = (&d.bodies, d.push.as_ref().filter(|_| d.by_cylinder));
        let (zero, one) = (T::constant(0.0), T::constant(1.0));
        let (g, theta) = (&positions.geometry, Dual2::new(theta, one, zero));
        let p = Position::new(g, theta)?;
        let bars = bars(g, &p);
        let moved = |body: &Body<P>, bar: &Bar<T>| Moved {
            centre: bar.point(body.centre.map(T::of)),
            turn: [bar.turn, bar.turn_change],
        };
        let mut counterweight = None;
        if let Some(Counterweight {
            balancing,
            weights,
            mass,
        }) = &positions.counterweight
        {
            counterweight = Some((*mass, balancing::place(balancing, g, weights, &p, theta)?));
        }
        let turn = d
            .turntable
            .as_ref()
            .map_or([zero; 2], |table| turned_inertia(table, bodies, &bars, counterweight));
        let drive = push.map_or([zero; 2], |push| {
            let [line, d] = push.line(g.driven, &bars);
            let length = plane::length(line);
            [length, dot(line, d) / length]
        });
        Some(Moves {
            bodies: [
                moved(&bodies.boom, &bars[0]),
                moved(&bodies.jib, &bars[1]),
                moved(&bodies.rocker, &bars[2]),
            ],
            counterweight: counterweight.map(|(mass, place)| (mass, parts(place))),
            head: parts(p.a),
            drive,
            turn,
        })
    }
}

impl<C: Calc> Reduced<C> {
    /// The sum over all bodies.
    #[inline]
    pub(super) fn of<P: Calc>(bodies: &Bodies<P>, moves: Moves<C>) -> Self
    where
        C: Over<P>,
    {
        let zero = C::constant(0.0);
        let (mut inertia, mut slope, mut moment, mut energy) = (zero, zero, zero, zero);
        let parts = [&bodies.boom, &bodies.jib, &bodies.rocker]
            .into_iter()
            .zip(&moves.bodies);
        for ((body, moved), names) in parts.zip(&s::OF_BODY) {
            let own = body.mass.def(names.mass);
            let (mass, spin) = (C::of(own), C::of(body.inertia));
            let weight = C::of(own * bodies.gravity);
            let ([r, v, a], [turn, turn_change]) = (moved.centre, moved.turn);
            inertia += (mass * squared(v) + spin * turn).def(names.inertia);
            slope += (C::constant(2.0) * (mass * dot(v, a) + spin * turn_change)).def(names.slope);
            moment += weight * v.y;
            energy += weight * r.y;
        }
        if let Some((mass, [r, v, a])) = moves.counterweight {
            let weight = mass * C::of(bodies.gravity);
            inertia += (mass * squared(v)).def(&s::I_R5);
            slope += (C::constant(2.0) * mass * dot(v, a)).def(&s::DI_R5);
            moment += weight * v.y;
            energy += weight * r.y;
        }
        Reduced {
            inertia: inertia.def(&s::I_R),
            slope: slope.def(&s::DI_R),
            moment: moment.def(&s::M_W),
            energy,
            head: moves.head,
            drive: moves.drive,
            turn: moves.turn,
        }
    }
}

impl<T: Calc + DualNum> Reduced<T> {
    #[inline]
    fn new<P: Calc>(d: &Dynamics<P>, positions: &Positions<T>, theta: T) -> Option<Self>
    where
        T: Over<P>,
    {
        Some(Reduced::of(&d.bodies, Moves::new(d, positions, theta)?))
    }
}

/// Boom, jib and rocker.
#[inline]
pub(super) fn bars<T: Calc + DualNum>(g: &Geometry<Dual2<T>>, p: &Position<Dual2<T>>) -> [Bar<T>; 3] {
    let zero = Dual2::from_re(T::constant(0.0));
    [
        Bar::new(Point::new(zero, zero), p.x_1),
        Bar::new(p.b, p.x_2),
        Bar::new(g.lengths.o3(), p.x_3),
    ]
}

/// A bar with its derivatives by the driven angle.
pub(super) struct Bar<T> {
    pub joint: [Point<T>; 3],
    pub along: [Point<T>; 3],
    pub length: T,
    /// Square of its turning by the driven angle, and half of how that changes.
    turn: T,
    turn_change: T,
}

impl<T: Calc + DualNum> Bar<T> {
    #[inline]
    fn new(joint: Point<Dual2<T>>, along: Point<Dual2<T>>) -> Bar<T> {
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
pub(super) fn spread<C: Calc>([xx, xy, yy]: [C; 3], along: Point<C>) -> C {
    let (along, across) = (along.x, -along.y);
    xx * along * along + xy * along * across * C::constant(2.0) + yy * across * across
}

/// Value, first and second derivative.
pub(super) fn parts<T: Calc + DualNum>(v: Point<Dual2<T>>) -> [Point<T>; 3] {
    [v.map(|x| x.re), v.map(|x| x.v1), v.map(|x| x.v2)]
}

/// Inertia of all bodies about the slewing axis (kg·m²), and its change by the driven angle; the counterweight
/// by its mass (kg) and place (m).
fn turned_inertia<P: Calc, T: Calc + DualNum + Over<P>>(
    table: &Turntable<P>,
    bodies: &Bodies<P>,
    bars: &[Bar<T>; 3],
    counterweight: Option<(T, Point<Dual2<T>>)>,
) -> [T; 2] {
    let axis = Dual2::from_re(T::of(table.axis));
    let bodies = [&bodies.boom, &bodies.jib, &bodies.rocker].into_iter().zip(bars);
    let bodies = bodies.map(|(body, bar)| {
        let [r, v, a] = bar.point(body.centre.map(T::of));
        let mass = Dual2::from_re(T::of(body.mass));
        let spread = bar.spread(body.spread.map(T::of));
        (mass, Dual2::new(r.x, v.x, a.x) - axis, Some(spread))
    });
    let counterweight = counterweight.map(|(mass, place)| (Dual2::from_re(mass), place.x - axis, None));
    let sum = about_axis(Dual2::from_re(T::of(table.inertia)), bodies.chain(counterweight));
    [sum.re, sum.v1]
}

/// An inertia (kg·m²) with bodies: mass (kg), distance from the axis (m), inertia about the centre where it has one.
pub(super) fn about_axis<C: Calc>(inertia: C, bodies: impl Iterator<Item = (C, C, Option<C>)>) -> C {
    bodies.fold(inertia, |sum, (mass, reach, spread)| {
        let about = mass * reach * reach;
        sum + spread.map_or(about, |spread| about + spread)
    })
}

/// A scalar that the equations of motion run on, with parameters known as `P`: a number, one with its
/// derivatives by all states, or one with its derivative in one direction of states and parameters.
pub trait Coordinate<P = f64>: Over<P> {
    /// `None` where the linkage does not close.
    fn reduced(d: &Dynamics<P>, theta: Self) -> Option<Reduced<Self>>;
}

impl Coordinate for f64 {
    fn reduced(d: &Dynamics, theta: f64) -> Option<Reduced<f64>> {
        d.latest.at(theta, || Reduced::new(d, &d.twice, theta))
    }
}

impl Coordinate<Dual64> for Dual64 {
    fn reduced(d: &Dynamics<Dual64>, theta: Dual64) -> Option<Reduced<Dual64>> {
        Reduced::new(d, &d.thrice, theta)
    }
}

/// The mechanism depends on the driven angle alone, so that one more derivative by it serves all states.
impl<const N: usize> Coordinate for Gradient<N> {
    fn reduced(d: &Dynamics, theta: Gradient<N>) -> Option<Reduced<Gradient<N>>> {
        let r = Reduced::new(d, &d.thrice, Dual64::new(theta.re, 1.0))?;
        let of = |x: Dual64| theta.chain(x);
        Some(Reduced {
            inertia: of(r.inertia),
            slope: of(r.slope),
            moment: of(r.moment),
            energy: of(r.energy),
            head: [r.head[0].map(of), r.head[1].map(of), r.head[2].map(of)],
            drive: [of(r.drive[0]), of(r.drive[1])],
            turn: r.turn.map(of),
        })
    }
}

/// What the mechanism was at the angle (rad) that was asked for last: rates, events, powers and forces of one instant
/// all ask.
#[derive(Clone, Debug, Default)]
struct Latest(Cell<Option<(f64, Reduced<f64>)>>);

impl Latest {
    #[inline]
    fn at(&self, theta: f64, find: impl FnOnce() -> Option<Reduced<f64>>) -> Option<Reduced<f64>> {
        match self.0.get() {
            Some((at, found)) if at.to_bits() == theta.to_bits() => Some(found),
            _ => {
                let found = find()?;
                self.0.set(Some((theta, found)));
                Some(found)
            }
        }
    }
}

/// The mechanism with its bodies.
#[derive(Clone, Debug)]
pub struct Dynamics<P = f64> {
    /// For two and for three derivatives.
    pub(super) twice: Positions<f64>,
    pub(super) thrice: Positions<Dual64>,
    /// What its balance is made from, for the book.
    pub(super) quantities: Option<(Parameters<P>, Range)>,
    pub(super) push: Option<Push<P>>,
    /// The equations of motion ask for the drive.
    pub(super) by_cylinder: bool,
    turntable: Option<Turntable<P>>,
    bodies: Bodies<P>,
    latest: Latest,
}

/// A drive's line from a point of the frame to one of the driven bar, in its frame, in m.
#[derive(Clone, Copy, Debug)]
pub(super) struct Push<P> {
    from: Point<P>,
    to: Point<P>,
}

impl<P: Calc> Push<P> {
    /// The line, and how it changes with the driven angle.
    #[inline]
    pub fn line<T: Calc + DualNum + Over<P>>(&self, driven: Driven, bars: &[Bar<T>; 3]) -> [Point<T>; 2] {
        let bar = match driven {
            Driven::Boom => &bars[0],
            Driven::Rocker => &bars[2],
        };
        let [r, d, _] = bar.point(self.to.map(T::of));
        [r - self.from.map(T::of), d]
    }
}

impl<P: Calc> Dynamics<P> {
    #[must_use]
    pub fn new(geometry: &Geometry<P>, bodies: Bodies<P>) -> Dynamics<P>
    where
        Dual64: Over<P>,
    {
        Dynamics {
            twice: Positions {
                geometry: geometry.map(|x| Dual2::from_re(x.value())),
                counterweight: None,
            },
            thrice: Positions {
                geometry: geometry.map(|x| Dual2::from_re(Dual64::of(x))),
                counterweight: None,
            },
            quantities: None,
            push: None,
            by_cylinder: false,
            turntable: None,
            bodies,
            latest: Latest::default(),
        }
    }

    /// With the balance of the same mechanism's parameters, if they have one, over its working range.
    ///
    /// # Errors
    /// Quantities with which there is no such balance.
    pub fn with_balance(mut self, p: &Parameters<P>, range: &Range) -> Result<Dynamics<P>, OutOfRange>
    where
        Dual64: Over<P>,
    {
        self.quantities = Some((*p, *range));
        let gravity = self.bodies.gravity;
        let values = p.values();
        self.twice.counterweight = Counterweight::new(&values, range, gravity.value())?;
        let dual = p.map(&mut |_, value| Dual64::of(value));
        self.thrice.counterweight = Counterweight::new(&dual, range, Dual64::of(gravity))?;
        self.latest = Latest::default();
        Ok(self)
    }

    /// With a drive that pushes along a line from the frame to the driven bar; where it is a cylinder, the equations of
    /// motion ask for that line.
    #[must_use]
    pub fn with_drive(mut self, anchors: &Anchors<P>, by_cylinder: bool) -> Dynamics<P> {
        let (sin, cos) = anchors.chi_d.sin_cos();
        self.push = Some(Push {
            from: Point::new(anchors.e_x, anchors.e_y),
            to: Point::new(anchors.s_d * cos, anchors.s_d * sin),
        });
        self.by_cylinder = by_cylinder;
        self.latest = Latest::default();
        self
    }

    /// On a turntable.
    #[must_use]
    pub fn with_slewing(mut self, turntable: Turntable<P>) -> Dynamics<P> {
        self.turntable = Some(turntable);
        self.latest = Latest::default();
        self
    }

    /// Where it slews.
    #[must_use]
    pub fn turntable(&self) -> Option<Turntable<P>> {
        self.turntable
    }

    #[must_use]
    pub fn driven(&self) -> Driven {
        self.twice.geometry.driven
    }

    /// What the acceleration of the driven bar is called.
    pub(crate) fn acceleration(&self) -> &'static Symbol {
        match self.driven() {
            Driven::Boom => &s::D_OMEGA_1,
            Driven::Rocker => &s::D_OMEGA_3,
        }
    }

    #[must_use]
    pub fn bodies(&self) -> &Bodies<P> {
        &self.bodies
    }

    /// The pendulum's part of the equations of motion, for the coordinates (theta, swing).
    fn pendulum<C: Coordinate<P>>(&self, r: &Reduced<C>, m: &Phase<C>, load: &Pendulum<P>, reel: Reel<C>) -> Swing<C> {
        let [_, d, dd] = r.head;
        let (sin, cos) = m.swing.sin_cos();
        // Directions of the load's motion when the rope swings, and of its centripetal acceleration.
        let (swing, inward) = (Point::new(cos, sin), Point::new(-sin, cos));
        let (mass, gravity, l) = (C::of(load.mass), C::of(self.bodies.gravity), reel.length);
        let any = C::of(load.cancelling());
        let pull = reel.less_gain(l * m.swing_rate.square());
        let coriolis = C::constant(2.0) * reel.rate * m.swing_rate;
        let square = m.omega.square();
        let forward = dot(d, swing).def(&s::D_PHI);
        let along = dot(d, inward).def(&s::D_N);
        let (bend, change) = (dot(d, dd).def(&s::Q_A), dot(dd, swing).def(&s::DD_PHI));
        let own = (mass * squared(d)).def(&s::M_11);
        let coupled = (mass * l * forward).def(&s::M_12);
        Swing {
            own,
            coupled,
            back: if any == mass {
                coupled
            } else {
                (any * l * forward).def(&s::M_21)
            },
            inertia: (any * l.square()).def(&s::M_22),
            forces: [
                (-mass * (bend * square + along * pull + forward * coriolis + gravity * d.y)).def(&s::TAU_1),
                (-any * l * (change * square + coriolis + gravity * sin)).def(&s::TAU_2),
            ],
        }
    }

    /// Accelerations of the driven bar and of the rope (rad/s²) under a moment on the driven bar
    /// (N·m, positive raises it), with what the mechanism is at this angle.
    #[inline]
    pub fn motion<C: Coordinate<P>>(&self, r: &Reduced<C>, m: &Phase<C>, moment: C, reel: Reel<C>) -> [C; 2] {
        let driven = (moment - r.moment - C::constant(0.5) * r.slope * m.omega.square()).def(&s::M_NET);
        let Some(load) = &self.bodies.pendulum else {
            return [(driven / r.inertia).def(self.acceleration()), C::constant(0.0)];
        };
        let swing = self.pendulum(r, m, load, reel);
        let (m_12, m_21, m_22, [f_1, f_2]) = (swing.coupled, swing.back, swing.inertia, swing.forces);
        // M q″ = f.
        let (m_11, f_1) = (r.inertia + swing.own, driven + f_1);
        let determinant = m_11 * m_22 - m_12 * m_21;
        [
            ((f_1 * m_22 - m_12 * f_2) / determinant).def(self.acceleration()),
            ((m_11 * f_2 - m_21 * f_1) / determinant).def(&s::D_OMEGA_R),
        ]
    }

    /// Moment on the driven bar (N·m) that keeps it at rest, and the acceleration of the rope (rad/s²) with it.
    #[must_use]
    pub fn hold<C: Coordinate<P>>(&self, r: &Reduced<C>, m: &Phase<C>, reel: Reel<C>) -> [C; 2] {
        let Some(load) = &self.bodies.pendulum else {
            return [r.moment, C::constant(0.0)];
        };
        let swing = self.pendulum(r, m, load, reel);
        let (m_22, [f_1, f_2]) = (swing.inertia, swing.forces);
        [
            r.moment - f_1 + swing.coupled * f_2 / m_22,
            (f_2 / m_22).def(&s::D_OMEGA_R),
        ]
    }
}

impl Dynamics {
    /// How much the rope's rate changes, over how much the driven bar's does, in a blow on the driven bar.
    #[must_use]
    pub fn blow(&self, r: &Reduced<f64>, m: &Phase, reel: Reel<f64>) -> f64 {
        self.bodies.pendulum.as_ref().map_or(0.0, |load| {
            let swing = self.pendulum(r, m, load, reel);
            -swing.back / swing.inertia
        })
    }

    /// Inertia at the driven bar at an angle (rad) in kg·m², the load as if it were fixed to the head;
    /// `None` where the linkage does not close.
    #[must_use]
    pub fn inertia(&self, theta: f64) -> Option<f64> {
        let r = f64::reduced(self, theta)?;
        let load = self.bodies.pendulum.map_or(0.0, |p| p.mass);
        Some(r.inertia + load * r.head[1].norm_squared())
    }

    /// Accelerations of the driven bar and of the rope (rad/s²) under a moment on the driven bar
    /// (N·m, positive raises it); `None` where the linkage does not close.
    #[must_use]
    pub fn accelerations(&self, m: &Phase, moment: f64) -> Option<[f64; 2]> {
        let r = f64::reduced(self, m.theta)?;
        let length = self.bodies.pendulum.map_or(0.0, |p| p.length);
        Some(self.motion(&r, m, moment, Reel::still(length)))
    }

    /// Kinetic and potential energy, in J; `None` where the linkage does not close.
    #[must_use]
    pub fn energy(&self, m: &Phase) -> Option<f64> {
        let r = f64::reduced(self, m.theta)?;
        let bars = 0.5 * r.inertia * m.omega * m.omega + r.energy;
        let Some(Pendulum { mass, length, .. }) = self.bodies.pendulum else {
            return Some(bars);
        };
        let [a, d, _] = r.head;
        let (sin, cos) = Calc::sin_cos(m.swing);
        let velocity = d * m.omega + Point::new(cos, sin) * (length * m.swing_rate);
        let height = a.y - length * cos;
        Some(bars + mass * (0.5 * velocity.norm_squared() + self.bodies.gravity * height))
    }

    /// One step of the classical Runge-Kutta method of fourth order, of `h` s, under a constant
    /// moment (N·m); `None` where the linkage does not close on the way.
    #[must_use]
    pub fn step(&self, m: &Phase, moment: f64, h: f64) -> Option<Phase> {
        let phase = |&[theta, omega, swing, swing_rate]: &[f64; 4]| Phase {
            theta,
            omega,
            swing,
            swing_rate,
        };
        let start = [m.theta, m.omega, m.swing, m.swing_rate];
        let end = runge_kutta::step(&start, h, |y| {
            let [alpha, swing] = self.accelerations(&phase(y), moment)?;
            Some([y[1], alpha, y[3], swing])
        })?;
        Some(phase(&end))
    }
}

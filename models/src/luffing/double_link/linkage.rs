//! The double link with its bodies, as the equations of motion see it: positions are run with second-order dual numbers,
//! and what bodies do follows from their derivatives.

use num_dual::{Dual2, Dual64, DualNum};

use crate::drive::mount::Anchors;
use crate::kernel::allowed::OutOfRange;
use crate::kernel::calc::{Calc, Over, Takes};
use crate::luffing::balancing::Balancing;
use crate::luffing::double_link::balancing;
use crate::luffing::double_link::geometry::Geometry;
use crate::luffing::double_link::leading::JIB;
use crate::luffing::double_link::moving::symbols as s;
use crate::luffing::double_link::parameters::{Driven, Parameters, Weights};
use crate::luffing::double_link::position::Position;
use crate::luffing::led::reeved::Reeved;
use crate::luffing::moving::bodies::{
    Asked, Bar, Body, MovedBody, Moves, Pendulum, hung, parts, turned_inertia, weighed_forward,
};
use crate::luffing::moving::reduced::Reduced;
use crate::parts::motion::Motion as Range;
use crate::parts::plane::{self, Point, dot};

/// Bodies that the mechanism moves.
#[derive(Clone, Copy, Debug)]
pub struct Bodies<P = f64> {
    pub boom: Body<P>,
    pub jib: Body<P>,
    pub rocker: Body<P>,
    pub pendulum: Option<Pendulum<P>>,
    /// Mass of a load on a led rope on which it does not swing, in kg.
    pub load: Option<P>,
    /// In m/s².
    pub gravity: P,
}

impl<P> Bodies<P> {
    pub(crate) fn bars(&self) -> [&Body<P>; 3] {
        [&self.boom, &self.jib, &self.rocker]
    }
}

/// Positions with their first and second derivatives by the driven angle.
#[derive(Copy, Debug)]
pub(crate) struct Positions<T> {
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
pub(crate) struct Counterweight<T> {
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

/// Boom, jib and rocker.
#[inline]
pub(crate) fn bars<T: Calc + DualNum>(g: &Geometry<Dual2<T>>, p: &Position<Dual2<T>>) -> [Bar<T>; 3] {
    let zero = Dual2::from_re(T::constant(0.0));
    [
        Bar::new(Point::new(zero, zero), p.x_1),
        Bar::new(p.b, p.x_2),
        Bar::new(g.lengths.o3(), p.x_3),
    ]
}

/// The mechanism with its bodies.
#[derive(Clone, Debug)]
pub struct HeavyLinkage<P = f64> {
    /// For two and for three derivatives.
    pub(crate) twice: Positions<f64>,
    pub(crate) thrice: Positions<Dual64>,
    /// What its balance is made from, for the book.
    pub(crate) quantities: Option<(Parameters<P>, Range)>,
    pub(crate) push: Option<Push<P>>,
    pub(crate) led: Option<Reeved<P>>,
    pub(crate) bodies: Bodies<P>,
}

/// A drive's line from a point of the frame to one of the driven bar, in its frame, in m.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Push<P> {
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

impl<P: Calc> HeavyLinkage<P> {
    #[must_use]
    pub fn new(geometry: &Geometry<P>, bodies: Bodies<P>) -> HeavyLinkage<P>
    where
        Dual64: Over<P>,
    {
        HeavyLinkage {
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
            led: None,
            bodies,
        }
    }

    /// With the balance of the same mechanism's parameters, if they have one, over its working range.
    ///
    /// # Errors
    /// Quantities with which there is no such balance.
    pub fn with_balance(mut self, p: &Parameters<P>, range: &Range) -> Result<HeavyLinkage<P>, OutOfRange>
    where
        Dual64: Over<P>,
    {
        self.quantities = Some((*p, *range));
        let gravity = self.bodies.gravity;
        let values = p.values();
        self.twice.counterweight = Counterweight::new(&values, range, gravity.value())?;
        let dual = p.map(&mut |_, value| Dual64::of(value));
        self.thrice.counterweight = Counterweight::new(&dual, range, Dual64::of(gravity))?;
        Ok(self)
    }

    /// With a drive that pushes along a line from the frame to the driven bar.
    #[must_use]
    pub fn with_drive(mut self, anchors: &Anchors<P>) -> HeavyLinkage<P> {
        let (sin, cos) = anchors.chi_d.sin_cos();
        self.push = Some(Push {
            from: Point::new(anchors.e_x, anchors.e_y),
            to: Point::new(anchors.s_d * cos, anchors.s_d * sin),
        });
        self
    }

    /// With a hoist rope that is led over sheaves, where it has one.
    #[must_use]
    pub fn with_rope(self, led: Option<Reeved<P>>) -> HeavyLinkage<P> {
        HeavyLinkage { led, ..self }
    }

    #[must_use]
    pub fn driven(&self) -> Driven {
        self.twice.geometry.driven
    }

    #[inline]
    pub(crate) fn moves<T: Calc + DualNum + Over<P>>(
        &self,
        positions: &Positions<T>,
        theta: T,
        asked: &Asked<P>,
    ) -> Option<Moves<T, 3>> {
        let push = self.push.as_ref().filter(|_| asked.drive);
        let (zero, one) = (T::constant(0.0), T::constant(1.0));
        let (g, theta) = (&positions.geometry, Dual2::new(theta, one, zero));
        let p = Position::new(g, theta)?;
        let (bodies, bars) = (self.bodies.bars(), bars(g, &p));
        let mut counterweight = None;
        if let Some(Counterweight {
            balancing,
            weights,
            mass,
        }) = &positions.counterweight
        {
            counterweight = Some((*mass, parts(balancing::place(balancing, g, weights, &p, theta)?)));
        }
        let head = parts(p.a);
        let led = match &self.led {
            Some(led) => Some(led.moves((JIB, head), |bar, at| bars[bar].point(at.map(T::of)))?),
            None => None,
        };
        let load = self
            .bodies
            .load
            .zip(led)
            .map(|(mass, led)| (T::of(mass), hung(head, led.raised, led.lead)));
        let points = || [load, counterweight].into_iter().flatten();
        let turn = asked
            .turntable
            .as_ref()
            .map_or([zero; 2], |table| turned_inertia(table, bodies, &bars, points()));
        let moved: [MovedBody<T>; 3] = std::array::from_fn(|i| bars[i].moved(bodies[i]));
        let drive = push.map_or([zero; 2], |push| {
            let [line, d] = push.line(g.driven, &bars);
            let length = plane::length(line);
            [length, dot(line, d) / length]
        });
        Some(Moves {
            weighed: asked.turntable.filter(|_| asked.leans).map(|table| {
                let (gravity, axis) = (T::of(self.bodies.gravity), T::of(table.axis));
                let each = bodies.into_iter().zip(&moved);
                let each = each.map(|(body, moved)| (T::of(body.mass), moved.centre));
                let of = |(mass, [at, travel, _]): (T, [Point<T>; 3])| [mass * gravity, at.x - axis, travel.x];
                weighed_forward(each.chain(points()).map(of))
            }),
            bodies: moved,
            load,
            counterweight,
            head,
            drive,
            turn,
            lead: led.filter(|_| load.is_none()).map(|led| led.lead),
        })
    }

    #[inline]
    pub(crate) fn reduced_by<T: Calc + DualNum + Over<P>>(
        &self,
        positions: &Positions<T>,
        theta: T,
        asked: &Asked<P>,
    ) -> Option<Reduced<T>> {
        Some(self.sum(self.moves(positions, theta, asked)?))
    }

    /// The sum over all bodies.
    #[inline]
    pub(crate) fn sum<C: Calc + Over<P>>(&self, moves: Moves<C, 3>) -> Reduced<C> {
        let names = s::OF_BODY.each_ref().map(|body| &body.sums);
        Reduced::of(self.bodies.bars(), names, self.bodies.gravity, moves)
    }
}

//! Tipping about every side of the polygon of supports.

use crate::component::stages::results;
use crate::kernel::calc::{Among, Calc};
use crate::kernel::group::quantities;
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::Fault;
use crate::parts::hull::hull;
use crate::parts::plane::{self, Point, cross};
use crate::supports::mobile::symbols as s;
use crate::supports::mobile::weights::{DeadWeight, Leaning};

quantities! {
    /// Where a support stands, in m.
    SupportPoint { x: X, y: Y }
}

impl<C: Calc> SupportPoint<C> {
    pub fn point(&self) -> Point<C> {
        Point::new(self.x, self.y)
    }

    /// By its number, from 1, in the book.
    fn numbered(&self, number: usize) -> Point<C> {
        let of = |value: C| value.among(Among::Of(number as u16), value);
        Point::new(of(self.x), of(self.y))
    }
}

/// A side of the polygon about which the crane may tip.
#[derive(Clone, Copy, Debug)]
pub struct Side<C> {
    /// Square to it, away from the crane; of length 1.
    pub out: Point<C>,
    /// From the slewing axis, positive where that lies inside, in m.
    pub away: C,
    /// From the support farthest from it, in m.
    width: C,
    /// Places of the supports at its ends, and of the farthest one.
    those: [usize; 3],
}

impl<C: Calc> Side<C> {
    /// Through two supports, with the farthest one.
    fn through([a, b, far]: [Point<C>; 3], those: [usize; 3]) -> Side<C> {
        let along = b - a;
        let length = plane::length(along);
        let out = Point::new(along.y / length, -(along.x / length));
        let away = plane::dot(out, a);
        Side {
            out,
            away,
            width: away - plane::dot(out, far),
            those,
        }
    }

    /// The same with the names of its direction and its distance.
    fn named(&self, points: &[SupportPoint<C>], [x, y, away]: [&'static Symbol; 3]) -> Side<C> {
        let [a, _, far] = self.those.map(|place| points[place].numbered(place + 1));
        let out = plane::def(self.out, [x, y]);
        let away = plane::dot(out, a).def(away);
        Side {
            out,
            away,
            width: away - plane::dot(out, far),
            those: self.those,
        }
    }

    /// Cosine of the angle between the boom and what is square to this side.
    fn facing(&self, heading: &Point<C>) -> C {
        plane::dot(self.out, *heading)
    }

    /// Moment of the crane without load about it, in N·m, where `slewing` is that of what slews, in the boom's direction.
    fn holds(&self, dead: &DeadWeight<C>, slewing: C, facing: C) -> C {
        dead.weight * self.away - plane::dot(self.out, dead.carrier) - slewing * facing
    }
}

/// All sides, counter-clockwise.
#[derive(Clone, Debug)]
pub struct Sides<C>(pub Vec<Side<C>>);

impl<C: Calc> Sides<C> {
    /// # Errors
    /// Supports on one line.
    pub fn new(points: &[SupportPoint<C>]) -> Result<Sides<C>, Fault> {
        let at = |place: usize| points[place].numbered(place + 1);
        let places: Vec<Point<f64>> = points.iter().map(|p| p.point().map(Calc::value)).collect();
        let corners = hull(&places).ok_or_else(|| {
            Fault::outside(
                "the supports stand on one line: nothing keeps the crane from tipping; set one of them aside",
            )
        })?;
        let next = corners.iter().cycle().skip(1);
        let side = |(&a, &b): (&usize, &usize)| {
            let inside = |c: &usize| cross(places[b] - places[a], places[*c] - places[a]);
            let far = corners.iter().copied().max_by(|c, d| inside(c).total_cmp(&inside(d)));
            let those = [a, b, far.expect("three at least")];
            Side::through(those.map(at), those)
        };
        Ok(Sides(corners.iter().zip(next).map(side).collect()))
    }
}

/// The least of values, each of a side; with that side.
fn least<'a, C: Calc>(each: impl Iterator<Item = (C, &'a Side<C>)>) -> Option<(C, &'a Side<C>)> {
    each.reduce(|(one, own), (other, another)| {
        if other.value() < one.value() {
            (other.over(one), another)
        } else {
            (one.over(other), own)
        }
    })
}

/// The load that tips the crane.
#[derive(Clone, Copy, Debug)]
pub struct Tipping<C> {
    /// In N; `None` where the load lies within the supports.
    pub load: Option<C>,
    /// Stands for it there: infinite.
    none: C,
}
results! { Tipping as t => { P: t.load.unwrap_or(t.none); } }

impl<C: Calc> Tipping<C> {
    /// P = M_S / a about the side where that is least. [Ports001, 7.1.4]
    pub fn new(
        points: &[SupportPoint<C>],
        sides: &Sides<C>,
        heading: &Point<C>,
        dead: &DeadWeight<C>,
        leaning: &Leaning<C>,
    ) -> Tipping<C> {
        let mut none = C::known(&s::P, f64::INFINITY);
        let load = least(sides.0.iter().filter_map(|side| {
            let facing = side.facing(heading);
            let moment = side.holds(dead, leaning.moment, facing);
            let arm = leaning.reach * facing - side.away;
            none = none.over(moment).over(arm);
            (arm.value() > 0.0).then(|| (moment / arm, side))
        }));
        // What governs, with its names.
        let load = load.map(|(load, side)| {
            let side = side.named(points, [&s::N_X, &s::N_Y, &s::D_T]);
            let facing = side.facing(heading).def(&s::C_T);
            let moment = side.holds(dead, leaning.moment, facing).def(&s::M_S);
            let arm = (leaning.reach * facing - side.away).def(&s::A_T);
            (moment / arm).over(load).def(&s::P)
        });
        Tipping { load, none }
    }
}

/// Part of the weight without load on the side opposite to a tipping line behind the boom, about the line where that is
/// least: M_S / (V_0 b) on the slope that falls to the rear.
pub fn behind<C: Calc>(
    points: &[SupportPoint<C>],
    sides: &Sides<C>,
    heading: &Point<C>,
    dead: &DeadWeight<C>,
    leaning: &Leaning<C>,
) -> C {
    let part = least(sides.0.iter().filter_map(|side| {
        let facing = side.facing(heading);
        let part = || side.holds(dead, leaning.against, facing) / (dead.weight * side.width);
        (facing.value() < 0.0).then(|| (part(), side))
    }));
    let (part, side) = part.expect("a polygon has a side behind the boom");
    let side = side.named(points, [&s::N_RX, &s::N_RY, &s::D_R]);
    let width = side.width.def(&s::B_R);
    let moment = side.holds(dead, leaning.against, side.facing(heading)).def(&s::M_SR);
    (moment / (dead.weight * width)).over(part).def(&s::S_BACK)
}

//! What the bodies come to at a position, by derivatives of their places.

use crate::component::stages::{Found, results};
use crate::kernel::calc::Calc;
use crate::kernel::variable::Fault;
use crate::luffing::moving::bodies::spread_change;
use crate::luffing::resistances::given::{Case, CaseBody, CasesChoice};
use crate::luffing::resistances::placed::{BARS, MovedBars};
use crate::luffing::resistances::symbols as s;
use crate::parts::plane::{Point, dot, squared};

/// What one body comes to: its mass (kg), centre forward of the axis and its travel (m), turn, inertia reduced to the
/// luffing angle with its change, change of the inertia about the slewing axis (kg·m²).
#[derive(Clone, Copy, Debug)]
pub struct BodySums<C> {
    pub mass: C,
    pub x: C,
    pub travel: Point<C>,
    pub turn: C,
    pub inertia: [C; 2],
    pub about_axis: C,
}

impl<C: Calc> BodySums<C> {
    /// Of a bar, or of the counterweight behind them, by Lagrange's equation.
    pub fn new(moved: &MovedBars<C>, body: usize) -> BodySums<C> {
        let (two, zero) = (C::constant(2.0), C::constant(0.0));
        let (mass, spin, centre) = match moved.of.bodies.get(body) {
            Some(body) => (body.mass, body.inertia, body.centre),
            None => (moved.of.counterweight, zero, Point::new(zero, zero)),
        };
        let [r, v, a] = moved.on(body, centre);
        let (x, mut sums) = (r.x - moved.of.axis, [mass * squared(v), two * (mass * dot(v, a))]);
        let mut about_axis = two * (mass * (x * v.x));
        let mut turn = zero;
        if body < BARS {
            let [w, dw] = moved.turn(body);
            sums = [sums[0] + spin * w.square(), sums[1] + two * (spin * (w * dw))];
            about_axis += moved.spread_change(body);
            turn = w;
        }
        BodySums {
            mass,
            x,
            travel: v,
            turn,
            inertia: sums,
            about_axis,
        }
    }
}

impl<C: Calc> MovedBars<C> {
    /// How the inertia of a thin body about an upright axis through its own centre changes for one radian of the luffing
    /// angle, in kg·m².
    fn spread_change(&self, body: usize) -> C {
        let [e, d, _] = self.at.each_ref().map(|placed| placed.bars[body][1]);
        spread_change(self.of.bodies[body].spread, [e, d])
    }
}

/// Areas of a body times drag coefficients times the forward travel of their centres (m³), for one radian of the luffing angle.
pub fn swept<C: Calc>(moved: &MovedBars<C>, given: &[CaseBody<C>], choice: &CasesChoice, body: usize) -> C {
    let own = given.iter().zip(&choice.bodies).filter(|(_, on)| **on == body);
    own.fold(C::constant(0.0), |sum, (it, _)| {
        sum + it.area * it.drag * moved.on(body, it.middle())[1].x
    })
}

impl<C: Calc> CaseBody<C> {
    /// Centre of the area in the frame of its bar, in m.
    pub fn middle(&self) -> Point<C> {
        let (sin, cos) = self.chi.sin_cos();
        Point::new(self.s * cos, self.s * sin)
    }
}

/// What all bodies come to; for one radian of the luffing angle.
#[derive(Clone, Copy, Debug)]
pub struct Sums<C> {
    /// Way of the drive (m) and its change.
    pub way: [C; 2],
    /// Weights times forward travel and rise, in N·m.
    pub weighed: Point<C>,
    /// Travel of the head and rise of the load, in m.
    pub head: Point<C>,
    pub load: C,
    /// Areas times travel, in m³.
    pub swept: C,
    pub inertia: [C; 2],
    pub about_axis: C,
    /// As if every body were in its centre.
    pub points: C,
    pub own: C,
}
results! { Sums as m => { M_R_OWN: m.own; } }

impl<C: Calc> Sums<C> {
    /// The sums over all bodies, whose parts a table of the book has; M_rG = −W_Gy. [Ports001, 5.5.1; virtual work]
    ///
    /// # Errors
    /// A drive that a case moves where it points at the foot of its bar.
    pub fn new(moved: &MovedBars<C>, given: &[CaseBody<C>], cases: &[Case<C>], choice: &CasesChoice) -> Found<Sums<C>> {
        let moves = |case: &Case<C>| case.v.value() != 0.0 || case.a.value() != 0.0;
        if moved.at[1].way.value().abs() <= f64::EPSILON && cases.iter().any(moves) {
            return Err(Box::new(pointing()));
        }
        let zero = C::constant(0.0);
        let (mut weighed, mut inertia) = (Point::new(zero, zero), [zero; 2]);
        let (mut about_axis, mut points, mut area) = (zero, zero, zero);
        for body in 0..=BARS {
            let of = BodySums::new(moved, body);
            weighed += of.travel * (of.mass * moved.of.gravity);
            inertia = [inertia[0] + of.inertia[0], inertia[1] + of.inertia[1]];
            about_axis += of.about_axis;
            points += of.mass * (of.x * of.travel.x);
            area += swept(moved, given, choice, body);
        }
        let [_, travel, bend] = &moved.at;
        let weighed = Point::new(weighed.x.tabled(&s::W_GX), weighed.y.tabled(&s::W_GY));
        Ok(Sums {
            way: [travel.way.tabled(&s::DS_S), bend.way.tabled(&s::DDS_S)],
            weighed,
            head: Point::new(travel.head.x.tabled(&s::DX_H), travel.head.y.tabled(&s::DY_H)),
            load: travel.load.tabled(&s::DY_L),
            swept: area.tabled(&s::V_CA),
            inertia: [inertia[0].tabled(&s::J_R), inertia[1].tabled(&s::DJ_R)],
            about_axis: about_axis.tabled(&s::DI_Z),
            points: points.tabled(&s::D_P),
            own: (-weighed.y).def(&s::M_R_OWN),
        })
    }
}

/// Of a drive that moves where no speed of the boom is its own.
#[cold]
pub fn pointing() -> Fault {
    Fault::outside(
        "a case moves the drive where it points at the foot of its bar: no speed of the boom is that of the drive",
    )
}

//! The boom in motion: what boom and load are to the equations of motion, in closed form.

use crate::balance::boom::Plain;
use crate::kernel::calc::{Calc, Over};
use crate::kernel::group::quantities;
use crate::kernel::symbol::{Symbol, listed};
use crate::luffing::moving::bodies::{Asked, Body, MovedBody, Moves, hung};
use crate::luffing::moving::built::HoistParts;
use crate::luffing::moving::hoisting::{HoistMotor, HoistRamp, RopeGive};
use crate::luffing::moving::reduced::{CoordinateNames, Reduced};
use crate::luffing::moving::single::SingleBoom;
use crate::luffing::moving::symbols::{self as m, OfSums};
use crate::luffing::moving::weighed::Weight;
use crate::luffing::rope::balancing::OnBoom;
use crate::luffing::rope::position::{BoomChoice, Compensation, Rig};
use crate::luffing::rope::symbols as s;
use crate::parts::motion::Motion;
use crate::parts::plane::{self, Point};

quantities! {
    /// Inertia of the boom.
    BoomInertia { j_b: J_B }
}

/// Names of what is summed for the boom.
static OF_BOOM: OfSums = OfSums {
    mass: &s::MASS_B,
    inertia: &s::I_RB,
    slope: &s::DI_RB,
};

/// What a boom on a luffing rope is made of.
#[derive(Clone, Copy)]
pub struct RopedParts<C> {
    pub rig: Rig<C>,
    pub compensation: Option<Compensation<C>>,
    pub weights: Plain<C>,
    pub inertia: BoomInertia<C>,
    pub choice: BoomChoice,
}

impl<C: Calc> RopedParts<C> {
    pub fn new(
        rig: &Rig<C>,
        compensation: &Option<Compensation<C>>,
        weights: &Plain<C>,
        inertia: &BoomInertia<C>,
        choice: &BoomChoice,
    ) -> RopedParts<C> {
        RopedParts {
            rig: *rig,
            compensation: *compensation,
            weights: *weights,
            inertia: *inertia,
            choice: *choice,
        }
    }
}

/// Its hoist: a drum feels the load through the falls of its tackle.
pub fn hoist<C: Calc>(
    ramp: &Option<HoistRamp<C>>,
    motor: &Option<HoistMotor<C>>,
    give: &Option<RopeGive<C>>,
    rig: &Rig<C>,
) -> HoistParts<C> {
    HoistParts::new(ramp, motor, give, &None).led(Some(rig.m_h))
}

/// What of it moves and weighs.
#[derive(Clone, Copy)]
pub struct RopedBodies<P> {
    rig: Rig<P>,
    parts: Option<Compensation<P>>,
    /// From its foot.
    boom: Body<P>,
    /// Mass of a load that hangs straight below the head at any time, in kg.
    load: Option<P>,
}

impl<P: Calc> RopedBodies<P> {
    /// Of the hoist rope in all its parts between head and sheave, over the falls of its tackle: length, lever arm and how
    /// that changes with the boom's angle, in m; `None` where they meet.
    /// |A − B|′ = −h_S, h_S′ = (h_S² − A · B) / |A − B|.
    fn led<C: Over<P>>(&self, head: Point<C>) -> Option<[C; 3]> {
        let b = Point::new(C::of(self.rig.b_x), C::of(self.rig.b_y));
        let length = plane::length(b - head).def(&s::L_S);
        if length.value() == 0.0 {
            return None;
        }
        let falls = C::of(self.rig.m_h);
        let part = self.parts.map_or(C::constant(1.0), |parts| C::of(parts.m_k)) / falls;
        let arm = (plane::cross(head, b) / length).def(&s::H_S);
        let change = ((arm.square() - plane::dot(head, b)) / length).def(&s::DH_S);
        Some([
            part * length,
            (part * arm).def(&m::DL_R),
            (part * change).def(&m::DDL_R),
        ])
    }
}

/// A boom on a luffing rope, as its equations of motion see it.
#[derive(Clone, Copy, Debug)]
pub struct Roped;

impl SingleBoom for Roped {
    type Own<C: Calc> = RopedParts<C>;
    type Stands = OnBoom;
    type Bodies<P: Calc> = RopedBodies<P>;

    const NAMES: CoordinateNames = CoordinateNames {
        acceleration: &s::D_OMEGA,
        stops: [&s::FROM, &s::TO],
    };
    const RATES: &'static [&'static Symbol] = listed!(s: D_PHI, D_OMEGA);
    const PULLED: bool = true;

    fn range<C: Calc>(own: &RopedParts<C>) -> (Motion, C) {
        (own.choice.range, -own.rig.x_8)
    }

    fn stands<C: Calc>(own: &RopedParts<C>) -> (Plain<C>, BoomChoice) {
        (own.weights, own.choice)
    }

    fn bodies<P: Calc>(own: &RopedParts<P>, fixed: Option<P>, gravity: P) -> RopedBodies<P> {
        let along = Point::new(P::constant(1.0), P::constant(0.0));
        let weights = &own.weights;
        let (sin, cos) = weights.chi_b.sin_cos();
        let centre = Point::new(weights.r_b * cos, weights.r_b * sin);
        RopedBodies {
            rig: own.rig,
            parts: own.compensation,
            boom: Body::slender(weights.g_b / gravity, own.inertia.j_b, centre, along),
            load: fixed,
        }
    }

    fn load<P: Over<P>>(of: &RopedBodies<P>, phi: P) -> Option<(P, [Point<P>; 3])> {
        let mass = of.load?;
        let (sin, cos) = phi.sin_cos();
        let head = plane::turned(Point::new(cos, sin), of.rig.l, of.rig.f_a);
        let head = plane::def(head, [&s::A_X, &s::A_Y]);
        let travel = plane::def(Point::new(-head.y, head.x), [&s::DA_X, &s::DA_Y]);
        let [raised, lead, change] = of.led(head)?;
        Some((
            mass.def(&m::MASS_Q),
            hung([head, travel, -head], raised, [lead, change]),
        ))
    }

    /// `None` where the head is at the sheave. What turns about the foot has x″ = −x, y″ = −y.
    fn at<P: Calc, C: Over<P>>(
        of: &RopedBodies<P>,
        (gravity, asked): (P, &Asked<P>),
        phi: C,
        counterweight: Option<Weight<C>>,
    ) -> Option<Reduced<C>> {
        let (sin, cos) = phi.sin_cos();
        let place = |x: P, y: P| Point::new(C::of(x) * cos - C::of(y) * sin, C::of(x) * sin + C::of(y) * cos);
        let turned = |p: Point<C>| Point::new(-p.y, p.x);
        let centre = plane::def(place(of.boom.centre.x, of.boom.centre.y), [&s::S_BX, &s::S_BY]);
        let head = plane::def(place(of.rig.l, of.rig.f_a), [&s::A_X, &s::A_Y]);
        let travel = plane::def(turned(head), [&s::DA_X, &s::DA_Y]);
        let led = of.led(head)?;
        let boom = MovedBody {
            centre: [centre, turned(centre), -centre],
            turn: [1.0, 0.0].map(C::constant),
        };
        let along = Point::new(cos, sin);
        let lies = Some([along, turned(along)]);
        let [raised, lead, change] = led;
        let load = of
            .load
            .map(|mass| (C::of(mass), hung([head, travel, -head], raised, [lead, change])));
        let (bend, lead) = match load {
            None => (plane::def(-head, [&m::DDA_X, &m::DDA_Y]), Some([lead, change])),
            Some(_) => (-head, None),
        };
        let moves = Moves::in_plane([boom], counterweight, [head, travel, bend], lead);
        let moves = moves.hanging(load).turning((gravity, asked), [&of.boom], [lies]);
        Some(Reduced::of([&of.boom], [&OF_BOOM], gravity, moves))
    }
}

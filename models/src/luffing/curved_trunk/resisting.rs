//! Boom and trunk as their drive feels them: where they are, and what their pins carry in a case.

use crate::balance::residual::Residual;
use crate::component::scalar::Scalar;
use crate::component::stages::Found;
use crate::drive::line::Drive;
use crate::drive::way::DriveWay;
use crate::kernel::calc::Calc;
use crate::luffing::balancing::Balancing;
use crate::luffing::curved_trunk::balancing::energy;
use crate::luffing::curved_trunk::contact::direction;
use crate::luffing::curved_trunk::position::TrunkPosition;
use crate::luffing::curved_trunk::statics::TrunkWeights;
use crate::luffing::curved_trunk::tail::{TrunkChoice, TrunkTail};
use crate::luffing::led::pull::LedPull;
use crate::luffing::led::reeved::Reeved;
use crate::luffing::moving::bodies::Body;
use crate::luffing::resistances::friction::{Pin, Pins, Rubbed};
use crate::luffing::resistances::given::{CaseBody, CasesChoice};
use crate::luffing::resistances::loads::{Carrying, Loads};
use crate::luffing::resistances::moments::Resisted;
use crate::luffing::resistances::placed::{BARS, MovedBars, Placed, Placing, Weighty};
use crate::luffing::resistances::scene::CaseParts;
use crate::luffing::resistances::symbols as s;
use crate::parts::plane::{Point, cross};

/// Bars and pins in their order.
pub const PARTS: CaseParts = CaseParts {
    bodies: &["boom", "trunk"],
    pins: &["O1", "B"],
    guide: None,
};

/// What the places follow from.
#[derive(Clone)]
pub struct TrunkPlaces<C> {
    tail: TrunkTail<C>,
    choice: TrunkChoice,
    weights: TrunkWeights<C>,
    balancing: Option<Balancing<C>>,
    reeved: Option<Reeved<C>>,
    way: DriveWay<C>,
}

/// How they follow from that.
pub struct OfTrunk;

impl Placing for OfTrunk {
    type Of<C: Calc> = TrunkPlaces<C>;

    #[inline(always)]
    fn map<C: Calc, D: Calc>(of: &TrunkPlaces<C>, f: fn(C) -> D) -> TrunkPlaces<D> {
        TrunkPlaces {
            tail: of.tail.map(f),
            choice: of.choice.clone(),
            weights: of.weights.map(&mut |_, x| f(x)),
            balancing: of.balancing.map(|balancing| balancing.map(f)),
            reeved: of.reeved.map(|reeved| reeved.map(f)),
            way: of.way.map(f),
        }
    }

    #[inline(always)]
    fn placed<C: Calc>(of: &TrunkPlaces<C>, phi: C) -> Option<Placed<C>> {
        let (trunk, zero) = (&of.tail.trunk, C::constant(0.0));
        let (nothing, (sin, cos)) = (Point::new(zero, zero), phi.sin_cos());
        let (line, b) = (Point::new(cos, sin), Point::new(trunk.b * cos, trunk.b * sin));
        let along = direction(&of.tail, &of.choice, phi).ok()?;
        let head = b + along * trunk.a;
        let counterweight = match &of.balancing {
            Some(balancing) => balancing.place(phi, || energy(&of.tail, &of.weights, phi, along))?,
            None => nothing,
        };
        Some(Placed {
            bars: [[nothing, line], [b, along], [b, along]],
            head,
            load: head.y,
            counterweight,
            way: of.way.at(phi)?,
        })
    }

    fn bodies<C: Calc>(of: &TrunkPlaces<C>, j: [C; BARS], g: C) -> [Body<C>; BARS] {
        let w = &of.weights;
        [
            Body::along_bar(w.g_b, g, j[0], [w.r_b, w.chi_b]),
            Body::along_bar(w.g_t, g, j[1], [w.r_t, w.chi_t]),
            Body::nothing(),
        ]
    }

    fn balancing<C: Calc>(of: &TrunkPlaces<C>) -> Option<&Balancing<C>> {
        of.balancing.as_ref()
    }

    fn axis<C: Calc>(of: &TrunkPlaces<C>) -> C {
        -of.tail.trunk.x_8
    }
}

impl<C: Calc> TrunkPlaces<C> {
    pub fn new(
        tail: &TrunkTail<C>,
        choice: &TrunkChoice,
        weights: &TrunkWeights<C>,
        balancing: Option<&Balancing<C>>,
        reeved: Option<&Reeved<C>>,
        way: &DriveWay<C>,
    ) -> TrunkPlaces<C> {
        TrunkPlaces {
            tail: *tail,
            choice: choice.clone(),
            weights: *weights,
            balancing: balancing.copied(),
            reeved: reeved.copied(),
            way: *way,
        }
    }
}

/// What weighs of it.
pub fn weighty<C: Calc>(places: &TrunkPlaces<C>, bodies: &[CaseBody<C>], choice: &CasesChoice) -> Weighty<C> {
    Weighty::new::<OfTrunk>(places, bodies, choice)
}

/// How that moves.
///
/// # Errors
/// An angle at which mechanism, balance or crank do not close.
pub fn moved<C: Scalar>(
    places: &TrunkPlaces<C>,
    weighty: &Weighty<C>,
    residual: Option<&Residual<C>>,
    phi: &C,
) -> Found<MovedBars<C>> {
    MovedBars::new::<OfTrunk>(places, weighty, residual, *phi)
}

/// What the pins carry in a case, by equilibrium of trunk and boom: the tie holds the trunk against turning about B.
pub fn pins<C: Calc>(
    p: &TrunkPosition<C>,
    drive: &Drive<C>,
    residual: Option<&Residual<C>>,
    rope: Option<&LedPull<C>>,
    moved: &MovedBars<C>,
    loads: &Loads<C>,
    resisted: &Resisted<C>,
) -> Pins<C> {
    let (zero, [boom, trunk]) = (C::constant(0.0), [0, 1].map(|bar| moved.turn(bar)[0]));
    let [(f_b, _), (f_t, m_t), _] = loads.bars;
    let carrying = Carrying::new(residual, moved, loads);
    let (mut on_boom, mut on_trunk) = (f_b, f_t + loads.head);
    let mut about_b = m_t + cross(p.front, loads.head);
    if let Some(rope) = rope {
        let [boom, trunk] = [0, 1].map(|bar| rope.by(bar, loads.load));
        on_boom += boom.force;
        on_trunk += trunk.force;
        about_b += trunk.moment;
    }
    let tie = p.tie * (-about_b / p.h_t);
    let at_b = -(on_trunk + tie);
    let frame = at_b - on_boom - carrying.on_boom;
    let push = drive.along(-resisted.sum / drive.h_d);
    let frame = push.map_or(frame, |push| frame - push);
    let own = [Pin::new(frame, [boom, zero]), Pin::new(at_b, [trunk, boom])];
    Pins::new(own, &carrying, boom)
}

/// Force of the drive, in N.
pub fn force<C: Calc>(drive: &Drive<C>, rubbed: &Rubbed<C>) -> C {
    drive.force(-rubbed.sum, &s::F_R)
}

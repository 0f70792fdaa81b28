//! Boom and link as their drive feels them: where they are, and what pins and guide carry in a case.

use crate::balance::residual::Residual;
use crate::component::scalar::Scalar;
use crate::component::stages::Found;
use crate::drive::line::Drive;
use crate::drive::way::DriveWay;
use crate::kernel::calc::Calc;
use crate::luffing::balancing::Balancing;
use crate::luffing::ellipsograph::position::{Bars, GuidedPosition, axes};
use crate::luffing::ellipsograph::statics::{GuidedWeights, WeightMoment};
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
    bodies: &["boom", "link"],
    pins: &["O1", "C", "B"],
    guide: Some("B"),
};

/// What the places follow from.
#[derive(Clone, Copy)]
pub struct GuidedPlaces<C> {
    bars: Bars<C>,
    weights: GuidedWeights<C>,
    balancing: Option<Balancing<C>>,
    way: DriveWay<C>,
}

/// How they follow from that.
pub struct OfGuided;

impl Placing for OfGuided {
    type Of<C: Calc> = GuidedPlaces<C>;

    const BALANCED: usize = 1;

    #[inline(always)]
    fn map<C: Calc, D: Calc>(of: &GuidedPlaces<C>, f: fn(C) -> D) -> GuidedPlaces<D> {
        GuidedPlaces {
            bars: of.bars.map(&mut |_, x| f(x)),
            weights: of.weights.map(&mut |_, x| f(x)),
            balancing: of.balancing.map(|balancing| balancing.map(f)),
            way: of.way.map(f),
        }
    }

    #[inline(always)]
    fn placed<C: Calc>(of: &GuidedPlaces<C>, phi: C) -> Option<Placed<C>> {
        let (bars, zero) = (&of.bars, C::constant(0.0));
        let p = GuidedPosition::new(bars, &axes(bars), &phi);
        let nothing = Point::new(zero, zero);
        let link = [nothing, p.c / bars.c];
        let counterweight = match &of.balancing {
            Some(balancing) => balancing.place(p.theta_l, || WeightMoment::new(bars, &of.weights, &phi).load.u_0)?,
            None => nothing,
        };
        Some(Placed {
            bars: [[Point::new(zero, p.b_y), p.along], link, link],
            head: p.a,
            load: p.a.y,
            counterweight,
            way: of.way.at(phi)?,
        })
    }

    fn bodies<C: Calc>(of: &GuidedPlaces<C>, j: [C; BARS], g: C) -> [Body<C>; BARS] {
        let w = &of.weights;
        [
            Body::along_bar(w.g_b, g, j[0], [w.r_b, w.chi_b]),
            Body::along_bar(w.g_l, g, j[1], [w.r_l, C::constant(0.0)]),
            Body::nothing(),
        ]
    }

    fn balancing<C: Calc>(of: &GuidedPlaces<C>) -> Option<&Balancing<C>> {
        of.balancing.as_ref()
    }

    fn axis<C: Calc>(of: &GuidedPlaces<C>) -> C {
        -of.bars.x_8
    }
}

impl<C: Calc> GuidedPlaces<C> {
    pub fn new(
        bars: &Bars<C>,
        weights: &GuidedWeights<C>,
        balancing: Option<&Balancing<C>>,
        way: &DriveWay<C>,
    ) -> GuidedPlaces<C> {
        GuidedPlaces {
            bars: *bars,
            weights: *weights,
            balancing: balancing.copied(),
            way: *way,
        }
    }
}

/// What weighs of it.
pub fn weighty<C: Calc>(places: &GuidedPlaces<C>, bodies: &[CaseBody<C>], choice: &CasesChoice) -> Weighty<C> {
    Weighty::new::<OfGuided>(places, bodies, choice)
}

/// How that moves.
///
/// # Errors
/// An angle at which mechanism, balance or crank do not close.
pub fn moved<C: Scalar>(
    places: &GuidedPlaces<C>,
    weighty: &Weighty<C>,
    residual: Option<&Residual<C>>,
    phi: &C,
) -> Found<MovedBars<C>> {
    MovedBars::new::<OfGuided>(places, weighty, residual, *phi)
}

/// What pins and guide carry in a case, by equilibrium of boom and link: the guide holds the boom against turning about C.
pub fn pins<C: Calc>(
    p: &GuidedPosition<C>,
    drive: &Drive<C>,
    residual: Option<&Residual<C>>,
    moved: &MovedBars<C>,
    loads: &Loads<C>,
    resisted: &Resisted<C>,
) -> Pins<C> {
    let (zero, [boom, link]) = (C::constant(0.0), [0, 1].map(|bar| moved.turn(bar)[0]));
    let foot = moved.at[0].bars[0][0];
    let [(f_b, m_b), (f_l, _), _] = loads.bars;
    let carrying = Carrying::new(residual, moved, loads);
    let on_boom = f_b + loads.head;
    let about_c = m_b + cross(foot - p.c, f_b) + cross(p.a - p.c, loads.head);
    let guide = about_c / (foot.y - p.c.y);
    let at_c = -Point::new(on_boom.x + guide, on_boom.y);
    // It turns the link, which the boom's rising lowers.
    let push = drive.along(resisted.sum / drive.h_d);
    let frame = at_c - f_l - carrying.on_boom;
    let frame = push.map_or(frame, |push| frame - push);
    let own = [
        Pin::new(frame, [link, zero]),
        Pin::new(at_c, [boom, link]),
        Pin::Slides {
            force: guide.abs(),
            way: moved.at[1].bars[0][0].y,
        },
    ];
    Pins::new(own, &carrying, link)
}

/// Force of the drive, in N.
pub fn force<C: Calc>(drive: &Drive<C>, rubbed: &Rubbed<C>) -> C {
    drive.force(rubbed.sum, &s::F_R)
}

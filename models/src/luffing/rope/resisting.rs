//! The boom on a luffing rope as its drive feels it: where it is, and what its pins carry in a case.

use crate::balance::boom::Plain;
use crate::balance::residual::Residual;
use crate::component::scalar::Scalar;
use crate::component::stages::Found;
use crate::kernel::calc::Calc;
use crate::luffing::balancing::Balancing;
use crate::luffing::moving::bodies::Body;
use crate::luffing::resistances::friction::{Pin, Pins, Rubbed};
use crate::luffing::resistances::given::{CaseBody, CasesChoice};
use crate::luffing::resistances::loads::{Carrying, Loads};
use crate::luffing::resistances::moments::Resisted;
use crate::luffing::resistances::placed::{BARS, MovedBars, Placed, Placing, Weighty};
use crate::luffing::resistances::scene::CaseParts;
use crate::luffing::resistances::symbols as s;
use crate::luffing::rope::position::{BoomPosition, Compensation, Falls, Rig, Stretch};
use crate::luffing::strength::given::Wire;
use crate::luffing::strength::pull::Tensed;
use crate::parts::plane::Point;

/// Bars and pins in their order.
pub const PARTS: CaseParts = CaseParts {
    bodies: &["boom"],
    pins: &["O1"],
    guide: None,
};

/// What the places follow from.
#[derive(Clone, Copy)]
pub struct BoomPlaces<C> {
    rig: Rig<C>,
    parts: Option<Compensation<C>>,
    weights: Plain<C>,
    balancing: Option<Balancing<C>>,
}

/// How they follow from that.
pub struct OfBoom;

impl Placing for OfBoom {
    type Of<C: Calc> = BoomPlaces<C>;

    #[inline(always)]
    fn map<C: Calc, D: Calc>(of: &BoomPlaces<C>, f: fn(C) -> D) -> BoomPlaces<D> {
        BoomPlaces {
            rig: of.rig.map(&mut |_, x| f(x)),
            parts: of.parts.map(|parts| parts.map(&mut |_, x| f(x))),
            weights: of.weights.map(&mut |_, x| f(x)),
            balancing: of.balancing.map(|balancing| balancing.map(f)),
        }
    }

    #[inline(always)]
    fn placed<C: Calc>(of: &BoomPlaces<C>, phi: C) -> Option<Placed<C>> {
        let (rig, nothing) = (&of.rig, Point::new(C::constant(0.0), C::constant(0.0)));
        let position = BoomPosition::new(rig, &phi);
        let stretch = Stretch::new(rig, &of.parts, &position).ok()?;
        let counterweight = match &of.balancing {
            Some(balancing) => balancing.place(phi, || of.weights.load(phi).u_0)?,
            None => nothing,
        };
        Some(Placed {
            bars: [[nothing, position.along]; BARS],
            head: position.a,
            load: position.a.y + stretch.all(stretch.line.length) / rig.m_h,
            counterweight,
            way: Falls::new(rig, &position, &phi).ok()?.line.length,
        })
    }

    fn bodies<C: Calc>(of: &BoomPlaces<C>, j: [C; BARS], g: C) -> [Body<C>; BARS] {
        let w = &of.weights;
        let boom = Body::along_bar(w.g_b, g, j[0], [w.r_b, w.chi_b]);
        [boom, Body::nothing(), Body::nothing()]
    }

    fn balancing<C: Calc>(of: &BoomPlaces<C>) -> Option<&Balancing<C>> {
        of.balancing.as_ref()
    }

    fn axis<C: Calc>(of: &BoomPlaces<C>) -> C {
        -of.rig.x_8
    }
}

impl<C: Calc> BoomPlaces<C> {
    /// The drive is the luffing tackle between its ends.
    pub fn new(
        rig: &Rig<C>,
        parts: &Option<Compensation<C>>,
        weights: &Plain<C>,
        balancing: Option<&Balancing<C>>,
    ) -> BoomPlaces<C> {
        BoomPlaces {
            rig: *rig,
            parts: *parts,
            weights: *weights,
            balancing: balancing.copied(),
        }
    }
}

/// What weighs of it.
pub fn weighty<C: Calc>(places: &BoomPlaces<C>, bodies: &[CaseBody<C>], choice: &CasesChoice) -> Weighty<C> {
    Weighty::new::<OfBoom>(places, bodies, choice)
}

/// How that moves.
///
/// # Errors
/// An angle at which mechanism, balance or crank do not close.
pub fn moved<C: Scalar>(
    places: &BoomPlaces<C>,
    weighty: &Weighty<C>,
    residual: Option<&Residual<C>>,
    phi: &C,
) -> Found<MovedBars<C>> {
    MovedBars::new::<OfBoom>(places, weighty, residual, *phi)
}

/// What the foot carries in a case, and the pins of a balance: what both ropes leave. The hoist rope pulls by the weight of the
/// load, and the tackle gives the rest.
pub fn pins<C: Calc>(
    rig: &Rig<C>,
    falls: &Falls<C>,
    stretch: &Stretch<C>,
    residual: Option<&Residual<C>>,
    moved: &MovedBars<C>,
    loads: &Loads<C>,
    resisted: &Resisted<C>,
) -> Pins<C> {
    let (zero, one) = (C::constant(0.0), C::constant(1.0));
    let carrying = Carrying::new(residual, moved, loads);
    let hoist = stretch.line.force(stretch.all(loads.load) / rig.m_h);
    let tackle = falls.line.force(-resisted.sum / falls.line.arm);
    let foot = -(loads.bars[0].0 + loads.head + hoist + tackle + carrying.on_boom);
    Pins::new([Pin::new(foot, [one, zero])], &carrying, one)
}

/// Force of the tackle between its ends, in N: it pulls where negative.
pub fn force<C: Calc>(falls: &Falls<C>, rubbed: &Rubbed<C>) -> C {
    (rubbed.sum / falls.line.arm).def(&s::F_R)
}

/// The luffing rope in a case, under the force of its tackle, in N.
pub fn tensed<C: Calc>(wire: &Wire<C>, rig: &Rig<C>, force: &C) -> Tensed<C> {
    Tensed::new(wire, [rig.m_l, rig.eta_l], force)
}

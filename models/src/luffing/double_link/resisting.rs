//! The double link as its drive feels it: where its bars are, and what its pins carry in a case.

use crate::balance::residual::Residual;
use crate::component::scalar::Scalar;
use crate::component::stages::Found;
use crate::drive::line::Drive;
use crate::drive::way::DriveWay;
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::luffing::balancing::Balancing;
use crate::luffing::double_link::balancing::place;
use crate::luffing::double_link::geometry::Geometry;
use crate::luffing::double_link::leading::{height, lines};
use crate::luffing::double_link::moving::symbols as m;
use crate::luffing::double_link::parameters::{Driven, Weights};
use crate::luffing::double_link::pin_forces::{JibLoad, MomentNames, PinForces};
use crate::luffing::double_link::position::Position;
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
    bodies: &["boom", "jib", "rocker"],
    pins: &["O1", "B", "C", "O3"],
    guide: None,
};

/// What the places follow from.
#[derive(Clone, Copy)]
pub struct LinkPlaces<C> {
    geometry: Geometry<C>,
    weights: Weights<C>,
    balancing: Option<Balancing<C>>,
    reeved: Option<Reeved<C>>,
    way: DriveWay<C>,
}

/// How they follow from that.
pub struct OfLink;

impl Placing for OfLink {
    type Of<C: Calc> = LinkPlaces<C>;

    #[inline(always)]
    fn map<C: Calc, D: Calc>(of: &LinkPlaces<C>, f: fn(C) -> D) -> LinkPlaces<D> {
        LinkPlaces {
            geometry: of.geometry.map(f),
            weights: of.weights.map(&mut |_, x| f(x)),
            balancing: of.balancing.map(|balancing| balancing.map(f)),
            reeved: of.reeved.map(|reeved| reeved.map(f)),
            way: of.way.map(f),
        }
    }

    #[inline(always)]
    fn placed<C: Calc>(of: &LinkPlaces<C>, theta: C) -> Option<Placed<C>> {
        let (g, nothing) = (&of.geometry, Point::new(C::constant(0.0), C::constant(0.0)));
        let p = Position::new(g, theta)?;
        let counterweight = match &of.balancing {
            Some(balancing) => place(balancing, g, &of.weights, &p, theta)?,
            None => nothing,
        };
        Some(Placed {
            bars: lines(g, &p),
            head: p.a,
            load: height(g, of.reeved.as_ref(), &p)?,
            counterweight,
            way: of.way.at(theta)?,
        })
    }

    fn bodies<C: Calc>(of: &LinkPlaces<C>, j: [C; BARS], g: C) -> [Body<C>; BARS] {
        let w = &of.weights;
        let jib = Body::along_bar(w.g_2, g, j[1], [w.s_2, w.chi_2]);
        // From its tail to its head.
        let kappa = of.geometry.kappa;
        let axis = Point::new(kappa.x - C::constant(1.0), -kappa.y);
        [
            Body::along_bar(w.g_1, g, j[0], [w.s_1, w.chi_1]),
            Body::slender(jib.mass, j[1], jib.centre, axis),
            Body::along_bar(w.g_3, g, j[2], [w.s_3, w.chi_3]),
        ]
    }

    fn balancing<C: Calc>(of: &LinkPlaces<C>) -> Option<&Balancing<C>> {
        of.balancing.as_ref()
    }

    fn axis<C: Calc>(of: &LinkPlaces<C>) -> C {
        -of.geometry.lengths.x_8
    }
}

impl<C: Calc> LinkPlaces<C> {
    pub fn new(
        geometry: &Geometry<C>,
        weights: &Weights<C>,
        balancing: Option<&Balancing<C>>,
        reeved: Option<&Reeved<C>>,
        way: &DriveWay<C>,
    ) -> LinkPlaces<C> {
        LinkPlaces {
            geometry: *geometry,
            weights: *weights,
            balancing: balancing.copied(),
            reeved: reeved.copied(),
            way: *way,
        }
    }
}

/// What weighs of it.
pub fn weighty<C: Calc>(places: &LinkPlaces<C>, bodies: &[CaseBody<C>], choice: &CasesChoice) -> Weighty<C> {
    Weighty::new::<OfLink>(places, bodies, choice)
}

/// How that moves.
///
/// # Errors
/// An angle at which mechanism, balance or crank do not close.
pub fn moved<C: Scalar>(
    places: &LinkPlaces<C>,
    weighty: &Weighty<C>,
    residual: Option<&Residual<C>>,
    theta: &One<C>,
) -> Found<MovedBars<C>> {
    MovedBars::new::<OfLink>(places, weighty, residual, theta.1)
}

const NAMES: MomentNames = MomentNames {
    about: [&m::M_IB, &m::M_IC],
    driven: &m::M_T,
};

/// What the pins carry in a case, by equilibrium of jib, rocker and boom.
pub fn pins<C: Calc>(
    p: &Position<C>,
    drive: &Drive<C>,
    residual: Option<&Residual<C>>,
    rope: Option<&LedPull<C>>,
    moved: &MovedBars<C>,
    loads: &Loads<C>,
    resisted: &Resisted<C>,
) -> Pins<C> {
    let nothing = C::constant(0.0);
    let [boom, jib, rocker] = [0, 1, 2].map(|bar| moved.turn(bar)[0]);
    let [(f_1, m_1), (f_2, m_2), (f_3, m_3)] = loads.bars;
    let carrying = Carrying::new(residual, moved, loads);
    let on_jib = f_2 + loads.head;
    let about_b = m_2 + cross(p.a - p.b, loads.head);
    let under = JibLoad {
        down: -on_jib.y,
        forward: Some(on_jib.x),
        about_b: -about_b,
    };
    let rope = rope.map(|rope| [0, 1, 2].map(|bar| rope.by(bar, loads.load)));
    let held = C::body(usize::MAX, || {
        let moments = [Some(-m_1 - carrying.moment), Some(-m_3)];
        match &rope {
            None => PinForces::under(p, &under, moments, &NAMES),
            Some(rope) => PinForces::led(p, &under, moments, rope, &NAMES),
        }
    });
    let by_rope = |force: Point<C>, bar: usize| rope.map_or(force, |rope| force - rope[bar].force);
    let push = drive.along(-resisted.sum / drive.h_d);
    let by_drive = |force: Point<C>, driven| match push {
        Some(push) if p.driven == driven => force - push,
        _ => force,
    };
    let o1 = by_drive(by_rope(held.b - f_1 - carrying.on_boom, 0), Driven::Boom);
    let o3 = by_drive(by_rope(held.c - f_3, 2), Driven::Rocker);
    let own = [
        Pin::new(o1, [boom, nothing]),
        Pin::new(held.b, [jib, boom]),
        Pin::new(held.c, [jib, rocker]),
        Pin::new(o3, [rocker, nothing]),
    ];
    Pins::new(own, &carrying, boom)
}

/// Force of the drive, in N.
pub fn force<C: Calc>(drive: &Drive<C>, rubbed: &Rubbed<C>) -> C {
    drive.force(-rubbed.sum, &s::F_R)
}

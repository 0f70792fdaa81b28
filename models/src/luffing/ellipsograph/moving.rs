//! Boom and link in motion: what they are to the equations of motion, in closed form.

use crate::drive::line::drawn;
use crate::drive::mount::{Anchors, DriveMount};
use crate::kernel::calc::{Calc, Over};
use crate::kernel::group::quantities;
use crate::kernel::symbol::{Symbol, listed};
use crate::luffing::ellipsograph::balancing::OnLink;
use crate::luffing::ellipsograph::driving;
use crate::luffing::ellipsograph::position::{Bars, GuidedChoice};
use crate::luffing::ellipsograph::statics::GuidedWeights;
use crate::luffing::ellipsograph::symbols as s;
use crate::luffing::moving::bodies::{Asked, Body, MovedBody, Moves};
use crate::luffing::moving::reduced::{CoordinateNames, Reduced};
use crate::luffing::moving::single::SingleBoom;
use crate::luffing::moving::symbols::{self as m, OfSums};
use crate::luffing::moving::weighed::Weight;
use crate::parts::motion::Motion;
use crate::parts::plane::{self, Point};

quantities! {
    /// Inertias of boom and link.
    GuidedInertias { j_b: J_B, j_l: J_L }
}

/// Names of what is summed for boom and link.
static OF_BODY: [OfSums; 2] = [
    OfSums {
        mass: &s::MASS_B,
        inertia: &s::I_RB,
        slope: &s::DI_RB,
    },
    OfSums {
        mass: &s::MASS_L,
        inertia: &s::I_RL,
        slope: &s::DI_RL,
    },
];

/// What boom and link are made of.
#[derive(Clone, Copy)]
pub struct GuidedParts<C> {
    pub bars: Bars<C>,
    pub weights: GuidedWeights<C>,
    pub inertias: GuidedInertias<C>,
    pub choice: GuidedChoice,
    /// Of a drive along a line.
    anchors: Option<Anchors<C>>,
}

impl<C: Calc> GuidedParts<C> {
    pub fn new(
        bars: &Bars<C>,
        weights: &GuidedWeights<C>,
        inertias: &GuidedInertias<C>,
        choice: &GuidedChoice,
        mount: &Option<DriveMount<C>>,
    ) -> GuidedParts<C> {
        GuidedParts {
            bars: *bars,
            weights: *weights,
            inertias: *inertias,
            choice: *choice,
            anchors: mount.as_ref().and_then(DriveMount::line),
        }
    }
}

/// What of them moves and weighs.
#[derive(Clone, Copy)]
pub struct GuidedBodies<P> {
    bars: Bars<P>,
    /// Of boom, from its foot, and link, from its pivot.
    pub bodies: [Body<P>; 2],
    anchors: Option<Anchors<P>>,
}

/// Centres of gravity of boom and link, in m from O1, and what they move by for one radian of the boom's angle.
pub struct GuidedCentres<C> {
    pub boom: [Point<C>; 2],
    pub link: [Point<C>; 2],
}

impl<C: Calc> GuidedCentres<C> {
    /// Of their places in their bars (m), on a link of length `c` (m), at the boom's angle (rad).
    pub fn new(c: C, [boom, link]: [Point<C>; 2], phi: C) -> GuidedCentres<C> {
        let (sin, cos) = phi.sin_cos();
        let foot = C::constant(2.0) * c;
        let s = Point::new(boom.x * cos - boom.y * sin, boom.x * sin + boom.y * cos - foot * sin);
        let ds = Point::new(-(boom.x * sin) - boom.y * cos, boom.x * cos - boom.y * sin - foot * cos);
        let dl = Point::new(-(link.x * sin), -(link.x * cos));
        GuidedCentres {
            boom: [
                plane::def(s, [&s::S_MX, &s::S_MY]),
                plane::def(ds, [&s::DS_MX, &s::DS_MY]),
            ],
            link: [
                Point::new(link.x * cos, -(link.x * sin)),
                plane::def(dl, [&s::DS_LX, &s::DS_LY]),
            ],
        }
    }
}

/// A boom on guide and link, as its equations of motion see it.
#[derive(Clone, Copy, Debug)]
pub struct Guided;

impl SingleBoom for Guided {
    type Own<C: Calc> = GuidedParts<C>;
    type Stands = OnLink;
    type Bodies<P: Calc> = GuidedBodies<P>;

    const NAMES: CoordinateNames = CoordinateNames {
        acceleration: &s::D_OMEGA,
        stops: [&s::FROM, &s::TO],
    };
    const RATES: &'static [&'static Symbol] = listed!(s: D_PHI, D_OMEGA);

    fn range<C: Calc>(own: &GuidedParts<C>) -> (Motion, C) {
        (own.choice.range, -own.bars.x_8)
    }

    fn stands<C: Calc>(own: &GuidedParts<C>) -> ((Bars<C>, GuidedWeights<C>), GuidedChoice) {
        ((own.bars, own.weights), own.choice)
    }

    fn bodies<P: Calc>(own: &GuidedParts<P>, fixed: Option<P>, gravity: P) -> GuidedBodies<P> {
        let (bars, weights, inertias) = (own.bars, &own.weights, &own.inertias);
        let line = Point::new(P::constant(1.0), P::constant(0.0));
        let (sin, cos) = weights.chi_b.sin_cos();
        let centre = Point::new(weights.r_b * cos, weights.r_b * sin);
        let mut boom = Body::slender(weights.g_b / gravity, inertias.j_b, centre, line);
        if let Some(load) = fixed {
            boom = boom.with_mass(load.def(&m::MASS_Q), line * (bars.c + bars.a));
            boom.inertia = boom.inertia.def(&s::J_BQ);
        }
        let link = Body::slender(weights.g_l / gravity, inertias.j_l, line * weights.r_l, line);
        GuidedBodies {
            bars,
            bodies: [boom, link],
            anchors: own.anchors,
        }
    }

    /// The link turns against the boom's angle, and so the arm is.
    fn line<P: Calc, C: Over<P>>(of: &GuidedBodies<P>, phi: C) -> Option<[C; 2]> {
        let [length, arm] = drawn(&driving::link(C::of(of.bars.c), phi), of.anchors.as_ref()?);
        Some([length, -arm])
    }

    /// Foot and head are c + a and 2c from
    /// the level and the upright through O1, so that of every point x″ = −x and y″ = −y.
    fn at<P: Calc, C: Over<P>>(
        of: &GuidedBodies<P>,
        (gravity, asked): (P, &Asked<P>),
        phi: C,
        counterweight: Option<Weight<C>>,
    ) -> Option<Reduced<C>> {
        let (sin, cos) = phi.sin_cos();
        let zero = C::constant(0.0);
        let GuidedCentres {
            boom: [s, ds],
            link: [l, dl],
        } = GuidedCentres::new(C::of(of.bars.c), of.bodies.map(|body| body.centre.map(C::of)), phi);
        let axes = [C::of(of.bars.c) + C::of(of.bars.a), C::of(of.bars.a) - C::of(of.bars.c)];
        let head = Point::new(axes[0] * cos, axes[1] * sin);
        let travel = plane::def(Point::new(-(axes[0] * sin), axes[1] * cos), [&s::DA_X, &s::DA_Y]);
        let bend = plane::def(-head, [&m::DDA_X, &m::DDA_Y]);
        let turn = [C::constant(1.0), zero];
        let moves = Moves::in_plane(
            [
                MovedBody {
                    centre: [s, ds, -s],
                    turn,
                },
                MovedBody {
                    centre: [l, dl, -l],
                    turn,
                },
            ],
            counterweight,
            [head, travel, bend],
            None,
        );
        let bars = [
            [Point::new(cos, sin), Point::new(-sin, cos)],
            [Point::new(cos, -sin), Point::new(-sin, -cos)],
        ];
        let moves = moves
            .pushed(asked.drive.then(|| Guided::line(of, phi)).flatten())
            .turning((gravity, asked), of.bodies.each_ref(), bars.map(Some));
        let names = OF_BODY.each_ref();
        Some(Reduced::of(of.bodies.each_ref(), names, gravity, moves))
    }
}

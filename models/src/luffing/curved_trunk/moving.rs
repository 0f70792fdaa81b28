//! Boom and trunk in motion: what they are to the equations of motion, in closed form over the point of contact.

use crate::drive::line::drawn;
use crate::drive::mount::{Anchors, DriveMount};
use crate::kernel::calc::{Calc, Over};
use crate::kernel::group::quantities;
use crate::kernel::symbol::{Symbol, listed};
use crate::luffing::curved_trunk::balancing::UnderTrunk;
use crate::luffing::curved_trunk::centres::TrunkCentres;
use crate::luffing::curved_trunk::contact::Contact;
use crate::luffing::curved_trunk::driving;
use crate::luffing::curved_trunk::leading::{bent_head, moves};
use crate::luffing::curved_trunk::position::TrunkPosition;
use crate::luffing::curved_trunk::statics::TrunkWeights;
use crate::luffing::curved_trunk::symbols as s;
use crate::luffing::curved_trunk::tail::{TrunkChoice, TrunkTail};
use crate::luffing::curved_trunk::velocity::{TrunkBend, TrunkTravel};
use crate::luffing::led::moving::LedMoves;
use crate::luffing::led::reeved::Reeved;
use crate::luffing::moving::bodies::{Asked, Body, MovedBody, Moves, hung};
use crate::luffing::moving::reduced::{CoordinateNames, Reduced};
use crate::luffing::moving::single::SingleBoom;
use crate::luffing::moving::symbols::{self as m, OfSums};
use crate::luffing::moving::weighed::Weight;
use crate::parts::motion::Motion;
use crate::parts::plane::{self, Point};

quantities! {
    /// Inertias of boom and trunk.
    TrunkInertias { j_b: J_B, j_t: J_T }
}

/// Names of what is summed for boom and trunk.
static OF_BODY: [OfSums; 2] = [
    OfSums {
        mass: &s::MASS_B,
        inertia: &s::I_RB,
        slope: &s::DI_RB,
    },
    OfSums {
        mass: &s::MASS_T,
        inertia: &s::I_RT,
        slope: &s::DI_RT,
    },
];

/// What boom and trunk are made of.
#[derive(Clone)]
pub struct TrunkParts<C> {
    pub tail: TrunkTail<C>,
    pub weights: TrunkWeights<C>,
    pub inertias: TrunkInertias<C>,
    pub choice: TrunkChoice,
    pub reeved: Option<Reeved<C>>,
    /// Of a drive along a line.
    anchors: Option<Anchors<C>>,
}

impl<C: Calc> TrunkParts<C> {
    pub fn new(
        tail: &TrunkTail<C>,
        weights: &TrunkWeights<C>,
        inertias: &TrunkInertias<C>,
        choice: &TrunkChoice,
        reeved: Option<&Reeved<C>>,
        mount: &Option<DriveMount<C>>,
    ) -> TrunkParts<C> {
        TrunkParts {
            tail: *tail,
            weights: *weights,
            inertias: *inertias,
            choice: choice.clone(),
            reeved: reeved.copied(),
            anchors: mount.as_ref().and_then(DriveMount::line),
        }
    }
}

/// What of them moves and weighs.
#[derive(Clone)]
pub struct TrunkBodies<P> {
    pub own: TrunkParts<P>,
    /// Of boom, from its foot, and trunk, from B.
    pub bodies: [Body<P>; 2],
    /// The mass of a load that does not swing on a led hoist rope, in kg.
    load: Option<P>,
}

/// A boom with a curved trunk, as its equations of motion see it.
#[derive(Clone, Copy, Debug)]
pub struct Trunked;

impl<P: Calc> TrunkBodies<P> {
    fn placed<C: Over<P>>(&self, phi: C) -> Option<(Contact<C>, TrunkPosition<C>, TrunkTravel<C>)> {
        let tail = self.own.tail.map(C::of);
        let contact = Contact::new(&tail, &self.own.choice, &phi).ok()?;
        let position = TrunkPosition::new(&tail, &contact);
        let travel = TrunkTravel::new(&position);
        Some((contact, position, travel))
    }
}

impl SingleBoom for Trunked {
    type Own<C: Calc> = TrunkParts<C>;
    type Stands = UnderTrunk;
    type Bodies<P: Calc> = TrunkBodies<P>;

    const NAMES: CoordinateNames = CoordinateNames {
        acceleration: &s::D_OMEGA,
        stops: [&s::FROM, &s::TO],
    };
    const RATES: &'static [&'static Symbol] = listed!(s: D_PHI, D_OMEGA);

    fn range<C: Calc>(own: &TrunkParts<C>) -> (Motion, C) {
        (own.choice.range, -own.tail.trunk.x_8)
    }

    fn stands<C: Calc>(own: &TrunkParts<C>) -> ((TrunkTail<C>, TrunkWeights<C>), TrunkChoice) {
        ((own.tail, own.weights), own.choice.clone())
    }

    fn bodies<P: Calc>(own: &TrunkParts<P>, fixed: Option<P>, gravity: P) -> TrunkBodies<P> {
        let (w, inertias) = (&own.weights, &own.inertias);
        let boom = Body::along_bar(w.g_b, gravity, inertias.j_b, [w.r_b, w.chi_b]);
        let mut trunk = Body::along_bar(w.g_t, gravity, inertias.j_t, [w.r_t, w.chi_t]);
        if let Some(load) = fixed.filter(|_| own.reeved.is_none()) {
            let head = Point::new(own.tail.trunk.a, P::constant(0.0));
            trunk = trunk.with_mass(load.def(&m::MASS_Q), head);
            trunk.inertia = trunk.inertia.def(&s::J_TQ);
        }
        TrunkBodies {
            own: own.clone(),
            bodies: [boom, trunk],
            load: fixed.filter(|_| own.reeved.is_some()),
        }
    }

    fn line<P: Calc, C: Over<P>>(of: &TrunkBodies<P>, phi: C) -> Option<[C; 2]> {
        let boom = driving::boom(C::of(of.own.tail.trunk.b), phi);
        Some(drawn(&boom, of.own.anchors.as_ref()?))
    }

    fn load<P: Over<P>>(of: &TrunkBodies<P>, phi: P) -> Option<(P, [Point<P>; 3])> {
        let mass = of.load?;
        let (contact, position, travel) = of.placed(phi)?;
        let bend = TrunkBend::new(&contact, &position, &travel);
        let head = bent_head((&position, &travel, &bend));
        let LedMoves { raised, lead } = moves(of.own.reeved.as_ref()?, phi, (&position, &travel, &bend), head)?;
        Some((mass.def(&m::MASS_Q), hung(head, raised, lead)))
    }

    /// `None` where the tie does not reach from tail to frame.
    fn at<P: Calc, C: Over<P>>(
        of: &TrunkBodies<P>,
        (gravity, asked): (P, &Asked<P>),
        phi: C,
        counterweight: Option<Weight<C>>,
    ) -> Option<Reduced<C>> {
        let zero = C::constant(0.0);
        let (contact, position, travel) = of.placed(phi)?;
        let bend = TrunkBend::new(&contact, &position, &travel);
        let centres = of.bodies.map(|body| body.centre.map(C::of));
        let TrunkCentres { boom, trunk } = TrunkCentres::new(centres, (phi, &position), (&travel, &bend));
        let place = [position.b + trunk[0], trunk[1], trunk[2]];
        let head = bent_head((&position, &travel, &bend));
        let led = match &of.own.reeved {
            Some(reeved) => Some(moves(reeved, phi, (&position, &travel, &bend), head)?),
            None => None,
        };
        let load = of
            .load
            .zip(led)
            .map(|(mass, led)| (C::of(mass), hung(head, led.raised, led.lead)));
        let moves = Moves::in_plane(
            [
                MovedBody {
                    centre: boom,
                    turn: [C::constant(1.0), zero],
                },
                MovedBody {
                    centre: place,
                    turn: [travel.i_2.square(), travel.i_2 * bend.i_2],
                },
            ],
            counterweight,
            head,
            led.filter(|_| load.is_none()).map(|led| led.lead),
        );
        let (sin, cos) = phi.sin_cos();
        let bars = [
            [Point::new(cos, sin), Point::new(-sin, cos)],
            [position.along, plane::turned(position.along, zero, travel.i_2)],
        ];
        let moves = moves
            .pushed(asked.drive.then(|| Trunked::line(of, phi)).flatten())
            .hanging(load)
            .turning((gravity, asked), of.bodies.each_ref(), bars.map(Some));
        Some(Reduced::of(of.bodies.each_ref(), OF_BODY.each_ref(), gravity, moves))
    }
}

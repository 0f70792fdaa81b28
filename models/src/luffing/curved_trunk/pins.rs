//! Forces of tie, boom and frame, and what the drive must give, by equilibrium of the trunk and of the boom.

use crate::balance::residual::Residual;
use crate::component::stages::results;
use crate::drive::line::Reaction;
use crate::kernel::calc::Calc;
use crate::luffing::curved_trunk::contact::Contact;
use crate::luffing::curved_trunk::position::TrunkPosition;
use crate::luffing::curved_trunk::statics::TrunkWeight;
use crate::luffing::curved_trunk::symbols as s;
use crate::luffing::led::pull::LedPull;
use crate::parts::motion::degrees;
use crate::parts::plane::{self, Point};

/// In N.
#[derive(Clone, Copy, Debug)]
pub struct TrunkPins<C> {
    /// In the tie; negative where it is slack.
    n_t: C,
    /// Of the boom on the trunk.
    head: Point<C>,
    /// Moment of the drive, in N·m.
    pub m_d: C,
}
results! { TrunkPins as f => {
    M_D: f.m_d;
    N_T: f.n_t;
    F_BX: f.head.x;
    F_BY: f.head.y;
} }

impl<C: Calc> TrunkPins<C> {
    /// The trunk about B: N_t h_t = Q (x_A − x_B) + G_t x_St; the boom about O1.
    pub fn new(
        position: &TrunkPosition<C>,
        q: &C,
        own: Option<&TrunkWeight<C>>,
        residual: Option<&Residual<C>>,
        pulled: Option<&LedPull<C>>,
    ) -> TrunkPins<C> {
        let load = *q * position.front.x;
        let m_b = own.map_or(load, |own| load + own.of_trunk);
        let m_b = pulled.map_or(m_b, |pulled| m_b - pulled.on[1].moment).def(&s::M_B);
        let n_t = (m_b / position.h_t).def(&s::N_T);
        let down = own.map_or(*q, |own| *q + own.trunk);
        let pull = position.tie * n_t;
        let head = Point::new(-pull.x, down - pull.y);
        let head = pulled.map_or(head, |pulled| head - pulled.on[1].force);
        let head = plane::def(head, [&s::F_BX, &s::F_BY]);
        let m_d = plane::cross(position.b, head);
        let m_d = own.map_or(m_d, |own| m_d + own.of_boom);
        let m_d = pulled.map_or(m_d, |pulled| m_d - pulled.on[0].moment);
        let m_d = residual.map_or(m_d, |left| m_d - left.action.m_b);
        TrunkPins {
            n_t,
            head,
            m_d: m_d.def(&s::M_D),
        }
    }
}

/// What frame and tail carry, in N.
#[derive(Clone, Copy, Debug)]
pub struct TrunkBearing<C> {
    /// Of the frame on the boom.
    foot: Point<C>,
    /// Line load of the tie on the tail, in N/m.
    pub q_t: C,
}
results! { TrunkBearing as f => {
    F_O1X: f.foot.x;
    F_O1Y: f.foot.y;
    Q_T: f.q_t;
} }

impl<C: Calc> TrunkBearing<C> {
    /// The boom with the force of its drive, where that is no mere moment. On the tail the tie slides without friction, and
    /// its pull is the same all along: it presses with N_t/ρ.
    pub fn new(
        contact: &Contact<C>,
        pins: &TrunkPins<C>,
        own: Option<&TrunkWeight<C>>,
        residual: Option<&Residual<C>>,
        drive: Option<&Reaction<C>>,
        pulled: Option<&LedPull<C>>,
    ) -> TrunkBearing<C> {
        let foot = own.map_or(pins.head, |own| Point::new(pins.head.x, pins.head.y + own.boom));
        let foot = pulled.map_or(foot, |pulled| foot - pulled.on[0].force);
        let foot = residual.map_or(foot, |left| foot - left.action.on_boom);
        let push = drive.and_then(|drive| drive.force);
        let foot = push.map_or(foot, |push| foot - push);
        TrunkBearing {
            foot: plane::def(foot, [&s::F_O1X, &s::F_O1Y]),
            q_t: line_load(pins.n_t, contact),
        }
    }
}

/// Line load (N/m) of a tie with a force (N) on the tail.
pub fn line_load<C: Calc>(n_t: C, contact: &Contact<C>) -> C {
    (n_t / contact.rho).def(&s::Q_T)
}

/// The same over the tie's width (m), in Pa.
pub fn over_width<C: Calc>(q_t: C, width: &C) -> C {
    (q_t / *width).def(&s::P_T)
}

/// Pressure of the tie on the tail at rest, in Pa, over its width (m).
pub fn pressure<C: Calc>(bearing: &TrunkBearing<C>, width: &C) -> C {
    over_width(bearing.q_t, width)
}

/// What is wrong at the boom's angle (rad) with a force in the tie (N): it cannot push.
pub fn slack(phi: f64, n_t: f64) -> Option<String> {
    (n_t < 0.0).then(|| {
        let push = s::N_T.written(-n_t);
        format!(
            "phi = {}: the tie is slack, it would have to push with {push}",
            degrees(phi)
        )
    })
}

/// Power of the drive, in W.
pub fn power<C: Calc>(pins: &TrunkPins<C>, omega: &C) -> C {
    (pins.m_d * *omega).def(&s::P_D)
}

//! Forces of tie, boom, frame and drive while the boom moves: equilibrium of trunk and boom under weight, inertia, rope and
//! balance. [Newton and Euler]

use crate::component::stages::{Found, absent, results};
use crate::drive::hauling::Pushes;
use crate::drive::line::Drive;
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::luffing::curved_trunk::centres::TrunkCentres;
use crate::luffing::curved_trunk::contact::Contact;
use crate::luffing::curved_trunk::leading::TRUNK;
use crate::luffing::curved_trunk::moving::{TrunkBodies, Trunked};
use crate::luffing::curved_trunk::pins::{line_load, over_width};
use crate::luffing::curved_trunk::position::TrunkPosition;
use crate::luffing::curved_trunk::velocity::{TrunkBend, TrunkTravel};
use crate::luffing::led::pull::{self, Hauled, named};
use crate::luffing::led::stretch::LedBars;
use crate::luffing::moving::inertia_forces::PosedBody;
use crate::luffing::moving::reduced::Renewed;
use crate::luffing::moving::single::{Acting, Heavy};
use crate::parts::plane::{self, Point, cross};

/// Quantities at rest and in motion.
mod s {
    pub use crate::drive::symbols::F_D;
    pub use crate::luffing::curved_trunk::symbols::*;
    pub use crate::luffing::led::symbols::{F_R1X, F_R1Y, F_R2X, F_R2Y, M_R1, M_R2, S_H};
    pub use crate::luffing::moving::symbols::{F_IBX, F_IBY, M_T};
}

/// In N; moments in N·m.
#[derive(Clone, Copy, Debug)]
pub struct TrunkForces<C> {
    /// Of motor and brake; positive raises the boom.
    m_d: C,
    /// Of the drive, in W.
    p_d: C,
    /// In the tie, and its line load on the tail, in N/m; negative where it would have to push.
    pub n_t: C,
    pub q_t: C,
    /// Of the boom on the trunk, and of the frame on the boom.
    head: Point<C>,
    foot: Point<C>,
    /// Moment for the boom's angle that equilibrium asks for, and the forces of which it is, on their arms.
    asked: C,
    /// Pull of a led hoist rope, and what it does to boom and trunk.
    rope: Option<(C, [Hauled<C>; 3])>,
    levers: [[Point<C>; 2]; 3],
    acting: Acting<C>,
    /// Of the drive on the boom, push positive, where there is one.
    f_d: Option<C>,
}
results! { TrunkForces as f => {
    M_D: f.m_d;
    P_D: f.p_d;
    N_T: f.n_t;
    Q_T: f.q_t;
    F_BX: f.head.x;
    F_BY: f.head.y;
    F_O1X: f.foot.x;
    F_O1Y: f.foot.y;
    F_D: f.f_d.ok_or_else(absent)?;
    Z_TIE: f.n_t;
    S_H: f.led()?[0];
    F_R1X: f.led()?[1];
    F_R1Y: f.led()?[2];
    M_R1: f.led()?[3];
    F_R2X: f.led()?[4];
    F_R2Y: f.led()?[5];
    M_R2: f.led()?[6];
} }

impl<C: Copy> Pushes<C> for TrunkForces<C> {
    fn f_d(&self) -> Option<C> {
        self.f_d
    }
}

impl<C: Calc> TrunkForces<C> {
    /// At the boom's angle (rad), under gravity in m/s²: the trunk about B, N_t h_t = M_tB; the boom about O1.
    pub fn new(
        (bodies, gravity): (&TrunkBodies<C>, C),
        phi: C,
        (contact, position, travel): (&Contact<C>, &TrunkPosition<C>, &TrunkTravel<C>),
        acting: &Acting<C>,
        drive: Option<&Drive<C>>,
    ) -> TrunkForces<C> {
        let bend = TrunkBend::new(contact, position, travel);
        let [boom, trunk] = &bodies.bodies;
        let (sin, cos) = phi.sin_cos();
        let lie = [(boom.spread, Point::new(cos, sin)), (trunk.spread, position.along)];
        let TrunkCentres { boom: s, trunk: m } =
            TrunkCentres::new([boom.centre, trunk.centre], (phi, position), (travel, &bend));
        let at = &acting.at;
        let trunk = PosedBody {
            turn: [travel.i_2, bend.i_2],
            ..PosedBody::in_plane(
                (1, position.b.y),
                [trunk.mass.def(&s::MASS_T), trunk.inertia],
                m[0],
                [m[1], m[2]],
            )
        };
        let trunk = acting.turning(trunk, position.b.x + m[0].x, lie[1]);
        let foot = (0, C::constant(0.0));
        let boom = PosedBody::in_plane(foot, [boom.mass.def(&s::MASS_B), boom.inertia], s[0], [s[1], s[2]]);
        let boom = acting.turning(boom, s[0].x, lie[0]);
        let f_t = trunk.force(at, gravity, [&s::F_ITX, &s::F_ITY]);
        let about_b = trunk.moment(at, f_t);
        let (on_trunk, about_b) = match at.pull {
            Some(pull) => (f_t + pull, about_b - cross(position.front, pull)),
            None => (f_t, about_b),
        };
        let zero = C::constant(0.0);
        let rope = bodies.own.reeved.as_ref().and_then(|led| {
            let at_trunk = [position.b, position.along];
            let bars = [[Point::new(zero, zero), Point::new(cos, sin)], at_trunk, at_trunk];
            let each = led.hauled(&LedBars::still(bars, (TRUNK, position.a)))?;
            let s_h = (at.tension.unwrap_or(zero) / led.falls.m_h).def(&s::S_H);
            Some((s_h, named(each.map(|bar| bar.under(s_h)))))
        });
        let (on_boom, on_trunk, about_b) = match rope {
            Some((_, [boom, trunk, _])) => (boom, on_trunk + trunk.force, about_b - trunk.moment),
            None => (Hauled::nothing()[0], on_trunk, about_b),
        };
        let n_t = (about_b.def(&s::M_TB) / position.h_t).def(&s::N_T);
        let head = plane::def(-(on_trunk + position.tie * n_t), [&s::F_BX, &s::F_BY]);
        let f_b = boom.force(at, gravity, [&s::F_IBX, &s::F_IBY]);
        let asked = boom.moment(at, f_b).def(&s::M_BO) + cross(position.b, head);
        let asked = asked - on_boom.moment;
        let asked = acting.balance.map_or(asked, |balance| asked - balance.moment);
        let m_d = at.shares.drive.def(&s::M_D);
        let push = at.shares.push;
        let f_d = drive.map(|drive| push.unwrap_or_else(|| drive.force(m_d, &s::F_D)));
        let foot = acting
            .balance
            .map_or(head - f_b, |balance| head - f_b - balance.on_boom)
            - on_boom.force;
        let push = drive.zip(f_d).and_then(|(drive, f_d)| drive.along(f_d));
        let foot = push.map_or(foot, |push| foot - push);
        TrunkForces {
            m_d,
            p_d: (m_d * at.omega).def(&s::P_D),
            n_t,
            q_t: line_load(n_t, contact),
            head,
            foot: plane::def(foot, [&s::F_O1X, &s::F_O1Y]),
            asked: asked.def(&s::M_T),
            rope,
            levers: [[position.b, head], [s[0], f_b], [m[0], f_t]],
            acting: *acting,
            f_d,
        }
    }

    /// As [`pull::RESULTS`].
    ///
    /// # Errors
    /// Without a led rope.
    fn led(&self) -> Found<[C; pull::RESULTS.len()]> {
        let (s_h, on) = self.rope.as_ref().ok_or_else(absent)?;
        Ok(pull::results(*s_h, on))
    }

    /// As [`Acting::apart`].
    #[must_use]
    pub fn apart(&self) -> [f64; 2] {
        self.acting.apart(self.asked, self.levers)
    }
}

/// Of the boom with what it weighs.
pub fn forces<C: Calc>(
    boom: &[Renewed<Heavy<Trunked, C>>],
    phi: &One<C>,
    contact: &Contact<C>,
    position: &TrunkPosition<C>,
    travel: &TrunkTravel<C>,
    acting: &Acting<C>,
    drive: Option<&Drive<C>>,
) -> TrunkForces<C> {
    let known = (contact, position, travel);
    TrunkForces::new(boom[0].now().bodies(), phi.1, known, acting, drive)
}

/// Pressure of the tie on the tail, in Pa, over its width (m).
pub fn pressure<C: Calc>(forces: &TrunkForces<C>, width: &C) -> C {
    over_width(forces.q_t, width)
}

//! Forces of guide, link, frame and drive while the boom moves: equilibrium of boom and link under weight, inertia, rope and
//! balance. [Newton and Euler]

use crate::component::stages::{Found, absent, results};
use crate::drive::hauling::Pushes;
use crate::drive::line::Drive;
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::luffing::ellipsograph::moving::{Guided, GuidedBodies, GuidedCentres};
use crate::luffing::ellipsograph::pins::held;
use crate::luffing::ellipsograph::position::{Bars, GuidedPosition};
use crate::luffing::moving::inertia_forces::PosedBody;
use crate::luffing::moving::reduced::Renewed;
use crate::luffing::moving::single::{Acting, Heavy};
use crate::parts::plane::{self, Point, cross};

/// Quantities at rest and in motion.
mod s {
    pub use crate::drive::symbols::F_D;
    pub use crate::luffing::ellipsograph::symbols::*;
    pub use crate::luffing::moving::symbols::{F_IBX, F_IBY, M_T};
}

/// In N; moments in N·m.
#[derive(Clone, Copy, Debug)]
pub struct GuidedForces<C> {
    /// Of motor and brake; positive raises the boom.
    m_d: C,
    /// Of the drive, in W.
    p_d: C,
    /// Of the guide on the foot, forward.
    guide: C,
    /// Of the link on the boom, along it with tension positive; of the frame on the link.
    link: Point<C>,
    axial: C,
    frame: Point<C>,
    /// Moment for the boom's angle that equilibrium asks for, and the forces of which it is, on their arms.
    asked: C,
    levers: [[Point<C>; 2]; 3],
    acting: Acting<C>,
    /// Of the drive on the link, push positive, where there is one.
    f_d: Option<C>,
}
results! { GuidedForces as f => {
    M_D: f.m_d;
    P_D: f.p_d;
    F_BX: f.guide;
    F_CX: f.link.x;
    F_CY: f.link.y;
    N_L: f.axial;
    F_O1X: f.frame.x;
    F_O1Y: f.frame.y;
    F_D: f.f_d.ok_or_else(absent)?;
} }

impl<C: Copy> Pushes<C> for GuidedForces<C> {
    fn f_d(&self) -> Option<C> {
        self.f_d
    }
}

impl<C: Calc> GuidedForces<C> {
    /// Under gravity in m/s².
    ///
    /// # Errors
    /// A boom that lies level: no force of the guide holds its head there.
    pub fn new(
        bars: &Bars<C>,
        (bodies, gravity): (&GuidedBodies<C>, C),
        phi: C,
        position: &GuidedPosition<C>,
        acting: &Acting<C>,
        drive: Option<&Drive<C>>,
    ) -> Found<GuidedForces<C>> {
        held(position, phi)?;
        let at = &acting.at;
        let [boom, link] = &bodies.bodies;
        let (sin, cos) = phi.sin_cos();
        let lie = [
            (boom.spread, Point::new(cos, sin)),
            (link.spread, Point::new(cos, -sin)),
        ];
        let GuidedCentres { boom: s, link: l } = GuidedCentres::new(bars.c, [boom.centre, link.centre], phi);
        let boom = [boom.mass.def(&s::MASS_B), boom.inertia];
        let boom = PosedBody::in_plane((0, position.c.y), boom, s[0] - position.c, [s[1], -s[0]]);
        let boom = acting.turning(boom, s[0].x, lie[0]);
        let link = [link.mass.def(&s::MASS_L), link.inertia];
        // The link turns against the boom's angle.
        let link = PosedBody {
            turn: [C::constant(-1.0), C::constant(0.0)],
            ..PosedBody::in_plane((1, C::constant(0.0)), link, l[0], [l[1], -l[0]])
        };
        let link = acting.turning(link, l[0].x, lie[1]);
        let f_b = boom.force(at, gravity, [&s::F_IBX, &s::F_IBY]);
        let about_c = boom.moment(at, f_b);
        let (on_boom, about_c) = match at.pull {
            Some(pull) => (f_b + pull, about_c - cross(position.a - position.c, pull)),
            None => (f_b, about_c),
        };
        let guide = (about_c.def(&s::M_BC) / (bars.c * position.along.y)).def(&s::F_BX);
        let f_c = plane::def(Point::new(-(on_boom.x + guide), -on_boom.y), [&s::F_CX, &s::F_CY]);
        let f_l = link.force(at, gravity, [&s::F_ILX, &s::F_ILY]);
        let m_lo = link.moment(at, f_l).def(&s::M_LO);
        let asked = -cross(position.c, f_c) - m_lo;
        let asked = acting.balance.map_or(asked, |balance| asked + balance.moment);
        let m_d = at.shares.drive.def(&s::M_D);
        let push = at.shares.push;
        let f_d = drive.map(|drive| push.unwrap_or_else(|| drive.force(-m_d, &s::F_D)));
        let frame = acting.balance.map_or(f_c - f_l, |balance| f_c - f_l - balance.on_boom);
        let push = drive.zip(f_d).and_then(|(drive, f_d)| drive.along(f_d));
        let frame = push.map_or(frame, |push| frame - push);
        Ok(GuidedForces {
            m_d,
            p_d: (m_d * at.omega).def(&s::P_D),
            guide,
            link: f_c,
            axial: (-plane::dot(f_c, position.c) / bars.c).def(&s::N_L),
            frame: plane::def(frame, [&s::F_O1X, &s::F_O1Y]),
            asked: asked.def(&s::M_T),
            levers: [[position.c, f_c], [position.c, on_boom], [l[0], f_l]],
            acting: *acting,
            f_d,
        })
    }

    /// As [`Acting::apart`].
    #[must_use]
    pub fn apart(&self) -> [f64; 2] {
        self.acting.apart(self.asked, self.levers)
    }
}

/// Of the boom with what it weighs.
///
/// # Errors
/// As [`GuidedForces::new`].
pub fn forces<C: Calc>(
    bars: &Bars<C>,
    boom: &[Renewed<Heavy<Guided, C>>],
    phi: &One<C>,
    position: &GuidedPosition<C>,
    acting: &Acting<C>,
    drive: Option<&Drive<C>>,
) -> Found<GuidedForces<C>> {
    GuidedForces::new(bars, boom[0].now().bodies(), phi.1, position, acting, drive)
}

//! Forces of the boom while it moves: its equilibrium under weight, inertia, both ropes as they run, and balance.
//! [Newton and Euler]

use crate::balance::boom::Plain;
use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::luffing::moving::given::Constants;
use crate::luffing::moving::inertia_forces::PosedBody;
use crate::luffing::moving::single::Acting;
use crate::luffing::rope::moving::BoomInertia;
use crate::luffing::rope::position::{BoomPosition, Falls, Rig, Stretch};
use crate::parts::plane::{self, Point, cross};

/// Quantities at rest and in motion.
mod s {
    pub use crate::luffing::moving::symbols::{F_IBX, F_IBY, M_T};
    pub use crate::luffing::rope::symbols::*;
}

/// In N; moments in N·m.
#[derive(Clone, Copy, Debug)]
pub struct RopeForces<C> {
    /// Pull of the hoist rope, and of all its parts between head and sheave.
    s_h: C,
    f_k: C,
    /// Of the frame on the boom.
    foot: Point<C>,
    /// Axial force at the foot, tension positive.
    n_b: C,
    /// Moment about the foot that equilibrium asks for, and the forces of which it is, on their arms.
    asked: C,
    levers: [[Point<C>; 2]; 3],
    acting: Acting<C>,
}
results! { RopeForces as f => {
    S_H: f.s_h;
    F_K: f.f_k;
    F_O1X: f.foot.x;
    F_O1Y: f.foot.y;
    N_B: f.n_b;
} }

impl<C: Calc> RopeForces<C> {
    /// With the pull of the luffing tackle in motion, in N.
    #[expect(clippy::too_many_arguments, reason = "what acts on the boom, one by one")]
    pub fn new(
        rig: &Rig<C>,
        position: &BoomPosition<C>,
        falls: &Falls<C>,
        stretch: &Stretch<C>,
        weights: &Plain<C>,
        inertia: &BoomInertia<C>,
        constants: &Constants<C>,
        acting: &Acting<C>,
        tackle: &C,
    ) -> RopeForces<C> {
        let (sin, cos) = weights.chi_b.sin_cos();
        let centre = plane::turned(position.along, weights.r_b * cos, weights.r_b * sin);
        let centre = plane::def(centre, [&s::S_BX, &s::S_BY]);
        let mass = (weights.g_b / constants.g).def(&s::MASS_B);
        let turned = Point::new(-centre.y, centre.x);
        let boom = PosedBody::in_plane((0, C::constant(0.0)), [mass, inertia.j_b], centre, [turned, -centre]);
        let lies = ([inertia.j_b, C::constant(0.0), C::constant(0.0)], position.along);
        let (at, boom) = (&acting.at, acting.turning(boom, centre.x, lies));
        let own = boom.force(at, constants.g, [&s::F_IBX, &s::F_IBY]);
        let m_bo = boom.moment(at, own).def(&s::M_BO);
        let zero = C::constant(0.0);
        let on_head = at.pull.unwrap_or(Point::new(zero, zero));
        let s_h = (at.tension.unwrap_or(zero) / rig.m_h).def(&s::S_H);
        let f_k = stretch.parts.map_or(s_h, |_| stretch.all(s_h).def(&s::F_K));
        let led = stretch.line.force(f_k);
        let forces = own + on_head + led + falls.line.force(*tackle);
        let forces = acting.balance.map_or(forces, |balance| forces + balance.on_boom);
        let foot = plane::def(-forces, [&s::F_O1X, &s::F_O1Y]);
        let asked = m_bo - cross(position.a, on_head) - f_k * stretch.line.arm;
        let asked = acting.balance.map_or(asked, |balance| asked - balance.moment);
        RopeForces {
            s_h,
            f_k,
            foot,
            n_b: (-plane::dot(foot, position.along)).def(&s::N_B),
            asked: asked.def(&s::M_T),
            levers: [[centre, own], [position.a, on_head], [position.a, led]],
            acting: *acting,
        }
    }

    /// As [`Acting::apart`].
    #[must_use]
    pub fn apart(&self) -> [f64; 2] {
        self.acting.apart(self.asked, self.levers)
    }
}

/// Pull of the luffing tackle in motion, in N, that gives the boom a moment (N·m).
pub fn pull<C: Calc>(moment: &C, falls: &Falls<C>) -> C {
    (*moment / falls.line.arm).def(&s::T_DYN)
}

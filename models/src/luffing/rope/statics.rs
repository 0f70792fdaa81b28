//! Moments about the boom's foot, the tackle's pull and the foot's reaction; all without losses.

use crate::balance::boom::{Load, Plain};
use crate::balance::residual::Residual;
use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::luffing::rope::position::{BoomPosition, Falls, Rig, Stretch};
use crate::luffing::rope::symbols as s;
use crate::luffing::rope::velocity::{RopeTravel, Speeds};
use crate::parts::plane::{self, Point};

/// The load on its ropes.
#[derive(Clone, Copy, Debug)]
pub struct Hanging<C> {
    /// Moment about O1 by virtual work, in N·m; positive lowers the boom.
    pub m_q: C,
    /// The same by powers.
    by_pole: C,
    /// Pull of the hoist rope, in N.
    s_h: C,
    /// Pull of all its parts between head and sheave, in N.
    f_k: C,
}
results! { Hanging as h => { M_Q: h.m_q; M_Q_P: h.by_pole; S_H: h.s_h; F_K: h.f_k; } }

impl<C: Calc> Hanging<C> {
    /// M_Q = Q dy_Q/dphi [Ports001, 5.2.3]; S_h = Q / m_h [Ports001, 5.1]; F_k = m_k S_h [Ports001, 5.2.4.1]; the powers of Q and
    /// F_k at the head while the boom turns about O1, M_Q omega = (Q x_A − F_k h_S) omega [Ports001, 5.9.2.4]
    pub fn new(
        rig: &Rig<C>,
        position: &BoomPosition<C>,
        q: &C,
        stretch: &Stretch<C>,
        travel: &RopeTravel<C>,
    ) -> Hanging<C> {
        let s_h = (*q / rig.m_h).def(&s::S_H);
        let f_k = stretch.parts.map_or(s_h, |_| stretch.all(s_h).def(&s::F_K));
        Hanging {
            m_q: (*q * travel.y_q).def(&s::M_Q),
            by_pole: (*q * position.a.x - f_k * stretch.line.arm).def(&s::M_Q_P),
            s_h,
            f_k,
        }
    }
}

/// The boom's own weight.
#[derive(Clone, Copy, Debug)]
pub struct OwnMoment<C> {
    pub load: Load<C>,
    /// Moment about O1, in N·m; positive lowers the boom.
    pub m_g: C,
    g_b: C,
}
results! { OwnMoment as w => { M_G: w.m_g; } }

impl<C: Calc> OwnMoment<C> {
    /// [Ports001, 5.1]
    pub fn new(weights: &Plain<C>, phi: &C) -> OwnMoment<C> {
        let load = weights.load(*phi);
        OwnMoment {
            load,
            m_g: (-load.m_0).def(&s::M_G),
            g_b: weights.g_b,
        }
    }
}

/// What load, own weight and balance ask of both ropes, whichever way these run.
#[derive(Clone, Copy, Debug)]
pub struct RopePulls<C> {
    /// Moment about O1, in N·m; positive lowers the boom.
    pub m_w: C,
    /// Their force on the boom, in N.
    force: Point<C>,
}

impl<C: Calc> RopePulls<C> {
    /// G_b r_b cos phi + Q x_A [Ports001, 5.1], less what a balance carries.
    pub fn new(
        position: &BoomPosition<C>,
        q: &C,
        own: Option<&OwnMoment<C>>,
        residual: Option<&Residual<C>>,
    ) -> RopePulls<C> {
        let load = *q * position.a.x;
        let m_w = own.map_or(load, |own| load + own.m_g);
        let m_w = residual.map_or(m_w, |left| m_w - left.action.m_b);
        let weight = Point::new(C::constant(0.0), -own.map_or(*q, |own| *q + own.g_b));
        RopePulls {
            m_w: m_w.def(&s::M_W),
            force: residual.map_or(weight, |left| weight + left.action.on_boom),
        }
    }

    /// Moment that is left for the luffing tackle, in N·m, with a pull `f_k` (N) of all parts of the hoist rope.
    pub fn left(&self, stretch: &Stretch<C>, f_k: C) -> C {
        self.m_w - f_k * stretch.line.arm
    }
}

/// The luffing tackle holds the boom.
#[derive(Clone, Copy, Debug)]
pub struct Pull<C> {
    /// In N·m; positive raises the boom.
    pub m_d: C,
    /// In N; negative where the rope is slack.
    pub t: C,
    /// Force of the frame on the boom, in N.
    foot: Point<C>,
    /// Axial force at the foot, in N, tension positive.
    n_b: C,
}
results! { Pull as p => {
    M_D: p.m_d;
    T: p.t;
    F_O1X: p.foot.x;
    F_O1Y: p.foot.y;
    N_B: p.n_b;
} }

impl<C: Calc> Pull<C> {
    /// Equilibrium of the boom: T h_T = G_b r_b cos phi + Q x_A − F_k h_S. [Ports001, 5.1]
    pub fn new(
        carried: &RopePulls<C>,
        hanging: &Hanging<C>,
        position: &BoomPosition<C>,
        falls: &Falls<C>,
        stretch: &Stretch<C>,
    ) -> Pull<C> {
        let m_d = carried.left(stretch, hanging.f_k).def(&s::M_D);
        let t = (m_d / falls.line.arm).def(&s::T);
        let ropes = falls.line.force(t) + stretch.line.force(hanging.f_k);
        let foot = plane::def(-(carried.force + ropes), [&s::F_O1X, &s::F_O1Y]);
        let n_b = (-plane::dot(foot, position.along)).def(&s::N_B);
        Pull { m_d, t, foot, n_b }
    }
}

/// Power of the luffing rope at its drum, in W; positive where the drum gives it.
/// T / m_l in the rope, at its speed.
pub fn power<C: Calc>(rig: &Rig<C>, pull: &Pull<C>, speeds: &Speeds<C>) -> C {
    hauled(rig, &pull.t, speeds)
}

/// The same with a pull of the luffing tackle, in N.
pub fn hauled<C: Calc>(rig: &Rig<C>, pull: &C, speeds: &Speeds<C>) -> C {
    (*pull / rig.m_l * speeds.v_l).def(&s::P_L)
}

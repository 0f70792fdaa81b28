//! A crane whose head a luffing mechanism carries: where its head is, and what it weighs.

use crate::afloat::symbols as s;
use crate::afloat::weights::{CranePlace, Weighed};
use crate::component::scalar::Scalar;
use crate::component::stages::{absent, results};
use crate::kernel::calc::{Calc, sum};
use crate::kernel::group::{One, quantities};
use crate::kernel::variable::Fault;
use crate::luffing::luffed::{self, Luffed, Luffer};

quantities! {
    /// The luffing angle, and its rate.
    LuffingMotion { theta_1: THETA_1, omega_1: OMEGA_1 }
}

/// The luffing mechanism where it moves or is held.
///
/// # Errors
/// As [`Luffed::at`].
pub fn luffed<C: Scalar>(
    of: &Luffer,
    held: &Option<One<C>>,
    luffing: &Option<LuffingMotion<C>>,
) -> Result<Luffed<C>, Fault> {
    let moved = luffing.map(|luffing| luffing.theta_1);
    Luffed::at(of, moved.or(held.map(|held| held.1)))
}

quantities! {
    /// A mass that slews.
    TurningMass { g_u: G_U, x_u: X_U, y_u: Y_U, z_u: Z_U }
}

/// Reach and height of the point where the load hangs, in m.
#[derive(Clone, Copy, Debug)]
pub struct HungPoint<C> {
    pub reach: C,
    pub height: C,
}
results! { HungPoint as h => { H_S: h.height; } }

impl<C: Calc> HungPoint<C> {
    /// As given; or h_s = h_1 + h_A.
    ///
    /// # Errors
    /// As [`luffed::reach`].
    pub fn new(reach: &Option<One<C>>, height: &One<C>, luffed: Option<&Luffed<C>>) -> Result<HungPoint<C>, Fault> {
        let above = |luffed: &Luffed<C>| (height.1 + luffed.height).def(&s::H_S);
        Ok(HungPoint {
            reach: luffed::reach(reach, luffed)?,
            height: luffed.map_or(height.1, above),
        })
    }
}

/// What slews, without load: weight (N), moments (N·m) toward the load and to the left of the boom's plane, and on the hull.
#[derive(Clone, Copy, Debug)]
pub struct CraneWeights<C> {
    pub all: Weighed<C>,
    pub forward: C,
    pub aside: Option<C>,
}
results! { CraneWeights as c => {
    W_C: c.all.weight;
    M_XI: c.forward;
    M_ETA: c.aside.ok_or_else(absent)?;
    M_LC: c.all.along;
    M_TC: c.all.across;
    M_VC: c.all.up;
} }

/// Moments toward the load and aside (N·m), as they lie along and across the hull.
pub fn slewed<C: Calc>(forward: C, aside: Option<C>, (sin, cos): (C, C)) -> [C; 2] {
    match aside {
        Some(aside) => [forward * cos - aside * sin, forward * sin + aside * cos],
        None => [forward * cos, forward * sin],
    }
}

impl<C: Calc> CraneWeights<C> {
    /// W_c = W_1 + Σ G_u, M_ξ = M_r1 + Σ G_u x_u, M_η = Σ G_u y_u; M_Lc = W_c x_s + M_ξ cos ψ − M_η sin ψ,
    /// M_Tc = W_c y_s + M_ξ sin ψ + M_η cos ψ, M_Vc = W_1 h_1 + M_h1 + Σ G_u z_u.
    pub fn new(
        psi: &One<C>,
        place: &CranePlace<C>,
        foot: &One<C>,
        luffed: &Luffed<C>,
        turning: &[TurningMass<C>],
    ) -> CraneWeights<C> {
        let of = |each: &dyn Fn(&TurningMass<C>) -> C| sum(turning.iter().map(|mass| mass.g_u * each(mass)));
        let with = |own: C, each: &dyn Fn(&TurningMass<C>) -> C| if turning.is_empty() { own } else { own + of(each) };
        let (weight, forward) = (luffed.weight, luffed.forward);
        let up = with(weight * foot.1 + luffed.up, &|mass| mass.z_u).def(&s::M_VC);
        let weight = match turning {
            [] => weight,
            _ => weight + sum(turning.iter().map(|mass| mass.g_u)),
        };
        let weight = weight.def(&s::W_C);
        let forward = with(forward, &|mass| mass.x_u).def(&s::M_XI);
        let aside = (!turning.is_empty()).then(|| of(&|mass| mass.y_u).def(&s::M_ETA));
        let [along, across] = slewed(forward, aside, psi.sin_cos());
        let all = Weighed {
            weight,
            along: (weight * place.x_s + along).def(&s::M_LC),
            across: (weight * place.y_s + across).def(&s::M_TC),
            up,
        };
        CraneWeights { all, forward, aside }
    }
}

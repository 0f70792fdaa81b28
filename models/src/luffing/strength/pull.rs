//! Oil pressure of a cylinder, and the rope of a tackle.

use std::f64::consts::FRAC_PI_4;

use crate::component::stages::results;
use crate::drive::mount::Bore;
use crate::kernel::calc::Calc;
use crate::luffing::strength::given::{Wire, under};
use crate::luffing::strength::symbols as s;

/// p = |F| / A, in Pa, with the bore where the cylinder pushes and the annulus where it pulls. [Ports001, 5.8]
pub fn pressed<C: Calc>(bore: &Bore<C>, force: &C) -> C {
    let whole = bore.d_c.square();
    let area = if force.value() < 0.0 {
        whole - bore.d_r.square()
    } else {
        whole.over(bore.d_r)
    };
    under(*force, |force| (force / (C::constant(FRAC_PI_4) * area)).def(&s::P_C))
}

/// Ratios of diameters.
#[derive(Clone, Copy, Debug)]
pub struct RopeRatios<C> {
    drum: C,
    sheave: C,
}
results! { RopeRatios as w => { H_TR: w.drum; H_SH: w.sheave; } }

impl<C: Calc> RopeRatios<C> {
    /// D / d. [Ports001, 5.8]
    pub fn new(wire: &Wire<C>) -> RopeRatios<C> {
        RopeRatios {
            drum: (wire.d_tr / wire.d_w).def(&s::H_TR),
            sheave: (wire.d_sh / wire.d_w).def(&s::H_SH),
        }
    }
}

/// The rope in a case.
#[derive(Clone, Copy, Debug)]
pub struct Tensed<C> {
    /// In N.
    pull: C,
    used: C,
}
results! { each Tensed as t => { S_W: t.pull; U_W: t.used; } }

impl<C: Calc> Tensed<C> {
    /// S Z_p ≤ F_min, where S = T / (m η) for a tackle of m falls and its efficiency that pulls with T; under a force that
    /// would press (N, positive) the rope is slack. [Ports001, 5.8]
    pub fn new(wire: &Wire<C>, [falls, eta]: [C; 2], force: &C) -> Tensed<C> {
        let pull = (-*force / (falls * eta)).def(&s::S_W);
        let used = if pull.value() > 0.0 {
            (wire.z_p * pull / wire.f_min).def(&s::U_W)
        } else {
            C::constant(0.0).over(pull).over(wire.z_p).over(wire.f_min)
        };
        Tensed { pull, used }
    }
}

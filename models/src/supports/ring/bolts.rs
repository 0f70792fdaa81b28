//! Bolts of the ring in each load case: pull of the farthest, force with its preload, clamping that is left, slip of the joint.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::quantities;
use crate::parts::safety::safety;
use crate::supports::ring::symbols as s;
use crate::supports::upper::load::SupportLoad;

quantities! {
    /// Bolts on their circle: their number, its diameter (m), preload and force at which each yields (N), part of a pull that a
    /// bolt feels on its preload, friction of the joint.
    RingBolts { n: N_B, d: D_B, preload: F_P, yields: F_Y, phi: PHI_B, mu: MU_B }
}

/// Of a case: pull of the farthest bolt and its force with preload (N), safety against yielding, clamping that is left there (N),
/// safety of the joint against slip.
#[derive(Clone, Copy, Debug)]
pub struct BoltForces<C> {
    pull: C,
    force: C,
    safety: C,
    clamps: C,
    slip: C,
}
results! { each BoltForces as b => {
    F_B: b.pull;
    F_BM: b.force;
    S_B: b.safety;
    F_K: b.clamps;
    S_H: b.slip;
} }

impl<C: Calc> BoltForces<C> {
    /// F_b = 4M/(n D_b) − V/n, F_bm = F_p + φ F_b where it is pulled, S_b = F_y/F_bm, F_k = F_p − (1 − φ) F_b,
    /// S_h = μ (n F_p + V)/H. (equilibrium of a rigid ring on springs)
    pub fn new(bolts: &RingBolts<C>, load: &SupportLoad<C>) -> BoltForces<C> {
        let turned = load.moment.scaled(4.0) / (bolts.n * bolts.d);
        let pull = (turned - load.vertical / bolts.n).def(&s::F_B);
        let pulled = bolts.phi * pull.greater(C::constant(0.0));
        let force = (bolts.preload + pulled).def(&s::F_BM);
        let rest = (C::constant(1.0) - bolts.phi) * pull;
        let grip = bolts.mu * (bolts.n * bolts.preload + load.vertical);
        BoltForces {
            pull,
            force,
            safety: (bolts.yields / force).def(&s::S_B),
            clamps: (bolts.preload - rest).def(&s::F_K),
            slip: safety(grip, load.horizontal, &s::S_H),
        }
    }
}

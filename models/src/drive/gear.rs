//! What turns a drive, as it is given.

use crate::drive::screw::Screw;
use crate::drive::symbols as s;
use crate::drive::tackle::Tackle;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::group::{either, quantities};
use crate::kernel::schema::Values;
use crate::kernel::symbol::{Symbol, listed};

quantities! {
    /// Pitch radius (m) of a pinion in a rack or a sector, and the efficiency of both.
    Pinion { r_z: R_Z, eta_d: ETA_D }
}

quantities! {
    /// Efficiency of a crank with its rod.
    Direct { eta_d: ETA_D }
}

/// Screw, pinion, crank or tackle as it is given.
#[derive(Clone, Copy, Debug)]
pub enum Gear<C> {
    Screw(Screw<C>),
    Pinion(Pinion<C>),
    Direct(Direct<C>),
    Tackle(Tackle<C>),
}

impl<C: Copy> Gear<C> {
    /// Whether a rope alone holds the driving link.
    #[must_use]
    pub fn is_rope(&self) -> bool {
        matches!(self, Gear::Tackle(_))
    }

    /// Whether a drive of this kind has a result.
    #[must_use]
    pub fn has(&self, result: &'static Symbol) -> bool {
        (matches!(self, Gear::Screw(_)) || !listed!(s: LAMBDA_D, RHO_D, LOCK_D).contains(&result))
            && (self.is_rope()
                || !listed!(s: S_L, S_L_OUT, S_L_IN, S_L_MAX, S_LM, S_LM_OUT, S_LM_IN, Z_PULL).contains(&result))
    }
}
either!(Gear {
    Screw,
    Pinion,
    Direct,
    Tackle
});

impl Gear<f64> {
    /// Of the checked table of a drive of a kind, none where it does not say how it is turned. Mistakes go to `found`.
    pub fn read(v: &Values, kind: &str, found: &mut Vec<Diagnostic>) -> Option<Gear<f64>> {
        match kind {
            "screw" => {
                let screw = Screw::read(v)?;
                if let Some(told) = screw.stuck() {
                    found.push(v.refuse(
                        "mu_d",
                        told,
                        "too much friction",
                        "give a smaller lead or less friction",
                    ));
                }
                Some(Gear::Screw(screw))
            }
            "rack" | "sector" => Pinion::read(v).map(Gear::Pinion),
            "crank" => Direct::read(v).map(Gear::Direct),
            "rope" => Tackle::read(v).map(Gear::Tackle),
            _ => None,
        }
    }
}

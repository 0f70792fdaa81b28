//! Load cases besides the one that `[hull]` itself describes: what changes in them, and what they come to.

use crate::afloat::symbols as s;
use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::{group, quantities};
use crate::kernel::symbol::{Symbol, listed};

quantities! {
    /// The wind in a load case.
    CaseWind { p_wk: P_WK, chi_wk: CHI_WK }
}

/// Results of a load case by their places: what limits may judge, in the order of [`LIMITS`], and what else is told.
pub const NAMES: [&Symbol; 11] = *listed!(s: PHI_K, THETA_K, F_K, F_OK, PHI_OK, A_K, PHI_2K, PHI_DK, K_CK, GM_K, RHO_K);

/// What is asked of the first of these, and whether that is the most or the least.
pub const LIMITS: [(&Symbol, bool); 10] = [
    (&s::PHI_MAX, true),
    (&s::THETA_MAX, true),
    (&s::F_MIN, false),
    (&s::F_O_MIN, false),
    (&s::PHI_O_MIN, false),
    (&s::A_RES_MIN, false),
    (&s::PHI_2_MAX, true),
    (&s::PHI_DYN_MAX, true),
    (&s::K_C_MIN, false),
    (&s::GM_MIN, false),
];

/// What the scene plans of a load case: its slewing angle, if it has one (rad), which openings are open, which compartments are
/// flooded, and limits by their places.
#[derive(Clone, Debug, Default)]
pub struct PlannedCase {
    pub psi: Option<f64>,
    pub open: Vec<bool>,
    pub flooded: Vec<bool>,
    pub asked: Vec<(usize, f64)>,
}

/// Which compartments are flooded in the case of `[hull]` itself, and the further cases.
#[derive(Clone, Debug, Default)]
pub struct PlannedCases {
    pub flooded: Vec<bool>,
    pub further: Vec<PlannedCase>,
}
group!(PlannedCases);

/// Those of a list that act.
pub fn acting<'a, T>(all: &'a [T], act: &'a [bool]) -> impl Iterator<Item = &'a T> {
    all.iter().zip(act).filter(|(_, acts)| **acts).map(|(one, _)| one)
}

/// What a load case comes to: results by their places, and the greatest part that they use of their limits.
#[derive(Clone, Copy, Debug)]
pub struct CaseOutcome<C> {
    found: [C; NAMES.len()],
    used: C,
}
results! { each CaseOutcome as o => {
    PHI_K: o.found[0];
    THETA_K: o.found[1];
    F_K: o.found[2];
    F_OK: o.found[3];
    PHI_OK: o.found[4];
    A_K: o.found[5];
    PHI_2K: o.found[6];
    PHI_DK: o.found[7];
    K_CK: o.found[8];
    GM_K: o.found[9];
    RHO_K: o.found[10];
    U_K: o.used;
} }

impl<C: Calc> CaseOutcome<C> {
    /// u = max(|x|/x_max, x_min/x) over all limits of the case, and 1/ρ where a loss of load is judged.
    pub fn new(found: [C; NAMES.len()], planned: &PlannedCase, loses: bool) -> CaseOutcome<C> {
        let part = |&(place, limit): &(usize, f64)| {
            let (symbol, most) = LIMITS[place];
            let limit = C::known(symbol, limit);
            if most {
                found[place].abs() / limit
            } else {
                limit / found[place]
            }
        };
        let lost = loses.then(|| C::constant(1.0) / found[10]);
        let used = planned.asked.iter().map(part).chain(lost).reduce(C::greater);
        CaseOutcome {
            found,
            used: used.unwrap_or(C::constant(0.0)).def(&s::U_K),
        }
    }
}

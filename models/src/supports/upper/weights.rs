//! What slews on a support besides the load: its weights, and the areas on which the wind acts.

use crate::component::stages::{absent, results};
use crate::kernel::calc::{Calc, sum};
use crate::kernel::group::quantities;
use crate::kernel::variable::Fault;
use crate::supports::upper::symbols as s;

quantities! {
    /// A body of the upper works.
    UpperWeight { g_u: G_U, r_u: R_U, h_u: H_U }
}

quantities! {
    /// An area on which the wind acts.
    UpperArea { a_w: A_W, h_w: H_W }
}

quantities! {
    /// Slope, and the height from which the load hangs.
    UpperSlope { gamma: GAMMA, h_q: H_Q }
}

/// The upper works: weight (N), its moment (N·m), with a slope its sum with the heights (N·m); the wind areas (m²) and
/// their sum with the heights (m³).
#[derive(Clone, Copy, Debug)]
pub struct UpperWorks<C> {
    pub weight: C,
    pub moment: C,
    pub high: Option<C>,
    pub areas: Option<[C; 2]>,
}
results! { UpperWorks as u => {
    G_0: u.weight;
    M_U: u.moment;
    S_U: u.high.ok_or_else(absent)?;
    A_SUM: u.areas.ok_or_else(absent)?[0];
    S_W: u.areas.ok_or_else(absent)?[1];
} }

impl<C: Calc> UpperWorks<C> {
    /// G_0 = Σ G_u, M_u = Σ G_u r_u, S_u = Σ G_u h_u, A_w = Σ A_wi, S_w = Σ A_wi h_wi.
    ///
    /// # Errors
    /// Nothing weighs anything.
    pub fn new(
        upper: &[UpperWeight<C>],
        slope: &Option<UpperSlope<C>>,
        areas: &[UpperArea<C>],
    ) -> Result<UpperWorks<C>, Fault> {
        let weight = sum(upper.iter().map(|body| body.g_u)).def(&s::G_0);
        if weight.value() <= 0.0 {
            let what = "G_0 = 0: upper works without weight load no slewing support; give the weights of what slews";
            return Err(Fault::outside(what));
        }
        let high = || sum(upper.iter().map(|body| body.g_u * body.h_u)).def(&s::S_U);
        Ok(UpperWorks {
            weight,
            moment: sum(upper.iter().map(|body| body.g_u * body.r_u)).def(&s::M_U),
            high: slope.as_ref().map(|_| high()),
            areas: (!areas.is_empty()).then(|| {
                [
                    sum(areas.iter().map(|area| area.a_w)).def(&s::A_SUM),
                    sum(areas.iter().map(|area| area.a_w * area.h_w)).def(&s::S_W),
                ]
            }),
        })
    }
}

//! What slews on a support besides the load: its weights, and the areas on which the wind acts.

use crate::component::stages::{absent, results};
use crate::kernel::calc::{Calc, sum};
use crate::kernel::group::{One, quantities};
use crate::kernel::variable::Fault;
use crate::luffing::luffed::Luffed;
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
    /// Slope on which the crane stands.
    UpperSlope { gamma: GAMMA }
}

/// The upper works: weight (N), its moment (N·m), with a slope its sum with the heights (N·m) and the height from which the load
/// hangs (m); the wind areas (m²) and their sum with the heights (m³).
#[derive(Clone, Copy, Debug)]
pub struct UpperWorks<C> {
    pub weight: C,
    pub moment: C,
    pub high: Option<[C; 2]>,
    pub areas: Option<[C; 2]>,
}
results! { UpperWorks as u => {
    G_0: u.weight;
    M_U: u.moment;
    S_U: u.high.ok_or_else(absent)?[0];
    H_Q: u.high.ok_or_else(absent)?[1];
    A_SUM: u.areas.ok_or_else(absent)?[0];
    S_W: u.areas.ok_or_else(absent)?[1];
} }

impl<C: Calc> UpperWorks<C> {
    /// G_0 = Σ G_u, M_u = Σ G_u r_u, S_u = Σ G_u h_u, A_w = Σ A_wi, S_w = Σ A_wi h_wi; with a luffing mechanism G_0 has W_1, M_u has
    /// M_r1, S_u has W_1 h_1 + M_h1, and h_Q = h_1 + h_A.
    ///
    /// # Errors
    /// Nothing weighs anything.
    pub fn new(
        upper: &[UpperWeight<C>],
        slope: &Option<UpperSlope<C>>,
        hook: &Option<One<C>>,
        areas: &[UpperArea<C>],
        foot: &Option<One<C>>,
        luffed: Option<&Luffed<C>>,
    ) -> Result<UpperWorks<C>, Fault> {
        let with = |own: C, of: &dyn Fn(&Luffed<C>) -> C| luffed.map_or(own, |luffed| own + of(luffed));
        let weight = with(sum(upper.iter().map(|body| body.g_u)), &|luffed| luffed.weight).def(&s::G_0);
        if weight.value() <= 0.0 {
            let what = "G_0 = 0: upper works without weight load no slewing support; give the weights of what slews";
            return Err(Fault::outside(what));
        }
        let moment = with(sum(upper.iter().map(|body| body.g_u * body.r_u)), &|luffed| {
            luffed.forward
        })
        .def(&s::M_U);
        let high = |hung: C| {
            let own = sum(upper.iter().map(|body| body.g_u * body.h_u));
            let up = |luffed: &Luffed<C>| foot.map_or(luffed.up, |foot| luffed.weight * *foot + luffed.up);
            [with(own, &up).def(&s::S_U), hung]
        };
        let above = foot
            .zip(luffed)
            .map(|(foot, luffed)| (*foot + luffed.height).def(&s::H_Q));
        let hung = above.or(hook.map(|hook| *hook));
        Ok(UpperWorks {
            weight,
            moment,
            high: slope.as_ref().and(hung).map(high),
            areas: (!areas.is_empty()).then(|| {
                [
                    sum(areas.iter().map(|area| area.a_w)).def(&s::A_SUM),
                    sum(areas.iter().map(|area| area.a_w * area.h_w)).def(&s::S_W),
                ]
            }),
        })
    }
}

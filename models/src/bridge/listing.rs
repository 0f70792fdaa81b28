//! List of the spreader: the load's centre of gravity out of the middle along the beam.
//!
//! The four-bar moves to where its potential energy is least: `m g (u² E/(2 h) − e_x κ u)`. Ropes that are parallel keep the spreader
//! level; those of a trapezoid turn it. The pulls follow from moments about the other side's joints. All to the first order of the
//! list.

use crate::bridge::suspension::{FourRopes, Suspended};
use crate::bridge::symbols as s;
use crate::component::stages::results;
use crate::kernel::calc::Calc;

/// Travel of the spreader's middle (m), its list (rad), pull of a rope on the sea side and on the land side (N).
#[derive(Clone, Copy, Debug)]
pub struct Listing<C> {
    travel: C,
    list: C,
    pulls: [C; 2],
}
results! { Listing as l => { U_L: l.travel; BETA_L: l.list; S_R1: l.pulls[0]; S_R2: l.pulls[1]; } }

impl<C: Calc> Listing<C> {
    /// u = e_x κ h/E, β = κ u; S = W l (a_u ± (e_x − e_Q β))/(4 a_u (h ± β (a_o ∓ u))). (equilibrium)
    pub fn new(ropes: &FourRopes<C>, length: &C, hanging: &Suspended<C>, weight: &C) -> Listing<C> {
        let FourRopes { a_o, a_u, e_q, e_x, .. } = *ropes;
        let travel = (e_x * hanging.turn * hanging.height / hanging.back).def(&s::U_L);
        let list = (hanging.turn * travel).def(&s::BETA_L);
        let part = *weight * *length / a_u.scaled(4.0);
        let aside = e_x - e_q * list;
        Listing {
            travel,
            list,
            pulls: [
                (part * (a_u + aside) / (hanging.height + list * (a_o - travel))).def(&s::S_R1),
                (part * (a_u - aside) / (hanging.height - list * (a_o + travel))).def(&s::S_R2),
            ],
        }
    }
}

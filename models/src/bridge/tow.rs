//! The tow rope: tensions of both sides, sag, stretch.
//!
//! A rope that sags little hangs in a parabola: its weight counts over the span, and its tension is the same all along.

use crate::bridge::symbols as s;
use crate::bridge::trolley::TravelForces;
use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::{One, quantities};
use crate::kernel::variable::Fault;

quantities! {
    /// A tow rope: tension on the slack side (N), number on a side, weight over length (N/m), stiffness and breaking force (N),
    /// places of its sheaves (m).
    TowRope { t_0: T_0, z_r: Z_R, q_r: Q_R, ea: EA, f_b: F_B, x_1: X_1, x_2: X_2 }
}

/// Both sides of a tow rope: tensions (N), sags and stretches (m), the greater sag, the safety.
#[derive(Clone, Copy, Debug)]
pub struct TowRun<C> {
    tensions: [C; 2],
    sags: [C; 2],
    stretches: [C; 2],
    sag: C,
    safety: C,
}
results! { TowRun as t => {
    T_1: t.tensions[0];
    T_2: t.tensions[1];
    F_1: t.sags[0];
    F_2: t.sags[1];
    DELTA_1: t.stretches[0];
    DELTA_2: t.stretches[1];
    F_TOW: t.sag;
    NU: t.safety;
} }

impl<C: Calc> TowRun<C> {
    /// z (T_1 − T_2) = F_r with T_0 on the slack side; f = q l²/(8 T), δ = T l/(E A), ν = F_b/T. [parabola; Hooke]
    ///
    /// # Errors
    /// A trolley beyond the sheaves of its rope.
    pub fn new(tow: &TowRope<C>, place: &One<C>, forces: &TravelForces<C>) -> Result<TowRun<C>, Fault> {
        let at = place.value();
        if at >= tow.x_1.value() || at <= tow.x_2.value() {
            return Err(Fault::outside(format!(
                "x_t = {} is not between the sheaves of the tow rope, x_2 = {} and x_1 = {}",
                s::X_T.written(at),
                s::X_2.written(tow.x_2.value()),
                s::X_1.written(tow.x_1.value())
            )));
        }
        let pull = forces.total / tow.z_r;
        let slack = tow.t_0.over(pull);
        let tensions = match pull.value() < 0.0 {
            true => [slack.def(&s::T_1), (tow.t_0 - pull).def(&s::T_2)],
            false => [(tow.t_0 + pull).def(&s::T_1), slack.def(&s::T_2)],
        };
        let spans = [tow.x_1 - **place, **place - tow.x_2];
        let [sags, stretches] = [[&s::F_1, &s::F_2], [&s::DELTA_1, &s::DELTA_2]];
        let sags: [C; 2] =
            std::array::from_fn(|i| (tow.q_r * spans[i].square() / (C::constant(8.0) * tensions[i])).def(sags[i]));
        Ok(TowRun {
            tensions,
            sags,
            stretches: std::array::from_fn(|i| (tensions[i] * spans[i] / tow.ea).def(stretches[i])),
            sag: sags[0].greater(sags[1]).def(&s::F_TOW),
            safety: (tow.f_b / tensions[0].greater(tensions[1])).def(&s::NU),
        })
    }
}

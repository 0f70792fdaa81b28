//! What is in the hopper, and the steady balance of grab and feeder, in closed form.

use crate::component::stages::results;
use crate::hopper::symbols as s;
use crate::kernel::calc::Calc;
use crate::kernel::group::{One, quantities};
use crate::kernel::variable::Fault;

quantities! {
    /// The hopper.
    HopperSize { m_max: M_MAX, rho_b: RHO_B }
}

quantities! {
    /// The grab that feeds it.
    GrabCycle { m_g: M_G, t_c: T_C, t_d: T_D, t_p: T_P }
}

quantities! {
    /// The feeder that empties it.
    HopperFeeder { q_f: Q_F }
}

quantities! {
    /// What it is told, where the contents move.
    FeederCommand { y_f: Y_F }
}

/// Grab and feeder at their means: flow of the grab (kg/s), the same over that of the feeder, longest cycle (s).
#[derive(Clone, Copy, Debug)]
pub struct SteadyFlow<C> {
    grab: C,
    ratio: C,
    longest: C,
}
results! { SteadyFlow as f => { Q_G: f.grab; K_Q: f.ratio; T_C_MAX: f.longest; } }

impl<C: Calc> SteadyFlow<C> {
    /// q_g = m_g / t_c, k_q = q_g / q_f, t_c,max = m_g / q_f.
    pub fn new(grab: &GrabCycle<C>, feeder: &HopperFeeder<C>) -> SteadyFlow<C> {
        let flow = (grab.m_g / grab.t_c).def(&s::Q_G);
        SteadyFlow {
            grab: flow,
            ratio: (flow / feeder.q_f).def(&s::K_Q),
            longest: (grab.m_g / feeder.q_f).def(&s::T_C_MAX),
        }
    }
}

/// Contents (kg) that bridge the pause, rise at a load of the grab, what the hopper must hold, reserve, and volume (m³).
#[derive(Clone, Copy, Debug)]
pub struct NeededCapacity<C> {
    bridge: C,
    rise: C,
    need: C,
    reserve: C,
    volume: C,
}
results! { NeededCapacity as n => {
    M_BR: n.bridge;
    D_M: n.rise;
    M_NEED: n.need;
    M_RES: n.reserve;
    V_MAX: n.volume;
} }

impl<C: Calc> NeededCapacity<C> {
    /// m_br = q_f t_p, Δm = m_g − q_f t_d, m_need = m_br + Δm where that is a rise, m_res = m_max − m_need, V = m_max / ρ.
    pub fn new(hopper: &HopperSize<C>, grab: &GrabCycle<C>, feeder: &HopperFeeder<C>) -> NeededCapacity<C> {
        let bridge = (feeder.q_f * grab.t_p).def(&s::M_BR);
        let rise = (grab.m_g - feeder.q_f * grab.t_d).def(&s::D_M);
        let need = if rise.value() > 0.0 {
            bridge + rise
        } else {
            bridge.over(rise)
        };
        let need = need.def(&s::M_NEED);
        NeededCapacity {
            bridge,
            rise,
            need,
            reserve: (hopper.m_max - need).def(&s::M_RES),
            volume: (hopper.m_max / hopper.rho_b).def(&s::V_MAX),
        }
    }
}

/// The contents as weight (N), part of the capacity and volume (m³), and room for loads of the grab.
#[derive(Clone, Copy, Debug)]
pub struct HopperContents<C> {
    weight: C,
    filling: C,
    volume: C,
    loads: C,
}
results! { HopperContents as h => { G_H: h.weight; PHI_H: h.filling; V_H: h.volume; N_G: h.loads; } }

impl<C: Calc> HopperContents<C> {
    /// G = m g, φ = m / m_max, V = m / ρ, n = (m_max − m) / m_g.
    ///
    /// # Errors
    /// Contents that stand still and that no hopper has; of those that move it is decided at an event.
    pub fn new(
        hopper: &HopperSize<C>,
        grab: &GrabCycle<C>,
        gravity: &One<C>,
        moves: &Option<FeederCommand<C>>,
        contents: &One<C>,
    ) -> Result<HopperContents<C>, Fault> {
        let (m, most) = (contents.value(), hopper.m_max.value());
        if moves.is_none() && !(0.0..=most).contains(&m) {
            return Err(Fault::outside(format!(
                "{} = {}: the hopper holds from 0 to {} = {}",
                s::M_H.id,
                s::M_H.written(m),
                s::M_MAX.id,
                s::M_MAX.written(most)
            )));
        }
        Ok(HopperContents {
            weight: (**contents * **gravity).def(&s::G_H),
            filling: (**contents / hopper.m_max).def(&s::PHI_H),
            volume: (**contents / hopper.rho_b).def(&s::V_H),
            loads: ((hopper.m_max - **contents) / grab.m_g).def(&s::N_G),
        })
    }
}

/// Times (s) until the hopper is empty by the feeder alone, full by both at their means, empty by both.
#[derive(Clone, Copy, Debug)]
pub struct HopperTimes<C> {
    run: C,
    full: C,
    low: C,
}
results! { HopperTimes as t => { T_RUN: t.run; T_FULL: t.full; T_LOW: t.low; } }

impl<C: Calc> HopperTimes<C> {
    /// t_run = m / q_f, t_full = (m_max − m) / (q_g − q_f), t_low = m / (q_f − q_g).
    pub fn new(
        hopper: &HopperSize<C>,
        feeder: &HopperFeeder<C>,
        steady: &SteadyFlow<C>,
        contents: &One<C>,
    ) -> HopperTimes<C> {
        let (gain, m) = (steady.grab - feeder.q_f, **contents);
        let never = |symbol| C::known(symbol, f64::INFINITY).over(gain).over(m);
        HopperTimes {
            run: (m / feeder.q_f).def(&s::T_RUN),
            full: if gain.value() > 0.0 {
                ((hopper.m_max - m) / (steady.grab - feeder.q_f)).def(&s::T_FULL)
            } else {
                never(&s::T_FULL)
            },
            low: if gain.value() < 0.0 {
                (m / (feeder.q_f - steady.grab)).def(&s::T_LOW)
            } else {
                never(&s::T_LOW)
            },
        }
    }
}

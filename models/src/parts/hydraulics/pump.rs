//! A pump that holds its pressure until flow or power is at its limit; beyond that the pressure falls.

use crate::kernel::calc::{Calc, Over};
use crate::kernel::group::quantities;
use crate::parts::hydraulics::symbols as s;
use crate::parts::hydraulics::throttle::{LAMINAR, difference, root};

quantities! {
    /// Most that a pump gives.
    PumpLimits { q_pmax: Q_PMAX, p_pmax: P_PMAX }
}

/// What a pump is asked for: the flow (m³/s) through an edge of a conductance (m³/s over √Pa) into a port at a pressure
/// (Pa), were the pump to hold its own.
#[derive(Clone, Copy, Debug)]
pub struct PumpDemand<C> {
    pub flow: C,
    pub edge: C,
    pub port: C,
    /// Pressure that the pump holds, in Pa.
    pub supply: C,
}

impl<C: Calc> PumpDemand<C> {
    fn plain(&self) -> PumpDemand<f64> {
        let [flow, edge, port, supply] = [self.flow, self.edge, self.port, self.supply].map(C::value);
        PumpDemand {
            flow,
            edge,
            port,
            supply,
        }
    }

    /// Pressure of the pump (Pa) with which its edge passes no more than a flow.
    fn behind(&self, flow: C) -> C {
        let turbulent = (flow / self.edge).square().def(&s::DP_T);
        self.port + difference(turbulent).def(&s::DP_E)
    }
}

impl<P: Calc> PumpLimits<P> {
    /// Flow into the port (m³/s) and pressure of the pump (Pa): Q = min(Q_edge(p_P), Q_max), and where p Q would be more
    /// than P_max the flow with which it is that.
    #[inline]
    pub fn delivered<C: Over<P>>(&self, asked: &PumpDemand<C>) -> [C; 2] {
        let [within, behind] = self.map(&mut |_, most| most.value()).within_flow(&asked.plain());
        if within * behind <= self.p_pmax.value() {
            return self.within_flow(asked);
        }
        let drop = self.drop(asked, within);
        [asked.edge * root(drop), asked.port + drop]
    }

    /// The same of a pump with any power.
    fn within_flow<C: Over<P>>(&self, asked: &PumpDemand<C>) -> [C; 2] {
        if asked.flow.value() <= self.q_pmax.value() {
            return [asked.flow, asked.supply];
        }
        let most = C::of(self.q_pmax);
        [most, asked.behind(most)]
    }

    /// Pressure difference over the edge at which (p + Δp) Q(Δp) = P_max: found for plain numbers below a flow (m³/s), and
    /// one step of Newton's for all else.
    fn drop<C: Over<P>>(&self, asked: &PumpDemand<C>, below: f64) -> C {
        let (edge, port) = (asked.edge.value(), asked.port.value());
        let found = throttled(port, self.p_pmax.value() / edge, below / edge);
        let slope = edge * (found[0] + (port + found[1]) / found[2]);
        let start = C::constant(found[1]).def(&s::DP_E0);
        let slope = C::constant(slope).def(&s::Q_E0);
        let power = ((asked.port + start) * asked.edge * root(start)).def(&s::P_E0);
        (start + (C::of(self.p_pmax) - power) / slope).def(&s::DP_E)
    }

    /// What is left of flow (m³/s) and, of the pump within that, of power (W) until they are at their limits.
    #[inline]
    pub fn margins<C: Over<P>>(&self, asked: &PumpDemand<C>) -> [C; 2] {
        let [flow, pressure] = self.within_flow(asked);
        [C::of(self.q_pmax) - asked.flow, C::of(self.p_pmax) - flow * pressure]
    }
}

/// The root r of a pressure difference Δp (√Pa) with r (p + Δp) = `power`, with that difference (Pa) and its slope over the
/// root (√Pa): p and a root above it are given. The left side bends upward, so that Newton's method falls to it.
fn throttled(port: f64, power: f64, above: f64) -> [f64; 3] {
    const STEPS: u32 = 100;
    let at = |root: f64| {
        let drop = difference(root * root);
        let (square, laminar) = (drop * drop, LAMINAR * LAMINAR);
        let sum = square + laminar;
        // Of the edge: dr/dΔp = (Δp²/2 + Δp_l²)/(Δp² + Δp_l²)^(5/4).
        let slope = sum * sum.sqrt().sqrt() / (0.5 * square + laminar);
        [root, drop, slope]
    };
    let mut found = at(above);
    for _ in 0..STEPS {
        let [root, drop, slope] = found;
        let next = root - (root * (port + drop) - power) / (port + drop + root * slope);
        if next >= root || !next.is_finite() {
            break;
        }
        found = at(next);
    }
    found
}

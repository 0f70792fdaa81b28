//! Proportional valve with four edges.

use crate::kernel::calc::{Calc, Over};
use crate::kernel::number::short;
use crate::kernel::symbol::Symbol;
use crate::parts::hydraulics::symbols::Y_V;
use crate::parts::hydraulics::throttle::root;

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Valve<P = f64> {
    /// Flow (m³/s) over the root of the pressure difference (Pa) at one fully open edge.
    pub conductance: P,
    /// Part of the stroke, from the middle and to either side, in which no edge is open; below 1.
    pub overlap: P,
    /// Natural frequency of the spool, in rad/s, and its damping ratio.
    pub frequency: P,
    pub damping: P,
}

impl<P: Calc> Valve<P> {
    /// The conductance that passes `flow` (m³/s) at `difference` (Pa) over one edge.
    #[must_use]
    pub fn rated(flow: P, difference: P) -> P {
        flow / difference.sqrt()
    }

    /// Flows (m³/s) from the valve into the ports A and B, with the spool at `x` in [−1, 1] of its
    /// stroke: positive connects A with the pump and B with the tank.
    #[inline(always)]
    pub fn flows<C: Over<P>>(&self, x: C, supply: P, ports: [C; 2]) -> [C; 2] {
        let opening = self.opening(x).def(&Y_V).times(self.conductance);
        let pump = |p: C| opening * root(C::of(supply) - p);
        let tank = |p: C| opening * root(p);
        if x.value() >= 0.0 {
            [pump(ports[0]), -tank(ports[1])]
        } else {
            [tank(ports[0]), -pump(ports[1])]
        }
    }

    /// Part of the edges that is open, with the sign of the spool: none within the overlap.
    #[inline]
    pub fn opening<C: Over<P>>(&self, x: C) -> C {
        let overlap = C::of(self.overlap);
        if x.value().abs() < overlap.value() {
            return C::constant(0.0);
        }
        let beyond = if x.value() < 0.0 { x + overlap } else { x - overlap };
        beyond.times(P::constant(1.0) / (P::constant(1.0) - self.overlap))
    }

    /// Rate of the spool's speed, in 1/s², towards the command in [−1, 1].
    #[inline]
    pub fn acceleration<C: Over<P>>(&self, x: C, speed: C, command: P) -> C {
        let w = self.frequency;
        (C::of(command) - x).times(w * w) - speed.times(P::constant(2.0) * self.damping * w)
    }
}

/// Speed of sound in oil, in m/s.
const SOUND: f64 = 1400.0;

/// Where a rated flow (m³/s) into a cylinder with a bore (m) would be faster than sound: that, and what to do.
#[must_use]
pub fn supersonic(rated: &'static Symbol, flow: f64, bore: f64) -> Option<[String; 2]> {
    let area = std::f64::consts::FRAC_PI_4 * bore * bore;
    let most = SOUND * area;
    (flow > most).then(|| {
        let given = rated.written(flow);
        [
            format!(
                "a valve of {} = {given} moves its cylinder faster than sound goes through oil",
                rated.id
            ),
            format!(
                "a bore of {} mm takes {} at most",
                short(1e3 * bore),
                rated.written(most)
            ),
        ]
    })
}

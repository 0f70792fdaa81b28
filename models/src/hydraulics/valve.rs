//! Proportional valve with four edges.

use crate::calc::Calc;
use crate::hydraulics::throttle::root;

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Valve {
    /// Flow (m³/s) over the root of the pressure difference (Pa) at one fully open edge.
    pub conductance: f64,
    /// Part of the stroke, from the middle and to either side, in which no edge is open; below 1.
    pub overlap: f64,
    /// Natural frequency of the spool, in rad/s, and its damping ratio.
    pub frequency: f64,
    pub damping: f64,
}

impl Valve {
    /// The conductance that passes `flow` (m³/s) at `difference` (Pa) over one edge.
    #[must_use]
    pub fn rated(flow: f64, difference: f64) -> f64 {
        flow / difference.sqrt()
    }

    /// Flows (m³/s) from the valve into the ports A and B, with the spool at `x` in [−1, 1] of its
    /// stroke: positive connects A with the pump and B with the tank.
    #[inline]
    pub fn flows<C: Calc>(&self, x: C, supply: f64, ports: [C; 2]) -> [C; 2] {
        let opening = C::constant(self.conductance) * self.opening(x);
        let pump = |p: C| opening * root(C::constant(supply) - p);
        let tank = |p: C| opening * root(p);
        if x.value() >= 0.0 {
            [pump(ports[0]), -tank(ports[1])]
        } else {
            [tank(ports[0]), -pump(ports[1])]
        }
    }

    /// Part of the edges that is open, with the sign of the spool: none within the overlap.
    #[inline]
    pub fn opening<C: Calc>(&self, x: C) -> C {
        if x.value().abs() < self.overlap {
            return C::constant(0.0);
        }
        (x - C::constant(self.overlap.copysign(x.value()))) / C::constant(1.0 - self.overlap)
    }

    /// Rate of the spool's speed, in 1/s², towards the command in [−1, 1].
    #[inline]
    pub fn acceleration<C: Calc>(&self, x: C, speed: C, command: f64) -> C {
        let w = self.frequency;
        C::constant(w * w) * (C::constant(command) - x) - C::constant(2.0 * self.damping * w) * speed
    }
}

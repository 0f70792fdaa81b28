//! A double-acting cylinder with a volume of oil in each chamber and in each
//! port of the valve, a line between the two, relief valves at the ports and
//! leakage past the piston.

use crate::calc::Calc;
use crate::hydraulics::oil::pressure_rate;
use crate::hydraulics::throttle::{relief, root};
use crate::hydraulics::valve::Valve;

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cylinder {
    /// Areas of bore and annulus, in m².
    pub areas: [f64; 2],
    /// Lengths retracted and extended, in m.
    pub lengths: [f64; 2],
    /// Oil left in a chamber at the piston's end, in m³.
    pub dead_volume: f64,
    /// Oil in each port of the valve, in m³.
    pub port_volume: f64,
    /// Of each line: flow (m³/s) over the root of the pressure difference (Pa).
    pub line: f64,
    /// Past the piston, in m³/(s·Pa).
    pub leakage: f64,
    /// Of oil and walls, in Pa.
    pub bulk_modulus: f64,
    /// Opening pressure of the relief valves (Pa), and their flow over the excess, in m³/(s·Pa).
    pub relief: [f64; 2],
    pub valve: Valve,
}

/// Oil and spool of one cylinder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Oil<C> {
    /// Pressures of the ports A and B, then of the chambers of bore and annulus, in Pa.
    pub ports: [C; 2],
    pub chambers: [C; 2],
    /// Spool in [−1, 1] of its stroke, and its speed in 1/s.
    pub spool: C,
    pub spool_speed: C,
}

/// Flows of one cylinder, in m³/s.
#[derive(Clone, Copy, Debug)]
pub struct Flows<C> {
    /// From the valve into the ports, and on into the chambers.
    pub valve: [C; 2],
    pub line: [C; 2],
    /// From the ports to the tank.
    pub relief: [C; 2],
    /// From bore to annulus.
    pub leakage: C,
}

impl Cylinder {
    /// Areas of bore and annulus, in m², of a bore and a rod in m.
    #[must_use]
    pub fn areas(bore: f64, rod: f64) -> [f64; 2] {
        let quarter = std::f64::consts::FRAC_PI_4;
        [quarter * bore * bore, quarter * (bore * bore - rod * rod)]
    }

    /// Push on the rod, in N.
    #[inline]
    pub fn force<C: Calc>(&self, oil: &Oil<C>) -> C {
        C::constant(self.areas[0]) * oil.chambers[0] - C::constant(self.areas[1]) * oil.chambers[1]
    }

    #[inline]
    pub fn flows<C: Calc>(&self, oil: &Oil<C>, supply: f64) -> Flows<C> {
        let line = |i: usize| C::constant(self.line) * root(oil.ports[i] - oil.chambers[i]);
        Flows {
            valve: self.valve.flows(oil.spool, supply, oil.ports),
            line: [line(0), line(1)],
            relief: oil.ports.map(|p| relief(p, self.relief[0], self.relief[1])),
            leakage: C::constant(self.leakage) * (oil.chambers[0] - oil.chambers[1]),
        }
    }

    /// Oil in the chambers, in m³, at a length (m).
    #[inline]
    pub fn volumes<C: Calc>(&self, length: C) -> [C; 2] {
        let constant = C::constant;
        let [short, long] = self.lengths;
        [
            constant(self.dead_volume) + constant(self.areas[0]) * (length - constant(short)),
            constant(self.dead_volume) + constant(self.areas[1]) * (constant(long) - length),
        ]
    }

    /// Rates of all of the oil's states at a length (m) and speed (m/s, lengthening positive);
    /// `command` in [−1, 1], `supply` in Pa.
    #[inline]
    pub fn rates<C: Calc>(&self, oil: &Oil<C>, length: C, speed: C, command: f64, supply: f64) -> Oil<C> {
        let f = self.flows(oil, supply);
        let volumes = self.volumes(length);
        let (ports, still) = (C::constant(self.port_volume), C::constant(0.0));
        let port = |i: usize| pressure_rate(self.bulk_modulus, ports, f.valve[i] - f.line[i] - f.relief[i], still);
        let chamber = |i: usize, flow: C, growth: C| pressure_rate(self.bulk_modulus, volumes[i], flow, growth);
        Oil {
            ports: [port(0), port(1)],
            chambers: [
                chamber(0, f.line[0] - f.leakage, C::constant(self.areas[0]) * speed),
                chamber(1, f.line[1] + f.leakage, C::constant(-self.areas[1]) * speed),
            ],
            spool: oil.spool_speed,
            spool_speed: self.valve.acceleration(oil.spool, oil.spool_speed, command),
        }
    }
}

//! A double-acting cylinder with a volume of oil in each chamber and in each
//! port of the valve, a line between the two, relief valves at the ports and
//! leakage past the piston.

use crate::kernel::calc::{Calc, Over};
use crate::kernel::symbol::Symbol;
use crate::parts::hydraulics::load_holding::checked;
use crate::parts::hydraulics::oil::{VACUUM, pressure_rate};
use crate::parts::hydraulics::parts::OilParts;
use crate::parts::hydraulics::pump::PumpDemand;
use crate::parts::hydraulics::symbols as s;
use crate::parts::hydraulics::throttle::{relief, root};
use crate::parts::hydraulics::valve::Valve;

/// Oil flow to a cylinder with a bore and a rod (m), in m³/s, at its speed (m/s): on the bore where it lengthens, on the
/// annulus (negative) where it shortens. With the symbols of that area and of the flow.
pub fn flow<C: Calc>([bore, rod]: [C; 2], speed: C, [area, flow]: [&'static Symbol; 2]) -> C {
    let quarter = C::constant(std::f64::consts::FRAC_PI_4);
    let works = if speed.value() < 0.0 {
        quarter * (bore.square() - rod.square())
    } else {
        quarter * bore.square()
    };
    (works.def(area) * speed).def(flow)
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cylinder<P = f64> {
    /// Areas of bore and annulus, in m².
    pub areas: [P; 2],
    /// Lengths retracted and extended, in m.
    pub lengths: [P; 2],
    /// Oil left in a chamber at the piston's end, in m³.
    pub dead_volume: P,
    /// Oil in each port of the valve, in m³.
    pub port_volume: P,
    /// Of each line: flow (m³/s) over the root of the pressure difference (Pa).
    pub line: P,
    /// Past the piston, in m³/(s·Pa).
    pub leakage: P,
    /// Of oil and walls, in Pa.
    pub bulk_modulus: P,
    /// Opening pressure of the relief valves (Pa), and their flow over the excess, in m³/(s·Pa).
    pub relief: [P; 2],
    pub valve: Valve<P>,
    pub parts: Option<OilParts<P>>,
    /// Parts of the lines, in [0, 1], that are torn open between the valve's ports and the load-holding valves.
    pub torn: [P; 2],
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

impl<C: Calc> Oil<C> {
    /// The port with which the valve connects the pump.
    #[inline(always)]
    fn fed(&self) -> usize {
        usize::from(self.spool.value() < 0.0)
    }

    /// Place of the least of all pressures among those of the ports and chambers, and that pressure, in Pa.
    #[inline]
    pub fn least(&self) -> (usize, C) {
        let ([p_1, p_2], [p_a, p_b]) = (self.ports, self.chambers);
        let all = [(0, p_1), (1, p_2), (2, p_a), (3, p_b)];
        let less = |a: (usize, C), b: (usize, C)| {
            if b.1.value() < a.1.value() {
                (b.0, b.1.over(a.1))
            } else {
                (a.0, a.1.over(b.1))
            }
        };
        less(less(all[0], all[1]), less(all[2], all[3]))
    }
}

impl Oil<f64> {
    /// Whether the pressures are bounded, and none pulls with the bulk modulus (Pa), which stretches oil by all of its volume.
    #[must_use]
    pub fn is_possible(&self, bulk_modulus: f64) -> bool {
        /// In Pa.
        const MOST: f64 = 1e12;
        let mut pressures = self.ports.iter().chain(&self.chambers);
        pressures.all(|pressure| (-bulk_modulus..MOST).contains(pressure))
    }

    /// Whether oil is below vacuum. `rates` are those of the pressures of ports and chambers, in Pa/s: an importer meets
    /// the event with a pressure that is at vacuum but for rounding, and what it is then to be is told by its rate.
    pub fn cavitates(&self, rates: impl FnOnce() -> [f64; 4]) -> bool {
        /// In Pa.
        const ROUNDING: f64 = 1.0;
        let (at, least) = self.least();
        let margin = least - VACUUM;
        if margin.abs() > ROUNDING {
            margin < 0.0
        } else {
            rates()[at] < 0.0
        }
    }
}

/// Flows of one cylinder, in m³/s.
#[derive(Clone, Copy, Debug)]
pub struct Flows<C> {
    /// From the valve into the ports, and on into the chambers; the pump's is one of the former.
    pub valve: [C; 2],
    pub pump: C,
    /// Pressure of the pump above that of the tank, in Pa.
    pub supply: C,
    pub line: [C; 2],
    /// Parts of the load-holding valves that are open; none without them.
    pub openings: Option<[C; 2]>,
    /// From the tank into the chambers.
    pub drawn: Option<[C; 2]>,
    /// Out of torn lines.
    pub torn: Option<[C; 2]>,
    /// From the ports to the tank in the valve's middle.
    pub relieved: Option<[C; 2]>,
    /// From the ports to the tank.
    pub relief: [C; 2],
    /// From bore to annulus.
    pub leakage: C,
}

impl<C: Calc> Flows<C> {
    /// What is left of them in a port.
    #[inline(always)]
    fn gains(&self, i: usize) -> C {
        let left = self.valve[i] - self.line[i] - self.relief[i];
        let lost = self.torn.zip(self.relieved);
        lost.map_or(left, |(torn, relieved)| left - torn[i] - relieved[i])
    }
}

/// Numbers of a cylinder's parts whose fall below zero is an event.
pub const PART_MARGINS: usize = 9;
/// Which of them are a part of the spool's stroke, a flow and a power; the others are pressures.
pub const UNDERLAP_MARGIN: usize = 6;
pub const FLOW_MARGIN: usize = 7;
pub const POWER_MARGIN: usize = 8;

impl<P: Calc> Cylinder<P> {
    /// Areas of bore and annulus, in m², of a bore and a rod in m.
    #[must_use]
    pub fn areas(bore: P, rod: P) -> [P; 2] {
        let quarter = P::constant(std::f64::consts::FRAC_PI_4);
        [
            (quarter * bore * bore).def(&s::A_A),
            (quarter * (bore * bore - rod * rod)).def(&s::A_B),
        ]
    }

    /// Push on the rod, in N.
    #[inline]
    pub fn force<C: Over<P>>(&self, oil: &Oil<C>) -> C {
        oil.chambers[0].times(self.areas[0]) - oil.chambers[1].times(self.areas[1])
    }

    #[inline]
    pub fn flows<C: Over<P>>(&self, oil: &Oil<C>, supply: P) -> Flows<C> {
        self.flows_by(self.parts.as_ref(), oil, supply)
    }

    /// The same with these parts.
    #[inline(always)]
    fn flows_by<C: Over<P>>(&self, parts: Option<&OilParts<P>>, oil: &Oil<C>, supply: P) -> Flows<C> {
        let above = Self::above_tank(parts, oil);
        let mut valve = self.valve.flows(oil.spool, supply, above.ports);
        let mut pressure = C::of(supply);
        if let Some(pump) = parts.and_then(|parts| parts.pump.as_ref()) {
            let asked = self.asked(&above, valve, pressure);
            let [flow, falls] = pump.delivered(&asked);
            (valve[oil.fed()], pressure) = (flow, falls.def(&s::P_S));
        }
        let [a, b] = [valve[0].def(&s::Q_1), valve[1].def(&s::Q_2)];
        let holding = parts.and_then(|parts| parts.load_holding.as_ref());
        let openings = holding.map(|valves| {
            let opening = |i: usize| valves.opening(oil.chambers[i], oil.ports[1 - i]);
            [opening(0).def(&s::Y_LHA), opening(1).def(&s::Y_LHB)]
        });
        let free = [self.free_line(oil, 0), self.free_line(oil, 1)];
        let line = openings.map_or(free, |[a, b]| [checked(free[0], a), checked(free[1], b)]);
        let torn = |i: usize| root(oil.ports[i]).times(self.line).times(self.torn[i]);
        let suction = parts.and_then(|parts| parts.anti_cavitation.as_ref());
        Flows {
            valve: [a, b],
            pump: if oil.fed() == 0 { a } else { b }.def(&s::Q_0),
            supply: pressure,
            line: [line[0].def(&s::Q_LA), line[1].def(&s::Q_LB)],
            openings,
            drawn: suction.map(|valves| {
                let [bore, annulus] = above.chambers.map(|chamber| valves.flow(chamber));
                [bore.def(&s::Q_ACA), annulus.def(&s::Q_ACB)]
            }),
            torn: holding.map(|_| [torn(0).def(&s::Q_B1), torn(1).def(&s::Q_B2)]),
            relieved: holding.map(|valves| {
                let edge = valves.relieves(oil.spool).times(self.valve.conductance);
                let [a, b] = above.ports.map(|port| edge * root(port));
                [a.def(&s::Q_T1), b.def(&s::Q_T2)]
            }),
            relief: [self.relieves(oil, 0).def(&s::Q_R1), self.relieves(oil, 1).def(&s::Q_R2)],
            leakage: (oil.chambers[0] - oil.chambers[1]).times(self.leakage).def(&s::Q_LEAK),
        }
    }

    /// The same oil with its pressures above that of the tank.
    #[inline(always)]
    fn above_tank<C: Over<P>>(parts: Option<&OilParts<P>>, oil: &Oil<C>) -> Oil<C> {
        match parts.and_then(|parts| parts.tank.as_ref()) {
            None => *oil,
            Some(tank) => Oil {
                ports: tank.above(oil.ports),
                chambers: tank.above(oil.chambers),
                ..*oil
            },
        }
    }

    /// What a line would pass into its chamber without a valve of its own, in m³/s.
    #[inline(always)]
    fn free_line<C: Over<P>>(&self, oil: &Oil<C>, i: usize) -> C {
        root(oil.ports[i] - oil.chambers[i]).times(self.line)
    }

    /// Flow through the relief valve of a port, in m³/s.
    #[inline(always)]
    fn relieves<C: Over<P>>(&self, oil: &Oil<C>, i: usize) -> C {
        relief(oil.ports[i], self.relief[0], self.relief[1])
    }

    /// Rate of the pressure of a port, in Pa/s, by the flow (m³/s) that is left in it.
    #[inline(always)]
    fn port_rate<C: Over<P>>(&self, left: C) -> C {
        left.times(self.bulk_modulus) / C::of(self.port_volume)
    }

    /// What the pump is asked for while the valve passes flows (m³/s) at its full pressure (Pa).
    #[inline]
    fn asked<C: Over<P>>(&self, oil: &Oil<C>, valve: [C; 2], supply: C) -> PumpDemand<C> {
        let edge = self.valve.opening(oil.spool).times(self.valve.conductance);
        let fed = oil.fed();
        PumpDemand {
            flow: valve[fed],
            edge: if fed == 0 { edge } else { -edge },
            port: oil.ports[fed],
            supply,
        }
    }

    /// What falls below zero where a part opens, is fully open, shut or at its limit, of those that are there:
    /// anti-cavitation valves (Pa), load-holding valves that open and that are open (Pa), underlap of the spool, pump by flow
    /// (m³/s) and power (W).
    #[inline]
    pub fn margins<C: Over<P>>(&self, oil: &Oil<C>, supply: P) -> [Option<C>; PART_MARGINS] {
        let Some(parts) = &self.parts else {
            return [None; PART_MARGINS];
        };
        let above = Self::above_tank(Some(parts), oil);
        let suction = parts
            .anti_cavitation
            .map(|valves| above.chambers.map(|p| valves.margin(p)));
        let held = parts.load_holding.map(|valves| {
            let left = |i: usize, full: C| full - valves.excess(oil.chambers[i], oil.ports[1 - i]);
            let (none, full) = (C::constant(0.0), C::of(valves.dp_lh));
            let underlap = valves.underlap(oil.spool);
            [left(0, none), left(1, none), left(0, full), left(1, full), underlap]
        });
        let pump = parts.pump.map(|pump| {
            let valve = self.valve.flows(oil.spool, supply, above.ports);
            pump.margins(&self.asked(&above, valve, C::of(supply)))
        });
        let [suction, pump] = [suction, pump].map(|two| two.map_or([None; 2], |two| two.map(Some)));
        let held = held.map_or([None; 5], |five| five.map(Some));
        [
            suction[0], suction[1], held[0], held[1], held[2], held[3], held[4], pump[0], pump[1],
        ]
    }

    /// Oil in the chambers, in m³, at a length (m).
    #[inline]
    pub fn volumes<C: Over<P>>(&self, length: C) -> [C; 2] {
        let of = C::of;
        let [short, long] = self.lengths;
        let bore = of(self.dead_volume) + (length - of(short)).times(self.areas[0]);
        let annulus = of(self.dead_volume) + (of(long) - length).times(self.areas[1]);
        [bore.def(&s::V_A), annulus.def(&s::V_B)]
    }

    /// Rates of all of the oil's states at a length (m) and speed (m/s, lengthening positive);
    /// `command` in [−1, 1], `supply` in Pa.
    #[inline]
    pub fn rates<C: Over<P>>(&self, oil: &Oil<C>, length: C, speed: C, command: P, supply: P) -> Oil<C> {
        match &self.parts {
            None => self.rates_by(None, oil, [length, speed], command, supply),
            Some(parts) => self.rates_with(parts, oil, [length, speed], command, supply),
        }
    }

    /// With parts. By itself, so that a cylinder without any is none the larger for them, nor the slower.
    #[inline(never)]
    fn rates_with<C: Over<P>>(&self, parts: &OilParts<P>, oil: &Oil<C>, at: [C; 2], command: P, supply: P) -> Oil<C> {
        self.rates_by(Some(parts), oil, at, command, supply)
    }

    #[inline(always)]
    fn rates_by<C: Over<P>>(
        &self,
        parts: Option<&OilParts<P>>,
        oil: &Oil<C>,
        [length, speed]: [C; 2],
        command: P,
        supply: P,
    ) -> Oil<C> {
        let f = self.flows_by(parts, oil, supply);
        let volumes = self.volumes(length);
        let mut into = [f.line[0] - f.leakage, f.line[1] + f.leakage];
        if let Some([bore, annulus]) = f.drawn {
            into = [into[0] + bore, into[1] + annulus];
        }
        let growths = [speed.times(self.areas[0]), speed.times(-self.areas[1])];
        Oil {
            ports: [self.port_rate(f.gains(0)), self.port_rate(f.gains(1))],
            chambers: [
                pressure_rate(self.bulk_modulus, volumes[0], into[0], growths[0]),
                pressure_rate(self.bulk_modulus, volumes[1], into[1], growths[1]),
            ],
            spool: oil.spool_speed,
            spool_speed: self.valve.acceleration(oil.spool, oil.spool_speed, command),
        }
    }
}

impl Cylinder {
    /// Power of the pump, what edges, lines, relief valves and leakage take of it, and what compresses the oil,
    /// all in W, at a speed (m/s, lengthening positive); the rest is the rod's.
    #[must_use]
    pub fn powers(&self, oil: &Oil<f64>, speed: f64, supply: f64) -> [f64; 3] {
        let f = self.flows(oil, supply);
        let (fed, other) = (oil.fed(), 1 - oil.fed());
        let growth = [speed * self.areas[0], -speed * self.areas[1]];
        let gain = [-f.leakage, f.leakage];
        let mut throttles = (f.supply - oil.ports[fed]) * f.pump - oil.ports[other] * f.valve[other];
        throttles += (oil.chambers[0] - oil.chambers[1]) * f.leakage;
        let mut compression = 0.0;
        for i in 0..2 {
            let (port, chamber) = (oil.ports[i], oil.chambers[i]);
            throttles += (port - chamber) * f.line[i] + port * f.relief[i];
            compression += port * f.gains(i);
            compression += chamber * (f.line[i] + gain[i] - growth[i]);
            if let Some((torn, relieved)) = f.torn.zip(f.relieved) {
                throttles += port * (torn[i] + relieved[i]);
            }
            if let Some(drawn) = f.drawn {
                throttles -= chamber * drawn[i];
                compression += chamber * drawn[i];
            }
        }
        [f.supply * f.pump, throttles, compression]
    }
}

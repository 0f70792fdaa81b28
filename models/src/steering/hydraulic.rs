//! Level `hydraulic` of a steered group: its cylinder with oil, ports and valve,
//! the tyres' resistance, and the control loop of the PLC. [Zhang2016, 7, Fig. 8]
//!
//! The pump holds its pressure (load sensing), so that the groups do not act on
//! each other: each is a system of its own with 8 states.

use crate::calc::Calc;
use crate::hydraulics::cylinder::{Cylinder, Oil};
use crate::plane::Point;
use crate::solver::rodas::{Run, Tolerance};
use crate::solver::{Gradient, Halt, System};
use crate::steering::cylinder::Linkage;

/// Angular velocity, in rad/s, below which the resistance is in proportion to it: tyres creep.
pub const CREEP: f64 = 1e-3;

/// One group at work: angle, rate, pressures of ports and chambers, spool and its speed.
#[derive(Clone, Copy, Debug)]
pub struct Group {
    pub linkage: Linkage<f64>,
    pub cylinder: Cylinder,
    /// About the group's axis, in kg·m².
    pub inertia: f64,
    /// Resistance to steering, in N·m.
    pub resistance: f64,
    /// Pressure of the pump, in Pa.
    pub supply: f64,
    /// Command of the valve in [−1, 1]; positive lengthens the cylinder.
    pub command: f64,
}

impl Group {
    /// Equations over any scalar.
    #[inline]
    pub fn equations<C: Calc>(&self, y: &[C; 8]) -> [C; 8] {
        let &[theta, omega, p_a, p_b, a, b, spool, spool_speed] = y;
        let linkage = Linkage {
            c: self.linkage.c.map(C::constant),
            b: self.linkage.b.map(C::constant),
            l_0: C::constant(self.linkage.l_0),
            mirrored: self.linkage.mirrored,
        };
        let (sin, cos) = theta.sin_cos();
        let pose = linkage.at(Point::new(cos, sin));
        let oil = Oil {
            ports: [p_a, p_b],
            chambers: [a, b],
            spool,
            spool_speed,
        };
        let rates = self
            .cylinder
            .rates(&oil, pose.l, pose.od * omega, self.command, self.supply);
        let smooth = (omega.square() + C::constant(CREEP * CREEP)).sqrt();
        let moment = self.cylinder.force(&oil) * pose.od - C::constant(self.resistance) * omega / smooth;
        [
            omega,
            moment / C::constant(self.inertia),
            rates.ports[0],
            rates.ports[1],
            rates.chambers[0],
            rates.chambers[1],
            rates.spool,
            rates.spool_speed,
        ]
    }
}

impl System<8> for Group {
    #[inline]
    fn rates(&self, y: &[f64; 8]) -> Option<[f64; 8]> {
        Some(self.equations(y))
    }

    #[inline]
    fn jacobian(&self, y: &[f64; 8]) -> Option<([f64; 8], [[f64; 8]; 8])> {
        let out = self.equations(&Gradient::states(y));
        Some((out.map(|x| x.re), out.map(|x| x.by)))
    }
}

/// The PLC's control loop of one group: proportional and integral, sampled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Control {
    /// Of the PLC's cycle, in s.
    pub period: f64,
    /// Of the encoder, in rad: it tells whole steps.
    pub resolution: f64,
    /// Command for an error, in 1/rad, and for its integral, in 1/(rad·s).
    pub gains: [f64; 2],
}

/// A group with its loop, from sample to sample.
#[derive(Clone, Copy, Debug)]
pub struct Steered {
    pub group: Group,
    pub control: Control,
    pub run: Run<8>,
    /// Of the error, in rad·s.
    integral: f64,
}

impl Steered {
    /// At rest at an angle (rad), both chambers at a pressure (Pa) without force on the group.
    #[must_use]
    pub fn new(group: Group, control: Control, theta: f64, pressure: f64) -> Steered {
        let [bore, annulus] = group.cylinder.areas;
        let back = pressure * bore / annulus;
        let y = [theta, 0.0, pressure, back, pressure, back, 0.0, 0.0];
        Steered {
            group,
            control,
            run: Run::new(y, control.period / 10.0),
            integral: 0.0,
        }
    }

    /// One cycle of the PLC: reads the encoder, sets the valve for the angle wanted (rad), and moves
    /// on by the period.
    ///
    /// # Errors
    /// As [`Run::advance`].
    pub fn cycle(&mut self, wanted: f64, tolerance: &Tolerance<8>) -> Result<(), Halt> {
        let Control {
            period,
            resolution,
            gains: [proportional, integral],
        } = self.control;
        let seen = (self.run.states()[0] / resolution).round() * resolution;
        let error = wanted - seen;
        let sum = self.integral + error * period;
        let command = proportional * error + integral * sum;
        // The integral waits while the valve is fully open.
        if command.abs() < 1.0 {
            self.integral = sum;
        }
        let sense = if self.group.linkage.mirrored { -1.0 } else { 1.0 };
        self.group.command = sense * command.clamp(-1.0, 1.0);
        self.run.interrupt(period / 10.0);
        self.run.advance(&self.group, tolerance, period, period)
    }
}

//! Level `hydraulic` of a steered group: its cylinder with oil, ports and valve,
//! the tyres' resistance, and the control loop of the PLC. [Zhang2016, 7, Fig. 8]
//!
//! The pump holds its pressure (load sensing), so that the groups do not act on
//! each other: each is a system of its own with 8 states.

use crate::kernel::calc::{Calc, Over};
use crate::kernel::group::quantities;
use crate::parts::hydraulics::cylinder::{Cylinder, Oil};
use crate::parts::plane::Point;
use crate::parts::solver::{Gradient, System};
use crate::steering::cylinder::{Linkage, Pose};
use crate::steering::moving::symbols as s;

/// Angular velocity, in rad/s, below which the resistance is in proportion to it: tyres creep.
pub const CREEP: f64 = 1e-3;

/// Continuous states of a group.
pub const STATES: usize = 8;

/// Event indicators of a group.
pub const INDICATORS: usize = 6;

/// One group at work: angle, rate, pressures of ports and chambers, spool and its speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorkingGroup<P = f64> {
    pub linkage: Linkage<P>,
    pub cylinder: Cylinder<P>,
    /// About the group's axis, in kg·m².
    pub inertia: P,
    /// Resistance to steering, in N·m: tyres and slewing ring.
    pub resistance: P,
    /// Least and greatest angle, in rad, and the end stops' stiffness (N·m/rad) and damping (N·m·s/rad) beyond them.
    pub stops: [P; 2],
    pub buffer: [P; 2],
    /// Pressure of the pump, in Pa.
    pub supply: P,
    /// Command of the valve in [−1, 1]; positive lengthens the cylinder.
    pub command: P,
}

impl WorkingGroup {
    /// At rest at an angle (rad), the chamber of the bore at a pressure (Pa), without force on the group.
    #[must_use]
    pub fn resting(&self, theta: f64, pressure: f64) -> [f64; STATES] {
        let [bore, annulus] = self.cylinder.areas;
        let back = pressure * bore / annulus;
        [theta, 0.0, pressure, back, pressure, back, 0.0, 0.0]
    }

    /// Pressures and spool out of the states.
    #[inline]
    pub fn oil<C: Calc>(y: &[C; STATES]) -> Oil<C> {
        let &[_, _, p_1, p_2, a, b, spool, spool_speed] = y;
        Oil {
            ports: [p_1, p_2],
            chambers: [a, b],
            spool,
            spool_speed,
        }
    }
}

impl<P: Calc> WorkingGroup<P> {
    /// Length and lever arm of the cylinder at an angle (rad).
    #[inline]
    pub fn pose<C: Over<P>>(&self, theta: C) -> Pose<C> {
        let linkage = Linkage {
            c: self.linkage.c.map(C::of),
            b: self.linkage.b.map(C::of),
            l_0: C::of(self.linkage.l_0),
            mirrored: self.linkage.mirrored,
        };
        let (sin, cos) = theta.sin_cos();
        linkage.at(Point::new(cos, sin))
    }

    /// Moment of tyres, slewing ring and end stop on the group, in N·m; positive turns it counter-clockwise.
    #[inline]
    pub fn reaction<C: Over<P>>(&self, theta: C, omega: C) -> C {
        let smooth = (omega.square() + C::constant(CREEP * CREEP)).sqrt();
        let tyres = C::of(-self.resistance) * omega / smooth;
        let [low, high] = self.stops;
        let depth = if theta.value() < low.value() {
            theta - C::of(low)
        } else if theta.value() > high.value() {
            theta - C::of(high)
        } else {
            return tyres;
        };
        let [stiffness, damping] = self.buffer;
        let push = C::of(-stiffness) * depth - C::of(damping) * omega;
        // A stop pushes, and never pulls.
        if push.value() * depth.value() < 0.0 {
            tyres + push
        } else {
            tyres
        }
    }

    /// Equations over any scalar.
    #[inline]
    pub fn equations<C: Over<P>>(&self, y: &[C; STATES]) -> [C; STATES] {
        let [theta, omega, ..] = *y;
        let oil = WorkingGroup::oil(y);
        let pose = self.pose(theta);
        let rates = self
            .cylinder
            .rates(&oil, pose.l, pose.od * omega, self.command, self.supply);
        let moment = self.cylinder.force(&oil) * pose.od + self.reaction(theta, omega);
        [
            omega,
            moment / C::of(self.inertia),
            rates.ports[0],
            rates.ports[1],
            rates.chambers[0],
            rates.chambers[1],
            rates.spool,
            rates.spool_speed,
        ]
    }

    /// Where one falls below zero there is a kink in the rates: both pairs of edges close, both relief
    /// valves open, both end stops are met.
    #[must_use]
    pub fn indicators<C: Over<P>>(&self, y: &[C; STATES]) -> [C; INDICATORS] {
        let &[theta, _, p_1, p_2, _, _, spool, _] = y;
        let (overlap, opening) = (C::of(self.cylinder.valve.overlap), C::of(self.cylinder.relief[0]));
        [
            spool - overlap,
            -spool - overlap,
            opening - p_1,
            opening - p_2,
            theta - C::of(self.stops[0]),
            C::of(self.stops[1]) - theta,
        ]
    }

    /// Flow from the pump through the valve, in m³/s.
    #[must_use]
    pub fn demand<C: Over<P>>(&self, y: &[C; STATES]) -> C {
        let oil = WorkingGroup::oil(y);
        let [a, b] = self.cylinder.valve.flows(oil.spool, self.supply, oil.ports);
        if oil.spool.value() >= 0.0 { a } else { b }
    }
}

impl System<STATES> for WorkingGroup {
    #[inline]
    fn rates(&self, y: &[f64; STATES]) -> Option<[f64; STATES]> {
        Some(self.equations(y))
    }

    #[inline]
    fn jacobian(&self, y: &[f64; STATES]) -> Option<([f64; STATES], [[f64; STATES]; STATES])> {
        let out = self.equations(&Gradient::states(y));
        Some((out.map(|x| x.re), out.map(|x| x.by)))
    }

    #[inline]
    fn least(&self, y: &[f64; STATES]) -> f64 {
        WorkingGroup::oil(y).least().1
    }
}

/// The PLC's control loop of one group: proportional and integral, sampled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Control {
    /// Of the PLC's cycle, in s.
    pub period: f64,
    /// Of the encoder, in rad: it tells whole steps; with zero every angle.
    pub resolution: f64,
    /// Command for an error, in 1/rad, and for its integral, in 1/(rad·s).
    pub gains: [f64; 2],
    /// Greatest command by amount, up to 1.
    pub limit: f64,
}

quantities! {
    /// What the PLC holds of a group from one sample to the next: integral of the error, in rad·s, and the valve's command.
    Sampled { integral: INTEGRAL, command: U_V }
}

impl Control {
    /// One sample: reads the encoder at an angle (rad) and sets the valve for the angle wanted (rad);
    /// `mirrored` where the cylinder shortens for a positive angle.
    #[must_use]
    pub fn sample(&self, held: &Sampled<f64>, wanted: f64, theta: f64, mirrored: bool) -> Sampled<f64> {
        let seen = match self.resolution {
            0.0 => theta,
            step => (theta / step).round() * step,
        };
        let error = wanted - seen;
        let sum = held.integral + error * self.period;
        let command = self.gains[0] * error + self.gains[1] * sum;
        let sense = if mirrored { -1.0 } else { 1.0 };
        Sampled {
            // The integral waits while the command is at its limit.
            integral: if command.abs() < self.limit { sum } else { held.integral },
            command: sense * command.clamp(-self.limit, self.limit),
        }
    }
}

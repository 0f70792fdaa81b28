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
        let smooth = (omega.square() + C::known(&s::OMEGA_C, CREEP).square()).sqrt();
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
        let speed = (pose.od * omega).def(&s::V_C);
        let rates = self.cylinder.rates(&oil, pose.l, speed, self.command, self.supply);
        let (force, reaction) = (self.cylinder.force(&oil), self.reaction(theta, omega));
        let moment = force.def(&s::F_C) * pose.od + reaction.def(&s::M_R);
        [
            omega,
            (moment / C::of(self.inertia)).def(&s::D_OMEGA_G),
            rates.ports[0].def(&s::D_P_1),
            rates.ports[1].def(&s::D_P_2),
            rates.chambers[0].def(&s::D_P_A),
            rates.chambers[1].def(&s::D_P_B),
            rates.spool,
            rates.spool_speed.def(&s::D_V_V),
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
pub struct Control<P = f64> {
    /// Of the PLC's cycle, in s.
    pub period: P,
    /// Of the encoder, in rad: it tells whole steps; with zero every angle.
    pub resolution: P,
    /// Command for an error, in 1/rad, and for its integral, in 1/(rad·s).
    pub gains: [P; 2],
    /// Greatest command by amount, up to 1.
    pub limit: P,
}

quantities! {
    /// What the PLC holds of a group from one sample to the next: integral of the error, in rad·s, and the valve's command.
    Sampled { integral: I_E, command: U_V }
}

impl<P: Calc> Control<P> {
    /// Sum of the errors (rad·s) and command that follow from the sum held, the angle wanted (rad), the angle (rad) and
    /// the encoder's whole steps in it; `mirrored` where the cylinder shortens for a positive angle.
    pub fn asked(&self, held: P, wanted: P, [theta, steps]: [P; 2], mirrored: bool) -> [P; 2] {
        let seen = match self.resolution.value() {
            0.0 => theta,
            _ => steps * self.resolution,
        };
        let error = (wanted - seen.def(&s::THETA_E)).def(&s::E_E);
        let sum = (held + error * self.period).def(&s::I_N);
        let command = (self.gains[0] * error + self.gains[1] * sum).def(&s::U_F);
        let limited = match command.value() {
            asked if asked > self.limit.value() => self.limit,
            asked if asked < -self.limit.value() => -self.limit,
            _ => command,
        };
        let told = if mirrored { -limited } else { limited };
        // The sum waits while the command is at its limit.
        let free = command.value().abs() < self.limit.value();
        [if free { sum } else { held }, told.def(&s::U_N)]
    }
}

impl Control {
    /// Whole steps of the encoder at an angle, in rad; none where it tells every angle.
    #[must_use]
    pub fn steps(&self, theta: f64) -> f64 {
        match self.resolution {
            0.0 => 0.0,
            step => (theta / step).round(),
        }
    }

    /// One sample: reads the encoder at an angle (rad) and sets the valve for the angle wanted (rad);
    /// `mirrored` where the cylinder shortens for a positive angle.
    #[must_use]
    pub fn sample(&self, held: &Sampled<f64>, wanted: f64, theta: f64, mirrored: bool) -> Sampled<f64> {
        let [integral, command] = self.asked(held.integral, wanted, [theta, self.steps(theta)], mirrored);
        Sampled { integral, command }
    }
}

//! Level `hydraulic`: the driven bar moved by a cylinder with its oil, ports
//! and proportional valve; with 8 states, or with 10 where the load swings.

use crate::calc::{Calc, Over};
use crate::hydraulics::cylinder::{Cylinder, Oil};
use crate::lemniscate::dynamics::{Coordinate, Dynamics, Phase, Reel};
use crate::lemniscate::moving::symbols as s;
use crate::lemniscate::symbols as g;
use crate::solver::{Gradient, MOST_KINKS, System};

/// Angular velocity, in rad/s, below which dry friction is in proportion to it.
pub const CREEP: f64 = 1e-4;

/// What counts as much at a kink: parts of the spool's stroke and of a relief valve's opening pressure, and a
/// way into an end stop in rad. Times the tolerance, a step ends as near to it.
const GAP: f64 = 0.1;
const CRACK: f64 = 0.03;
const TOUCH: f64 = 1e-3;

/// States of the oil, the last ones of the system's.
const OIL: usize = 6;

/// A luffing cylinder at work, as a system of N states: angle and rate of the driven bar, with
/// N = 10 also those of the rope, pressures of ports and chambers, spool and its speed.
#[derive(Clone, Copy, Debug)]
pub struct Hydraulic<const N: usize, P = f64> {
    pub dynamics: Dynamics<P>,
    pub cylinder: Cylinder<P>,
    /// Friction at the driven bar, in N·m·s/rad, and dry, in N·m; below [`CREEP`] the bar creeps.
    pub viscous: P,
    pub coulomb: P,
    /// Least and greatest angle of the driven bar, in rad, and the end stops' stiffness (N·m/rad) and
    /// damping (N·m·s/rad) beyond them.
    pub stops: [f64; 2],
    pub buffer: [P; 2],
    /// Command of the valve in [−1, 1]; positive raises the driven bar.
    pub command: P,
    /// Pressure of the pump, in Pa.
    pub supply: P,
}

impl<const N: usize, P: Calc> Hydraulic<N, P> {
    pub fn phase<C: Calc>(y: &[C; N]) -> Phase<C> {
        let still = C::constant(0.0);
        let swings = N > OIL + 2;
        Phase {
            theta: y[0],
            omega: y[1],
            swing: if swings { y[2] } else { still },
            swing_rate: if swings { y[3] } else { still },
        }
    }

    pub fn oil<C: Calc>(y: &[C; N]) -> Oil<C> {
        let oil = &y[N - OIL..];
        Oil {
            ports: [oil[0], oil[1]],
            chambers: [oil[2], oil[3]],
            spool: oil[4],
            spool_speed: oil[5],
        }
    }

    /// Equations over any scalar.
    #[inline]
    pub fn equations<C: Coordinate<P>>(&self, y: &[C; N]) -> Option<[C; N]> {
        let m = Self::phase(y);
        let oil = Self::oil(y);
        let r = C::reduced(&self.dynamics, m.theta)?;
        let [length, arm] = r.drive;
        let rates = self
            .cylinder
            .rates(&oil, length, (arm * m.omega).def(&g::V_D), self.command, self.supply);
        let moment = self.cylinder.force(&oil).def(&s::F_C) * arm + self.reaction(&m);
        let still = C::constant(0.0);
        let reel = Reel {
            length: self.dynamics.bodies().pendulum.map_or(still, |p| C::of(p.length)),
            rate: still,
        };
        let [alpha, swing] = self.dynamics.motion(&r, &m, moment, reel);
        let mut out = [C::constant(0.0); N];
        out[0] = m.omega;
        out[1] = alpha;
        if N > OIL + 2 {
            out[2] = m.swing_rate;
            out[3] = swing;
        }
        let oil = [
            rates.ports[0].def(&s::D_P_1),
            rates.ports[1].def(&s::D_P_2),
            rates.chambers[0].def(&s::D_P_A),
            rates.chambers[1].def(&s::D_P_B),
            rates.spool,
            rates.spool_speed.def(&s::D_V_V),
        ];
        out[N - OIL..].copy_from_slice(&oil);
        Some(out)
    }

    /// Moment of friction and end stop on the driven bar, in N·m; positive turns it counter-clockwise.
    #[inline]
    pub fn reaction<C: Over<P>>(&self, m: &Phase<C>) -> C {
        let mut moment = -m.omega.times(self.viscous);
        if self.coulomb.value() > 0.0 {
            let smooth = (m.omega.square() + C::known(&s::OMEGA_C, CREEP).square()).sqrt();
            moment -= m.omega.times(self.coulomb) / smooth;
        }
        if let Some(depth) = self.beyond(m.theta) {
            let [stiffness, damping] = self.buffer;
            let push = -C::of(stiffness) * depth - C::of(damping) * m.omega;
            // A stop pushes, and never pulls.
            if push.value() * depth.value() < 0.0 {
                moment += push;
            }
        }
        moment.def(&s::M_R)
    }

    /// How far the bar is beyond its range, in rad.
    fn beyond<C: Calc>(&self, theta: C) -> Option<C> {
        let nearest = theta.value().clamp(self.stops[0], self.stops[1]);
        let name = if nearest == self.stops[0] { &g::FROM } else { &g::TO };
        (theta.value() != nearest).then(|| theta - C::known(name, nearest))
    }
}

impl<const N: usize> Hydraulic<N> {
    /// The crane at rest at an angle (rad), the valve closed and the oil carrying it, both chambers at
    /// `least` (Pa) or more. `None` where the linkage does not close or the cylinder cannot hold it.
    #[must_use]
    pub fn resting(&self, theta: f64, least: f64) -> Option<[f64; N]> {
        let r = f64::reduced(&self.dynamics, theta)?;
        let still = Phase {
            theta,
            omega: 0.0,
            swing: 0.0,
            swing_rate: 0.0,
        };
        let length = self.dynamics.bodies().pendulum.map_or(0.0, |p| p.length);
        let [moment, _] = self.dynamics.hold(&r, &still, Reel { length, rate: 0.0 });
        let [bore, annulus] = self.cylinder.areas;
        let force = moment / r.drive[1];
        let back = least.max((least * bore - force) / annulus);
        let push = (force + annulus * back) / bore;
        if !push.is_finite() {
            return None;
        }
        let mut y = [0.0; N];
        y[0] = theta;
        y[N - OIL..N - 2].copy_from_slice(&[push, back, push, back]);
        Some(y)
    }
}

impl<const N: usize> System<N> for Hydraulic<N> {
    #[inline]
    fn rates(&self, y: &[f64; N]) -> Option<[f64; N]> {
        self.equations(y)
    }

    #[inline]
    fn jacobian(&self, y: &[f64; N]) -> Option<([f64; N], [[f64; N]; N])> {
        let out = self.equations(&Gradient::states(y))?;
        Some((out.map(|x| x.re), out.map(|x| x.by)))
    }

    #[inline]
    fn kinks(&self, y: &[f64; N]) -> [f64; MOST_KINKS] {
        let opening = self.cylinder.relief[0];
        let over = |port: f64| (port / opening - 1.0) / CRACK;
        let oil = &y[N - OIL..];
        [
            oil[4] / GAP,
            over(oil[0]),
            over(oil[1]),
            (y[0] - self.stops[0]) / TOUCH,
            (self.stops[1] - y[0]) / TOUCH,
        ]
    }
}

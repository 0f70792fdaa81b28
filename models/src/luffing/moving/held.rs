//! Oil that holds a crane at rest.

use nalgebra::{Vector2, Vector3};

use crate::luffing::moving::dynamics::Coordinate;
use crate::luffing::moving::hydraulic::{Crane, FIXED, Hydraulic, put};
use crate::luffing::moving::motion;
use crate::luffing::moving::pendulum::{Phase, Reel};
use crate::luffing::moving::reduced::Reduced;
use crate::luffing::moving::space;

impl<const N: usize> Hydraulic<N> {
    /// The crane at rest at an angle (rad), its load hanging, the valve closed and the oil carrying it, both
    /// chambers at `least` (Pa) or more. `None` where the linkage does not close or the cylinder cannot hold it.
    #[must_use]
    pub fn resting(&self, theta: f64, least: f64) -> Option<[f64; N]> {
        let length = self.dynamics().pendulum().map_or(0.0, |p| p.length);
        let mut y = [0.0; N];
        y[0] = theta;
        if N > FIXED {
            match &self.crane {
                Crane::Plane(_) => put(&mut y, &motion::MotionState::resting(theta, length).y),
                Crane::Slewing(_) => put(&mut y, &space::SlewingState::resting(theta, length).y),
            }
        }
        let pressures = self.carrying(&y, least)?;
        y[2..6].copy_from_slice(&pressures);
        Some(y)
    }

    /// Pressures of ports and chambers with which the oil carries a crane that stands still in these states, both chambers at
    /// `least` (Pa) or more; `None` where the linkage does not close or the cylinder cannot hold it.
    pub(crate) fn carrying(&self, y: &[f64; N], least: f64) -> Option<[f64; 4]> {
        let r = f64::reduced(self.dynamics(), y[0])?;
        let [bore, annulus] = self.cylinder.areas;
        let force = self.holding(&r, y) / r.drive[1];
        let back = least.max((least * bore - force) / annulus);
        let push = (force + annulus * back) / bore;
        if !push.is_finite() {
            return None;
        }
        // Load-holding valves keep the oil from the ports, which the valve's middle relieves.
        let parts = self.cylinder.parts;
        let ports = match parts.and_then(|parts| parts.load_holding) {
            Some(_) => [parts.and_then(|parts| parts.tank).map_or(0.0, |tank| tank.p_tank); 2],
            None => [push, back],
        };
        Some([ports[0], ports[1], push, back])
    }

    /// Moment on the driven bar that holds it (N·m), the load straight below the head, or on a slope under a crane that slews as it
    /// hangs there.
    fn holding(&self, r: &Reduced<f64>, y: &[f64; N]) -> f64 {
        let dynamics = self.dynamics();
        let load = dynamics.pendulum();
        let psi = if N > FIXED { y[FIXED] } else { 0.0 };
        let Some([lifts, _]) = dynamics.leaned(r, psi) else {
            let still = Phase {
                theta: y[0],
                omega: 0.0,
                swing: 0.0,
                swing_rate: 0.0,
            };
            return dynamics.hold(r, &still, Reel::still(load.map_or(0.0, |load| load.length)))[0];
        };
        let pulled = load.map_or(0.0, |load| {
            let along = Vector3::from_column_slice(&y[FIXED + 2..FIXED + 5]).normalize();
            let pull = load.mass * dynamics.gravity_at(psi).dot(&along);
            pull * r.arm(along.xy().dot(&Vector2::new(r.head[1].x, r.head[1].y)))
        });
        r.moment - lifts - pulled
    }
}

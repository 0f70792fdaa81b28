//! A mechanism in motion: its driven bar as a coordinate of its own, with the
//! inertia of all bodies, and the load as a pendulum on its rope.
//!
//! Nothing here is derived by hand from the mechanism, which gives its reduced inertia, the change of it and the moment
//! of its weights. [virtual work; Lagrange]

use crate::kernel::calc::Calc;
use crate::luffing::moving::bodies::Pendulum;
use crate::luffing::moving::dynamics::{Coordinate, Dynamics};
use crate::luffing::moving::reduced::Reduced;
use crate::luffing::moving::symbols as s;
use crate::parts::plane::{Point, dot, squared};
use crate::parts::solver::runge_kutta;

/// Angles in rad and their rates in rad/s: where the mechanism is and how it moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Phase<C = f64> {
    /// Angle of the driven bar.
    pub theta: C,
    pub omega: C,
    /// Rope from the vertical, forward positive; stays as it is without a pendulum.
    pub swing: C,
    pub swing_rate: C,
}

/// The rope: its length (m), how fast it is paid out (m/s), and how that changes (m/s²) where it does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reel<C> {
    pub length: C,
    pub rate: C,
    pub gain: Option<C>,
}

impl<C: Calc> Reel<C> {
    /// At rest.
    #[must_use]
    pub fn still(length: C) -> Reel<C> {
        Reel {
            length,
            rate: C::constant(0.0),
            gain: None,
        }
    }

    /// An acceleration towards the head (m/s²) less what the hoist gives way.
    pub(crate) fn less_gain(&self, inward: C) -> C {
        self.gain.map_or(inward, |gain| inward - gain)
    }
}

/// The pendulum's part of the equations of motion: the terms that it adds to the inertia of the driven bar (kg·m²) and
/// couples it with, how the bar couples back, its own inertia, and the moments on both (N·m). The rope's equation, with
/// `back`, `inertia` and the second moment, is multiplied by the mass that [cancels](Pendulum::cancelling).
struct Swing<C> {
    own: C,
    coupled: C,
    back: C,
    inertia: C,
    forces: [C; 2],
}

impl<P: Calc> Dynamics<P> {
    /// The pendulum's part of the equations of motion, for the coordinates (theta, swing).
    fn swing<C: Coordinate<P>>(&self, r: &Reduced<C>, m: &Phase<C>, load: &Pendulum<P>, reel: Reel<C>) -> Swing<C> {
        let [_, d, dd] = r.head;
        let (sin, cos) = m.swing.sin_cos();
        // Directions of the load's motion when the rope swings, and of its centripetal acceleration.
        let (swing, inward) = (Point::new(cos, sin), Point::new(-sin, cos));
        let (mass, gravity, l) = (C::of(load.mass), C::of(self.gravity()), reel.length);
        let any = C::of(load.cancelling());
        let mut pull = reel.less_gain(l * m.swing_rate.square());
        let coriolis = (C::constant(2.0) * reel.rate * m.swing_rate).def(&s::A_C);
        let square = m.omega.square();
        let forward = dot(d, swing).def(&s::D_PHI);
        let mut along = dot(d, inward).def(&s::D_N);
        let (mut bend, change) = (dot(d, dd).def(&s::Q_A), dot(dd, swing).def(&s::DD_PHI));
        let (mut travel, mut rise) = (squared(d), d.y);
        if let Some([lead, further]) = r.lead {
            travel += lead * (lead - C::constant(2.0) * along);
            bend = (bend - lead * dot(dd, inward)).def(&s::Q_L);
            pull = (pull - further * square).def(&s::A_L);
            rise = (rise - lead * cos).def(&s::DH_R);
            along = (along - lead).def(&s::D_L);
        }
        let mut work = bend * square + along * pull + forward * coriolis + gravity * rise;
        let mut across = change * square + coriolis + gravity * sin;
        if let Some([lift, push]) = self.outer_along(r, m, &reel) {
            (work, across) = (work - lift, across - push.def(&s::A_OUT));
        }
        let work = work.def(&s::W_1);
        let (own, coupled) = ((mass * travel).def(&s::M_11), (mass * l * forward).def(&s::M_12));
        Swing {
            own,
            coupled,
            back: if any == mass {
                coupled
            } else {
                (any * l * forward).def(&s::M_21)
            },
            inertia: (any * l.square()).def(&s::M_22),
            forces: [(-mass * work).def(&s::TAU_1), (-any * l * across).def(&s::TAU_2)],
        }
    }

    /// Accelerations of the driven bar and of the rope (rad/s²) under a moment on the driven bar
    /// (N·m, positive raises it), with what the mechanism is at this angle.
    #[inline]
    pub fn motion<C: Coordinate<P>>(&self, r: &Reduced<C>, m: &Phase<C>, moment: C, reel: Reel<C>) -> [C; 2] {
        let driven = (moment - r.moment - C::constant(0.5) * r.slope * m.omega.square()).def(&s::M_NET);
        let Some(load) = self.pendulum() else {
            return [(driven / r.inertia).def(self.names().acceleration), C::constant(0.0)];
        };
        let swing = self.swing(r, m, load, reel);
        let (m_12, m_21, m_22, [f_1, f_2]) = (swing.coupled, swing.back, swing.inertia, swing.forces);
        // M q″ = f.
        let (m_11, f_1) = (r.inertia + swing.own, (driven + f_1).def(&s::TAU_M));
        let determinant = m_11 * m_22 - m_12 * m_21;
        [
            ((f_1 * m_22 - m_12 * f_2) / determinant).def(self.names().acceleration),
            ((m_11 * f_2 - m_21 * f_1) / determinant).def(&s::D_OMEGA_R),
        ]
    }

    /// Moment on the driven bar (N·m) that keeps it at rest, and the acceleration of the rope (rad/s²) with it.
    #[must_use]
    pub fn hold<C: Coordinate<P>>(&self, r: &Reduced<C>, m: &Phase<C>, reel: Reel<C>) -> [C; 2] {
        let Some(load) = self.pendulum() else {
            return [r.moment, C::constant(0.0)];
        };
        let swing = self.swing(r, m, load, reel);
        let (m_22, [f_1, f_2]) = (swing.inertia, swing.forces);
        [
            r.moment - f_1 + swing.coupled * f_2 / m_22,
            (f_2 / m_22).def(&s::D_OMEGA_R),
        ]
    }
}

impl Dynamics {
    /// How much the rope's rate changes, over how much the driven bar's does, in a blow on the driven bar.
    #[must_use]
    pub fn blow(&self, r: &Reduced<f64>, m: &Phase, reel: Reel<f64>) -> f64 {
        self.pendulum().map_or(0.0, |load| {
            let swing = self.swing(r, m, load, reel);
            -swing.back / swing.inertia
        })
    }

    /// Inertia at the driven bar at an angle (rad) in kg·m², the load as if it were fixed to the head;
    /// `None` where the linkage does not close.
    #[must_use]
    pub fn inertia(&self, theta: f64) -> Option<f64> {
        let r = f64::reduced(self, theta)?;
        let load = self.pendulum().map_or(0.0, |p| p.mass);
        Some(r.inertia + load * r.head[1].norm_squared())
    }

    /// The same at any angle, on a rope of constant length; `None` where the linkage does not close.
    #[must_use]
    pub fn accelerations(&self, m: &Phase, moment: f64) -> Option<[f64; 2]> {
        let r = f64::reduced(self, m.theta)?;
        let length = self.pendulum().map_or(0.0, |p| p.length);
        let rate = r.paid(0.0, m.omega);
        let gain = None;
        Some(self.motion(&r, m, moment, Reel { length, rate, gain }))
    }

    /// Kinetic and potential energy, in J; `None` where the linkage does not close.
    #[must_use]
    pub fn energy(&self, m: &Phase) -> Option<f64> {
        let r = f64::reduced(self, m.theta)?;
        let bars = 0.5 * r.inertia * m.omega * m.omega + r.energy;
        let Some(&Pendulum { mass, length, .. }) = self.pendulum() else {
            return Some(bars);
        };
        let [a, d, _] = r.head;
        let (sin, cos) = Calc::sin_cos(m.swing);
        let along = Point::new(sin, -cos) * r.paid(0.0, m.omega);
        let velocity = d * m.omega + Point::new(cos, sin) * (length * m.swing_rate) + along;
        let place = a + Point::new(sin, -cos) * length;
        Some(bars + mass * (0.5 * velocity.norm_squared() + self.potential(place)))
    }

    /// A step of `h` s of the classical Runge-Kutta method under a constant moment (N·m); `None` where the linkage opens.
    #[must_use]
    pub fn step(&self, m: &Phase, moment: f64, h: f64) -> Option<Phase> {
        let phase = |&[theta, omega, swing, swing_rate]: &[f64; 4]| Phase {
            theta,
            omega,
            swing,
            swing_rate,
        };
        let start = [m.theta, m.omega, m.swing, m.swing_rate];
        let end = runge_kutta::step(&start, h, |y| {
            let [alpha, swing] = self.accelerations(&phase(y), moment)?;
            Some([y[1], alpha, y[3], swing])
        })?;
        Some(phase(&end))
    }
}

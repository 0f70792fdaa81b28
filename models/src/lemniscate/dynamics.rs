//! The mechanism in motion: its driven bar as a coordinate of its own, with the
//! inertia of all bodies, and the load as a pendulum on its rope.
//!
//! Nothing here is derived by hand from the mechanism: positions are run with
//! second-order dual numbers, and reduced inertia, its change and the moment of
//! the weights follow from their derivatives. [virtual work; Lagrange]

use num_dual::Dual2_64;

use crate::calc::Calc;
use crate::lemniscate::geometry::{Driven, Geometry};
use crate::lemniscate::position::Position;
use crate::plane::Point;

/// A body that moves with one of the bars.
#[derive(Clone, Copy, Debug)]
pub struct Body {
    /// In kg.
    pub mass: f64,
    /// About the centre of gravity, in kg·m².
    pub inertia: f64,
    /// Centre of gravity from the bar's first joint, along the bar and to its left, in m.
    pub centre: Point<f64>,
}

impl Body {
    /// A uniform bar of a mass (kg) from one point to another, both in the frame of its bar, in m.
    #[must_use]
    pub fn uniform(mass: f64, from: Point<f64>, to: Point<f64>) -> Body {
        Body {
            mass,
            inertia: mass * (to - from).norm_squared() / 12.0,
            centre: (from + to) / 2.0,
        }
    }
}

/// The load on its rope: a pendulum in the plane of the mechanism.
#[derive(Clone, Copy, Debug)]
pub struct Pendulum {
    /// In kg.
    pub mass: f64,
    /// Length of the rope, in m.
    pub length: f64,
}

/// Bodies that the mechanism moves.
#[derive(Clone, Copy, Debug)]
pub struct Bodies {
    pub boom: Body,
    pub jib: Body,
    pub rocker: Body,
    pub pendulum: Option<Pendulum>,
    /// In m/s².
    pub gravity: f64,
}

/// Angles in rad and their rates in rad/s: where the mechanism is and how it moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Phase {
    /// Angle of the driven bar.
    pub theta: f64,
    pub omega: f64,
    /// Rope from the vertical, forward positive; stays as it is without a pendulum.
    pub swing: f64,
    pub swing_rate: f64,
}

/// What the equations of motion need at one angle, all by derivatives of the positions.
#[derive(Clone, Copy, Debug)]
struct Reduced {
    /// Inertia of boom, jib and rocker at the driven bar (kg·m²), and its change by the angle.
    inertia: f64,
    slope: f64,
    /// Moment of their weights, in N·m; positive lowers the driven bar.
    moment: f64,
    /// Height of their centres of gravity times their weights, in J.
    energy: f64,
    /// Head A: place, first and second derivative by the angle, in m.
    head: [Point<f64>; 3],
}

impl Reduced {
    fn new(g: &Geometry<Dual2_64>, bodies: &Bodies, theta: f64) -> Option<Reduced> {
        let p = Position::new(g, Dual2_64::new(theta, 1.0, 0.0))?;
        let foot = g.lengths.o3();
        let (mut inertia, mut slope, mut moment, mut energy) = (0.0, 0.0, 0.0, 0.0);
        let bars = [
            (&bodies.boom, Point::zeros().map(Dual2_64::from_re), p.x_1),
            (&bodies.jib, p.b, p.x_2),
            (&bodies.rocker, foot, p.x_3),
        ];
        for (body, joint, bar) in bars {
            let [_, d, dd] = parts(bar);
            let square = square_length(bar);
            let (along, across) = (body.centre.x / square.sqrt(), body.centre.y / square.sqrt());
            let turned = |v: Point<f64>| Point::new(along * v.x - across * v.y, across * v.x + along * v.y);
            let [j, dj, ddj] = parts(joint);
            let (r, dr, ddr) = (j + turned(parts(bar)[0]), dj + turned(d), ddj + turned(dd));
            // A bar of constant length turns by phi: |d| = length · phi', and d · d″ = length² · phi' phi″.
            let (turn, turn_change) = (d.norm_squared() / square, d.dot(&dd) / square);
            inertia += body.mass * dr.norm_squared() + body.inertia * turn;
            slope += 2.0 * (body.mass * dr.dot(&ddr) + body.inertia * turn_change);
            moment += body.mass * bodies.gravity * dr.y;
            energy += body.mass * bodies.gravity * r.y;
        }
        Some(Reduced {
            inertia,
            slope,
            moment,
            energy,
            head: parts(p.a),
        })
    }
}

/// Value, first and second derivative.
fn parts(v: Point<Dual2_64>) -> [Point<f64>; 3] {
    [v.map(|x| x.re), v.map(|x| x.v1), v.map(|x| x.v2)]
}

/// Square of a bar's length, in m².
fn square_length(v: Point<Dual2_64>) -> f64 {
    v.x.re * v.x.re + v.y.re * v.y.re
}

/// The mechanism with its bodies.
#[derive(Clone, Copy, Debug)]
pub struct Dynamics {
    geometry: Geometry<Dual2_64>,
    bodies: Bodies,
}

impl Dynamics {
    #[must_use]
    pub fn new(geometry: &Geometry<f64>, bodies: Bodies) -> Dynamics {
        Dynamics {
            geometry: geometry.map(Dual2_64::from_re),
            bodies,
        }
    }

    #[must_use]
    pub fn driven(&self) -> Driven {
        self.geometry.driven
    }

    /// Accelerations of the driven bar and of the rope (rad/s²) under a moment on the driven bar
    /// (N·m, positive raises it); `None` where the linkage does not close.
    #[must_use]
    pub fn accelerations(&self, m: &Phase, moment: f64) -> Option<[f64; 2]> {
        let r = Reduced::new(&self.geometry, &self.bodies, m.theta)?;
        let driven = moment - r.moment - 0.5 * r.slope * m.omega * m.omega;
        let Some(Pendulum { mass, length }) = self.bodies.pendulum else {
            return Some([driven / r.inertia, 0.0]);
        };
        let [_, d, dd] = r.head;
        let (sin, cos) = Calc::sin_cos(m.swing);
        // Directions of the load's motion when the rope swings, and of its centripetal acceleration.
        let (swing, inward) = (Point::new(cos, sin), Point::new(-sin, cos));
        let gravity = self.bodies.gravity;
        // M q″ = f for the coordinates (theta, swing).
        let coupled = mass * length * d.dot(&swing);
        let m_11 = r.inertia + mass * d.norm_squared();
        let m_22 = mass * length * length;
        let pull = length * m.swing_rate * m.swing_rate;
        let f_1 = driven - mass * (d.dot(&dd) * m.omega * m.omega + d.dot(&inward) * pull + gravity * d.y);
        let f_2 = -mass * length * (dd.dot(&swing) * m.omega * m.omega + gravity * sin);
        let determinant = m_11 * m_22 - coupled * coupled;
        Some([
            (f_1 * m_22 - coupled * f_2) / determinant,
            (m_11 * f_2 - coupled * f_1) / determinant,
        ])
    }

    /// Kinetic and potential energy, in J; `None` where the linkage does not close.
    #[must_use]
    pub fn energy(&self, m: &Phase) -> Option<f64> {
        let r = Reduced::new(&self.geometry, &self.bodies, m.theta)?;
        let bars = 0.5 * r.inertia * m.omega * m.omega + r.energy;
        let Some(Pendulum { mass, length }) = self.bodies.pendulum else {
            return Some(bars);
        };
        let [a, d, _] = r.head;
        let (sin, cos) = Calc::sin_cos(m.swing);
        let velocity = d * m.omega + Point::new(cos, sin) * (length * m.swing_rate);
        let height = a.y - length * cos;
        Some(bars + mass * (0.5 * velocity.norm_squared() + self.bodies.gravity * height))
    }

    /// One step of the classical Runge-Kutta method of fourth order, of `h` s, under a constant
    /// moment (N·m); `None` where the linkage does not close on the way.
    #[must_use]
    pub fn step(&self, m: &Phase, moment: f64, h: f64) -> Option<Phase> {
        let rate = |m: &Phase| {
            let [alpha, swing] = self.accelerations(m, moment)?;
            Some([m.omega, alpha, m.swing_rate, swing])
        };
        let moved = |rate: &[f64; 4], h: f64| Phase {
            theta: m.theta + h * rate[0],
            omega: m.omega + h * rate[1],
            swing: m.swing + h * rate[2],
            swing_rate: m.swing_rate + h * rate[3],
        };
        let k_1 = rate(m)?;
        let k_2 = rate(&moved(&k_1, h / 2.0))?;
        let k_3 = rate(&moved(&k_2, h / 2.0))?;
        let k_4 = rate(&moved(&k_3, h))?;
        let mean = std::array::from_fn(|i| (k_1[i] + 2.0 * (k_2[i] + k_3[i]) + k_4[i]) / 6.0);
        Some(moved(&mean, h))
    }
}

//! A controller: proportional and integral, its set point on a ramp, its moment limited. As a PLC runs it, it reads place and
//! speed of an axis at every multiple of its cycle; until the next one its moment holds. It follows a commanded speed, or goes
//! to a commanded place at a speed from which it can stop there. Without a cycle it is [`continuous`], by the same law.

use crate::kernel::calc::Calc;
use crate::kernel::group::{One, by_map};
use crate::kernel::number::short;
use crate::kernel::symbol::Symbol;

pub mod continuous;
pub mod reading;

/// A controlled axis: what its quantities are called.
#[derive(Debug)]
pub struct DriveAxis {
    /// K_p and K_i, cycle, ramp of the set point, greatest moment.
    pub settings: [&'static Symbol; 5],
    /// Speed asked for over the distance that is left, and the greatest one: of an axis whose place is commanded.
    pub approach: [&'static Symbol; 2],
    /// Of speed and of place.
    pub commands: [&'static Symbol; 2],
    /// Set point, integral part and moment, from one sample to the next.
    pub held: [&'static Symbol; 3],
    /// What a sample finds: distance that is left, speed asked for, set point, error, moment asked for, integral part, moment.
    pub sample: [&'static Symbol; 7],
    /// The moment of its drive.
    pub drive: &'static Symbol,
    /// A positive moment turns it backwards.
    pub reversed: bool,
    /// What it is without a cycle, its speed or its place commanded.
    pub continuous: [&'static ContinuousAxis; 2],
}

/// What the quantities of a continuous controller are called.
#[derive(Debug, PartialEq)]
pub struct ContinuousAxis {
    /// Set point, and integral of the error.
    pub states: [&'static Symbol; 2],
    /// Command to which the set point goes and its rate, which way it goes there or how it follows, and how the limit has the
    /// moment.
    pub past: [&'static Symbol; 4],
    /// Error, and moment asked for.
    pub law: [&'static Symbol; 2],
}

/// What a controller is set to.
#[derive(Clone, Copy, Debug)]
pub struct SpeedControl<C = f64> {
    pub axis: &'static DriveAxis,
    /// Moment over the error of the speed and over the integral of it; in N·m·s and N·m of an axis that turns.
    gains: [C; 2],
    /// From sample to sample, in s; none of one that is continuous.
    cycle: Option<C>,
    /// Greatest acceleration of the set point.
    ramp: C,
    /// Greatest moment by amount, in N·m.
    limit: C,
    /// Where its place is commanded: speed over distance (1/s), and greatest speed.
    approach: Option<[C; 2]>,
}

/// What it holds from one sample to the next.
#[derive(Clone, Copy, Debug)]
pub struct Latched<C = f64> {
    pub axis: &'static DriveAxis,
    pub set: C,
    pub integral: C,
    pub moment: C,
}

impl<C: Copy> SpeedControl<C> {
    /// The same over another scalar.
    pub fn map<D>(&self, f: &mut dyn FnMut(&'static Symbol, C) -> D) -> SpeedControl<D> {
        let [k_p, k_i, t_c, a, m_max] = self.axis.settings;
        let [first, second] = self.axis.approach;
        SpeedControl {
            axis: self.axis,
            gains: [f(k_p, self.gains[0]), f(k_i, self.gains[1])],
            cycle: self.cycle.map(|cycle| f(t_c, cycle)),
            ramp: f(a, self.ramp),
            limit: f(m_max, self.limit),
            approach: self.approach.map(|[k, most]| [f(first, k), f(second, most)]),
        }
    }
}

impl<C: Copy> Latched<C> {
    /// The same over another scalar.
    pub fn map<D>(&self, f: &mut dyn FnMut(&'static Symbol, C) -> D) -> Latched<D> {
        let [set, integral, moment] = self.axis.held;
        Latched {
            axis: self.axis,
            set: f(set, self.set),
            integral: f(integral, self.integral),
            moment: f(moment, self.moment),
        }
    }
}

by_map!(SpeedControl: 7);
by_map!(Latched: 3);

/// A number no further from zero than a limit, which is not negative.
fn limited<C: Calc>(x: C, limit: C) -> C {
    match x.value() {
        over if over > limit.value() => limit,
        under if under < -limit.value() => -limit,
        _ => x,
    }
}

/// Whether a moment that is asked for grows with an error (anti-windup by clamping: beyond the limit the integral then waits).
fn pushes(asked: f64, error: f64) -> bool {
    (asked > 0.0) == (error > 0.0)
}

impl<C: Calc> SpeedControl<C> {
    /// e = v_s − v, turned round where a positive moment turns the axis backwards.
    fn error(&self, set: C, speed: C) -> C {
        if self.axis.reversed { speed - set } else { set - speed }
    }

    /// K_p e + M_i, in N·m.
    fn asked(&self, error: C, integral: C) -> C {
        self.gains[0] * error + integral
    }

    /// v_w = sgn(e_x) min(K_x |e_x|, √(2 a |e_x|), v_max): the speed at which to go to a place.
    fn wanted(&self, [k, most]: [C; 2], commanded: C, place: C) -> C {
        let [left, wanted, ..] = self.axis.sample;
        let left = (commanded - place).def(left);
        let far = left.abs();
        let near = limited(k * far, most);
        let stops = (C::constant(2.0) * self.ramp * far).sqrt();
        let speed = if stops.value() < near.value() { stops } else { near };
        (if left.value() < 0.0 { -speed } else { speed }).def(wanted)
    }

    /// v_n = v_s ± a T_c towards v_c, e = v_n − v, M_n = K_p e + M_i within ±M_max; M_i grows by K_i T_c e unless the moment is
    /// at its limit and the error asks for more (anti-windup by clamping).
    ///
    /// # Panics
    /// For a controller that is continuous.
    pub fn sample(&self, held: &Latched<C>, commanded: &One<C>, [place, speed]: [C; 2]) -> Latched<C> {
        let cycle = self.cycle.expect("it is sampled");
        let commanded = match self.approach {
            Some(approach) => self.wanted(approach, commanded.1, place),
            None => commanded.1,
        };
        let [_, _, set_n, e_n, m_a, m_in, m_n] = self.axis.sample;
        let most = self.ramp * cycle;
        let set = match (commanded - held.set).value() {
            rise if rise > most.value() => held.set + most,
            fall if fall < -most.value() => held.set - most,
            _ => commanded,
        };
        let set = set.def(set_n);
        let error = self.error(set, speed).def(e_n);
        let asked = self.asked(error, held.integral).def(m_a);
        let beyond = asked.value().abs() > self.limit.value();
        let winds = beyond && pushes(asked.value(), error.value());
        let grown = || (held.integral + self.gains[1] * cycle * error).def(m_in);
        Latched {
            axis: self.axis,
            set,
            integral: if winds { held.integral } else { grown() },
            moment: limited(asked, self.limit).def(m_n),
        }
    }

    /// What is wrong, and what to do, where a speed swings up under its samples: eigenvalues of z² − (2 − p) z + 1 − p + q beyond
    /// the unit circle, where p = K_p T_c/J and q = K_i T_c²/J, with moment over acceleration J. Without samples none does.
    #[must_use]
    pub fn swings_up(&self, inertia: f64) -> Option<[String; 2]> {
        let cycle = self.cycle?;
        let [p, q] = self.gains.map(|gain| (gain * cycle).value() / inertia);
        let q = q * cycle.value();
        if q < p && 2.0 * p - q < 4.0 {
            return None;
        }
        let [k_p, k_i, t_c, ..] = self.axis.settings;
        Some([
            format!(
                "samples every {} under which a speed swings up",
                t_c.written(cycle.value())
            ),
            format!(
                "give a shorter cycle, or other gains: stable is {i} {t} < {p} with 2 {p} {t} < 4 J + {i} {t}^2, where J = {} in \
                 SI units is the moment over the acceleration that it gives",
                short(inertia),
                i = k_i.id,
                p = k_p.id,
                t = t_c.id,
            ),
        ])
    }

    /// ω_0 = √(K_i/J) in rad/s, ζ = (K_p + c)/(2 √(K_i J)) of a rigid shaft with viscous friction (N·m·s), as the cycle goes to
    /// zero: J ω̇ = K_p e + K_i ∫e dt − c ω.
    pub fn vibration(&self, inertia: C, friction: C, [omega_0, zeta]: [&'static Symbol; 2]) -> [C; 2] {
        let [proportional, integral] = self.gains;
        let frequency = (integral / inertia).sqrt().def(omega_0);
        let damping = (proportional + friction) / (C::constant(2.0) * (integral * inertia).sqrt());
        [frequency, damping.def(zeta)]
    }
}

/// Ids of what a model takes for granted of controllers.
pub fn taken<'a>(controls: impl Iterator<Item = &'a SpeedControl> + Clone) -> impl Iterator<Item = &'static str> {
    let all = || controls.clone();
    let first = all().find_map(|control| control.cycle).map(|_| "control");
    let continuous = all().find(|control| control.cycle.is_none());
    let continuous = continuous.map(|_| "control_continuous");
    let to_place = controls
        .clone()
        .find_map(|control| control.approach)
        .map(|_| "control_to_place");
    first.into_iter().chain(continuous).chain(to_place)
}

impl Latched {
    /// With a set point and no moment yet.
    #[must_use]
    pub fn steady(control: &SpeedControl, set: f64) -> Latched {
        Latched {
            axis: control.axis,
            set,
            integral: 0.0,
            moment: 0.0,
        }
    }
}

impl SpeedControl {
    /// From sample to sample, in s; `None` of one that is continuous.
    #[must_use]
    pub fn cycle(&self) -> Option<f64> {
        self.cycle
    }

    /// The integral of the error that gives a moment (N·m) at no error.
    #[must_use]
    pub fn integrated(&self, moment: f64) -> f64 {
        moment / self.gains[1]
    }

    /// Greatest moment by amount, in N·m.
    #[must_use]
    pub fn limit(&self) -> f64 {
        self.limit
    }
}

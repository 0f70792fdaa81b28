//! A speed controller as a PLC runs it: proportional and integral, sampled, its set point on a ramp, its moment limited. At
//! every multiple of its cycle it reads the speed; until the next one its moment holds.

use crate::kernel::calc::Calc;
use crate::kernel::symbol::Symbol;

/// What a controller is set to.
#[derive(Clone, Copy, Debug)]
pub struct SpeedControl<C> {
    /// Moment over the error of the speed, in N·m·s, and over the integral of it, in N·m.
    pub gains: [C; 2],
    /// From sample to sample, in s.
    pub cycle: C,
    /// Greatest acceleration of the set point, in rad/s².
    pub ramp: C,
    /// Greatest moment by amount, in N·m.
    pub limit: C,
}

/// What it holds from one sample to the next: set point (rad/s), integral part and moment (N·m).
#[derive(Clone, Copy, Debug)]
pub struct Latch<C> {
    pub set: C,
    pub integral: C,
    pub moment: C,
}

/// Names of what a sample finds.
#[derive(Debug)]
pub struct SampleNames {
    pub set: &'static Symbol,
    pub error: &'static Symbol,
    pub asked: &'static Symbol,
    pub integral: &'static Symbol,
    pub moment: &'static Symbol,
}

/// A number no further from zero than a limit, which is not negative.
fn limited<C: Calc>(x: C, limit: C) -> C {
    match x.value() {
        over if over > limit.value() => limit,
        under if under < -limit.value() => -limit,
        _ => x,
    }
}

impl<C: Calc> SpeedControl<C> {
    /// ω_n = ω_s ± a T_c towards ω_c, e = ω_n − ω, M_n = K_p e + M_i within ±M_max; M_i grows by K_i T_c e unless the
    /// moment is at its limit and the error asks for more (anti-windup by clamping).
    pub fn sample(&self, held: Latch<C>, commanded: C, speed: C, names: &SampleNames) -> Latch<C> {
        let most = self.ramp * self.cycle;
        let set = match (commanded - held.set).value() {
            rise if rise > most.value() => held.set + most,
            fall if fall < -most.value() => held.set - most,
            _ => commanded,
        };
        let set = set.def(names.set);
        let error = (set - speed).def(names.error);
        let [proportional, integral] = self.gains;
        let asked = (proportional * error + held.integral).def(names.asked);
        let beyond = asked.value().abs() > self.limit.value();
        let winds = beyond && (asked.value() > 0.0) == (error.value() > 0.0);
        let grown = || (held.integral + integral * self.cycle * error).def(names.integral);
        Latch {
            set,
            integral: if winds { held.integral } else { grown() },
            moment: limited(asked, self.limit).def(names.moment),
        }
    }

    /// Whether a shaft of an inertia (kg·m²) comes to rest under its samples: eigenvalues of z² − (2 − p) z + 1 − p + q
    /// within the unit circle, where p = K_p T_c/J and q = K_i T_c²/J.
    pub fn is_stable(&self, inertia: C) -> bool {
        let [p, q] = self.gains.map(|gain| (gain * self.cycle / inertia).value());
        let q = q * self.cycle.value();
        q < p && 2.0 * p - q < 4.0
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

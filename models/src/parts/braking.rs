//! Brakes that stop a shaft one after another, under torques that stay as they are.

use crate::kernel::calc::Calc;

/// A shaft when the last brake begins to act that stops it.
#[derive(Clone, Copy, Debug)]
pub struct LastBrake<C> {
    /// Since all were called, in s; its turn (rad) and speed (rad/s) then.
    pub time: C,
    pub turned: C,
    pub speed: C,
    /// Torque against it from then on, in N·m.
    pub torque: C,
}

impl<C: Calc> LastBrake<C> {
    /// Of a speed (rad/s) and an inertia (kg·m²), against which a torque is (N·m), and brakes by torque (N·m) and delay (s).
    /// ω̇ = −(T_0 + Σ T_b) / J, each brake after its delay. [Ports001, 5.7]
    pub fn new(inertia: C, against: C, speed: C, brakes: impl Iterator<Item = [C; 2]>) -> LastBrake<C> {
        let (zero, half) = (C::constant(0.0), C::constant(0.5));
        let mut last = LastBrake {
            time: zero,
            turned: zero,
            speed,
            torque: against,
        };
        for [more, delay] in brakes {
            let (span, slows) = (delay - last.time, last.torque / inertia);
            if slows.value() * span.value() >= last.speed.value() {
                break;
            }
            last.turned += last.speed * span - half * slows * span.square();
            last.speed -= slows * span;
            last.time = delay;
            last.torque += more;
        }
        last
    }
}

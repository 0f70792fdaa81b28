//! What travel on rails asks for, of a motor, and of a stop.

use crate::kernel::calc::Calc;

/// Slower, in m/s, it stands: a speed that is summed from accelerations ends at rest but for its rounding.
const STANDS: f64 = 1e-9;

/// Which way a trolley goes, or starts to go: forward (1), backward (−1), or it stands (0).
#[must_use]
pub fn sense(v: f64, a: f64) -> f64 {
    match [v, a] {
        [v, _] if v.abs() > STANDS => v.signum(),
        [_, a] if a != 0.0 => a.signum(),
        _ => 0.0,
    }
}

/// Sum (N) of wheels, wind and sheaves, which are against the travel, and of a force that accelerates forward, positive forward,
/// of a trolley that goes one way or stands. [Ports001, 7.5]
pub fn along<C: Calc>([wheels, wind, sheaves, inertia]: [C; 4], sense: f64) -> C {
    match sense {
        s if s > 0.0 => wheels + wind + sheaves + inertia,
        s if s < 0.0 => inertia - wheels - wind - sheaves,
        _ => inertia.over(wheels).over(wind).over(sheaves),
    }
}

/// What a weight on ropes loses at the sheaves that they pass as the trolley travels, in N: W(1 − η^n). [Ports001, 7.5]
pub fn passed<C: Calc>(weight: C, efficiency: C, sheaves: u8) -> C {
    weight * (C::constant(1.0) - efficiency.power([sheaves, 1]))
}

/// Power of a motor, in W, for that behind it: losses are added where it drives, taken off where it brakes.
pub fn at_motor<C: Calc>(power: C, efficiency: C) -> C {
    if power.value() < 0.0 {
        power * efficiency
    } else {
        power / efficiency
    }
}

/// Time (s) and way (m) of a stop from a speed (m/s) at a deceleration (m/s²): v/a, v²/(2a).
pub fn stopped<C: Calc>(speed: C, rate: C) -> [C; 2] {
    [speed / rate, speed.square() / rate.scaled(2.0)]
}

//! Small sway of both bodies by the derivatives of their motion, against the closed form.

use num_dual::Dual64;

use crate::bridge::bodies::motion::{SlungRates, SlungTurning};
use crate::bridge::bodies::posture::{SlungLoad, SlungPosture};
use crate::bridge::given::{BridgeTrolley, TrolleyCommand};
use crate::bridge::slung::{LoadSlings, Slung};
use crate::bridge::suspension::{FourRopes, Suspended};
use crate::kernel::calc::Calc;
use crate::kernel::group::One;

/// Squares of both frequencies, from the sum and the product of those of the motion's own rates about rest, against the closed form:
/// the greater relative difference.
pub(in crate::bridge) fn small_sway(
    slings: &LoadSlings<f64>,
    unit: &BridgeTrolley<f64>,
    ropes: &FourRopes<f64>,
    load: f64,
    length: f64,
    gravity: &One<f64>,
) -> Option<f64> {
    let known = |_, value: f64| Dual64::constant(value);
    let rest = Dual64::constant(0.0);
    let (slings, unit, ropes) = (
        slings.map(&mut { known }),
        unit.map(&mut { known }),
        ropes.map(&mut { known }),
    );
    let (gravity, length) = (One(gravity.0, Dual64::constant(**gravity)), Dual64::constant(length));
    let command = TrolleyCommand {
        a: rest,
        v_h: rest,
        q: Dual64::constant(load),
    };
    let hanging = Suspended::new(&ropes, &gravity, &length).ok()?;
    let slung = Slung::new(&slings, &unit, &command, &ropes, &gravity, &hanging).ok()?;
    let column = |phi: f64, psi: f64| {
        let load = SlungLoad {
            phi: Dual64::new(0.0, phi),
            psi: Dual64::new(0.0, psi),
            w_phi: rest,
            w_psi: rest,
            l: length,
        };
        let posture = SlungPosture::new(&load, &slings, &ropes, &hanging).ok()?;
        let turning = SlungTurning::new(&load, &slings, &command, &slung, &posture);
        let rates = SlungRates::new(&load, &slings, &command, &gravity, &slung, &posture, &turning, &rest);
        Some(rates.turning().map(|rate| -rate.eps))
    };
    let [[a, c], [b, d]] = [column(1.0, 0.0)?, column(0.0, 1.0)?];
    let [low, high] = slung.frequency.map(|frequency| frequency.re.square());
    let sum = ((a + d) / (low + high) - 1.0).abs();
    Some(sum.max(((a * d - b * c) / (low * high) - 1.0).abs()))
}

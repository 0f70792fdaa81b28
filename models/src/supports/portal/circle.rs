//! The greatest and the least corner load over the full slewing circle, in closed form.

use std::f64::consts::FRAC_PI_2;

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::parts::plane::Point;
use crate::supports::portal::corners::{PortalCorner, signed};
use crate::supports::portal::load::{Base, SlewingLoad};
use crate::supports::portal::symbols as s;
use crate::supports::portal::weights::StillMoment;

/// PortalCorner loads of the rigid portal as the crane slews: mean of the most loaded corner and amplitude of all, the greatest
/// with its slewing angle (rad), the least on four legs; in N.
#[derive(Clone, Copy, Debug)]
pub struct Circle<C> {
    mean: C,
    amplitude: C,
    greatest: C,
    at: C,
    least: C,
}
results! { Circle as c => {
    N_MEAN: c.mean;
    N_AMP: c.amplitude;
    N_CIR: c.greatest;
    PSI_CIR: c.at;
    N_4_CIR: c.least;
} }

/// The corner that is loaded most: where what does not slew leans to.
pub fn loaded<C: Calc>(still: &StillMoment<C>) -> PortalCorner {
    PortalCorner {
        front: still.moment.y.value() >= 0.0,
        left: still.moment.x.value() >= 0.0,
    }
}

impl<C: Calc> Circle<C> {
    /// N = V/4 + |M_0y|/(2a) + |M_0x|/(2b) + (|M|/2) √(1/a² + 1/b²) at tan ψ = a/b towards the corner; where the leg across
    /// from it is lifted there twice that less V/2; the least is that of the leg across. [Ports001, 7.2]
    pub fn new(base: &Base<C>, still: &StillMoment<C>, slewing: &SlewingLoad<C>) -> Circle<C> {
        let (one, two) = (C::constant(1.0), C::constant(2.0));
        let half = slewing.force / two;
        let along = still.moment.y.abs() / (two * base.a);
        let across = still.moment.x.abs() / (two * base.b);
        let mean = (slewing.force / C::constant(4.0) + along + across).def(&s::N_MEAN);
        let steep = (one / base.a.square() + one / base.b.square()).sqrt();
        let amplitude = (slewing.moment.abs() / two * steep).def(&s::N_AMP);
        let four = mean + amplitude;
        let greatest = if four.value() > half.value() {
            two * four - half
        } else {
            four
        };
        let corner = loaded(still);
        let part = |width: C, positive: bool| signed(C::constant(0.0), slewing.moment / width, positive);
        let at = if slewing.moment.value() == 0.0 {
            C::known(&s::PSI_CIR, 0.0).over(slewing.moment)
        } else {
            C::direction(part(base.a, corner.front), part(base.b, corner.left)).def(&s::PSI_CIR)
        };
        Circle {
            mean,
            amplitude,
            greatest: greatest.def(&s::N_CIR),
            at,
            least: (half - four).def(&s::N_4_CIR),
        }
    }
}

/// The greatest corner load (N) of the hinged portal over the full circle: V (1/2 + p + q cos t) (1/2 + r + u sin t), where
/// its exact derivative by t vanishes, which it does once in a quarter turn.
#[must_use]
pub fn hinged_peak([a, b]: [f64; 2], force: f64, still: Point<f64>, moment: f64) -> f64 {
    let along = (0.5 + still.y.abs() / (force * a), moment.abs() / (force * a));
    let across = (0.5 + still.x.abs() / (force * b), moment.abs() / (force * b));
    let factors = |t: f64| {
        let (sin, cos) = Calc::sin_cos(t);
        (along.0 + along.1 * cos, across.0 + across.1 * sin, sin, cos)
    };
    let rises = |t: f64| {
        let (x, y, sin, cos) = factors(t);
        across.1 * cos * x > along.1 * sin * y
    };
    let (mut low, mut high) = (0.0, FRAC_PI_2);
    loop {
        let middle = f64::midpoint(low, high);
        if middle <= low || middle >= high {
            break;
        }
        if rises(middle) { low = middle } else { high = middle }
    }
    let (x, y, ..) = factors(low);
    force * x * y
}

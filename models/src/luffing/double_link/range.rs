//! The head's rise over the whole working range.

use std::f64::consts::TAU;
use std::num::NonZeroUsize;

use gauss_quad::GaussLegendre;
use num_dual::Dual64;

use crate::component::extreme::greatest_amount;
use crate::luffing::double_link::geometry::Geometry;
use crate::luffing::double_link::leading::{height, rise};
use crate::luffing::double_link::parameters::Parameters;
use crate::luffing::double_link::position::Position;
use crate::luffing::led::reeved::Reeved;
use crate::parts::motion::Motion;

/// Rise of the load, in m: of A, unless its rope is led.
#[derive(Clone, Copy, Debug)]
pub struct Rise {
    /// From the start to the end of the working range.
    pub whole: f64,
    /// For a radian where it is steepest, with its sign: where the luffing moment is greatest.
    pub steepest: f64,
}

impl Rise {
    /// `None` where the linkage does not close over the whole range.
    #[must_use]
    pub fn new(parameters: &Parameters<f64>, led: Option<&Reeved<f64>>, motion: &Motion) -> Option<Rise> {
        let g = Geometry::new(&parameters.map(&mut |_, value| Dual64::from_re(value))).ok()?;
        let led = led.map(|led| led.map(Dual64::from_re));
        let at = |theta: Dual64| Position::new(&g, theta);
        let height = |theta: f64| Some(height(&g, led.as_ref(), &at(Dual64::from_re(theta))?)?.re);
        let mut slope = |theta: Dual64| rise(&g, led.as_ref(), &at(theta)?);
        Some(Rise {
            whole: height(motion.to)? - height(motion.from)?,
            steepest: greatest_amount(motion, &mut slope)?.value,
        })
    }
}

/// Rise of the load over the range as the integral of its slope, in m: the work of the
/// luffing moment for a load of 1 N. By Gauss and Legendre's rule, on halves where
/// they do not agree with the whole; every whole turn is like the first.
#[must_use]
pub fn rise_by_integration(g: &Geometry<f64>, led: Option<&Reeved<f64>>, motion: &Motion) -> f64 {
    let Motion { from, to, .. } = *motion;
    let slope = |theta: f64| {
        Position::new(g, theta)
            .and_then(|p| rise(g, led, &p))
            .unwrap_or(f64::NAN)
    };
    let over = |from: f64, to: f64| {
        let size = g.lengths.x_1 + g.lengths.x_3 + g.lengths.x_4;
        integral(&slope, [from, to], CONVERGED * size * (to - from), &mut { HALVINGS })
    };
    let turns = ((to - from) / TAU).floor();
    if turns == 0.0 {
        return over(from, to);
    }
    turns * over(from, from + TAU) + over((from + turns * TAU).min(to), to)
}

/// How often intervals are halved at most, and what two halves may differ from the whole by, as a part of the way
/// of the longest bars.
const HALVINGS: u32 = 1000;
const CONVERGED: f64 = 1e-13;

fn integral(slope: &impl Fn(f64) -> f64, [from, to]: [f64; 2], tolerance: f64, halvings: &mut u32) -> f64 {
    const POINTS: NonZeroUsize = NonZeroUsize::new(64).expect("not zero");
    let over = |from: f64, to: f64| GaussLegendre::new(POINTS).integrate(from, to, slope);
    let middle = f64::midpoint(from, to);
    let whole = over(from, to);
    let apart = (over(from, middle) + over(middle, to) - whole).abs();
    // Where the linkage does not close there is nothing to converge.
    if apart <= tolerance || apart.is_nan() || *halvings == 0 {
        return whole;
    }
    *halvings -= 1;
    let [low, high] = [[from, middle], [middle, to]].map(|half| integral(slope, half, tolerance, halvings));
    low + high
}

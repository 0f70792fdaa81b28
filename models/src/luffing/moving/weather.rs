//! Wind, slope and a given slewing speed in motion: how they are told, and what the equations of motion have of them.

use std::sync::Arc;

use num_dual::Dual64;

use crate::kernel::calc::Calc;
use crate::luffing::moving::symbols as s;
use crate::luffing::resistances::placed::BARS;
use crate::parts::plane::{self, Point};

/// How the wind blows, the ground lies and the crane is slewed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weather<C = f64> {
    /// Pressure (Pa), and speed (m/s) that adds to it; positive from the rear.
    pub wind: [C; 2],
    /// In rad; positive where the front is lower.
    pub slope: C,
    /// Slewing speed, in 1/s.
    pub slewing: C,
}

impl<C: Calc> Weather<C> {
    /// No wind on level ground, and no slewing.
    pub fn calm() -> Weather<C> {
        let zero = C::constant(0.0);
        Weather {
            wind: [zero; 2],
            slope: zero,
            slewing: zero,
        }
    }

    pub fn is_calm(&self) -> bool {
        [self.wind[0], self.wind[1], self.slope, self.slewing].map(C::value) == [0.0; 4]
    }

    /// The same over another scalar, each with the one in its place.
    pub fn with<B: Calc, D: Calc>(&self, other: &Weather<B>, f: impl Fn(C, B) -> D) -> Weather<D> {
        Weather {
            wind: [0, 1].map(|i| f(self.wind[i], other.wind[i])),
            slope: f(self.slope, other.slope),
            slewing: f(self.slewing, other.slewing),
        }
    }
}

impl Weather {
    /// A time (s) later, where it changes at some rates.
    pub(super) fn later(&self, rates: &Weather, time: f64) -> Weather {
        self.with(rates, |now, rate| now + rate * time)
    }
}

/// Moments of wind and slope for one radian of the coordinate (N·m), positive where they raise it, and what the slope makes of
/// the energy of the weights (J).
#[derive(Clone, Copy, Debug)]
pub struct Outside<C> {
    pub wind: C,
    pub slope: C,
    pub energy: C,
}

/// What acts on the bodies one by one: acceleration by the slope, beside gravity on level ground (m/s²); force of the wind
/// forward (N), and its moment about the mechanism's origin (N·m, clockwise), on each bar and on the counterweight behind them.
#[derive(Clone, Copy, Debug)]
pub struct Pushed<C> {
    pub lean: Point<C>,
    /// What is left of gravity upright to the ground, in m/s².
    pub gravity: C,
    pub wind: Option<[[C; 2]; BARS + 1]>,
}

/// A mechanism as wind and slope meet it, at any value of its coordinate (rad); `None` where it does not close.
pub trait Exposes<P>: Send + Sync {
    fn outside(&self, at: P, weather: &Weather<P>) -> Option<Outside<P>>;

    /// The same of plain quantities, with one more derivative.
    fn with_slope(&self, at: Dual64, weather: &Weather<P>) -> Option<Outside<Dual64>>;

    /// Force and moment of the wind as in [`Pushed`].
    fn pushes(&self, at: P, weather: &Weather<P>) -> Option<[[P; 2]; BARS + 1]>;
}

/// What wind and slope meet in motion, and what blows and leans there.
#[derive(Clone)]
pub struct Outdoors<P> {
    pub to: Arc<dyn Exposes<P>>,
    pub weather: Weather<P>,
    /// Acceleration by the slope, in m/s².
    pub lean: Point<P>,
    /// What is left of gravity upright to the ground, in m/s².
    gravity: P,
}

impl<P: Calc> Outdoors<P> {
    /// Under gravity in m/s²; a_σx = g sin σ, a_σy = g (1 − cos σ), g_σ = g cos σ.
    pub fn new(to: Arc<dyn Exposes<P>>, weather: Weather<P>, gravity: P) -> Outdoors<P> {
        let (sin, cos) = weather.slope.sin_cos();
        let lean = [gravity * sin, gravity * (P::constant(1.0) - cos)];
        Outdoors {
            to,
            weather,
            lean: plane::def(lean.into(), [&s::A_SLOPE_X, &s::A_SLOPE_Y]),
            gravity: (gravity * cos).def(&s::G_SLOPE),
        }
    }

    /// What acts on the bodies one by one at a coordinate (rad); `None` where the mechanism does not close.
    pub fn pushed(&self, at: P) -> Option<Pushed<P>> {
        Some(Pushed {
            lean: self.lean,
            gravity: self.gravity,
            wind: Some(self.to.pushes(at, &self.weather)?),
        })
    }
}

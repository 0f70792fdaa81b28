//! What follows from the dimensions of the crane alone.

use std::f64::consts::TAU;

use crate::kernel::calc::Calc;
use crate::luffing::double_link::misfit::Misfit;
use crate::luffing::double_link::parameters::{Driven, Jib, Lengths, Parameters};
use crate::luffing::double_link::symbols as s;
use crate::parts::four_bar::{FourBar, Names};
use crate::parts::motion::Motion;
use crate::parts::plane::Point;

/// The mechanism at no particular position.
#[derive(Clone, Copy, Debug)]
pub struct Geometry<C> {
    pub lengths: Lengths<C>,
    pub driven: Driven,
    pub linkage: FourBar<C>,
    /// Angle of the jib at B, in rad. [Li2022, eq. 6]
    pub beta_0: C,
    /// Front arm in terms of the rear arm: BA = kappa.x · BC − kappa.y · (BC turned by 90°).
    pub kappa: Point<C>,
    /// Angle from the jib's axis CA to its front arm, in rad. [Li2022, eq. 7]
    pub epsilon_a: C,
}

impl<C: Calc> Geometry<C> {
    pub fn new(p: &Parameters<C>) -> Result<Geometry<C>, Misfit> {
        let Lengths { x_1, x_2, x_3, x_4, .. } = p.lengths;
        let beta_0 = jib_angle(p.jib, x_2, x_4)
            .filter(|angle| angle.value().is_finite())
            .ok_or(Misfit::Jib)?;
        let (sin, cos) = beta_0.sin_cos();
        let kappa = Point::new((x_4 * cos / x_2).def(&s::KAPPA_X), (x_4 * sin / x_2).def(&s::KAPPA_Y));
        // A seen from C, in the frame of the front arm.
        let epsilon_a = C::direction(x_4 - x_2 * cos, x_2 * sin).def(&s::EPSILON_A);
        let o3 = p.lengths.o3();
        if o3.x.value() == 0.0 && o3.y.value() == 0.0 {
            return Err(Misfit::Frame);
        }
        let (bars, frame) = match p.driven {
            Driven::Boom => ([x_1, x_2, x_3], o3),
            Driven::Rocker => ([x_3, x_2, x_1], -o3),
        };
        let linkage = FourBar::new(bars, frame, p.branch, names(p.driven)).ok_or(Misfit::Linkage)?;
        Ok(Geometry {
            lengths: p.lengths,
            driven: p.driven,
            linkage,
            beta_0,
            kappa,
            epsilon_a,
        })
    }
}

impl<C: Calc> Geometry<C> {
    /// The first angle of the driving link (rad) within a range, ends included, at which the linkage has a change point.
    #[must_use]
    pub fn change_point(&self, range: &Motion) -> Option<f64> {
        // A rounding of degrees is not an angle outside.
        const ROUNDING: f64 = 1e-9;
        let first = |point: f64| point + ((range.from - ROUNDING - point) / TAU).ceil() * TAU;
        let points = self.linkage.change_points().map(first);
        points.filter(|at| *at <= range.to + ROUNDING).reduce(f64::min)
    }
}

impl<C: Copy + nalgebra::Scalar> Geometry<C> {
    /// The same geometry over another scalar.
    #[must_use]
    pub fn map<D: nalgebra::Scalar>(&self, f: fn(C) -> D) -> Geometry<D> {
        Geometry {
            lengths: self.lengths.map(&mut |_, value| f(value)),
            driven: self.driven,
            linkage: self.linkage.map(f),
            beta_0: f(self.beta_0),
            kappa: self.kappa.map(f),
            epsilon_a: f(self.epsilon_a),
        }
    }
}

/// Angle of the jib at B. [Li2022, eq. 6]
fn jib_angle<C: Calc>(jib: Jib<C>, x_2: C, x_4: C) -> Option<C> {
    match jib {
        Jib::Angle(beta_0) => Some(beta_0),
        Jib::Sag(x_7) => {
            let within = x_7.value().abs() <= x_2.value().min(x_4.value());
            within.then(|| ((x_7 / x_2).acos() + (x_7 / x_4).acos()).def(&s::BETA_0))
        }
        Jib::Axis(ac) => {
            let within = ac.value() <= (x_2 + x_4).value() && ac.value() >= (x_2 - x_4).value().abs();
            let cosine = (x_2.square() + x_4.square() - ac.square()) / (C::constant(2.0) * x_2 * x_4);
            within.then(|| cosine.acos().def(&s::BETA_0))
        }
    }
}

/// Names of the closure's steps: with the boom driven its diagonal is O3B, with
/// the rocker driven O1C.
#[must_use]
pub fn names(driven: Driven) -> &'static Names {
    match driven {
        Driven::Boom => &BOOM,
        Driven::Rocker => &ROCKER,
    }
}

static BOOM: Names = Names {
    frame: &s::X_56,
    frame_angle: &s::THETA_56,
    stretched: [&s::THETA_S, &s::THETA_S2],
    folded: [&s::THETA_F, &s::THETA_F2],
    crank: [&s::B_X, &s::B_Y],
    diagonal: [&s::L_X, &s::L_Y],
    diagonal_length: &s::L,
    stretched_margin: &s::SIGMA_S,
    folded_margin: &s::SIGMA_F,
    area: &s::K,
    follower: [&s::X_3X, &s::X_3Y],
    coupler: [&s::X_2X, &s::X_2Y],
};

static ROCKER: Names = Names {
    crank: [&s::X_3X, &s::X_3Y],
    diagonal: [&s::Y_X, &s::Y_Y],
    diagonal_length: &s::Y,
    follower: [&s::B_X, &s::B_Y],
    coupler: [&s::X_2RX, &s::X_2RY],
    ..BOOM
};

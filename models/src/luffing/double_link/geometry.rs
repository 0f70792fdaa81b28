//! Dimensions of the crane, and what follows from them alone.

use std::f64::consts::TAU;

use crate::balance::scene::Form;
use crate::kernel::calc::Calc;
use crate::kernel::group::{group, quantities};
use crate::kernel::number::short;
use crate::kernel::symbol::Symbol;
use crate::luffing::double_link::symbols as s;
use crate::parts::four_bar::{Branch, FourBar, Names};
use crate::parts::motion::Motion;
use crate::parts::plane::{self, Point};

/// What the scene has chosen.
#[derive(Clone, Copy, Debug)]
pub struct Choice {
    pub driven: Driven,
    pub branch: Branch,
    /// Working range of the driven bar.
    pub range: Motion,
    /// Whether finite forces in the pins carry load and weights all over it.
    pub pins: bool,
}
group!(Choice);

/// Which bar the drive turns; its angle is the coordinate of the mechanism.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Driven {
    Boom,
    Rocker,
}

impl Driven {
    /// Angle of the driven bar, the coordinate of the mechanism.
    #[must_use]
    pub fn coordinate(self) -> &'static Symbol {
        match self {
            Driven::Boom => &s::THETA_1,
            Driven::Rocker => &s::THETA_3,
        }
    }

    /// Angular velocity of the driven bar.
    #[must_use]
    pub fn rate(self) -> &'static Symbol {
        match self {
            Driven::Boom => &s::OMEGA_1,
            Driven::Rocker => &s::OMEGA_3,
        }
    }
}

quantities! {
    /// Lengths of the linkage, in m. `x_5`, `x_6` and `x_8` may be zero or negative.
    Lengths { x_1: X_1, x_2: X_2, x_3: X_3, x_4: X_4, x_5: X_5, x_6: X_6, x_8: X_8 }
}

impl<C: Calc> Lengths<C> {
    /// Foot of the rocker, O1 being the origin. [Li2022, Fig. 2]
    #[inline]
    pub fn o3(&self) -> Point<C> {
        Point::new(-self.x_5, self.x_6)
    }
}

quantities! {
    /// Own weights (N) and their centres of gravity (m from the bar's first
    /// joint, rad counter-clockwise from the bar).
    Weights { g_1: G_1, s_1: S_1, chi_1: CHI_1, g_2: G_2, s_2: S_2, chi_2: CHI_2, g_3: G_3, s_3: S_3, chi_3: CHI_3 }
}

quantities! {
    /// Anchors of a drive that pushes along a line from the frame to the driven bar.
    Anchors { e_x: E_X, e_y: E_Y, s_d: S_D, chi_d: CHI_D }
}

quantities! {
    /// Bore and rod of a luffing cylinder, in m.
    Bore { d_c: D_C, d_r: D_R }
}

/// What determines the jib's triangle besides its two arms.
#[derive(Clone, Copy, Debug)]
pub enum Jib<C> {
    /// Sag X_7 (m): B below the line CA; negative where B lies above.
    Sag(C),
    /// Angle beta_0 at B (rad), counter-clockwise from BA to BC, in (0, 2π).
    Angle(C),
    /// Distance AC (m), with B below the line CA.
    Axis(C),
}

/// Everything that is constant in a scene.
#[derive(Clone, Copy, Debug)]
pub struct Parameters<C> {
    pub lengths: Lengths<C>,
    pub jib: Jib<C>,
    pub weights: Option<Weights<C>>,
    pub anchors: Option<Anchors<C>>,
    pub cylinder: Option<Bore<C>>,
    pub balance: Option<Form<C>>,
    pub driven: Driven,
    pub branch: Branch,
}

impl<C: Copy> Parameters<C> {
    /// The same parameters over another scalar.
    pub fn map<D>(&self, f: &mut dyn FnMut(&'static Symbol, C) -> D) -> Parameters<D> {
        Parameters {
            lengths: self.lengths.map(f),
            jib: match self.jib {
                Jib::Sag(x) => Jib::Sag(f(&s::X_7, x)),
                Jib::Angle(x) => Jib::Angle(f(&s::BETA_0, x)),
                Jib::Axis(x) => Jib::Axis(f(&s::AC, x)),
            },
            weights: self.weights.map(|part| part.map(f)),
            anchors: self.anchors.map(|part| part.map(f)),
            cylinder: self.cylinder.map(|part| part.map(f)),
            balance: self.balance.map(|part| part.map(f)),
            driven: self.driven,
            branch: self.branch,
        }
    }
}

impl<C: Calc> Parameters<C> {
    /// The same parameters as plain numbers.
    #[must_use]
    pub fn values(&self) -> Parameters<f64> {
        self.map(&mut |_, value| value.value())
    }
}

/// A misfit in words.
#[derive(Clone, Debug)]
pub struct Words {
    /// The quantity to blame.
    pub key: &'static str,
    pub what: String,
    /// What is allowed.
    pub help: String,
}

impl Parameters<f64> {
    /// Why there is no mechanism with these parameters, with values and allowed ranges.
    #[must_use]
    pub fn describe(&self, misfit: Misfit) -> Words {
        let l = &self.lengths;
        match misfit {
            Misfit::Jib => {
                let (key, value, limit) = match self.jib {
                    Jib::Sag(x) => (
                        "X_7",
                        s::X_7.written(x),
                        format!("between -{0} m and {0} m, the shorter arm", short(l.x_2.min(l.x_4))),
                    ),
                    Jib::Axis(x) => (
                        "AC",
                        s::X_7.written(x),
                        format!(
                            "between {} m and {} m, difference and sum of the arms",
                            short((l.x_2 - l.x_4).abs()),
                            short(l.x_2 + l.x_4)
                        ),
                    ),
                    Jib::Angle(x) => ("beta_0", s::BETA_0.written(x), "between 0 and 360 deg".to_owned()),
                };
                Words {
                    key,
                    what: format!("the jib's triangle does not close: {key} = {value}"),
                    help: format!(
                        "with X_2 = {} m and X_4 = {} m it must lie {limit}",
                        short(l.x_2),
                        short(l.x_4)
                    ),
                }
            }
            Misfit::Frame => Words {
                key: "X_5",
                what: "the feet O1 and O3 are one point: boom, jib and rocker turn about it as one body".to_owned(),
                help: "X_5 and X_6 must not both be zero".to_owned(),
            },
            Misfit::Linkage => {
                let frame = plane::length(l.o3());
                let (bar, other) = match self.driven {
                    Driven::Boom => (("X_1", l.x_1), ("X_3", l.x_3)),
                    Driven::Rocker => (("X_3", l.x_3), ("X_1", l.x_1)),
                };
                Words {
                    key: other.0,
                    what: "the linkage closes at no angle of the driven bar".to_owned(),
                    help: format!(
                        "the diagonal opposite this bar lies between {} m and {} m ({} = {} m, distance of the feet {} m), \
                         X_2 and {} reach from {} m to {} m: change the lengths so that the two ranges overlap",
                        short((bar.1 - frame).abs()),
                        short(bar.1 + frame),
                        bar.0,
                        short(bar.1),
                        short(frame),
                        other.0,
                        short((l.x_2 - other.1).abs()),
                        short(l.x_2 + other.1),
                    ),
                }
            }
        }
    }
}

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

/// Why there is no such mechanism.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Misfit {
    /// The jib's triangle does not close.
    Jib,
    /// Both feet are one point.
    Frame,
    /// The linkage closes at no angle.
    Linkage,
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
    /// The first angle of the driven bar (rad) within a range, ends included, at which the linkage has a change point.
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

//! Dimensions of the crane, and what follows from them alone.

use crate::calc::Calc;
use crate::four_bar::{Branch, FourBar, Names};
use crate::lemniscate::symbols as s;
use crate::plane::Point;
use crate::symbol::{Symbol, quantities};

/// Which bar the drive turns; its angle is the coordinate of the mechanism.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Driven {
    Boom,
    Rocker,
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
    Cylinder { d_c: D_C, d_r: D_R }
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
    pub cylinder: Option<Cylinder<C>>,
    pub driven: Driven,
    pub branch: Branch,
}

impl<C: Copy> Parameters<C> {
    /// The same parameters over another scalar.
    pub fn map<D>(&self, mut f: impl FnMut(&'static Symbol, C) -> D) -> Parameters<D> {
        Parameters {
            lengths: self.lengths.map(&mut f),
            jib: match self.jib {
                Jib::Sag(x) => Jib::Sag(f(&s::X_7, x)),
                Jib::Angle(x) => Jib::Angle(f(&s::BETA_0, x)),
                Jib::Axis(x) => Jib::Axis(f(&s::AC, x)),
            },
            weights: self.weights.map(|part| part.map(&mut f)),
            anchors: self.anchors.map(|part| part.map(&mut f)),
            cylinder: self.cylinder.map(|part| part.map(&mut f)),
            driven: self.driven,
            branch: self.branch,
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

//! What is constant in a scene: dimensions, weights, drive, balance, and what the scene has chosen.

use crate::balance::scene::Form;
use crate::drive::mount::{Anchors, Bore};
use crate::kernel::calc::Calc;
use crate::kernel::group::{group, quantities};
use crate::kernel::symbol::Symbol;
use crate::luffing::double_link::symbols as s;
use crate::parts::four_bar::Branch;
use crate::parts::motion::Motion;
use crate::parts::plane::Point;

/// What the scene has chosen.
#[derive(Clone, Copy, Debug)]
pub struct Choice {
    pub driven: Driven,
    pub branch: Branch,
    /// Working range of the driving link.
    pub range: Motion,
    /// Whether finite forces in the pins carry load and weights all over it.
    pub pins: bool,
    /// Side of the line from the centre of the drive's crank to its anchor on the driving link on which crank and rod meet.
    pub crank: Branch,
}
group!(Choice);

/// Which bar the drive turns; its angle is the coordinate of the mechanism.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Driven {
    Boom,
    Rocker,
}

impl Driven {
    /// Angle of the driving link, the coordinate of the mechanism.
    #[must_use]
    pub fn coordinate(self) -> &'static Symbol {
        match self {
            Driven::Boom => &s::THETA_1,
            Driven::Rocker => &s::THETA_3,
        }
    }

    /// Angular velocity of the driving link.
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

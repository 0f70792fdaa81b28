//! Positions: from the angle of the driving link to every joint, angle and the reach.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::luffing::double_link::geometry::{Geometry, names};
use crate::luffing::double_link::parameters::Driven;
use crate::luffing::double_link::symbols as s;
use crate::parts::closure::{Closure, Passing};
use crate::parts::plane::{self, Point};

/// The mechanism at one position; lengths in m.
#[derive(Clone, Copy, Debug)]
pub struct Position<C> {
    pub driven: Driven,
    /// Boom O1–B, rear arm B–C, rocker O3–C, front arm B–A.
    pub x_1: Point<C>,
    pub x_2: Point<C>,
    pub x_3: Point<C>,
    pub x_4: Point<C>,
    /// Joints and head, from O1.
    pub a: Point<C>,
    pub b: Point<C>,
    pub c: Point<C>,
    /// Reach. [Li2022, eq. 8]
    pub r: C,
    /// ±4 × area of the triangle between diagonal, rear arm and driven link.
    pub k: C,
    /// How the linkage passes its change points, if it has any.
    pub passing: Option<Passing>,
    /// Diagonal that the closure went through: O3B or O1C.
    diagonal: C,
    epsilon_a: C,
}

results! { Position as p => {
    THETA_3: p.follower_angle();
    THETA_1: p.follower_angle();
    ALPHA: p.alpha();
    ALPHA_1: p.alpha_1(p.alpha());
    R: p.r;
    A_X: p.a.x;
    A_Y: p.a.y;
    B_X: p.b.x;
    B_Y: p.b.y;
    C_X: p.c.x;
    C_Y: p.c.y;
    L: p.l();
    Y: p.y();
    MU: p.mu();
} }

impl<C: Calc> Position<C> {
    /// The position at `theta` (rad), the angle of the driving link; `None` where
    /// the linkage does not close. [Li2022, eq. 3-8]
    // Inlined where the angle's derivatives are plain: most of what is computed of them is then known.
    #[inline]
    pub fn new(g: &Geometry<C>, theta: C) -> Option<Position<C>> {
        let Closure {
            crank,
            coupler,
            follower,
            diagonal,
            area: k,
            passing,
        } = Closure::new(&g.linkage, theta, names(g.driven))?;
        let (x_1, x_2, x_3) = match g.driven {
            Driven::Boom => (crank, coupler, follower),
            Driven::Rocker => (follower, -coupler, crank),
        };
        let b = x_1;
        let c = plane::def(g.lengths.o3() + x_3, [&s::C_X, &s::C_Y]);
        let x_4 = plane::turned(x_2, g.kappa.x, -g.kappa.y);
        let a = plane::def(b + x_4, [&s::A_X, &s::A_Y]);
        let r = (a.x + g.lengths.x_8).def(&s::R);
        Some(Position {
            driven: g.driven,
            x_1,
            x_2,
            x_3,
            x_4,
            a,
            b,
            c,
            r,
            k,
            passing,
            diagonal,
            epsilon_a: g.epsilon_a,
        })
    }

    /// The same position over another scalar.
    #[must_use]
    pub fn map<D: Calc>(&self, f: fn(C) -> D) -> Position<D> {
        Position {
            driven: self.driven,
            x_1: self.x_1.map(f),
            x_2: self.x_2.map(f),
            x_3: self.x_3.map(f),
            x_4: self.x_4.map(f),
            a: self.a.map(f),
            b: self.b.map(f),
            c: self.c.map(f),
            r: f(self.r),
            k: f(self.k),
            passing: self.passing,
            diagonal: f(self.diagonal),
            epsilon_a: f(self.epsilon_a),
        }
    }

    /// Whether rear arm and driven link lie in one line within rounding.
    #[must_use]
    pub fn is_in_line(&self) -> bool {
        self.k.value().abs() <= 4.0 * f64::EPSILON * plane::dot(self.x_2, self.follower()).value().abs()
    }

    /// Sine of the transmission angle, by amount: what velocities and forces are divided by.
    #[must_use]
    pub fn sine(&self) -> f64 {
        let [coupler, follower] = [self.x_2, self.follower()].map(|bar| bar.map(C::value));
        plane::cross(coupler, follower).abs() / (plane::length(coupler) * plane::length(follower))
    }

    /// Angle of the bar that is not driven: theta_3 or theta_1, in rad. [Li2022, eq. 5]
    pub fn follower_angle(&self) -> C {
        match self.driven {
            Driven::Boom => C::direction(self.x_3.x, self.x_3.y).def(&s::THETA_3),
            Driven::Rocker => C::direction(self.x_1.x, self.x_1.y).def(&s::THETA_1),
        }
    }

    /// Angle of the front arm, in rad. [Li2022, eq. 6]
    pub fn alpha(&self) -> C {
        C::direction(self.x_4.x, self.x_4.y).def(&s::ALPHA)
    }

    /// Angle of the jib's axis, in rad, given the front arm's. [Li2022, eq. 7]
    pub fn alpha_1(&self, alpha: C) -> C {
        (alpha - self.epsilon_a).def(&s::ALPHA_1)
    }

    /// Diagonal O3B, in m. [Li2022, eq. 4]
    pub fn l(&self) -> C {
        match self.driven {
            Driven::Boom => self.diagonal,
            Driven::Rocker => plane::length(self.x_3 - self.x_2).def(&s::L),
        }
    }

    /// Diagonal O1C, in m. [Li2022, eq. 4]
    pub fn y(&self) -> C {
        match self.driven {
            Driven::Boom => plane::length(self.c).def(&s::Y),
            Driven::Rocker => self.diagonal,
        }
    }

    /// Transmission angle between rear arm and driven link, 0 to π/2 rad.
    pub fn mu(&self) -> C {
        C::direction(
            plane::dot(self.x_2, self.follower()).abs(),
            (self.k / C::constant(2.0)).abs(),
        )
        .def(&s::MU)
    }

    /// The driven link.
    fn follower(&self) -> Point<C> {
        match self.driven {
            Driven::Boom => self.x_3,
            Driven::Rocker => self.x_1,
        }
    }
}

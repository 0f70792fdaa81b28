//! The steering cylinder: length and lever arm over the angle, stroke. [Zhang2016, 5.1]
//!
//! Straight ahead the cylinder stands at a right angle to its arm o–c and is
//! extended by half its stroke.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::quantities;
use crate::kernel::number::short;
use crate::parts::plane::{self, Point};
use crate::steering::limits::Limits;
use crate::steering::refusal::Refusal;
use crate::steering::symbols as s;

quantities! {
    /// A group's cylinder: arm o–c and its angle from straight ahead, stroke, and
    /// what the cylinder is longer than its stroke when retracted; m and rad.
    Mounting { r: R_C, alpha: ALPHA, l_x: L_X, l_a: L_A }
}

/// A cylinder on its frame, o being the axis of the group.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linkage<C> {
    /// The arm straight ahead.
    pub c: Point<C>,
    /// The cylinder's foot on the frame.
    pub b: Point<C>,
    /// Length straight ahead, in m.
    pub l_0: C,
    /// Whether the cylinder shortens, where it else lengthens, when the group turns counter-clockwise.
    pub mirrored: bool,
}

/// Length and lever arm at one angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose<C> {
    /// Length, in m.
    pub l: C,
    /// Lever arm, in m: dR/dtheta, positive where a push turns counter-clockwise.
    pub od: C,
}
results! { each Pose as p => {
    R: p.l;
    OD: p.od;
} }

impl<C: Calc> Mounting<C> {
    /// Where the cylinder's foot is: straight ahead b–c stands at a right angle to
    /// o–c and is half extended. [Zhang2016, Fig. 5]
    pub fn linkage(&self, mirrored: bool) -> Linkage<C> {
        let l_0 = (self.l_a + C::constant(1.5) * self.l_x).def(&s::L_0);
        let (sin, cos) = self.alpha.sin_cos();
        let c = plane::def(Point::new(self.r * cos, self.r * sin), [&s::C_X, &s::C_Y]);
        let b = plane::def(Point::new(c.x + l_0 * sin, c.y - l_0 * cos), [&s::B_X, &s::B_Y]);
        Linkage { c, b, l_0, mirrored }
    }

    /// What is left of the stroke at a greatest and a smallest length, in m, when
    /// extended and when retracted; negative where it does not suffice. [Zhang2016, 5.1]
    pub fn stroke_margins(&self, longest: C, shortest: C) -> [C; 2] {
        [
            (C::constant(2.0) * self.l_x + self.l_a - longest).def(&s::M_OUT),
            (shortest - self.l_x - self.l_a).def(&s::M_IN),
        ]
    }
}

impl<C: Calc> Linkage<C> {
    /// Length and lever arm at the heading with this cosine and sine. [Zhang2016, Fig. 6]
    #[inline]
    pub fn at(&self, turn: Point<C>) -> Pose<C> {
        let (sin, sense) = if self.mirrored { (-turn.y, -1.0) } else { (turn.y, 1.0) };
        let c = plane::def(plane::turned(self.c, turn.x, sin), [&s::CT_X, &s::CT_Y]);
        let line = Point::new(c.x - self.b.x, c.y - self.b.y);
        let l = plane::length(line).def(&s::R);
        let od = plane::cross(c, line) / l;
        let od = if sense < 0.0 { -od } else { od };
        Pose { l, od: od.def(&s::OD) }
    }

    /// Length and lever arm at a heading, in rad.
    pub fn at_angle(&self, theta: C) -> Pose<C> {
        let (sin, cos) = theta.sin_cos();
        self.at(Point::new(cos, sin))
    }
}

impl<C: Calc> Mounting<C> {
    /// How far the stroke turns the group, in rad. Where a stop would lie beyond a dead
    /// point the range ends there, and [`Linkage::over`] refuses it: it needs a
    /// shorter stroke or a stop of its own.
    #[must_use]
    pub fn ends(&self, mirrored: bool) -> [C; 2] {
        let linkage = self.linkage(mirrored);
        let [low, high] = linkage.dead_points();
        let (back, out) = (self.l_x + self.l_a, C::constant(2.0) * self.l_x + self.l_a);
        let (short, long) = (linkage.angle(back), linkage.angle(out));
        let (min, max) = if mirrored { (long, short) } else { (short, long) };
        [min.unwrap_or(low), max.unwrap_or(high)]
    }
}

impl<C: Calc> Linkage<C> {
    /// The heading, in rad, at a length (m), between the dead points; `None` where
    /// the cylinder is too long or too short for any.
    #[must_use]
    pub fn angle(&self, l: C) -> Option<C> {
        let (r, ob) = (plane::length(self.c), plane::length(self.b));
        // Half the angle at o of the triangle o, b, c, well conditioned throughout.
        let (above, below) = ((l - (ob - r)) * (l + (ob - r)), ((ob + r) - l) * ((ob + r) + l));
        if above.value() < 0.0 || below.value() < 0.0 {
            return None;
        }
        let theta = C::constant(2.0) * C::direction(below.sqrt(), above.sqrt()) - C::direction(r, self.l_0);
        Some(if self.mirrored { -theta } else { theta })
    }

    /// The headings between which the lever arm does not vanish, in rad.
    #[must_use]
    pub fn dead_points(&self) -> [C; 2] {
        let beta = C::direction(plane::length(self.c), self.l_0);
        let half = C::constant(std::f64::consts::PI);
        if self.mirrored {
            [beta - half, beta]
        } else {
            [-beta, half - beta]
        }
    }
}

impl Linkage<f64> {
    /// Longest and shortest length and smallest lever arm (by amount) over a
    /// group's range. Between dead points the length is monotone and the arm falls
    /// to both sides of straight ahead, so that all three are found at the ends.
    pub fn over(&self, limits: &Limits) -> Result<Extremes, Refusal> {
        let [low, high] = self.dead_points();
        if limits.min <= low || limits.max >= high {
            let degrees = |x: f64| short(x.to_degrees());
            return Err(Refusal::new(
                "theta",
                format!(
                    "the cylinder cannot turn its group from {} to {} deg",
                    degrees(limits.min),
                    degrees(limits.max)
                ),
                format!(
                    "with R_c = {} m and l_0 = {} m its dead points are at {} and {} deg: the range must lie between them",
                    short(plane::length(self.c)),
                    short(self.l_0),
                    degrees(low),
                    degrees(high)
                ),
            ));
        }
        let ends = [limits.min, limits.max].map(|theta| self.at_angle(theta));
        let at = usize::from(ends[1].od.abs() < ends[0].od.abs());
        Ok(Extremes {
            longest: ends[0].l.max(ends[1].l),
            shortest: ends[0].l.min(ends[1].l),
            od_min: ends[at].od.abs(),
            od_min_at: [limits.min, limits.max][at],
        })
    }
}

/// Results over a group's range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extremes {
    pub longest: f64,
    pub shortest: f64,
    /// Smallest lever arm, in m, and the heading (rad) where it occurs.
    pub od_min: f64,
    pub od_min_at: f64,
}

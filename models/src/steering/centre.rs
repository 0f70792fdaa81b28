//! The turning centre, and the motion about it.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::parts::plane::{self, Point};
use crate::steering::machine::Machine;
use crate::steering::symbols as s;

/// The turning centre, projectively: it has no singular place, infinity included.
/// Each form is exact where it is used.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Centre<C> {
    /// At infinity: every group rolls along this direction (cosine, sine).
    Far(Point<C>),
    /// A point, in m; forward travel turns about it clockwise or counter-clockwise.
    At { at: Point<C>, clockwise: bool },
    /// `from` + `d`/`w`, at infinity in the direction `d` where `w` is zero.
    Beyond { from: Point<C>, d: Point<C>, w: C },
}

impl<C: Calc> Centre<C> {
    /// Direction in which the point `p` moves when the machine travels forward,
    /// with a length that grows in proportion to its speed; zero on the centre.
    #[inline]
    pub fn rolling(&self, p: Point<C>) -> Point<C> {
        match *self {
            Centre::Far(along) => along,
            Centre::At { at, clockwise: false } => Point::new(at.y - p.y, p.x - at.x),
            Centre::At { at, clockwise: true } => Point::new(p.y - at.y, at.x - p.x),
            Centre::Beyond { from, d, w } => Point::new(d.y - w * (p.y - from.y), w * (p.x - from.x) - d.x),
        }
    }

    /// Angular velocity that belongs to [`Centre::rolling`], counter-clockwise
    /// positive; `None` for none.
    #[inline]
    pub fn turning(&self) -> Option<C> {
        match *self {
            Centre::Far(_) => None,
            Centre::At { clockwise, .. } => Some(C::constant(if clockwise { -1.0 } else { 1.0 })),
            Centre::Beyond { w, .. } => Some(w),
        }
    }

    /// Whether it is at infinity by itself, and not by its numbers.
    #[inline]
    pub fn is_far(&self) -> bool {
        matches!(self, Centre::Far(_))
    }

    /// The point, in m; `None` at infinity.
    pub fn point(&self) -> Option<Point<C>> {
        match *self {
            Centre::Far(_) => None,
            Centre::At { at, .. } => Some(at),
            Centre::Beyond { from, d, w } => {
                let at = Point::new(from.x + d.x / w, from.y + d.y / w);
                (at.x.value().is_finite() && at.y.value().is_finite()).then_some(at)
            }
        }
        .map(|at| plane::def(at, [&s::O_X, &s::O_Y]))
    }
}

impl Centre<f64> {
    /// Greatest length of the rolling directions of all groups.
    #[must_use]
    pub fn fastest(&self, machine: &Machine<f64>) -> f64 {
        let lengths = machine.groups.iter().map(|p| plane::length(self.rolling(*p)));
        lengths.fold(0.0, f64::max)
    }
}

/// Where the turning centre lies. At infinity it lies to the left of the way, on the line across the machine.
#[derive(Clone, Copy, Debug)]
pub struct TurningPole<C> {
    at: Point<C>,
    far: bool,
    /// Distance from the machine's middle, in m.
    radius: C,
}
results! { TurningPole as p => {
    O_X: p.at.x;
    O_Y: p.at.y;
    O_AT_INFINITY: C::constant(f64::from(p.far));
    R_O: p.radius;
} }

impl<C: Calc> TurningPole<C> {
    pub fn new(machine: &Machine<C>, centre: &Centre<C>) -> TurningPole<C> {
        if let Some(at) = centre.point() {
            return TurningPole {
                at,
                far: false,
                radius: plane::length(at - machine.middle),
            };
        }
        let along = centre.rolling(machine.middle);
        let far = |x: C| match x.value() {
            0.0 => C::constant(0.0),
            x => C::constant(f64::INFINITY.copysign(x)),
        };
        TurningPole {
            at: Point::new(far(-along.y), far(along.x)),
            far: true,
            radius: C::constant(f64::INFINITY),
        }
    }
}

/// Distance, in m, at which the axle line of a group at `p` with heading `theta`
/// (rad) passes the turning centre; positive where the group must turn
/// counter-clockwise to meet it. A centre beyond 1 km, where axle lines are
/// parallel to the eye, counts at 1 km in its direction.
#[must_use]
pub fn residual(centre: &Centre<f64>, p: Point<f64>, theta: f64) -> f64 {
    const HORIZON: f64 = 1e3;
    let along = centre.rolling(p);
    let (sin, cos) = Calc::sin_cos(theta);
    let (astray, reach) = (plane::cross(Point::new(cos, sin), along), plane::length(along));
    if reach == 0.0 {
        return 0.0;
    }
    // A heading against the rolling direction has the same axle line.
    let astray = astray * plane::dot(Point::new(cos, sin), along).signum();
    let w = centre.turning().unwrap_or(0.0).abs();
    if reach <= HORIZON * w {
        astray / w
    } else {
        astray / reach * HORIZON
    }
}

//! A rigid body on equal springs at points of a plane, which push and never pull: how they share its weight, and which
//! of them bear.

use crate::kernel::calc::{Among, Calc, sum};
use crate::kernel::symbol::Symbol;
use crate::parts::plane::{self, Point};

/// What the quantities of such a body are called: number of springs, their mean, sums of the squares of their distances
/// from it (forward, to the left) and of the products; place of the weight and of a spring from the mean; how the share
/// of a spring grows with its place, where that has names.
#[derive(Debug)]
pub struct SpringNames {
    pub count: &'static Symbol,
    pub mean: [&'static Symbol; 2],
    pub sums: [&'static Symbol; 3],
    pub eccentric: [&'static Symbol; 2],
    pub apart: [&'static Symbol; 2],
    pub tilt: Option<[&'static Symbol; 2]>,
}

/// How many springs there are, their mean (m), and the sums of the squares and products of their distances from it (m²).
#[derive(Clone, Copy, Debug)]
pub struct Springs<C> {
    n: C,
    pub mean: Point<C>,
    xx: C,
    xy: C,
    yy: C,
    names: &'static SpringNames,
}

impl<C: Calc> Springs<C> {
    /// At one point at least.
    pub fn new(points: impl Iterator<Item = Point<C>> + Clone, names: &'static SpringNames) -> Springs<C> {
        let n = sum(points.clone().map(|_| C::constant(1.0))).def(names.count);
        let mean = Point::new(
            (sum(points.clone().map(|p| p.x)) / n).def(names.mean[0]),
            (sum(points.clone().map(|p| p.y)) / n).def(names.mean[1]),
        );
        // In the book by their names.
        let named = |d: Point<C>| {
            let [x, y] = names.apart;
            Point::new(C::known(x, d.x.value()), C::known(y, d.y.value()))
        };
        let of = |product: fn(Point<C>) -> C| {
            let mut all = points.clone().map(|p| p - mean);
            let first = all.next().expect("at least one");
            let sum = all.fold(product(first), |sum, d| sum + product(d));
            sum.among(Among::Sum, product(named(first)))
        };
        Springs {
            n,
            mean,
            xx: of(|d| d.x * d.x).def(names.sums[0]),
            xy: of(|d| d.x * d.y).def(names.sums[2]),
            yy: of(|d| d.y * d.y).def(names.sums[1]),
            names,
        }
    }

    fn determinant(&self) -> C {
        self.xx * self.yy - self.xy * self.xy
    }

    /// Whether they stand on one line, so that nothing holds the body there.
    pub fn are_in_line(&self) -> bool {
        let spread = self.xx.value() + self.yy.value();
        self.determinant().value() <= 1e-12 * spread * spread
    }

    /// How the share of a spring grows with its place, for each metre, under a weight that is off the mean (m).
    fn tilt(&self, e: Point<C>) -> Point<C> {
        let Springs { xx, xy, yy, .. } = *self;
        let determinant = self.determinant();
        Point::new((e.x * yy - e.y * xy) / determinant, (e.y * xx - e.x * xy) / determinant)
    }

    /// Force of the spring at `p` (m), in N, under a weight (N) at `centre` (m).
    pub fn carry(&self, weight: C, centre: Point<C>, p: Point<C>) -> C {
        let names = self.names;
        let e = plane::def(centre - self.mean, names.eccentric);
        let d = plane::def(p - self.mean, names.apart);
        let tilt = self.tilt(e);
        let tilt = names.tilt.map_or(tilt, |names| plane::def(tilt, names));
        weight * (C::constant(1.0) / self.n + plane::dot(tilt, d))
    }
}

/// A weight (N) with its moments (N·m): its place is these over it.
#[derive(Clone, Copy, Debug)]
pub struct PlacedWeight {
    pub force: f64,
    pub moment: Point<f64>,
}

impl PlacedWeight {
    #[must_use]
    pub fn at(force: f64, place: Point<f64>) -> PlacedWeight {
        PlacedWeight {
            force,
            moment: place * force,
        }
    }
}

/// Which of at most 64 springs bear, a bit for each.
pub type Bearing64 = u64;

/// Where a growing weight ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Growth {
    /// At the end that was asked for.
    Whole(Bearing64),
    /// A spring reaches what it can bear.
    Full { at: f64, spring: usize, bearing: Bearing64 },
    /// The body falls over the line of the last two.
    Over(f64),
}

/// Follows a weight that grows from `base` by `step` times a number, up to `end`, while the springs in `bearing` bear the
/// base: a spring that would pull is lifted, one that is met again bears. `caps` in N.
#[must_use]
pub fn grow(
    points: &[Point<f64>],
    names: &'static SpringNames,
    mut bearing: Bearing64,
    [base, step]: [PlacedWeight; 2],
    end: f64,
    caps: &dyn Fn(usize) -> f64,
) -> Growth {
    let mut now = 0.0_f64;
    let mut last = None;
    // Each spring lifts and is met again a few times at most.
    for _ in 0..8 * points.len() {
        let those = (0..points.len()).filter(|spring| bearing >> spring & 1 == 1);
        if those.clone().count() < 3 {
            return Growth::Over(now);
        }
        let springs = Springs::new(those.map(|spring| points[spring]), names);
        if springs.are_in_line() {
            return Growth::Over(now);
        }
        let linear = |weight: PlacedWeight| {
            let tilt = springs.tilt(weight.moment - springs.mean * weight.force);
            move |p: Point<f64>| weight.force / springs.n + tilt.dot(&(p - springs.mean))
        };
        let (start, rate) = (linear(base), linear(step));
        let mut next = (end, None, false);
        for (spring, &p) in points.iter().enumerate() {
            let (a, b) = (start(p), rate(p));
            let bears = bearing >> spring & 1 == 1;
            if Some(spring) != last && (bears && b < 0.0 || !bears && b > 0.0) {
                let at = (-a / b).max(now);
                if at < next.0 {
                    next = (at, Some(spring), false);
                }
            }
            let full = ((caps(spring) - a) / b).max(now);
            if bears && b > 0.0 && full < next.0 {
                next = (full, Some(spring), true);
            }
        }
        match next {
            (_, None, _) => return Growth::Whole(bearing),
            (at, Some(spring), true) => return Growth::Full { at, spring, bearing },
            (at, Some(spring), false) => {
                bearing ^= 1 << spring;
                (now, last) = (at, Some(spring));
            }
        }
    }
    Growth::Over(now)
}

/// Which springs bear a weight; `None` where it lies beyond all of them, and the body falls over.
#[must_use]
pub fn bearing(points: &[Point<f64>], names: &'static SpringNames, weight: PlacedWeight) -> Option<Bearing64> {
    let all = !0 >> (64 - points.len());
    let mean = points.iter().sum::<Point<f64>>() / points.len() as f64;
    // From where all bear alike to its place.
    let base = PlacedWeight::at(weight.force, mean);
    let step = PlacedWeight {
        force: 0.0,
        moment: weight.moment - base.moment,
    };
    match grow(points, names, all, [base, step], 1.0, &|_| f64::INFINITY) {
        Growth::Whole(bearing) => Some(bearing),
        Growth::Full { .. } | Growth::Over(_) => None,
    }
}

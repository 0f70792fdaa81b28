//! The four-bar linkage: crank O–J (driven), coupler J–K, follower N–K, frame
//! O–N; any lengths, both branches of assembly, exact up to its dead points.
//!
//! A dead point is where coupler and follower lie in one line: there the
//! triangle N–J–K has no area, and differences of squares lose half of their
//! digits. The products of sines below keep them, given that the dead angles
//! are known to twice the working precision:
//!
//! (b + c)² − d² = −4 a f sin((θ − θ_s)/2) sin((θ − θ_s′)/2)
//!
//! with crank a, coupler b, follower c, frame f and diagonal d = N–J.
//!
//! Where both margins vanish (parallelogram, kite, rhombus) the two branches of
//! assembly meet in change points. There the root of their product has a closed
//! form that changes its sign, 2 a f sin(θ − θ_f): a linkage keeps its branch
//! through every change point, even exactly in it.

use std::f64::consts::{PI, TAU};

use nalgebra::Scalar;
use twofloat::TwoFloat;

use crate::kernel::calc::Calc;
use crate::kernel::symbol::Symbol;
use crate::parts::plane::{self, Point};

/// How near to a change point a linkage counts as having it: its margin there over four times crank and frame.
/// Within the root of it, in rad, it would turn from one way of moving to another.
const NEAR: f64 = 1e-9;

/// Names under which a mechanism's book prints the steps of the closure.
#[derive(Debug)]
pub struct Names {
    pub frame: &'static Symbol,
    pub frame_angle: &'static Symbol,
    pub stretched: [&'static Symbol; 2],
    pub folded: [&'static Symbol; 2],
    pub crank: [&'static Symbol; 2],
    pub diagonal: [&'static Symbol; 2],
    pub diagonal_length: &'static Symbol,
    pub stretched_margin: &'static Symbol,
    pub folded_margin: &'static Symbol,
    pub area: &'static Symbol,
    pub follower: [&'static Symbol; 2],
    pub coupler: [&'static Symbol; 2],
}

/// On which side of the line from the follower's pivot N to the crank's joint J
/// the joint K of coupler and follower lies; with change points, where it lies
/// up to half a turn clockwise of the frame: there a parallelogram is `Left`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Branch {
    Left,
    Right,
}

/// How one kind of dead point (stretched or folded) limits the crank.
#[derive(Clone, Copy, Debug)]
enum Limit<C> {
    /// The crank stays between two dead angles; each comes with the tail that
    /// completes it to twice the working precision.
    Between([(C, f64); 2]),
    /// The crank stays out of the angles between two dead angles.
    Outside([(C, f64); 2]),
    /// The crank passes: at the worst position this margin (m²) is left.
    Free(C),
}

/// Lengths of a linkage with what follows from them alone.
#[derive(Clone, Copy, Debug)]
pub struct FourBar<C> {
    crank: C,
    coupler: C,
    follower: C,
    /// From the crank's pivot O to the follower's pivot N.
    frame: Point<C>,
    frame_length: C,
    frame_direction: Point<C>,
    branch: Branch,
    stretched: Limit<C>,
    folded: Limit<C>,
    /// Middle of the crank angles in use, in rad.
    middle: f64,
    /// Whether both margins vanish.
    changes: bool,
}

/// The linkage at one crank angle: bars as vectors, in m.
#[derive(Clone, Copy, Debug)]
pub struct Closure<C> {
    /// O to J.
    pub crank: Point<C>,
    /// J to K.
    pub coupler: Point<C>,
    /// N to K.
    pub follower: Point<C>,
    /// Length of the diagonal N–J.
    pub diagonal: C,
    /// ±4 × the area of the triangle N–J–K; twice the cross product of follower
    /// and coupler, without its cancellation.
    pub area: C,
    /// How the linkage passes its change points, if it has any.
    pub passing: Option<Passing>,
}

/// How a linkage keeps its branch through its change points, in which the loop of the bars says nothing of their velocities.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Passing {
    /// The follower turns like the crank, and the coupler not at all.
    Parallel,
    /// The coupler turns like the crank, and the follower not at all.
    Folded,
    /// The area changes its sign there: it falls with the cosine from crank to frame, or grows.
    Swept(Branch),
}

/// An interval of crank angles in which the linkage can be assembled, in rad;
/// the whole turn where it has no end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arc {
    pub from: f64,
    pub to: f64,
}

impl<C: Copy + Scalar> Limit<C> {
    fn map<D>(&self, f: fn(C) -> D) -> Limit<D> {
        let both = |ends: [(C, f64); 2]| ends.map(|(end, tail)| (f(end), tail));
        match *self {
            Limit::Between(ends) => Limit::Between(both(ends)),
            Limit::Outside(ends) => Limit::Outside(both(ends)),
            Limit::Free(margin) => Limit::Free(f(margin)),
        }
    }
}

impl<C: Copy + Scalar> FourBar<C> {
    /// The same linkage over another scalar.
    #[must_use]
    pub fn map<D: Scalar>(&self, f: fn(C) -> D) -> FourBar<D> {
        FourBar {
            crank: f(self.crank),
            coupler: f(self.coupler),
            follower: f(self.follower),
            frame: self.frame.map(f),
            frame_length: f(self.frame_length),
            frame_direction: self.frame_direction.map(f),
            branch: self.branch,
            stretched: self.stretched.map(f),
            folded: self.folded.map(f),
            middle: self.middle,
            changes: self.changes,
        }
    }
}

impl<C: Calc> FourBar<C> {
    /// `None` where these lengths close at no crank angle.
    pub fn new(
        [crank, coupler, follower]: [C; 3],
        frame: Point<C>,
        branch: Branch,
        names: &Names,
    ) -> Option<FourBar<C>> {
        let frame_length = plane::length(frame).def(names.frame);
        let frame_angle = C::direction(frame.x, frame.y).def(names.frame_angle);
        let (a, f) = (crank, frame_length);
        let (sum, difference) = (coupler + follower, coupler - follower);
        // The diagonal runs from |a − f| to a + f and must stay within
        // |b − c| .. b + c.
        if sum.value() <= (a - f).value().abs() || difference.value().abs() >= (a + f).value() {
            return None;
        }
        // Dead angles lie this far on both sides of the frame.
        let away = |diagonal: C| {
            let half = C::direction(
                ((a + f - diagonal) * (a + f + diagonal)).sqrt(),
                ((diagonal - a + f) * (diagonal + a - f)).sqrt(),
            );
            C::constant(2.0) * half
        };
        let exact = |sign: f64| TwoFloat::new_add(coupler.value(), sign * follower.value());
        let end = |angle: C, name, diagonal: TwoFloat| {
            let angle = angle.def(name);
            (
                angle,
                dead_angle_tail(angle.value(), crank.value(), frame.map(C::value), diagonal),
            )
        };
        let reaches_stretched = sum.value() < (a + f).value();
        let reaches_folded = difference.value().abs() > (a - f).value().abs();
        let stretched = if reaches_stretched {
            let (away, names, exact) = (away(sum), names.stretched, exact(1.0));
            Limit::Between([
                end(frame_angle - away, names[0], exact),
                end(frame_angle + away, names[1], exact),
            ])
        } else {
            Limit::Free((sum - a - f) * (sum + a + f))
        };
        let folded = if !reaches_folded {
            Limit::Free((a - f - difference) * (a - f + difference))
        } else {
            let (away, names, exact) = (away(difference), names.folded, exact(-1.0));
            if reaches_stretched {
                Limit::Outside([
                    end(frame_angle - away, names[0], exact),
                    end(frame_angle + away, names[1], exact),
                ])
            } else {
                let turn = C::constant(TAU);
                Limit::Between([
                    end(frame_angle + away, names[0], exact),
                    end(frame_angle + turn - away, names[1], exact),
                ])
            }
        };
        let middle = frame_angle.value() + if reaches_folded && !reaches_stretched { PI } else { 0.0 };
        let frame_direction = frame / frame_length;
        let vanishes = |limit: &Limit<C>| matches!(limit, Limit::Free(margin) if margin.value() == 0.0);
        let changes = vanishes(&stretched) && vanishes(&folded);
        Some(FourBar {
            crank,
            coupler,
            follower,
            frame,
            frame_length,
            frame_direction,
            branch,
            stretched,
            folded,
            middle,
            changes,
        })
    }

    /// The arcs of crank angles in which the linkage closes, each within one
    /// turn, ends included. With both kinds of dead point there are two.
    #[must_use]
    pub fn arcs(&self) -> Vec<Arc> {
        let ends = |ends: &[(C, f64); 2]| (ends[0].0.value(), ends[1].0.value());
        match (&self.stretched, &self.folded) {
            (Limit::Between(outer), Limit::Outside(inner)) => {
                let ((from, to), (low, high)) = (ends(outer), ends(inner));
                vec![Arc { from, to: low }, Arc { from: high, to }]
            }
            (Limit::Between(limit), _) | (_, Limit::Between(limit)) => {
                let (from, to) = ends(limit);
                vec![Arc { from, to }]
            }
            _ => vec![Arc {
                from: self.middle - PI,
                to: self.middle + PI,
            }],
        }
    }

    /// Crank angles (rad), at most one turn apart, at which all bars lie in one line, within 1e-9 of it: change points.
    pub fn change_points(&self) -> impl Iterator<Item = f64> + use<C> {
        let near = |limit: &Limit<C>, beyond: f64| match limit {
            Limit::Free(margin) if margin.value() < NEAR * 4.0 * (self.crank * self.frame_length).value() => {
                let frame = self.frame_direction.map(C::value);
                Some(f64::direction(frame.x, frame.y) + beyond)
            }
            _ => None,
        };
        [near(&self.folded, 0.0), near(&self.stretched, PI)]
            .into_iter()
            .flatten()
    }

    /// Whether the linkage keeps its branch through its change points: they are exact, and two in a turn.
    #[must_use]
    pub fn keeps_branch(&self) -> bool {
        self.changes
    }

    /// Whether the crank can turn without end.
    #[must_use]
    pub fn turns_fully(&self) -> bool {
        matches!((&self.stretched, &self.folded), (Limit::Free(_), Limit::Free(_)))
    }

    /// The bars at crank angle `theta` (rad), or `None` where they do not close.
    #[inline]
    pub fn close(&self, theta: C, names: &Names) -> Option<Closure<C>> {
        let (sin, cos) = theta.sin_cos();
        let crank = plane::def(Point::new(self.crank * cos, self.crank * sin), names.crank);
        let diagonal = plane::def(crank - self.frame, names.diagonal);
        let square = diagonal.x.square() + diagonal.y.square();
        if let Some(closure) = self.parallel(crank, diagonal, square) {
            return Some(closure);
        }
        let length = square.sqrt().def(names.diagonal_length);

        let two = C::constant(2.0);
        let product = self.crank * self.frame_length;
        let scale = C::constant(4.0) * product;
        // Squares of sums of the directions of crank and frame are squares of
        // half angles, (2 cos)² and (2 sin)².
        let away = self.frame_direction;
        // Whole turns away from the middle are taken off, without rounding.
        let from_middle = theta.value() - self.middle;
        let turns = if from_middle.abs() <= PI {
            0.0
        } else {
            (from_middle / TAU).round()
        };
        let near = if turns == 0.0 {
            theta
        } else {
            theta - C::constant(turns * TAU)
        };
        let sine_past = |(end, tail): (C, f64)| (near.minus_exact(end, tail + turns * TAU_TAIL) / two).sin();
        let stretched = match self.stretched {
            Limit::Between([low, high]) | Limit::Outside([low, high]) => -(scale * sine_past(low) * sine_past(high)),
            Limit::Free(margin) => margin + product * ((cos + away.x).square() + (sin + away.y).square()),
        }
        .def(names.stretched_margin);
        let folded = match self.folded {
            Limit::Between([low, high]) => -(scale * sine_past(low) * sine_past(high)),
            Limit::Outside([low, high]) => scale * sine_past(low) * sine_past(high),
            Limit::Free(margin) => margin + product * ((cos - away.x).square() + (sin - away.y).square()),
        }
        .def(names.folded_margin);
        // Not `<`: a NaN must not pass.
        if !(stretched.value() >= 0.0 && folded.value() >= 0.0 && square.value() > 0.0) {
            return None;
        }
        let root = if self.changes {
            two * product * plane::cross(Point::new(cos, sin), self.frame_direction)
        } else {
            (stretched * folded).sqrt()
        };
        let area = match self.branch {
            Branch::Left => root,
            Branch::Right => -root,
        }
        .def(names.area);

        // Components of the bars along and across the diagonal, times 2 d.
        let balance = (self.follower - self.coupler) * (self.follower + self.coupler);
        let double = two * length.square();
        let (along_follower, along_coupler) = (length.square() + balance, balance - length.square());
        let follower: Point<C> = plane::def(
            Point::new(
                (along_follower * diagonal.x - area * diagonal.y) / double,
                (along_follower * diagonal.y + area * diagonal.x) / double,
            ),
            names.follower,
        );
        let coupler = plane::def(
            Point::new(
                (along_coupler * diagonal.x - area * diagonal.y) / double,
                (along_coupler * diagonal.y + area * diagonal.x) / double,
            ),
            names.coupler,
        );
        Some(Closure {
            crank,
            coupler,
            follower,
            diagonal: length,
            area,
            passing: self.changes.then_some(Passing::Swept(self.branch)),
        })
    }

    /// Where bars stay parallel to each other: the parallelogram, and the rhombus folded onto
    /// itself. Exact in the change points too, where the diagonal may vanish.
    fn parallel(&self, crank: Point<C>, diagonal: Point<C>, square: C) -> Option<Closure<C>> {
        let same = |a: C, b: C| self.changes && a.value() == b.value();
        let (coupler, follower, passing) = match self.branch {
            Branch::Left if same(self.follower, self.crank) => (self.frame, crank, Passing::Parallel),
            Branch::Right if same(self.follower, self.frame_length) && same(self.crank, self.frame_length) => {
                (-crank, -self.frame, Passing::Folded)
            }
            _ => return None,
        };
        let two = C::constant(2.0);
        // No root where the diagonal vanishes: its derivative would not exist.
        let diagonal = if square.value() > 0.0 {
            square.sqrt()
        } else {
            plane::dot(diagonal, self.frame_direction)
        };
        Some(Closure {
            crank,
            coupler,
            follower,
            diagonal,
            area: two * plane::cross(follower, coupler),
            passing: Some(passing),
        })
    }
}

/// 2π less its double.
const TAU_TAIL: f64 = 2.449_293_598_294_706_4e-16;

/// What must be added to `angle`, a dead angle in working precision, to make it
/// exact: Newton's method in double-double arithmetic on
/// a² + f² − d² − 2 a (f_x cos θ + f_y sin θ) = 0.
fn dead_angle_tail(angle: f64, crank: f64, frame: Point<f64>, diagonal: TwoFloat) -> f64 {
    let square = |x: f64| TwoFloat::new_mul(x, x);
    let constant = square(crank) + square(frame.x) + square(frame.y) - diagonal * diagonal;
    let mut exact = TwoFloat::from(angle);
    // Quadratic convergence from 1e-16 (1e-8 where the linkage nearly passes), where twice is enough.
    for _ in 0..3 {
        let (sin, cos) = sin_cos(exact);
        let residual = constant - 2.0 * crank * (frame.x * cos + frame.y * sin);
        let slope = 2.0 * crank * (frame.x * sin - frame.y * cos);
        let change = residual / slope;
        exact -= change;
        if f64::from(change).abs() < 1e-20 {
            break;
        }
    }
    f64::from(exact - angle)
}

/// Sine and cosine in double-double arithmetic by their series: error below
/// 1e-29 for |x| ≤ 3π. (The crate's own functions stop at 1e-22.)
fn sin_cos(x: TwoFloat) -> (TwoFloat, TwoFloat) {
    let mut sums = [TwoFloat::from(0.0), TwoFloat::from(1.0)]; // sine, cosine
    let mut term = TwoFloat::from(1.0);
    for n in 1..60 {
        term = term * x / f64::from(n);
        if f64::from(term).abs() < 1e-34 {
            break;
        }
        let sign = if n % 4 < 2 { 1.0 } else { -1.0 };
        sums[usize::from(n % 2 == 0)] += sign * term;
    }
    (sums[0], sums[1])
}

//! The closure of a four-bar at a crank angle, exact up to its dead points.
//!
//! At a dead point the triangle N–J–K has no area, and differences of squares
//! lose half of their digits. The products of sines below keep them, given that
//! the dead angles are known to twice the working precision:
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

use crate::kernel::calc::Calc;
use crate::parts::dead_points::{Limit, TAU_TAIL};
use crate::parts::four_bar::{Branch, FourBar, Names};
use crate::parts::plane::{self, Point};

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

impl<C: Calc> Closure<C> {
    /// The bars at crank angle `theta` (rad), or `None` where they do not close.
    #[inline]
    pub fn new(linkage: &FourBar<C>, theta: C, names: &Names) -> Option<Closure<C>> {
        let (sin, cos) = theta.sin_cos();
        let crank = plane::def(Point::new(linkage.crank * cos, linkage.crank * sin), names.crank);
        let diagonal = plane::def(crank - linkage.frame, names.diagonal);
        let square = diagonal.x.square() + diagonal.y.square();
        if let Some(closure) = Closure::parallel(linkage, crank, diagonal, square) {
            return Some(closure);
        }
        let length = square.sqrt().def(names.diagonal_length);

        let two = C::constant(2.0);
        let product = linkage.crank * linkage.frame_length;
        let scale = C::constant(4.0) * product;
        // Squares of sums of the directions of crank and frame are squares of
        // half angles, (2 cos)² and (2 sin)².
        let away = linkage.frame_direction;
        // Whole turns away from the middle are taken off, without rounding.
        let from_middle = theta.value() - linkage.middle;
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
        let stretched = match linkage.stretched {
            Limit::Between([low, high]) | Limit::Outside([low, high]) => -(scale * sine_past(low) * sine_past(high)),
            Limit::Free(margin) => margin + product * ((cos + away.x).square() + (sin + away.y).square()),
        }
        .def(names.stretched_margin);
        let folded = match linkage.folded {
            Limit::Between([low, high]) => -(scale * sine_past(low) * sine_past(high)),
            Limit::Outside([low, high]) => scale * sine_past(low) * sine_past(high),
            Limit::Free(margin) => margin + product * ((cos - away.x).square() + (sin - away.y).square()),
        }
        .def(names.folded_margin);
        // Not `<`: a NaN must not pass.
        if !(stretched.value() >= 0.0 && folded.value() >= 0.0 && square.value() > 0.0) {
            return None;
        }
        let root = if linkage.changes {
            two * product * plane::cross(Point::new(cos, sin), linkage.frame_direction)
        } else {
            (stretched * folded).sqrt()
        };
        let area = match linkage.branch {
            Branch::Left => root,
            Branch::Right => -root,
        }
        .def(names.area);

        // Components of the bars along and across the diagonal, times 2 d.
        let balance = (linkage.follower - linkage.coupler) * (linkage.follower + linkage.coupler);
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
            passing: linkage.changes.then_some(Passing::Swept(linkage.branch)),
        })
    }

    /// Where bars stay parallel to each other: the parallelogram, and the rhombus folded onto
    /// itself. Exact in the change points too, where the diagonal may vanish.
    fn parallel(linkage: &FourBar<C>, crank: Point<C>, diagonal: Point<C>, square: C) -> Option<Closure<C>> {
        let same = |a: C, b: C| linkage.changes && a.value() == b.value();
        let (coupler, follower, passing) = match linkage.branch {
            Branch::Left if same(linkage.follower, linkage.crank) => (linkage.frame, crank, Passing::Parallel),
            Branch::Right
                if same(linkage.follower, linkage.frame_length) && same(linkage.crank, linkage.frame_length) =>
            {
                (-crank, -linkage.frame, Passing::Folded)
            }
            _ => return None,
        };
        let two = C::constant(2.0);
        // No root where the diagonal vanishes: its derivative would not exist.
        let diagonal = if square.value() > 0.0 {
            square.sqrt()
        } else {
            plane::dot(diagonal, linkage.frame_direction)
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

//! Points and vectors of the plane of the mechanism: x forward (towards the
//! load), y up, angles counter-clockwise from x.

use nalgebra::Vector2;

use crate::kernel::calc::Calc;

/// A point or a vector, in m (or a force, in N).
pub type Point<C> = Vector2<C>;

/// z component of the cross product: positive where `b` lies to the left of `a`.
#[inline]
pub fn cross<C: Calc>(a: Point<C>, b: Point<C>) -> C {
    a.x * b.y - a.y * b.x
}

#[inline]
pub fn dot<C: Calc>(a: Point<C>, b: Point<C>) -> C {
    a.x * b.x + a.y * b.y
}

/// Square of the length.
#[inline]
pub fn squared<C: Calc>(a: Point<C>) -> C {
    a.x.square() + a.y.square()
}

#[inline]
pub fn length<C: Calc>(a: Point<C>) -> C {
    squared(a).sqrt()
}

/// The vector turned by an angle given as cosine and sine, and stretched by the same.
#[inline]
pub fn turned<C: Calc>(a: Point<C>, cos: C, sin: C) -> Point<C> {
    Point::new(cos * a.x - sin * a.y, sin * a.x + cos * a.y)
}

/// Both components named.
#[inline]
pub fn def<C: Calc>(a: Point<C>, names: [&'static crate::kernel::symbol::Symbol; 2]) -> Point<C> {
    Point::new(a.x.def(names[0]), a.y.def(names[1]))
}

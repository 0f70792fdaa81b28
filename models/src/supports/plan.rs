//! What stands on supports as it is seen from above: x forward, y to the left of the slewing axis, the slewing angle
//! counter-clockwise from x.

use crate::component::draw::{Draw, polar};
use crate::kernel::calc::Calc;
use crate::kernel::group::{One, group};
use crate::kernel::schema::Values;
use crate::kernel::symbol::Symbol;
use crate::parts::plane::Point;

/// Direction of the boom.
pub fn heading<C: Calc>(psi: &One<C>) -> Point<C> {
    let (sin, cos) = psi.sin_cos();
    Point::new(cos, sin)
}

/// Quantities that are inputs although they are given.
#[derive(Clone, Debug)]
pub struct LeftOpen(pub Vec<&'static Symbol>);
group!(LeftOpen);

impl LeftOpen {
    /// Those of these that a scene leaves open.
    pub fn read(v: &Values, of: &[&'static Symbol]) -> LeftOpen {
        LeftOpen(of.iter().copied().filter(|symbol| v.is_input(symbol.id)).collect())
    }
}

/// What is read of each table of a list.
pub fn each<T>(v: &Values, name: &str, read: impl Fn(&Values) -> Option<T>) -> Option<Vec<T>> {
    v.tables(name).iter().map(read).collect()
}

/// How far forces (N) at points (m) are from the equilibrium with a force (N) at a place (m): their sum over that force, or
/// their moments over it and the greatest distance, whichever is more.
#[must_use]
pub fn unbalanced(forces: &[f64], points: &[Point<f64>], force: f64, place: Point<f64>) -> f64 {
    let (mut sum, mut moment, mut size) = (-force, place * -force, 0.0_f64);
    for (own, point) in forces.iter().zip(points) {
        (sum, moment) = (sum + own, moment + point * *own);
        size = size.max(point.norm());
    }
    (sum.abs() / force).max(moment.norm() / (force * size))
}

/// The supports with their numbers and the polygon through some of them, the boom at an angle (rad); with the greatest
/// distance of a support, in m, and the boom's head.
#[must_use]
pub fn drawn(places: &[Point<f64>], corners: &[usize], at: f64, psi: &'static Symbol) -> (Draw, f64, Point<f64>) {
    let size = places.iter().map(|p| p.norm()).fold(1e-3, f64::max);
    let mut draw = Draw::default();
    draw.body(&corners.iter().map(|&corner| places[corner]).collect::<Vec<_>>(), true);
    (1..)
        .zip(places)
        .for_each(|(number, place)| draw.number(*place, number));
    let head = polar(1.5 * size, at);
    draw.bar(&[Point::zeros(), head], false);
    draw.line(Point::new(-1.2 * size, 0.0), Point::new(1.2 * size, 0.0));
    draw.angle(Point::zeros(), 0.4 * size, at, psi);
    draw.joint(Point::zeros(), "O", true, false);
    (draw, size, head)
}

//! The double link as it leads its hoist rope, and what that does to the load. [Ports001, 5.9.2.4]

use crate::component::stages::{Found, absent};
use crate::kernel::calc::Calc;
use crate::luffing::double_link::geometry::Geometry;
use crate::luffing::double_link::parameters::Choice;
use crate::luffing::double_link::position::Position;
use crate::luffing::double_link::symbols as s;
use crate::luffing::double_link::velocity::Velocity;
use crate::luffing::led::pull::LedPull;
use crate::luffing::led::reeved::Reeved;
use crate::luffing::led::stretch::LedBars;
use crate::parts::plane::Point;

/// The bar that carries the head.
pub const JIB: usize = 1;

/// First joint of boom, jib and rocker, and the unit vector along each.
pub fn lines<C: Calc>(g: &Geometry<C>, p: &Position<C>) -> [[Point<C>; 2]; 3] {
    let (l, zero) = (&g.lengths, C::constant(0.0));
    [
        [Point::new(zero, zero), p.x_1 / l.x_1],
        [p.b, p.x_2 / l.x_2],
        [l.o3(), p.x_3 / l.x_3],
    ]
}

/// Boom, jib and rocker, and the jib's head.
pub fn leads<C: Calc>(g: &Geometry<C>, p: &Position<C>, v: &Velocity<C>) -> LedBars<C> {
    let zero = C::constant(0.0);
    let (still, (i_1, i_3)) = (Point::new(zero, zero), v.of_feet(p));
    let b = Point::new(-(i_1 * p.b.y), i_1 * p.b.x);
    LedBars {
        at: lines(g, p),
        moves: [(still, i_1), (b, v.i_2), (still, i_3)],
        head: p.a,
        travel: v.da,
        carries: JIB,
    }
}

/// The same at the start of the working range.
///
/// # Errors
/// A linkage that does not close there.
pub fn beginning<C: Calc>(g: &Geometry<C>, choice: &Choice) -> Found<LedBars<C>> {
    let found = C::aside(|| {
        let p = Position::new(g, C::known(&s::FROM, choice.range.from))?;
        Some(leads(g, &p, &Velocity::new(&p)))
    });
    found.ok_or_else(absent)
}

/// What the rope does to boom, jib and rocker at a position, under a load (N); `None` where it has no line to run along.
pub fn hauled<C: Calc>(g: &Geometry<C>, led: &Reeved<C>, p: &Position<C>, q: C) -> Option<LedPull<C>> {
    let (bars, mut room) = (leads(g, p, &Velocity::new(p)), Vec::new());
    led.stretches(&bars, &mut room).ok()?;
    Some(LedPull::new(led, &q, &bars, &room))
}

/// Height of the load at a position but for a constant, in m; `None` where a rope has no line to run along.
pub fn height<C: Calc>(g: &Geometry<C>, led: Option<&Reeved<C>>, p: &Position<C>) -> Option<C> {
    let raised = |led: &Reeved<C>| led.raised(&leads(g, p, &Velocity::new(p)));
    led.map_or(Some(p.a.y), |led| Some(p.a.y + raised(led).ok()?))
}

/// Rise of the load for one radian of the driving link, in m, likewise.
pub fn rise<C: Calc>(g: &Geometry<C>, led: Option<&Reeved<C>>, p: &Position<C>) -> Option<C> {
    let v = Velocity::new(p);
    led.map_or(Some(v.da.y), |led| Some(v.da.y + led.rises(&leads(g, p, &v)).ok()?))
}

//! The closure by the length of the tie: where it leaves the tail.

use crate::component::stages::results;
use crate::kernel::allowed::{FINITE, OutOfRange};
use crate::kernel::calc::Calc;
use crate::luffing::curved_trunk::symbols as s;
use crate::luffing::curved_trunk::tail::{Leaving, TrunkChoice, TrunkTail, unrolled};
use crate::parts::plane::{self, Point};

/// Between two dead points Newton's method, kept within bounds that halve where it leaves them, needs three to five steps.
const STEPS: usize = 200;
/// Of the place: the next step squares that, and the last one is left to the equations.
const NEAR: f64 = 1e-9;

/// Where the tie leaves the tail, in the trunk's frame.
#[derive(Clone, Copy, Debug)]
pub struct Contact<C> {
    /// Head of the boom, in m from O1, and from there to O3.
    pub b: Point<C>,
    pub d: Point<C>,
    /// Square of the distance of B and O3, in m².
    pub d_2: C,
    /// Point of contact, in m, and direction of the free tie.
    pub p: Point<C>,
    pub u: Point<C>,
    /// Tie on the tail and free, in m.
    pub w: C,
    pub f: C,
    /// Radius of the tail, in m.
    pub rho: C,
}
results! { Contact as c => { B_X: c.b.x; B_Y: c.b.y; W: c.w; F: c.f; RHO_T: c.rho; } }

impl<C: Calc> Contact<C> {
    /// v² = d². Where the point of contact is found with plain numbers, a last step of Newton's method over any scalar gives
    /// the derivatives, by the theorem of the implicit function. [Ports001, 5.2.4.3]
    ///
    /// # Errors
    /// A boom's head too far from O3, or too near.
    pub fn new(tail: &TrunkTail<C>, choice: &TrunkChoice, phi: &C) -> Result<Contact<C>, OutOfRange> {
        let trunk = &tail.trunk;
        let (sin, cos) = phi.sin_cos();
        let b = plane::def(Point::new(trunk.b * cos, trunk.b * sin), [&s::B_X, &s::B_Y]);
        let d = plane::def(Point::new(trunk.o3_x - b.x, trunk.o3_y - b.y), [&s::D_X, &s::D_Y]);
        let d_2 = plane::squared(d).def(&s::D_2);
        let place = found(&tail.map(C::value), choice, d_2.value())?;
        let found = Leaving::new(&tail.arc, choice, place);
        let (p_0, u_0) = (found.p, found.u);
        let f_0 = (trunk.l_t - found.w).def(&s::F_0);
        let h_0 = plane::cross(p_0, u_0).def(&s::H_0);
        let v_0 = plane::def(p_0 + u_0 * f_0, [&s::V0_X, &s::V0_Y]);
        let turn = ((plane::squared(v_0) - d_2) / (C::constant(2.0) * f_0 * h_0)).def(&s::DELTA_ZETA);
        let u = Point::new(u_0.x - u_0.y * turn, u_0.y + u_0.x * turn);
        let way = if choice.from_rear {
            -(found.rho * turn)
        } else {
            found.rho * turn
        };
        let w = (found.w + way).def(&s::W);
        Ok(Contact {
            b,
            d,
            d_2,
            p: plane::def(p_0 + u_0 * way, [&s::C_X, &s::C_Y]),
            u: plane::def(u, [&s::U_X, &s::U_Y]),
            w,
            f: (trunk.l_t - w).def(&s::F),
            rho: match found.rho_rate {
                Some(rate) => (found.rho + rate * turn).def(&s::RHO_T),
                None => found.rho.def(&s::RHO_T),
            },
        })
    }
}

/// End of the unrolled tie in the trunk's frame, in m, as far from B as O3 is, by the square of that (m²): with three derivatives,
/// of which the point of contact has one. Over the turn of the tie it is a series, v′ = f u⊥ and v″ = −(ρ u⊥ + f u), on which
/// two steps of Newton's method find that turn.
///
/// # Errors
/// As [`Contact::new`].
fn end_of_tie<C: Calc>(tail: &TrunkTail<C>, choice: &TrunkChoice, d_2: C) -> Result<Point<C>, OutOfRange> {
    let place = found(&tail.map(C::value), choice, d_2.value())?;
    let Leaving {
        p, u, w, rho, rho_rate, ..
    } = Leaving::new(&tail.arc, choice, place);
    let (two, f, rate) = (
        C::constant(2.0),
        tail.trunk.l_t - w,
        rho_rate.unwrap_or(C::constant(0.0)),
    );
    let [rolled, change] = if choice.from_rear { [-rho, -rate] } else { [rho, rate] };
    let across = Point::new(-u.y, u.x);
    let once = across * f;
    let twice = -(across * rolled + u * f);
    let thrice = u * (two * rolled) - across * (change + f);
    let v = p + u * f;
    let at = |turn: C| v + (once + (twice + thrice * (turn / C::constant(3.0))) * (turn / two)) * turn;
    let first = (plane::squared(v) - d_2) / (two * f * plane::cross(p, u));
    let slope = once + (twice + thrice * (first / two)) * first;
    let near = at(first);
    let left = (plane::squared(near) - d_2) / (two * plane::dot(near, slope));
    Ok(at(first - left))
}

/// The trunk's direction at the boom's angle (rad), with three derivatives: it turns the end of the unrolled tie onto O3.
///
/// # Errors
/// As [`Contact::new`].
pub fn direction<C: Calc>(tail: &TrunkTail<C>, choice: &TrunkChoice, phi: C) -> Result<Point<C>, OutOfRange> {
    let (trunk, (sin, cos)) = (&tail.trunk, phi.sin_cos());
    let d = Point::new(trunk.o3_x - trunk.b * cos, trunk.o3_y - trunk.b * sin);
    let d_2 = plane::squared(d);
    let v = end_of_tie(tail, choice, d_2)?;
    Ok(Point::new(plane::dot(d, v), plane::cross(v, d)) / d_2)
}

/// The place at which the end of the unrolled tie is as far from B as O3 is, `square` (m²) being that distance's square.
///
/// # Errors
/// A distance beyond those at the ends of the tail.
fn found(tail: &TrunkTail<f64>, choice: &TrunkChoice, square: f64) -> Result<f64, OutOfRange> {
    let [clamp, free] = &tail.ends;
    let (at_clamp, at_free) = (clamp.square[0] - square, free.square[0] - square);
    if at_clamp * at_free > 0.0 || !square.is_finite() {
        return Err(beyond([clamp.square[0], free.square[0]], square));
    }
    // The place over the square as a cubic from end to end.
    let part = at_clamp / (at_clamp - at_free);
    let (chord, rest) = (free.place - clamp.place, 1.0 - part);
    let rise = free.square[0] - clamp.square[0];
    let [first, last] = [clamp, free].map(|end| rise / end.square[1] - chord);
    let mut place = clamp.place + part * chord + part * rest * (rest * first - part * last);
    let mut bounds = [clamp.place, free.place];
    let within = |place: f64, [a, b]: [f64; 2]| place > a.min(b) && place < a.max(b);
    if !within(place, bounds) {
        place = f64::midpoint(bounds[0], bounds[1]);
    }
    for _ in 0..STEPS {
        let ([left, slope], _) = unrolled(&Leaving::new(&tail.arc, choice, place), tail.trunk.l_t, square);
        // The bound at the clamp keeps the sign of the clamp.
        bounds[usize::from((left < 0.0) != (at_clamp < 0.0))] = place;
        let mut next = place - left / slope;
        if !within(next, bounds) {
            if left == 0.0 || (bounds[1] - bounds[0]).abs() <= f64::EPSILON * place.abs() {
                return Ok(place);
            }
            next = f64::midpoint(bounds[0], bounds[1]);
        } else if (next - place).abs() <= NEAR * chord.abs() {
            return Ok(next);
        }
        place = next;
    }
    Ok(place)
}

#[cold]
fn beyond(squares: [f64; 2], square: f64) -> OutOfRange {
    let [clamp, free] = squares.map(f64::sqrt);
    let distance = square.sqrt();
    if !distance.is_finite() {
        return OutOfRange::new(&s::D_O3, distance, FINITE, "the boom's head is nowhere");
    }
    let what = if (distance > clamp) == (clamp > free) {
        "the tie lifts off the clamped end of the tail, on which nothing of it lies"
    } else {
        "the tie lies on the whole tail and bends round its other end"
    };
    let allowed = [clamp.min(free), clamp.max(free)];
    OutOfRange::new(&s::D_O3, distance, allowed, format!("{what}; the boom's head B and O3"))
}

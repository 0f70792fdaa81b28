//! The curve on which the tie lies: an arc, or a smooth curve through points.

use std::f64::consts::TAU;
use std::sync::Arc;

use crate::component::stages::results;
use crate::kernel::allowed::{FINITE, OutOfRange};
use crate::kernel::calc::Calc;
use crate::kernel::group::{group, quantities};
use crate::luffing::curved_trunk::symbols as s;
use crate::parts::four_bar::Branch;
use crate::parts::motion::Motion;
use crate::parts::plane::{self, Point};
use crate::parts::smooth_curve::SmoothCurve;

/// What the scene has chosen.
#[derive(Clone, Debug)]
pub struct TrunkChoice {
    /// Working range of the boom.
    pub range: Motion,
    /// Whether the tie is clamped at the tail's rear end.
    pub from_rear: bool,
    /// The tail, where it is no arc.
    pub curve: Option<Arc<SmoothCurve>>,
    /// Side of the line from the centre of the drive's crank to its anchor on the boom on which crank and rod meet.
    pub crank: Branch,
}
group!(TrunkChoice);

quantities! {
    /// Boom, trunk and tie.
    Trunk { b: B, a: A, l_t: L_T, o3_x: O3_X, o3_y: O3_Y, x_8: X_8 }
}

quantities! {
    /// A tail that is an arc.
    TailArc { z_x: Z_X, z_y: Z_Y, rho: RHO, zeta_f: ZETA_F, zeta_r: ZETA_R }
}

/// Trunk and tail, at no particular position.
#[derive(Clone, Copy, Debug)]
pub struct TrunkTail<C> {
    pub trunk: Trunk<C>,
    pub arc: Option<TailArc<C>>,
    /// Its length, in m.
    length: C,
    /// Its ends on plain numbers: the clamp and the other one.
    pub ends: [TailEnd; 2],
}
results! { TrunkTail as t => { W_A: t.length; } }

/// The unrolled tie at an end of the tail.
#[derive(Clone, Copy, Debug)]
pub struct TailEnd {
    /// On an arc its direction (rad), on a curve through points the number of the piece and the part of it.
    pub place: f64,
    /// Square of the distance of the tie's end from B, in m², and its slope over the place.
    pub square: [f64; 2],
    /// Lever arm of the tie about B, in m.
    pub arm: f64,
}

/// The tail where the tie leaves it, in the trunk's frame.
#[derive(Clone, Copy, Debug)]
pub struct Leaving<C> {
    /// Point (m) and direction of the free tie.
    pub p: Point<C>,
    pub u: Point<C>,
    /// Length on the tail, in m.
    pub w: C,
    /// Radius of the tail, in m; its change for one radian of turn where it has any.
    pub rho: C,
    pub rho_rate: Option<C>,
    /// Turn for one unit of the place, in rad.
    pub turn: f64,
}

impl<C: Copy> TrunkTail<C> {
    /// The same over another scalar.
    #[must_use]
    pub fn map<D>(&self, mut f: impl FnMut(C) -> D) -> TrunkTail<D> {
        TrunkTail {
            trunk: self.trunk.map(&mut |_, value| f(value)),
            arc: self.arc.map(|arc| arc.map(&mut |_, value| f(value))),
            length: f(self.length),
            ends: self.ends,
        }
    }
}

impl<C: Calc> TrunkTail<C> {
    /// The curve from end to end. [Ports001, 5.2.4.3]
    ///
    /// # Errors
    /// A tail without an upper side, one longer than the tie, one within which the tie's line passes through B.
    pub fn new(trunk: &Trunk<C>, arc: &Option<TailArc<C>>, choice: &TrunkChoice) -> Result<TrunkTail<C>, OutOfRange> {
        const GRID: u32 = 48;
        let length = match (arc, &choice.curve) {
            (Some(arc), _) => (arc.rho * (arc.zeta_r - arc.zeta_f)).def(&s::W_A),
            (None, Some(curve)) => C::known(&s::W_A, curve.length()),
            (None, None) => unreachable!("a tail has a form"),
        };
        let plain = arc.as_ref().map(|arc| arc.map(&mut |_, value| value.value()));
        if let Some(arc) = plain.filter(|arc| !turns(arc)) {
            let what = "the tail has no upper side: from its front end to its rear end it turns counter-clockwise, at most once";
            let allowed = [arc.zeta_f, arc.zeta_f + TAU];
            return Err(OutOfRange::new(&s::ZETA_R, arc.zeta_r, allowed, what));
        }
        let l_t = trunk.l_t.value();
        if l_t <= length.value() {
            let what = "the tie is no longer than the tail, nothing of it is free";
            return Err(OutOfRange::new(&s::L_T, l_t, [length.value(), f64::MAX], what));
        }
        let (low, high) = match (&plain, &choice.curve) {
            (None, Some(curve)) => (0.0, curve.count()),
            (arc, _) => arc.as_ref().map_or((0.0, 0.0), |arc| (arc.zeta_f, arc.zeta_r)),
        };
        let end = |place: f64| {
            let (square, arm) = unrolled(&Leaving::new(&plain, choice, place), l_t, 0.0);
            TailEnd { place, square, arm }
        };
        let ends = if choice.from_rear { [high, low] } else { [low, high] }.map(end);
        for i in 0..=GRID {
            let arm = end(low + (high - low) * f64::from(i) / f64::from(GRID)).arm;
            if arm.signum() != ends[0].arm.signum() || arm == 0.0 {
                let what = "within the tail the tie's line passes through the boom's head B, a dead point";
                return Err(OutOfRange::new(&s::H_T, arm, FINITE, what));
            }
        }
        Ok(TrunkTail {
            trunk: *trunk,
            arc: *arc,
            length,
            ends,
        })
    }
}

/// Whether an arc runs counter-clockwise from its front end to its rear end, once round at most.
fn turns(arc: &TailArc<f64>) -> bool {
    arc.zeta_r > arc.zeta_f && arc.zeta_r <= arc.zeta_f + TAU
}

/// Square of the distance of the unrolled tie's end from B less another square (m²), and its slope; the tie's lever arm
/// about B, in m.
#[inline]
pub fn unrolled(leaving: &Leaving<f64>, l_t: f64, less: f64) -> ([f64; 2], f64) {
    let free = l_t - leaving.w;
    let arm = plane::cross(leaving.p, leaving.u);
    let square = plane::squared(leaving.p + leaving.u * free) - less;
    ([square, -2.0 * free * arm * leaving.turn], arm)
}

impl<C: Calc> Leaving<C> {
    /// At a place, on a curve through points on plain numbers.
    #[inline]
    pub fn new(arc: &Option<TailArc<C>>, choice: &TrunkChoice, place: f64) -> Leaving<C> {
        let rear = choice.from_rear;
        if let Some(arc) = arc {
            let zeta = C::constant(place).def(&s::ZETA_0);
            let (sin, cos) = zeta.sin_cos();
            let u = if rear {
                Point::new(sin, -cos)
            } else {
                Point::new(-sin, cos)
            };
            let p = Point::new(arc.z_x + arc.rho * cos, arc.z_y + arc.rho * sin);
            let turned = if rear { arc.zeta_r - zeta } else { zeta - arc.zeta_f };
            return Leaving {
                p: plane::def(p, [&s::C0_X, &s::C0_Y]),
                u: plane::def(u, [&s::U0_X, &s::U0_Y]),
                w: (arc.rho * turned).def(&s::W_0),
                rho: arc.rho,
                rho_rate: None,
                turn: 1.0,
            };
        }
        let curve = choice.curve.as_ref().expect("a tail has a form");
        let at = curve.at(place);
        let (u, w) = if rear {
            (-at.along, curve.length() - at.length)
        } else {
            (at.along, at.length)
        };
        Leaving {
            p: Point::new(C::known(&s::C0_X, at.at.x), C::known(&s::C0_Y, at.at.y)),
            u: Point::new(C::known(&s::U0_X, u.x), C::known(&s::U0_Y, u.y)),
            w: C::known(&s::W_0, w),
            rho: C::known(&s::RHO_0, at.radius),
            rho_rate: Some(C::known(&s::DRHO_0, at.radius_rate)),
            turn: at.turn,
        }
    }
}
